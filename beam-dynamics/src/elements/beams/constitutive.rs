//! The three-node finite-volume beam with any constitutive law.
//!
//! At the evaluation points of [`super::ElasticBeam`], in section axes, with the strain
//! `eps = [nu; kappa]` and its rate (see [`super::strain_rate`]),
//!
//! ```text
//! [F~; M~] = law(eps, eps', t)            F = R F~,  M = R M~
//! d [F~; M~] = C d eps + V d eps'         C, V: slopes of the law
//! ```
//!
//! The forces on the nodes are those of the elastic beam, and so are their variations
//!
//! ```text
//! d F = R d F~ - [F]x theta               d M = R d M~ - [M]x theta
//! ```
//!
//! The elastic energy is taken by the same two points, `sum W(eps) J0`.
//!
//! References: [Masarati], the three-node finite-volume beam.

use nalgebra::{Matrix6x3, Vector3, Vector6};
use shared_geom::rotation::skew_times;

use super::elastic::ElasticBeam;
use super::geometry::{BeamGeometry, ReferencePoint};
use super::interpolation::{NodalKinematics, Shape};
use super::portions::{ByNode, Internal, NEIGHBORS};
use super::strain_rate::{ByNodes, StrainPoint};
use crate::elements::laws::{Law, Response};
use crate::elements::{
    Along, Element, Energy, Local, LocalJacobian, LocalResidual, Observations, SectionState,
};
use crate::model::{Drive, Node, NodeMotion};

/// A geometrically exact beam through three nodes, of any law.
#[derive(Debug, Clone)]
pub struct LawBeam {
    label: String,
    nodes: [usize; 3],
    geometry: BeamGeometry,
    points: [LawPoint; 2],
}

#[derive(Debug, Clone)]
struct LawPoint {
    xi: f64,
    shape: Shape,
    reference: ReferencePoint,
    law: Law<6>,
}

/// An evaluation point at a state.
struct At<'a> {
    strain: StrainPoint<'a>,
    variation: ByNodes,
    response: Response<6>,
}

impl LawBeam {
    /// A beam on nodes number `nodes`, undeformed at `undeformed`, with the laws at the
    /// evaluation points xi = -1/sqrt 3 and 1/sqrt 3.
    pub fn new(
        label: impl Into<String>,
        nodes: [usize; 3],
        geometry: BeamGeometry,
        undeformed: [&Node; 3],
        laws: [Law<6>; 2],
    ) -> Self {
        let places = ElasticBeam::evaluation_points();
        let [first, second] = laws;
        let point = |xi: f64, law: Law<6>| LawPoint {
            xi,
            shape: Shape::at(xi),
            reference: geometry.reference_point(&undeformed, xi),
            law,
        };
        Self {
            label: label.into(),
            nodes,
            geometry,
            points: [point(places[0], first), point(places[1], second)],
        }
    }

    /// Rates of the generalized strains at the two evaluation points, section axes, for
    /// the given motion of the three nodes [1/s, 1/(m s)].
    pub fn strain_rates(&self, nodes: &[NodeMotion]) -> [Vector6<f64>; 2] {
        let nodal = NodalKinematics::new(&self.geometry, nodes);
        self.points.each_ref().map(|point| {
            let strain = StrainPoint::new(&nodal, &point.shape, point.reference.j0);
            StrainPoint::rate(&strain.variation(), nodes)
        })
    }

    /// Generalized strains at the two evaluation points, section axes, for the given
    /// motion of the three nodes [-, 1/m].
    pub fn strains(&self, nodes: &[NodeMotion]) -> [Vector6<f64>; 2] {
        let nodal = NodalKinematics::new(&self.geometry, nodes);
        std::array::from_fn(|i| {
            let point = &self.points[i];
            point
                .reference
                .strain(&nodal.at(&point.shape, point.reference.j0))
        })
    }
}

impl LawPoint {
    fn at<'a>(&'a self, nodal: &'a NodalKinematics, at: &Local<'_>) -> At<'a> {
        let strain = StrainPoint::new(nodal, &self.shape, self.reference.j0);
        let variation = strain.variation();
        let rate = StrainPoint::rate(&variation, at.nodes);
        let now = self.reference.strain(&strain.point);
        let response = self.law.at(&now, &rate, at.loading.time);
        At {
            strain,
            variation,
            response,
        }
    }
}

