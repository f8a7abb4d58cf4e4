//! Helicoid's files: blade files in JSON and TOML, and property files of section-analyzer
//! as a uniform blade.

use std::path::Path;

use nalgebra::{Vector2, Vector3};

use crate::blade::{self, Blade, BladeDamping, Interpolation, Station};
use crate::error::{Diagnostics, SourceLocation, quoted};
use crate::line::{LinePoint, ReferenceLine};
use crate::section::{self, Damping, InitialCurvature, SectionProperties};

use super::problem::{ExchangeProblem, Problems};
use super::{Options, Reading, Writing};

/// A slope that is off the normal by less is round-off.
const NORMAL: f64 = 1e-6;

/// Whether `text` is one of these files.
pub fn recognize(text: &str) -> bool {
    text.contains("\"helicoid blade\"") || is_section(text)
}

/// Whether a file has the ending of one of these files.
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
/// All errors of the file; a section without a length.
pub fn read(text: &str, file: &Path, options: &Options) -> Result<Reading, Diagnostics> {
    let shown = file.display().to_string();
    if !is_section(text) {
        return blade::parse_with(text, &shown, options.rigid_shear);
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

/// Point of the section at which a line of the same beam is normal to it: (a, b) of
/// `g1 = l + k x t` vanish, (y, z) = (-l3, l2)/k1.
fn normal_point(initial: &InitialCurvature) -> String {
    let InitialCurvature { curvature, slope } = initial;
    // zero without a sign: -0 + 0 = 0
    let [y, z] = [-slope.z, slope.y].map(|component| component / curvature.x + 0.0);
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
/// A line that is not normal to the section, which is impossible in a blade.
fn uniform(section: &SectionProperties, length: f64, file: &str) -> Result<Reading, Diagnostics> {
    let section = &section.per_arc_length();
    let initial = section.initial_curvature;
    let initial = initial.filter(|initial| !initial.is_straight());
    let station = |arc_length| Station {
        arc_length,
        stiffness: section.stiffness,
        mass: section.mass,
    };
    let damping = section.damping.map(|damping| match damping {
        Damping::StiffnessProportional(time) => BladeDamping::Proportional(time),
        Damping::Viscous(matrix) => BladeDamping::Viscous(vec![matrix; 2]),
    });
    let blade = Blade {
        name: section.name.clone(),
        line: line_of(initial.as_ref(), length, file)?,
        reference_point: Vector2::zeros(),
        stations: vec![station(0.0), station(length)],
        interpolation: Interpolation::Linear,
        damping,
        provenance: section.provenance.clone(),
    };
    let shape = match initial {
        None => "straight",
        Some(_) => "curved and twisted as the section was solved for",
    };
    let mut remarks = vec![format!(
        "one section: the blade is {shape} and uniform, {length} m long, its line through the \
         reference point of the section"
    )];
    remarks.extend(left_behind(section));
    remarks.extend(blade.remarks());
    Ok(Reading::new(blade, remarks))
}

/// The line on which a section of this curvature was solved.
///
/// # Errors
/// A line that is not normal to the section.
fn line_of(
    initial: Option<&InitialCurvature>,
    length: f64,
    file: &str,
) -> Result<ReferenceLine, Diagnostics> {
    let Some(initial) = initial else {
        return Ok(ReferenceLine::straight(length));
    };
    if (initial.slope - Vector3::x()).amax() <= NORMAL {
        let root = LinePoint {
            position: Vector3::zeros(),
            twist: 0.0,
        };
        return Ok(ReferenceLine::curved(root, &[(length, initial.curvature)]));
    }
    let problem = ExchangeProblem::Other {
        what: "slope of the reference line".to_owned(),
        found: format!("{:?}", initial.slope.add_scalar(0.0).as_slice()),
        expected: "[1, 0, 0]: the sections of a blade are normal to its line".to_owned(),
        help: normal_point(initial),
    };
    Err(Diagnostics::one(SourceLocation::file(file), &problem))
}

/// Properties of a section that a blade does not have, as text.
fn left_behind(section: &SectionProperties) -> Vec<String> {
    let states = section.imposed.iter();
    let states: Vec<_> = states.map(|state| &state.name).collect();
    let all = [
        (section.piezo.is_some(), "the coupling with electrodes"),
        (
            section.thermal_force.is_some(),
            "the thermal force of an even rise of temperature",
        ),
        (
            section.prestress.is_some(),
            "the effect of prestress on the stiffness",
        ),
    ];
    let all = all.into_iter().filter(|(is_there, _)| *is_there);
    let mut remarks: Vec<_> = all
        .map(|(_, what)| format!("{what} is not taken over"))
        .collect();
    match states.len() {
        0 => {}
        1 => remarks.push(format!(
            "the imposed state \"{}\" is not taken over",
            states[0]
        )),
        _ => remarks.push(format!(
            "the imposed states {} are not taken over",
            quoted(&states)
        )),
    }
    remarks
}

/// The blade file. It does not name the files of the sections: their paths are from the folder of
/// the blade that it is made of.
pub fn write(blade: &Blade, name: &str) -> Writing {
    let mut blade = blade.clone();
    blade.provenance.sections.clear();
    Writing {
        files: vec![(format!("{name}.blade.json").into(), blade::write(&blade))],
        lost: Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{DMatrix, Vector6};

    use super::*;
    use crate::section::{
        Centers, CubicTable, Engineering, ImposedState, Piezo, Prestress, Provenance, StrainMeasure,
    };

    /// A twisted section whose line leaves it along y: no coordinate is `-0.0`.
    #[test]
    fn the_point_of_a_normal_line_has_no_sign_at_zero() {
        let initial = InitialCurvature {
            curvature: Vector3::new(0.5, 0.0, 0.0),
            slope: Vector3::new(1.0, 0.1, 0.0),
        };
        let shown = normal_point(&initial);
        assert!(shown.contains("(y, z) = (0.0, 0.2) m"), "{shown}");
    }

    /// A blade has stiffness, mass and damping: other properties of a section are
    /// reported, each imposed state by its name.
    #[test]
    fn what_a_blade_does_not_have_is_reported() {
        let engineering = Engineering {
            stiffness: [7e6, 2e6, 1e6, 30.0, 40.0, 900.0],
            mass: [0.3, 0.01, 0.04],
            centers: Centers {
                tension: Vector2::zeros(),
                shear: Vector2::zeros(),
                mass: Vector2::zeros(),
            },
            stiffness_angle: 0.0,
            inertia_angle: 0.0,
        };
        let mut section = engineering.section("strip", Provenance::default());
        let options = Options {
            length: Some(2.0),
            ..Options::default()
        };
        let reported = |section: &SectionProperties| {
            let text = section::write(section);
            let reading = read(&text, Path::new("strip.properties.json"), &options).unwrap();
            reading.remarks[1..].join("\n")
        };
        assert_eq!(reported(&section), "");
        let state = |name: &str| ImposedState {
            name: name.to_owned(),
            restrained_force: Vector6::zeros(),
            free_strain: Vector6::zeros(),
            stiffness_change: None,
        };
        section.imposed = vec![state("cure")];
        assert_eq!(
            reported(&section),
            "the imposed state \"cure\" is not taken over"
        );
        section.imposed.push(state("sun"));
        section.thermal_force = Some(Vector6::zeros());
        section.piezo = Some(Piezo {
            electrodes: vec!["top".to_owned()],
            coupling: DMatrix::zeros(6, 1),
            capacitance: DMatrix::from_element(1, 1, 1e-9),
        });
        section.prestress = Some(Prestress {
            strain_measure: StrainMeasure::Biot,
            third: CubicTable::from_fn(|_| 0.0),
            per_kelvin: None,
        });
        assert_eq!(
            reported(&section),
            "the coupling with electrodes is not taken over\n\
             the thermal force of an even rise of temperature is not taken over\n\
             the effect of prestress on the stiffness is not taken over\n\
             the imposed states \"cure\", \"sun\" are not taken over"
        );
    }
}
