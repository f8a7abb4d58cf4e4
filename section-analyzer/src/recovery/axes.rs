//! Stress and strain in other axes, as tensors.
//!
//! ```text
//! sigma_m = Q' sigma Q        eps_m = Q' eps Q                 (S-34)
//! ```
//!
//! Q has the new axes as columns; shear strains are halved in the tensor. No explicit
//! transformation matrix of the six components is used.

use nalgebra::{Matrix3, Vector6};

use crate::material::MATERIAL_ORDER;

/// Index of each component of the order xx yy zz yz xz xy in the order of
/// [`strain_at`](crate::element::strain_at), yz yy zz xx xy xz.
pub(super) const USUAL_ORDER: [usize; 6] = [3, 1, 2, 0, 5, 4];

/// Stress, order 11 22 33 23 13 12, in the axes that are the columns of `q`.
pub(super) fn stress_in_axes(q: &Matrix3<f64>, stress: &Vector6<f64>) -> Vector6<f64> {
    turned(q, stress, 1.0)
}

/// Strain with engineering shears, order 11 22 33 23 13 12, in the axes that are the
/// columns of `q`.
pub(super) fn strain_in_axes(q: &Matrix3<f64>, strain: &Vector6<f64>) -> Vector6<f64> {
    turned(q, strain, 0.5)
}

/// The 3x3 tensor of six components; the last three, times `shear`, enter twice.
pub(super) fn tensor(components: &Vector6<f64>, shear: f64) -> Matrix3<f64> {
    let mut tensor = Matrix3::zeros();
    for (&(i, j), value) in MATERIAL_ORDER.iter().zip(components.iter()) {
        let value = if i == j { *value } else { shear * value };
        tensor[(i, j)] = value;
        tensor[(j, i)] = value;
    }
    tensor
}

fn turned(q: &Matrix3<f64>, components: &Vector6<f64>, shear: f64) -> Vector6<f64> {
    let tensor = q.transpose() * tensor(components, shear) * q;
    Vector6::from_fn(|row, _| {
        let (i, j) = MATERIAL_ORDER[row];
        let value = tensor[(i, j)];
        if i == j { value } else { value / shear }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::material_axes;
    use approx::assert_relative_eq;

    /// Tension along x in the axes of fibers at theta: cos^2, sin^2 and -sin cos, by the
    /// projections of the traction; round-off of a few products.
    #[test]
    fn tension_seen_from_the_fiber() {
        let q = material_axes(0.5, 0.0);
        let seen = stress_in_axes(&q, &Vector6::new(2.0, 0.0, 0.0, 0.0, 0.0, 0.0));
        let (s, c) = 0.5_f64.sin_cos();
        let expected = Vector6::new(2.0 * c * c, 2.0 * s * s, 0.0, 0.0, 0.0, -2.0 * s * c);
        assert_relative_eq!(seen, expected, epsilon = 1e-15);
    }

    /// Work is the same in all axes, which verifies the factors of the shears.
    #[test]
    fn work_does_not_depend_on_the_axes() {
        let stress = Vector6::new(1.0, -2.0, 0.5, 3.0, -1.5, 0.7);
        let strain = Vector6::new(0.3, 0.1, -0.4, 0.2, 0.9, -0.6);
        let q = material_axes(0.7, -1.9);
        let turned = stress_in_axes(&q, &stress).dot(&strain_in_axes(&q, &strain));
        assert_relative_eq!(turned, stress.dot(&strain), max_relative = 1e-14);
    }
}
