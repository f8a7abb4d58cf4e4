//! The radius of the tip of a blade as an unknown that its strips share.
//!
//! With the tip at x, and the shaft axis n through c (see [`super::kinematics`]),
//!
//! ```text
//! R - |d - n (n . d)| = 0                        d = x - c
//! ```

use nalgebra::{Matrix3, RowVector3, Vector3};
use shared_geom::rotation::skew;

use super::kinematics::Shaft;
use crate::elements::{Element, Local, LocalJacobian, LocalResidual};
use crate::model::{Quantity, Scalar, ScalarSpec, ScalarStart, Variable};

/// Sensor of the radius of the tip of a blade.
#[derive(Debug, Clone)]
pub struct TipRadius {
    label: String,
    /// The tip, and the node of the hub if it moves.
    nodes: Vec<usize>,
    shaft: Shaft,
    scalars: [Scalar; 1],
}

impl TipRadius {
    /// The radius of node `tip` about a shaft, which the node `hub` carries, or the frame.
    pub fn new(label: impl Into<String>, tip: usize, shaft: Shaft, hub: Option<usize>) -> Self {
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
        let axes = at
            .nodes
            .get(1)
            .map_or_else(Matrix3::identity, |hub| hub.rotation);
        let origin = at
            .nodes
            .get(1)
            .map_or_else(Vector3::zeros, |hub| hub.position);
        let n = axes * self.shaft.axis;
        let offset = axes * self.shaft.center;
        let d = at.nodes[0].position - origin - offset;
        let across = d - n * n.dot(&d);
        let radius = across.norm();
        out.add_scalar(0, at.scalars.values[0]);
        out.add_scalar(0, -radius);
        let Some(out) = jacobian else { return };
        let radial: RowVector3<f64> = match radius > 0.0 {
            true => across.transpose() / radius,
            false => RowVector3::zeros(),
        };
        out.add_scalar(0, 0, 1.0, false);
        out.add_scalar_row(0, (0, Variable::Position), &-radial);
        if self.nodes.len() > 1 {
            out.add_scalar_row(0, (1, Variable::Position), &radial);
            let mut by_rotation = -radial * skew(&offset);
            if radius > 0.0 {
                by_rotation -= (n.dot(&d) / radius) * (d.transpose() * skew(&n));
            }
            out.add_scalar_row(0, (1, Variable::Rotation), &by_rotation);
        }
    }
}
