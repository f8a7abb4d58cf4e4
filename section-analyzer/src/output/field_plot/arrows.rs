//! Arrows along a vector field, about evenly spaced.

use std::collections::{HashMap, HashSet};

use shared_geom::figure::{BLACK, Drawing, WHITE};

use super::sample::{SPACING, Sample, grid_point};
use crate::mesh::distance;

/// Least distance of two arrows, relative to [`SPACING`]: less than one, so that all points of
/// the grid can have one, and more than half a diagonal, so that none is between them.
const NEAREST: f64 = 0.95;
/// The same for arrows whose depth in the section is less than this part of the distance: in
/// thin walls, and at the boundary of wide ones, where few are enough.
const NEAREST_SHALLOW: f64 = 1.3;
const SHALLOW: f64 = 0.2;
/// Radius of the means that arrows show [figure pixels].
const MEAN: f64 = 0.4 * SPACING;
/// Ratio to the mean length below which a mean has no meaningful direction: if the shear of the
/// two faces of a wall, or of plies of opposite angles, is opposite, the mean is a small
/// difference that depends on its exact position.
const COHERENT: f64 = 0.5;
/// Weight of a pixel of depth, in pixels of distance from the grid.
const DEEP: f64 = 4.0;
/// Distance of the points of the boundary [figure pixels].
const CLOSE: f64 = 4.0;
/// Length of the longest arrow, relative to the distance.
const LONGEST: f64 = 0.92;
/// Length below which arrows are omitted, relative to the longest.
const SHORTEST: f64 = 0.06;
/// Maximum length of the head of an arrow [figure pixels].
const HEAD: f64 = 17.0;

/// Draws arrows at some of the samples; `rim` are the lines around the section and between its
/// materials; the longest arrow is a vector of the length `largest`.
pub(super) fn draw(drawing: &mut Drawing, samples: &[Sample], rim: &[Vec<[f64; 2]>], largest: f64) {
    let near = BySquare::new(
        samples.iter().map(|sample| (sample.position, *sample)),
        MEAN,
    );
    for position in spread(samples, rim) {
        let [y, z] = mean_vector(&near, position);
        let size = y.hypot(z) / largest;
        if size >= SHORTEST {
            let length = (LONGEST * SPACING * size).max(0.25 * SPACING);
            // z is up on the figure, but the pixel coordinate y is down
            let direction = [y / y.hypot(z), -z / y.hypot(z)];
            draw_arrow(drawing, position, direction, length);
        }
    }
}

/// Mean vector around a position: in a wall the mean over its thickness, which is its flow.
/// Zero if vectors of all directions meet, as in the wall of an open section in torsion.
fn mean_vector(near: &BySquare<Sample>, position: [f64; 2]) -> [f64; 2] {
    let (mut sum, mut length, mut area) = ([0.0; 2], 0.0, 0.0);
    for sample in near.around(position) {
        if distance(sample.position, position) <= MEAN {
            sum = [0, 1].map(|axis| sum[axis] + sample.area * sample.vector[axis]);
            length += sample.area * sample.vector[0].hypot(sample.vector[1]);
            area += sample.area;
        }
    }
    if sum[0].hypot(sum[1]) > COHERENT * length {
        sum.map(|part| part / area)
    } else {
        [0.0; 2]
    }
}

/// Positions at the points of a grid that are deep in the section, in its walls the positions
/// farthest from the boundary; none too near to another.
fn spread(samples: &[Sample], rim: &[Vec<[f64; 2]>]) -> Vec<[f64; 2]> {
    let farthest = 0.5 * SPACING;
    let rim = BySquare::new(points_along(rim).into_iter().map(|p| (p, p)), farthest);
    let depth = |position: [f64; 2]| {
        let points = rim.around(position).map(|point| distance(*point, position));
        points.fold(farthest, f64::min)
    };
    let mut best_first: Vec<_> = samples
        .iter()
        .map(|sample| {
            let off = distance(sample.position, grid_point(sample.position));
            let depth = depth(sample.position);
            (off - DEEP * depth, depth, sample.position)
        })
        .collect();
    best_first.sort_by(|(one, ..), (other, ..)| one.total_cmp(other));

    let mut kept = BySquare::new(std::iter::empty(), NEAREST_SHALLOW * SPACING);
    for (_, depth, position) in best_first {
        let is_shallow = depth < SHALLOW * SPACING;
        let least = if is_shallow { NEAREST_SHALLOW } else { NEAREST } * SPACING;
        if kept
            .around(position)
            .all(|other| distance(*other, position) >= least)
        {
            kept.insert(position, position);
        }
    }
    kept.into_values()
}

/// Points along lines, close together but not more than needed.
fn points_along(lines: &[Vec<[f64; 2]>]) -> Vec<[f64; 2]> {
    let pieces = lines.iter().flat_map(|line| line.windows(2));
    let points = pieces.flat_map(|piece| {
        let (a, b) = (piece[0], piece[1]);
        let count = (distance(a, b) / CLOSE).ceil().max(1.0) as usize;
        (0..count).map(move |k| {
            let t = k as f64 / count as f64;
            [0, 1].map(|axis| (1.0 - t) * a[axis] + t * b[axis])
        })
    });
    let mut taken = HashSet::new();
    let is_first = |point: &[f64; 2]| taken.insert(point.map(|value| (value / CLOSE) as i64));
    points.filter(is_first).collect()
}

