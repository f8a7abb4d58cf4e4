//! Parts common to the reports of an analysis and of a property file.

use nalgebra::Matrix6;
use shared_geom::wrench::COMPONENTS;

use super::engineering::EngineeringValue;
use super::text::{coordinate, number, table};
use crate::properties::{Centers, PrincipalAxes};

/// Couplings below this fraction of `sqrt(Kii Kjj)` are not listed.
const COUPLING: f64 = 1e-6;

/// The parts that are not empty, separated by empty lines; a part in parentheses
/// follows the previous part directly.
pub(super) fn joined(parts: &[String]) -> String {
    let mut text = String::new();
    for part in parts.iter().filter(|part| !part.is_empty()) {
        if !text.is_empty() && !part.starts_with("  (") {
            text.push('\n');
        }
        text += part;
    }
    text
}

/// The engineering values.
pub(super) fn engineering(values: &[EngineeringValue]) -> String {
    let heading = ["", "", "others restrained", "others free", ""];
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    for value in values {
        rows.push(vec![
            value.symbol.to_owned(),
            value.meaning.to_owned(),
            number(value.restrained),
            number(value.free),
            value.unit.to_owned(),
        ]);
    }
    format!(
        "Engineering values\n  (restrained: other generalized strains zero, Kii; \
         free: other internal forces zero, 1/Cii)\n{}",
        table(&rows, "llrrl")
    )
}

/// The centers; coordinates that are round-off compared with `scale`, the size of the
/// section \[m\], are shown as zero.
pub(super) fn centers(scale: f64, centers: &Centers) -> String {
    let mut rows = vec![["center", "y", "z", ""].map(str::to_owned).to_vec()];
    let mut add = |name: &str, [y, z]: [f64; 2], meaning: &str| {
        rows.push(vec![
            name.to_owned(),
            coordinate(y, scale),
            coordinate(z, scale),
            meaning.to_owned(),
        ]);
    };
    add(
        "tension",
        centers.tension,
        "an axial force here causes no bending",
    );
    add("shear", centers.shear, "a shear force here causes no twist");
    match centers.mass {
        Some(mass) => add("mass", mass, "center of mass"),
        None => add("mass", [0.0; 2], "the section has no mass"),
    }
    format!(
        "Centers, from the reference point [m]\n{}",
        table(&rows, "lrrl")
    )
}

/// The principal axes; axes of inertia are omitted without mass.
pub(super) fn principal_axes(bending: &PrincipalAxes, inertia: Option<&PrincipalAxes>) -> String {
    // Rounded first: a tiny negative angle is shown as zero, not as -0.0000.
    let degrees = |angle: f64| format!("{:.4}", (angle.to_degrees() * 1e4).round() / 1e4 + 0.0);
    let heading = [
        "axes",
        "angle [deg]",
        "about the first",
        "about the second",
        "",
    ];
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    let mut add = |name: &str, axes: &PrincipalAxes, unit: &str| {
        rows.push(vec![
            name.to_owned(),
            degrees(axes.angle),
            number(axes.first),
            number(axes.second),
            unit.to_owned(),
        ]);
    };
    add("bending, at the tension center", bending, "N m^2");
    if let Some(inertia) = inertia {
        add("inertia, at the mass center", inertia, "kg m");
    }
    format!(
        "Principal axes (angle from +y to the first axis, positive about +x)\n{}",
        table(&rows, "lrrrl")
    )
}

/// The couplings of the stiffness above round-off.
pub(super) fn couplings(stiffness: &Matrix6<f64>) -> String {
    let mut rows = Vec::new();
    for i in 0..6 {
        for j in i + 1..6 {
            let scale = (stiffness[(i, i)] * stiffness[(j, j)]).sqrt();
            let relative = stiffness[(i, j)] / scale;
            if relative.abs() > COUPLING {
                rows.push(vec![
                    format!("{}-{}", coupling_name(i), coupling_name(j)),
                    format!("K{}{}", i + 1, j + 1),
                    format!("{relative:+.6}"),
                    number(stiffness[(i, j)]),
                ]);
            }
        }
    }
    let list = if rows.is_empty() {
        "  none above 1e-6\n".to_owned()
    } else {
        table(&rows, "llr")
    };
    format!("Couplings about the reference point, Kij / sqrt(Kii Kjj) and Kij\n{list}")
}

/// `extension` where the component is called axial.
fn coupling_name(component: usize) -> &'static str {
    match component {
        0 => "extension",
        other => COMPONENTS[other],
    }
}
