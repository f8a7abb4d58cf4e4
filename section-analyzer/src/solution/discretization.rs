//! Estimate of the discretization error of the stiffness.

use nalgebra::Matrix6;

/// Estimated error of the stiffness by the size and the kind of the cells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DiscretizationError {
    /// Computed stiffness minus the estimate of its limit on ever smaller cells of the same
    /// outline, about the reference point, 6x6 symmetric \[N, N m, N m^2\].
    pub stiffness: Matrix6<f64>,
    /// Unknowns of the second analysis.
    pub unknowns: usize,
}

impl DiscretizationError {
    /// Couplings up to this fraction of `sqrt(Kii Kjj)` count as zero: their error is
    /// relative to this root \[-\].
    pub const WEAK: f64 = 1e-3;

    /// Whether the error of entry (i, j) of `stiffness` is relative to the entry itself; if
    /// not, it is relative to `sqrt(Kii Kjj)`.
    pub fn is_of_entry(stiffness: &Matrix6<f64>, (i, j): (usize, usize)) -> bool {
        let scale = (stiffness[(i, i)] * stiffness[(j, j)]).sqrt();
        stiffness[(i, j)].abs() > Self::WEAK * scale
    }

    /// Sizes of the errors of `stiffness`, each relative to its entry, for weak couplings to
    /// `sqrt(Kii Kjj)` \[-\].
    pub fn relative(&self, stiffness: &Matrix6<f64>) -> Matrix6<f64> {
        Matrix6::from_fn(|i, j| {
            let scale = if Self::is_of_entry(stiffness, (i, j)) {
                stiffness[(i, j)].abs()
            } else {
                (stiffness[(i, i)] * stiffness[(j, j)]).sqrt()
            };
            self.stiffness[(i, j)].abs() / scale
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_of_weak_couplings_are_relative_to_the_diagonal() {
        let mut stiffness = Matrix6::from_diagonal_element(4.0);
        stiffness[(0, 1)] = -1.0;
        stiffness[(0, 2)] = 0.002;
        let error = DiscretizationError {
            stiffness: Matrix6::from_element(-0.01),
            unknowns: 1,
        };
        let relative = error.relative(&stiffness);
        assert_eq!(relative[(0, 0)], 0.0025);
        assert_eq!(relative[(0, 1)], 0.01);
        assert_eq!(relative[(0, 2)], 0.0025);
    }
}
