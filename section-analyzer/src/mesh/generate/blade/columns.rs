//! Positions along the contour at which cells begin and end.
//!
//! The length h(u) of the cells is the requested one, shorter if the surface turns, and
//! changes slowly; between two landmarks the positions follow from
//!
//! ```text
//! int_0^u du / h = i I / n ,      n = I rounded up ,      h = min(size, turn / b)
//! ```
//!
//! with as many cells on the upper as on the lower surface.

use super::Sizes;
use super::contour::{Contour, Half};
use super::problem::{BladeProblem, MOST_CELLS};

/// Number of positions on each surface at which the length of cells is evaluated.
const SAMPLES: usize = 4000;
/// Growth of the length of cells along the contour: 20 % from one to the next.
const GROWTH: f64 = 0.2;
/// Smallest number of cells between two landmarks.
const LEAST: usize = 2;

/// The positions, in pairs.
#[derive(Debug)]
pub(super) struct Columns {
    /// On the upper surface, from the trailing edge to the nose.
    pub upper: Vec<f64>,
    /// On the lower surface, in the same order.
    pub lower: Vec<f64>,
    /// The position of each landmark.
    pub landmarks: Vec<usize>,
}

/// The sum of 1/h along a surface.
struct Progress {
    positions: Vec<f64>,
    sums: Vec<f64>,
}

impl Progress {
    /// From the trailing edge to the nose.
    fn new(contour: &Contour, half: Half, sizes: &Sizes) -> Self {
        let mut range = contour.range(half);
        if half == Half::Lower {
            range.reverse();
        }
        let [from, to] = range;
        let positions: Vec<f64> = (0..=SAMPLES)
            .map(|i| from + (to - from) * i as f64 / SAMPLES as f64)
            .collect();
        let mut lengths: Vec<f64> = positions
            .iter()
            .map(|&u| {
                let turned = sizes.turn / contour.bend(u).abs().max(f64::MIN_POSITIVE);
                turned.clamp(1e-4 * sizes.size, sizes.size)
            })
            .collect();
        let most = GROWTH * ((to - from) / SAMPLES as f64).abs();
        for i in 1..=SAMPLES {
            lengths[i] = lengths[i].min(lengths[i - 1] + most);
        }
        for i in (0..SAMPLES).rev() {
            lengths[i] = lengths[i].min(lengths[i + 1] + most);
        }
        let mut sums = vec![0.0];
        for i in 0..SAMPLES {
            let step = (positions[i + 1] - positions[i]).abs();
            let mean = 0.5 * (1.0 / lengths[i] + 1.0 / lengths[i + 1]);
            sums.push(sums[i] + step * mean);
        }
        Self { positions, sums }
    }

    fn at(&self, u: f64) -> f64 {
        interpolated(&self.positions, &self.sums, u)
    }

    fn position(&self, sum: f64) -> f64 {
        interpolated(&self.sums, &self.positions, sum)
    }
}

/// Linear between points whose abscissas ascend or descend.
fn interpolated(x: &[f64], f: &[f64], at: f64) -> f64 {
    let is_ascending = x[x.len() - 1] > x[0];
    let behind = x.partition_point(|x| (*x < at) == is_ascending && *x != at);
    let i = behind.clamp(1, x.len() - 1);
    let part = (at - x[i - 1]) / (x[i] - x[i - 1]);
    f[i - 1] + part * (f[i] - f[i - 1])
}

impl Columns {
    /// Columns between landmarks on the two surfaces; the first landmark is the trailing
    /// edge and the last the nose.
    ///
    /// # Errors
    /// Too many cells.
    pub fn new(
        contour: &Contour,
        landmarks: &[[f64; 2]],
        sizes: &Sizes,
    ) -> Result<Self, BladeProblem> {
        let progress = Half::BOTH.map(|half| Progress::new(contour, half, sizes));
        let sums: Vec<[f64; 2]> = landmarks
            .iter()
            .map(|positions| [0, 1].map(|i| progress[i].at(positions[i])))
            .collect();
        let whole = sums[sums.len() - 1].iter().copied().fold(0.0, f64::max);
        if whole > MOST_CELLS as f64 {
            let found = whole as usize;
            return Err(BladeProblem::TooManyCells { found });
        }
        let mut columns = Self {
            upper: vec![landmarks[0][0]],
            lower: vec![landmarks[0][1]],
            landmarks: vec![0],
        };
        for (ends, marks) in sums.windows(2).zip(landmarks.windows(2)) {
            let lengths = [0, 1].map(|i| ends[1][i] - ends[0][i]);
            let count = (lengths[0].max(lengths[1]) - 1e-6).ceil().max(0.0) as usize;
            let count = count.max(LEAST);
            for step in 1..count {
                let part = step as f64 / count as f64;
                let position = |i: usize| progress[i].position(ends[0][i] + part * lengths[i]);
                columns.upper.push(position(0));
                columns.lower.push(position(1));
            }
            columns.upper.push(marks[1][0]);
            columns.lower.push(marks[1][1]);
            columns.landmarks.push(columns.upper.len() - 1);
        }
        Ok(columns)
    }

    /// The last column, at the nose.
    pub fn nose(&self) -> usize {
        self.upper.len() - 1
    }

    /// The position of a column on a surface.
    pub fn at(&self, half: Half, column: usize) -> f64 {
        match half {
            Half::Upper => self.upper[column],
            Half::Lower => self.lower[column],
        }
    }
}
