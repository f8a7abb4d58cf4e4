//! Helicoid's table of a blade: comma-separated values below a header that states units,
//! frame, order and reference point.
//!
//! ```text
//! # helicoid blade table
//! # units: SI (m, rad, N, N m, N m^2, kg/m, kg, kg m, s)
//! # frame: helicoid (x along the blade ...)
//! # order: axial, shear y, shear z, torsion, bending y, bending z
//! # reference point: reference line
//! # course: spline
//! # interpolation: linear
//! # damping: none
//! # stations: 2
//! table,line
//! x [m],y [m],z [m],twist [rad]
//! 0.0,...
//! table,stations
//! s [m],K11 [N],K12 [N],...,K66 [N m^2],M11 [kg/m],...,M66 [kg m]
//! 0.0,...
//! ```
//!
//! `stations` may be replaced by `sections`, arc lengths and the names of section files
//! (VABS output, property files of section-analyzer); a file of a line alone has neither. Columns
//! may be written without their units.
//! The frame may be any [`Convention`]; the line is always in Helicoid's root axes.

use std::path::Path;

use nalgebra::Vector2;

use crate::blade::{Blade, CurvedStation, Interpolation};
use crate::error::{Diagnostics, SourceLocation};
use crate::line::ReferenceLine;

use super::header::Header;
use super::problem::{ExchangeProblem, Problems};
use super::stations::{self, name_of, provenance};
use super::text::lines;
use super::{Options, Reading, Writing};

mod head;
mod tables;
mod writing;

pub(super) use writing::{write_index, write_line};

use head::Head;
use tables::Tables;

/// The first line of a file.
const MARK: &str = "helicoid blade table";

/// Whether `text` is a table of Helicoid.
pub fn recognize(text: &str) -> bool {
    let mut words = text.lines().map(str::trim).filter(|line| !line.is_empty());
    let head = words.next().unwrap_or_default();
    head.strip_prefix('#')
        .is_some_and(|head| head.trim() == MARK)
        || text.lines().any(|line| line.trim().starts_with("table,"))
}

/// Reads a table, with the section files that it names.
///
/// # Errors
/// All errors of the files.
pub fn read(text: &str, file: &Path, _: &Options) -> Result<Reading, Diagnostics> {
    let mut problems = Problems::new(&file.display().to_string());
    let lines = lines(text);
    let head = Head::parse(&lines, &mut problems);
    let tables = Tables::parse(&lines, &mut problems);
    let mut all = Diagnostics::new();
    let line = head
        .course
        .and_then(|course| tables.line(course, &mut problems));
    tables.check_count(head.stations, &mut problems);
    let stations = tables.stations(head.frame, file, &mut problems, &mut all);
    let locations = tables.locations(file);
    let content = all.keep(problems.finish(line.zip(stations)));
    let content = all.into_result(content)?;
    let Some(((line, stations), interpolation)) = content.zip(head.interpolation) else {
        return Err(incomplete(file));
    };
    let (stations, curved): (Vec<_>, Vec<_>) = stations.into_iter().unzip();
    let blade = Blade {
        name: head.name.unwrap_or_else(|| name_of(file)),
        line,
        reference_point: Vector2::zeros(),
        stations,
        interpolation,
        damping: head.damping,
        provenance: provenance("Helicoid blade table", &[text]),
    };
    let remarks = curved_remarks(&blade, &curved, &locations)?;
    Ok(Reading {
        locations,
        frame: head.frame.map(|frame| frame.name().to_owned()),
        ..Reading::new(blade, remarks)
    })
}

/// Remarks on sections that were solved for curved beams.
///
/// # Errors
/// Sections of another curvature than the line's.
fn curved_remarks(
    blade: &Blade,
    curved: &[Option<CurvedStation>],
    locations: &[SourceLocation],
) -> Result<Vec<String>, Diagnostics> {
    // An invalid line is reported by the check of the blade.
    if !blade.line.problems().is_empty() {
        return Ok(Vec::new());
    }
    let (found, remarks) = blade.compare_curved(curved);
    let mut problems = Diagnostics::new();
    for (station, problem) in found {
        problems.push(locations[station].clone(), &problem);
    }
    problems.into_result(remarks)
}

/// Reads the line of a table that may have no other content.
///
/// # Errors
/// All errors of the line.
pub(super) fn read_line(text: &str, file: &Path) -> Result<ReferenceLine, Diagnostics> {
    let mut problems = Problems::new(&file.display().to_string());
    let lines = lines(text);
    let head = Head::parse(&lines, &mut problems);
    let tables = Tables::parse(&lines, &mut problems);
    let line = head
        .course
        .and_then(|course| tables.line(course, &mut problems));
    problems.finish(line)
}

/// A file whose problems, if any, were not reported.
fn incomplete(file: &Path) -> Diagnostics {
    let mut problems = Problems::new(&file.display().to_string());
    problems.push(
        0,
        &ExchangeProblem::Missing {
            what: "a part of the table".to_owned(),
            help: "see the page on formats for a complete one".to_owned(),
        },
    );
    problems.into_diagnostics()
}

/// The table of `blade`.
pub fn write(blade: &Blade, name: &str) -> Writing {
    let mut lost = Vec::new();
    let blade = stations::prepared(blade, &mut lost);
    Writing {
        files: vec![(format!("{name}.csv").into(), writing::write_blade(&blade))],
        lost,
    }
}

/// Words of the interpolation.
fn interpolation_name(interpolation: Interpolation) -> &'static str {
    match interpolation {
        Interpolation::Linear => "linear",
        Interpolation::Constant => "constant",
    }
}

/// The statement at the beginning of all exports, for tables.
fn statement(blade: &Blade) -> String {
    let convention = super::frame::Convention::Helicoid;
    Header::new(blade, convention, "reference line").lines("# ")
}
