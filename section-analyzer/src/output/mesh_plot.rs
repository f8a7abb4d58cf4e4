//! The mesh in the colors of its materials, with the centers of the section.

use shared_geom::figure::{
    Anchor, BLACK, Color, Drawing, Figure, INK, Label, SMALL, WHITE, WIDTH, tick_label,
};

use super::cell_colors::fill_cells;
use super::figure_parts::{BELOW, HIGHEST, LEFT, RIGHT, SPARED, THINNEST, TOP, draw_title};
use super::material_colors::MaterialColors;
use super::outline::{Outline, Side, SideRole, side_points};
use super::plane::{Extent, Plane, PlotUnit};
use super::text::rounded;
use crate::input::InputSummary;
use crate::properties::Centers;
use crate::section::Section;

/// Height of a line of the legend [figure pixels].
const LINE: f64 = 62.0;
/// Width below which cells are drawn without the lines between them.
const NARROWEST: f64 = 7.0;
/// Distance above which centers are not drawn, relative to the size of the section.
const REACH: f64 = 1.0;
/// Lines between cells of one material are darker than the cells by this factor.
const SHADE: f64 = 0.62;
/// Width of the white rim of a mark [figure pixels].
const RIM: f64 = 2.25;

/// The figure of a mesh.
#[derive(Debug)]
pub struct MeshPlot<'a> {
    section: &'a Section,
    unit: PlotUnit,
    /// Larger side of the section's box [m].
    size: f64,
    plane: Plane,
    sides: &'a [Side],
    marks: Vec<Mark>,
    colors: MaterialColors,
    /// Width of the walls on the figure [figure pixels].
    wall: f64,
    /// Width of the cells on the figure [figure pixels].
    cell: f64,
}

/// A point of the section with a name.
#[derive(Debug, Clone, Copy)]
struct Mark {
    name: &'static str,
    position: [f64; 2],
    shape: Shape,
}

/// Shapes that can be distinguished even if they overlap.
#[derive(Debug, Clone, Copy)]
enum Shape {
    Disc,
    Triangle,
    Ring,
    Cross,
}

impl<'a> MeshPlot<'a> {
    /// The figure of `section`; without centers if the analysis failed.
    pub fn new(
        section: &'a Section,
        outline: &'a Outline,
        summary: &InputSummary,
        centers: Option<&Centers>,
    ) -> Self {
        let bare = Extent::of(section.mesh.nodes.iter().copied());
        let size = bare.largest();
        let marks = marks(centers);
        let mut extent = bare;
        let near = bare.grown(REACH * size);
        for mark in &marks {
            if near.holds(mark.position) {
                extent.include(mark.position);
            }
        }
        let space = [f64::from(WIDTH) - LEFT - RIGHT, HIGHEST];
        let plane = Plane::fitted(extent.grown(0.05 * size), [LEFT, TOP], space);
        Self {
            section,
            unit: PlotUnit::of(summary, size),
            size,
            wall: outline.wall * plane.scale,
            cell: outline.cell * plane.scale,
            plane,
            sides: &outline.sides,
            marks,
            colors: MaterialColors::new(section),
        }
    }

    fn draw_title(&self, drawing: &mut Drawing) {
        let section = self.section;
        let space = f64::from(WIDTH) - LEFT - RIGHT;
        draw_title(drawing, [&section.name, ""], [LEFT, 50.0], space);
        let line = format!(
            "{} nodes, {} cells{}",
            section.mesh.nodes.len(),
            section.mesh.cells.len(),
            self.true_scale()
        );
        drawing.text(&line, [LEFT, 105.0], Label::new(SMALL).colored(INK));
    }

    /// Note on walls that are drawn wider than in reality.
    fn true_scale(&self) -> String {
        let wall = self.wall / self.plane.scale;
        if self.wall < THINNEST {
            format!(
                "; walls drawn {THINNEST} pixels wide, actual width about {} {} ({:.1} pixels)",
                tick_label(rounded(wall / self.unit.meters), 0.0),
                self.unit.name,
                self.wall,
            )
        } else {
            String::new()
        }
    }

    fn draw_cells(&self, drawing: &mut Drawing) {
        let section = self.section;
        let position = |node: u32| self.plane.position(section.mesh.nodes[node as usize]);
        let color = |cell: usize| self.colors.of(section.cells[cell].material);
        let is_thin = self.wall < THINNEST;
        fill_cells(drawing, (section, self.sides), &position, color, is_thin);
        if is_thin {
            return;
        }
        for side in self.sides {
            let (width, color) = match side.role {
                SideRole::Boundary if self.wall > 40.0 => (3.0, INK),
                SideRole::Interface if self.wall > 40.0 => (2.0, INK),
                SideRole::Boundary | SideRole::Interface => (1.6, INK),
                SideRole::Inner(_) if self.cell < NARROWEST => continue,
                SideRole::Inner(material) => (1.2, shaded(self.colors.of(material))),
            };
            drawing.line(
                &side_points(side.ends, side.middle, &position),
                width,
                color,
            );
        }
    }

