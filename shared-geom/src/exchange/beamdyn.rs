//! Blades of BeamDyn, the beam module of OpenFAST: a primary file with the key points of
//! the reference line, which names a blade file with the matrices.
//!
//! Axes: see [`Convention::BeamDyn`]; `initial_twist` is positive about -z. Before twist,
//! BeamDyn's x axis has no component along its root y, while Helicoid's y axis has none
//! along z: with a tangent `t` in Helicoid's root axes, BeamDyn's axes are Helicoid's
//! turned about `t` by
//!
//! ```text
//! delta = -asin(t_y t_z / (sqrt(t_x^2 + t_y^2) sqrt(t_x^2 + t_z^2)))
//! beta  = delta - initial_twist
//! ```
//!
//! # References
//! - OpenFAST documentation, BeamDyn, "Input files"; layouts of versions 4 and 5.

use std::path::Path;

use nalgebra::{Matrix6, Vector2, Vector3};

use crate::blade::{Blade, BladeDamping, Interpolation, Station};
use crate::document::read_text;
use crate::error::{Diagnostics, SourceLocation};
use crate::line::{Course, LinePoint, ReferenceLine};

use super::frame::Convention;
use super::problem::{ExchangeProblem, Problems};
use super::stations::{self, name_of, provenance};
use super::text::lines;
use super::{Options, Reading, Writing};

mod blade_file;
mod primary;

use blade_file::BladeFile;
use primary::Primary;

/// Distance of the two stations of a jump, as part of the length.
const RAMP: f64 = 1e-8;

/// Version of OpenFAST that reads the files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Layout {
    /// Versions 3 and 4.
    Four,
    /// Version 5: with modal damping, without pitch actuator.
    Five,
}

/// Whether `text` is one of the two files.
pub fn recognize(text: &str) -> bool {
    primary::recognize(text) || blade_file::recognize(text)
}

/// Reads a primary file with the blade file that it names, or a blade file alone as a
/// straight blade of the length of `options`.
///
/// # Errors
/// All errors of the files; a blade file alone without a length.
pub fn read(text: &str, file: &Path, options: &Options) -> Result<Reading, Diagnostics> {
    if primary::recognize(text) {
        return read_both(text, file);
    }
    let mut problems = Problems::new(&file.display().to_string());
    let content = blade_file::parse(&lines(text), &mut problems);
    if options.length.is_none() {
        problems.push(
            0,
            &ExchangeProblem::Missing {
                what: "the reference line of the blade (this is a BeamDyn blade file, which has \
                       the matrices only)"
                    .to_owned(),
                help: "give the primary file, which has the key points and names this file, or \
                       --length METERS for a straight blade without twist"
                    .to_owned(),
            },
        );
    }
    let content = problems.finish(content.zip(options.length));
    let (content, length) = content?;
    let line = ReferenceLine::straight(length);
    let shown = file.display().to_string();
    let mut reading = assemble((content, &shown), line, file, &[text]);
    reading.remarks.push(format!(
        "the line is straight, {length} m long, without twist: a blade file has none"
    ));
    Ok(reading)
}

/// Reads both files; returns the problems of both.
fn read_both(text: &str, file: &Path) -> Result<Reading, Diagnostics> {
    let mut problems = Problems::new(&file.display().to_string());
    let primary = primary::parse(&lines(text), &mut problems);
    let mut all = Diagnostics::new();
    let Some((name, line)) = primary::blade_file_name(text) else {
        return Err(problems.into_diagnostics());
    };
    let path = file.parent().unwrap_or(Path::new("")).join(&name);
    let is_there = problems.finds(&path, "BldFile", &name, line);
    let primary = all.keep(problems.finish(primary));
    if !is_there {
        return Err(all);
    }
    let content = all.keep(read_text(&path)).and_then(|text| {
        let mut problems = Problems::new(&path.display().to_string());
        let content = blade_file::parse(&lines(&text), &mut problems);
        let content = all.keep(problems.finish(content))?;
        Some((content, text))
    });
    match (primary, content) {
        (Some(primary), Some((content, blade_text))) if all.is_empty() => {
            let line = line_of(&primary);
            let shown = path.display().to_string();
            let texts = [text, blade_text.as_str()];
            let mut reading = assemble((content, &shown), line, file, &texts);
            reading.remarks.extend(primary.remarks);
            Ok(reading)
        }
        _ => Err(all),
    }
}

/// The blade of the stations of `blade_file` along a line.
fn assemble(
    (content, blade_file): (BladeFile, &str),
    line: ReferenceLine,
    file: &Path,
    texts: &[&str],
) -> Reading {
    let length = line.length();
    let convention = Convention::BeamDyn;
    let station = |&(eta, stiffness, mass): &(f64, Matrix6<f64>, Matrix6<f64>)| Station {
        arc_length: eta * length,
        stiffness: convention.to_ours(&stiffness),
        mass: convention.to_ours(&mass),
    };
    let blade = Blade {
        name: name_of(file),
        line,
        reference_point: Vector2::zeros(),
        stations: content.stations.iter().map(station).collect(),
        interpolation: Interpolation::Linear,
        damping: content.times.map(|times| {
            let times = convention.values_to_ours(&times);
            if times.iter().all(|&time| time == times[0]) {
                BladeDamping::Proportional(times[0])
            } else {
                BladeDamping::Times(times)
            }
        }),
        provenance: provenance("BeamDyn files", texts),
    };
    let at = |&line: &usize| SourceLocation::line(blade_file, line);
    Reading {
        locations: content.lines.iter().map(at).collect(),
        has_other_damping: content.has_modal_damping,
        ..Reading::new(blade, content.remarks)
    }
}

