//! A point of the line of a beam that carries a load, as seen from outside of the beam.

use nalgebra::Vector3;

use super::attachment::BeamGeometry;
use super::forces::LineForce;
use super::interpolation::{NodalKinematics, Shape};
use super::mass::portion_of;
use super::strain::SectionPoint;
use crate::elements::LocalJacobian;
use crate::elements::carried::{CarriedPoint, Share};
use crate::model::{Node, NodeMotion};

/// A point of the line of a beam.
#[derive(Debug, Clone)]
pub(in crate::elements) struct LinePoint {
    geometry: BeamGeometry,
    /// Portion of a finite volume, hence node, to which it belongs.
    portion: usize,
    shape: Shape,
    /// Undeformed length per unit of xi [m].
    j0: f64,
}

/// The point at a state of the nodes of the beam.
pub(in crate::elements) struct LineState<'a> {
    point: &'a LinePoint,
    nodal: NodalKinematics,
}

impl LinePoint {
    /// The point at xi of a beam on `undeformed` nodes.
    pub fn new(geometry: BeamGeometry, undeformed: &[&Node; 3], xi: f64) -> Self {
        Self {
            geometry,
            portion: portion_of(xi),
            shape: Shape::at(xi),
            j0: geometry.reference_point(undeformed, xi).j0,
        }
    }

    /// The point at the motion of the three nodes.
    pub fn at(&self, nodes: &[NodeMotion]) -> LineState<'_> {
        LineState {
            point: self,
            nodal: NodalKinematics::new(&self.geometry, nodes),
        }
    }
}

impl LineState<'_> {
    fn section(&self) -> SectionPoint<'_> {
        SectionPoint::new(&self.nodal, &self.point.shape, self.point.j0)
    }

    /// Its kinematics, and the shares of its loads that the nodes carry.
    pub fn carried(&self) -> CarriedPoint {
        let section = self.section();
        let formulation = self.point.geometry.formulation;
        let loads = formulation.shares(self.point.portion, &section);
        let shares = std::array::from_fn(|j| Share {
            weight: self.point.shape.n[j],
            offset: self.nodal.f[j],
            turn: section.theta[j],
            load: loads[j],
        });
        CarriedPoint {
            position: section.point.p,
            rotation: section.point.r,
            shares,
            count: 3,
        }
    }

    /// Adds the variation of the forces on the nodes with the geometry, at fixed force and moment.
    pub fn add_variation(
        &self,
        force: &Vector3<f64>,
        moment: &Vector3<f64>,
        out: &mut LocalJacobian,
    ) {
        let formulation = self.point.geometry.formulation;
        // With the axes of the model.
        let load = LineForce {
            force: *force,
            moment: *moment,
            by_rotation: None,
        };
        formulation.add_on_line_variation(self.point.portion, &self.section(), &load, out);
    }
}
