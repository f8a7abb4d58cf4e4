//! Sides of cells as lines to draw: curved sides as curves, boundaries distinguished
//! from sides between cells.

use shared_geom::lagrange::line3;

use crate::mesh::{SectionCell, polygon_area};
use crate::section::Section;

/// Chords by which a curved side is drawn.
const PIECES: usize = 8;
/// Deviation of a middle node from the chord, relative to its length, below which
/// a side is drawn straight.
const STRAIGHT: f64 = 1e-4;

/// Kind of a side, by its adjacent cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SideRole {
    /// One cell only.
    Boundary,
    /// Cells of different parts.
    Interface,
    /// Cells of one part, with its number.
    Inner(usize),
}

/// A side of one or two cells: its ends, and its middle if it is quadratic.
#[derive(Debug, Clone, Copy)]
pub(super) struct Side {
    pub ends: [u32; 2],
    pub middle: Option<u32>,
    pub role: SideRole,
    /// The first adjacent cell, on its left.
    pub cell: usize,
    /// Number of the side in that cell.
    pub local: usize,
    /// The second adjacent cell.
    pub other: Option<usize>,
}

/// The sides of a section and its widths, which all figures of it share.
#[derive(Debug)]
pub struct Outline {
    /// Every side of the mesh, once, in the order of the cells; parts are materials.
    pub(super) sides: Vec<Side>,
    /// Mean thickness of the walls, and mean width of the cells [m].
    pub(super) wall: f64,
    pub(super) cell: f64,
}

impl Outline {
    /// The outline of the cells of `section`.
    pub fn new(section: &Section) -> Self {
        let sides = sides_by(&section.mesh.cells, |cell| section.cells[cell].material);
        let (wall, cell) = widths(section, &sides);
        Self { sides, wall, cell }
    }
}

/// Every side of the mesh, once, in the order of the cells, with the part of each cell given by
/// `part`.
pub(super) fn sides_by(cells: &[SectionCell], part: impl Fn(usize) -> usize) -> Vec<Side> {
    let mut sides: Vec<Side> = Vec::new();
    let mut known = KnownSides::default();
    for (index, cell) in cells.iter().enumerate() {
        for (local, (ends, middle)) in cell.kind.sides(cell.nodes()).enumerate() {
            if let Some(side) = known.find_or_add(ends) {
                let side = &mut sides[side];
                side.other = Some(index);
                side.role = match (part(side.cell), part(index)) {
                    (one, other) if one == other => SideRole::Inner(one),
                    _ => SideRole::Interface,
                };
                continue;
            }
            sides.push(Side {
                ends,
                middle,
                role: SideRole::Boundary,
                cell: index,
                local,
                other: None,
            });
        }
    }
    sides
}

/// Numbers of sides by their ends, in the order of addition.
///
/// Few sides meet in a node: each node has a list of the sides whose lower end it is.
#[derive(Debug, Default)]
struct KnownSides {
    /// The last side of each node.
    last: Vec<Option<usize>>,
    /// Upper end of each side, and the previous side in its list.
    entries: Vec<(u32, Option<usize>)>,
}

impl KnownSides {
    /// The number of the side between these nodes; a new side is added and gives `None`.
    fn find_or_add(&mut self, [a, b]: [u32; 2]) -> Option<usize> {
        let (low, high) = (a.min(b) as usize, a.max(b));
        if self.last.len() <= low {
            self.last.resize(low + 1, None);
        }
        let mut next = self.last[low];
        while let Some(side) = next {
            let (end, before) = self.entries[side];
            if end == high {
                return Some(side);
            }
            next = before;
        }
        let before = self.last[low].replace(self.entries.len());
        self.entries.push((high, before));
        None
    }
}

/// The points of a side, with the nodes at the positions `position`: two for a straight side.
pub(super) fn side_points(
    ends: [u32; 2],
    middle: Option<u32>,
    position: &impl Fn(u32) -> [f64; 2],
) -> Vec<[f64; 2]> {
    let mut points = Vec::with_capacity(2);
    add_side(&mut points, ends.map(position), middle.map(position));
    points
}

/// Adds the points of a side between these ends.
fn add_side(points: &mut Vec<[f64; 2]>, [a, b]: [[f64; 2]; 2], middle: Option<[f64; 2]>) {
    let mean = [0, 1].map(|axis| 0.5 * (a[axis] + b[axis]));
    let is_straight = |m: &[f64; 2]| squared(*m, mean) <= STRAIGHT * STRAIGHT * squared(a, b);
    let Some(m) = middle.filter(|m| !is_straight(m)) else {
        return points.extend([a, b]);
    };
    let point = |piece: usize| {
        let shape = line3(2.0 * piece as f64 / PIECES as f64 - 1.0);
        [0, 1].map(|axis| shape.n[0] * a[axis] + shape.n[1] * b[axis] + shape.n[2] * m[axis])
    };
    points.extend((0..=PIECES).map(point));
}

