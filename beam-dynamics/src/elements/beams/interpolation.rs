//! Objective interpolation of position and rotation along a three-node beam.
//!
//! Nodes 1, 2, 3 at xi = -1, 0, 1. Rotations are interpolated relative to the mid
//! node and in its frame, so that a rigid motion causes no strain:
//!
//! ```text
//! p_j = x_j + R_j f~_j                    A = R_2 R~_2
//! g~_j = g(A^T R_j R~_j)                  (g~_2 = 0)
//! p = N_j p_j                             l = N'_j p_j / J0
//! g~ = N_j g~_j                           g~' = N'_j g~_j / J0
//! R = A R(g~)
//! ```
//!
//! and its variation, with spatial rotations theta_j of the nodes:
//!
//! ```text
//! d p_j = d x_j - [f_j]x theta_j
//! A_j   = G(g~_j)^-1 A^T                  d g~  = sum_{1,3} N_j  A_j (theta_j - theta_2)
//! theta = theta_2 + A G(g~) d g~          d g~' = sum_{1,3} N'_j A_j (theta_j - theta_2) / J0
//! ```
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | x_j, R_j | position and rotation of node j | m, - |
//! | f~_j, f_j | offset of the beam from the node, in node and model axes | m |
//! | R~_j | section axes at node j in the node's axes | - |
//! | p, R | position and section axes at xi | m, - |
//! | l | slope of the line, per unit undeformed length | - |
//! | g~ | Gibbs-Rodrigues parameters of the section relative to the mid one | - |
//! | J0 | undeformed length per unit of xi | m |
//!
//! References: [Masarati], the three-node finite-volume beam; the interpolation
//! relative to the mid node makes it objective.

use nalgebra::{Matrix3, Vector3};
use shared_geom::lagrange;
use shared_geom::rotation::{gibbs, skew};

use super::geometry::BeamGeometry;
use crate::model::NodeMotion;

/// Node of the beam at each place along xi, in the gmsh order of `line3`.
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
    /// Gibbs-Rodrigues parameters relative to the mid node.
    pub g: [Vector3<f64>; 3],
}

impl NodalKinematics {
    pub fn new(geometry: &BeamGeometry, nodes: &[NodeMotion]) -> Self {
        let x = std::array::from_fn(|j| nodes[j].position);
        let f = std::array::from_fn(|j| nodes[j].rotation * geometry.nodes[j].offset);
        let section = |j: usize| nodes[j].rotation * geometry.nodes[j].orientation;
        let a = section(1);
        let relative = |j: usize| gibbs::from_rotation(&(a.transpose() * section(j)));
        Self {
            x,
            f,
            p: std::array::from_fn(|j| x[j] + f[j]),
            a,
            g: [relative(0), Vector3::zeros(), relative(2)],
        }
    }

    /// The state at a point with shape functions `shape` and undeformed length
    /// `j0` per unit of xi.
    pub fn at(&self, shape: &Shape, j0: f64) -> PointKinematics {
        let g = shape.sum(&self.g);
        PointKinematics {
            p: shape.sum(&self.p),
            l: shape.slope(&self.p) / j0,
            g,
            g_prime: shape.slope(&self.g) / j0,
            r: self.a * gibbs::to_rotation(&g),
        }
    }

    /// `A_j = G(g~_j)^-1 A^T` of the outer nodes.
    pub fn relative_variation(&self) -> [Matrix3<f64>; 2] {
        [0, 2].map(|j| gibbs::tangent_inverse(&self.g[j]) * self.a.transpose())
    }

    /// Derivatives of the rotation at a point by the rotations of the nodes:
    /// `theta = sum_j T_j theta_j`, with `B = A G(g~)`,
    /// `T_1 = N_1 B A_1`, `T_3 = N_3 B A_3`, `T_2 = I - T_1 - T_3`.
    pub fn rotation_variation(
        &self,
        shape: &Shape,
        point: &PointKinematics,
        relative: &[Matrix3<f64>; 2],
    ) -> [Matrix3<f64>; 3] {
        let b = self.a * gibbs::tangent(&point.g);
        let first = shape.n[0] * b * relative[0];
        let last = shape.n[2] * b * relative[1];
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
    /// Gibbs-Rodrigues parameters relative to the mid node.
    pub g: Vector3<f64>,
    /// Their derivative along the undeformed line [1/m].
    pub g_prime: Vector3<f64>,
    /// Section axes.
    pub r: Matrix3<f64>,
}

impl PointKinematics {
    /// Slope in section axes, `R^T l`, and curvature in section axes, `G(g~)^T g~'`.
    pub fn strain_measures(&self) -> (Vector3<f64>, Vector3<f64>) {
        let slope = self.r.transpose() * self.l;
        let curvature = gibbs::tangent(&self.g).transpose() * self.g_prime;
        (slope, curvature)
    }
}
