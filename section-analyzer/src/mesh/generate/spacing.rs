//! Lengths of cells along a contour: the integral of their density.
//!
//! ```text
//! int_0^s ds / h = i I / n ,     n = I rounded up
//! ```
//!
//! are the places between the cells of an interval with the length h(s).

/// The integral of a density along an interval, over equal steps.
#[derive(Debug)]
pub(super) struct Progress {
    from: f64,
    step: f64,
    sums: Vec<f64>,
}

impl Progress {
    /// The integral from one place to another, either way, with the density in the middle of each step.
    pub fn new([from, to]: [f64; 2], densities: &[f64]) -> Self {
        let step = (to - from) / densities.len() as f64;
        let mut sums = vec![0.0];
        for (i, density) in densities.iter().enumerate() {
            sums.push(sums[i] + density * step.abs());
        }
        Self { from, step, sums }
    }

    /// The integral of the whole interval.
    pub fn whole(&self) -> f64 {
        self.sums[self.sums.len() - 1]
    }

    /// The integral up to a place.
    pub fn up_to(&self, place: f64) -> f64 {
        let part = (place - self.from) / self.step;
        let last = self.sums.len() - 2;
        let i = (part.max(0.0) as usize).min(last);
        self.sums[i] + (part - i as f64) * (self.sums[i + 1] - self.sums[i])
    }

    /// The place up to which the integral has a value.
    pub fn place(&self, value: f64) -> f64 {
        let last = self.sums.len() - 1;
        let after = self
            .sums
            .partition_point(|sum| *sum <= value)
            .clamp(1, last);
        let (low, high) = (self.sums[after - 1], self.sums[after]);
        self.from + self.step * ((after - 1) as f64 + (value - low) / (high - low))
    }
}
