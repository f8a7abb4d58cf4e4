//! The warping of the section under each unit internal force, in six panels.

use nalgebra::DMatrix;
use shared_geom::figure::{
    Anchor, Color, Drawing, Figure, INK, Label, SMALL, TEXT, ValueTriangle, WIDTH, diverging,
};
use shared_geom::wrench::COMPONENTS;

use super::cell_pieces::{PIECE, Patterns};
use super::figure_parts::{THINNEST, draw_color_bar, draw_title, fill_cell};
use super::outline::{Outline, Side, SideRole, side_points};
use super::plane::{Extent, Plane};
use crate::mesh::distance;
use crate::section::Section;
use crate::solution::SectionSolution;

/// Largest in-plane displacement on the figure, relative to the section's size.
const EXAGGERATED: f64 = 0.07;
/// Margin around the displaced section, relative to its size.
const MARGIN: f64 = 0.02;
/// Ratio to the largest warping of the panel below which warping is zero.
const NONE: f64 = 1e-8;
/// Maximum height of the panels together [figure pixels].
const HIGHEST: f64 = 1900.0;
const EDGE: f64 = 50.0;
const GAP: f64 = 50.0;
/// Space for the two lines above a panel [figure pixels].
const HEADING: f64 = 115.0;
/// Space for the title of the figure, and for the color bar below the panels.
const TITLE: f64 = 100.0;
const BAR: f64 = 230.0;
/// Size of the pieces of a cell that have one color each, for walls so thin that their rims are
/// drawn too [figure pixels].
const FLAT: f64 = 5.0;
/// Sides shorter than `SHORT` are drawn straight if their middle is within `AS_STRAIGHT` of a
/// straight side's [figure pixels].
const SHORT: f64 = 12.0;
const AS_STRAIGHT: f64 = 0.05;
/// Color of the outline before warping.
const FAINT: Color = Color(150, 150, 150);

/// The figure of the warping of a section.
#[derive(Debug)]
pub struct WarpingPlot<'a> {
    section: &'a Section,
    warping: &'a DMatrix<f64>,
    sides: &'a [Side],
    /// Box of the section including its warping [m].
    extent: Extent,
    /// Larger side of the section's box [m].
    size: f64,
    /// Mean thickness of the walls [m].
    wall: f64,
    columns: usize,
    /// Width and height of the part of a panel below its heading [figure pixels].
    space: [f64; 2],
}

/// The contents of one panel.
struct Panel<'p> {
    plane: &'p Plane,
    component: usize,
    /// Largest warping along x, and in the plane [m/N or 1/N].
    largest: [f64; 2],
}

impl<'a> WarpingPlot<'a> {
    /// The figure of `solution` on `section`.
    pub fn new(section: &'a Section, outline: &'a Outline, solution: &'a SectionSolution) -> Self {
        let bare = Extent::of(section.mesh.nodes.iter().copied());
        let size = bare.largest();
        let extent = bare.grown((EXAGGERATED + MARGIN) * size);
        let (columns, space) = layout(&extent);
        Self {
            section,
            warping: &solution.warping,
            wall: outline.wall,
            sides: &outline.sides,
            extent,
            size,
            columns,
            space,
        }
    }

    /// Largest warping along x and in the plane, under one unit force.
    fn largest(&self, component: usize) -> [f64; 2] {
        let nodes = 0..self.section.mesh.nodes.len();
        let [along, squared] = nodes.fold([0.0_f64; 2], |[along, across], node| {
            let [ux, uy, uz] = self.of_node(node, component);
            [along.max(ux.abs()), across.max(uy * uy + uz * uz)]
        });
        [along, squared.sqrt()]
    }

    fn of_node(&self, node: usize, component: usize) -> [f64; 3] {
        [0, 1, 2].map(|axis| self.warping[(3 * node + axis, component)])
    }

