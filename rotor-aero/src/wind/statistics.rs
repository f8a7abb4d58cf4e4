//! Statistics of turbulence boxes over time, and boxes scaled to a standard deviation.
//!
//! ```text
//! v' = m + k (v - m),   k = sigma / s
//! ```
//!
//! m is the mean over all planes at each point and of each component; s is the standard deviation of
//! u at the grid point nearest the hub. v and w have the factor of u.

use super::problem::WindProblem;
use super::scale::Scale;
use super::turbulence::TurbulenceBox;

/// Mean and standard deviation over the planes of a box.
#[derive(Debug, Clone, PartialEq)]
pub struct BoxStatistics {
    /// Mean, in the order of the grid \[m/s\].
    pub mean: Vec<f64>,
    /// Mean of u at the grid point nearest the hub \[m/s\].
    pub hub_speed: f64,
    /// Standard deviation of u there \[m/s\].
    pub hub_sigma: f64,
}

impl TurbulenceBox {
    /// Mean and standard deviation, from all planes.
    ///
    /// # Errors
    /// A file that can no longer be read.
    pub fn statistics(&self) -> Result<BoxStatistics, WindProblem> {
        let grid = self.grid();
        let steps = (grid.hub_height - grid.bottom) / grid.vertical_step;
        let row = (steps.round().max(0.0) as usize).min(grid.vertical.saturating_sub(1));
        let hub = grid.index(grid.lateral / 2, row);
        let count = grid.planes.max(1) as f64;
        let (mut mean, mut series) = (vec![0.0; grid.values()], Vec::new());
        for index in 0..grid.planes {
            let plane = self.plane(index)?;
            for (sum, value) in mean.iter_mut().zip(plane.iter()) {
                *sum += value / count;
            }
            series.push(plane.get(hub).copied().unwrap_or_default());
        }
        let hub_speed = mean.get(hub).copied().unwrap_or_default();
        let squares = series.iter().map(|value| (value - hub_speed).powi(2));
        Ok(BoxStatistics {
            hub_speed,
            hub_sigma: (squares.sum::<f64>() / count).sqrt(),
            mean,
        })
    }

    /// The same box with its deviations from the mean multiplied, so that u at the hub has a standard
    /// deviation `sigma` \[m/s\]; `statistics` are its own, whose standard deviation is above zero.
    #[must_use]
    pub fn scaled_to(self, sigma: f64, statistics: BoxStatistics) -> Self {
        let factor = sigma / statistics.hub_sigma;
        self.with_scale(Scale {
            mean: statistics.mean,
            factor,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wind::grid::tests::{random, small};

    #[test]
    fn a_scaled_box_has_its_mean_and_the_given_deviation() {
        let values = random(small(12, true), 5);
        let own = TurbulenceBox::from_values("box", values.clone()).unwrap();
        let before = own.statistics().unwrap();
        let scaled = own.scaled_to(3.0, before.clone());
        let after = scaled.statistics().unwrap();
        assert!((after.hub_sigma - 3.0).abs() < 1e-12);
        let pairs = after.mean.iter().zip(&before.mean);
        assert!(pairs.clone().all(|(a, b)| (a - b).abs() < 1e-12));
        // v at any point has the factor of u at the hub
        let [there, here] = [scaled.plane(4).unwrap()[7], values.planes[4][7]];
        let expected = before.mean[7] + 3.0 / before.hub_sigma * (here - before.mean[7]);
        assert!((there - expected).abs() < 1e-12);
    }
}
