//! Objective interpolation of position and rotation along a three-node beam.
//!
//! Nodes 1, 2, 3 at xi = -1, 0, 1. Rotations are interpolated relative to the mid
//! node and in its frame, so that a rigid motion causes no strain, by parameters psi
//! (see [`Parametrization`]; T is their tangent):
//!
//! ```text
//! p_j = x_j + R_j f~_j                    A = R_2 R~_2
//! psi_j = psi(A^T R_j R~_j)               (psi_2 = 0)
//! p = N_j p_j                             l = N'_j p_j / J0
//! psi = N_j psi_j                         psi' = N'_j psi_j / J0
//! R = A R(psi)
//! ```
//!
//! and its variation, with spatial rotations theta_j of the nodes:
//!
//! ```text
//! d p_j = d x_j - [f_j]x theta_j
//! A_j   = T(psi_j)^-1 A^T                 d psi  = sum_{1,3} N_j  A_j (theta_j - theta_2)
//! theta = theta_2 + A T(psi) d psi        d psi' = sum_{1,3} N'_j A_j (theta_j - theta_2) / J0
//! ```
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | x_j, R_j | position and rotation of node j | m, - |
//! | f~_j, f_j | offset of the beam from the node, in node and model axes | m |
//! | R~_j | section axes at node j in the node's axes | - |
//! | p, R | position and section axes at xi | m, - |
//! | l | slope of the line, per unit undeformed length | - |
//! | psi | parameters of the section's rotation relative to the mid one | rad |
//! | J0 | undeformed length per unit of xi | m |
//!
//! A constant curvature is exact with rotation vectors, which are valid until the ends of an
//! element turn by nearly half a turn relative to its middle ([`LARGEST`]); beyond, no state is
//! defined, and the interpolation returns NaN.
//!
//! References: [Masarati], the three-node finite-volume beam (Gibbs parameters);
//! [CrisfieldJelenic1999], relative rotation vectors.

use nalgebra::{Matrix3, Vector3};
use shared_geom::lagrange;
use shared_geom::rotation::parameters::{Parametrization, RotationMap};
use shared_geom::rotation::{product, skew, times_skew, vector};

use super::attachment::BeamGeometry;
use crate::model::NodeMotion;

/// Largest rotation of an outer node relative to the mid one with rotation vectors, 0.95 pi
/// \[rad\]: the next state may be on the other side of half a turn, where the vector flips its
/// sign.
pub(super) const LARGEST: f64 = 0.95 * std::f64::consts::PI;

/// Node of the beam at each index along xi, in the gmsh order of `line3`.
const LINE3_ORDER: [usize; 3] = [0, 2, 1];

/// Shape functions at a point: values and derivatives by xi, nodes 1, 2, 3.
#[derive(Debug, Clone, Copy)]
pub(super) struct Shape {
    pub n: [f64; 3],
    pub d: [f64; 3],
}

impl Shape {
    pub fn at(xi: f64) -> Self {
        let line = lagrange::line3(xi);
        Self {
            n: LINE3_ORDER.map(|i| line.n[i]),
            d: LINE3_ORDER.map(|i| line.d[i]),
        }
    }

    /// `N_j a_j`.
    pub fn sum(&self, of: &[Vector3<f64>; 3]) -> Vector3<f64> {
        self.n[0] * of[0] + self.n[1] * of[1] + self.n[2] * of[2]
    }

    /// `N'_j a_j`.
    pub fn slope(&self, of: &[Vector3<f64>; 3]) -> Vector3<f64> {
        self.d[0] * of[0] + self.d[1] * of[1] + self.d[2] * of[2]
    }
}

/// Position and rotation quantities of the nodes of one beam.
#[derive(Debug, Clone, Copy)]
pub(super) struct NodalKinematics {
    /// Node positions [m].
    pub x: [Vector3<f64>; 3],
    /// Offsets in model axes [m].
    pub f: [Vector3<f64>; 3],
    /// Beam points at the nodes [m].
    pub p: [Vector3<f64>; 3],
    /// Section axes at the mid node.
    pub a: Matrix3<f64>,
    /// Parametrization of the relative rotations.
    pub parametrization: Parametrization,
    /// The rotations of the outer nodes relative to the mid one.
    pub outer: [RotationMap; 2],
    /// `A_j = T(psi_j)^-1 A^T` of the outer nodes.
    pub relative: [Matrix3<f64>; 2],
}

