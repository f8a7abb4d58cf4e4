//! The strain of a section point from the generalized strain, the warping, and the rate of
//! the warping along the beam.
//!
//! A point moves with the rigid section and warps on top of it (S-1); the generalized
//! strain is (S-3), the order of the strains (S-2).
//!
//! # Symbols
//!
//! | symbol | meaning | unit | shape |
//! | --- | --- | --- | --- |
//! | `t` | position in the section, (0, y, z) | m | 3 |
//! | `psi` | generalized strain: axial, shears, twist, bendings | -, 1/m | 6 |
//! | `w`, `w'` | warping and its derivative along x | m, - | 3 |
//! | `eps` | strain, order yz yy zz xx xy xz, engineering shears | - | 6 |
//!
//! ```text
//! eps = Bpsi psi + B1 u' + B0 u        w = N u                         (S-4)
//! Bpsi = S [I, -t x]      B1 = S N      B0 = Dop N      S = [0; I3]     (S-5)
//! Dop w = (uy,z + uz,y, uy,y, uz,z, 0, ux,y, ux,z)                      (S-6)
//! ```
//!
//! On a beam of initial curvature k and slope l of its line, with J, a, b of (S-71),
//!
//! ```text
//! Bpsi = S [I, -t x]/J      B1 = S N/J      B0 = S (k x N - a N,y - b N,z)/J + Dop N   (S-73)
//! ```
//!
//! S and Dop only select components, so the operators are stored as the three lists of
//! strain components below instead of as matrices of zeros and ones.
//!
//! # References
//! - Giavotto et al. 1983, section 2: the strain of a straight section.

use super::line::Line;
use super::point::CellPoint;
use nalgebra::{ArrayStorage, Matrix3x6, Matrix6};
use shared_geom::rotation::skew;

/// Strain components on the section's face, which depend on (ux', uy', uz') and on the
/// rigid strain: xx, xy, xz. The rows of S.
pub const FACE_STRAINS: [usize; 3] = [3, 4, 5];

/// Strain components that depend on the derivatives along y of (ux, uy, uz): xy, yy, yz.
pub const Y_GRADIENT_STRAINS: [usize; 3] = [4, 1, 0];

/// Strain components that depend on the derivatives along z of (ux, uy, uz): xz, yz, zz.
pub const Z_GRADIENT_STRAINS: [usize; 3] = [5, 0, 2];

/// Components of a law that depend on the C unknowns of a node, in their order: for the
/// displacements the strains above; for the potential V of dielectrics the gradients that
/// follow the strains in the order of [`crate::material::CoupledLaw`].
#[derive(Debug, Clone, Copy)]
pub struct Fed<const C: usize> {
    /// Components of the unknowns and of their rates along the beam.
    pub face: [usize; C],
    /// Components of their derivatives along y.
    pub along_y: [usize; C],
    /// Components of their derivatives along z.
    pub along_z: [usize; C],
}

impl Fed<3> {
    /// The components of ux, uy, uz.
    pub const DISPLACEMENTS: Self = Self {
        face: FACE_STRAINS,
        along_y: Y_GRADIENT_STRAINS,
        along_z: Z_GRADIENT_STRAINS,
    };
}

impl Fed<4> {
    /// The components of ux, uy, uz and V.
    pub const WITH_POTENTIAL: Self = Self {
        face: [3, 4, 5, 8],
        along_y: [4, 1, 0, 6],
        along_z: [5, 0, 2, 7],
    };
}

/// `f [I, -t x]` summed over points, given the sums of f, f y and f z.
///
/// With `f = 1` it is the displacement of the point t = (0, y, z) in the six
/// rigid motions of the section, columns translations x y z and rotations x y z.
pub fn rigid_displacement(one: f64, y: f64, z: f64) -> Matrix3x6<f64> {
    Matrix3x6::new(
        one, 0.0, 0.0, 0.0, z, -y, //
        0.0, one, 0.0, -z, 0.0, 0.0, //
        0.0, 0.0, one, y, 0.0, 0.0,
    )
}

/// Six columns of a field at the nodes of a cell; entries after its node count are not
/// read.
pub type NodalColumns = [Matrix3x6<f64>; 9];

/// No displacement at any node.
pub const NO_COLUMNS: NodalColumns =
    [Matrix3x6::from_array_storage(ArrayStorage([[0.0; 3]; 6])); 9];

