//! Output of VABS (`.K`): titled blocks of text, a section a file.
//!
//! A blade is several files with an index, a table of arc lengths and file names (see
//! [`super::csv`]). Axes as ours. A matrix stands below its title and a line of `=`.
//!
//! # References
//! - The layout of the blocks: VABS manual for users, output files, as read by the
//!   open readers of PreVABS, SONATA and pyNuMAD.

use std::path::Path;

use nalgebra::{Matrix6, Vector2};

use crate::blade::{Blade, Interpolation, Station};
use crate::error::Diagnostics;
use crate::line::ReferenceLine;

use super::csv;
use super::frame::Convention;
use super::header::Header;
use super::problem::{ExchangeProblem, Problems};
use super::stations::{self, name_of, provenance, symmetric};
use super::text::{Line, digits, lines, matrix_lines};
use super::{Options, Reading, Writing};

const MASS: &str = "The 6X6 Mass Matrix";
const STIFFNESS: &str = "Timoshenko Stiffness Matrix";

/// Whether `text` is such an output.
pub fn recognize(text: &str) -> bool {
    text.lines()
        .any(|line| begins(line, MASS) || begins(line, STIFFNESS))
}

/// Whether a line is the title, whatever the case, and not one that goes on.
fn begins(line: &str, title: &str) -> bool {
    let line = line.trim();
    let head = line.get(..title.len());
    head.is_some_and(|head| head.eq_ignore_ascii_case(title))
        && !line.to_lowercase().contains(" at the ")
        && !line.to_lowercase().contains(" at shear")
}

/// Reads one section, as a straight uniform blade of the length of `options`.
///
/// # Errors
/// Everything that is wrong with the file; a length that is not given.
pub fn read(text: &str, file: &Path, options: &Options) -> Result<Reading, Diagnostics> {
    let (stiffness, mass) = section(text, &file.display().to_string())?;
    let Some(length) = options.length else {
        let mut problems = Problems::new(&file.display().to_string());
        problems.push(
            0,
            &ExchangeProblem::Missing {
                what: "the length of the blade (a VABS output is one section)".to_owned(),
                help: "give --length METERS for a uniform straight blade, or a table of arc \
                       lengths and section files"
                    .to_owned(),
            },
        );
        return Err(problems.into_diagnostics());
    };
    let station = |arc_length| Station {
        arc_length,
        stiffness,
        mass,
    };
    let blade = Blade {
        name: name_of(file),
        line: ReferenceLine::straight(length),
        reference_point: Vector2::zeros(),
        stations: vec![station(0.0), station(length)],
        interpolation: Interpolation::Linear,
        damping: None,
        provenance: provenance("VABS output", &[text]),
    };
    let remark = format!("one section: the blade is straight and uniform, {length} m long");
    Ok(Reading::new(blade, vec![remark]))
}

/// Stiffness and mass of the section of an output, shown as `file` in messages.
///
/// # Errors
/// Everything that is wrong with the text.
pub fn section(text: &str, file: &str) -> Result<(Matrix6<f64>, Matrix6<f64>), Diagnostics> {
    let mut problems = Problems::new(file);
    let lines = lines(text);
    let stiffness = block(&lines, STIFFNESS, &mut problems);
    let mass = block(&lines, MASS, &mut problems);
    problems.finish(stiffness.zip(mass))
}

/// The matrix below a title.
fn block(lines: &[Line<'_>], title: &str, problems: &mut Problems) -> Option<Matrix6<f64>> {
    let Some(at) = lines.iter().position(|line| begins(line.text, title)) else {
        problems.push(
            0,
            &ExchangeProblem::Missing {
                what: format!("the block \"{title}\""),
                help: "run VABS with the Timoshenko model switched on (timoshenko flag 1)"
                    .to_owned(),
            },
        );
        return None;
    };
    let body = lines.get(at + 1..).unwrap_or_default();
    let ruled = body
        .iter()
        .take_while(|line| line.text.starts_with('='))
        .count();
    let mut rows = Vec::with_capacity(6);
    for i in 0..6 {
        let Some(line) = body.get(ruled + i) else {
            let problem = ExchangeProblem::CutShort {
                what: format!("the block \"{title}\", after {i} of 6 rows"),
                expected: "rows of six numbers".to_owned(),
            };
            problems.push(lines.last().map_or(0, |line| line.number), &problem);
            return None;
        };
        rows.push(line.numbers::<6>(&format!("{title}, row {}", i + 1), problems));
    }
    let rows: Vec<[f64; 6]> = rows.into_iter().collect::<Option<_>>()?;
    let matrix = Matrix6::from_fn(|i, j| rows[i][j]);
    Some(symmetric(&matrix, title, lines[at].number, problems))
}

/// A file for each station, and their index.
pub fn write(blade: &Blade, name: &str) -> Writing {
    let mut lost = Vec::new();
    let blade = &stations::prepared(blade, &mut lost);
    let stations = stations::linear_stations(blade);
    let file = |i: usize| format!("{name}.{:03}.K", i + 1);
    let names: Vec<_> = (0..stations.len()).map(file).collect();
    let places = stations.iter().map(|station| station.arc_length);
    let index: Vec<_> = places.zip(names.iter().cloned()).collect();
    let mut files = vec![(
        format!("{name}.sections.csv").into(),
        csv::write_index(blade, &index),
    )];
    let sections = stations.iter().zip(names);
    files.extend(sections.map(|(station, name)| (name.into(), section_text(blade, station))));
    lost.push(
        "the .K files hold sections only; line, twist and damping are in the index, which VABS \
         does not read"
            .to_owned(),
    );
    Writing { files, lost }
}

/// The text of one section.
fn section_text(blade: &Blade, station: &Station) -> String {
    let header = Header::new(blade, Convention::Vabs, "reference line");
    let mut text = header.lines("# ");
    text.push_str(&format!(
        "# arc length [m]: {}\n",
        digits(station.arc_length).trim()
    ));
    let mut block = |title: &str, content: &str| {
        let rule = "=".repeat(56);
        text.push_str(&format!("\n {title}\n {rule}\n\n{content}"));
    };
    block(MASS, &matrix_lines(&station.mass));
    let order = "(1-extension; 2,3-shear, 4-twist; 5,6-bending)";
    block(
        &format!("{STIFFNESS} {order}"),
        &matrix_lines(&station.stiffness),
    );
    if let Some(compliance) = station.stiffness.try_inverse() {
        let title = format!("Timoshenko Compliance Matrix {order}");
        block(&title, &matrix_lines(&compliance));
    }
    text
}