    fn draw_marks(&self, drawing: &mut Drawing) {
        for mark in self
            .marks
            .iter()
            .filter(|mark| self.plane.shows(mark.position))
        {
            let rim = if self.wall < SPARED { 0.0 } else { RIM };
            mark.shape
                .draw(drawing, self.plane.position(mark.position), rim);
        }
    }

    fn draw_legend(&self, drawing: &mut Drawing) {
        let top = TOP + self.plane.frame[1] + BELOW + 0.5 * LINE;
        let label = Label::new(SMALL).colored(INK);
        let second = 0.42 * f64::from(WIDTH);
        let rows = (LINE, second - LEFT - 34.0);
        self.colors.draw(drawing, [LEFT, top], rows);
        for (row, mark) in self.marks.iter().enumerate() {
            let y = top + LINE * row as f64;
            mark.shape.draw_in_legend(drawing, [second, y]);
            let [at_y, at_z] = mark.position.map(|value| self.unit.shown(value, self.size));
            let beyond = if self.plane.shows(mark.position) {
                ""
            } else {
                ", outside of the figure"
            };
            let text = format!("{} ({at_y}, {at_z}) {}{beyond}", mark.name, self.unit.name);
            drawing.text(&text, [second + 50.0, y], label.anchored(Anchor::Start));
        }
    }
}

impl Figure for MeshPlot<'_> {
    fn size(&self) -> (u32, u32) {
        let rows = self.colors.rows().max(self.marks.len()) as f64;
        let height = TOP + self.plane.frame[1] + BELOW + LINE * rows + 0.5 * LINE;
        (WIDTH, height.ceil() as u32)
    }

    fn draw(&self, drawing: &mut Drawing) {
        self.draw_title(drawing);
        self.plane.draw_axes(drawing, &self.unit);
        self.draw_cells(drawing);
        self.draw_marks(drawing);
        self.draw_legend(drawing);
    }
}

impl Shape {
    /// Draws the shape in black with a white rim \[figure pixels\]. Ring, triangle and cross
    /// around one point do not overlap.
    fn draw(self, drawing: &mut Drawing, center: [f64; 2], rim: f64) {
        let [x, y] = center;
        let at = |[dx, dy]: [f64; 2]| [x + dx, y + dy];
        let lines = match self {
            Self::Disc => {
                // the largest width that the dot leaves inside of the ring
                drawing.disc(center, 5.0 + rim.min(2.0), WHITE);
                drawing.disc(center, 5.0, BLACK);
                return;
            }
            Self::Ring => {
                for (width, color) in strokes(rim) {
                    drawing.ring(center, 11.0, width, color);
                }
                return;
            }
            Self::Triangle => {
                let [top, right, left] = [[0.0, -34.0], [29.5, 17.0], [-29.5, 17.0]].map(at);
                vec![vec![top, right, left, top]]
            }
            Self::Cross => vec![
                [[-46.0, 0.0], [46.0, 0.0]].map(at).to_vec(),
                [[0.0, -46.0], [0.0, 46.0]].map(at).to_vec(),
            ],
        };
        for (width, color) in strokes(rim) {
            for line in &lines {
                drawing.line(line, width, color);
            }
        }
    }

    /// Draws the shape small enough for a line of the legend.
    fn draw_in_legend(self, drawing: &mut Drawing, [x, y]: [f64; 2]) {
        match self {
            Self::Cross => {
                drawing.line(&[[x - 26.0, y], [x + 26.0, y]], 3.5, BLACK);
                drawing.line(&[[x, y - 26.0], [x, y + 26.0]], 3.5, BLACK)
            }
            Self::Triangle => self.draw(drawing, [x, y + 8.0], RIM),
            Self::Ring | Self::Disc => self.draw(drawing, [x, y], RIM),
        }
    }
}

/// Widths and colors of the strokes of a mark: with a white rim below the black one, if any.
fn strokes(rim: f64) -> impl Iterator<Item = (f64, Color)> {
    let below = (rim > 0.0).then_some((3.5 + 2.0 * rim, WHITE));
    below.into_iter().chain([(3.5, BLACK)])
}

fn shaded(Color(r, g, b): Color) -> Color {
    let dark = |channel: u8| (SHADE * f64::from(channel)).round() as u8;
    Color(dark(r), dark(g), dark(b))
}

fn marks(centers: Option<&Centers>) -> Vec<Mark> {
    let mark = |name, position, shape| Mark {
        name,
        position,
        shape,
    };
    let mut marks = vec![mark("reference point", [0.0; 2], Shape::Cross)];
    if let Some(centers) = centers {
        marks.push(mark("shear center", centers.shear, Shape::Triangle));
        marks.extend(
            centers
                .mass
                .map(|position| mark("mass center", position, Shape::Ring)),
        );
        marks.push(mark("tension center", centers.tension, Shape::Disc));
    }
    marks
}