/// The line through the key points, in Helicoid's axes.
fn line_of(primary: &Primary) -> ReferenceLine {
    let axes = Convention::BeamDyn.axes();
    let point = |row: &[f64; 4]| LinePoint {
        position: axes * Vector3::new(row[0], row[1], row[2]),
        twist: 0.0,
    };
    let points = primary.points.iter().map(point).collect();
    let mut line = ReferenceLine::through(points, Course::Spline);
    let offsets = offsets(&line);
    let twists = primary.points.iter().zip(offsets);
    for (point, (row, offset)) in line.points.iter_mut().zip(twists) {
        point.twist = offset - row[3].to_radians();
    }
    line
}

/// The angle from Helicoid's axes to BeamDyn's about the tangent, without twist, at each
/// point of a line [rad].
fn offsets(line: &ReferenceLine) -> Vec<f64> {
    let curve = line.curve();
    let offset = |&s: &f64| {
        let t = curve.at(s).tangent;
        -(t.y * t.z / (t.x.hypot(t.y) * t.x.hypot(t.z))).asin()
    };
    curve.arc_lengths().iter().map(offset).collect()
}

/// Both files, for OpenFAST 5.
pub fn write(blade: &Blade, name: &str) -> Writing {
    write_as(blade, name, Layout::Five)
}

/// Both files, for OpenFAST 3 and 4.
pub fn write_four(blade: &Blade, name: &str) -> Writing {
    write_as(blade, name, Layout::Four)
}

fn write_as(blade: &Blade, name: &str, layout: Layout) -> Writing {
    let mut lost = Vec::new();
    let blade = &stations::prepared(blade, &mut lost);
    let line = spline(&blade.line, &mut lost);
    let axes = Convention::BeamDyn.axes();
    let points = line
        .points
        .iter()
        .zip(offsets(&line))
        .map(|(point, offset)| {
            let position = axes.tr_mul(&point.position);
            let twist = (offset - point.twist).to_degrees();
            [position.x, position.y, position.z, twist]
        });
    let blade_name = format!("{name}_blade.dat");
    let primary = primary::write(blade, &points.collect::<Vec<_>>(), &blade_name, layout);
    let content = blade_file::write(blade, &rows(blade, &mut lost), layout);
    Writing {
        files: vec![
            (format!("{name}.inp").into(), primary),
            (blade_name.into(), content),
        ],
        lost,
    }
}

/// The line as BeamDyn interpolates it: splines through at least three points.
fn spline(line: &ReferenceLine, lost: &mut Vec<String>) -> ReferenceLine {
    let mut points = line.points.clone();
    if let [a, b] = points[..] {
        let middle = LinePoint {
            position: 0.5 * (a.position + b.position),
            twist: 0.5 * (a.twist + b.twist),
        };
        points.insert(1, middle);
    }
    let spline = ReferenceLine::through(points, Course::Spline);
    if line.course == Course::Polyline && line.points.len() > 2 {
        let (point, twist) = stations::apart(line, &spline);
        if point > 0.0 || twist > 0.0 {
            lost.push(format!(
                "the line is straight between its points; BeamDyn runs splines through them: the \
                 difference is up to {point:.2e} m and {:.2e} deg of twist",
                twist.to_degrees()
            ));
        }
    }
    spline
}

/// Stations in the axes of BeamDyn, at increasing parts of the length.
fn rows(blade: &Blade, lost: &mut Vec<String>) -> Vec<(f64, Matrix6<f64>, Matrix6<f64>)> {
    let length = blade.line.length();
    let stations = stations::linear_stations(blade);
    let jumps = stations::jumps(&stations);
    if !jumps.is_empty() {
        lost.push(format!(
            "{} jumps of the properties become ramps of {:.1e} m (at {:.6} m for the first)",
            jumps.len(),
            RAMP * length,
            jumps[0]
        ));
    }
    let convention = Convention::BeamDyn;
    let mut rows: Vec<(f64, Matrix6<f64>, Matrix6<f64>)> = Vec::with_capacity(stations.len());
    for station in &stations {
        let exact = station.arc_length / length;
        let eta = if (exact - 1.0).abs() < 1e-12 {
            1.0
        } else {
            exact
        };
        let row = |eta: f64| {
            let stiffness = convention.from_ours(&station.stiffness);
            (eta, stiffness, convention.from_ours(&station.mass))
        };
        match rows.last_mut() {
            // At the tip the ramp ends at the jump, elsewhere it begins at the jump.
            Some(last) if last.0 >= eta && eta >= 1.0 => {
                last.0 = 1.0 - RAMP;
                rows.push(row(1.0));
            }
            Some(last) if last.0 >= eta => {
                let next = last.0 + RAMP;
                rows.push(row(next));
            }
            _ => rows.push(row(eta)),
        }
    }
    rows
}
