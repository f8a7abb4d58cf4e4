//! Our own files: blade files in JSON and TOML, and property files of section-analyzer as a
//! uniform blade.

use std::path::Path;

use nalgebra::Vector2;

use crate::blade::{self, Blade, BladeDamping, Interpolation, Station};
use crate::error::Diagnostics;
use crate::line::ReferenceLine;
use crate::section::{self, Damping, SectionProperties};

use super::problem::{ExchangeProblem, Problems};
use super::{Options, Reading, Writing};

/// Whether `text` is such a file.
pub fn recognize(text: &str) -> bool {
    text.contains("\"helicoid blade\"") || is_section(text)
}

/// Whether a file has the ending of such a file.
pub(super) fn is_named(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let endings = [".blade.json", ".properties.json", ".toml"];
    endings.iter().any(|ending| name.ends_with(ending))
}

/// Whether `text` is a property file of one section.
pub(super) fn is_section(text: &str) -> bool {
    text.contains("\"helicoid section properties\"")
}

/// Reads a blade file, or a property file as a straight uniform blade of the length of
/// `options`.
///
/// # Errors
/// Everything that is wrong with the file; a section without a length.
pub fn read(text: &str, file: &Path, options: &Options) -> Result<Reading, Diagnostics> {
    let shown = file.display().to_string();
    if !is_section(text) {
        return blade::parse(text, &shown);
    }
    let section = section::parse(text, &shown)?;
    let Some(length) = options.length else {
        let mut problems = Problems::new(&shown);
        problems.push(
            0,
            &ExchangeProblem::Missing {
                what: "the length of the blade (a property file is one section)".to_owned(),
                help: "give --length METERS for a uniform straight blade, or several sections \
                       with their arc lengths in a NAME.blade.toml"
                    .to_owned(),
            },
        );
        return Err(problems.into_diagnostics());
    };
    Ok(uniform(&section, length))
}

/// The straight blade of one section.
fn uniform(section: &SectionProperties, length: f64) -> Reading {
    let station = |arc_length| Station {
        arc_length,
        stiffness: section.stiffness,
        mass: section.mass,
    };
    let damping = section.damping.map(|damping| match damping {
        Damping::StiffnessProportional(time) => BladeDamping::Proportional(time),
        Damping::Viscous(matrix) => BladeDamping::Viscous(vec![matrix; 2]),
    });
    let mut remarks = vec![format!(
        "one section: the blade is straight and uniform, {length} m long, its line through the \
         reference point of the section"
    )];
    if section.piezo.is_some() {
        remarks.push("the coupling with electrodes is not taken over".to_owned());
    }
    if section.prestress.is_some() {
        remarks.push("the effect of prestress on the stiffness is not taken over".to_owned());
    }
    let blade = Blade {
        name: section.name.clone(),
        line: ReferenceLine::straight(length),
        reference_point: Vector2::zeros(),
        stations: vec![station(0.0), station(length)],
        interpolation: Interpolation::Linear,
        damping,
        provenance: section.provenance.clone(),
    };
    remarks.extend(blade.remarks());
    Reading::new(blade, remarks)
}

/// The blade file.
pub fn write(blade: &Blade, name: &str) -> Writing {
    Writing {
        files: vec![(format!("{name}.blade.json").into(), blade::write(blade))],
        lost: Vec::new(),
    }
}
