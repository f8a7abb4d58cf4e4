//! The plies of a wall one by one, if they are too thin to be seen in the figure.
//!
//! A straight cut runs from the middle of a side of the boundary along its normal to the other
//! face of the wall; consecutive cells of one material and fiber angle are a ply.

use shared_geom::figure::{Anchor, Color, Drawing, INK, Label, SMALL, TEXT, WIDTH, tick_label};

use super::figure_parts::{LEFT, RIGHT, boxed};
use super::outline::{Outline, Side, SideRole};
use super::plane::{Plane, PlotUnit};
use super::text::rounded;
use crate::mesh::distance;
use crate::section::{CellMaterial, Section};

/// Thickness below which plies are also shown next to the figure [figure pixels].
const THIN: f64 = 12.0;
/// Maximum number of cuts tried.
const CUTS: usize = 400;
/// Sine of the largest oblique angle between a cut and the normal of a ply.
const OBLIQUE: f64 = 0.35;
/// Height of a row, and of the part above the first row [figure pixels].
const ROW: f64 = 46.0;
const HEADING: f64 = 80.0;
/// Maximum number of rows of a column, and of columns.
const ROWS: usize = 12;
const COLUMNS: usize = 2;
/// Width of a ply of the strip [figure pixels].
const BOX: f64 = 110.0;
/// Length of the cut beyond the wall, at its first end so that its number is clear of the flags, and
/// at the other one [figure pixels].
const BEYOND: [f64; 2] = [48.0, 26.0];

/// A ply of a wall.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Ply {
    /// A cell of it.
    cell: usize,
    /// Thickness along the cut [m].
    thickness: f64,
}

/// The plies of a wall.
#[derive(Debug)]
pub(super) struct LayupStrip {
    plies: Vec<Ply>,
    /// Both ends of the cut (y, z), its first ply at the first [m].
    ends: [[f64; 2]; 2],
}

impl LayupStrip {
    /// The wall with the most plies, if it has more than two and one of them is too thin to be
    /// seen, with `scale` figure pixels per meter.
    pub fn new(section: &Section, outline: &Outline, scale: f64) -> Option<Self> {
        let of_cells = sides_of_cells(section, &outline.sides);
        let boundary = outline.sides.iter().enumerate();
        let boundary = boundary.filter(|(_, side)| side.role == SideRole::Boundary);
        let boundary: Vec<usize> = boundary.map(|(number, _)| number).collect();
        let step = boundary.len().div_ceil(CUTS).max(1);
        let cuts = boundary.iter().step_by(step);
        let walls = cuts.filter_map(|&side| cut(section, &outline.sides, &of_cells, side));
        // the first of several with the same number
        let wall = walls.reduce(|best, wall| {
            if wall.plies.len() > best.plies.len() {
                wall
            } else {
                best
            }
        })?;
        let thinnest = wall.plies.iter().map(|ply| ply.thickness);
        let thinnest = thinnest.fold(f64::INFINITY, f64::min);
        (wall.plies.len() > 2 && thinnest * scale < THIN).then_some(wall)
    }

    /// Rows of a column.
    fn rows(&self) -> usize {
        self.plies.len().div_ceil(COLUMNS).min(ROWS)
    }

    /// Height of the strip \[figure pixels\].
    pub fn height(&self) -> f64 {
        HEADING + ROW * (self.rows() as f64 + 0.5)
    }

    /// Draws the cut across the wall, with a number at its first end.
    pub fn draw_cut(&self, drawing: &mut Drawing, plane: &Plane) {
        let [a, b] = self.ends.map(|end| plane.position(end));
        let length = distance(a, b).max(1e-9);
        let along = [0, 1].map(|axis| (b[axis] - a[axis]) / length);
        let at = |from: [f64; 2], by: f64| [0, 1].map(|axis| from[axis] + by * along[axis]);
        drawing.line(&[at(a, -BEYOND[0]), at(b, BEYOND[1])], 3.5, INK);
        let label = Label::new(TEXT).bold().colored(INK);
        let label = label.anchored(Anchor::Middle);
        drawing.text("1", at(a, -BEYOND[0] - 0.6 * TEXT), label);
    }

