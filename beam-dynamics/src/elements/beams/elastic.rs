//! Elastic forces of the three-node finite-volume beam.
//!
//! The beam is cut at the evaluation points I and II (xi = -+1/sqrt 3) into three
//! portions, each in balance with its node. At an evaluation point, in section axes,
//!
//! ```text
//! nu = R^T l - (R^T l)_ref        kappa = G(g~)^T g~' - (G^T g~')_ref
//! [F~; M~] = K [nu; kappa]        F = R F~,  M = R M~
//! ```
//!
//! and the forces on the nodes are
//!
//! ```text
//! node 1:   F_I              M_I        + (p_I - x_1) x F_I
//! node 2:   F_II - F_I       M_II - M_I + (p_II - x_2) x F_II - (p_I - x_2) x F_I
//! node 3: - F_II           - M_II       - (p_II - x_3) x F_II
//! ```
//!
//! The elastic energy is taken by the same two points, `sum 1/2 eps . K eps J0`.
//!
//! Variations (see [`super::interpolation`] for theta and d p):
//!
//! ```text
//! d nu = R^T (d l + [l]x theta)        d kappa = G^T d g~' + d(G^T g~')/dg~ d g~
//! d F = R d F~ - [F]x theta            d M = R d M~ - [M]x theta
//! d[(P - x) x F] = [P - x]x d F - [F]x (d P - d x)
//! ```
//!
//! With the blocks of the stiffness turned, `K_FF = R K~_FF R^T` and so on,
//! `S = d(G^T g~')/dg~`, `B = A G` and `R G^T = B`, this is
//!
//! ```text
//! d F = K_FF d l + (K_FF [l]x - [F]x) theta + K_FM (R S d g~ + B d g~')
//! d M = K_MF d l + (K_MF [l]x - [M]x) theta + K_MM (R S d g~ + B d g~')
//! ```
//!
//! References: [Masarati], the three-node finite-volume beam (5.2-5.4).

use nalgebra::{Matrix3, Matrix6, Vector6};
use shared_geom::rotation::{gibbs, skew, times_skew};

use super::geometry::{BeamGeometry, ReferencePoint};
use super::interpolation::{NodalKinematics, PointKinematics, Shape};
use super::portions::{ByNode, Internal, NEIGHBORS};
use crate::elements::{
    Along, Element, Energy, Local, LocalJacobian, LocalResidual, Observations, SectionState,
};
use crate::model::{Node, NodeMotion};

mod prestress;

/// xi of the evaluation points: the Gauss points, which make the beam of constant
/// properties exact at its ends.
const EVALUATION_POINTS: [f64; 2] = [-0.577_350_269_189_625_8, 0.577_350_269_189_625_8];

/// A geometrically exact elastic beam through three nodes.
#[derive(Debug, Clone)]
pub struct ElasticBeam {
    label: String,
    nodes: [usize; 3],
    geometry: BeamGeometry,
    points: [EvaluationPoint; 2],
}

#[derive(Debug, Clone)]
struct EvaluationPoint {
    shape: Shape,
    reference: ReferencePoint,
    /// Section stiffness, section axes [N, N m, N m^2].
    stiffness: Matrix6<f64>,
}

impl ElasticBeam {
    /// A beam on nodes number `nodes`, undeformed at `undeformed`, with the stiffness
    /// given at the evaluation points xi = -1/sqrt 3 and 1/sqrt 3.
    pub fn new(
        label: impl Into<String>,
        nodes: [usize; 3],
        geometry: BeamGeometry,
        undeformed: [&Node; 3],
        stiffness: [Matrix6<f64>; 2],
    ) -> Self {
        let points = std::array::from_fn(|i| {
            let xi = EVALUATION_POINTS[i];
            EvaluationPoint {
                shape: Shape::at(xi),
                reference: geometry.reference_point(&undeformed, xi),
                stiffness: stiffness[i],
            }
        });
        Self {
            label: label.into(),
            nodes,
            geometry,
            points,
        }
    }

    /// xi of the two evaluation points.
    pub fn evaluation_points() -> [f64; 2] {
        EVALUATION_POINTS
    }

    /// How the beam is attached to its nodes.
    pub fn geometry(&self) -> BeamGeometry {
        self.geometry
    }

    /// Generalized strains at the two evaluation points, section axes, for the given
    /// motion of the three nodes [-, 1/m].
    pub fn strains(&self, nodes: &[NodeMotion]) -> [Vector6<f64>; 2] {
        let nodal = NodalKinematics::new(&self.geometry, nodes);
        std::array::from_fn(|i| {
            let point = &self.points[i];
            point.reference.strain(&nodal.at_point(point))
        })
    }

