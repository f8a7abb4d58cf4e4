//! The property file: versioned JSON.
//!
//! # Example
//!
//! ```
//! use std::path::Path;
//!
//! use shared_geom::section;
//!
//! let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../cases/section/two_materials/last_month.properties.json");
//! let properties = section::read(Path::new(path)).expect("a property file");
//! // written and read again, all digits are the same
//! let again = section::parse(&section::write(&properties), "again.json").expect("a property file");
//! assert_eq!(properties.stiffness, again.stiffness);
//! ```

use std::path::Path;

use nalgebra::{DMatrix, Matrix6, Vector2, Vector3, Vector6};
use serde::{Deserialize, Serialize};

use super::{
    Centers, Change, Damping, ImposedState, InitialCurvature, Piezo, Prestress, PrincipalAxes,
    PropertyProblem, Provenance, SectionFile, SectionProperties, Step, json,
};
use crate::document::read_text;
use crate::error::Diagnostics;

mod fields;
mod locations;
mod points;
mod prestress;
mod shapes;

use locations::{FieldLocations, location_of};
use points::{FileAxes, FileCenters};
use prestress::FilePrestress;

/// Latest version of the file format that this program reads.
///
/// Version 2 adds the history of the provenance, version 3 the effect of prestress and
/// imposed states. A file is written in the first version that has all its fields, which
/// older programs read.
pub const VERSION: u64 = 3;
/// The version without prestress.
const WITHOUT_PRESTRESS: u64 = 2;
/// The version without the history.
const WITHOUT_HISTORY: u64 = 1;
/// The last version without imposed states.
const WITHOUT_IMPOSED: u64 = 2;
const FORMAT: &str = "helicoid section properties";
const CONVENTION: &str = "x along the beam, y and z in the section; components: axial, \
    shear y, shear z, torsion, bending y, bending z; at the reference point";

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
    stiffness: [[f64; 6]; 6],
    mass: [[f64; 6]; 6],
    #[serde(default)]
    centers: Option<FileCenters>,
    #[serde(default)]
    principal_axes: Option<FileAxes>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    initial_curvature: Option<FileCurvature>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    piezo: Option<FilePiezo>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    thermal_force: Option<[f64; 6]>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    imposed: Vec<FileImposed>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    damping: Option<FileDamping>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    prestress: Option<FilePrestress>,
    #[serde(default)]
    provenance: FileProvenance,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct FileCurvature {
    curvature: [f64; 3],
    slope: [f64; 3],
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct FilePiezo {
    electrodes: Vec<String>,
    coupling: Vec<Vec<f64>>,
    capacitance: Vec<Vec<f64>>,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct FileImposed {
    name: String,
    restrained_force: [f64; 6],
    free_strain: [f64; 6],
    #[serde(default, skip_serializing_if = "Option::is_none")]
    stiffness_change: Option<[[f64; 4]; 4]>,
}

#[expect(
    clippy::large_enum_variant,
    reason = "one a file; a plain value is simpler"
)]
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "snake_case")]
enum FileDamping {
    StiffnessProportional(f64),
    Viscous([[f64; 6]; 6]),
}

/// Origin of the numbers; a file of another program may have none.
#[derive(Debug, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct FileProvenance {
    program: String,
    version: String,
    #[serde(default)]
    input_hash: String,
    #[serde(default)]
    nodes: usize,
    #[serde(default)]
    cells: usize,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    history: Vec<FileStep>,
    /// Of blades.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    sections: Vec<SectionFile>,
}

/// Either `shift` or `rotate`.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct FileStep {
    #[serde(default, skip_serializing_if = "Option::is_none")]
    shift: Option<[f64; 2]>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    rotate: Option<f64>,
    program: String,
    version: String,
}

/// The part of a file that shows whether the rest can be read.
#[derive(Debug, Deserialize)]
struct Head {
    format: String,
    version: u64,
    units: String,
}