/// The corners of the polygon by which a cell is drawn.
pub(super) fn cell_points(
    cell: &SectionCell,
    position: &impl Fn(u32) -> [f64; 2],
) -> Vec<[f64; 2]> {
    let mut points = Vec::with_capacity(4);
    add_cell(&mut points, cell, position);
    points
}

/// Adds the corners of the polygon that a cell is drawn as.
fn add_cell(points: &mut Vec<[f64; 2]>, cell: &SectionCell, position: &impl Fn(u32) -> [f64; 2]) {
    for (ends, middle) in cell.kind.sides(cell.nodes()) {
        add_side(points, ends.map(position), middle.map(position));
        // the last point of a side is the first of the next
        points.pop();
    }
}

/// Mean thickness of the walls (area over half the length of the boundary), and
/// mean width of the cells (area over a quarter of their circumference) [m].
pub(super) fn widths(section: &Section, sides: &[Side]) -> (f64, f64) {
    let position = |node: u32| section.mesh.nodes[node as usize];
    let mut points = Vec::new();
    let mut boundary = 0.0;
    for side in sides.iter().filter(|side| side.role == SideRole::Boundary) {
        points.clear();
        add_side(
            &mut points,
            side.ends.map(position),
            side.middle.map(position),
        );
        boundary += length(&points);
    }
    let (mut area, mut width) = (0.0, 0.0);
    for cell in &section.mesh.cells {
        points.clear();
        add_cell(&mut points, cell, &position);
        let cell_area = polygon_area(points.iter().copied());
        points.push(points[0]);
        area += cell_area;
        width += 4.0 * cell_area / length(&points);
    }
    (
        2.0 * area / boundary,
        width / section.mesh.cells.len().max(1) as f64,
    )
}

/// Length of a line through these points.
pub(super) fn length(points: &[[f64; 2]]) -> f64 {
    let pieces = points.windows(2);
    pieces.map(|pair| squared(pair[0], pair[1]).sqrt()).sum()
}

/// Square of the distance of two points.
fn squared(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::SectionMesh;
    use crate::mesh::generate::Tube;
    use crate::section::CellMaterial;
    use shared_geom::error::SourceLocation;
    use shared_geom::mesh::CellKind;
    use shared_geom::section::InitialCurvature;
    use std::f64::consts::PI;

    /// A tube of 24 x 2 cells, one half of each of two materials, in which the
    /// curved sides are drawn as 8 chords each.
    fn tube() -> Section {
        let tube = Tube {
            outer_radius: 1.0,
            thickness: 0.1,
            cells_around: 24,
            cells_through: 2,
            kind: CellKind::Quadrilateral9,
            curved: true,
        };
        let mesh = tube.generate().unwrap();
        let (mesh, _) = SectionMesh::from_mesh(&mesh, 1.0, &SourceLocation::file("tube")).unwrap();
        let material = |cell: &SectionCell| {
            let node = cell.nodes()[8] as usize;
            usize::from(mesh.nodes[node][1] > 0.0)
        };
        let cell = |cell| CellMaterial {
            material: material(cell),
            fiber_angle: 0.0,
            plane_angle: 0.0,
        };
        let cells = mesh.cells.iter().map(cell).collect();
        Section {
            name: "tube".into(),
            cells,
            mesh,
            materials: Vec::new(),
            initial_curvature: InitialCurvature::STRAIGHT,
            electrodes: Vec::new(),
        }
    }

    #[test]
    fn sides_are_counted_once_with_their_role() {
        let sides = Outline::new(&tube()).sides;
        let count =
            |role: fn(SideRole) -> bool| sides.iter().filter(|side| role(side.role)).count();
        assert_eq!(count(|role| role == SideRole::Boundary), 48);
        // the halves meet at two positions, each two cells thick
        assert_eq!(count(|role| role == SideRole::Interface), 4);
        assert_eq!(sides.len(), 24 * 3 + 24 * 2);
        assert_eq!(
            count(|role| matches!(role, SideRole::Inner(_))),
            24 * 3 + 24 * 2 - 52
        );
    }

    /// Thickness 0.1; the chords of 192 pieces around shorten the boundary by
    /// (pi/192)^2 / 6 = 5e-5 and more by the parabolas: 1e-3.
    #[test]
    fn walls_and_cells_have_their_width() {
        let section = tube();
        let Outline { wall, cell, .. } = Outline::new(&section);
        assert!((wall / 0.1 - 1.0).abs() < 1e-3, "{wall}");
        // cells of 0.05 by 0.95 * 2 pi / 24: four areas over the circumference
        let length = 0.95 * 2.0 * PI / 24.0;
        let expected = 2.0 * 0.05 * length / (0.05 + length);
        assert!((cell / expected - 1.0).abs() < 1e-2, "{cell} {expected}");
    }
}
