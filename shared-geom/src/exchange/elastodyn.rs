//! Blades of ElastoDyn, the modal structural module of OpenFAST: the blade file with
//! distributed mass and bending stiffness, alone or named by the primary file, which has
//! the radii of hub and tip; and the tower file as a straight line, whose z is fore-aft
//! and whose y is side-side.
//!
//! ElastoDyn blades are straight, bend only, and have their properties in axes turned by
//! `StrcTwst`, which is BeamDyn's `initial_twist`: nose down. Axial, shear and torsional
//! stiffness are infinite there; here they have the substitutes of
//! [`crate::blade::Blade::make_shear_rigid`], unless the older table of 17 columns has
//! them.
//!
//! # References
//! - OpenFAST documentation, ElastoDyn, "Input files"; blade files of the DTU 10 MW (17
//!   columns) and of the IEA-22 (6 columns).

use std::path::Path;

use nalgebra::{Matrix6, Vector2, Vector3};

use crate::blade::{Blade, Interpolation, Station, rigid_force, rigid_torsion};
use crate::document::read_text;
use crate::error::{Diagnostics, SourceLocation};
use crate::line::{Course, LinePoint, ReferenceLine};
use crate::units::rounded;

use super::named::{companion, named, required};
use super::problem::{ExchangeProblem, Problems};
use super::stations::{name_of, provenance};
use super::{Options, Reading};

mod table;

use table::{BLADE, Names, Row, TOWER, Table};

/// Names of the blade file in the primary file.
const BLADE_FILE: [&str; 2] = ["BldFile(1)", "BldFile1"];

/// Whether `text` is a blade file, a tower file or a primary file.
pub(super) fn recognize(text: &str) -> bool {
    ["NBlInpSt", "NTwInpSt"]
        .iter()
        .any(|name| named(text, &[name]).is_some())
        || named(text, &["TipRad"]).is_some() && named(text, &BLADE_FILE).is_some()
}

/// Reads a primary file with the blade file that it names, or a file of blade or tower alone with the
/// length of `options`.
///
/// # Errors
/// All errors of the files; a file of blade or tower alone without a length.
pub(super) fn read(text: &str, file: &Path, options: &Options) -> Result<Reading, Diagnostics> {
    let mut problems = Problems::new(&file.display().to_string());
    let is_tower = named(text, &["NTwInpSt"]).is_some();
    if !is_tower && named(text, &["NBlInpSt"]).is_none() {
        return read_primary(text, file, problems);
    }
    let names = if is_tower { &TOWER } else { &BLADE };
    let table = table::parse(text, names, &mut problems);
    if options.length.is_none() {
        let part = names.part;
        let help = match is_tower {
            true => {
                "give [rotor.tower] with its height, or --length METERS: TowerHt less TowerBsHt"
            }
            false => {
                "give the primary file of ElastoDyn or the .fst file, which lead to TipRad \
                 and HubRad, or --length METERS"
            }
        };
        problems.push(
            0,
            &ExchangeProblem::Missing {
                what: format!(
                    "the length of the {part} (an ElastoDyn {part} file has parts of it only)"
                ),
                help: help.to_owned(),
            },
        );
    }
    let (table, length) = problems.finish(table.zip(options.length))?;
    Ok(assemble(table, (names, length), file, &[text]))
}

