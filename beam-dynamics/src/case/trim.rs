//! The requested trim: numbers that are found so that quantities have given values.

use super::Sweep;

/// Search of the controls.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TrimMethod {
    /// Newton's method for the periodic motion with the controls.
    Shooting,
    /// Integration over periods with an auto-pilot.
    AutoPilot,
    /// The equilibrium of the turning frame with the controls.
    Equilibrium,
}

/// A number that is found.
#[derive(Debug, Clone, PartialEq)]
pub struct TrimControl {
    /// Name.
    pub name: String,
    /// Label of the element whose state it is; of a parameter its name.
    pub label: String,
    /// Size relative to which changes are measured \[its unit\].
    pub scale: f64,
    /// Least and largest value, infinite without bounds \[its unit\].
    pub bounds: [f64; 2],
    /// Largest change in an iteration \[its unit\].
    pub step: f64,
}

/// A quantity that must have a value.
#[derive(Debug, Clone, PartialEq)]
pub struct TrimTarget {
    /// Name.
    pub name: String,
    /// Label of the element that integrates or reads the quantity.
    pub label: String,
    /// The required value [unit of the quantity].
    pub value: f64,
    /// Size relative to which errors are measured [unit of the quantity].
    pub scale: f64,
}

/// An auto-pilot: with the targets' errors e after a filter of first order and the derivative J of the
/// targets by the controls, `u' = -G J^-1 e`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AutoPilot {
    /// G, per period [-].
    pub gain: f64,
    /// Time constant of the filter, in periods [-].
    pub filter: f64,
    /// Largest error relative to its size at the end [-].
    pub tolerance: f64,
}

/// The requested trim.
#[derive(Debug, Clone, PartialEq)]
pub struct TrimSettings {
    /// The method.
    pub method: TrimMethod,
    /// Rotor speed of an equilibrium [rad/s].
    pub speed: f64,
    /// Largest error of the targets of parameters, relative to their sizes [-].
    pub tolerance: f64,
    /// Largest number of iterations for parameters.
    pub iterations: usize,
    /// Controls that are unknowns of the model.
    pub controls: Vec<TrimControl>,
    /// Controls that are parameters of the file, which is read again for each of their values.
    pub parameters: Vec<TrimControl>,
    /// Their values in the file \[any unit\].
    pub guesses: Vec<f64>,
    /// Targets: the ones of the controls, then the ones of the parameters.
    pub targets: Vec<TrimTarget>,
    /// The sweep, if one is requested.
    pub sweep: Option<Sweep>,
}