/// The text of the property file of `section`. Numbers keep all their digits.
pub fn write(section: &SectionProperties) -> String {
    let file = File::from(section);
    match serde_json::to_value(&file) {
        Ok(value) => json::layout(&value),
        // Plain numbers, texts and lists always have a JSON form.
        Err(error) => error.to_string(),
    }
}

/// Reads and checks the property file at `path`.
///
/// # Errors
/// A file that cannot be read, and all errors of [`parse`].
pub fn read(path: &Path) -> Result<SectionProperties, Diagnostics> {
    parse(&read_text(path)?, &path.display().to_string())
}

/// Reads and checks the text of a property file, shown as `file` in messages.
///
/// # Errors
/// Text of another format or a newer version, missing or unknown fields (with the
/// line), and every [`PropertyProblem`] of the content.
pub fn parse(text: &str, file: &str) -> Result<SectionProperties, Diagnostics> {
    let malformed = |error: serde_json::Error| shapes::malformed(&error, text, file);
    let head: Head = serde_json::from_str(text).map_err(malformed)?;
    check_head(&head, text, file)?;
    let content: File = serde_json::from_str(text).map_err(malformed)?;
    let mut problems = Diagnostics::new();
    let section = content.section(text, file, &mut problems);
    let found = section.field_problems();
    if !found.is_empty() {
        let locations = FieldLocations::of(text);
        for (field, problem) in found {
            let path = match &problem {
                PropertyProblem::OfState { index, .. } => format!("imposed.{index}.{field}"),
                _ => field.to_owned(),
            };
            problems.push(locations.location(&path, file), &problem);
        }
    }
    problems.into_result(section)
}

fn check_head(head: &Head, text: &str, file: &str) -> Result<(), Diagnostics> {
    let mut problems = Diagnostics::new();
    if head.format != FORMAT {
        let reason = format!("\"format\" is \"{}\", expected \"{FORMAT}\"", head.format);
        let problem = PropertyProblem::Malformed { reason };
        problems.push(location_of("format", text, file), &problem);
    } else if head.version > VERSION {
        let (found, known) = (head.version, VERSION);
        let problem = PropertyProblem::Newer { found, known };
        problems.push(location_of("version", text, file), &problem);
    } else if head.units != "SI" {
        let found = head.units.clone();
        problems.push(
            location_of("units", text, file),
            &PropertyProblem::Units { found },
        );
    }
    problems.into_result(())
}

/// The first version that has all fields of `section`.
fn least_version(section: &SectionProperties) -> u64 {
    let needed = [
        (!section.imposed.is_empty(), WITHOUT_IMPOSED + 1),
        (section.prestress.is_some(), WITHOUT_PRESTRESS + 1),
        (!section.provenance.history.is_empty(), WITHOUT_HISTORY + 1),
    ];
    let needed = needed.into_iter().filter(|(is_there, _)| *is_there);
    needed.map(|(_, version)| version).max().unwrap_or(1)
}

impl From<&SectionProperties> for File {
    fn from(section: &SectionProperties) -> Self {
        let source = &section.provenance;
        Self {
            format: FORMAT.to_owned(),
            version: least_version(section),
            name: section.name.clone(),
            units: "SI".to_owned(),
            convention: CONVENTION.to_owned(),
            reference_point: section.reference_point.into(),
            stiffness: rows(&section.stiffness),
            mass: rows(&section.mass),
            centers: Some(FileCenters::from(&section.centers)),
            principal_axes: Some(FileAxes::from(&section.principal_axes)),
            initial_curvature: section.initial_curvature.map(|initial| FileCurvature {
                curvature: initial.curvature.into(),
                slope: initial.slope.into(),
            }),
            piezo: section.piezo.as_ref().map(|piezo| FilePiezo {
                electrodes: piezo.electrodes.clone(),
                coupling: lists(&piezo.coupling),
                capacitance: lists(&piezo.capacitance),
            }),
            thermal_force: section.thermal_force.map(Into::into),
            imposed: section.imposed.iter().map(FileImposed::from).collect(),
            damping: section.damping.map(|damping| match damping {
                Damping::StiffnessProportional(time) => FileDamping::StiffnessProportional(time),
                Damping::Viscous(matrix) => FileDamping::Viscous(rows(&matrix)),
            }),
            prestress: section.prestress.as_ref().map(FilePrestress::from),
            provenance: FileProvenance::from(source),
        }
    }
}

