//! Output of VABS (`.K`): titled blocks of text, one section per file.
//!
//! A blade is several files with an index, a table of arc lengths and file names (see
//! [`super::csv`]). Axes are Helicoid's. A matrix is below its title and a line of `=`.
//!
//! # References
//! - The layout of the blocks: VABS manual for users, output files, as read by the
//!   open readers of PreVABS, SONATA and pyNuMAD.

use std::path::Path;

use nalgebra::Vector2;

use crate::blade::{Blade, Interpolation, Station};
use crate::error::Diagnostics;
use crate::line::ReferenceLine;

use super::csv;
use super::frame::Convention;
use super::header::Header;
use super::problem::{ExchangeProblem, Problems};
use super::stations::{self, name_of, provenance};
use super::text::{digits, matrix_lines};
use super::{Options, Reading, Writing};

pub mod blocks;

pub use blocks::recognize;

use blocks::{MASS, STIFFNESS, section};

/// Reads one section, as a straight uniform blade of the length of `options`.
///
/// # Errors
/// All errors of the file; a missing length.
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

/// A file for each station, and their index.
pub fn write(blade: &Blade, name: &str) -> Writing {
    let mut lost = Vec::new();
    let blade = &stations::prepared(blade, &mut lost);
    let stations = stations::linear_stations(blade);
    let file = |i: usize| format!("{name}.{:03}.K", i + 1);
    let names: Vec<_> = (0..stations.len()).map(file).collect();
    let positions = stations.iter().map(|station| station.arc_length);
    let index: Vec<_> = positions.zip(names.iter().cloned()).collect();
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