    /// Draws the plies below each other from the first end of the cut, in the colors of their
    /// cells and with equal heights.
    pub fn draw(
        &self,
        drawing: &mut Drawing,
        (section, unit): (&Section, &PlotUnit),
        top: f64,
        color: impl Fn(usize) -> Color,
    ) {
        let label = Label::new(SMALL).colored(INK);
        let words = "plies of the wall along the cut, from the end called 1:";
        drawing.text(words, [LEFT, top + 0.4 * HEADING], label);
        let width = (f64::from(WIDTH) - LEFT - RIGHT) / COLUMNS as f64;
        let shown = self.plies.len().min(COLUMNS * ROWS);
        for (number, ply) in self.plies.iter().take(shown).enumerate() {
            let left = LEFT + width * (number / self.rows()) as f64;
            let above = top + HEADING + ROW * (number % self.rows()) as f64;
            let (right, below) = (left + BOX, above + ROW);
            let corners = boxed([left, above], [right, below]);
            drawing.polygon(&corners, color(ply.cell));
            drawing.outline(&corners, 2.0, INK);
            let left_out = self.plies.len() - shown;
            let text = if number + 1 == shown && left_out > 0 {
                format!("and {} more plies", left_out + 1)
            } else {
                ply.words(section, unit, number + 1)
            };
            let text = drawing.shortened(&text, label, width - BOX - 40.0);
            drawing.text(&text, [right + 20.0, above + 0.5 * ROW], label);
        }
    }
}

impl Ply {
    /// `3: 45 deg, 0.127 mm, graphite`; without angle if the material has no directions.
    fn words(&self, section: &Section, unit: &PlotUnit, number: usize) -> String {
        let made = &section.cells[self.cell];
        let angle = if section.has_directions(self.cell) {
            let degrees = rounded(made.fiber_angle.to_degrees());
            format!("{} deg, ", tick_label(degrees, 90.0))
        } else {
            String::new()
        };
        let thickness = tick_label(rounded(self.thickness / unit.meters), 0.0);
        let material = section.materials.get(made.material);
        let material = material.map_or("", |material| &material.name);
        format!("{number}: {angle}{thickness} {}, {material}", unit.name)
    }
}

/// Numbers of the sides of each cell; triangles have one side less.
fn sides_of_cells(section: &Section, sides: &[Side]) -> Vec<[Option<u32>; 4]> {
    let mut of_cells = vec![[None; 4]; section.mesh.cells.len()];
    for (side, number) in sides.iter().zip(0..) {
        for cell in [Some(side.cell), side.other].into_iter().flatten() {
            let free = of_cells[cell].iter_mut().find(|known| known.is_none());
            if let Some(free) = free {
                *free = Some(number);
            }
        }
    }
    of_cells
}

