//! Undeformed geometry of a three-node beam.

use nalgebra::{Matrix3, Vector3, Vector6};
use shared_geom::section::InitialCurvature;

use super::attachment::BeamGeometry;
use super::interpolation::{NodalKinematics, PointKinematics, Shape};
use crate::model::{Node, NodeMotion};

/// Newton iterations for the position of an arc length: each squares the error, which is a few
/// percent at first.
const POSITION_ITERATIONS: usize = 5;

/// The undeformed beam at one point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ReferencePoint {
    /// Undeformed length per unit of xi [m].
    pub j0: f64,
    /// Position [m].
    pub p: Vector3<f64>,
    /// Section axes.
    pub r: Matrix3<f64>,
    /// Slope in section axes [-].
    pub slope: Vector3<f64>,
    /// Curvature in section axes [1/m].
    pub curvature: Vector3<f64>,
}

impl ReferencePoint {
    /// Generalized strain `[nu; kappa]` of a point, section axes [-, 1/m].
    pub(super) fn strain(&self, point: &PointKinematics) -> Vector6<f64> {
        let (slope, curvature) = point.strain_measures();
        let nu = slope - self.slope;
        let kappa = curvature - self.curvature;
        Vector6::new(nu.x, nu.y, nu.z, kappa.x, kappa.y, kappa.z)
    }
}

impl BeamGeometry {
    /// The undeformed beam at xi, with `J0 = |N'_j p_j|`; `nodes` are undeformed.
    pub(super) fn reference_point(&self, nodes: &[&Node; 3], xi: f64) -> ReferencePoint {
        let motion = nodes.map(NodeMotion::at_rest);
        let nodal = NodalKinematics::new(self, &motion);
        let shape = Shape::at(xi);
        let j0 = nodal.at(&shape, 1.0).l.norm();
        let point: PointKinematics = nodal.at(&shape, j0);
        let (slope, curvature) = point.strain_measures();
        ReferencePoint {
            j0,
            p: point.p,
            r: point.r,
            slope,
            curvature,
        }
    }

    /// Curvature and slope of the undeformed line at xi, by arc length and in section
    /// axes (D-230).
    pub fn initial_curvature(&self, nodes: &[&Node; 3], xi: f64) -> InitialCurvature {
        let point = self.reference_point(nodes, xi);
        InitialCurvature {
            curvature: point.curvature,
            slope: point.slope,
        }
    }

    /// Undeformed length of the reference line from the first node to xi [m].
    pub fn arc_length(&self, nodes: &[&Node; 3], xi: f64) -> f64 {
        let half = 0.5 * (xi + 1.0);
        shared_geom::quadrature::line(3)
            .iter()
            .map(|(at, weight)| {
                let position = half * (at + 1.0) - 1.0;
                half * weight * self.reference_point(nodes, position).j0
            })
            .sum()
    }

    /// Position xi at an arc length from the first node.
    pub fn position(&self, nodes: &[&Node; 3], arc_length: f64) -> f64 {
        let length = self.length(nodes);
        let mut xi = 2.0 * arc_length / length - 1.0;
        // Nearly linear already: the middle node is near the middle.
        for _ in 0..POSITION_ITERATIONS {
            let excess = self.arc_length(nodes, xi) - arc_length;
            xi = (xi - excess / self.reference_point(nodes, xi).j0).clamp(-1.0, 1.0);
        }
        xi
    }

    /// Position [m] and direction \[-\] of the line at xi of the undeformed beam.
    pub fn line_point(&self, nodes: &[&Node; 3], xi: f64) -> (Vector3<f64>, Vector3<f64>) {
        let point = self.reference_point(nodes, xi);
        (point.p, (point.r * point.slope).normalize())
    }

    /// Section axes at xi of the undeformed beam (columns) [-].
    pub fn section_axes(&self, nodes: &[&Node; 3], xi: f64) -> Matrix3<f64> {
        self.reference_point(nodes, xi).r
    }

    /// Undeformed length of the reference line, by three Gauss points [m].
    pub fn length(&self, nodes: &[&Node; 3]) -> f64 {
        shared_geom::quadrature::line(3)
            .iter()
            .map(|(xi, weight)| weight * self.reference_point(nodes, *xi).j0)
            .sum()
    }
}