    /// Internal forces at the two evaluation points, section axes [N, N m].
    pub fn internal_forces(&self, nodes: &[NodeMotion]) -> [Vector6<f64>; 2] {
        let strains = self.strains(nodes);
        std::array::from_fn(|i| self.points[i].stiffness * strains[i])
    }
}

impl NodalKinematics {
    fn at_point(&self, point: &EvaluationPoint) -> PointKinematics {
        self.at(&point.shape, point.reference.j0)
    }
}

impl EvaluationPoint {
    fn internal(&self, nodal: &NodalKinematics) -> Internal {
        let point = nodal.at_point(self);
        let section = self.stiffness * self.reference.strain(&point);
        Internal {
            point,
            force: point.r * section.fixed_rows::<3>(0),
            moment: point.r * section.fixed_rows::<3>(3),
        }
    }

    /// `d F` and `d M` by position and rotation of each node, `relative` being the `A_j`
    /// of the outer ones.
    fn variation(
        &self,
        nodal: &NodalKinematics,
        relative: &[Matrix3<f64>; 2],
        at: &Internal,
    ) -> [ByNode; 3] {
        let point = &at.point;
        let rt = point.r.transpose();
        let b = nodal.a * gibbs::tangent(&point.g);
        let bent = point.r * gibbs::tangent_transpose_derivative(&point.g, &point.g_prime);
        let [force, moment] = [(0, &at.force), (3, &at.moment)].map(|(row, sum)| {
            let turned = |column| point.r * self.stiffness.fixed_view::<3, 3>(row, column) * rt;
            let (by_slope, by_curvature) = (turned(0), turned(3));
            let by_theta = times_skew(&by_slope, &point.l) - skew(sum);
            let by_g = by_theta * b + by_curvature * bent;
            let by_g_prime = by_curvature * b;
            let outer = [0, 1].map(|k| {
                let j = 2 * k;
                (self.shape.n[j] * by_g + self.slope(j) * by_g_prime) * relative[k]
            });
            let rotations = [outer[0], by_theta - outer[0] - outer[1], outer[1]];
            std::array::from_fn::<_, 3, _>(|j| {
                let position = self.slope(j) * by_slope;
                [position, rotations[j] - times_skew(&position, &nodal.f[j])]
            })
        });
        std::array::from_fn(|j| ByNode {
            force: force[j],
            moment: moment[j],
        })
    }

    /// `N'_j / J0`.
    fn slope(&self, j: usize) -> f64 {
        self.shape.d[j] / self.reference.j0
    }
}

impl Element for ElasticBeam {
    fn label(&self) -> &str {
        &self.label
    }

    fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    fn joins_nodes(&self) -> bool {
        true
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let strains = self.strains(at.nodes);
        let of_point = |(point, strain): (&EvaluationPoint, &Vector6<f64>)| {
            0.5 * strain.dot(&(point.stiffness * strain)) * point.reference.j0
        };
        Energy {
            elastic: self.points.iter().zip(&strains).map(of_point).sum(),
            ..Energy::default()
        }
    }

    fn residual(&self, at: &Local<'_>, out: &mut LocalResidual) {
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        for (evaluation, neighbors) in self.points.iter().zip(NEIGHBORS) {
            evaluation
                .internal(&nodal)
                .add_forces(&nodal, neighbors, out);
        }
    }

    fn jacobian(&self, at: &Local<'_>, out: &mut LocalJacobian) {
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        let relative = nodal.relative_variation();
        for (evaluation, neighbors) in self.points.iter().zip(NEIGHBORS) {
            let internal = evaluation.internal(&nodal);
            let variation = evaluation.variation(&nodal, &relative, &internal);
            internal.add_tangent(&nodal, &evaluation.shape, &variation, neighbors, out);
        }
    }

    fn prestress(&self, at: &Local<'_>, along: &Along<'_>, out: &mut LocalJacobian) {
        self.add_prestress(at, along, out);
    }

    fn observe(&self, at: &Local<'_>, out: &mut Observations) {
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        for (evaluation, xi) in self.points.iter().zip(EVALUATION_POINTS) {
            let point = nodal.at_point(evaluation);
            let strain = evaluation.reference.strain(&point);
            out.sections.push(SectionState {
                beam: self.label.clone(),
                xi,
                position: point.p,
                axes: point.r,
                strain,
                internal_force: evaluation.stiffness * strain,
                change_of_stiffness: None,
            });
        }
    }
}
