//! The DYMORE table of sectional properties: 29 numbers a station.
//!
//! ```text
//! m, m y, m z, m33, m23, m22        of the mass matrix: 11, 34, 15, 66, 56, 55
//! k11, k12, k22, k13, k23, k33, ... k66    columns of the upper triangle
//! mu                                damping time
//! eta                               part of the length, or arc length if it exceeds 1
//! ```
//!
//! Axes are Helicoid's. The table has no line; DYMORE has it among its curves. Helicoid's
//! tables name a companion file, `# line: NAME.line.csv`, which is read with them.
//!
//! # References
//! - SONATA (German Aerospace and TU Munich), export for DYMORE: the list of the 29
//!   numbers. DYMORE user's manual, "Beam property definition".

use std::path::Path;

use nalgebra::{Matrix6, Vector2};

use crate::blade::{Blade, BladeDamping, Interpolation, Station};
use crate::document::read_text;
use crate::error::{Diagnostics, SourceLocation};
use crate::line::ReferenceLine;

use super::frame::Convention;
use super::header::Header;
use super::problem::{ExchangeProblem, Problems};
use super::stations::{self, name_of, provenance};
use super::text::{Line, digits, lines, number};
use super::{Options, Reading, Writing, csv};

/// Numbers of a station.
const COLUMNS: usize = 29;
/// Range of numbers per line that is read as such a table with an error.
const NEARLY: std::ops::RangeInclusive<usize> = 24..=34;
/// Mark of the companion file.
const LINE_FILE: &str = "line:";

/// Whether `text` is a DYMORE table: lines of about 29 numbers.
pub fn recognize(text: &str) -> bool {
    let mut data = text.lines().map(str::trim);
    let first = data.find(|line| !line.is_empty() && !line.starts_with('#'));
    first.is_some_and(|line| {
        let words = line.split_whitespace().count();
        NEARLY.contains(&words) && line.split_whitespace().all(|word| number(word).is_some())
    })
}

/// Reads a table with its line: from the companion file that it names, or straight with
/// the length of `options`.
///
/// # Errors
/// All errors of the files; a table without line and length.
pub fn read(text: &str, file: &Path, options: &Options) -> Result<Reading, Diagnostics> {
    let mut problems = Problems::new(&file.display().to_string());
    let all = lines(text);
    let rows: Vec<_> = all
        .iter()
        .filter(|line| !line.text.starts_with('#'))
        .collect();
    let table = table(&rows, &mut problems);
    let companion = companion(&all);
    let longest = table.iter().map(|row| row.position).fold(0.0, f64::max);
    let mut remarks = Vec::new();
    let mut diagnostics = Diagnostics::new();
    let line = match (companion, options.length) {
        (Some((name, line)), _) => {
            let path = file.parent().unwrap_or(Path::new("")).join(name);
            if !problems.finds(&path, "line", name, line) {
                return Err(problems.into_diagnostics());
            }
            let read = read_text(&path).and_then(|text| csv::read_line(&text, &path));
            diagnostics.keep(read)
        }
        (None, Some(length)) => Some(straight(length, &mut remarks)),
        (None, None) if longest > 1.0 + 1e-9 => Some(straight(longest, &mut remarks)),
        (None, None) => {
            problems.push(0, &without_line());
            None
        }
    };
    diagnostics.keep(problems.finish(Some(())));
    let Some(line) = line.filter(|_| diagnostics.is_empty()) else {
        return Err(diagnostics);
    };
    let blade = assemble(&table, line, longest, &mut remarks);
    let blade = Blade {
        name: name_of(file),
        provenance: provenance("DYMORE table", &[text]),
        ..blade
    };
    let shown = file.display().to_string();
    let positions = rows
        .iter()
        .map(|line| SourceLocation::line(&shown, line.number));
    Ok(Reading {
        locations: positions.collect(),
        ..Reading::new(blade, remarks)
    })
}

fn straight(length: f64, remarks: &mut Vec<String>) -> ReferenceLine {
    remarks.push(format!(
        "the line is straight, {length} m long, without twist: a DYMORE table has none"
    ));
    ReferenceLine::straight(length)
}

fn without_line() -> ExchangeProblem {
    ExchangeProblem::Missing {
        what: "the reference line of the blade (a DYMORE table has the matrices only)".to_owned(),
        help: "name a file of points with a comment line \"# line: NAME.line.csv\", or give \
               --length METERS for a straight blade without twist"
            .to_owned(),
    }
}

/// The file that a comment line names, and that line.
fn companion<'a>(lines: &[Line<'a>]) -> Option<(&'a str, usize)> {
    let name = |line: &Line<'a>| {
        let name = line
            .text
            .strip_prefix('#')?
            .trim()
            .strip_prefix(LINE_FILE)?;
        Some((name.trim(), line.number))
    };
    lines
        .iter()
        .find_map(name)
        .filter(|(name, _)| !name.is_empty())
}

/// A line of the table.
struct Row {
    mass: Matrix6<f64>,
    stiffness: Matrix6<f64>,
    time: f64,
    position: f64,
}

