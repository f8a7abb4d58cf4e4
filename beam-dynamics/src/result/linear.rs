//! A linear model.

use nalgebra::{Complex, DMatrix};

/// A state, an input or an output.
#[derive(Debug, Clone, PartialEq)]
pub struct LinearVariable {
    /// Name.
    pub name: String,
    /// SI unit, `-` for a plain number.
    pub unit: String,
    /// Value at the point of operation [its unit]; `None` for states, which are changes.
    pub value: Option<f64>,
}

/// The linear model `x' = A x + B u`, `y = C x + D u` of changes about a point of operation.
#[derive(Debug, Clone, PartialEq)]
pub struct LinearModel {
    /// Name of the model.
    pub name: String,
    /// The point of operation, as text.
    pub about: String,
    /// Rotor speed [rad/s].
    pub speed: f64,
    /// The states x.
    pub states: Vec<LinearVariable>,
    /// The inputs u.
    pub inputs: Vec<LinearVariable>,
    /// The outputs y.
    pub outputs: Vec<LinearVariable>,
    /// A: rates of the states by the states [SI units].
    pub a: DMatrix<f64>,
    /// B: rates of the states by the inputs [SI units].
    pub b: DMatrix<f64>,
    /// C: outputs by the states [SI units].
    pub c: DMatrix<f64>,
    /// D: outputs by the inputs [SI units].
    pub d: DMatrix<f64>,
    /// Eigenvalues of A by ascending size [1/s].
    pub eigenvalues: Vec<Complex<f64>>,
    /// Largest remainder of an equation of the full model for the motions of this one, relative to
    /// its terms [-].
    pub residual: f64,
    /// Remarks.
    pub remarks: Vec<String>,
}
