//! Blades of QBlade: the structural file with the table of the sections, `.str`, and the
//! geometry with chord, twist and shape of the axis, `.bld`. The turbine file, `.trb`, names
//! both; the main structural file names the first.
//!
//! Full matrices (`BEAMTYPE` 2) are in BeamDyn's axes and order: x to the suction side, y to the
//! trailing edge, as QBlade's local axes of a blade; the geometry is in the same axes of the
//! root, with the twist positive nose down. Engineering properties (`BEAMTYPE` 0 and 1) have
//! centers and radii of gyration as parts of the chord: see [`engineering`].
//!
//! # References
//! - QBlade documentation, "Turbine Structural Model", "Blade Design Module", "Coordinate
//!   Systems", "Turbine Definition ASCII File"; blade file of the IEA-22.

use std::path::{Path, PathBuf};

use nalgebra::{Matrix6, Vector2};

use crate::blade::{Blade, BladeDamping, Interpolation, Station};
use crate::document::read_text;
use crate::error::{Diagnostics, SourceLocation};
use crate::line::ReferenceLine;

use super::frame::Convention;
use super::named::{companion, named};
use super::problem::Problems;
use super::stations::{name_of, provenance};
use super::text::from_upper;
use super::{Options, Reading};

mod engineering;
mod geometry;
mod pair;
mod table;

use geometry::Geometry;
use table::{Content, Row};

/// Name of the blade file in the main file.
const STRUCTURE: [&str; 1] = ["BLDFILE_1"];
/// Name of the geometry in the turbine file.
const GEOMETRY: [&str; 1] = ["BLADEFILE"];
/// Name of the main structural file in the turbine file.
const MAIN: [&str; 1] = ["STRUCTURALFILE"];

/// A file and its text.
struct Source {
    path: PathBuf,
    text: String,
}

/// Whether `text` is one of the files of a blade.
pub(super) fn recognize(text: &str) -> bool {
    table::is_table(text)
        || geometry::is_table(text)
        || named(text, &STRUCTURE).is_some()
        || named(text, &GEOMETRY).is_some()
}

/// Reads a structural file with the geometry next to it, or both files from the file that leads
/// to them. Without a geometry, matrices belong to a straight blade of the length of
/// `options`.
///
/// # Errors
/// All errors of both files; a missing file; a missing length or chord.
pub(super) fn read(text: &str, file: &Path, options: &Options) -> Result<Reading, Diagnostics> {
    let (structure, geometry) = sources(text, file)?;
    let mut all = Diagnostics::new();
    let line = geometry
        .as_ref()
        .and_then(|source| all.keep(geometry::read(&source.text, &source.path)));
    let mut problems = Problems::new(&structure.path.display().to_string());
    let content = table::read(&structure.text, &mut problems);
    let is_engineering = content
        .as_ref()
        .is_some_and(|content| content.is_engineering);
    match (&geometry, options.length) {
        (None, _) if is_engineering => problems.push(0, &pair::without_chord(&structure.path)),
        (None, None) => problems.push(0, &pair::without_line(&structure.path)),
        _ => {}
    }
    let content = all.keep(problems.finish(content));
    let (Some(content), true) = (content, all.is_empty()) else {
        return Err(all);
    };
    let texts: Vec<_> = [Some(&structure), geometry.as_ref()]
        .into_iter()
        .flatten()
        .map(|source| source.text.as_str())
        .collect();
    let length = options.length.unwrap_or_default();
    Ok(assemble(content, line, length, &structure.path, &texts))
}

/// The structural file of a blade, and its geometry if there is one.
fn sources(text: &str, file: &Path) -> Result<(Source, Option<Source>), Diagnostics> {
    let own = || Source {
        path: file.to_owned(),
        text: text.to_owned(),
    };
    let mut problems = Problems::new(&file.display().to_string());
    if table::is_table(text) {
        let geometry = pair::beside(file, "bld", geometry::is_table);
        return Ok((own(), geometry));
    }
    if geometry::is_table(text) {
        let structure = pair::beside(file, "str", table::is_blade);
        if structure.is_none() {
            problems.push(0, &pair::without_structure(file));
        }
        return Ok((problems.finish(structure)?, Some(own())));
    }
    if named(text, &GEOMETRY).is_none() {
        let structure = follow(text, file, &STRUCTURE)?;
        let geometry = pair::beside(&structure.path, "bld", geometry::is_table);
        return Ok((structure, geometry));
    }
    if let Some(found) = named(text, &["ROTATIONALDIR"]).filter(|found| found.value != "0") {
        problems.push(found.line, &pair::reversed(found.value));
        return Err(problems.into_diagnostics());
    }
    let mut all = Diagnostics::new();
    let geometry = all.keep(follow(text, file, &GEOMETRY));
    let main = all.keep(follow(text, file, &MAIN));
    let structure = main.and_then(|main| all.keep(follow(&main.text, &main.path, &STRUCTURE)));
    match structure {
        Some(structure) if all.is_empty() => Ok((structure, geometry)),
        _ => Err(all),
    }
}

