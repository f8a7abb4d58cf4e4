//! Viscous forces of the three-node beam: what its material adds in motion.
//!
//! Beside the elastic law of [`super::ElasticBeam`], at the same evaluation points, in
//! section axes,
//!
//! ```text
//! [F~; M~] = D [nu.; kappa.]              F = R F~,  M = R M~
//! ```
//!
//! so that both together are the law of Kelvin and Voigt, `K eps + D eps.`. The forces
//! on the nodes are those of the elastic beam. Variations (see [`super::strain_rate`]):
//!
//! ```text
//! d F = R d F~ - [F]x theta               d M = R d M~ - [M]x theta
//! d[(P - x) x F] = [P - x]x d F - [F]x (d P - d x)
//! ```
//!
//! In steady rotation nothing moves in the frame, and all of this vanishes.
//!
//! References: [Masarati], the three-node finite-volume beam.

use nalgebra::{Matrix3, Matrix6, Matrix6x3, Vector3, Vector6};
use shared_geom::rotation::skew;

use super::elastic::{ElasticBeam, NEIGHBORS, add_forces};
use super::geometry::BeamGeometry;
use super::interpolation::{NodalKinematics, Shape};
use super::strain_rate::{ByNodes, StrainPoint};
use crate::elements::{Element, Local, LocalJacobian, LocalResidual};
use crate::model::Equation::{Force, Moment};
use crate::model::{Node, NodeMotion, Variable};

/// Internal damping of a beam through three nodes.
#[derive(Debug, Clone)]
pub struct ViscousBeam {
    label: String,
    nodes: [usize; 3],
    geometry: BeamGeometry,
    points: [ViscousPoint; 2],
}

#[derive(Debug, Clone)]
struct ViscousPoint {
    shape: Shape,
    /// Undeformed length per unit of xi [m].
    j0: f64,
    /// Section viscosity, section axes [N s, N m s, N m^2 s].
    damping: Matrix6<f64>,
}

/// Force and moment at an evaluation point, model axes.
struct Internal<'a> {
    strain: StrainPoint<'a>,
    variation: ByNodes,
    /// Force [N] and moment [N m].
    force: Vector3<f64>,
    moment: Vector3<f64>,
}

impl ViscousBeam {
    /// The damping of a beam on nodes number `nodes`, undeformed at `undeformed`, with the
    /// viscosity given at the evaluation points xi = -1/sqrt 3 and 1/sqrt 3.
    pub fn new(
        label: impl Into<String>,
        nodes: [usize; 3],
        geometry: BeamGeometry,
        undeformed: [&Node; 3],
        damping: [Matrix6<f64>; 2],
    ) -> Self {
        let places = ElasticBeam::evaluation_points();
        Self {
            label: label.into(),
            nodes,
            geometry,
            points: std::array::from_fn(|i| ViscousPoint {
                shape: Shape::at(places[i]),
                j0: geometry.reference_point(&undeformed, places[i]).j0,
                damping: damping[i],
            }),
        }
    }

    /// Rates of the generalized strains at the two evaluation points, section axes, for
    /// the given motion of the three nodes [1/s, 1/(m s)].
    pub fn strain_rates(&self, nodes: &[NodeMotion]) -> [Vector6<f64>; 2] {
        let nodal = NodalKinematics::new(&self.geometry, nodes);
        std::array::from_fn(|i| {
            let at = &self.points[i];
            let variation = StrainPoint::new(&nodal, &at.shape, at.j0).variation();
            StrainPoint::rate(&variation, nodes)
        })
    }
}

impl ViscousPoint {
    fn internal<'a>(&'a self, nodal: &'a NodalKinematics, nodes: &[NodeMotion]) -> Internal<'a> {
        let strain = StrainPoint::new(nodal, &self.shape, self.j0);
        let variation = strain.variation();
        let section = self.damping * StrainPoint::rate(&variation, nodes);
        let r = strain.point.r;
        Internal {
            strain,
            variation,
            force: r * section.fixed_rows::<3>(0),
            moment: r * section.fixed_rows::<3>(3),
        }
    }
}

impl Internal<'_> {
    /// `R D` times a variation of the strain rate, split into force and moment.
    fn turned(&self, damping: &Matrix6<f64>, by: &Matrix6x3<f64>) -> [Matrix3<f64>; 2] {
        let section = damping * by;
        [0, 3].map(|row| self.strain.point.r * section.fixed_view::<3, 3>(row, 0))
    }
}

impl Element for ViscousBeam {
    fn label(&self) -> &str {
        &self.label
    }

    fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    fn residual(&self, at: &Local<'_>, out: &mut LocalResidual) {
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        for (point, neighbors) in self.points.iter().zip(NEIGHBORS) {
            let internal = point.internal(&nodal, at.nodes);
            let forces = [&internal.force, &internal.moment];
            add_forces(&nodal, &internal.strain.point.p, forces, neighbors, out);
        }
    }

    fn jacobian(&self, at: &Local<'_>, out: &mut LocalJacobian) {
        const UNKNOWNS: [Variable; 2] = [Variable::Position, Variable::Rotation];
        const RATES: [Variable; 2] = [Variable::Velocity, Variable::AngularVelocity];
        let nodal = NodalKinematics::new(&self.geometry, at.nodes);
        let offset = nodal.offset_skew();
        for (point, (plus, minus)) in self.points.iter().zip(NEIGHBORS) {
            let internal = point.internal(&nodal, at.nodes);
            let by_unknowns = internal.strain.rate_variation(at.nodes);
            let (force, moment) = (skew(&internal.force), skew(&internal.moment));
            for (node, sign) in [(plus, 1.0), (minus, -1.0)] {
                let arm = skew(&(internal.strain.point.p - nodal.x[node]));
                for j in 0..3 {
                    let own = if j == node { 1.0 } else { 0.0 };
                    let n = point.shape.n[j];
                    let theta = internal.strain.theta[j];
                    let lever = [force * (n - own), -force * offset[j] * n];
                    let turning = [Matrix3::zeros(), theta];
                    for k in 0..2 {
                        let [mut f, mut m] = internal.turned(&point.damping, &by_unknowns[j][k]);
                        f -= force * turning[k];
                        m += arm * f - moment * turning[k] - lever[k];
                        out.add((node, Force), (j, UNKNOWNS[k]), &(sign * f));
                        out.add((node, Moment), (j, UNKNOWNS[k]), &(sign * m));

                        let [f, m] = internal.turned(&point.damping, &internal.variation[j][k]);
                        out.add((node, Force), (j, RATES[k]), &(sign * f));
                        out.add((node, Moment), (j, RATES[k]), &(sign * (m + arm * f)));
                    }
                }
            }
        }
    }
}
