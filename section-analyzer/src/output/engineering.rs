//! The engineering values of a section, read from its matrices at its centers.

use nalgebra::{Matrix6, Vector3};
use shared_geom::wrench;

use crate::solution::SectionSolution;

/// An engineering value: a diagonal entry of the matrices about one point.
#[derive(Debug, Clone, PartialEq)]
pub struct EngineeringValue {
    /// The usual symbol, as `GAy`.
    pub symbol: &'static str,
    /// What it is, with the point.
    pub meaning: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// With all other generalized strains zero, `K_ii` \[N, N m^2\].
    pub restrained: f64,
    /// With all other internal forces zero, `1 / C_ii` \[N, N m^2\].
    pub free: f64,
}

/// EA, EIy, EIz about the tension center; GAy, GAz, GJ about the shear center.
///
/// ```text
/// about O + d, with U(d) = [I 0; -d x I]:    K' = U(d) K U(d)^T     C' = U(-d)^T C U(-d)
/// ```
pub fn engineering_values(solution: &SectionSolution) -> [EngineeringValue; 6] {
    let tension = about(solution, solution.centers.tension);
    let shear = about(solution, solution.centers.shear);
    let value =
        |symbol, meaning, unit, (stiffness, compliance): &(Matrix6<f64>, Matrix6<f64>), i| {
            EngineeringValue {
                symbol,
                meaning,
                unit,
                restrained: stiffness[(i, i)],
                free: 1.0 / compliance[(i, i)],
            }
        };
    [
        value("EA", "extension at the tension center", "N", &tension, 0),
        value("GAy", "shear along y at the shear center", "N", &shear, 1),
        value("GAz", "shear along z at the shear center", "N", &shear, 2),
        value("GJ", "torsion about the shear center", "N m^2", &shear, 3),
        value(
            "EIy",
            "bending about y at the tension center",
            "N m^2",
            &tension,
            4,
        ),
        value(
            "EIz",
            "bending about z at the tension center",
            "N m^2",
            &tension,
            5,
        ),
    ]
}

/// Stiffness and compliance about the point (y, z).
fn about(solution: &SectionSolution, [y, z]: [f64; 2]) -> (Matrix6<f64>, Matrix6<f64>) {
    let d = Vector3::new(0.0, y, z);
    let back = wrench::shift_matrix(&-d);
    let stiffness = wrench::shift(&solution.stiffness, &d);
    (stiffness, back.transpose() * solution.compliance * back)
}