fn table(lines: &[&Line<'_>], problems: &mut Problems) -> Vec<Row> {
    let mut rows: Vec<Row> = Vec::new();
    for (i, line) in lines.iter().enumerate() {
        let what = format!("station {}", i + 1);
        let Some(values) = line.numbers::<COLUMNS>(&what, problems) else {
            continue;
        };
        let row = row(&values);
        if let Some(before) = rows
            .last()
            .map(|row| row.position)
            .filter(|&position| position > row.position)
        {
            let (what, found) = (format!("eta of {what}"), row.position);
            let problem = ExchangeProblem::Order {
                what,
                found,
                before,
            };
            problems.push(line.number, &problem);
        }
        rows.push(row);
    }
    if lines.len() < 2 {
        problems.push(
            0,
            &ExchangeProblem::CutShort {
                what: format!("the table, which has {} lines", lines.len()),
                expected: "at least two stations, root and tip".to_owned(),
            },
        );
    }
    rows
}

/// The matrices of 29 numbers.
fn row(values: &[f64; COLUMNS]) -> Row {
    let [m, my, mz, m33, m23, m22] = [0, 1, 2, 3, 4, 5].map(|i| values[i]);
    let mut mass = Matrix6::zeros();
    mass.fixed_view_mut::<3, 3>(0, 0).fill_diagonal(m);
    let mut pair = |i: usize, j: usize, value: f64| {
        mass[(i, j)] = value;
        mass[(j, i)] = value;
    };
    pair(0, 4, mz);
    pair(0, 5, -my);
    pair(1, 3, -mz);
    pair(2, 3, my);
    pair(3, 3, m22 + m33);
    pair(4, 4, m22);
    pair(4, 5, m23);
    pair(5, 5, m33);
    let mut stiffness = Matrix6::zeros();
    let columns = (0..6).flat_map(|j| (0..=j).map(move |i| (i, j)));
    for ((i, j), &value) in columns.zip(&values[6..27]) {
        stiffness[(i, j)] = value;
        stiffness[(j, i)] = value;
    }
    Row {
        mass,
        stiffness,
        time: values[27],
        position: values[28],
    }
}

fn assemble(rows: &[Row], line: ReferenceLine, longest: f64, remarks: &mut Vec<String>) -> Blade {
    let length = line.length();
    let in_meters = longest > 1.0 + 1e-9;
    if in_meters {
        remarks.push(format!(
            "the last column goes up to {longest}: it is treated as arc length [m], not as the \
             part of the length"
        ));
    }
    let scale = if in_meters { 1.0 } else { length };
    let station = |row: &Row| Station {
        arc_length: row.position * scale,
        stiffness: row.stiffness,
        mass: row.mass,
    };
    let time = rows.first().map_or(0.0, |row| row.time);
    if rows.iter().any(|row| row.time != time) {
        remarks.push(format!(
            "the damping time mu differs between stations: the first, {time} s, is used for \
             all"
        ));
    }
    Blade {
        name: String::new(),
        line,
        reference_point: Vector2::zeros(),
        stations: rows.iter().map(station).collect(),
        interpolation: Interpolation::Linear,
        damping: (time != 0.0).then_some(BladeDamping::Proportional(time)),
        provenance: provenance("", &[]),
    }
}

/// The table and its line.
pub fn write(blade: &Blade, name: &str) -> Writing {
    let mut lost = Vec::new();
    let blade = &stations::prepared(blade, &mut lost);
    let header = Header::new(blade, Convention::Vabs, "reference line");
    let line_name = format!("{name}.line.csv");
    let length = blade.line.length();
    let time = damping_time(blade.damping.as_ref(), &mut lost);
    let stations = stations::linear_stations(blade);
    let mut text = header.lines("# ");
    text.push_str(&format!("# {LINE_FILE} {line_name}\n"));
    text.push_str(
        "# columns: m m*y m*z m33 m23 m22 k11 k12 k22 k13 k23 k33 k14 k24 k34 k44 k15 k25 k35 k45 \
         k55 k16 k26 k36 k46 k56 k66 mu eta\n",
    );
    let mut change = 0.0_f64;
    for station in &stations {
        let values = values(station, time, station.arc_length / length);
        let back = row(&values);
        let scale = station.mass.amax();
        change = change.max((back.mass - station.mass).amax() / scale);
        text.push_str(&values.map(digits).join(" "));
        text.push('\n');
    }
    if change > 1e-14 {
        lost.push(format!(
            "the mass matrix has entries that six numbers cannot carry (it is not the matrix of a \
             rigid slice): up to {change:.2e} of its largest entry"
        ));
    }
    Writing {
        files: vec![
            (format!("{name}.dym").into(), text),
            (line_name.into(), csv::write_line(blade)),
        ],
        lost,
    }
}

fn values(station: &Station, time: f64, eta: f64) -> [f64; COLUMNS] {
    let (m, k) = (&station.mass, &station.stiffness);
    let mut values = [0.0; COLUMNS];
    let mass = [(0, 0), (2, 3), (0, 4), (5, 5), (4, 5), (4, 4)].map(|pair| m[pair]);
    values[..6].copy_from_slice(&mass);
    let columns = (0..6).flat_map(|j| (0..=j).map(move |i| (i, j)));
    for (value, pair) in values[6..27].iter_mut().zip(columns) {
        *value = k[pair];
    }
    values[27] = time;
    values[28] = eta;
    values
}

/// One damping time for all components.
fn damping_time(damping: Option<&BladeDamping>, lost: &mut Vec<String>) -> f64 {
    match damping {
        Some(BladeDamping::Proportional(time)) => *time,
        Some(BladeDamping::Times(times)) => {
            let mean = times.iter().sum::<f64>() / 6.0;
            let apart = times.iter().map(|time| (time - mean).abs());
            lost.push(format!(
                "six damping times become one, their mean {mean:.3e} s: they differ from it by up \
                 to {:.2e} s",
                apart.fold(0.0, f64::max)
            ));
            mean
        }
        // Matrices were converted to times earlier.
        None | Some(BladeDamping::Viscous(_)) => 0.0,
    }
}
