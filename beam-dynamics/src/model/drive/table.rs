//! Drives that are interpolated between given times.
//!
//! Between two times h apart, with `b = (t - t_k)/h`, `a = 1 - b` and the second
//! derivatives M of the natural cubic spline (zero everywhere for straight pieces), the
//! value is (D-192)
//!
//! ```text
//! y = a y_k + b y_(k+1) + h^2/6 [(a^3 - a) M_k + (b^3 - b) M_(k+1)]
//! ```
//!
//! and M follows from continuity of the slope, a tridiagonal system, solved by
//! elimination (it is diagonally dominant):
//!
//! ```text
//! h_(k-1) M_(k-1) + 2 (h_(k-1) + h_k) M_k + h_k M_(k+1)
//!     = 6 [(y_(k+1) - y_k)/h_k - (y_k - y_(k-1))/h_(k-1)]
//! ```

use super::DriveValue;

/// What lies between the given values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interpolation {
    /// Straight lines.
    Linear,
    /// The natural cubic spline.
    Spline,
}

/// What holds before the first and after the last time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outside {
    /// There is no value.
    Error,
    /// The first, or the last, value.
    Hold,
}

/// Why rows are no table of a drive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TableProblem {
    /// Fewer than two rows.
    Few {
        /// Number of rows.
        found: usize,
    },
    /// A time that does not come after the one before.
    NotRising {
        /// Row, from zero.
        row: usize,
    },
    /// A number that is not finite.
    NotFinite {
        /// Row, from zero.
        row: usize,
    },
}

/// Values at given times.
#[derive(Debug, Clone, PartialEq)]
pub struct DriveTable {
    times: Vec<f64>,
    values: Vec<f64>,
    /// Second derivatives at the times.
    bends: Vec<f64>,
    interpolation: Interpolation,
    outside: Outside,
}

impl DriveTable {
    /// The table of `rows` of time \[s\] and value.
    ///
    /// # Errors
    /// [`TableProblem`]: fewer than two rows, or times that do not rise.
    pub fn new(
        rows: &[[f64; 2]],
        interpolation: Interpolation,
        outside: Outside,
    ) -> Result<Self, TableProblem> {
        let found = rows.len();
        if found < 2 {
            return Err(TableProblem::Few { found });
        }
        if let Some(row) = rows
            .iter()
            .position(|row| !row.iter().all(|n| n.is_finite()))
        {
            return Err(TableProblem::NotFinite { row });
        }
        if let Some(row) = rows.windows(2).position(|pair| pair[1][0] <= pair[0][0]) {
            return Err(TableProblem::NotRising { row: row + 1 });
        }
        let times: Vec<_> = rows.iter().map(|row| row[0]).collect();
        let values: Vec<_> = rows.iter().map(|row| row[1]).collect();
        let bends = match interpolation {
            Interpolation::Linear => vec![0.0; found],
            Interpolation::Spline => bends(&times, &values),
        };
        Ok(Self {
            times,
            values,
            bends,
            interpolation,
            outside,
        })
    }

    fn ends(&self) -> [f64; 2] {
        [self.times[0], self.times[self.times.len() - 1]]
    }

    pub(super) fn domain(&self) -> [f64; 2] {
        match self.outside {
            Outside::Error => self.ends(),
            Outside::Hold => super::Drive::ALWAYS,
        }
    }

    pub(super) fn at(&self, time: f64) -> DriveValue {
        let [first, last] = self.ends();
        let end = self.times.len() - 1;
        if time < first || time > last || (time == last && self.outside == Outside::Hold) {
            return DriveValue::constant(match self.outside {
                Outside::Error => f64::NAN,
                Outside::Hold if time < first => self.values[0],
                Outside::Hold => self.values[end],
            });
        }
        let k = self.times.partition_point(|own| *own <= time);
        self.inside(k.clamp(1, end) - 1, time)
    }

    fn inside(&self, k: usize, time: f64) -> DriveValue {
        let h = self.times[k + 1] - self.times[k];
        let b = (time - self.times[k]) / h;
        let a = 1.0 - b;
        let [y0, y1] = [self.values[k], self.values[k + 1]];
        let [m0, m1] = [self.bends[k], self.bends[k + 1]];
        let bend = (a * a * a - a) * m0 + (b * b * b - b) * m1;
        let slope = (1.0 - 3.0 * a * a) * m0 + (3.0 * b * b - 1.0) * m1;
        DriveValue {
            value: a * y0 + b * y1 + h * h / 6.0 * bend,
            rate: (y1 - y0) / h + h / 6.0 * slope,
            acceleration: a * m0 + b * m1,
        }
    }

    pub(super) fn next_corner(&self, time: f64) -> f64 {
        let next = match self.interpolation {
            Interpolation::Spline => self.ends().into_iter().find(|own| *own > time),
            Interpolation::Linear => {
                let k = self.times.partition_point(|own| *own <= time);
                self.times.get(k).copied()
            }
        };
        next.unwrap_or(f64::INFINITY)
    }
}

/// Second derivatives of the natural spline at its points.
fn bends(x: &[f64], y: &[f64]) -> Vec<f64> {
    let n = x.len();
    let slope = |k: usize| (y[k + 1] - y[k]) / (x[k + 1] - x[k]);
    let mut diagonal = vec![1.0; n];
    let mut right = vec![0.0; n];
    for k in 1..n - 1 {
        let [before, after] = [x[k] - x[k - 1], x[k + 1] - x[k]];
        // The row above has been divided out already; the first one is M_0 = 0.
        let above = if k == 1 {
            0.0
        } else {
            before / diagonal[k - 1]
        };
        diagonal[k] = 2.0 * (before + after) - above * before;
        right[k] = 6.0 * (slope(k) - slope(k - 1)) - above * right[k - 1];
    }
    let mut bends = vec![0.0; n];
    for k in (1..n - 1).rev() {
        bends[k] = (right[k] - (x[k + 1] - x[k]) * bends[k + 1]) / diagonal[k];
    }
    bends
}