/// The file that the line with one of `names` leads to.
fn follow(text: &str, file: &Path, names: &[&str]) -> Result<Source, Diagnostics> {
    let mut problems = Problems::new(&file.display().to_string());
    let path = companion(text, names, file, &mut problems);
    let path = problems.finish(path)?;
    let text = read_text(&path)?;
    Ok(Source { path, text })
}

/// The blade of a table on the line of a geometry, or on a straight one of `length` [m].
fn assemble(
    mut content: Content,
    geometry: Option<Geometry>,
    length: f64,
    file: &Path,
    texts: &[&str],
) -> Reading {
    let mut remarks = std::mem::take(&mut content.remarks);
    let (line, chord) = match geometry {
        Some(geometry) => {
            remarks.extend(geometry.remarks);
            (geometry.line, geometry.chord)
        }
        None => {
            remarks.push(format!(
                "the line is straight, {length} m long, without twist: both are in a .bld file"
            ));
            (ReferenceLine::straight(length), Vec::new())
        }
    };
    let of_line = Sections {
        length: line.length(),
        arcs: line.arc_lengths(),
        chord,
    };
    let (stations, small) = of_line.stations(&content);
    remarks.extend(engineering::small_radii(small, stations.len()));
    let blade = Blade {
        name: name_of(file),
        line,
        reference_point: Vector2::zeros(),
        damping: damping(content.damping, content.times, &stations),
        stations,
        interpolation: Interpolation::Linear,
        provenance: provenance("QBlade", texts),
    };
    let shown = file.display().to_string();
    let at = |row: &Row| SourceLocation::line(&shown, row.line);
    Reading {
        locations: content.rows.iter().map(at).collect(),
        ..Reading::new(blade, remarks)
    }
}

/// The damping of a table: of its rows if they have their own.
fn damping(
    of_all: Option<BladeDamping>,
    times: Option<Vec<f64>>,
    stations: &[Station],
) -> Option<BladeDamping> {
    let Some(times) = times else {
        return of_all;
    };
    let viscous = |(station, time): (&Station, f64)| station.stiffness * time;
    Some(BladeDamping::Viscous(
        stations.iter().zip(times).map(viscous).collect(),
    ))
}

/// The line of a blade, with its chords.
struct Sections {
    /// Length of the line [m].
    length: f64,
    /// Arc lengths of the points [m].
    arcs: Vec<f64>,
    /// Chord at the points [m].
    chord: Vec<f64>,
}

impl Sections {
    /// The stations of a table, and the number of those whose radius of gyration is too small.
    fn stations(&self, content: &Content) -> (Vec<Station>, usize) {
        let [stiff, heavy] = content.factors;
        let mut small = 0;
        let station = |row: &Row| {
            let (stiffness, mass, is_small) = self.matrices(row);
            small += usize::from(is_small);
            Station {
                arc_length: row.part() * self.length,
                stiffness: stiffness * stiff,
                mass: mass * heavy,
            }
        };
        let stations = content.rows.iter().map(station).collect();
        (stations, small)
    }

    /// Stiffness and mass of a row in Helicoid's axes, about the line, without the factors of
    /// the file; and whether a radius of gyration is too small for its mass center.
    fn matrices(&self, row: &Row) -> (Matrix6<f64>, Matrix6<f64>, bool) {
        if let Some(values) = row.properties {
            let chord = self.chord_at(row.part() * self.length);
            return engineering::matrices(&values, chord, self.length);
        }
        let ours = |upper: &[f64]| Convention::BeamDyn.to_ours(&from_upper(upper));
        let (stiffness, mass) = row.numbers.get(4..).unwrap_or_default().split_at(21);
        (ours(stiffness), ours(mass), false)
    }

    /// Chord at an arc length [m], linear between the points.
    fn chord_at(&self, at: f64) -> f64 {
        let next = self.arcs.iter().position(|arc| *arc >= at);
        let next = next.unwrap_or(self.arcs.len().saturating_sub(1));
        let before = next.saturating_sub(1);
        let (from, to) = (self.arcs[before], self.arcs[next]);
        let (a, b) = (self.chord[before], self.chord[next]);
        if to > from {
            a + (b - a) * ((at - from) / (to - from)).clamp(0.0, 1.0)
        } else {
            b
        }
    }
}

#[cfg(test)]
mod pair_tests;
#[cfg(test)]
mod tests;
