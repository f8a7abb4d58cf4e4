//! Our own files: blade files in JSON and TOML, and property files of section-analyzer as a
//! uniform blade.

use std::path::Path;

use nalgebra::{Vector2, Vector3};

use crate::blade::{self, Blade, BladeDamping, Interpolation, Station};
use crate::error::{Diagnostics, Place};
use crate::line::{LinePoint, ReferenceLine};
use crate::section::{self, Damping, InitialCurvature, SectionProperties};

use super::problem::{ExchangeProblem, Problems};
use super::{Options, Reading, Writing};

/// A slope that is off the normal by less is that of digits.
const NORMAL: f64 = 1e-6;

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

/// Reads a blade file, or a property file as a uniform blade of the length of
/// `options`, straight or with the curvature for which its section was solved.
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
                help: "give --length METERS for a uniform blade, or several sections \
                       with their arc lengths in a NAME.blade.toml"
                    .to_owned(),
            },
        );
        return Err(problems.into_diagnostics());
    };
    uniform(&section, length, &shown)
}

/// Where in the section a line of the same beam would be normal to it: where (a, b) of
/// `g1 = l + k x t` vanish, (y, z) = (-l3, l2)/k1.
fn normal_point(initial: &InitialCurvature) -> String {
    let InitialCurvature { curvature, slope } = initial;
    let [y, z] = [-slope.z / curvature.x, slope.y / curvature.x];
    if y.is_finite() && z.is_finite() {
        format!(
            "shift the properties to the point whose line is normal to the section, \
             (y, z) = ({y:?}, {z:?}) m from here"
        )
    } else {
        "a beam without twist has no line normal to this section: solve the section that is \
         normal to the line"
            .to_owned()
    }
}

/// The blade of one section: straight, or with the curvature for which the section was
/// solved.
///
/// # Errors
/// A line that is not normal to the section, which no blade has.
fn uniform(section: &SectionProperties, length: f64, file: &str) -> Result<Reading, Diagnostics> {
    let section = &section.per_arc_length();
    let initial = section.initial_curvature;
    let initial = initial.filter(|initial| !initial.is_straight());
    let line = match &initial {
        None => ReferenceLine::straight(length),
        Some(initial) if (initial.slope - Vector3::x()).amax() <= NORMAL => {
            let root = LinePoint {
                position: Vector3::zeros(),
                twist: 0.0,
            };
            ReferenceLine::curved(root, &[(length, initial.curvature)])
        }
        Some(initial) => {
            let problem = ExchangeProblem::Other {
                what: "slope of the reference line".to_owned(),
                found: format!("{:?}", initial.slope.as_slice()),
                expected: "[1, 0, 0]: the sections of a blade are normal to its line".to_owned(),
                help: normal_point(initial),
            };
            return Err(Diagnostics::one(Place::file(file), &problem));
        }
    };
    let station = |arc_length| Station {
        arc_length,
        stiffness: section.stiffness,
        mass: section.mass,
    };
    let damping = section.damping.map(|damping| match damping {
        Damping::StiffnessProportional(time) => BladeDamping::Proportional(time),
        Damping::Viscous(matrix) => BladeDamping::Viscous(vec![matrix; 2]),
    });
    let shape = match initial {
        None => "straight",
        Some(_) => "curved and twisted as the section was solved for",
    };
    let mut remarks = vec![format!(
        "one section: the blade is {shape} and uniform, {length} m long, its line through the \
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
        line,
        reference_point: Vector2::zeros(),
        stations: vec![station(0.0), station(length)],
        interpolation: Interpolation::Linear,
        damping,
        provenance: section.provenance.clone(),
    };
    remarks.extend(blade.remarks());
    Ok(Reading::new(blade, remarks))
}

/// The blade file.
pub fn write(blade: &Blade, name: &str) -> Writing {
    Writing {
        files: vec![(format!("{name}.blade.json").into(), blade::write(blade))],
        lost: Vec::new(),
    }
}