impl File {
    /// The imposed states, which a file of an earlier version cannot have: noted.
    fn imposed(&self, text: &str, file: &str, problems: &mut Diagnostics) -> Vec<ImposedState> {
        if self.version <= WITHOUT_IMPOSED && !self.imposed.is_empty() {
            let version = self.version;
            let reason =
                format!("\"imposed\" belongs to version 3, and the file states version {version}");
            let problem = PropertyProblem::Malformed { reason };
            problems.push(location_of("imposed", text, file), &problem);
        }
        let state = |state: &FileImposed| ImposedState {
            name: state.name.clone(),
            restrained_force: Vector6::from(state.restrained_force),
            free_strain: Vector6::from(state.free_strain),
            stiffness_change: state.stiffness_change.as_ref().map(prestress::matrix4),
        };
        self.imposed.iter().map(state).collect()
    }

    /// The history; an invalid one is noted and omitted.
    fn history(&self, text: &str, file: &str, problems: &mut Diagnostics) -> Vec<Step> {
        let steps = &self.provenance.history;
        let mut malformed = |reason: &str| {
            let reason = reason.to_owned();
            let problem = PropertyProblem::Malformed { reason };
            problems.push(location_of("history", text, file), &problem);
        };
        if self.version <= WITHOUT_HISTORY && !steps.is_empty() {
            malformed("\"history\" belongs to version 2, and the file states version 1");
        }
        let known: Vec<_> = steps.iter().filter_map(FileStep::step).collect();
        if known.len() < steps.len() {
            malformed("each entry of \"history\" has either \"shift\" or \"rotate\"");
        }
        known
    }

    /// The table of prestress; invalid parts are noted and omitted.
    fn prestress(&self, text: &str, file: &str, problems: &mut Diagnostics) -> Option<Prestress> {
        let mut malformed = |reason: String| {
            let problem = PropertyProblem::Malformed { reason };
            problems.push(location_of("prestress", text, file), &problem);
        };
        let written = self.prestress.as_ref()?;
        if self.version <= WITHOUT_PRESTRESS {
            let version = self.version;
            malformed(format!(
                "\"prestress\" belongs to version 3, and the file states version {version}"
            ));
        }
        Some(written.prestress(malformed))
    }

    /// The content; ragged matrices are noted and left empty.
    fn section(self, text: &str, file: &str, problems: &mut Diagnostics) -> SectionProperties {
        let history = self.history(text, file, problems);
        let imposed = self.imposed(text, file, problems);
        let prestress = self.prestress(text, file, problems);
        let mut matrix = |field, rows: &[Vec<f64>]| {
            matrix_of(rows).unwrap_or_else(|| {
                let found = "ragged".to_owned();
                let expected = "rows of equal length".to_owned();
                let problem = PropertyProblem::Size {
                    field,
                    found,
                    expected,
                };
                problems.push(location_of("piezo", text, file), &problem);
                DMatrix::zeros(0, 0)
            })
        };
        let piezo = self.piezo.map(|piezo| Piezo {
            coupling: matrix("piezo coupling", &piezo.coupling),
            capacitance: matrix("piezo capacitance", &piezo.capacitance),
            electrodes: piezo.electrodes,
        });
        let (stiffness, mass) = (matrix6(&self.stiffness), matrix6(&self.mass));
        SectionProperties {
            name: self.name,
            reference_point: Vector2::from(self.reference_point),
            centers: match self.centers {
                Some(centers) => centers.centers(),
                None => Centers::or_origin(&stiffness, &mass),
            },
            principal_axes: match self.principal_axes {
                Some(axes) => axes.axes(),
                None => PrincipalAxes::of(&stiffness, &mass).unwrap_or_default(),
            },
            stiffness,
            mass,
            initial_curvature: self.initial_curvature.map(|initial| InitialCurvature {
                curvature: Vector3::from(initial.curvature),
                slope: Vector3::from(initial.slope),
            }),
            piezo,
            thermal_force: self.thermal_force.map(Vector6::from),
            imposed,
            damping: self.damping.map(|damping| match damping {
                FileDamping::StiffnessProportional(time) => Damping::StiffnessProportional(time),
                FileDamping::Viscous(matrix) => Damping::Viscous(matrix6(&matrix)),
            }),
            prestress,
            provenance: Provenance {
                history,
                ..self.provenance.without_history()
            },
        }
    }
}

