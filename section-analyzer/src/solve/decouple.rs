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

use super::central::{CentralSolution, warping_rate};
use crate::assembly::{Domain, State, equilibrium, face_forces};
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
    /// `H' Ph`: internal force of the solutions, the unit matrix up to round-off
    /// \[-\].
    pub internal_force: Matrix6<f64>,
}

impl Decoupled {
    /// Decouples `central`; `h` are the rigid modes.
    pub fn new(domain: &Domain, h: &DMatrix<f64>, central: &CentralSolution) -> Self {
        let CentralSolution { x, y, .. } = central;
        let state = State {
            rate: Some(&warping_rate(x)),
            warping: Some(x),
            strain: y,
        };
        let forces = face_forces(domain, state, 6);
        let z: Matrix6<f64> = (-forces.tr_mul(x)).fixed_view::<6, 6>(0, 0).into();
        let tt = equilibrium();
        let mut decoupled = x.clone();
        decoupled += h * z;
        Self {
            x: decoupled,
            y: y - (z * tt + tt.transpose() * z),
            internal_force: h.tr_mul(&forces).fixed_view::<6, 6>(0, 0).into(),
        }
    }
}
