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
//! d[(P - x) x F] = [P - x]x d F - [F]x (d P - d x)
//! ```
//!
//! The elastic energy is taken by the same two points, `sum W(eps) J0`.
//!
//! References: [Masarati], the three-node finite-volume beam.

use nalgebra::{Matrix3, Matrix6, Matrix6x3, Vector3, Vector6};
use shared_geom::rotation::skew;

use super::elastic::{ElasticBeam, NEIGHBORS, add_forces};
use super::geometry::{BeamGeometry, ReferencePoint};
use super::interpolation::{NodalKinematics, PointKinematics, Shape};
use super::strain_rate::{ByNodes, StrainPoint};
use crate::elements::laws::{Law, Response};
use crate::elements::{
    Along, Element, Energy, Local, LocalJacobian, LocalResidual, Observations, SectionState,
};
use crate::model::Equation::{Force, Moment};
use crate::model::{Drive, Node, NodeMotion, Variable};

const UNKNOWNS: [Variable; 2] = [Variable::Position, Variable::Rotation];
const RATES: [Variable; 2] = [Variable::Velocity, Variable::AngularVelocity];

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

/// Variations of the section's forces by one variable of one node, model axes, and of the
/// arm of the force.
struct ByVariable {
    force: Matrix3<f64>,
    moment: Matrix3<f64>,
    point: Matrix3<f64>,
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

    /// Generalized strains at the two evaluation points, section axes, for the given
    /// motion of the three nodes [-, 1/m].
    pub fn strains(&self, nodes: &[NodeMotion]) -> [Vector6<f64>; 2] {
        let nodal = NodalKinematics::new(&self.geometry, nodes);
        std::array::from_fn(|i| {
            let point = &self.points[i];
            point.strain(&nodal.at(&point.shape, point.reference.j0))
        })
    }
}

impl LawPoint {
    fn strain(&self, point: &PointKinematics) -> Vector6<f64> {
        let (slope, curvature) = point.strain_measures();
        let nu = slope - self.reference.slope;
        let kappa = curvature - self.reference.curvature;
        Vector6::new(nu.x, nu.y, nu.z, kappa.x, kappa.y, kappa.z)
    }

    fn at<'a>(&'a self, nodal: &'a NodalKinematics, at: &Local<'_>) -> At<'a> {
        let strain = StrainPoint::new(nodal, &self.shape, self.reference.j0);
        let variation = strain.variation();
        let rate = StrainPoint::rate(&variation, at.nodes);
        let response = self
            .law
            .at(&self.strain(&strain.point), &rate, at.loading.time);
        At {
            strain,
            variation,
            response,
        }
    }
}

