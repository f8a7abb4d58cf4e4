//! The equilibrium of a section, factored once (S-22).
//!
//! The unknowns are warping x and generalized strain y that balance given forces P' and
//! theta when the warping has the given rate u' along the beam:
//!
//! ```text
//! C' u' + E x + R y = P'         S = A - R^H E_ff^-1 R      (6x6)
//! L' u' + R' x + A y = theta     S dy = dtheta - R^H E_ff^-1 dQ
//!                                dx = E_ff^-1 (dQ - R dy)
//! ```
//!
//! For solutions that vary along the beam as `exp(lambda x)`, lambda imaginary, E and R are
//! formed with `B0 + lambda B1` (S-73), Hermitian instead of symmetric.
//!
//! | symbol | meaning | shape |
//! | --- | --- | --- |
//! | `x` | warping of the unknowns | n x k |
//! | `y` | generalized strain | 6 x k |
//! | `dq`, `dtheta` | imbalance of the state | n x k, 6 x k |
//! | `z` | `E_ff^-1 [R, b]`, b a uniform load | n x 7 |
//!
//! The six rows of pinned unknowns are dropped: consistent forces satisfy them
//! nevertheless, up to the sum of the round-off of all other rows.
//!
//! # References
//! - W. W. Hager, *Condition estimates*, SIAM J. Sci. Stat. Comput. 5 (1984) 311-316.

use super::factor::{Entry, Factor, FactorError};
use super::pins::Pins;
use crate::assembly::{Pattern, SectionMatrices};
use nalgebra::{Cholesky, DMatrix, DMatrixViewMut, Matrix6, Matrix6xX, U6};

/// The factored equilibrium.
#[derive(Debug)]
pub struct CentralSystem<T: Entry> {
    factor: Factor<T>,
    r: DMatrix<T>,
    z: DMatrix<T>,
    schur: Cholesky<T, U6>,
    condition: f64,
}

impl<T: Entry> CentralSystem<T> {
    /// Factors the system of `matrices`, with `pins` held.
    ///
    /// # Errors
    /// [`FactorError`] when E is not positive definite with the pins held, or
    /// the Schur complement is not.
    pub fn new(
        pattern: &Pattern,
        matrices: SectionMatrices<T>,
        pins: Pins,
    ) -> Result<Self, FactorError> {
        let SectionMatrices { e, r, a, .. } = matrices;
        let factor = Factor::new(e, pattern, pins)?;
        // R, and a uniform load for the condition number in the same pass
        let n = r.nrows();
        let mut z = DMatrix::from_element(n, 7, T::from_real(1.0 / n as f64));
        z.columns_mut(0, 6).copy_from(&r);
        factor
            .solve(z.as_mut_slice())
            .ok_or(FactorError::OutOfMemory)?;
        let condition = factor.norm() * z.column(6).lp_norm(1);

        let rz: Matrix6<T> = r.ad_mul(&z.columns(0, 6)).fixed_view::<6, 6>(0, 0).into();
        let schur = a.map(T::from_real) - (rz + rz.adjoint()).map(|entry| entry.scale(0.5));
        Ok(Self {
            condition,
            schur: Cholesky::new(schur).ok_or(FactorError::NoStiffness)?,
            r,
            z,
            factor,
        })
    }

    /// The states (x, y) that balance only the internal forces `theta` (6 x k): no rate and
    /// no P', so that `x = -Z y` needs no solution with E.
    pub fn balance_of(&self, theta: &Matrix6xX<T>) -> (DMatrix<T>, Matrix6xX<T>) {
        let y = self.schur.solve(theta);
        let mut x = DMatrix::zeros(self.r.nrows(), theta.ncols());
        x.gemm(-T::one(), &self.z.columns(0, 6), &y, T::zero());
        (x, y)
    }

    /// Replaces missing forces `dq` (n x k, column by column) and `dtheta` (6 x k) by the
    /// changes of state that balance them; `None` if memory is insufficient.
    ///
    /// `S dy = dtheta - R^H E_ff^-1 dQ`, `dx = E_ff^-1 dQ - Z dy`.
    pub fn correct(&self, dq: &mut [T], dtheta: &mut Matrix6xX<T>) -> Option<()> {
        self.factor.solve(dq)?;
        let (n, k) = (self.r.nrows(), dtheta.ncols());
        let mut dx = DMatrixViewMut::from_slice(dq, n, k);
        *dtheta = self.schur.solve(&(&*dtheta - self.r.ad_mul(&dx)));
        dx.gemm(-T::one(), &self.z.columns(0, 6), dtheta, T::one());
        Some(())
    }

    /// The factorization of E.
    pub fn factor(&self) -> &Factor<T> {
        &self.factor
    }

    /// Estimate, from below, of the condition number of E in the 1-norm \[-\]:
    /// `|E| |E^-1 b|` for the uniform load b of unit norm, the start of Hager's iteration.
    /// The load has a resultant, which the pins carry: it moves the section as far as real
    /// loads.
    pub fn condition(&self) -> f64 {
        self.condition
    }
}
