//! The requested linear model.

use crate::model::Scalar;

/// The state about which a model is linearized.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LinearAbout {
    /// The equilibrium in the turning frame.
    Equilibrium {
        /// Rotor speed [rad/s].
        speed: f64,
        /// Factor of the proportional loads [-].
        proportional: f64,
    },
    /// The equilibrium of the trim.
    Trim,
    /// The periodic motion, in multiblade coordinates averaged over it.
    Period,
}

/// An input or an output.
#[derive(Debug, Clone, PartialEq)]
pub struct LinearPort {
    /// Name.
    pub name: String,
    /// Its SI unit, `-` for a plain number.
    pub unit: String,
    /// The unknown of the model; an input replaces its equation.
    pub scalar: Scalar,
}

/// The requested linear model.
#[derive(Debug, Clone, PartialEq)]
pub struct LinearSettings {
    /// The state about which the model is linearized.
    pub about: LinearAbout,
    /// The inputs.
    pub inputs: Vec<LinearPort>,
    /// The outputs.
    pub outputs: Vec<LinearPort>,
}
