//! The boundary of a part of a section: closed loops of sides, and their lengths.

use std::collections::HashMap;

use shared_geom::quadrature;

use super::moments::{CellSide, SidePoint};
use crate::mesh::SectionMesh;

/// Number of pieces for the length of a side, with [`POINTS`] points each. The length of a
/// parabola is not a polynomial: for a side that turns by 60 degrees, a piece has an error
/// of 1e-14.
const PIECES: usize = 4;
const POINTS: usize = 6;

/// Lengths of the closed lines that bound a part of a section.
///
/// The sides of a slit are included: a slit lies outside. If two lines touch at a node,
/// they are distinguished by the cells around the node: a hole that touches the outline
/// belongs to the outline.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Perimeter {
    /// Lengths of the lines around the part, one for each of its pieces \[m\].
    pub outer: Vec<f64>,
    /// Lengths of the lines around its holes \[m\].
    pub holes: Vec<f64>,
}

impl Perimeter {
    /// The boundary of the cells `part`, by index.
    pub fn of(mesh: &SectionMesh, part: &[usize]) -> Self {
        let sides = Sides::new(mesh, part);
        let mut perimeter = Self::default();
        for (length, area) in sides.loops(mesh) {
            // the part lies left of its boundary: around a hole this runs clockwise
            if area < 0.0 {
                perimeter.holes.push(length);
            } else {
                perimeter.outer.push(length);
            }
        }
        perimeter
    }

    /// Length of all lines around the part \[m\].
    pub fn outer_length(&self) -> f64 {
        self.outer.iter().sum()
    }

    /// Length of all lines around its holes \[m\].
    pub fn hole_length(&self) -> f64 {
        self.holes.iter().sum()
    }

    /// Length of the whole boundary \[m\].
    pub fn length(&self) -> f64 {
        self.outer_length() + self.hole_length()
    }
}

/// Side of a cell: cell and number of the side.
type SideOf = (usize, usize);

/// The sides of the cells of a part, by their ends in the direction of the cell.
struct Sides {
    by_ends: HashMap<[u32; 2], SideOf>,
    /// In the order of the cells, so that the order of the loops is unique.
    all: Vec<([u32; 2], SideOf)>,
}

impl Sides {
    fn new(mesh: &SectionMesh, part: &[usize]) -> Self {
        let all: Vec<_> = part
            .iter()
            .flat_map(|&index| {
                let corners = 0..mesh.cells[index].kind.corner_count();
                corners.map(move |side| (ends(mesh, (index, side)), (index, side)))
            })
            .collect();
        Self {
            by_ends: all.iter().copied().collect(),
            all,
        }
    }

    fn is_boundary(&self, [first, second]: [u32; 2]) -> bool {
        !self.by_ends.contains_key(&[second, first])
    }

    /// Length \[m\] and enclosed area \[m^2\] of each closed line; the area is
    /// negative where the line runs clockwise.
    fn loops(&self, mesh: &SectionMesh) -> Vec<(f64, f64)> {
        let mut seen = std::collections::HashSet::new();
        let mut loops = Vec::new();
        for &(start, side) in &self.all {
            if !self.is_boundary(start) || !seen.insert(start) {
                continue;
            }
            let base = mesh.nodes[start[0] as usize];
            let (mut length, mut area) = measure(mesh, side, base);
            let mut now = self.next(mesh, side);
            while seen.insert(ends(mesh, now)) {
                let (more, swept) = measure(mesh, now, base);
                length += more;
                area += swept;
                now = self.next(mesh, now);
            }
            loops.push((length, area));
        }
        loops
    }

    /// The boundary side after `side`: searches the cells around its second end for a side
    /// without a neighbor.
    fn next(&self, mesh: &SectionMesh, (cell, side): SideOf) -> SideOf {
        let after =
            |(cell, side): SideOf| (cell, (side + 1) % mesh.cells[cell].kind.corner_count());
        let mut found = after((cell, side));
        loop {
            let [first, second] = ends(mesh, found);
            match self.by_ends.get(&[second, first]) {
                Some(&neighbor) => found = after(neighbor),
                None => return found,
            }
        }
    }
}

/// Nodes at the ends of a side, counterclockwise in its cell.
fn ends(mesh: &SectionMesh, (cell, side): SideOf) -> [u32; 2] {
    let cell = &mesh.cells[cell];
    let (first, second, _) = cell.kind.side(side);
    [first, second].map(|local| cell.nodes()[local])
}

/// Length of a side \[m\], and the area between it and `base` \[m^2\].
///
/// ```text
/// length = int |dx/dxi| dxi        area = 1/2 int (y dz - z dy)
/// ```
fn measure(mesh: &SectionMesh, (cell, side): SideOf, base: [f64; 2]) -> (f64, f64) {
    let side = CellSide::new(mesh, &mesh.cells[cell], side);
    let (mut length, mut area) = (0.0, 0.0);
    for piece in 0..PIECES {
        let middle = (2 * piece + 1) as f64 / PIECES as f64 - 1.0;
        for &(xi, weight) in quadrature::line(POINTS) {
            let SidePoint { position, tangent } = side.at(middle + xi / PIECES as f64);
            let weight = weight / PIECES as f64;
            length += weight * tangent[0].hypot(tangent[1]);
            let [y, z] = [position[0] - base[0], position[1] - base[1]];
            area += 0.5 * weight * (y * tangent[1] - z * tangent[0]);
        }
    }
    (length, area)
}