impl From<&ImposedState> for FileImposed {
    fn from(state: &ImposedState) -> Self {
        Self {
            name: state.name.clone(),
            restrained_force: state.restrained_force.into(),
            free_strain: state.free_strain.into(),
            stiffness_change: state.stiffness_change.as_ref().map(prestress::rows4),
        }
    }
}

impl From<&Provenance> for FileProvenance {
    fn from(source: &Provenance) -> Self {
        Self {
            program: source.program.clone(),
            version: source.version.clone(),
            input_hash: source.input_hash.clone(),
            nodes: source.nodes,
            cells: source.cells,
            history: source.history.iter().map(FileStep::from).collect(),
            sections: source.sections.clone(),
        }
    }
}

impl FileProvenance {
    fn without_history(self) -> Provenance {
        Provenance {
            program: self.program,
            version: self.version,
            input_hash: self.input_hash,
            nodes: self.nodes,
            cells: self.cells,
            history: Vec::new(),
            sections: self.sections,
        }
    }

    /// The content; `None` unless every step of the history is exactly one change.
    pub(crate) fn provenance(self) -> Option<Provenance> {
        let steps: Option<_> = self.history.iter().map(FileStep::step).collect();
        let history = steps?;
        Some(Provenance {
            history,
            ..self.without_history()
        })
    }
}

impl From<&Step> for FileStep {
    fn from(step: &Step) -> Self {
        let (shift, rotate) = match step.change {
            Change::Shift(by) => (Some(by.into()), None),
            Change::Rotate(angle) => (None, Some(angle)),
        };
        Self {
            shift,
            rotate,
            program: step.program.clone(),
            version: step.version.clone(),
        }
    }
}

impl FileStep {
    /// The step; `None` unless it is exactly one change.
    fn step(&self) -> Option<Step> {
        let change = match (self.shift, self.rotate) {
            (Some(by), None) => Change::Shift(Vector2::from(by)),
            (None, Some(angle)) => Change::Rotate(angle),
            _ => return None,
        };
        Some(Step {
            change,
            program: self.program.clone(),
            version: self.version.clone(),
        })
    }
}

pub(crate) fn rows(matrix: &Matrix6<f64>) -> [[f64; 6]; 6] {
    std::array::from_fn(|i| std::array::from_fn(|j| matrix[(i, j)]))
}

pub(crate) fn matrix6(rows: &[[f64; 6]; 6]) -> Matrix6<f64> {
    Matrix6::from_fn(|i, j| rows[i][j])
}

fn lists(matrix: &DMatrix<f64>) -> Vec<Vec<f64>> {
    matrix
        .row_iter()
        .map(|row| row.iter().copied().collect())
        .collect()
}

fn matrix_of(rows: &[Vec<f64>]) -> Option<DMatrix<f64>> {
    let columns = rows.first().map_or(0, Vec::len);
    let even = rows.iter().all(|row| row.len() == columns);
    even.then(|| DMatrix::from_fn(rows.len(), columns, |i, j| rows[i][j]))
}
