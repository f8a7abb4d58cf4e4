//! Rigid motions of the section, and the identities that every correct set of section
//! matrices satisfies.
//!
//! ```text
//! H = [I, -t x] at each node (n x 6)          T = [k x, l x; 0, k x]            (S-14)
//! M H = L     C' H = R     C H = L T     E H = R T     L' H = A     R' H = A T  (S-15)
//! theta' = T' theta:  for a straight beam M2' = F3,  M3' = -F2                  (S-13)
//! ```
//!
//! T is the matrix of the line, [`crate::element::Line::equilibrium`].
//!
//! The identities hold to round-off because the shape functions contain the rigid motions
//! exactly: a violation means that strains, forces and matrices are inconsistent.

use super::domain::Domain;
use super::forces::{Rate, State};
use super::matrices::SectionMatrices;
use super::model::Model;
use super::scaling::largest;
use super::stress::section_forces;
use crate::element::rigid_displacement;
use nalgebra::{DMatrix, DVector, Matrix6, Vector6};
use sprs::CsMatI;

/// The identities between assembled matrices only, in the order of
/// [`check_assembled_identities`].
pub const ASSEMBLED_IDENTITIES: [&str; 2] = ["E H = R T", "R' H = A T"];

/// All six identities, in the order of [`check_identities`].
pub const IDENTITIES: [&str; 6] = [
    "M H = L",
    "C' H = R",
    "C H = L T",
    "E H = R T",
    "L' H = A",
    "R' H = A T",
];

/// `H z`: adds rigid motions, a column of `z` each, to the columns of `x` (n x 6).
pub fn add_rigid_motions(model: &impl Model, z: &Matrix6<f64>, x: &mut DMatrix<f64>) {
    for (node, &[y, z_position]) in model.nodes().iter().enumerate() {
        let mut rows = x.fixed_view_mut::<3, 6>(3 * node, 0);
        rows += rigid_displacement(1.0, y, z_position) * z;
    }
}

/// `H' P`: resultant of forces at the unknowns (n x 6), a column for each case.
pub fn resultant(model: &impl Model, forces: &DMatrix<f64>) -> Matrix6<f64> {
    let mut resultant = Matrix6::zeros();
    for (node, &[y, z]) in model.nodes().iter().enumerate() {
        let at_node = forces.fixed_view::<3, 6>(3 * node, 0);
        resultant += rigid_displacement(1.0, y, z).transpose() * at_node;
    }
    resultant
}

/// A rigid motion with six nonzero parts, no part a simple multiple of another: an identity
/// that is violated for any motion is violated for this one.
const GENERIC_MOTION: [f64; 6] = [1.0, -0.71, 0.43, 0.89, -0.61, 0.53];

/// Error of each of the [`ASSEMBLED_IDENTITIES`], applied to a rigid motion with all six
/// parts, relative to the largest entry of its right-hand side before T; the error of E
/// relative to the terms of its product.
pub fn check_assembled_identities(model: &impl Model, matrices: &SectionMatrices<f64>) -> [f64; 2] {
    let SectionMatrices { e, r, a, order } = matrices;
    let motion = Vector6::from(GENERIC_MOTION);
    let turned = model.line().equilibrium().transpose() * motion;
    let displacement = rigid_displacements(model, &motion);
    let (e_motion, e_scale) = symmetric_product(e, order, &displacement);
    [
        (e_motion - r * turned).amax() / e_scale,
        (r.tr_mul(&displacement) - a * turned).amax() / (a * motion).amax(),
    ]
}

/// Error of each of the [`IDENTITIES`] in all six rigid motions.
///
/// An error is relative to the largest entry of the right-hand side before T, the error of
/// E relative to the largest sum of absolute terms of its product. E, R and A are the
/// assembled matrices; M, C and L act by integration of stresses.
///
/// An analysis checks only the two of [`ASSEMBLED_IDENTITIES`]; this function also checks
/// the operators that are not assembled.
pub fn check_identities(domain: &Domain, matrices: &SectionMatrices<f64>) -> [f64; 6] {
    let SectionMatrices { e, r, a, order } = matrices;
    let t = domain.line.equilibrium().transpose();
    let (identity, still) = (Matrix6::identity(), Matrix6::zeros());
    let mut motions = DMatrix::zeros(domain.unknowns(), 6);
    add_rigid_motions(domain, &identity, &mut motions);

    let with = |rate, warping, strain| {
        let state = State {
            rate,
            warping,
            strain,
        };
        section_forces(domain, state)
    };
    let moving = with(Rate::Given(&motions), None, &still);
    let moved = with(Rate::Zero, Some(&motions), &still).face;
    let l = with(Rate::Zero, None, &identity).face;
    let l_turned = with(Rate::Zero, None, &t).face;

    let mut of_e = 0.0;
    for (motion, turned) in motions.column_iter().zip(t.column_iter()) {
        let (e_motion, scale) = symmetric_product(e, order, &motion.into_owned());
        of_e = largest(of_e, (e_motion - r * turned).amax() / scale);
    }
    let (of_l, of_r, of_a) = (l.amax(), r.amax(), a.amax());
    [
        (&moving.face - &l).amax() / of_l,
        (&moving.within - r).amax() / of_r,
        (moved - l_turned).amax() / of_l,
        of_e,
        (moving.resultant - a).amax() / of_a,
        (r.tr_mul(&motions) - a * t).amax() / of_a,
    ]
}

/// `H m`: displacement of the unknowns in one rigid motion.
fn rigid_displacements(model: &impl Model, motion: &Vector6<f64>) -> DVector<f64> {
    let mut displacement = DVector::zeros(model.unknowns());
    for (node, &[y, z]) in model.nodes().iter().enumerate() {
        displacement
            .fixed_rows_mut::<3>(3 * node)
            .copy_from(&(rigid_displacement(1.0, y, z) * motion));
    }
    displacement
}

/// Product of a symmetric matrix, given by its lower triangle in compressed columns, with
/// `x`, and the largest sum of absolute terms in it; `order` are the unknowns of its rows
/// if their order differs from `x`.
fn symmetric_product(
    lower: &CsMatI<f64, u32>,
    order: &[u32],
    x: &DVector<f64>,
) -> (DVector<f64>, f64) {
    let unknown = |row: usize| order.get(row).map_or(row, |&unknown| unknown as usize);
    let mut product = DVector::zeros(x.len());
    let mut terms = DVector::<f64>::zeros(x.len());
    for (column, entries) in lower.outer_iterator().enumerate() {
        let j = unknown(column);
        for (row, &value) in entries.iter() {
            let i = unknown(row);
            product[i] += value * x[j];
            terms[i] += (value * x[j]).abs();
            if i != j {
                product[j] += value * x[i];
                terms[j] += (value * x[i]).abs();
            }
        }
    }
    (product, terms.amax())
}
