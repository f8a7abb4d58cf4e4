//! The place of a rotor, and what holds the node of its shaft.

use nalgebra::{Matrix3, Vector3};
use shared_geom::document::{Card, Content};

use crate::input::rotors::base::Base;

/// The place of a rotor.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::input::rotors) struct Place {
    /// Center of the hub \[m\].
    pub center: Vector3<f64>,
    /// Axis of the shaft in the sense of rotation.
    pub axis: Vector3<f64>,
    /// Direction of azimuth zero.
    pub aft: Vector3<f64>,
}

/// The axes whose x is a direction and whose y is as near as possible to another one.
pub(super) fn axes_along(x: &Vector3<f64>, y: &Vector3<f64>) -> Matrix3<f64> {
    let x = x.normalize();
    let y = (y - x * x.dot(y)).normalize();
    Matrix3::from_columns(&[x, y, x.cross(&y)])
}

/// The card that holds a node on another one, or on the frame of the model.
pub(super) fn held(base: &Base, node: &str, below: Option<&str>) -> Card {
    match below {
        Some(below) => base
            .listed("rigid")
            .with("name", format!("{node} attachment"))
            .with("nodes", Content::texts([below, node])),
        None => base.listed("clamp").with("node", node),
    }
}
