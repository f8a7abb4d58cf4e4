//! The fiber directions: the wall direction and its normal in a choice of cells, and the fiber
//! angle of every cell as its color; its material, if all fibers run along the beam.
//!
//! ```text
//!      ----> s      flag: the pole is the wall normal n, the arrow the wall
//!     |             direction s, both at the plane angle; the foot is in
//!     | n           the cell and has its color
//!     o
//! ```

use shared_geom::figure::{
    Anchor, Color, Drawing, Figure, INK, Label, SMALL, WHITE, WIDTH, diverging,
};

use super::cell_colors::fill_cells;
use super::figure_parts::{
    BELOW, HIGHEST, LEFT, RIGHT, SPARED, THINNEST, TOP, draw_color_bar, draw_title,
};
use super::layup_strip::LayupStrip;
use super::material_colors::MaterialColors;
use super::outline::{Outline, Side, SideRole, side_points};
use super::plane::{Extent, Plane, PlotUnit};
use crate::input::InputSummary;
use crate::mesh::distance;
use crate::section::Section;

/// Height of the legend with a color bar, and of one of its lines [figure pixels].
const LEGEND: f64 = 390.0;
const LINE: f64 = 54.0;
/// Least distance between feet of flags [figure pixels]; smaller if their arrows point in other
/// directions, as in a web and in the adjacent skins.
const SPACING: f64 = 105.0;
const CLOSE: f64 = 48.0;
/// Cosine of the angle from which arrows point in other directions.
const OTHER: f64 = 0.87;
/// Length of the pole and of the arrow of a flag [figure pixels].
const POLE: f64 = 34.0;
const ARROW: f64 = 62.0;
/// Width of the white rim of a flag [figure pixels].
const RIM: f64 = 2.5;
/// Margin around the section, for flags [figure pixels].
const MARGIN: f64 = 90.0;
/// Ends of the scale of angles, of which the least sufficient one is used [deg].
const SCALES: [f64; 4] = [15.0, 30.0, 60.0, 90.0];
/// Lines between cells [figure pixels].
const FAINT: Color = Color(120, 120, 120);

/// The figure of the fibers of a section.
#[derive(Debug)]
pub struct FiberPlot<'a> {
    section: &'a Section,
    unit: PlotUnit,
    plane: Plane,
    sides: &'a [Side],
    /// Width of the walls on the figure [figure pixels].
    wall: f64,
    /// End of the scale of angles [deg].
    scale: f64,
    /// Colors in place of the angles, if all of these are zero.
    materials: Option<MaterialColors>,
    /// Cells with a flag.
    flags: Vec<usize>,
    /// The plies of a wall, if they are too thin to be seen.
    layup: Option<LayupStrip>,
}

/// The fiber angle as the angle of a line, from -90 to 90 [deg].
fn line_angle(angle: f64) -> f64 {
    let degrees = angle.to_degrees();
    let turned = degrees - 180.0 * (degrees / 180.0).round();
    // so that rounding of the input does not make 90 and -90 of one ply
    if turned < -90.0 + 1e-6 { 90.0 } else { turned }
}

impl<'a> FiberPlot<'a> {
    /// The figure of `section`; `None` if all its materials are isotropic.
    pub fn new(section: &'a Section, outline: &'a Outline, summary: &InputSummary) -> Option<Self> {
        let cells = (0..section.cells.len()).filter(|&cell| section.has_directions(cell));
        let cells: Vec<_> = cells.collect();
        let angle = |&cell: &usize| line_angle(section.cells[cell].fiber_angle).abs();
        let largest = cells.iter().map(angle).reduce(f64::max)?;
        let scale = SCALES.into_iter().find(|scale| largest <= scale + 1e-6);
        let bare = Extent::of(section.mesh.nodes.iter().copied());
        let space = [f64::from(WIDTH) - LEFT - RIGHT, HIGHEST];
        // pixels are converted to meters before the frame is known: by the widest frame
        let pixel = (0..2).map(|axis| bare.size(axis) / (space[axis] - 2.0 * MARGIN));
        let margin = MARGIN * pixel.fold(0.0, f64::max);
        let plane = Plane::fitted(bare.grown(margin), [LEFT, TOP], space);
        let flags = spread(section, &plane, &cells);
        Some(Self {
            section,
            unit: PlotUnit::of(summary, bare.largest()),
            wall: outline.wall * plane.scale,
            layup: LayupStrip::new(section, outline, plane.scale),
            plane,
            sides: &outline.sides,
            scale: scale.unwrap_or(90.0),
            materials: (largest <= 1e-6).then(|| MaterialColors::new(section)),
            flags,
        })
    }

