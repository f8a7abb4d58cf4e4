//! Cells that overlap, have hanging nodes, or nearly touch.
//!
//! All cells are counterclockwise, and each inner side is shared by two cells that pass
//! it in opposite directions. The number of cells that cover a point is then the winding
//! number of the boundary around it, which changes only at the boundary. It is therefore
//! enough to search around the sides of the boundary.

use std::collections::HashSet;

use shared_geom::mesh::CellKind;
use static_aabb2d_index::{StaticAABB2DIndex, StaticAABB2DIndexBuilder};

use super::boundary::{Boundary, BoundarySide, Curve, curves};
use super::findings::{CellOverlap, HangingNode, NarrowGap};
use super::overlap::{is_inside, position_inside};
use super::plane::{PlaneMesh, distance};
use super::seams::{Groups, SidePair};

/// Fraction of the height of a cell within which sides are close to each other, and
/// beyond which a side inside of another cell is an overlap.
const NARROW: f64 = 0.02;
/// Fraction of the height of a cell within which a corner lies on a side.
const TOUCHING: f64 = 1e-3;
/// Cosine of the angle within which sides are parallel: 26 degrees.
const ALONG: f64 = 0.9;
/// Points at which the distance between sides is measured.
const SAMPLES: [f64; 2] = [0.25, 0.75];
/// Points inside of a cell near one of its sides: position along the side, and from there
/// toward the opposite side or corner. They detect overlaps of cells whose sides
/// coincide; no ordinary mesh has its lines there.
const PROBES: [[f64; 2]; 2] = [[0.37, 0.21], [0.71, 0.13]];

/// Number of overlapping pairs at which the search ends: more copies of a surface would
/// cost time without new information.
const ENOUGH: usize = 10_000;

/// Results of the search.
#[derive(Debug, Default)]
pub(super) struct Contacts {
    pub(super) overlaps: Vec<CellOverlap>,
    /// Pairs of cells that overlap.
    pub(super) overlapping: Vec<[usize; 2]>,
    pub(super) hanging: Vec<HangingNode>,
    /// The cell with the corner and the cell with the side, parallel to `hanging`.
    pub(super) hangs_on: Vec<[usize; 2]>,
    pub(super) gaps: Vec<NarrowGap>,
}

/// The search, with its results so far.
struct Search<'a> {
    mesh: &'a PlaneMesh,
    boundary: &'a Boundary,
    boxes: Vec<[f64; 4]>,
    curves: Vec<Curve>,
    side_boxes: Vec<[f64; 4]>,
    heights: Vec<f64>,
    /// For each node the smallest index of the nodes at its position.
    least: &'a [u32],
    groups: Groups<'a>,
    /// Pairs of cells that overlap.
    covered: HashSet<[usize; 2]>,
    /// Hanging nodes, with the side on which they lie.
    hung: HashSet<(u32, usize)>,
    /// Sides with a hanging node on them.
    carrying: HashSet<usize>,
    /// Sides that nearly touch, with a position and the distance.
    near: Vec<(SidePair, [f64; 2], f64)>,
    found: Contacts,
}

/// Searches a mesh whose cells are counterclockwise and fit at their shared sides.
/// `doubled` are the pairs of sides that another check reports.
pub(super) fn contacts(
    mesh: &PlaneMesh,
    boundary: &Boundary,
    least: &[u32],
    doubled: &[SidePair],
    groups: Groups<'_>,
) -> Contacts {
    let boxes: Vec<_> = (0..mesh.cells.len())
        .map(|cell| box_of(mesh, cell))
        .collect();
    let Some(index) = index_of(&boxes) else {
        return Contacts::default();
    };
    let curves: Vec<_> = boundary.sides.iter().map(|side| side.curve(mesh)).collect();
    let mut search = Search {
        mesh,
        boundary,
        boxes,
        side_boxes: curves
            .iter()
            .map(|curve| box_around(curve.hull()))
            .collect(),
        curves,
        heights: (0..mesh.cells.len())
            .map(|cell| height(mesh, cell))
            .collect(),
        least,
        groups,
        covered: HashSet::new(),
        hung: HashSet::new(),
        carrying: HashSet::new(),
        near: Vec::new(),
        found: Contacts::default(),
    };
    let mut cells = Vec::new();
    for side in 0..boundary.sides.len() {
        let own = boundary.sides[side].cell;
        let reach = NARROW * search.heights[own];
        let [low_y, low_z, high_y, high_z] = search.side_boxes[side];
        cells.clear();
        index.visit_query(
            low_y - reach,
            low_z - reach,
            high_y + reach,
            high_z + reach,
            &mut |cell: usize| cells.push(cell),
        );
        if search.found.overlapping.len() >= ENOUGH {
            break;
        }
        let probes = search.probes(side);
        for &cell in cells.iter().filter(|&&cell| cell != own) {
            search.overlap(side, &probes, cell);
            for other in boundary.of_cell(cell) {
                search.compare(side, other);
            }
        }
    }
    search.finish(doubled)
}