impl At<'_> {
    /// Force and moment in the model's axes.
    fn internal(&self, section: &Vector6<f64>) -> Internal {
        let point = self.strain.point;
        Internal {
            point,
            force: point.r * section.fixed_rows::<3>(0),
            moment: point.r * section.fixed_rows::<3>(3),
        }
    }

    /// `R` times variations of the section's forces.
    fn turned(&self, sections: &[Matrix6x3<f64>; 2]) -> ByNode {
        let part = |row: usize| {
            sections
                .each_ref()
                .map(|section| self.strain.point.r * section.fixed_view::<3, 3>(row, 0))
        };
        ByNode {
            force: part(0),
            moment: part(3),
        }
    }

    /// Variations by position and rotation of node `j`: what the law gives, `sections`,
    /// and what comes with the turning of `internal`.
    fn by_unknowns(&self, j: usize, sections: &[Matrix6x3<f64>; 2], internal: &Internal) -> ByNode {
        let mut by = self.turned(sections);
        let theta = &self.strain.theta[j];
        by.force[1] -= skew_times(&internal.force, theta);
        by.moment[1] -= skew_times(&internal.moment, theta);
        by
    }

    /// What the law gives by position and rotation of each node.
    fn sections(&self, is_viscous: bool, nodes: &[NodeMotion]) -> ByNodes {
        let Response {
            by_strain, by_rate, ..
        } = &self.response;
        let elastic = self.variation.map(|by| by.map(|by| by_strain * by));
        if !is_viscous {
            return elastic;
        }
        let rates = self.strain.rate_variation(nodes);
        std::array::from_fn(|j| std::array::from_fn(|k| elastic[j][k] + by_rate * rates[j][k]))
    }
}

impl Element for LawBeam {
    fn label(&self) -> &str {
        &self.label
    }

    fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    fn joins_nodes(&self) -> bool {
        true
    }

    fn domain(&self) -> [f64; 2] {
        let drives = self.points.iter().flat_map(|point| point.law.drives());
        Drive::common_domain(drives)
    }

    fn next_corner(&self, time: f64) -> f64 {
        let corners = self.points.iter().map(|point| point.law.next_corner(time));
        corners.fold(f64::INFINITY, f64::min)
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let strains = self.strains(at.nodes);
        let of_point = |(point, strain): (&LawPoint, &Vector6<f64>)| {
            point.law.energy(strain, at.loading.time) * point.reference.j0
        };
        Energy {
            elastic: self.points.iter().zip(&strains).map(of_point).sum(),
            ..Energy::default()
        }
    }

    fn residual(&self, at: &Local<'_>, out: &mut LocalResidual) {
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        for (point, neighbors) in self.points.iter().zip(NEIGHBORS) {
            let state = point.at(&nodal, at);
            let internal = state.internal(&state.response.force);
            internal.add_forces(&nodal, neighbors, out);
        }
    }

    fn jacobian(&self, at: &Local<'_>, out: &mut LocalJacobian) {
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        for (point, neighbors) in self.points.iter().zip(NEIGHBORS) {
            let state = point.at(&nodal, at);
            let internal = state.internal(&state.response.force);
            let is_viscous = point.law.is_viscous();
            let sections = state.sections(is_viscous, at.nodes);
            let by = std::array::from_fn(|j| state.by_unknowns(j, &sections[j], &internal));
            internal.add_tangent(&nodal, &point.shape, &by, neighbors, out);
            if is_viscous {
                let by_rate = &state.response.by_rate;
                let by = state
                    .variation
                    .map(|by| state.turned(&by.map(|by| by_rate * by)));
                internal.add_rates(&nodal, &by, neighbors, out);
            }
        }
    }

    /// The part that is proportional to the internal forces, for their growth along the
    /// motion, with the stiffness of the section where it grows with the strain.
    fn prestress(&self, at: &Local<'_>, along: &Along<'_>, out: &mut LocalJacobian) {
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        for (point, neighbors) in self.points.iter().zip(NEIGHBORS) {
            let state = point.at(&nodal, at);
            let of_node = |(by, moved): (&[Matrix6x3<f64>; 2], &[Vector3<f64>; 2])| {
                by[0] * moved[0] + by[1] * moved[1]
            };
            let strain: Vector6<f64> = state.variation.iter().zip(along.nodes).map(of_node).sum();
            let growth = state.internal(&(state.response.by_strain * strain));
            let stiffer = point.law.growth_of_stiffness(&strain);
            let sections = state.variation.map(|by| by.map(|by| stiffer * by));
            let by = std::array::from_fn(|j| state.by_unknowns(j, &sections[j], &growth));
            growth.add_tangent(&nodal, &point.shape, &by, neighbors, out);
        }
    }

    fn observe(&self, at: &Local<'_>, out: &mut Observations) {
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        for point in &self.points {
            let state = point.at(&nodal, at);
            let strain = point.reference.strain(&state.strain.point);
            out.sections.push(SectionState {
                beam: self.label.clone(),
                xi: point.xi,
                position: state.strain.point.p,
                axes: state.strain.point.r,
                strain,
                internal_force: state.response.force,
                change_of_stiffness: point.law.change_by_prestress(&strain, at.loading.time),
            });
        }
    }
}