/// Cuts the wall from the side of the boundary with this number to its other face; `None` if
/// the cut runs along plies or out of cells.
fn cut(
    section: &Section,
    sides: &[Side],
    of_cells: &[[Option<u32>; 4]],
    start: usize,
) -> Option<LayupStrip> {
    let ends = |side: &Side| side.ends.map(|node| section.mesh.nodes[node as usize]);
    let [a, b] = ends(&sides[start]);
    let origin = [0, 1].map(|axis| 0.5 * (a[axis] + b[axis]));
    let length = distance(a, b);
    // the cell is on the left of its side
    let along = [(a[1] - b[1]) / length, (b[0] - a[0]) / length];
    let (mut cell, mut entry, mut depth) = (sides[start].cell, start, 0.0);
    let mut plies: Vec<Ply> = Vec::new();
    for _ in 0..section.mesh.cells.len() {
        let made = &section.cells[cell];
        let (sine, cosine) = made.plane_angle.sin_cos();
        if (along[0] * cosine + along[1] * sine).abs() > OBLIQUE {
            return None;
        }
        let others = of_cells[cell].iter().flatten().map(|&side| side as usize);
        let crossed = others.filter(|&side| side != entry).filter_map(|side| {
            let depth = crossing(origin, along, ends(&sides[side]))?;
            Some((side, depth))
        });
        let (exit, reached) = crossed.max_by(|(_, a), (_, b)| a.total_cmp(b))?;
        let thickness = (reached - depth).max(0.0);
        match plies.last_mut() {
            Some(ply) if is_same(&section.cells[ply.cell], made) => ply.thickness += thickness,
            _ => plies.push(Ply { cell, thickness }),
        }
        (entry, depth) = (exit, reached);
        let side = &sides[exit];
        match side.other {
            Some(other) if side.cell == cell => cell = other,
            Some(_) => cell = side.cell,
            None => {
                let end = [0, 1].map(|axis| origin[axis] + depth * along[axis]);
                return Some(LayupStrip {
                    plies,
                    ends: [origin, end],
                });
            }
        }
    }
    None
}

fn is_same(one: &CellMaterial, other: &CellMaterial) -> bool {
    one.material == other.material && (one.fiber_angle - other.fiber_angle).abs() < 1e-6
}

/// Distance along the line from `origin` to its crossing with the straight side between these
/// ends; `None` if they do not cross.
fn crossing(origin: [f64; 2], along: [f64; 2], [a, b]: [[f64; 2]; 2]) -> Option<f64> {
    let (side, to) = (
        [b[0] - a[0], b[1] - a[1]],
        [a[0] - origin[0], a[1] - origin[1]],
    );
    let cross = |p: [f64; 2], q: [f64; 2]| p[0] * q[1] - p[1] * q[0];
    let turn = cross(along, side);
    let part = cross(to, along) / turn;
    let depth = cross(to, side) / turn;
    // at a node it crosses both sides
    ((-1e-6..=1.0 + 1e-6).contains(&part) && depth.is_finite()).then_some(depth)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::section::samples::of_quadrilaterals;

    /// A strip of 20 x 6 cells of 10 by 0.1: five plies, the middle one two cells thick. Cuts
    /// from the ends of the strip run along plies and are rejected.
    #[test]
    fn plies_are_distinguished_from_one_face_to_the_other() {
        let nodes =
            (0..=6).flat_map(|j| (0..=20).map(move |i| [10.0 * f64::from(i), 0.1 * f64::from(j)]));
        let nodes: Vec<[f64; 2]> = nodes.collect();
        let square = |i: u32, j: u32| {
            let low = 21 * j + i;
            [low, low + 1, low + 22, low + 21]
        };
        let cells: Vec<_> = (0..6)
            .flat_map(|j| (0..20).map(move |i| square(i, j)))
            .collect();
        let mut section = of_quadrilaterals(&nodes, &cells);
        for (k, made) in section.cells.iter_mut().enumerate() {
            made.plane_angle = 0.0;
            made.fiber_angle = [45.0_f64, -45.0, 0.0, 0.0, -45.0, 45.0][k / 20].to_radians();
        }
        let outline = Outline::new(&section);
        let strip = LayupStrip::new(&section, &outline, 1.0).unwrap();
        let thickness: Vec<_> = strip.plies.iter().map(|ply| ply.thickness).collect();
        assert_eq!(thickness.len(), 5);
        for (found, expected) in thickness.iter().zip([0.1, 0.1, 0.2, 0.1, 0.1]) {
            assert!((found - expected).abs() < 1e-12, "{found}");
        }
        let [[y, low], [end, high]] = strip.ends;
        assert_eq!((y, end), (5.0, 5.0));
        assert!((low - 0.0).abs() < 1e-12 && (high - 0.6).abs() < 1e-12);
        // plies that can be seen need no strip
        assert!(LayupStrip::new(&section, &outline, 200.0).is_none());
    }
}
