//! The blade file that programs write: versioned JSON.

use std::path::Path;

use nalgebra::{Vector2, Vector3};
use serde::{Deserialize, Serialize};

use super::{Blade, BladeDamping, BladeProblem, Interpolation, Reading, Station, input};
use crate::document::read_text;
use crate::error::{Diagnostics, SourceLocation};
use crate::line::{Course, LinePoint, ReferenceLine};
use crate::section::file::{FileProvenance, matrix6, rows};
use crate::section::json;

/// Latest version of the file format that this program reads.
pub const VERSION: u64 = 1;
const FORMAT: &str = "helicoid blade";
const CONVENTION: &str = "root axes: x outward along the span, y toward the leading edge, \
    z toward the upper surface; section axes: x along the line, y and z in the section, \
    twist nose up; components: axial, shear y, shear z, torsion, bending y, bending z; \
    at the reference point, which is (y, z) from the line";

/// The file as written, field by field.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    format: String,
    version: u64,
    name: String,
    units: String,
    #[serde(default)]
    convention: String,
    reference_point: [f64; 2],
    line: FileLine,
    interpolation: FileInterpolation,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    damping: Option<FileDamping>,
    stations: Vec<FileStation>,
    provenance: FileProvenance,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct FileLine {
    course: FileCourse,
    points: Vec<[f64; 3]>,
    twist: Vec<f64>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    curvature: Vec<[f64; 3]>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    lengths: Vec<f64>,
}

#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum FileCourse {
    Polyline,
    Spline,
    Arcs,
}

#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum FileInterpolation {
    Linear,
    Constant,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "snake_case")]
