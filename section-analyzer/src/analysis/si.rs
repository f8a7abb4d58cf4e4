//! Conversion from the units of the solver to SI, and from its origin to the reference
//! point.

use super::central::Central;
use crate::assembly::Scaling;
use crate::failure::Failure;
use crate::properties::{Centers, PrincipalAxes, invert_symmetric};
use crate::solution::SectionSolution;
use nalgebra::{DMatrix, Matrix6, Vector3};
use shared_geom::wrench;

/// Data that convert the solution of a section to its result.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame<'a> {
    /// The units of the solver, and its origin.
    pub scaling: &'a Scaling,
    /// For each node of the solver its index among the nodes of the result.
    pub nodes: &'a [u32],
    /// Number of nodes of the result.
    pub count: usize,
    /// Mass per length about the reference point [kg/m, kg, kg m].
    pub mass: &'a Matrix6<f64>,
}

/// The result in SI.
///
/// ```text
/// psi_i = p_i psi^_i, theta_j = f_j theta^_j:  C = diag(p) C^ diag(1/f),  K = diag(f) K^ diag(1/p)
/// at O = c - t:  K_O = U K_c U',  C_O = V' C_c V,  X_O = X_c V    with U = U(-t), V = U(t)
/// ```
pub(super) fn in_si(frame: &Frame<'_>, central: &Central) -> Result<SectionSolution, Failure> {
    let Frame { scaling, mass, .. } = *frame;
    let Central {
        decoupled,
        compliance,
        checks,
    } = central;
    let stiffness = invert_symmetric(compliance).ok_or(Failure::ComplianceNotPositive)?;
    let (p, f) = (scaling.strain(), scaling.force());
    let per_force = f.map(|unit| 1.0 / unit);
    let compliance_unit = p * per_force.transpose();
    let stiffness_unit = f * p.map(|unit| 1.0 / unit).transpose();

    let [y, z] = scaling.origin;
    let t = Vector3::new(0.0, y, z);
    let v = wrench::shift_matrix(&t);
    let about_origin = |c: &Matrix6<f64>| v.transpose() * c.component_mul(&compliance_unit) * v;

    let centroidal_mass = wrench::shift(mass, &t);
    let centers = Centers::new(
        &compliance.component_mul(&compliance_unit),
        &centroidal_mass,
    );
    let solution = SectionSolution {
        stiffness: symmetric(&wrench::shift(
            &stiffness.component_mul(&stiffness_unit),
            &-t,
        )),
        compliance: symmetric(&about_origin(compliance)),
        principal_bending: PrincipalAxes::of_bending(&compliance.component_mul(&compliance_unit)),
        principal_inertia: PrincipalAxes::of_mass(&centroidal_mass, centers.mass),
        centers: centers.placed(scaling.origin),
        mass: symmetric(mass),
        warping: warping(
            frame,
            &decoupled.x,
            &(Matrix6::from_diagonal(&per_force) * v),
        ),
        strain: about_origin(&decoupled.y),
        checks: *checks,
        unknowns: decoupled.x.nrows(),
        piezo: None,
    };
    require_sound(&solution)?;
    Ok(solution)
}

/// Warping in meters at all nodes of the result per unit of the forces that `forces`
/// converts to the forces of the solver; zero at nodes that the solver does not have.
fn warping(frame: &Frame<'_>, x: &DMatrix<f64>, forces: &Matrix6<f64>) -> DMatrix<f64> {
    let mut warping = DMatrix::zeros(3 * frame.count, 6);
    for (node, &target) in frame.nodes.iter().enumerate() {
        let at_node = frame.scaling.length * x.fixed_view::<3, 6>(3 * node, 0) * forces;
        warping
            .fixed_view_mut::<3, 6>(3 * target as usize, 0)
            .copy_from(&at_node);
    }
    warping
}

fn symmetric(matrix: &Matrix6<f64>) -> Matrix6<f64> {
    0.5 * (matrix + matrix.transpose())
}

/// Requires finite matrices and a stiffness that stores energy in SI about the reference
/// point: they may be out of range there but not in the units of the solver.
fn require_sound(solution: &SectionSolution) -> Result<(), Failure> {
    let SectionSolution {
        stiffness, mass, ..
    } = solution;
    let finite = |matrix: &Matrix6<f64>| matrix.iter().all(|value| value.is_finite());
    if !finite(stiffness) || !finite(&solution.compliance) {
        return Err(Failure::NoScale { what: "stiffness" });
    }
    if !finite(mass) {
        return Err(Failure::NoScale { what: "mass" });
    }
    let down = stiffness.diagonal().map(|value| 1.0 / value.sqrt());
    let scaled = stiffness.component_mul(&(down * down.transpose()));
    match scaled.cholesky() {
        Some(_) => Ok(()),
        None => Err(Failure::ComplianceNotPositive),
    }
}