impl Search<'_> {
    /// Points in the cell of a side, near this side.
    fn probes(&self, side: usize) -> [[f64; 2]; 2] {
        let BoundarySide { cell, number, .. } = self.boundary.sides[side];
        let cell = &self.mesh.cells[cell];
        PROBES.map(|[along, inward]| {
            let [r, s] = reference_position(cell.kind, number, along, inward);
            let shape = cell.kind.shape(r, s);
            let mut position = [0.0; 2];
            for (n, &node) in shape.n.iter().zip(cell.nodes()) {
                let node = self.mesh.nodes[node as usize];
                position = [position[0] + n * node[0], position[1] + n * node[1]];
            }
            position
        })
    }

    /// Whether the side, or its cell near it, is inside of `cell`.
    fn overlap(&mut self, side: usize, probes: &[[f64; 2]; 2], cell: usize) {
        let own = self.boundary.sides[side].cell;
        let tolerance = NARROW * self.heights[own].min(self.heights[cell]);
        let mesh = self.mesh;
        let [low_y, low_z, high_y, high_z] = self.boxes[cell];
        let is_held = |&[y, z]: &[f64; 2]| {
            (low_y..=high_y).contains(&y)
                && (low_z..=high_z).contains(&z)
                && is_inside(mesh, &mesh.cells[cell], [y, z], tolerance)
        };
        let found = position_inside(mesh, &mesh.cells[cell], &self.curves[side], tolerance)
            .or_else(|| probes.iter().copied().find(is_held));
        if let Some(position) = found {
            self.cover([own, cell], position);
        }
    }

    fn cover(&mut self, mut cells: [usize; 2], position: [f64; 2]) {
        let group = |cell: usize| self.groups.of_cell[cell];
        cells.sort_unstable_by_key(|&cell| (group(cell), cell));
        if !self.covered.insert(cells) {
            return;
        }
        self.found.overlapping.push(cells);
        let groups = self.groups.labels_of(cells);
        let overlaps = &mut self.found.overlaps;
        let at = overlaps.iter().position(|known| known.groups == groups);
        let at = at.unwrap_or_else(|| {
            overlaps.push(CellOverlap {
                groups,
                cells: Vec::new(),
                positions: Vec::new(),
            });
            overlaps.len() - 1
        });
        let tags = cells.map(|cell| self.mesh.cells[cell].tag);
        overlaps[at].cells.push(tags);
        overlaps[at].positions.push(position);
    }

    /// Compares the side `one` with the side `other`: hanging nodes, overlap, gap.
    fn compare(&mut self, one: usize, other: usize) {
        let cells = [one, other].map(|side| self.boundary.sides[side].cell);
        let height = self.heights[cells[0]].min(self.heights[cells[1]]);
        let [a, b] = [one, other].map(|side| &self.side_boxes[side]);
        if is_beyond(a, b, NARROW * height) || self.runs_on(one, other) || self.runs_on(other, one)
        {
            return;
        }
        self.hang(one, other, TOUCHING * height);
        for t in SAMPLES {
            let position = self.curves[one].at(t);
            let on = self.curves[other].nearest(position);
            let width = distance(position, self.curves[other].at(on));
            if width > NARROW * height {
                continue;
            }
            let cosine = dot(
                self.curves[one].direction(t),
                self.curves[other].direction(on),
            );
            if cosine > ALONG {
                // both cells lie on the same side of the line
                self.cover(cells, position);
            } else if cosine < -ALONG && !self.share_nodes(one, other) {
                self.near
                    .push(([one.min(other), one.max(other)], position, width));
            }
        }
    }

    /// Whether an end of the side `other` is a hanging node on the side `one`, which is
    /// parallel to `other`.
    fn hang(&mut self, one: usize, other: usize, tolerance: f64) {
        let [on, of] = [one, other].map(|side| self.boundary.sides[side]);
        let carrier = self.mesh.cells[on.cell].nodes();
        for (end, node) in of.ends.into_iter().enumerate() {
            let position = self.mesh.nodes[node as usize];
            let curve = &self.curves[one];
            let t = curve.nearest(position);
            let is_between = t > TOUCHING && t < 1.0 - TOUCHING;
            if !is_between || distance(curve.at(t), position) > tolerance {
                continue;
            }
            let least = |node: u32| self.least[node as usize];
            let is_own = carrier.iter().any(|&own| least(own) == least(node));
            let direction = self.curves[other].direction(end as f64);
            if is_own || dot(direction, curve.direction(t)) > -ALONG {
                continue;
            }
            self.carrying.insert(one);
            if self.hung.insert((least(node), one)) {
                let tag = |node: u32| self.mesh.node_tags[node as usize];
                self.found.hanging.push(HangingNode {
                    node: tag(node),
                    position,
                    corner_of: self.mesh.cells[of.cell].tag,
                    side_of: self.mesh.cells[on.cell].tag,
                    side: on.ends.map(tag),
                    groups: self.groups.labels_of([of.cell, on.cell]),
                });
                self.found.hangs_on.push([of.cell, on.cell]);
            }
        }
    }

    /// Whether `next` starts at the end of `side`, and does not turn back along it.
    fn runs_on(&self, side: usize, next: usize) -> bool {
        let (end, start) = (
            self.boundary.sides[side].ends[1],
            self.boundary.sides[next].ends[0],
        );
        let cosine = || {
            dot(
                self.curves[side].direction(1.0),
                self.curves[next].direction(0.0),
            )
        };
        end == start && cosine() > -ALONG
    }

    fn share_nodes(&self, one: usize, other: usize) -> bool {
        let [one, other] = [one, other].map(|side| self.boundary.sides[side].ends);
        one.iter().any(|node| other.contains(node))
    }

    /// Collects the gaps that no other check reports.
    fn finish(mut self, doubled: &[SidePair]) -> Contacts {
        let reported: HashSet<SidePair> =
            doubled.iter().map(|&[a, b]| [a.min(b), a.max(b)]).collect();
        let mut gaps: Vec<([usize; 2], NarrowGap, HashSet<usize>)> = Vec::new();
        for &(pair, position, width) in &self.near {
            let cells = pair.map(|side| self.boundary.sides[side].cell);
            let mut ordered = cells;
            ordered.sort_unstable_by_key(|&cell| (self.groups.of_cell[cell], cell));
            let hangs = pair.iter().any(|side| self.carrying.contains(side));
            if reported.contains(&pair) || hangs || self.covered.contains(&ordered) {
                continue;
            }
            let mut key = cells.map(|cell| self.groups.of_cell[cell]);
            key.sort_unstable();
            let at = gaps.iter().position(|(known, ..)| *known == key);
            let at = at.unwrap_or_else(|| {
                let empty = NarrowGap {
                    groups: key.map(|group| self.groups.labels[group].clone()),
                    sides: 0,
                    narrowest: f64::INFINITY,
                    widest: 0.0,
                    positions: Vec::new(),
                };
                gaps.push((key, empty, HashSet::new()));
                gaps.len() - 1
            });
            let (_, gap, sides) = &mut gaps[at];
            gap.narrowest = gap.narrowest.min(width);
            gap.widest = gap.widest.max(width);
            gap.positions.push(position);
            sides.insert(pair[0]);
            gap.sides = sides.len();
        }
        self.found.gaps = gaps.into_iter().map(|(_, gap, _)| gap).collect();
        self.found
    }
}

