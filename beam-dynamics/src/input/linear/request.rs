//! The request of a linear model, from outside the file.

/// The analysis whose equilibrium is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LinearChoice {
    /// Of `[modes]`.
    Modes,
    /// Of `[static]`.
    Static,
    /// Of `[trim]`.
    Trim,
    /// The motion of `[periodic]`, in multiblade coordinates averaged over it.
    Periodic,
}

/// Names of inputs and outputs, and the equilibrium.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LinearRequest {
    /// Names of drives, and of controls of the trim.
    pub inputs: Vec<String>,
    /// Names of sensors, of outputs and actuators, and of columns.
    pub outputs: Vec<String>,
    /// Rotor speed, if it is not the one of the analysis [rad/s].
    pub speed: Option<f64>,
    /// The analysis whose equilibrium is meant; `None`: the one that the file has.
    pub about: Option<LinearChoice>,
}
