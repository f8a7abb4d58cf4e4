//! The gradient of the displacement of a section point in a uniform state, and its
//! second-order strain.
//!
//! # Symbols
//!
//! | symbol | meaning | unit | shape |
//! | --- | --- | --- | --- |
//! | `R`, `r` | axes and reference point of the deformed section | -, m | 3x3, 3 |
//! | `t`, `w` | position in the section, (0, y, z), and warping | m | 3 |
//! | `nu`, `kappa` | generalized strain, [nu; kappa] = psi | -, 1/m | 3, 3 |
//! | `H` | displacement gradient in the axes of the section | - | 3x3 |
//!
//! ```text
//! s = r + R (t + w)      R' grad s = I + H + [kappa x w, 0, 0]
//! H = [nu + kappa x t,  w,y ,  w,z]                                        (S-81)
//! Green:  eps2 = 1/2 H'H + sym([kappa x w, 0, 0])
//! Biot:   eps2 = 1/2 (H'H - (sym H)^2) + sym([kappa x w, 0, 0])            (S-82)
//! ```
//!
//! H has no rotation of the section, which is in R: the remaining rotations are local, e.g.
//! of the fibers of a twisted bar about its axis.

use super::point::CellPoint;
use super::strain::rigid_displacement;
use nalgebra::{Matrix3, Vector3, Vector6};
use shared_geom::section::StrainMeasure;

/// A uniform state of a section at a point, as required for its second-order strain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointGradient {
    /// H: columns are derivatives along x, y, z \[-\].
    pub gradient: Matrix3<f64>,
    /// Twist and curvature \[1/m\].
    pub curvature: Vector3<f64>,
    /// Warping \[m\].
    pub warping: Vector3<f64>,
}

impl PointGradient {
    /// The state at `point` of a cell whose nodes warp by `warping`, under the
    /// generalized strain `psi`.
    ///
    /// As in [`super::strain_at`], derivatives are taken of differences from the first
    /// node.
    pub fn at(point: &CellPoint, psi: &Vector6<f64>, warping: &[Vector3<f64>; 9]) -> Self {
        let (mut along_y, mut along_z) = (Vector3::zeros(), Vector3::zeros());
        let mut value = warping[0];
        for i in 1..point.count {
            let difference = warping[i] - warping[0];
            along_y += point.dy[i] * difference;
            along_z += point.dz[i] * difference;
            value += point.n[i] * difference;
        }
        let face = rigid_displacement(1.0, point.y, point.z) * psi;
        Self {
            gradient: Matrix3::from_columns(&[face, along_y, along_z]),
            curvature: psi.fixed_rows::<3>(3).into_owned(),
            warping: value,
        }
    }

    /// `sym H`, the linear strain, order yz yy zz xx xy xz, engineering shears \[-\].
    pub fn strain(&self) -> Vector6<f64> {
        engineering(&self.gradient)
    }

    /// The second-order strain of this state and another: bilinear and symmetric, and
    /// `eps2` of (S-82) for a state with itself; order yz yy zz xx xy xz \[-\].
    pub fn second_order(&self, other: &Self, measure: StrainMeasure) -> Vector6<f64> {
        let (h, g) = (&self.gradient, &other.gradient);
        let mut twice = h.transpose() * g;
        if measure == StrainMeasure::Biot {
            twice -= symmetric(h) * symmetric(g);
        }
        let carried =
            0.5 * (self.curvature.cross(&other.warping) + other.curvature.cross(&self.warping));
        let mut tensor = 0.5 * twice;
        tensor.set_column(0, &(tensor.column(0) + carried));
        engineering(&tensor)
    }
}

fn symmetric(a: &Matrix3<f64>) -> Matrix3<f64> {
    0.5 * (a + a.transpose())
}

/// The symmetric part of a tensor, shears doubled, order yz yy zz xx xy xz.
fn engineering(a: &Matrix3<f64>) -> Vector6<f64> {
    Vector6::new(
        a[(1, 2)] + a[(2, 1)],
        a[(1, 1)],
        a[(2, 2)],
        a[(0, 0)],
        a[(0, 1)] + a[(1, 0)],
        a[(0, 2)] + a[(2, 0)],
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::{Line, NO_COLUMNS, strain_at};
    use approx::assert_relative_eq;
    use nalgebra::Matrix6;
    use shared_geom::mesh::CellKind;
    use shared_geom::rotation::vector;

    /// A triangle with numbers of no pattern at its nodes.
    fn state(scale: f64) -> (CellPoint, Vector6<f64>, [Vector3<f64>; 9]) {
        let nodes = [[0.1, -0.2], [1.3, 0.1], [0.3, 0.9]];
        let point = CellPoint::at(CellKind::Triangle3, &nodes, 0.2, 0.3, 1.0);
        let psi = scale * Vector6::new(0.3, -0.2, 0.4, 0.7, -0.5, 0.6);
        let mut warping = [Vector3::zeros(); 9];
        for (i, at_node) in warping.iter_mut().take(3).enumerate() {
            let i = i as f64;
            *at_node = scale * Vector3::new(0.3 - i, 0.5 * i * i - 0.2, 0.4 * i - 0.1);
        }
        (point, psi, warping)
    }

    #[test]
    fn linear_strain_is_that_of_the_section() {
        let (point, psi, warping) = state(1.0);
        let mut columns = NO_COLUMNS;
        for (column, at_node) in columns.iter_mut().zip(&warping) {
            column.set_column(0, at_node);
        }
        let mut all = Matrix6::zeros();
        all.set_column(0, &psi);
        let expected = strain_at(&Line::STRAIGHT, &point, None, Some(&columns), &all);
        let found = PointGradient::at(&point, &psi, &warping).strain();
        assert_relative_eq!(found, expected.column(0).into_owned(), epsilon = 1e-15);
    }

    /// Both measures against the strains of the exact gradient `F = R' grad s`,
    /// `1/2 (F'F - I)` and `sqrt(F'F) - I`: the difference is of third order, 1e-9 for
    /// displacements of 1e-3, compared with second-order strains of 1e-6.
    #[test]
    fn second_order_strains_are_those_of_the_exact_deformation() {
        let (point, psi, warping) = state(1e-3);
        let at = PointGradient::at(&point, &psi, &warping);
        let mut f = Matrix3::identity() + at.gradient;
        f.set_column(0, &(f.column(0) + at.curvature.cross(&at.warping)));
        // the strain does not depend on a rotation
        let f = vector::to_rotation(&Vector3::new(0.3, 0.2, -0.5)) * f;
        let square = f.transpose() * f;
        let root = square.symmetric_eigen();
        let stretch = root.eigenvectors
            * Matrix3::from_diagonal(&root.eigenvalues.map(f64::sqrt))
            * root.eigenvectors.transpose();
        let identity = Matrix3::identity();
        for (measure, exact) in [
            (StrainMeasure::Green, 0.5 * (square - identity)),
            (StrainMeasure::Biot, stretch - identity),
        ] {
            let second = engineering(&exact) - at.strain();
            let found = at.second_order(&at, measure);
            assert!(second.amax() > 1e-7, "{measure:?}");
            assert!(
                (found - second).amax() < 5e-9,
                "{measure:?}: {found} {second}"
            );
        }
    }
}
