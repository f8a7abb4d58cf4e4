//! Laminates as cells: stations across them, and the layers between two stations.
//!
//! ```text
//!   station i        station i + 1     -> clockwise
//!      *-----------------*   level 0, the outer face
//!      |     layer 0     |
//!      *-----------------*   level 1
//!      |     layer 1     |
//!      *-----------------*   level 2, the inner face
//! ```
//!
//! A level lies at its depth below the contour. At a corner of two walls, its node is the
//! point at this depth below both: the mitre, which preserves the thickness of the plies.
//! The corner shifts a level along the contour; nodes next to the corner are shifted too,
//! decreasing with the distance, and the middle node of a side is halfway along the level
//! between its ends.

use super::contour::{Contour, Half};
use super::grid::Grid;
use super::layers::{Content, Interval, Layer, Part};

/// Distance within which nodes move with a corner, as a multiple of its shift.
const REACH: f64 = 3.0;

/// The nodes across a laminate at one position.
#[derive(Debug, Clone, Default)]
pub(super) struct Station {
    pub nodes: Vec<u32>,
    /// Depth of each level below the outer face [unit of the mesh].
    pub depths: Vec<f64>,
    /// Position of each level along the contour for the interval before it; empty if the
    /// interval is straight.
    pub before: Vec<f64>,
    /// The same for the interval after it.
    pub behind: Vec<f64>,
}

/// Shift of the levels of a wall along the contour, due to a corner.
#[derive(Debug, Clone)]
pub(super) struct Shift {
    /// Position of the corner.
    pub at: f64,
    /// Shift of each level [unit of the mesh].
    pub by: Vec<f64>,
    /// Distance at which its effect ends [unit of the mesh].
    reach: f64,
}

impl Shift {
    /// Shift of a corner at `at` whose levels lie at `positions`, with the length `space`
    /// along the wall.
    pub fn new(at: f64, positions: &[f64], space: f64) -> Self {
        let by: Vec<f64> = positions.iter().map(|position| position - at).collect();
        let most = by.iter().fold(0.0_f64, |most, by| most.max(by.abs()));
        Self {
            at,
            by,
            reach: (REACH * most).min(space),
        }
    }

    /// The largest shift of all levels [unit of the mesh].
    pub fn most(&self) -> f64 {
        self.by.iter().fold(0.0_f64, |most, by| most.max(by.abs()))
    }

    /// Shift of a level at a position of the contour.
    fn of(&self, level: usize, u: f64) -> f64 {
        let away = (u - self.at).abs();
        if away < self.reach {
            self.by[level] * (1.0 - away / self.reach)
        } else {
            0.0
        }
    }
}

/// Positions at which the levels of a wall cross the column at `u`.
pub(super) fn moved(u: f64, levels: usize, shifts: &[&Shift]) -> Vec<f64> {
    let position = |level| u + shifts.iter().map(|shift| shift.of(level, u)).sum::<f64>();
    (0..levels).map(position).collect()
}

/// Nodes at these positions, one for all levels at the same depth; the outer node may
/// exist already.
pub(super) fn nodes(
    grid: &mut Grid,
    outer: Option<u32>,
    depths: &[f64],
    position: impl Fn(usize) -> [f64; 2],
) -> Vec<u32> {
    let mut nodes: Vec<u32> = Vec::with_capacity(depths.len());
    for (level, depth) in depths.iter().enumerate() {
        let node = match level {
            0 => outer.unwrap_or_else(|| grid.node(position(0))),
            _ if *depth == depths[level - 1] => nodes[level - 1],
            _ => grid.node(position(level)),
        };
        nodes.push(node);
    }
    nodes
}

/// Data of a laminate, and names of its parts.
pub(super) struct Wall<'a> {
    pub contour: &'a Contour,
    /// Depth of its outer face below the contour [unit of the mesh].
    pub depth: f64,
    pub layers: &'a [Layer],
    pub stations: &'a [Station],
    /// From each station to the next; after the last comes the first again.
    pub intervals: &'a [Interval],
    /// The curve of its outer face.
    pub curve: &'a str,
    /// Name of the content of a layer, and whether its faces are curves.
    pub group: &'a dyn Fn(usize, Content) -> (String, bool),
    /// Name of a part.
    pub part: &'a dyn Fn(Part) -> &'static str,
}

impl Wall<'_> {
    /// Makes cells and lines.
    pub fn build(&self, grid: &mut Grid) {
        for index in 0..self.intervals.len() {
            self.place_middles(grid, index);
        }
        for level in 0..=self.layers.len() {
            for index in 0..self.intervals.len() {
                let names = self.curves(level, &self.intervals[index]);
                if !names.is_empty() {
                    let [from, to] = self.ends(index).map(|station| station.nodes[level]);
                    grid.line([from, to], &names);
                }
            }
        }
        for layer in 0..self.layers.len() {
            for (index, interval) in self.intervals.iter().enumerate() {
                let content = interval.contents[layer];
                if content == Content::Nothing {
                    continue;
                }
                let [from, to] = self.ends(index).map(|station| &station.nodes);
                let corners = [from[layer], from[layer + 1], to[layer + 1], to[layer]];
                let (name, _) = (self.group)(self.layers[layer].ply, content);
                let of_part = format!("{name}/{}", (self.part)(interval.part));
                grid.cell(corners, &[name, of_part]);
            }
        }
    }

    fn ends(&self, index: usize) -> [&Station; 2] {
        let next = (index + 1) % self.stations.len();
        [&self.stations[index], &self.stations[next]]
    }

    /// The curves that the line of a level belongs to.
    fn curves(&self, level: usize, interval: &Interval) -> Vec<String> {
        let mut names = Vec::new();
        if level == 0 {
            names.push(self.curve.to_owned());
        }
        let mut face = |layer: Option<usize>, which: usize, word: &str| {
            let Some(layer) = layer.filter(|layer| *layer < self.layers.len()) else {
                return;
            };
            let content = interval.contents[layer];
            let (name, has_faces) = (self.group)(self.layers[layer].ply, content);
            let is_face = self.layers[layer].faces[which] && content != Content::Nothing;
            if is_face && has_faces {
                names.push(format!("{name}/{word}"));
            }
        };
        face(Some(level), 0, "outer");
        face(level.checked_sub(1), 1, "inner");
        names
    }

    /// The nodes in the middle of the sides along the contour, on the levels.
    fn place_middles(&self, grid: &mut Grid, index: usize) {
        if !matches!(self.intervals[index].part, Part::Upper | Part::Lower) {
            return;
        }
        let [from, to] = self.ends(index);
        for level in 0..=self.layers.len() {
            let u = 0.5 * (from.behind[level] + to.before[level]);
            let depth = self.depth + 0.5 * (from.depths[level] + to.depths[level]);
            let position = self.contour.offset(u, depth);
            grid.middle(from.nodes[level], to.nodes[level], position);
        }
    }
}

/// The part of a half of the contour.
pub(super) fn part_of(half: Half) -> Part {
    match half {
        Half::Upper => Part::Upper,
        Half::Lower => Part::Lower,
    }
}