    /// Lower edge of the legend \[figure pixels\].
    fn bottom(&self) -> f64 {
        let materials = self.materials.as_ref();
        let height = materials.map_or(LEGEND, |colors| LINE * (colors.rows() as f64 + 3.5));
        TOP + self.plane.frame[1] + BELOW + height
    }

    fn color(&self, cell: usize) -> Color {
        if let Some(materials) = &self.materials {
            materials.of(self.section.cells[cell].material)
        } else if self.section.has_directions(cell) {
            let angle = line_angle(self.section.cells[cell].fiber_angle);
            diverging(angle / self.scale)
        } else {
            WHITE
        }
    }

    fn draw_cells(&self, drawing: &mut Drawing) {
        let position = |node: u32| self.plane.position(self.section.mesh.nodes[node as usize]);
        let is_thin = self.wall < THINNEST;
        let color = |cell| self.color(cell);
        fill_cells(
            drawing,
            (self.section, self.sides),
            &position,
            color,
            is_thin,
        );
        for side in self.sides {
            let (width, color) = match side.role {
                SideRole::Boundary => (2.0, INK),
                SideRole::Interface => (1.2, FAINT),
                SideRole::Inner(_) => continue,
            };
            drawing.line(
                &side_points(side.ends, side.middle, &position),
                width,
                color,
            );
        }
    }

    fn draw_flags(&self, drawing: &mut Drawing) {
        for &cell in &self.flags {
            let foot = self.plane.position(center(self.section, cell));
            let angle = self.section.cells[cell].plane_angle;
            let rim = if self.wall < SPARED { 0.0 } else { RIM };
            draw_flag(drawing, foot, angle, (self.color(cell), rim));
        }
    }

    fn draw_legend(&self, drawing: &mut Drawing) {
        let top = TOP + self.plane.frame[1] + BELOW;
        let label = Label::new(SMALL).colored(INK);
        let foot = [LEFT + 10.0, top + 1.1 * LINE];
        draw_flag(drawing, foot, 0.0, (WHITE, RIM));
        let beside = [foot[0] + ARROW + 16.0, foot[1] - POLE];
        drawing.text("s", beside, label);
        drawing.text(
            "n",
            [foot[0] - 20.0, foot[1] - 0.6 * POLE],
            label.anchored(Anchor::End),
        );
        let texts = self.legend_lines();
        for (row, line) in texts.iter().enumerate() {
            let y = top + LINE * (0.5 + row as f64);
            drawing.text(line, [LEFT + 130.0, y], label);
        }
        let left = LEFT + 130.0;
        let below = top + LINE * texts.len() as f64;
        if let Some(materials) = &self.materials {
            let rows = (LINE, f64::from(WIDTH) - RIGHT - left);
            materials.draw(drawing, [left, below + 0.5 * LINE], rows);
            return;
        }
        let top = below + 0.25 * LINE;
        let corners = [[left, top], [left + 900.0, top + 32.0]];
        let ends = [-self.scale, self.scale];
        let color = |angle: f64| diverging(angle / self.scale);
        draw_color_bar(drawing, corners, (ends, "fiber angle [deg]"), color);
    }

    fn legend_lines(&self) -> Vec<&'static str> {
        let mut lines = vec![
            "arrow: wall direction s, at the plane angle from +y",
            "pole: wall normal n = x cross s, x toward the reader",
        ];
        if self.materials.is_some() {
            lines.push("all fibers run along the beam (fiber angle 0); color: material");
            return lines;
        }
        lines.push("color: fiber angle, from x toward s; at 0 the fiber runs along the beam");
        let mut cells = 0..self.section.cells.len();
        if cells.any(|cell| !self.section.has_directions(cell)) {
            lines.push("white: isotropic cells");
        }
        lines
    }
}

