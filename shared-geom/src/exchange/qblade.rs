//! Structural files of QBlade: the main file, which names the file of the blade, and the
//! blade file with a table of full matrices (`BEAMTYPE` 2).
//!
//! The matrices are in BeamDyn's axes and order: in the file of the IEA-22 the fourth
//! row has the edge stiffness and inertia, the mass center is off the axis toward the
//! trailing edge, and the documentation of `RAYLEIGHDMP_ANISO` calls bending about y
//! flapwise. Tables of the other beam types have offsets and radii as parts of the chord,
//! which is in another file.
//!
//! # References
//! - QBlade documentation, "Turbine Structural Model"; blade file of the IEA-22.

use std::path::Path;

use nalgebra::Vector2;

use crate::blade::{Blade, BladeDamping, Interpolation, Station};
use crate::document::read_text;
use crate::error::{Diagnostics, SourceLocation};
use crate::line::ReferenceLine;

use super::frame::Convention;
use super::named::{companion, named, optional};
use super::problem::{ExchangeProblem, Problems};
use super::stations::{name_of, provenance};
use super::text::{Line, from_upper, lines, number};
use super::{Options, Reading};

/// Name of the blade file in the main file.
const BLADE_FILE: [&str; 1] = ["BLDFILE_1"];
/// First word of the names of the columns.
const HEAD: &str = "LENFRACT";
/// Columns of a table of matrices: position, offsets, pitch, two upper triangles.
const COLUMNS: usize = 46;

/// Whether `text` is a blade file or a main file.
pub(super) fn recognize(text: &str) -> bool {
    text.lines().any(|line| is_head(line.trim())) || named(text, &BLADE_FILE).is_some()
}

fn is_head(line: &str) -> bool {
    line.get(..HEAD.len())
        .is_some_and(|begin| begin.eq_ignore_ascii_case(HEAD))
}

/// Reads a blade file, or the one that a main file names, as a straight blade of the
/// length of `options`.
///
/// # Errors
/// All errors of the file; a missing length; a table without matrices.
pub(super) fn read(text: &str, file: &Path, options: &Options) -> Result<Reading, Diagnostics> {
    let mut problems = Problems::new(&file.display().to_string());
    if !text.lines().any(|line| is_head(line.trim())) {
        let path = companion(text, &BLADE_FILE, file, &mut problems);
        let path = problems.finish(path)?;
        let inner = read_text(&path)?;
        let problems = Problems::new(&path.display().to_string());
        return read_blade(&inner, &path, options, problems);
    }
    read_blade(text, file, options, problems)
}

fn read_blade(
    text: &str,
    file: &Path,
    options: &Options,
    mut problems: Problems,
) -> Result<Reading, Diagnostics> {
    let all = lines(text);
    let head = all.iter().position(|line| is_head(line.text));
    let rows = head.and_then(|head| rows(&all, head, &mut problems));
    if head.is_none() {
        let what = "the table of the blade".to_owned();
        let help = format!("its first line begins with {HEAD}; is the file cut short?");
        problems.push(0, &ExchangeProblem::Missing { what, help });
    }
    let mut tuner = |name: &str| optional(text, &[name], 1.0, &mut problems);
    let tuners = tuner("STIFFTUNER").zip(tuner("MASSTUNER"));
    let mut remarks = Vec::new();
    let damping = damping(text, &mut remarks, &mut problems);
    if options.length.is_none() {
        problems.push(0, &without_line());
    }
    let found = rows.zip(tuners).zip(damping).zip(options.length);
    let (((rows, (stiff, heavy)), damping), length) = problems.finish(found)?;
    remarks.extend(unread(text));
    remarks.push(format!(
        "the line is straight, {length} m long, without twist: both are in the .bld file, which \
         is not read"
    ));
    let convention = Convention::BeamDyn;
    let station = |(_, row): &(usize, Vec<f64>)| Station {
        arc_length: row[0] * length,
        stiffness: convention.to_ours(&(from_upper(&row[4..25]) * stiff)),
        mass: convention.to_ours(&(from_upper(&row[25..]) * heavy)),
    };
    let blade = Blade {
        name: name_of(file),
        line: ReferenceLine::straight(length),
        reference_point: Vector2::zeros(),
        stations: rows.iter().map(station).collect(),
        interpolation: Interpolation::Linear,
        damping,
        provenance: provenance("QBlade", &[text]),
    };
    let shown = file.display().to_string();
    Ok(Reading {
        locations: rows
            .iter()
            .map(|(line, _)| SourceLocation::line(&shown, *line))
            .collect(),
        ..Reading::new(blade, remarks)
    })
}

