//! The forces of a given state of the section, by integration of its stresses.
//!
//! ```text
//! eps   = B1 u' + B0 u + Bpsi psi
//! P     = int B1' D eps dA   = M u' + C u + L psi        forces on the face
//! Q     = int B0' D eps dA   = C' u' + E u + R psi       forces within the section
//! theta = int Bpsi' D eps dA = L' u' + R' u + A psi      internal force
//! ```
//!
//! The same as products with the six matrices (S-11), but with the round-off of the
//! strain instead of that of the displacement. It matters: in a thin wall that
//! bends, the terms of the product E u are (size/thickness)^3 times their sum.

use super::domain::{Domain, DomainCell};
use crate::element::{
    CellPoint, FACE_STRAINS, NO_COLUMNS, Y_GRADIENT_STRAINS, Z_GRADIENT_STRAINS, cell_points,
    rigid_displacement, strain_at,
};
use nalgebra::{DMatrix, Matrix3x6, Matrix6};

/// A state of the section in the units of the domain, up to six cases side by
/// side.
#[derive(Debug, Clone, Copy)]
pub struct State<'a> {
    /// u': derivative of the warping along the beam, n x k; zero where `None` \[-\].
    pub rate: Option<&'a DMatrix<f64>>,
    /// u: warping, n x k; zero where `None` \[-\].
    pub warping: Option<&'a DMatrix<f64>>,
    /// psi: generalized strain; the first k columns count, the others are zero \[-\].
    pub strain: &'a Matrix6<f64>,
}

/// Forces that hold a state within the section, in the units of the domain.
#[derive(Debug, Clone)]
pub struct InternalForces {
    /// Q: at the unknowns, n x k \[-\].
    pub within: DMatrix<f64>,
    /// theta: internal force; the first k columns count \[-\].
    pub resultant: Matrix6<f64>,
}

/// Q and theta of `state`, k cases.
pub fn internal_forces(domain: &Domain, state: State<'_>, k: usize) -> InternalForces {
    let mut within = DMatrix::zeros(domain.unknowns(), k);
    let mut resultant = Matrix6::zeros();
    for cell in &domain.cells {
        let mut forces = NO_COLUMNS;
        visit_stresses(domain, cell, state, |point, _, stress| {
            let along_y = rows(stress, Y_GRADIENT_STRAINS);
            let along_z = rows(stress, Z_GRADIENT_STRAINS);
            for i in 0..point.count {
                forces[i] += point.dy[i] * along_y + point.dz[i] * along_z;
            }
            let face = rows(stress, FACE_STRAINS);
            resultant += rigid_displacement(1.0, point.y, point.z).tr_mul(&face);
        });
        domain.add_columns(cell, &forces, &mut within);
    }
    InternalForces { within, resultant }
}

/// P of `state`, k cases: forces of the stresses on the face, at the unknowns, n x k.
pub fn face_forces(domain: &Domain, state: State<'_>, k: usize) -> DMatrix<f64> {
    let mut face = DMatrix::zeros(domain.unknowns(), k);
    for cell in &domain.cells {
        let mut forces = NO_COLUMNS;
        visit_stresses(domain, cell, state, |point, _, stress| {
            let stress = rows(stress, FACE_STRAINS);
            for i in 0..point.count {
                forces[i] += point.n[i] * stress;
            }
        });
        domain.add_columns(cell, &forces, &mut face);
    }
    face
}

/// `int eps' D eps dA`: work of the stresses of each case on the strains of each.
pub fn energy(domain: &Domain, state: State<'_>) -> Matrix6<f64> {
    let mut energy = Matrix6::zeros();
    for cell in &domain.cells {
        visit_stresses(domain, cell, state, |_, strain, stress| {
            energy += strain.tr_mul(stress);
        });
    }
    0.5 * (energy + energy.transpose())
}

/// Calls `visit` at each integration point of `cell` with the strain (6 x k) and
/// the stress times the area of the point (6 x k).
fn visit_stresses(
    domain: &Domain,
    cell: &DomainCell,
    state: State<'_>,
    mut visit: impl FnMut(&CellPoint, &Matrix6<f64>, &Matrix6<f64>),
) {
    let rate = state.rate.map(|rate| domain.columns_at(cell, rate));
    let warping = state
        .warping
        .map(|warping| domain.columns_at(cell, warping));
    let law = &domain.laws[cell.law as usize];
    let places = domain.places(cell);
    for point in cell_points(cell.kind, &places[..cell.kind.node_count()]) {
        let strain = strain_at(&point, rate.as_ref(), warping.as_ref(), state.strain);
        visit(&point, &strain, &(point.area * (law * strain)));
    }
}

fn rows(stress: &Matrix6<f64>, rows: [usize; 3]) -> Matrix3x6<f64> {
    Matrix3x6::from_fn(|i, k| stress[(rows[i], k)])
}
