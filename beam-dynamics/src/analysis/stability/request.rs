//! The request of a scan over a parameter.

use crate::result::StabilityRoot;

/// The roots at a value of the parameter, or the reason why there are none with a remedy.
pub type Evaluate<'a> = &'a mut dyn FnMut(f64) -> Result<Vec<StabilityRoot>, [String; 2]>;

/// Values and boundaries of a parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct ScanSettings {
    /// The values, which all increase or all decrease \[unit of the parameter\].
    pub values: Vec<f64>,
    /// Whether boundaries are searched.
    pub boundaries: bool,
    /// Largest error of a boundary \[unit of the parameter\].
    pub tolerance: f64,
}

impl ScanSettings {
    /// Distance of the first and the last value \[unit of the parameter\].
    pub(super) fn range(&self) -> f64 {
        let ends = self.values.first().zip(self.values.last());
        ends.map_or(0.0, |(first, last)| (last - first).abs())
    }
}