impl Figure for FiberPlot<'_> {
    fn size(&self) -> (u32, u32) {
        let layup = self.layup.as_ref().map_or(0.0, LayupStrip::height);
        (WIDTH, (self.bottom() + layup).ceil() as u32)
    }

    fn draw(&self, drawing: &mut Drawing) {
        let title = [self.section.name.as_str(), ": fiber directions"];
        let space = f64::from(WIDTH) - LEFT - RIGHT;
        draw_title(drawing, title, [LEFT, 50.0], space);
        let line = format!(
            "flags in {} of {} cells{}",
            self.flags.len(),
            self.section.cells.len(),
            if self.wall < THINNEST {
                "; walls are drawn wider than in reality"
            } else {
                ""
            }
        );
        drawing.text(&line, [LEFT, 105.0], Label::new(SMALL).colored(INK));
        self.plane.draw_axes(drawing, &self.unit);
        self.draw_cells(drawing);
        self.draw_flags(drawing);
        self.draw_legend(drawing);
        let Some(layup) = &self.layup else {
            return;
        };
        layup.draw_cut(drawing, &self.plane);
        let color = |cell| self.color(cell);
        layup.draw(drawing, (self.section, &self.unit), self.bottom(), color);
    }
}

/// A flag on the figure: its cell, its foot [figure pixels] and its angle [rad].
#[derive(Debug, Clone, Copy)]
struct Flag {
    cell: usize,
    foot: [f64; 2],
    angle: f64,
}

impl Flag {
    fn of(section: &Section, plane: &Plane, cell: usize) -> Self {
        Self {
            cell,
            foot: plane.position(center(section, cell)),
            angle: section.cells[cell].plane_angle,
        }
    }

    fn distance(&self, other: &Self) -> f64 {
        distance(self.foot, other.foot)
    }

    fn has_other_direction(&self, other: &Self) -> bool {
        (self.angle - other.angle).cos() < OTHER
    }

    /// Whether the arrows of both can be distinguished.
    fn leaves_space(&self, other: &Self) -> bool {
        let distance = self.distance(other);
        distance >= SPACING || (distance >= CLOSE && self.has_other_direction(other))
    }
}

/// Cells among `cells` that are far enough from each other for a flag each, and one for each
/// physical surface with directions that no flag near it shows.
fn spread(section: &Section, plane: &Plane, cells: &[usize]) -> Vec<usize> {
    let mut chosen: Vec<Flag> = Vec::new();
    // in squares as wide as the distance, with a border of empty ones
    let [columns, rows] = [0, 1].map(|axis| (plane.frame[axis] / SPACING) as usize + 3);
    let mut near: Vec<Vec<Flag>> = vec![Vec::new(); columns * rows];
    for &cell in cells {
        let flag = Flag::of(section, plane, cell);
        let square = |axis: usize| ((flag.foot[axis] - plane.corner[axis]) / SPACING) as usize + 1;
        let (column, row) = (square(0).min(columns - 2), square(1).min(rows - 2));
        let mut around = (row - 1..=row + 1)
            .flat_map(|row| &near[row * columns + column - 1..=row * columns + column + 1]);
        if around.all(|others| others.iter().all(|other| flag.leaves_space(other))) {
            chosen.push(flag);
            near[row * columns + column].push(flag);
        }
    }
    let group = |cell: usize| section.mesh.cells[cell].group;
    for number in 0..section.mesh.groups.len() {
        if chosen.iter().any(|flag| group(flag.cell) == number) {
            continue;
        }
        let of_group = cells.iter().filter(|&&cell| group(cell) == number);
        let flags = of_group.map(|&cell| Flag::of(section, plane, cell));
        let is_new = |flag: &Flag| {
            let mut near = chosen.iter().filter(|other| flag.distance(other) < SPACING);
            near.all(|other| flag.has_other_direction(other))
        };
        let space = |flag: &Flag| {
            let distances = chosen.iter().map(|other| flag.distance(other));
            distances.fold(f64::INFINITY, f64::min)
        };
        let best = flags
            .filter(is_new)
            .max_by(|a, b| space(a).total_cmp(&space(b)));
        chosen.extend(best);
    }
    chosen.into_iter().map(|flag| flag.cell).collect()
}

