//! A checked question to the engine: the model and what is asked of it.

use nalgebra::Vector3;

use crate::assembly::System;
use crate::model::NamingAxes;

/// How the model's frame turns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spin {
    /// Axis of rotation, of unit length [-].
    pub axis: Vector3<f64>,
    /// A point of the axis [m].
    pub center: Vector3<f64>,
}

impl Default for Spin {
    /// About z through the origin.
    fn default() -> Self {
        Self {
            axis: Vector3::z(),
            center: Vector3::zeros(),
        }
    }
}

/// Modes over rotor speed.
#[derive(Debug)]
pub struct ModesCase {
    /// Name, for tables and plots.
    pub name: String,
    /// The model.
    pub system: System,
    /// Axes for naming, one a node.
    pub naming: Vec<NamingAxes>,
    /// What turns.
    pub spin: Spin,
    /// Rotor speeds, ascending, without doubles [rad/s].
    pub speeds: Vec<f64>,
    /// Number of modes to report at each speed.
    pub count: usize,
}
