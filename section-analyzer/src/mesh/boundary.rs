//! The boundary of the mesh: sides that only one cell has, as curves.

use shared_geom::mesh::Cell;

use super::plane::{PlaneMesh, distance};

/// Distance of a middle node from the middle of the chord, relative to it, up to which a
/// side is treated as straight.
const STRAIGHT: f64 = 1e-9;

/// A side of a cell: a parabola through the node in its middle, or straight.
///
/// ```text
/// x(t) = (1-t)^2 a + 2 t (1-t) c + t^2 b,      0 <= t <= 1,      c = 2 m - (a + b)/2
/// ```
#[derive(Debug, Clone, Copy)]
pub(super) struct Curve {
    pub(super) first: [f64; 2],
    pub(super) second: [f64; 2],
    /// The point `c`; the middle of the chord if the side is straight.
    control: [f64; 2],
    is_straight: bool,
}

impl Curve {
    pub(super) fn new(first: [f64; 2], second: [f64; 2], middle: Option<[f64; 2]>) -> Self {
        let mean = [0, 1].map(|i| 0.5 * (first[i] + second[i]));
        let off = middle.filter(|m| distance(*m, mean) > STRAIGHT * distance(first, second));
        Self {
            first,
            second,
            control: off.map_or(mean, |m| [0, 1].map(|i| 2.0 * m[i] - mean[i])),
            is_straight: off.is_none(),
        }
    }

    /// Points whose convex hull contains the side.
    pub(super) fn hull(&self) -> [[f64; 2]; 3] {
        [self.first, self.control, self.second]
    }

    pub(super) fn is_straight(&self) -> bool {
        self.is_straight
    }

    pub(super) fn control(&self) -> [f64; 2] {
        self.control
    }

    /// From the first to the second end.
    pub(super) fn chord(&self) -> [f64; 2] {
        [0, 1].map(|i| self.second[i] - self.first[i])
    }

    /// Largest distance between the side and its chord.
    pub(super) fn sagitta(&self) -> f64 {
        let mean = [0, 1].map(|i| 0.5 * (self.first[i] + self.second[i]));
        0.5 * distance(self.control, mean)
    }

    pub(super) fn at(&self, t: f64) -> [f64; 2] {
        let weights = [(1.0 - t) * (1.0 - t), 2.0 * t * (1.0 - t), t * t];
        [0, 1].map(|i| {
            weights[0] * self.first[i] + weights[1] * self.control[i] + weights[2] * self.second[i]
        })
    }

    /// Unit tangent.
    pub(super) fn direction(&self, t: f64) -> [f64; 2] {
        let along = [0, 1].map(|i| {
            (1.0 - t) * (self.control[i] - self.first[i]) + t * (self.second[i] - self.control[i])
        });
        let length = along[0].hypot(along[1]);
        along.map(|x| x / length)
    }

    /// The points that divide the side into pieces whose chords lie within `tolerance` of
    /// it, without the last point; and the remaining distance.
    pub(super) fn pieces(&self, tolerance: f64, points: &mut Vec<[f64; 2]>) -> f64 {
        /// More pieces have no benefit.
        const MOST: f64 = 32.0;
        if self.is_straight {
            points.push(self.first);
            return 0.0;
        }
        let count = (self.sagitta() / tolerance).sqrt().ceil().clamp(1.0, MOST);
        let whole = count as usize;
        points.extend((0..whole).map(|i| self.at(i as f64 / count)));
        self.sagitta() / (count * count)
    }

    /// The parameter of the point nearest to `p`.
    pub(super) fn nearest(&self, p: [f64; 2]) -> f64 {
        let straight = |a: [f64; 2], b: [f64; 2]| {
            let along = [b[0] - a[0], b[1] - a[1]];
            let square = along[0] * along[0] + along[1] * along[1];
            let way = [p[0] - a[0], p[1] - a[1]];
            ((way[0] * along[0] + way[1] * along[1]) / square).clamp(0.0, 1.0)
        };
        if self.is_straight {
            return straight(self.first, self.second);
        }
        // the nearest of a few chords, then steps along the tangent, which converge for
        // points much nearer than the radius of curvature
        const CHORDS: usize = 4;
        let chord = |i: usize| {
            let [low, high] = [i, i + 1].map(|i| i as f64 / CHORDS as f64);
            let t = low + straight(self.at(low), self.at(high)) * (high - low);
            (t, distance(self.at(t), p))
        };
        let best = (0..CHORDS).map(chord).min_by(|a, b| a.1.total_cmp(&b.1));
        let mut t = best.map_or(0.0, |(t, _)| t);
        for _ in 0..4 {
            let (position, d) = (self.at(t), self.direction(t));
            let off = (p[0] - position[0]) * d[0] + (p[1] - position[1]) * d[1];
            let speed = 2.0
                * [0, 1]
                    .map(|i| {
                        (1.0 - t) * (self.control[i] - self.first[i])
                            + t * (self.second[i] - self.control[i])
                    })
                    .iter()
                    .map(|x| x * x)
                    .sum::<f64>()
                    .sqrt();
            t = (t + off / speed).clamp(0.0, 1.0);
        }
        t
    }
}

/// A side that only one cell has.
#[derive(Debug, Clone, Copy)]
pub(super) struct BoundarySide {
    /// The cell.
    pub(super) cell: usize,
    /// Number of the side in the cell.
    pub(super) number: usize,
    /// Ends, counterclockwise in the cell.
    pub(super) ends: [u32; 2],
    /// The node at its middle.
    pub(super) middle: Option<u32>,
}

