//! `section-analyzer shift` and `section-analyzer rotate`: transforms a property file to
//! another point or other axes.

use std::path::Path;

use shared_geom::error::Explain;
use shared_geom::files::write_text;
use shared_geom::section::{self, Change, SectionProperties};

use super::arguments::{Point, PrincipalName, RotateArguments, ShiftArguments};
use super::{Stop, Terminal, WRONG_INPUT};
use crate::output::{property_axes, property_centers};

/// Reason for which a property file cannot be changed as requested.
#[derive(Debug, thiserror::Error)]
enum ChangeProblem {
    /// A center or axes of mass are requested of a section without mass.
    #[error("section \"{name}\" has no mass, expected one for {requested}")]
    NoMass {
        name: String,
        requested: &'static str,
    },
    /// The result would overwrite its own input.
    #[error("--out names the file that is read, \"{file}\", expected another one")]
    SameFile { file: String },
    /// The shifted matrices cannot be represented.
    #[error("the changed section is not sound: {problem}")]
    Unsound { problem: section::PropertyProblem },
}

impl Explain for ChangeProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::NoMass { .. } => None,
            Self::SameFile { .. } => Some("the input is never overwritten".to_owned()),
            Self::Unsound { .. } => Some("the new point is too far from the section".to_owned()),
        }
    }
}

/// Moves the reference point.
pub(super) fn shift_file(
    arguments: &ShiftArguments,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let properties = terminal.read_properties(&arguments.file)?;
    let centers = &properties.centers;
    let by = match arguments.to {
        Point::At(by) => by,
        Point::TensionCenter => centers.tension,
        Point::ShearCenter => centers.shear,
        Point::MassCenter => {
            require_mass(&properties, "the mass center", terminal)?;
            centers.mass
        }
    };
    let files = (arguments.file.as_path(), arguments.out.as_path());
    write_changed(&properties, Change::Shift(by), files, terminal)
}

/// Turns the axes.
pub(super) fn rotate_file(
    arguments: &RotateArguments,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let properties = terminal.read_properties(&arguments.file)?;
    let axes = &properties.principal_axes;
    let angle = match arguments.turn.to_principal {
        // One of the two exists: the command line requires it.
        None => arguments.turn.angle.unwrap_or(0.0),
        Some(PrincipalName::Bending) => axes.bending_angle,
        Some(PrincipalName::Inertia) => {
            require_mass(&properties, "the principal axes of inertia", terminal)?;
            axes.inertia_angle
        }
    };
    let files = (arguments.file.as_path(), arguments.out.as_path());
    write_changed(&properties, Change::Rotate(angle), files, terminal)
}

fn require_mass(
    properties: &SectionProperties,
    requested: &'static str,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    if properties.mass[(0, 0)] > 0.0 {
        return Ok(());
    }
    let name = properties.name.clone();
    Err(terminal.report(&ChangeProblem::NoMass { name, requested }, WRONG_INPUT))
}

/// Writes the section after `change` from the first into the second of `files`.
fn write_changed(
    properties: &SectionProperties,
    change: Change,
    (file, out): (&Path, &Path),
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    if is_same(file, out) {
        let file = file.display().to_string();
        return Err(terminal.report(&ChangeProblem::SameFile { file }, WRONG_INPUT));
    }
    let (program, version) = (env!("CARGO_PKG_NAME"), env!("CARGO_PKG_VERSION"));
    let changed = properties.changed(change, program, version);
    if let Some(problem) = changed.problems().into_iter().next() {
        return Err(terminal.report(&ChangeProblem::Unsound { problem }, WRONG_INPUT));
    }
    write_text(out, &section::write(&changed))
        .map_err(|problem| terminal.report(&problem, WRONG_INPUT))?;
    let name = &properties.name;
    let (centers, axes) = (property_centers(&changed), property_axes(&changed));
    writeln!(
        terminal.out,
        "Section \"{name}\": {change}\n\n{centers}\n{axes}"
    )?;
    writeln!(terminal.out, "Written\n  {}", out.display())?;
    Ok(())
}

/// Whether two names lead to one existing file.
fn is_same(a: &Path, b: &Path) -> bool {
    match (a.canonicalize(), b.canonicalize()) {
        (Ok(a), Ok(b)) => a == b,
        _ => false,
    }
}