/// Values by the squares that contain them.
struct BySquare<T> {
    values: HashMap<[i64; 2], Vec<T>>,
    /// Size of a square [figure pixels].
    size: f64,
}

impl<T> BySquare<T> {
    fn new(values: impl Iterator<Item = ([f64; 2], T)>, size: f64) -> Self {
        let mut sorted = Self {
            values: HashMap::new(),
            size,
        };
        for (position, value) in values {
            sorted.insert(position, value);
        }
        sorted
    }

    fn insert(&mut self, position: [f64; 2], value: T) {
        let square = self.square(position);
        self.values.entry(square).or_default().push(value);
    }

    fn square(&self, position: [f64; 2]) -> [i64; 2] {
        position.map(|value| (value / self.size).floor() as i64)
    }

    /// The values in the square of `position` and in the squares around it: all within the size of
    /// a square, and some more.
    fn around(&self, position: [f64; 2]) -> impl Iterator<Item = &T> {
        let [i, j] = self.square(position);
        (0..9)
            .filter_map(move |k| self.values.get(&[i + k / 3 - 1, j + k % 3 - 1]))
            .flatten()
    }

    /// All values, in the order of their squares.
    fn into_values(self) -> Vec<T> {
        let mut squares: Vec<_> = self.values.into_iter().collect();
        squares.sort_by_key(|(square, _)| *square);
        squares.into_iter().flat_map(|(_, values)| values).collect()
    }
}

/// An arrow around `middle`, black with a white rim.
fn draw_arrow(drawing: &mut Drawing, middle: [f64; 2], direction: [f64; 2], length: f64) {
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
        drawing.line(&shaft, 3.0 + 2.0 * rim, color);
        let half = 0.42 * head + 1.3 * rim;
        let back = tip - head - rim;
        let corners = [at(tip + 1.8 * rim, 0.0), at(back, half), at(back, -half)];
        drawing.polygon(&corners, color);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Samples on every pixel of a rectangle.
    fn samples(width: u32, height: u32) -> Vec<Sample> {
        let positions = (0..=width).flat_map(|x| (0..=height).map(move |y| [x, y]));
        let sample = |position: [u32; 2]| Sample {
            position: position.map(f64::from),
            vector: [f64::from(position[1]), 1.0],
            area: 1.0,
        };
        positions.map(sample).collect()
    }

    fn frame(width: f64, height: f64) -> Vec<Vec<[f64; 2]>> {
        let corners = [[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]];
        vec![corners.iter().cycle().take(5).copied().collect()]
    }

    /// Along a wall of 1000 by 40 pixels: all arrows in its middle, no nearer than allowed, and
    /// no gap wide enough for another.
    #[test]
    fn arrows_are_in_the_middle_of_a_wall_and_keep_their_distance() {
        let samples = samples(1000, 40);
        let kept = spread(&samples, &frame(1000.0, 40.0));
        let least = NEAREST * SPACING;
        for (k, a) in kept.iter().enumerate() {
            let is_at_an_end = a[0] < 20.0 || a[0] > 980.0;
            assert!(a[1] == 20.0 || is_at_an_end, "{a:?}");
            for b in &kept[k + 1..] {
                assert!(distance(*a, *b) >= least);
            }
        }
        for sample in &samples {
            let nearest = kept.iter().map(|k| distance(*k, sample.position));
            let nearest = nearest.fold(f64::INFINITY, f64::min);
            assert!(nearest < NEAREST_SHALLOW * SPACING);
        }
        assert!(spread(&[], &[]).is_empty());
    }

    /// In a wide section they are on the grid.
    #[test]
    fn arrows_in_the_open_are_on_the_grid() {
        let kept = spread(&samples(320, 256), &frame(320.0, 256.0));
        assert_eq!(kept.len(), 5 * 4);
        assert!(
            kept.iter()
                .all(|position| *position == grid_point(*position))
        );
    }

    /// The mean of a linear field over a disc is its value in the middle.
    #[test]
    fn arrows_show_the_mean_around_them() {
        let samples = samples(100, 100);
        let near = BySquare::new(samples.iter().map(|s| (s.position, *s)), MEAN);
        let [along, across] = mean_vector(&near, [40.0, 30.0]);
        assert!((along - 30.0).abs() < 1e-12 && (across - 1.0).abs() < 1e-12);
        assert_eq!(mean_vector(&near, [500.0, 500.0]), [0.0; 2]);

        // a wall of 40 pixels in which the vectors of the two sides are opposite
        let opposed = |sample: &Sample| Sample {
            vector: [sample.position[1] - 20.0, 0.0],
            ..*sample
        };
        let wall = samples.iter().filter(|sample| sample.position[1] <= 40.0);
        let near = BySquare::new(wall.map(|s| (s.position, opposed(s))), MEAN);
        assert_eq!(mean_vector(&near, [50.0, 22.0]), [0.0; 2]);
    }
}