/// A point of the reference cell: on its side `side`, at `along` from the first to the
/// second end, then `inward` toward the opposite side or corner.
fn reference_position(kind: CellKind, side: usize, along: f64, inward: f64) -> [f64; 2] {
    let corners = &kind.reference_nodes()[..kind.corner_count()];
    let at = |i: usize| corners[i % corners.len()];
    let mix = |a: [f64; 2], b: [f64; 2], t: f64| [0, 1].map(|i| a[i] + t * (b[i] - a[i]));
    let position = mix(at(side), at(side + 1), along);
    // in a triangle both lead to the corner
    let opposite = mix(at(side + corners.len() - 1), at(side + 2), along);
    mix(position, opposite, inward)
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// The boxes of the cells; `None` without cells.
fn index_of(boxes: &[[f64; 4]]) -> Option<StaticAABB2DIndex<f64>> {
    let mut builder = StaticAABB2DIndexBuilder::new(boxes.len());
    for &[low_y, low_z, high_y, high_z] in boxes {
        builder.add(low_y, low_z, high_y, high_z);
    }
    // it fails only for no boxes, or for fewer than announced
    builder.build().ok()
}

/// A box that contains the whole cell: low y, low z, high y, high z.
fn box_of(mesh: &PlaneMesh, cell: usize) -> [f64; 4] {
    box_around(curves(mesh, &mesh.cells[cell]).flat_map(|curve| curve.hull()))
}

fn box_around(points: impl IntoIterator<Item = [f64; 2]>) -> [f64; 4] {
    let empty = [
        f64::INFINITY,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NEG_INFINITY,
    ];
    points.into_iter().fold(empty, |b, [y, z]| {
        [b[0].min(y), b[1].min(z), b[2].max(y), b[3].max(z)]
    })
}

/// Whether two boxes are farther apart than `reach`.
fn is_beyond(a: &[f64; 4], b: &[f64; 4], reach: f64) -> bool {
    a[0] > b[2] + reach || b[0] > a[2] + reach || a[1] > b[3] + reach || b[1] > a[3] + reach
}

/// Area of a cell over its longest side (twice this value for a triangle), with straight
/// sides.
fn height(mesh: &PlaneMesh, cell: usize) -> f64 {
    let corners = mesh.cells[cell].corners();
    let position = |i: usize| mesh.nodes[corners[i % corners.len()] as usize];
    let origin = position(0);
    let (mut doubled, mut longest) = (0.0, 0.0_f64);
    for i in 0..corners.len() {
        let (p, q) = (position(i), position(i + 1));
        let side = [q[0] - p[0], q[1] - p[1]];
        doubled += (p[0] - origin[0]) * side[1] - (p[1] - origin[1]) * side[0];
        longest = longest.max(dot(side, side));
    }
    let share = if corners.len() == 3 { 1.0 } else { 0.5 };
    share * doubled.abs() / longest.sqrt()
}

#[cfg(test)]
#[path = "contact_tests.rs"]
mod tests;
