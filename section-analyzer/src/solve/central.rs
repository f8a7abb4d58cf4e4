//! The two nested central solutions (de Saint-Venant).
//!
//! An unloaded beam carries `theta' = T' theta`: shears constant, bendings
//! linear. With `u = X theta`, `psi = Y theta` (S-17) and T' nilpotent (its square is
//! zero) the equilibrium of the section (S-12), which is then (S-18), splits in two
//! steps, (S-19) and (S-20):
//!
//! ```text
//! linear    (F1, M1, M2, M3)   E x + R y = 0,                        R' x + A y = e_j
//! constant  (F2, F3)           C' u' + E x + R y = C u' + L psi',    L' u' + R' x + A y = e_j
//!                              u' = X T' e_j,  psi' = Y T' e_j  from the linear step:
//!                              T' e_F2 = -e_M3,  T' e_F3 = e_M2
//! ```
//!
//! # References
//! - Giavotto et al. 1983: central solutions.
//! - Masarati 1999, section 5.3.5.

use super::system::{BalancedState, CentralSystem};
use crate::assembly::{Domain, State, equilibrium, face_forces, largest};
use nalgebra::{DMatrix, Matrix6, Matrix6xX};

/// Internal forces whose solution is constant along the beam.
const LINEAR_STEP: [usize; 4] = [0, 3, 4, 5];

/// The shears, whose solution is linear along the beam.
const CONSTANT_STEP: [usize; 2] = [1, 2];

/// Warping and generalized strain per unit internal force, of some choice of
/// rigid motions.
#[derive(Debug, Clone)]
pub struct CentralSolution {
    /// X: warping of the unknowns, n x 6, in the units of the domain \[-\].
    pub x: DMatrix<f64>,
    /// Y: generalized strain, 6 x 6, in the units of the domain \[-\].
    pub y: Matrix6<f64>,
    /// Largest of the last corrections of the two steps, relative to the
    /// solution \[-\].
    pub correction: f64,
}

impl CentralSolution {
    /// Solves both steps; `None` when there is no memory for it.
    pub fn solve(domain: &Domain, system: &CentralSystem<'_>) -> Option<Self> {
        let n = domain.unknowns();
        let mut solution = Self {
            x: DMatrix::zeros(n, 6),
            y: Matrix6::zeros(),
            correction: 0.0,
        };

        // linear step: no rate, no change of the forces on the face
        let p = DMatrix::zeros(n, LINEAR_STEP.len());
        let theta = unit_forces(&LINEAR_STEP);
        solution.take(&LINEAR_STEP, &system.balance(None, &p, &theta)?);

        // constant step: P' = C u' + L psi' of the linear solution
        let rate = warping_rate(&solution.x).select_columns(&CONSTANT_STEP);
        let mut strain_rate = Matrix6::zeros();
        strain_rate
            .columns_mut(0, CONSTANT_STEP.len())
            .copy_from(&(solution.y * equilibrium()).select_columns(&CONSTANT_STEP));
        let changing = State {
            rate: None,
            warping: Some(&rate),
            strain: &strain_rate,
        };
        let p = face_forces(domain, changing, CONSTANT_STEP.len());
        let theta = unit_forces(&CONSTANT_STEP);
        solution.take(&CONSTANT_STEP, &system.balance(Some(&rate), &p, &theta)?);
        Some(solution)
    }

    fn take(&mut self, forces: &[usize], solved: &BalancedState) {
        for (k, &force) in forces.iter().enumerate() {
            self.x.set_column(force, &solved.x.column(k));
            self.y.set_column(force, &solved.y.column(k));
        }
        self.correction = largest(self.correction, solved.correction);
    }
}

/// `u' = X T'`, derivative of the warping along the beam per unit internal force:
/// column F2 is minus that of M3, column F3 is that of M2, the others zero.
pub fn warping_rate(x: &DMatrix<f64>) -> DMatrix<f64> {
    let mut rate = DMatrix::zeros(x.nrows(), 6);
    rate.set_column(1, &(-x.column(5)));
    rate.set_column(2, &x.column(4));
    rate
}

/// Columns e_j, 6 x k.
fn unit_forces(forces: &[usize]) -> Matrix6xX<f64> {
    let mut unit = Matrix6xX::zeros(forces.len());
    for (k, &force) in forces.iter().enumerate() {
        unit[(force, k)] = 1.0;
    }
    unit
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn warping_rate_is_the_product_with_the_equilibrium_matrix() {
        let x = DMatrix::from_fn(4, 6, |i, j| (7 * i + 3 * j) as f64 - 10.0);
        assert_eq!(warping_rate(&x), &x * equilibrium());
    }
}
