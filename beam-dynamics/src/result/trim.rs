//! Results of a trim.

/// The trim at one value of the sweep, or the only one.
#[derive(Debug, Clone, PartialEq)]
pub struct TrimPoint {
    /// Value of the parameter of the sweep, if there is one \[its unit\].
    pub at: Option<f64>,
    /// Values of the controls \[unit of each\].
    pub controls: Vec<f64>,
    /// Values of the targets, found and required \[unit of each\]; empty if none were found.
    pub targets: Vec<[f64; 2]>,
    /// Iterations, or periods of an auto-pilot, of all searches.
    pub iterations: usize,
    /// Largest remaining change of the motion or the equilibrium, and error of a target, relative to its
    /// size [-].
    pub residual: f64,
    /// Reason if the targets are not met, with the remedy.
    pub failure: Option<[String; 2]>,
}

/// The trim of a model.
#[derive(Debug, Clone, PartialEq)]
pub struct TrimResult {
    /// Name of the model.
    pub name: String,
    /// Words for the method.
    pub method: &'static str,
    /// Name of the parameter of the sweep, if there is one.
    pub sweep: Option<String>,
    /// Number of requested points.
    pub requested: usize,
    /// Names of the controls.
    pub controls: Vec<String>,
    /// Names of the targets.
    pub targets: Vec<String>,
    /// The points in their order; the last one may have failed.
    pub points: Vec<TrimPoint>,
    /// Remarks.
    pub remarks: Vec<String>,
}

impl TrimResult {
    /// The points at which the targets are met.
    pub fn met(&self) -> impl Iterator<Item = &TrimPoint> {
        self.points.iter().filter(|point| point.failure.is_none())
    }
}