/// Reads both files; returns the problems of both.
fn read_primary(text: &str, file: &Path, mut problems: Problems) -> Result<Reading, Diagnostics> {
    let tip = required(text, &["TipRad"], &mut problems);
    let hub = required(text, &["HubRad"], &mut problems);
    let path = companion(text, &BLADE_FILE, file, &mut problems);
    let length = tip.zip(hub).map(|(tip, hub)| tip - hub);
    if let Some(found) = length.filter(|length| *length <= 0.0) {
        problems.push(
            named(text, &["TipRad"]).map_or(0, |found| found.line),
            &ExchangeProblem::Other {
                what: "TipRad - HubRad, the length of the blade".to_owned(),
                found: format!("{} m", rounded(found)),
                expected: "more than zero".to_owned(),
                help: "correct one of the radii".to_owned(),
            },
        );
    }
    let ((length, path), hub) = problems.finish(length.zip(path).zip(hub))?;
    let blade_text = read_text(&path)?;
    let mut problems = Problems::new(&path.display().to_string());
    let table = table::parse(&blade_text, &BLADE, &mut problems);
    let table = problems.finish(table)?;
    let mut reading = assemble(table, (&BLADE, length), &path, &[text, &blade_text]);
    reading.remarks.insert(
        0,
        format!(
            "length {} m: TipRad less HubRad; the radius of the hub, {hub} m, and the \
             precone belong to the rotor: give hub_radius and precone",
            rounded(length)
        ),
    );
    Ok(reading)
}

/// The blade, or the tower as one, of a table.
fn assemble(table: Table, (names, length): (&Names, f64), file: &Path, texts: &[&str]) -> Reading {
    let shown = file.display().to_string();
    let positions = table
        .lines
        .iter()
        .map(|line| SourceLocation::line(&shown, *line));
    let point = |row: &Row| LinePoint {
        position: Vector3::new(row.part * length, 0.0, 0.0),
        twist: -row.twist_deg.to_radians(),
    };
    let points = table.rows.iter().map(point).collect();
    let blade = Blade {
        name: name_of(file),
        line: ReferenceLine::through(points, Course::Polyline),
        reference_point: Vector2::zeros(),
        stations: table.rows.iter().map(|row| station(row, length)).collect(),
        interpolation: Interpolation::Linear,
        damping: None,
        provenance: provenance("ElastoDyn", texts),
    };
    let mut remarks = table.remarks;
    remarks.extend(missing(&table.rows, names.part));
    Reading {
        locations: positions.collect(),
        has_other_damping: table.has_damping,
        ..Reading::new(blade, remarks)
    }
}

/// The station of a row.
fn station(row: &Row, length: f64) -> Station {
    let mut stiffness = Matrix6::zeros();
    stiffness[(4, 4)] = row.flap;
    stiffness[(5, 5)] = row.edge;
    let force = rigid_force(&stiffness, length);
    stiffness[(3, 3)] = row.torsion.unwrap_or_else(|| rigid_torsion(&stiffness));
    stiffness[(0, 0)] = row.axial.unwrap_or(force);
    stiffness[(1, 1)] = force;
    stiffness[(2, 2)] = force;
    let [iy, iz] = row.inertia;
    let m = row.mass;
    Station {
        arc_length: row.part * length,
        stiffness,
        mass: Matrix6::from_diagonal(&[m, m, m, iy + iz, iy, iz].into()),
    }
}

/// Remarks on the properties that the table does not have, and their substitutes.
fn missing(rows: &[Row], part: &str) -> Vec<String> {
    let mut absent = Vec::new();
    if rows.iter().any(|row| row.axial.is_none()) {
        absent.push("axial");
    }
    absent.push("shear");
    let mut remarks = Vec::new();
    let torsion = rows.iter().any(|row| row.torsion.is_none());
    remarks.push(format!(
        "{} stiffness is not in the file: rigid, as in ElastoDyn, by 1e6 max(EIy, EIz) / L^2",
        absent.join(" and ")
    ));
    if torsion {
        remarks.push(format!(
            "torsional stiffness is not in the file: rigid, as in ElastoDyn, by 1e3 max(EIy, \
             EIz); modes of torsion need a BeamDyn, HAWC2 or windIO file of the {part}"
        ));
    }
    if rows.iter().all(|row| row.inertia == [0.0, 0.0]) {
        remarks.push("rotary inertia is not in the file: zero, as in ElastoDyn".to_owned());
    }
    remarks.push(
        "mass, elastic and shear centers are not in the file: all on the line, which is straight \
         as in ElastoDyn"
            .to_owned(),
    );
    remarks
}

#[cfg(test)]
mod tests;
