//! Inverse and comparison of 6x6 matrices whose rows differ in units and size.

use crate::assembly::largest;
use nalgebra::{Cholesky, Matrix6, Vector6};

/// Inverse of a symmetric positive definite matrix whose rows may differ by many
/// orders of magnitude; `None` when it is not positive definite.
///
/// ```text
/// d_i = 1 / sqrt(c_ii)      c^-1 = diag(d) (diag(d) c diag(d))^-1 diag(d)
/// ```
pub fn invert_symmetric(c: &Matrix6<f64>) -> Option<Matrix6<f64>> {
    let d = Vector6::from_fn(|i, _| 1.0 / c[(i, i)].sqrt());
    let scale = d * d.transpose();
    let inverse = Cholesky::new(c.component_mul(&scale))?.inverse();
    let inverse = inverse.component_mul(&scale);
    let finite = inverse.iter().all(|value| value.is_finite());
    finite.then(|| 0.5 * (inverse + inverse.transpose()))
}

/// Largest `|a_ij - b_ij| rows_i columns_j`; NaN when one of them is.
pub fn scaled_difference(
    a: &Matrix6<f64>,
    b: &Matrix6<f64>,
    rows: &Vector6<f64>,
    columns: &Vector6<f64>,
) -> f64 {
    let difference = (a - b).component_mul(&(rows * columns.transpose()));
    difference
        .iter()
        .map(|value| value.abs())
        .fold(0.0, largest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Rows that differ by 1e9 lose no digits: the product with the inverse is
    /// the unit matrix after scaling back.
    #[test]
    fn inverse_of_a_badly_scaled_matrix() {
        let base = Matrix6::from_fn(|i, j| {
            if i == j {
                2.0
            } else {
                0.3 / (1 + i + j) as f64
            }
        });
        let base = 0.5 * (base + base.transpose());
        let d = Vector6::new(1.0, 1e3, 1e-3, 1e9, 1e-9, 1.0);
        let c = base.component_mul(&(d * d.transpose()));
        let inverse = invert_symmetric(&c).expect("positive definite");
        let back = inverse.component_mul(&(d * d.transpose())) * base;
        assert_relative_eq!(back, Matrix6::identity(), epsilon = 1e-14);
    }

    #[test]
    fn indefinite_matrices_have_no_inverse() {
        let mut c = Matrix6::identity();
        c[(2, 2)] = -1.0;
        assert_eq!(invert_symmetric(&c), None);
        assert_eq!(invert_symmetric(&Matrix6::zeros()), None);
    }

    #[test]
    fn scaled_difference_keeps_not_a_number() {
        let one = Matrix6::identity();
        let half = Vector6::repeat(0.5);
        assert_eq!(scaled_difference(&one, &(3.0 * one), &half, &half), 0.5);
        let mut bad = one;
        bad[(1, 2)] = f64::NAN;
        assert!(scaled_difference(&one, &bad, &half, &half).is_nan());
    }
}