/// The rows of the table with their lines; `None` if the table has no matrices.
fn rows(all: &[Line<'_>], head: usize, problems: &mut Problems) -> Option<Vec<(usize, Vec<f64>)>> {
    let names = &all[head];
    let has_matrices = names
        .words()
        .any(|name| name.to_uppercase().starts_with("K11"));
    if !has_matrices {
        problems.push(names.number, &without_matrices());
        return None;
    }
    let body = all[head + 1..].iter();
    let body = body.take_while(|line| number(line.first()).is_some());
    let mut rows: Vec<(usize, Vec<f64>)> = Vec::new();
    for (count, line) in body.enumerate() {
        let what = format!("station {}", count + 1);
        let Some(row) = line.list(&what, Some(COLUMNS), problems) else {
            continue;
        };
        check_position(&what, line, &row, rows.last(), problems);
        rows.push((line.number, row));
    }
    if rows.is_empty() && problems.is_empty() {
        problems.push(
            names.number,
            &ExchangeProblem::CutShort {
                what: "the table of the blade".to_owned(),
                expected: format!("rows of {COLUMNS} numbers"),
            },
        );
    }
    Some(rows)
}

/// Notes a position before the previous one, and matrices about another point or in other
/// axes.
fn check_position(
    what: &str,
    line: &Line<'_>,
    row: &[f64],
    before: Option<&(usize, Vec<f64>)>,
    problems: &mut Problems,
) {
    if let Some((_, before)) = before.filter(|(_, before)| before[0] > row[0]) {
        let (what, found, before) = (format!("position of {what}"), row[0], before[0]);
        let problem = ExchangeProblem::Order {
            what,
            found,
            before,
        };
        problems.push(line.number, &problem);
    }
    if row[1..4].iter().any(|number| *number != 0.0) {
        problems.push(
            line.number,
            &ExchangeProblem::Other {
                what: format!("XCB, YCB and PITCH of {what}"),
                found: format!("{}, {}, {}", row[1], row[2], row[3]),
                expected: "zeros: matrices about the line, in its axes".to_owned(),
                help: "offsets are parts of the chord, which is in the .bld file: transform the \
                       matrices to the line first"
                    .to_owned(),
            },
        );
    }
}

fn without_line() -> ExchangeProblem {
    ExchangeProblem::Missing {
        what: "the length of the blade (a structural file of QBlade has parts of it only)"
            .to_owned(),
        help: "give --length METERS for a straight blade without twist".to_owned(),
    }
}

fn without_matrices() -> ExchangeProblem {
    ExchangeProblem::Other {
        what: "the table of the blade".to_owned(),
        found: "engineering properties (BEAMTYPE 0 or 1)".to_owned(),
        expected: "matrices (BEAMTYPE 2): columns K11 to K66 and M11 to M66".to_owned(),
        help: "their centers and radii are parts of the chord, which is in the .bld file: write \
               the properties into a NAME.blade.toml"
            .to_owned(),
    }
}

/// Damping by times; `None` if a number is wrong.
fn damping(
    text: &str,
    remarks: &mut Vec<String>,
    problems: &mut Problems,
) -> Option<Option<BladeDamping>> {
    let keyword = "RAYLEIGHDMP_ANISO";
    let all = lines(text);
    let line = all.iter().find(|line| {
        let mut words = line.words();
        number(line.first()).is_some() && words.any(|word| word.eq_ignore_ascii_case(keyword))
    });
    let Some(line) = line else {
        let time = optional(text, &["RAYLEIGHDMP"], 0.0, problems)?;
        return Some((time != 0.0).then_some(BladeDamping::Proportional(time)));
    };
    let values: Vec<_> = line.words().map_while(number).collect();
    let (&[flap, edge, torsion, axial], rest) = values.split_first_chunk().or_else(|| {
        let problem = ExchangeProblem::Count {
            what: keyword.to_owned(),
            expected: 4,
            found: values.len(),
            separator: "blanks",
        };
        problems.push(line.number, &problem);
        None
    })?;
    if let Some(factor) = rest.first().filter(|factor| **factor != 0.0) {
        remarks.push(format!(
            "the factor of the mass in {keyword} ({factor} 1/s) is not read"
        ));
    }
    let times = [axial, edge, flap, torsion, flap, edge];
    let has_some = times.iter().any(|time| *time != 0.0);
    Some(has_some.then_some(BladeDamping::Times(times)))
}

/// Remark on data that are not read.
fn unread(text: &str) -> Option<String> {
    let mass = |line: &str| {
        let mut words = line.split_whitespace();
        let is_mass = words.next().is_some_and(|word| word.starts_with("ADDMASS"));
        is_mass && words.map_while(number).any(|mass| mass != 0.0)
    };
    let count = text.lines().filter(|line| mass(line.trim())).count();
    (count > 0)
        .then(|| format!("{count} point masses (ADDMASS) are not read: add them to the model"))
}

#[cfg(test)]
mod tests;
