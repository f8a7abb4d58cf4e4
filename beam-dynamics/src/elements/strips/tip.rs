//! The radius of the tip of a blade as an unknown that its strips share.
//!
//! With the tip at o from a node at x, and the shaft axis n through c (see [`super::shaft`]),
//!
//! ```text
//! R - |d - n (n . d)| = 0                        d = x + o - c
//! ```

use nalgebra::Vector3;
use shared_geom::rotation::skew;

use super::shaft::Shaft;
use crate::elements::{Element, Local, LocalJacobian, LocalResidual};
use crate::model::{Quantity, Scalar, ScalarSpec, ScalarStart, Variable};

/// Sensor of the radius of the tip of a blade.
#[derive(Debug, Clone)]
pub struct TipRadius {
    label: String,
    /// The node of the tip, and the node of the hub if it moves.
    nodes: Vec<usize>,
    /// The tip from its node, in the axes of the node \[m\].
    offset: Vector3<f64>,
    shaft: Shaft,
    scalars: [Scalar; 1],
}

impl TipRadius {
    /// The radius of a point, at an offset \[m\] from a node in its axes, about a shaft, which the
    /// node `hub` carries, or the frame.
    pub fn new(
        label: impl Into<String>,
        (tip, offset): (usize, Vector3<f64>),
        shaft: Shaft,
        hub: Option<usize>,
    ) -> Self {
        let label = label.into();
        let radius = Scalar::new(ScalarSpec {
            owner: label.clone(),
            unknown: Quantity::new("radius of the tip", "m", 1.0),
            equation: Quantity::new("radius of the tip", "m", 1.0),
            has_rate: false,
            rate: None,
            start: ScalarStart::Settled,
        });
        Self {
            label,
            nodes: std::iter::once(tip).chain(hub).collect(),
            offset,
            shaft,
            scalars: [radius],
        }
    }

    /// The unknown.
    pub fn scalar(&self) -> &Scalar {
        &self.scalars[0]
    }
}

impl Element for TipRadius {
    fn label(&self) -> &str {
        &self.label
    }

    fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    fn scalars(&self) -> &[Scalar] {
        &self.scalars
    }

    fn acts(&self) -> bool {
        false
    }

    fn evaluate(
        &self,
        at: &Local<'_>,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    ) {
        let shaft = self.shaft.at(at.nodes.get(1));
        let offset = at.nodes[0].rotation * self.offset;
        let distance = shaft.distance(&(at.nodes[0].position + offset));
        out.add_scalar(0, at.scalars.values[0]);
        out.add_scalar(0, -distance.radius);
        let Some(out) = jacobian else { return };
        out.add_scalar(0, 0, 1.0, false);
        out.add_scalar_row(0, (0, Variable::Position), &-distance.by_point);
        let by_turn = distance.by_point * skew(&offset);
        out.add_scalar_row(0, (0, Variable::Rotation), &by_turn);
        if self.nodes.len() > 1 {
            out.add_scalar_row(0, (1, Variable::Position), &distance.by_point);
            out.add_scalar_row(0, (1, Variable::Rotation), &-shaft.by_turn(&distance));
        }
    }
}
