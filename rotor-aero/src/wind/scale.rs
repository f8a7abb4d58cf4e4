//! Deviations of a turbulence box from its mean over time, scaled: `v' = m + k (v - m)`.

/// Mean over time and factor of the deviations.
#[derive(Debug)]
pub(super) struct Scale {
    /// Mean, in the order of the grid \[m/s\].
    pub mean: Vec<f64>,
    /// Factor \[-\].
    pub factor: f64,
}

impl Scale {
    /// Scales the values of a plane.
    pub fn apply(&self, values: &mut [f64]) {
        for (value, mean) in values.iter_mut().zip(&self.mean) {
            *value = mean + self.factor * (*value - mean);
        }
    }
}
