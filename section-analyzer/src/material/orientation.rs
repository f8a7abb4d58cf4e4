//! Stiffness of an oriented ply in section axes.
//!
//! ```text
//!   z ^   n   s        s  wall direction, at the plane angle alpha from y
//!     |    \ /         n  outward normal, x cross s
//!     |     *          f  fiber, at the fiber angle theta from x towards s
//!     +--------> y     g  transverse: f, g, n are right-handed
//!  (x towards the reader)
//! ```
//!
//! # Symbols
//!
//! | symbol | meaning | unit | shape |
//! | --- | --- | --- | --- |
//! | `q` | material axes in section axes: columns f, g, n | - | 3x3 |
//! | `c` | stiffness in material axes, order 11 22 33 23 13 12 | Pa | 6x6 |
//! | `d` | stiffness in section axes, order yz yy zz xx xy xz | Pa | 6x6 |
//!
//! The axes are (S-8). The fourth-order tensor is rotated (S-9),
//! `d_abcd = q_ai q_bj q_ck q_dl c_ijkl`, without an explicit transformation matrix of the
//! six components.

use nalgebra::{Matrix3, Matrix6, Vector6};

/// Tensor index pairs of the order 11 22 33 23 13 12.
pub(crate) const MATERIAL_ORDER: [(usize, usize); 6] =
    [(0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1)];

/// Tensor index pairs of the order yz yy zz xx xy xz.
pub(super) const SECTION_ORDER: [(usize, usize); 6] =
    [(1, 2), (1, 1), (2, 2), (0, 0), (0, 1), (0, 2)];

type Tensor = [[[[f64; 3]; 3]; 3]; 3];

/// Material axes in section axes: columns fiber, transverse, normal \[-\].
///
/// ```text
/// s = (0, cos alpha, sin alpha)       f =  cos theta x + sin theta s
/// n = x cross s                       g = -sin theta x + cos theta s
/// ```
///
/// Angles in radians: `fiber_angle` is theta, `plane_angle` alpha.
pub fn material_axes(fiber_angle: f64, plane_angle: f64) -> Matrix3<f64> {
    let (st, ct) = fiber_angle.sin_cos();
    let (sa, ca) = plane_angle.sin_cos();
    Matrix3::new(
        ct,
        -st,
        0.0, //
        st * ca,
        ct * ca,
        -sa, //
        st * sa,
        ct * sa,
        ca,
    )
}

/// Stiffness in section axes of a material rotated by the two angles of [`material_axes`]
/// \[Pa\].
///
/// `c` is in material axes, order 11 22 33 23 13 12; the result is in the order yz yy zz
/// xx xy xz, which separates the strains within the section's plane (first three) from
/// the strains on its face (last three). Engineering shears.
pub fn section_stiffness(c: &Matrix6<f64>, fiber_angle: f64, plane_angle: f64) -> Matrix6<f64> {
    let q = material_axes(fiber_angle, plane_angle);
    let mut tensor = tensor_of(c);
    for _ in 0..4 {
        tensor = turn_last_index_to_front(&q, &tensor);
    }

    let d = Matrix6::from_fn(|row, column| {
        let (i, j) = SECTION_ORDER[row];
        let (k, l) = SECTION_ORDER[column];
        tensor[i][j][k][l]
    });
    0.5 * (d + d.transpose())
}

/// Strain in section axes of a material rotated by the two angles of [`material_axes`]:
/// `eps = Q eps_m Q'` as a tensor \[-\].
///
/// `strain` is in material axes, order 11 22 33 23 13 12; the result is in the order
/// yz yy zz xx xy xz. Engineering shears.
pub fn section_strain(strain: &Vector6<f64>, fiber_angle: f64, plane_angle: f64) -> Vector6<f64> {
    let q = material_axes(fiber_angle, plane_angle);
    let mut tensor = Matrix3::zeros();
    for (&(i, j), value) in MATERIAL_ORDER.iter().zip(strain.iter()) {
        let value = if i == j { *value } else { 0.5 * value };
        tensor[(i, j)] = value;
        tensor[(j, i)] = value;
    }
    let tensor = q * tensor * q.transpose();
    Vector6::from_fn(|row, _| {
        let (i, j) = SECTION_ORDER[row];
        let value = tensor[(i, j)];
        if i == j { value } else { 2.0 * value }
    })
}

/// The fourth-order tensor of a stiffness in the order 11 22 33 23 13 12.
fn tensor_of(c: &Matrix6<f64>) -> Tensor {
    let mut tensor = Tensor::default();
    for (row, &(i, j)) in MATERIAL_ORDER.iter().enumerate() {
        for (column, &(k, l)) in MATERIAL_ORDER.iter().enumerate() {
            for (i, j) in [(i, j), (j, i)] {
                tensor[i][j][k][l] = c[(row, column)];
                tensor[i][j][l][k] = c[(row, column)];
            }
        }
    }
    tensor
}

/// `out_aijk = q_al in_ijkl`; applied four times it rotates every index once and restores
/// their order.
fn turn_last_index_to_front(q: &Matrix3<f64>, tensor: &Tensor) -> Tensor {
    let mut out = Tensor::default();
    for i in 0..3 {
        for j in 0..3 {
            for k in 0..3 {
                let t = tensor[i][j][k];
                for a in 0..3 {
                    out[a][i][j][k] = q[(a, 0)] * t[0] + q[(a, 1)] * t[1] + q[(a, 2)] * t[2];
                }
            }
        }
    }
    out
}

#[cfg(test)]
#[path = "orientation_tests.rs"]
mod tests;
