//! The equilibrium of a section, solved by one factorization (S-22).
//!
//! Sought are warping x and generalized strain y that balance given forces P'
//! and theta when the warping has the given rate u' along the beam:
//!
//! ```text
//! C' u' + E x + R y = P'         S = A - R' E_ff^-1 R       (6x6)
//! L' u' + R' x + A y = theta     S dy = dtheta - R' E_ff^-1 dQ
//!                                dx = E_ff^-1 (dQ - R dy)
//! ```
//!
//! | symbol | meaning | shape |
//! | --- | --- | --- |
//! | `x` | warping of the unknowns | n x k |
//! | `y` | generalized strain | 6 x k |
//! | `dq`, `dtheta` | what the state lacks of balance | n x k, 6 x k |
//! | `z` | `E_ff^-1 R` | n x 6 |
//!
//! The imbalance is that of the stresses ([`internal_forces`]), exact to the
//! round-off of the strains, and the factored matrix finds the correction; so
//! the state is accurate even where the matrix is so badly conditioned that one
//! solution keeps half of the digits only.
//!
//! The six rows of pinned unknowns are dropped: consistent forces meet them all
//! the same, up to the sum of the round-off of all other rows.

use super::factor::{Factor, FactorError};
use super::pins::Pins;
use crate::assembly::{Domain, Pattern, SectionMatrices, State, internal_forces, largest};
use nalgebra::{Cholesky, DMatrix, Matrix6, Matrix6xX, U6};

/// Corrections at most, the first of which is the solution itself. One or two
/// more are the rule, all of them the mark of a section near the limit.
const CORRECTIONS: usize = 12;

/// Largest ratio of a correction to the one before: beyond it corrections do not
/// lead anywhere, and the checks of the solution decide.
const SLOW: f64 = 0.5;

/// Size of a correction, relative to the state, after which no other is worth its
/// price: the next would be smaller by as much again, which is below round-off.
const SMALL_CORRECTION: f64 = 1e-9;

/// The factored equilibrium.
#[derive(Debug)]
pub struct CentralSystem<'a> {
    domain: &'a Domain,
    matrices: &'a SectionMatrices,
    factor: Factor,
    z: DMatrix<f64>,
    schur: Cholesky<f64, U6>,
}

/// Warping and generalized strain in balance with given forces.
#[derive(Debug, Clone)]
pub struct BalancedState {
    /// Warping, n x k, pinned unknowns zero, in the units of the domain \[-\].
    pub x: DMatrix<f64>,
    /// Generalized strain, 6 x k, in the units of the domain \[-\].
    pub y: Matrix6xX<f64>,
    /// Size of the last correction relative to the state \[-\]: how far the
    /// state was off before it.
    pub correction: f64,
}

impl<'a> CentralSystem<'a> {
    /// Factors the system of `matrices`, with `pins` held.
    ///
    /// # Errors
    /// [`FactorError`] when E is not positive definite with the pins held, or
    /// the Schur complement is not.
    pub fn new(
        domain: &'a Domain,
        pattern: &Pattern,
        matrices: &'a SectionMatrices,
        pins: Pins,
    ) -> Result<Self, FactorError> {
        let factor = Factor::new(&matrices.e, pattern, pins)?;
        let mut z = matrices.r.clone();
        factor.solve(&mut z).ok_or(FactorError::OutOfMemory)?;

        let rz: Matrix6<f64> = matrices.r.tr_mul(&z).fixed_view::<6, 6>(0, 0).into();
        let schur = matrices.a - 0.5 * (rz + rz.transpose());
        let not_positive = FactorError::NotPositive(factor.smallest_pivot());
        Ok(Self {
            domain,
            matrices,
            z,
            schur: Cholesky::new(schur).ok_or(not_positive)?,
            factor,
        })
    }

    /// The state that balances the forces `p` = P' (n x k) and `theta` (6 x k),
    /// given the rate of the warping; `None` when there is no memory for it.
    pub fn balance(
        &self,
        rate: Option<&DMatrix<f64>>,
        p: &DMatrix<f64>,
        theta: &Matrix6xX<f64>,
    ) -> Option<BalancedState> {
        let k = p.ncols();
        let mut state = BalancedState {
            x: DMatrix::zeros(p.nrows(), k),
            y: Matrix6xX::zeros(k),
            correction: f64::INFINITY,
        };
        let (mut dq, mut dtheta) = (p.clone(), theta.clone());
        if rate.is_some() {
            (dq, dtheta) = self.imbalance(rate, p, theta, &state);
        }
        for _ in 0..CORRECTIONS {
            let (dx, dy) = self.correction(dq, dtheta)?;
            state.x += &dx;
            state.y += &dy;
            let last = state.correction;
            state.correction = relative_size((&dx, &dy), (&state.x, &state.y));
            // written so that not a number ends it too
            let worth_another =
                state.correction > SMALL_CORRECTION && state.correction < SLOW * last;
            if !worth_another {
                break;
            }
            (dq, dtheta) = self.imbalance(rate, p, theta, &state);
        }
        Some(state)
    }

    /// What `state` lacks of balance: P' - Q and theta less that of the state.
    fn imbalance(
        &self,
        rate: Option<&DMatrix<f64>>,
        p: &DMatrix<f64>,
        theta: &Matrix6xX<f64>,
        state: &BalancedState,
    ) -> (DMatrix<f64>, Matrix6xX<f64>) {
        let k = p.ncols();
        let mut strain = Matrix6::zeros();
        strain.columns_mut(0, k).copy_from(&state.y);
        let of_stress = State {
            rate,
            warping: Some(&state.x),
            strain: &strain,
        };
        let forces = internal_forces(self.domain, of_stress, k);
        (p - forces.within, theta - forces.resultant.columns(0, k))
    }

    /// `S dy = dtheta - R' E_ff^-1 dQ`, `dx = E_ff^-1 dQ - Z dy`.
    fn correction(
        &self,
        mut dq: DMatrix<f64>,
        dtheta: Matrix6xX<f64>,
    ) -> Option<(DMatrix<f64>, Matrix6xX<f64>)> {
        if dq.amax() != 0.0 {
            self.factor.solve(&mut dq)?;
        }
        let dy = self.schur.solve(&(dtheta - self.matrices.r.tr_mul(&dq)));
        let dx = dq - &self.z * &dy;
        Some((dx, dy))
    }

    /// The factorization of E.
    pub fn factor(&self) -> &Factor {
        &self.factor
    }
}

/// Size of a change of state relative to the state, the largest over its k cases.
///
/// In the units of the domain a warping of 1 and a generalized strain of 1 move
/// the section alike, so the larger of the two is the size.
fn relative_size(
    (dx, dy): (&DMatrix<f64>, &Matrix6xX<f64>),
    (x, y): (&DMatrix<f64>, &Matrix6xX<f64>),
) -> f64 {
    let size = |x: &DMatrix<f64>, y: &Matrix6xX<f64>, case: usize| {
        x.column(case).amax().max(y.column(case).amax())
    };
    (0..x.ncols())
        .map(|case| size(dx, dy, case) / size(x, y, case))
        .fold(0.0, largest)
}