    fn draw_panel(&self, drawing: &mut Drawing, component: usize) {
        let column = (component % self.columns) as f64;
        let row = (component / self.columns) as f64;
        let left = EDGE + column * (self.space[0] + GAP);
        let top = TITLE + row * (HEADING + self.space[1] + GAP);
        let plane = Plane::fitted(self.extent, [left, top + HEADING], self.space);
        let panel = Panel {
            plane: &plane,
            component,
            largest: self.largest(component),
        };
        let middle = left + 0.5 * self.space[0];
        let label = Label::new(TEXT).anchored(Anchor::Middle);
        drawing.text(&title(component), [middle, top + 28.0], label.bold());
        let words = Label {
            size: SMALL,
            color: INK,
            ..label
        };
        drawing.text(&panel.words(), [middle, top + 76.0], words);
        self.draw_cells(drawing, &panel);
        self.draw_outlines(drawing, &panel);
    }

    /// Fills the cells with the colors of their axial warping.
    fn draw_cells(&self, drawing: &mut Drawing, panel: &Panel<'_>) {
        let thin = self.wall * panel.plane.scale < THINNEST;
        let mut patterns = Patterns::new(if thin { FLAT } else { PIECE });
        let mut points = Vec::new();
        let mut triangles = Vec::with_capacity(self.section.mesh.cells.len());
        for cell in &self.section.mesh.cells {
            // position on the figure, and relative warping
            let mut nodes = [[0.0; 3]; 9];
            for (at, &node) in nodes.iter_mut().zip(cell.nodes()) {
                let [x, y] = panel.plane.position(self.section.mesh.nodes[node as usize]);
                let axial = self.warping[(3 * node as usize, panel.component)];
                *at = [x, y, panel.relative(axial)];
            }
            let triangle = |corners: [[f64; 3]; 3]| ValueTriangle {
                corners: corners.map(|[x, y, _]| [x, y]),
                values: corners.map(|[_, _, value]| value),
            };
            if let Some(corners) = patterns.of_corners(cell.kind, &nodes) {
                triangles.extend(corners.iter().map(|t| triangle(t.map(|k| nodes[k]))));
                continue;
            }
            let pattern = patterns.of(cell.kind, &nodes, 1);
            points.clear();
            points.extend(pattern.at(&nodes));
            let corners = pattern.triangles.iter();
            triangles.extend(corners.map(|corners| triangle(corners.map(|k| points[k]))));
        }
        if !thin {
            drawing.shade(triangles, diverging);
            return;
        }
        for triangle in &triangles {
            let color = diverging(triangle.mean());
            fill_cell(drawing, &triangle.corners, color, true);
        }
    }

    /// The outline before and after the warping in the plane.
    fn draw_outlines(&self, drawing: &mut Drawing, panel: &Panel<'_>) {
        let factor = if panel.has_in_plane() {
            EXAGGERATED * self.size / panel.largest[1]
        } else {
            0.0
        };
        let before = |node: u32| panel.plane.position(self.section.mesh.nodes[node as usize]);
        let after = |node: u32| {
            let [y, z] = self.section.mesh.nodes[node as usize];
            let [_, uy, uz] = self.of_node(node as usize, panel.component);
            panel.plane.position([y + factor * uy, z + factor * uz])
        };
        let boundary = || {
            self.sides
                .iter()
                .filter(|side| side.role == SideRole::Boundary)
        };
        let thin = self.wall * panel.plane.scale < THINNEST;
        for side in boundary().filter(|_| !thin) {
            drawing.line(&side_points(side.ends, side.middle, &before), 1.5, FAINT);
        }
        for side in boundary().filter(|_| panel.has_in_plane()) {
            let [a, b] = side.ends.map(after);
            let mean = [0, 1].map(|axis| 0.5 * (a[axis] + b[axis]));
            let is_long = distance(a, b) > SHORT;
            let is_curved = |&m: &u32| is_long || distance(after(m), mean) > AS_STRAIGHT;
            let middle = side.middle.filter(is_curved);
            drawing.line(&side_points(side.ends, middle, &after), 2.5, INK);
        }
    }

