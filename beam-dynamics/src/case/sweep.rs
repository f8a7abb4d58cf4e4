//! Values of a parameter of the file.

/// Values of a parameter at which an analysis is made in turn.
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    /// Name of the parameter.
    pub parameter: String,
    /// Its values \[its unit\].
    pub values: Vec<f64>,
}
