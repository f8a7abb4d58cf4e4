//! Drives interpolated between given times: by the natural cubic spline (D-192),
//! or linearly.

use shared_geom::spline::Spline;

use super::DriveValue;

/// Interpolation between the given values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interpolation {
    /// Straight lines.
    Linear,
    /// The natural cubic spline.
    Spline,
}

/// Extrapolation before the first and after the last time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extrapolation {
    /// There is no value.
    Error,
    /// The first, or the last, value.
    Hold,
}

/// Reasons why rows are not a table of a drive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TableProblem {
    /// Fewer than two rows.
    Few {
        /// Number of rows.
        found: usize,
    },
    /// A time that is not after the previous one.
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
    line: Spline,
    interpolation: Interpolation,
    extrapolation: Extrapolation,
}

impl DriveTable {
    /// The table of `rows` of time \[s\] and value.
    ///
    /// # Errors
    /// [`TableProblem`]: fewer than two rows, or times that do not increase.
    pub fn new(
        rows: &[[f64; 2]],
        interpolation: Interpolation,
        extrapolation: Extrapolation,
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
        let line = match interpolation {
            Interpolation::Linear => Spline::straight(&times, &values),
            Interpolation::Spline => Spline::new(&times, &values),
        };
        Ok(Self {
            line,
            interpolation,
            extrapolation,
        })
    }

    fn ends(&self) -> [f64; 2] {
        let times = self.line.positions();
        [times[0], times[times.len() - 1]]
    }

    pub(super) fn domain(&self) -> [f64; 2] {
        match self.extrapolation {
            Extrapolation::Error => self.ends(),
            Extrapolation::Hold => super::Drive::ALWAYS,
        }
    }

    pub(super) fn at(&self, time: f64) -> DriveValue {
        let [first, last] = self.ends();
        let values = self.line.values();
        if time < first
            || time > last
            || (time == last && self.extrapolation == Extrapolation::Hold)
        {
            return DriveValue::constant(match self.extrapolation {
                Extrapolation::Error => f64::NAN,
                Extrapolation::Hold if time < first => values[0],
                Extrapolation::Hold => values[values.len() - 1],
            });
        }
        let k = self.line.interval(time);
        DriveValue {
            value: self.line.value(k, time),
            rate: self.line.slope(k, time),
            acceleration: self.line.bend(k, time),
        }
    }

    pub(super) fn next_corner(&self, time: f64) -> f64 {
        let next = match self.interpolation {
            Interpolation::Spline => self.ends().into_iter().find(|own| *own > time),
            Interpolation::Linear => {
                let times = self.line.positions();
                times
                    .get(times.partition_point(|own| *own <= time))
                    .copied()
            }
        };
        next.unwrap_or(f64::INFINITY)
    }
}
