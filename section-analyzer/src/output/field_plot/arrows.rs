//! Arrows along a vector field, about evenly spaced.

use std::collections::HashMap;

use plotters::backend::DrawingBackend;
use plotters::style::{BLACK, WHITE};
use shared_geom::figure::{Canvas, FigureProblem};

use super::surface::{PIECE, Sample};

/// Distance of the arrows [figure pixels].
const SPACING: f64 = 64.0;
/// Least distance of two arrows, relative to that.
const NEAREST: f64 = 0.7;
/// Size of the squares in which depth is counted: samples lie closer [figure pixels].
const DEPTH: f64 = 1.2 * PIECE;
/// Length of the longest arrow, relative to the distance.
const LONGEST: f64 = 0.92;
/// Arrows shorter than this part of the longest are left out.
const SHORTEST: f64 = 0.06;
/// Length of the head of an arrow at most [figure pixels].
const HEAD: f64 = 17.0;

/// Draws arrows at some of the samples; the longest is that of a vector of the
/// length `largest`.
pub(super) fn draw<B: DrawingBackend>(
    canvas: &Canvas<B>,
    samples: &[Sample],
    largest: f64,
) -> Result<(), FigureProblem> {
    for sample in spread(samples) {
        let [y, z] = sample.vector;
        let size = y.hypot(z) / largest;
        if size >= SHORTEST {
            let length = (LONGEST * SPACING * size).max(0.25 * SPACING);
            // z is up on the figure, where y counts down
            let direction = [y / y.hypot(z), -z / y.hypot(z)];
            draw_arrow(canvas, sample.place, direction, length)?;
        }
    }
    Ok(())
}

/// The point of the grid of arrows in whose square a place lies.
pub(super) fn grid_point(place: [f64; 2]) -> [f64; 2] {
    place.map(|value| ((value / SPACING).floor() + 0.5) * SPACING)
}

/// The sample of each square of a grid that lies nearest to its middle and deepest in
/// the section, none too near to another.
fn spread(samples: &[Sample]) -> Vec<Sample> {
    let depths = Depths::new(samples);
    let mut best: HashMap<[i64; 2], (f64, Sample)> = HashMap::new();
    for sample in samples {
        let square = sample.place.map(|value| (value / SPACING).floor() as i64);
        let off = distance(sample.place, grid_point(sample.place));
        let cost = off - 4.0 * depths.of(sample.place).min(0.5 * SPACING);
        let so_far = best.entry(square).or_insert((cost, *sample));
        if cost < so_far.0 {
            *so_far = (cost, *sample);
        }
    }
    // the best first: regular where there is room for it
    let mut found: Vec<_> = best.into_iter().collect();
    found.sort_by(|(a, (one, _)), (b, (other, _))| one.total_cmp(other).then(a.cmp(b)));
    let mut kept: HashMap<[i64; 2], Sample> = HashMap::new();
    for (square, (_, sample)) in found {
        let is_near = (0..9).any(|k| {
            let neighbor = [square[0] + k / 3 - 1, square[1] + k % 3 - 1];
            let other = kept.get(&neighbor);
            other.is_some_and(|other| distance(other.place, sample.place) < NEAREST * SPACING)
        });
        if !is_near {
            kept.insert(square, sample);
        }
    }
    let mut kept: Vec<_> = kept.into_iter().collect();
    kept.sort_by_key(|(square, _)| *square);
    kept.into_iter().map(|(_, sample)| sample).collect()
}

/// How deep in the section places lie, on a grid of squares.
struct Depths {
    /// Steps to the nearest square without a sample.
    steps: HashMap<[i64; 2], u32>,
}

impl Depths {
    fn new(samples: &[Sample]) -> Self {
        let mut steps: HashMap<_, _> = samples
            .iter()
            .map(|sample| (Self::square(sample.place), 0))
            .collect();
        let most = (0.5 * SPACING / DEPTH).ceil() as u32;
        // A square is one step deeper than the least deep of its neighbors.
        for step in 1..=most {
            let deeper: Vec<_> = steps
                .keys()
                .filter(|[i, j]| {
                    let around = [[i - 1, *j], [i + 1, *j], [*i, j - 1], [*i, j + 1]];
                    around
                        .iter()
                        .all(|square| steps.get(square).is_some_and(|found| found + 1 >= step))
                })
                .copied()
                .collect();
            for square in deeper {
                steps.insert(square, step);
            }
        }
        Self { steps }
    }

    /// Depth of a place \[figure pixels\].
    fn of(&self, place: [f64; 2]) -> f64 {
        let steps = self.steps.get(&Self::square(place));
        DEPTH * f64::from(steps.copied().unwrap_or(0))
    }

    fn square(place: [f64; 2]) -> [i64; 2] {
        place.map(|value| (value / DEPTH).floor() as i64)
    }
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// An arrow around `middle`, black with a white rim.
fn draw_arrow<B: DrawingBackend>(
    canvas: &Canvas<B>,
    middle: [f64; 2],
    direction: [f64; 2],
    length: f64,
) -> Result<(), FigureProblem> {
    let at = |along: f64, across: f64| {
        [
            middle[0] + along * direction[0] - across * direction[1],
            middle[1] + along * direction[1] + across * direction[0],
        ]
    };
    let head = HEAD.min(0.6 * length);
    let (tail, tip) = (-0.5 * length, 0.5 * length);
    for (rim, color) in [(2.0, WHITE), (0.0, BLACK)] {
        let shaft = [at(tail - rim, 0.0), at(tip - 0.5 * head, 0.0)];
        canvas.line(&shaft, 3.0 + 2.0 * rim, color)?;
        let half = 0.42 * head + 1.3 * rim;
        let back = tip - head - rim;
        let corners = [at(tip + 1.8 * rim, 0.0), at(back, half), at(back, -half)];
        canvas.polygon(&corners, color)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Along a wall of 1000 pixels: arrows no nearer than their least
    /// distance, and none missing where there is room for another.
    #[test]
    fn arrows_keep_their_distance() {
        let sample = |k: u32| Sample {
            place: [0.5 * f64::from(k), 63.0 + 0.001 * f64::from(k)],
            vector: [1.0, 0.0],
        };
        let samples: Vec<_> = (0..2000).map(sample).collect();
        let kept = spread(&samples);
        for (k, a) in kept.iter().enumerate() {
            for b in &kept[k + 1..] {
                assert!(distance(a.place, b.place) >= NEAREST * SPACING);
            }
        }
        for sample in &samples {
            let is_near = |kept: &Sample| distance(kept.place, sample.place) < 2.0 * SPACING;
            assert!(kept.iter().any(is_near));
        }
        assert!(spread(&[]).is_empty());
    }
}