/// Mean of the corners of a cell, or the node in its middle.
fn center(section: &Section, cell: usize) -> [f64; 2] {
    let cell = &section.mesh.cells[cell];
    match cell.nodes().get(8) {
        Some(&node) => section.mesh.nodes[node as usize],
        None => section.mesh.middle(cell),
    }
}

/// A flag with its foot at a position of the figure and its arrow at `angle` from +y; its foot
/// has a color, and the whole flag a white rim \[figure pixels\].
fn draw_flag(drawing: &mut Drawing, foot: [f64; 2], angle: f64, (color, rim): (Color, f64)) {
    let (sine, cosine) = angle.sin_cos();
    // z runs up, the figure's second coordinate down
    let at = |along: f64, out: f64| {
        let (y, z) = (along * cosine - out * sine, along * sine + out * cosine);
        [foot[0] + y, foot[1] - z]
    };
    let line = [foot, at(0.0, POLE), at(ARROW - 14.0, POLE)];
    let head = |rim: f64| {
        [
            at(ARROW + 1.8 * rim, POLE),
            at(ARROW - 22.0 - rim, POLE + 10.0 + 1.4 * rim),
            at(ARROW - 22.0 - rim, POLE - 10.0 - 1.4 * rim),
        ]
    };
    // a white rim separates it from dark colors
    if rim > 0.0 {
        drawing.line(&line, 3.5 + 2.0 * rim, WHITE);
        drawing.polygon(&head(rim), WHITE);
        drawing.disc(foot, 9.5 + rim, WHITE);
    }
    drawing.line(&line, 3.5, INK);
    drawing.polygon(&head(0.0), INK);
    drawing.disc(foot, 9.5, INK);
    drawing.disc(foot, 6.5, color);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::section::samples::of_quadrilaterals;

    /// A row of 40 squares with the arrow along it, and a square next to its middle in its own
    /// surface: on the figure, 1560 pixels wide, the squares are 36 pixels wide, so that every
    /// third of the row has a flag, and the one next to it only if its arrow points in another
    /// direction.
    #[test]
    fn flags_leave_space_and_show_every_direction() {
        let flags = |angle: f64| {
            let corner = |i: u32, j: u32| [f64::from(i), f64::from(j)];
            let nodes: Vec<[f64; 2]> = (0..=2)
                .flat_map(|j| (0..=40).map(move |i| corner(i, j)))
                .collect();
            let square = |i: u32, j: u32| {
                let low = 41 * j + i;
                [low, low + 1, low + 42, low + 41]
            };
            let mut cells: Vec<[u32; 4]> = (0..40).map(|i| square(i, 0)).collect();
            cells.push(square(21, 1));
            let mut section = of_quadrilaterals(&nodes, &cells);
            for made_of in &mut section.cells {
                made_of.plane_angle = 0.0;
            }
            section.cells[40].plane_angle = angle;
            section.mesh.groups.push("beside".into());
            section.mesh.cells[40].group = 1;
            let extent = Extent::of(nodes.iter().copied()).grown(1.5);
            let plane = Plane::fitted(extent, [0.0, 0.0], [1560.0, HIGHEST]);
            let all: Vec<usize> = (0..41).collect();
            spread(&section, &plane, &all)
        };
        let row: Vec<usize> = (0..40).step_by(3).collect();
        assert_eq!(flags(0.3), row);
        assert_eq!(flags(1.5), [row.as_slice(), &[40]].concat());
    }

    #[test]
    fn angles_of_fibers_are_those_of_lines() {
        let folded = |degrees: f64| (line_angle(degrees.to_radians()) * 1e6).round() / 1e6;
        for (angle, expected) in [
            (0.0, 0.0),
            (45.0, 45.0),
            (-45.0, -45.0),
            (135.0, -45.0),
            (90.0, 90.0),
            (-90.0, 90.0),
            (270.0, 90.0),
            (359.0, -1.0),
        ] {
            assert_eq!(folded(angle), expected, "{angle}");
        }
    }
}
