//! Positions along the contour at which cells begin and end, in pairs on both sides.
//!
//! The length of the cells is the requested one, shorter if the surface turns, and changes slowly;
//! between two landmarks there are as many cells on the upper as on the lower side.

use super::super::layup::Outline;
use super::super::layup::stations::{Station, Stations};
use super::super::spacing::Progress;
use super::Sizes;
use super::contour::Contour;
use super::fill::even_cells;
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
    /// Arc lengths on the upper and the lower side, from the trailing edge to the nose.
    pub sides: [Vec<f64>; 2],
    /// The position of each landmark.
    pub landmarks: Vec<usize>,
}

/// The sum of 1/h from the trailing edge to the nose.
fn progress(contour: &Contour, side: usize, sizes: &Sizes) -> Progress {
    let [from, to] = contour.range(side);
    let step = (to - from) / SAMPLES as f64;
    let mut lengths: Vec<f64> = (0..=SAMPLES)
        .map(|i| {
            let bend = contour.outline().bend(from + step * i as f64);
            let turned = sizes.turn / bend.abs().max(f64::MIN_POSITIVE);
            turned.clamp(1e-4 * sizes.size, sizes.size)
        })
        .collect();
    let most = GROWTH * step.abs();
    for i in 1..=SAMPLES {
        lengths[i] = lengths[i].min(lengths[i - 1] + most);
    }
    for i in (0..SAMPLES).rev() {
        lengths[i] = lengths[i].min(lengths[i + 1] + most);
    }
    let density = |pair: &[f64]| 0.5 * (1.0 / pair[0] + 1.0 / pair[1]);
    let densities: Vec<f64> = lengths.windows(2).map(density).collect();
    Progress::new([from, to], &densities)
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
        let progress = [0, 1].map(|side| progress(contour, side, sizes));
        let sums: Vec<[f64; 2]> = landmarks
            .iter()
            .map(|positions| [0, 1].map(|i| progress[i].up_to(positions[i])))
            .collect();
        let whole = sums[sums.len() - 1].iter().copied().fold(0.0, f64::max);
        if whole > MOST_CELLS as f64 {
            let found = whole as usize;
            return Err(BladeProblem::TooManyCells { found });
        }
        let mut columns = Self {
            sides: landmarks[0].map(|s| vec![s]),
            landmarks: vec![0],
        };
        for (ends, marks) in sums.windows(2).zip(landmarks.windows(2)) {
            let lengths = [0, 1].map(|i| ends[1][i] - ends[0][i]);
            let count = (lengths[0].max(lengths[1]) - 1e-6).ceil().max(0.0) as usize;
            let count = count.max(LEAST);
            for step in 1..count {
                let part = step as f64 / count as f64;
                let position = |i: usize| progress[i].place(ends[0][i] + part * lengths[i]);
                (0..2).for_each(|side| columns.sides[side].push(position(side)));
            }
            (0..2).for_each(|side| columns.sides[side].push(marks[1][side]));
            columns.landmarks.push(columns.sides[0].len() - 1);
        }
        Ok(columns)
    }

    /// The last column, at the nose.
    pub fn nose(&self) -> usize {
        self.sides[0].len() - 1
    }

    /// The column on the upper side that is nearest to an arc length.
    pub fn nearest(&self, s: f64) -> usize {
        let distance = |column: &usize| (self.sides[0][*column] - s).abs();
        let columns = 0..self.sides[0].len();
        let nearest = columns.min_by(|a, b| distance(a).total_cmp(&distance(b)));
        nearest.unwrap_or(0)
    }

    /// The columns as stations along the contour, and if it is closed those on its base, an even
    /// number of cells of about this size.
    pub fn stations(&self, outline: &Outline, size: f64, is_closed: bool) -> Stations {
        let [upper, lower] = &self.sides;
        let mut all = upper.clone();
        all.extend(lower.iter().rev().skip(1));
        let perimeter = outline.perimeter();
        if is_closed && outline.base() > 0.0 {
            let count = even_cells(outline.base(), size);
            let step = outline.base() / count as f64;
            let beside = |i: usize| step * i as f64;
            let before: Vec<f64> = (0..count / 2).map(beside).collect();
            let behind: Vec<f64> = before.iter().rev().map(|s| perimeter - s).collect();
            all = [before, all, behind].concat();
        }
        let all = all.into_iter().map(|s| Station { s, pair: None });
        Stations {
            all: all.collect(),
            pairs: Vec::new(),
        }
    }
}
