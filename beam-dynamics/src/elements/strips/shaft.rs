//! The axis of the shaft of a rotor, and distances from it.
//!
//! With the axis n through c, which is at o from the node that carries it, and `d = x - c`:
//!
//! ```text
//! r   = |d - n (n . d)|                          e = (d - n (n . d)) / r
//! d r = e . (d x - d x_h) + [ e^T [o]x + (n . d)/r d^T [n]x ] theta_h
//! ```

use nalgebra::{RowVector3, Vector3};
use shared_geom::rotation::skew;

use crate::model::NodeMotion;

/// The axis of the shaft of a rotor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shaft {
    /// A point of the axis: in the frame, or from the hub's node and in its axes [m].
    pub center: Vector3<f64>,
    /// Direction, a unit vector in the same axes \[-\].
    pub axis: Vector3<f64>,
}

/// The shaft at a state.
#[derive(Debug, Clone, Copy)]
pub(super) struct ShaftState {
    /// c, model axes [m].
    pub center: Vector3<f64>,
    /// n, model axes \[-\].
    pub axis: Vector3<f64>,
    /// o, model axes [m].
    pub offset: Vector3<f64>,
}

/// Distance of a point from the axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct Distance {
    /// r [m].
    pub radius: f64,
    /// `d r / d x`; zero on the axis \[-\].
    pub by_point: RowVector3<f64>,
    /// d [m].
    pub from_center: Vector3<f64>,
}

impl Shaft {
    /// The shaft at the motion of the node that carries it, or in the frame.
    pub(super) fn at(&self, hub: Option<&NodeMotion>) -> ShaftState {
        let Some(hub) = hub else {
            return ShaftState {
                center: self.center,
                axis: self.axis,
                offset: Vector3::zeros(),
            };
        };
        let offset = hub.rotation * self.center;
        ShaftState {
            center: hub.position + offset,
            axis: hub.rotation * self.axis,
            offset,
        }
    }
}

impl ShaftState {
    /// The distance of a point.
    pub fn distance(&self, point: &Vector3<f64>) -> Distance {
        let from_center = point - self.center;
        let across = from_center - self.axis * self.axis.dot(&from_center);
        let radius = across.norm();
        Distance {
            radius,
            by_point: if radius > 0.0 {
                across.transpose() / radius
            } else {
                RowVector3::zeros()
            },
            from_center,
        }
    }

    /// Derivative of a distance by the rotation of the node that carries the shaft.
    pub fn by_turn(&self, of: &Distance) -> RowVector3<f64> {
        let by_center = of.by_point * skew(&self.offset);
        if of.radius == 0.0 {
            return by_center;
        }
        let along = self.axis.dot(&of.from_center);
        by_center + (along / of.radius) * (of.from_center.transpose() * skew(&self.axis))
    }
}