/// The boundary of a mesh.
#[derive(Debug)]
pub(super) struct Boundary {
    /// Its sides, in the order of the cells.
    pub(super) sides: Vec<BoundarySide>,
    /// The sides of cell `i` are those from `of_cell[i]` to `of_cell[i + 1]`.
    of_cell: Vec<u32>,
}

impl Boundary {
    pub(super) fn of(mesh: &PlaneMesh) -> Self {
        let is_single = single_sides(mesh);
        let mut of_cell = Vec::with_capacity(mesh.cells.len() + 1);
        let mut sides = Vec::new();
        let mut number = 0;
        for (index, cell) in mesh.cells.iter().enumerate() {
            of_cell.push(sides.len() as u32);
            for (side, (ends, middle)) in cell.kind.sides(cell.nodes()).enumerate() {
                if is_single[number] {
                    sides.push(BoundarySide {
                        cell: index,
                        number: side,
                        ends,
                        middle,
                    });
                }
                number += 1;
            }
        }
        of_cell.push(sides.len() as u32);
        Self { sides, of_cell }
    }

    /// Nodes at which walls touch without a shared side: the boundary passes them more
    /// than once. `count` is the number of all nodes.
    pub(super) fn pinches(&self, count: usize) -> Vec<u32> {
        let mut passing = vec![0_u32; count];
        for side in &self.sides {
            // each passage enters and leaves
            passing[side.ends[0] as usize] += 1;
        }
        let nodes = (0..).zip(passing);
        let pinched = nodes.filter(|&(_, passing)| passing > 1);
        pinched.map(|(node, _)| node).collect()
    }

    /// The numbers of the sides of a cell.
    pub(super) fn of_cell(&self, cell: usize) -> std::ops::Range<usize> {
        self.of_cell[cell] as usize..self.of_cell[cell + 1] as usize
    }
}

impl BoundarySide {
    pub(super) fn curve(&self, mesh: &PlaneMesh) -> Curve {
        let position = |node: u32| mesh.nodes[node as usize];
        let [first, second] = self.ends.map(position);
        Curve::new(first, second, self.middle.map(position))
    }
}

/// The sides of a cell as curves, counterclockwise.
pub(super) fn curves<'a>(mesh: &'a PlaneMesh, cell: &'a Cell) -> impl Iterator<Item = Curve> + 'a {
    let position = |node: u32| mesh.nodes[node as usize];
    let sides = cell.kind.sides(cell.nodes());
    sides.map(move |([first, second], middle)| {
        Curve::new(position(first), position(second), middle.map(position))
    })
}

/// For each side of each cell, in order, whether it is on the boundary.
fn single_sides(mesh: &PlaneMesh) -> Vec<bool> {
    // sides sorted by their lower node, without comparisons: counts, then indices
    let mut start = vec![0_u32; mesh.nodes.len() + 1];
    let ends = || {
        let sides = mesh
            .cells
            .iter()
            .flat_map(|cell| cell.kind.sides(cell.nodes()));
        sides.map(|([a, b], _)| (a.min(b), a.max(b)))
    };
    let mut count = 0;
    for (low, _) in ends() {
        start[low as usize + 1] += 1;
        count += 1;
    }
    for i in 1..start.len() {
        start[i] += start[i - 1];
    }
    let mut sorted = vec![(0_u32, 0_u32); count];
    let mut next = start.clone();
    for (number, (low, high)) in ends().enumerate() {
        let slot = &mut next[low as usize];
        sorted[*slot as usize] = (high, number as u32);
        *slot += 1;
    }
    let mut is_single = vec![true; count];
    for node in 0..mesh.nodes.len() {
        let sides = &mut sorted[start[node] as usize..start[node + 1] as usize];
        sides.sort_unstable();
        for pair in sides.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
            is_single[pair[0].1 as usize] = false;
            is_single[pair[1].1 as usize] = false;
        }
    }
    is_single
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `z = y^2` between -1 and 1: its normal at y is (-2 y, 1). Each step multiplies the
    /// error by the distance over the radius of curvature, here at most 0.04: after four
    /// steps 1e-6 of the chords' error of 0.1 remains.
    #[test]
    fn nearest_position_of_a_parabola() {
        let parabola = Curve::new([-1.0, 1.0], [1.0, 1.0], Some([0.0, 0.0]));
        assert!((parabola.sagitta() - 1.0).abs() < 1e-15);
        for y in [-0.9, -0.3, 0.4, 0.75] {
            for d in [-0.02, 0.0, 0.02] {
                let slope = (1.0_f64 + 4.0 * y * y).sqrt();
                let p = [y - 2.0 * y * d / slope, y * y + d / slope];
                assert!(
                    (parabola.at(parabola.nearest(p))[0] - y).abs() < 1e-6,
                    "{y} {d}"
                );
            }
        }
        assert_eq!(parabola.nearest([-3.0, 3.0]), 0.0);
        let line = Curve::new([0.0, 0.0], [2.0, 0.0], Some([1.0, 1e-12]));
        assert_eq!((line.nearest([0.5, 9.0]), line.sagitta()), (0.25, 0.0));
    }

    /// A parabola in n equal pieces deviates from its chords by its sagitta / n^2.
    #[test]
    fn pieces_are_as_near_as_requested() {
        let parabola = Curve::new([-1.0, 1.0], [1.0, 1.0], Some([0.0, 0.0]));
        let mut points = Vec::new();
        let left = parabola.pieces(1.0 / 9.0 + 1e-9, &mut points);
        assert_eq!(points.len(), 3);
        assert!((left - 1.0 / 9.0).abs() < 1e-12);
        let middle = parabola.at(1.0 / 6.0);
        let chord = [0, 1].map(|i| 0.5 * (points[0][i] + points[1][i]));
        assert!((distance(middle, chord) - left).abs() < 1e-12);
    }
}
