//! Central solutions with the rigid part of the warping removed.
//!
//! `(u, psi) -> (u + H r, psi - r' - T r)` does not change the strains (S-16), so the split
//! between warping and generalized strain is a choice. The generalized strain is
//! work-conjugate to the internal force alone if the nodal forces of the section do no work
//! on the warping (S-25):
//!
//! ```text
//! Ph = M X T' + C X + L Y        nodal forces of the face, H' Ph = I
//! Z  = -Ph' X      Xd = X + H Z      Yd = Y - (Z T' + T Z)
//! Ph' Xd = 0       Yd = compliance, symmetric
//! ```
//!
//! On piezoelectric sections the forces do no work on the warping; the charges on the face
//! may do work on the potentials, as a common shift of all potentials must not change the
//! generalized strain. This work is an end effect, and the compliance excludes it.
//!
//! # References
//! - Masarati, *Multibody dynamics of rotorcraft*, section 5.3.6: decoupling of
//!   warping and rigid section motion.

use super::central::CentralSolution;
use crate::assembly::{Model, add_rigid_motions, resultant};
use nalgebra::{DMatrix, Matrix6};

/// Decoupled central solutions.
#[derive(Debug, Clone)]
pub struct Decoupled {
    /// Xd: warping of the unknowns per unit internal force, n x 6, in the units of
    /// the domain \[-\].
    pub x: DMatrix<f64>,
    /// Yd: generalized strain per unit internal force, 6 x 6, in the units of the
    /// domain \[-\].
    pub y: Matrix6<f64>,
    /// Ph: forces on the face per unit internal force, n x 6 \[-\].
    pub face: DMatrix<f64>,
    /// Generalized strain if charges on the face also do no work on the potentials: the
    /// compliance, symmetric; without potentials equal to `y` \[-\].
    pub of_work: Matrix6<f64>,
    /// `H' Ph`: internal force of the solutions, the unit matrix up to round-off
    /// \[-\].
    pub internal_force: Matrix6<f64>,
    /// Relative error of a single solution with the factored systems, from the corrections
    /// of the central solutions \[-\].
    pub first_correction: f64,
}

impl Decoupled {
    /// Decouples `central`.
    pub fn new(model: &impl Model, central: CentralSolution) -> Self {
        let CentralSolution {
            mut x,
            y,
            face,
            first_correction,
            ..
        } = central;
        let tt = model.line().equilibrium();
        let less = |z: &Matrix6<f64>| y - (z * tt + tt.transpose() * z);
        let z = -work(model, &face, &x);
        let of_work = less(&(z - electric_work(model, &face, &x)));
        add_rigid_motions(model, &z, &mut x);
        Self {
            x,
            y: less(&z),
            of_work,
            internal_force: resultant(model, &face),
            face,
            first_correction,
        }
    }
}

/// `P' x`: work of forces on the face on displacements, without the work of charges on
/// potentials (each n x 6).
pub fn work(model: &impl Model, face: &DMatrix<f64>, x: &DMatrix<f64>) -> Matrix6<f64> {
    let displacements = 3 * model.nodes().len();
    let product = face
        .rows(0, displacements)
        .tr_mul(&x.rows(0, displacements));
    product.fixed_view::<6, 6>(0, 0).into_owned()
}

/// `P_V' x_V`: work of charges on the face on potentials.
pub fn electric_work(model: &impl Model, face: &DMatrix<f64>, x: &DMatrix<f64>) -> Matrix6<f64> {
    let (first, count) = (3 * model.nodes().len(), model.potentials());
    let product = face.rows(first, count).tr_mul(&x.rows(first, count));
    product.fixed_view::<6, 6>(0, 0).into_owned()
}
