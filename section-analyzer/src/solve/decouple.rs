//! Central solutions with the rigid part of the warping removed.
//!
//! `(u, psi) -> (u + H r, psi - r' - T r)` leaves all strains as they are (S-16), so the
//! split between warping and generalized strain is a choice. The choice that
//! makes the generalized strain work with the internal force alone is the
//! warping on which the nodal forces of the section do no work (S-25):
//!
//! ```text
//! Ph = M X T' + C X + L Y        nodal forces of the face, H' Ph = I
//! Z  = -Ph' X      Xd = X + H Z      Yd = Y - (Z T' + T Z)
//! Ph' Xd = 0       Yd = compliance, symmetric
//! ```
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
    /// `H' Ph`: internal force of the solutions, the unit matrix up to round-off
    /// \[-\].
    pub internal_force: Matrix6<f64>,
    /// How far off a single solution with the factored systems is, relative to it, as
    /// the corrections of the central solutions found \[-\].
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
        let z: Matrix6<f64> = (-face.tr_mul(&x)).fixed_view::<6, 6>(0, 0).into();
        let tt = model.line().equilibrium();
        add_rigid_motions(model, &z, &mut x);
        Self {
            x,
            y: y - (z * tt + tt.transpose() * z),
            internal_force: resultant(model, &face),
            face,
            first_correction,
        }
    }
}