impl At<'_> {
    /// Force and moment in the model's axes.
    fn internal(&self, section: &Vector6<f64>) -> [Vector3<f64>; 2] {
        let r = &self.strain.point.r;
        [
            r * section.fixed_rows::<3>(0),
            r * section.fixed_rows::<3>(3),
        ]
    }

    /// `R` times a variation of the section's forces, split into force and moment.
    fn turned(&self, section: &Matrix6x3<f64>) -> [Matrix3<f64>; 2] {
        [0, 3].map(|row| self.strain.point.r * section.fixed_view::<3, 3>(row, 0))
    }

    /// Variations by position and rotation of node `j`: what the law gives, `section`, and
    /// what comes with the turning of `internal`.
    fn by_unknowns(
        &self,
        (j, n): (usize, f64),
        offset: &Matrix3<f64>,
        section: [Matrix6x3<f64>; 2],
        [force, moment]: &[Vector3<f64>; 2],
    ) -> [ByVariable; 2] {
        let zero = Matrix3::zeros();
        let turns = [zero, self.strain.theta[j]];
        let points = [n * Matrix3::identity(), -n * offset];
        std::array::from_fn(|k| {
            let [f, m] = self.turned(&section[k]);
            ByVariable {
                force: f - skew(force) * turns[k],
                moment: m - skew(moment) * turns[k],
                point: points[k],
            }
        })
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
            let [force, moment] = state.internal(&state.response.force);
            add_forces(
                &nodal,
                &state.strain.point.p,
                [&force, &moment],
                neighbors,
                out,
            );
        }
    }

    fn jacobian(&self, at: &Local<'_>, out: &mut LocalJacobian) {
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        for (point, neighbors) in self.points.iter().zip(NEIGHBORS) {
            let state = point.at(&nodal, at);
            let Response {
                force,
                by_strain,
                by_rate,
            } = &state.response;
            let place = Place {
                nodal: &nodal,
                p: state.strain.point.p,
                neighbors,
                internal: state.internal(force),
            };
            let is_viscous = point.law.is_viscous();
            let rates = is_viscous.then(|| state.strain.rate_variation(at.nodes));
            for j in 0..3 {
                let section = std::array::from_fn(|k| {
                    let elastic = by_strain * state.variation[j][k];
                    match &rates {
                        Some(rates) => elastic + by_rate * rates[j][k],
                        None => elastic,
                    }
                });
                place.add_unknowns(&state, (j, point.shape.n[j]), section, out);
                if is_viscous {
                    place.add_rates(&state, j, by_rate, out);
                }
            }
        }
    }

    /// The part that is proportional to the internal forces, for their growth along the
    /// motion.
    fn prestress(&self, at: &Local<'_>, along: &Along<'_>, out: &mut LocalJacobian) {
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        for (point, neighbors) in self.points.iter().zip(NEIGHBORS) {
            let state = point.at(&nodal, at);
            let of_node = |(by, moved): (&[Matrix6x3<f64>; 2], &[Vector3<f64>; 2])| {
                by[0] * moved[0] + by[1] * moved[1]
            };
            let strain: Vector6<f64> = state.variation.iter().zip(along.nodes).map(of_node).sum();
            let place = Place {
                nodal: &nodal,
                p: state.strain.point.p,
                neighbors,
                internal: state.internal(&(state.response.by_strain * strain)),
            };
            for j in 0..3 {
                let none = [Matrix6x3::zeros(); 2];
                place.add_unknowns(&state, (j, point.shape.n[j]), none, out);
            }
        }
    }

    fn observe(&self, at: &Local<'_>, out: &mut Observations) {
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        for point in &self.points {
            let state = point.at(&nodal, at);
            out.sections.push(SectionState {
                beam: self.label.clone(),
                xi: point.xi,
                position: state.strain.point.p,
                axes: state.strain.point.r,
                strain: point.strain(&state.strain.point),
                internal_force: state.response.force,
            });
        }
    }
}

/// An evaluation point with the nodes beside it, and force and moment there.
struct Place<'a> {
    nodal: &'a NodalKinematics,
    p: Vector3<f64>,
    neighbors: (usize, usize),
    internal: [Vector3<f64>; 2],
}

impl Place<'_> {
    /// Adds the variations of the forces on the two nodes by position and rotation of node
    /// `j`, whose shape function is `n`.
    fn add_unknowns(
        &self,
        state: &At<'_>,
        (j, n): (usize, f64),
        section: [Matrix6x3<f64>; 2],
        out: &mut LocalJacobian,
    ) {
        let offset = skew(&self.nodal.f[j]);
        let by = state.by_unknowns((j, n), &offset, section, &self.internal);
        let force = skew(&self.internal[0]);
        for (node, sign) in [(self.neighbors.0, 1.0), (self.neighbors.1, -1.0)] {
            let arm = skew(&(self.p - self.nodal.x[node]));
            for (variable, by) in UNKNOWNS.into_iter().zip(&by) {
                let own = match j == node && variable == Variable::Position {
                    true => Matrix3::identity(),
                    false => Matrix3::zeros(),
                };
                let moment = by.moment + arm * by.force - force * (by.point - own);
                out.add((node, Force), (j, variable), &(sign * by.force));
                out.add((node, Moment), (j, variable), &(sign * moment));
            }
        }
    }

    /// The same by velocity and angular velocity of node `j`.
    fn add_rates(&self, state: &At<'_>, j: usize, by_rate: &Matrix6<f64>, out: &mut LocalJacobian) {
        for (variable, by) in RATES.into_iter().zip(&state.variation[j]) {
            let [force, moment] = state.turned(&(by_rate * by));
            for (node, sign) in [(self.neighbors.0, 1.0), (self.neighbors.1, -1.0)] {
                let arm = skew(&(self.p - self.nodal.x[node]));
                out.add((node, Force), (j, variable), &(sign * force));
                out.add(
                    (node, Moment),
                    (j, variable),
                    &(sign * (moment + arm * force)),
                );
            }
        }
    }
}