impl NodalKinematics {
    pub fn new(geometry: &BeamGeometry, nodes: &[NodeMotion]) -> Self {
        let x = [nodes[0].position, nodes[1].position, nodes[2].position];
        let offset = |j: usize| nodes[j].rotation * geometry.nodes[j].offset;
        let f = [offset(0), offset(1), offset(2)];
        let section = |j: usize| product(&nodes[j].rotation, &geometry.nodes[j].orientation);
        let a = section(1);
        let parametrization = geometry.formulation.parametrization();
        let relative = |j: usize| {
            let psi = parametrization.of_rotation(&product(&a.transpose(), &section(j)));
            let is_beyond = parametrization == Parametrization::RotationVector
                && psi.norm_squared() > LARGEST * LARGEST;
            parametrization.at(&if is_beyond {
                Vector3::repeat(f64::NAN)
            } else {
                psi
            })
        };
        let outer = [relative(0), relative(2)];
        Self {
            x,
            p: [x[0] + f[0], x[1] + f[1], x[2] + f[2]],
            f,
            a,
            parametrization,
            relative: [
                product(&outer[0].tangent_inverse(), &a.transpose()),
                product(&outer[1].tangent_inverse(), &a.transpose()),
            ],
            outer,
        }
    }

    /// The larger rotation of the two outer sections relative to the mid one \[rad\].
    pub fn largest_turn(geometry: &BeamGeometry, nodes: &[NodeMotion]) -> f64 {
        let section = |j: usize| nodes[j].rotation * geometry.nodes[j].orientation;
        let turn = |j| vector::from_rotation(&(section(1).transpose() * section(j))).norm();
        f64::max(turn(0), turn(2))
    }

    /// The state at a point with shape functions `shape` and undeformed length
    /// `j0` per unit of xi.
    pub fn at(&self, shape: &Shape, j0: f64) -> PointKinematics {
        let [first, last] = [&self.outer[0].psi, &self.outer[1].psi];
        let psi = shape.n[0] * first + shape.n[2] * last;
        let map = self.parametrization.at(&psi);
        let tangent = map.tangent();
        PointKinematics {
            p: shape.sum(&self.p),
            l: shape.slope(&self.p) / j0,
            psi_prime: (shape.d[0] * first + shape.d[2] * last) / j0,
            r: self.a + product(&self.a, &times_skew(&tangent, &psi)),
            tangent,
            map,
        }
    }

    /// Derivatives of the rotation at a point by the rotations of the nodes:
    /// `theta = sum_j T_j theta_j`, with `B = A T(psi)`,
    /// `T_1 = N_1 B A_1`, `T_3 = N_3 B A_3`, `T_2 = I - T_1 - T_3`.
    pub fn rotation_variation(&self, shape: &Shape, point: &PointKinematics) -> [Matrix3<f64>; 3] {
        let relative = &self.relative;
        let b = product(&self.a, &point.tangent);
        let first = shape.n[0] * product(&b, &relative[0]);
        let last = shape.n[2] * product(&b, &relative[1]);
        [first, Matrix3::identity() - first - last, last]
    }

    /// `[f_j]x` of each node: `d p_j = d x_j - [f_j]x theta_j`.
    pub fn offset_skew(&self) -> [Matrix3<f64>; 3] {
        self.f.map(|f| skew(&f))
    }
}

/// Interpolated quantities at one point.
#[derive(Debug, Clone, Copy)]
pub(super) struct PointKinematics {
    /// Position [m].
    pub p: Vector3<f64>,
    /// Slope per undeformed length [-].
    pub l: Vector3<f64>,
    /// Rotation relative to the mid node, with its maps.
    pub map: RotationMap,
    /// T(psi).
    pub tangent: Matrix3<f64>,
    /// Derivative of psi along the undeformed line [1/m].
    pub psi_prime: Vector3<f64>,
    /// Section axes.
    pub r: Matrix3<f64>,
}

impl PointKinematics {
    /// Slope in section axes, `R^T l`, and curvature in section axes, `T(psi)^T psi'`.
    pub fn strain_measures(&self) -> (Vector3<f64>, Vector3<f64>) {
        let slope = self.r.transpose() * self.l;
        (slope, self.tangent.transpose() * self.psi_prime)
    }
}