/// `eps = B1 u' + B0 u + Bpsi psi` at a point of a beam along `line`, six columns at
/// once, 6x6.
///
/// Derivatives are taken of the differences from the first node, which is the same in exact
/// arithmetic (the derivatives of the shape functions add up to zero) and loses no digits
/// when the displacement of the cell is much larger than its strain, as in walls of thin
/// sections.
pub fn strain_at(
    line: &Line,
    point: &CellPoint,
    rate: Option<&NodalColumns>,
    warping: Option<&NodalColumns>,
    psi: &Matrix6<f64>,
) -> Matrix6<f64> {
    let mut along_y = Matrix3x6::zeros();
    let mut along_z = Matrix3x6::zeros();
    if let Some(warping) = warping {
        for i in 1..point.count {
            let difference = warping[i] - warping[0];
            along_y += point.dy[i] * difference;
            along_z += point.dz[i] * difference;
        }
    }
    let mut face = rigid_displacement(1.0, point.y, point.z) * psi;
    if let Some(rate) = rate {
        face += at_point(point, rate);
    }
    if !line.is_straight() {
        let metric = line.metric(point.y, point.z);
        if let Some(warping) = warping {
            face += skew(&line.curvature) * at_point(point, warping);
        }
        face -= metric.tilt[0] * along_y + metric.tilt[1] * along_z;
        face /= metric.volume;
    }
    let mut strain = Matrix6::zeros();
    for (rows, part) in [
        (FACE_STRAINS, &face),
        (Y_GRADIENT_STRAINS, &along_y),
        (Z_GRADIENT_STRAINS, &along_z),
    ] {
        for (component, row) in rows.into_iter().enumerate() {
            for column in 0..6 {
                strain[(row, column)] += part[(component, column)];
            }
        }
    }
    strain
}

/// A field at a point, from its values at the nodes of the cell.
fn at_point(point: &CellPoint, field: &NodalColumns) -> Matrix3x6<f64> {
    let nodes = field.iter().zip(&point.n).take(point.count);
    nodes.map(|(value, n)| *n * value).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use nalgebra::{Matrix3, Vector3, Vector6};
    use shared_geom::mesh::CellKind;

    /// The rigid displacement agrees with the cross product: translation + phi x t.
    #[test]
    fn rigid_displacement_is_translation_and_rotation() {
        let t = Vector3::new(0.0, 0.3, -0.7);
        let translation = Vector3::new(1.0, 2.0, 3.0);
        let rotation = Vector3::new(-0.4, 0.5, 0.6);
        let motion = Vector6::from_iterator(translation.iter().chain(&rotation).copied());
        let expected = translation + rotation.cross(&t);
        let found = rigid_displacement(1.0, t.y, t.z) * motion;
        assert_relative_eq!(found, expected, epsilon = 1e-15);
        let operator = -skew(&t);
        let rotations: Matrix3<f64> = rigid_displacement(1.0, t.y, t.z)
            .fixed_columns::<3>(3)
            .into_owned();
        assert_relative_eq!(rotations, operator, epsilon = 1e-15);
    }

    /// A triangle with corners (0, 0), (1, 0), (0, 1) at its point (y, z).
    fn triangle_at(y: f64, z: f64) -> CellPoint {
        let nodes = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        CellPoint::at(CellKind::Triangle3, &nodes, y, z, 1.0)
    }

    /// `eps_xx = nu1 + z kappa2 - y kappa3`, and a unit twist shears (-z, y).
    #[test]
    fn generalized_strain_acts_on_the_face_only() {
        let (y, z) = (0.3, 0.6);
        let mut psi = Matrix6::zeros();
        psi.set_column(2, &Vector6::new(1.0, 0.1, 0.2, 2.0, 10.0, 100.0));
        let strain = strain_at(&Line::STRAIGHT, &triangle_at(y, z), None, None, &psi);
        let expected = Vector6::new(
            0.0,
            0.0,
            0.0,
            1.0 + 10.0 * z - 100.0 * y,
            0.1 - 2.0 * z,
            0.2 + 2.0 * y,
        );
        assert_relative_eq!(strain.column(2).into_owned(), expected, epsilon = 1e-14);
        assert_eq!(strain.column(0).amax(), 0.0);
    }

    /// A displacement linear in x, y, z with gradient g has the strain
    /// e_ij = (g_ij + g_ji) / 2, shears doubled.
    #[test]
    fn warping_strain_is_the_symmetric_gradient() {
        // columns: derivatives along x, y, z
        let g = Matrix3::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0);
        let nodes = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        let mut rate = NO_COLUMNS;
        let mut warping = NO_COLUMNS;
        for (i, [y, z]) in nodes.into_iter().enumerate() {
            rate[i].set_column(1, &g.column(0));
            // a large common displacement does not matter
            let value = g * Vector3::new(0.0, y, z) + Vector3::new(1e8, 1e8, 1e8);
            warping[i].set_column(1, &value);
        }
        let strain = strain_at(
            &Line::STRAIGHT,
            &triangle_at(0.2, 0.3),
            Some(&rate),
            Some(&warping),
            &Matrix6::zeros(),
        );
        let expected = Vector6::new(
            g[(1, 2)] + g[(2, 1)],
            g[(1, 1)],
            g[(2, 2)],
            g[(0, 0)],
            g[(0, 1)] + g[(1, 0)],
            g[(0, 2)] + g[(2, 0)],
        );
        assert_relative_eq!(strain.column(1).into_owned(), expected, epsilon = 1e-14);
    }
}
