//! Elastic and electric law of an oriented material together, in section axes.
//!
//! ```text
//! [ sigma ]   [ c   e'   ] [ eps ]
//! [  D    ] = [ e  -epsS ] [  g  ]        g = grad V = -E                         (S-162)
//! ```
//!
//! sigma and eps in the order yz yy zz xx xy xz, D and g in the order y z x: the
//! derivatives of the potential within the section come before its derivative along the
//! beam. c rotates as a fourth-order tensor, e as a third-order one, epsS as a
//! second-order one (S-9).
//!
//! # References
//! - [Masarati], section 9.1 and appendix G: piezoelectric beam sections.

use super::electric::ElectricLaw;
use super::orientation::{MATERIAL_ORDER, SECTION_ORDER, material_axes, section_stiffness};
use nalgebra::{Matrix3x6, Matrix6, SMatrix};

/// A coupled law, order yz yy zz xx xy xz of the strains and y z x of the gradient of the
/// potential; symmetric, indefinite \[Pa, C/m^2, F/m\].
pub type CoupledLaw = SMatrix<f64, 9, 9>;

/// Axes y z x of the gradient.
const GRADIENT_ORDER: [usize; 3] = [1, 2, 0];

/// The law in section axes of a material rotated by the two angles of [`material_axes`]:
/// `c`, order 11 22 33 23 13 12 \[Pa\], and its electric law.
pub fn coupled_law(
    c: &Matrix6<f64>,
    electric: &ElectricLaw,
    fiber_angle: f64,
    plane_angle: f64,
) -> CoupledLaw {
    let q = material_axes(fiber_angle, plane_angle);
    let permittivity = q * electric.permittivity * q.transpose();
    let coupling = turned_coupling(&electric.coupling, fiber_angle, plane_angle);
    let mut law = CoupledLaw::zeros();
    let elastic = section_stiffness(c, fiber_angle, plane_angle);
    law.fixed_view_mut::<6, 6>(0, 0).copy_from(&elastic);
    for (row, &a) in GRADIENT_ORDER.iter().enumerate() {
        for column in 0..6 {
            law[(6 + row, column)] = coupling[(a, column)];
            law[(column, 6 + row)] = coupling[(a, column)];
        }
        for (column, &b) in GRADIENT_ORDER.iter().enumerate() {
            law[(6 + row, 6 + column)] = -0.5 * (permittivity[(a, b)] + permittivity[(b, a)]);
        }
    }
    law
}

/// `e_abc = q_ai q_bj q_ck e_ijk` in section axes \[C/m^2\]: rows are the axes x y z of the
/// field, columns the stresses yz yy zz xx xy xz; `e` is in material axes, columns
/// 11 22 33 23 13 12.
pub fn turned_coupling(e: &Matrix3x6<f64>, fiber_angle: f64, plane_angle: f64) -> Matrix3x6<f64> {
    let q = material_axes(fiber_angle, plane_angle);
    let along_field = q * e;
    Matrix3x6::from_fn(|a, column| {
        let (b, c) = SECTION_ORDER[column];
        let terms = MATERIAL_ORDER.iter().enumerate().map(|(entry, &(j, k))| {
            let turn = if j == k {
                q[(b, j)] * q[(c, k)]
            } else {
                q[(b, j)] * q[(c, k)] + q[(b, k)] * q[(c, j)]
            };
            along_field[(a, entry)] * turn
        });
        terms.sum()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::section::samples::Random;
    use nalgebra::{Matrix3, Vector3, Vector6};

    /// The law does not depend on its axes: stress and electric displacement from random
    /// strain and field, rotated as tensors, equal the results of the rotated law.
    /// Tolerance: round-off of numbers of order one.
    #[test]
    fn laws_turn_with_their_tensors() {
        let mut random = Random(11);
        let half = Matrix6::from_fn(|_, _| random.next());
        let c = half * half.transpose();
        let electric = ElectricLaw {
            coupling: Matrix3x6::from_fn(|_, _| random.next()),
            permittivity: {
                let half = Matrix3::from_fn(|_, _| random.next());
                half * half.transpose()
            },
        };
        let strain = Vector6::from_fn(|_, _| random.next());
        let field = Vector3::from_fn(|_, _| random.next());
        let stress = c * strain - electric.coupling.transpose() * field;
        let displacement = electric.coupling * strain + electric.permittivity * field;

        let (fiber, plane) = (0.7, -0.4);
        let q = material_axes(fiber, plane);
        let tensor = |v: &Vector6<f64>, shear: f64| {
            let mut tensor = Matrix3::zeros();
            for (&(i, j), value) in MATERIAL_ORDER.iter().zip(v.iter()) {
                let value = if i == j { *value } else { shear * value };
                tensor[(i, j)] = value;
                tensor[(j, i)] = value;
            }
            q * tensor * q.transpose()
        };
        let in_section = |tensor: &Matrix3<f64>, shear: f64| {
            Vector6::from_fn(|row, _| {
                let (i, j) = SECTION_ORDER[row];
                if i == j {
                    tensor[(i, j)]
                } else {
                    shear * tensor[(i, j)]
                }
            })
        };
        let law = coupled_law(&c, &electric, fiber, plane);
        let turned = |v: &Vector3<f64>| {
            let v = q * v;
            Vector3::new(v.y, v.z, v.x)
        };
        let mut state = SMatrix::<f64, 9, 1>::zeros();
        state
            .fixed_rows_mut::<6>(0)
            .copy_from(&in_section(&tensor(&strain, 0.5), 2.0));
        state.fixed_rows_mut::<3>(6).copy_from(&-turned(&field));
        let found = law * state;
        let expected = in_section(&tensor(&stress, 1.0), 1.0);
        assert!((found.fixed_rows::<6>(0) - expected).amax() < 1e-13);
        assert!((found.fixed_rows::<3>(6) - turned(&displacement)).amax() < 1e-13);
        assert_eq!(law, law.transpose());
    }
}
