//! The undeformed beam of a section, in reports.

use shared_geom::section::InitialCurvature;

use super::text::{number, table};

/// Difference of the length of a slope from one below which it is a unit vector.
const UNIT: f64 = 1e-9;

/// Twist, curvature and slope, and the length to which the matrices of the section refer.
pub(super) fn undeformed_beam(initial: &InitialCurvature) -> String {
    let mut rows = vec![["", "x", "y", "z"].map(str::to_owned).to_vec()];
    let mut add = |name: &str, values: [f64; 3]| {
        let values = values.map(number);
        rows.push(std::iter::once(name.to_owned()).chain(values).collect());
    };
    let curvature = initial.curvature;
    add("twist and curvature [1/m]", curvature.into());
    add("the same [deg/m]", curvature.map(f64::to_degrees).into());
    add("slope of the reference line [-]", initial.slope.into());
    let length = initial.slope.norm();
    let per = if (length - 1.0).abs() <= UNIT {
        "per length of the reference line".to_owned()
    } else {
        format!(
            "per unit of the parameter by which the line has this slope: {} of its length",
            number(length)
        )
    };
    format!(
        "Undeformed beam, curved or twisted\n{}  stiffness and mass apply to this beam, {per}\n",
        table(&rows, "lr")
    )
}