enum FileDamping {
    Proportional(f64),
    Times([f64; 6]),
    Viscous(Vec<[[f64; 6]; 6]>),
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct FileStation {
    arc_length: f64,
    stiffness: [[f64; 6]; 6],
    mass: [[f64; 6]; 6],
}

/// The part of a file that shows whether the rest can be read.
#[derive(Debug, Deserialize)]
struct Head {
    format: String,
    version: u64,
    units: String,
}

/// The text of the blade file of `blade`. Numbers keep all their digits.
pub fn write(blade: &Blade) -> String {
    match serde_json::to_value(File::from(blade)) {
        Ok(value) => json::layout(&value),
        // Plain numbers, words and lists always have a JSON form.
        Err(error) => error.to_string(),
    }
}

/// Reads and checks the blade file at `path`, written by a program or a person.
///
/// # Errors
/// A file that cannot be read, and all errors of [`parse`].
pub fn read(path: &Path) -> Result<Reading, Diagnostics> {
    parse(&read_text(path)?, &path.display().to_string())
}

/// Reads and checks the text of a blade file, in JSON or else in TOML, shown as `file` in
/// messages; the files that it names lie in its folder.
///
/// # Errors
/// Every problem of a file in TOML, of the tables that it names, and of the blade. In JSON:
/// Text of another format or a newer version, missing or unknown fields (with the
/// line), and every [`BladeProblem`] of the content.
pub fn parse(text: &str, file: &str) -> Result<Reading, Diagnostics> {
    parse_with(text, file, false)
}

/// As [`parse`]; if `rigid_shear`, stations without shear stiffness become rigid in shear before
/// they are checked, which is remarked.
///
/// # Errors
/// As [`parse`].
pub(crate) fn parse_with(
    text: &str,
    file: &str,
    rigid_shear: bool,
) -> Result<Reading, Diagnostics> {
    if !text.trim_start().starts_with('{') {
        return input::parse(text, file, rigid_shear);
    }
    let malformed = |error: serde_json::Error| {
        let location = SourceLocation::line(file, error.line().max(1));
        let reason = json::reason(&error);
        Diagnostics::one(location, &BladeProblem::Malformed { reason })
    };
    let head: Head = serde_json::from_str(text).map_err(malformed)?;
    check_head(&head, text, file)?;
    let content: File = serde_json::from_str(text).map_err(malformed)?;
    let mut problems = Diagnostics::new();
    let Some(mut blade) = content.blade(text, file, &mut problems) else {
        return Err(problems);
    };
    let replaced = rigid_shear.then(|| blade.replace_absent_shear());
    let lines = lines_of("arc_length", text);
    for (station, problem) in blade.shared_problems() {
        let line = station.and_then(|station| lines.get(station));
        let location = match line {
            Some(line) => SourceLocation::line(file, *line),
            None => SourceLocation::file(file),
        };
        problems.push(location, &problem);
    }
    let mut remarks = blade.remarks();
    remarks.extend(replaced);
    problems.into_result(Reading::new(blade, remarks))
}

fn check_head(head: &Head, text: &str, file: &str) -> Result<(), Diagnostics> {
    let problem = if head.format != FORMAT {
        let reason = format!("\"format\" is \"{}\", expected \"{FORMAT}\"", head.format);
        ("format", BladeProblem::Malformed { reason })
    } else if head.version > VERSION {
        let (found, known) = (head.version, VERSION);
        ("version", BladeProblem::Newer { found, known })
    } else if head.units != "SI" {
        let found = head.units.clone();
        ("units", BladeProblem::Units { found })
    } else {
        return Ok(());
    };
    let location = location_of(problem.0, text, file);
    Err(Diagnostics::one(location, &problem.1))
}

/// The line of a field: the first on which its name is a key.
fn location_of(field: &str, text: &str, file: &str) -> SourceLocation {
    match lines_of(field, text)[..] {
        [line, ..] => SourceLocation::line(file, line),
        [] => SourceLocation::file(file),
    }
}

/// The lines, from one, on which the name of a field is a key.
fn lines_of(field: &str, text: &str) -> Vec<usize> {
    let key = format!("\"{field}\":");
    let lines = text.lines().enumerate();
    let found =
        lines.filter(|(_, line)| line.trim_start_matches([' ', '\t', '{']).starts_with(&key));
    found.map(|(i, _)| i + 1).collect()
}

impl From<&Blade> for File {
    fn from(blade: &Blade) -> Self {
        let station = |station: &Station| FileStation {
            arc_length: station.arc_length,
            stiffness: rows(&station.stiffness),
            mass: rows(&station.mass),
        };
        Self {
            format: FORMAT.to_owned(),
            version: VERSION,
            name: blade.name.clone(),
            units: "SI".to_owned(),
            convention: CONVENTION.to_owned(),
            reference_point: blade.reference_point.into(),
            line: FileLine::from(&blade.line),
            interpolation: match blade.interpolation {
                Interpolation::Linear => FileInterpolation::Linear,
                Interpolation::Constant => FileInterpolation::Constant,
            },
            damping: blade.damping.as_ref().map(|damping| match damping {
                BladeDamping::Proportional(time) => FileDamping::Proportional(*time),
                BladeDamping::Times(times) => FileDamping::Times(*times),
                BladeDamping::Viscous(all) => FileDamping::Viscous(all.iter().map(rows).collect()),
            }),
            stations: blade.stations.iter().map(station).collect(),
            provenance: FileProvenance::from(&blade.provenance),
        }
    }
}

impl From<&ReferenceLine> for FileLine {
    fn from(line: &ReferenceLine) -> Self {
        Self {
            course: match line.course {
                Course::Polyline => FileCourse::Polyline,
                Course::Spline => FileCourse::Spline,
                Course::Arcs => FileCourse::Arcs,
            },
            points: line.points.iter().map(|p| p.position.into()).collect(),
            twist: line.points.iter().map(|point| point.twist).collect(),
            curvature: line.curvature.iter().map(|&k| k.into()).collect(),
            lengths: line.arc_length.clone(),
        }
    }
}

impl FileLine {
    /// The content; `None` if the numbers of twists and points differ.
    fn line(self) -> Option<ReferenceLine> {
        if self.twist.len() != self.points.len() {
            return None;
        }
        let points = self.points.into_iter().zip(self.twist);
        let point = |(position, twist)| LinePoint {
            position: Vector3::from(position),
            twist,
        };
        Some(ReferenceLine {
            points: points.map(point).collect(),
            course: match self.course {
                FileCourse::Polyline => Course::Polyline,
                FileCourse::Spline => Course::Spline,
                FileCourse::Arcs => Course::Arcs,
            },
            curvature: self.curvature.into_iter().map(Vector3::from).collect(),
            arc_length: self.lengths,
        })
    }
}

impl File {
    /// The content; notes inconsistent fields.
    fn blade(self, text: &str, file: &str, problems: &mut Diagnostics) -> Option<Blade> {
        let mut malformed = |field, reason: &str| {
            let reason = reason.to_owned();
            let problem = BladeProblem::Malformed { reason };
            problems.push(location_of(field, text, file), &problem);
        };
        let line = self.line.line();
        if line.is_none() {
            malformed("line", "\"line\" needs one entry of \"twist\" per point");
        }
        let provenance = self.provenance.provenance();
        if provenance.is_none() {
            let reason = "each entry of \"history\" has either \"shift\" or \"rotate\"";
            malformed("history", reason);
        }
        let count = provenance.as_ref().map_or(0, |from| from.sections.len());
        if count > 0 && count != self.stations.len() {
            malformed("sections", "\"sections\" needs one entry per station");
        }
        let station = |station: FileStation| Station {
            arc_length: station.arc_length,
            stiffness: matrix6(&station.stiffness),
            mass: matrix6(&station.mass),
        };
        Some(Blade {
            name: self.name,
            line: line?,
            reference_point: Vector2::from(self.reference_point),
            stations: self.stations.into_iter().map(station).collect(),
            interpolation: match self.interpolation {
                FileInterpolation::Linear => Interpolation::Linear,
                FileInterpolation::Constant => Interpolation::Constant,
            },
            damping: self.damping.map(|damping| match damping {
                FileDamping::Proportional(time) => BladeDamping::Proportional(time),
                FileDamping::Times(times) => BladeDamping::Times(times),
                FileDamping::Viscous(all) => {
                    BladeDamping::Viscous(all.iter().map(matrix6).collect())
                }
            }),
            provenance: provenance?,
        })
    }
}