    fn draw_bar(&self, drawing: &mut Drawing) {
        let (width, height) = drawing.size();
        let (left, right) = (0.3 * width, 0.7 * width);
        let (top, bottom) = (height - BAR + 30.0, height - BAR + 66.0);
        let name = "warping along x over its largest [-]";
        let corners = [[left, top], [right, bottom]];
        draw_color_bar(drawing, corners, ([-1.0, 1.0], name), diverging);
        let words = "dark outline: warping in the plane, exaggerated; \
            above each panel: the largest along x and in the y-z plane";
        let label = Label::new(SMALL).colored(INK).anchored(Anchor::Middle);
        drawing.text(words, [0.5 * width, bottom + 136.0], label);
    }
}

impl Figure for WarpingPlot<'_> {
    fn size(&self) -> (u32, u32) {
        let rows = COMPONENTS.len().div_ceil(self.columns) as f64;
        let height = TITLE + rows * (HEADING + self.space[1] + GAP) + BAR;
        (WIDTH, height.ceil() as u32)
    }

    fn draw(&self, drawing: &mut Drawing) {
        let title = [
            self.section.name.as_str(),
            ": warping per unit internal force",
        ];
        let space = f64::from(WIDTH) - 2.0 * EDGE;
        draw_title(drawing, title, [EDGE, 45.0], space);
        for component in 0..COMPONENTS.len() {
            self.draw_panel(drawing, component);
        }
        self.draw_bar(drawing);
    }
}

impl Panel<'_> {
    fn has_axial(&self) -> bool {
        self.largest[0] > NONE * self.largest[1]
    }

    fn has_in_plane(&self) -> bool {
        self.largest[1] > NONE * self.largest[0]
    }

    /// Axial warping relative to the largest of the panel, zero if there is no warping.
    fn relative(&self, axial: f64) -> f64 {
        if self.has_axial() {
            axial / self.largest[0]
        } else {
            0.0
        }
    }

    /// The largest values, short enough for a third of the figure.
    fn words(&self) -> String {
        let unit = if self.component < 3 { "m/N" } else { "1/N" };
        let value = |is_there: bool, value: f64| {
            if is_there {
                format!("{value:.2e}")
            } else {
                "0".to_owned()
            }
        };
        let along = value(self.has_axial(), self.largest[0]);
        let across = value(self.has_in_plane(), self.largest[1]);
        format!("x: {along}, y-z: {across} {unit}")
    }
}

/// `torsion, 1 N m`.
fn title(component: usize) -> String {
    let unit = if component < 3 { "1 N" } else { "1 N m" };
    format!("{}, {unit}", COMPONENTS[component])
}

/// The number of columns, and the size of a panel, with the largest drawing of the section.
fn layout(extent: &Extent) -> (usize, [f64; 2]) {
    let aspect = extent.size(1) / extent.size(0);
    let fit = |columns: usize| {
        let rows = COMPONENTS.len() / columns;
        let width = (f64::from(WIDTH) - 2.0 * EDGE - GAP * (columns - 1) as f64) / columns as f64;
        let highest = HIGHEST / rows as f64 - HEADING - GAP;
        let height = (width * aspect).min(highest);
        (columns, [width, height])
    };
    let drawn = |(_, space): &(usize, [f64; 2])| space[0].min(space[1] / aspect);
    // Three columns leave enough width for the text above a panel; six do not.
    let best = [1, 2, 3]
        .map(fit)
        .into_iter()
        .max_by(|a, b| drawn(a).total_cmp(&drawn(b)));
    best.unwrap_or_else(|| fit(3))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wide_sections_are_above_each_other() {
        let extent = |width: f64, height: f64| Extent {
            low: [0.0; 2],
            high: [width, height],
        };
        assert_eq!(layout(&extent(1.0, 0.1)).0, 1);
        assert_eq!(layout(&extent(1.0, 1.0)).0, 3);
        assert_eq!(layout(&extent(0.1, 1.0)).0, 3);
    }
}
