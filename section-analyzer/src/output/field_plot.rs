//! Values over a section in colors: stresses and failure indices of a load case.

use shared_geom::figure::{BLACK, Drawing, Figure, INK, Label, SMALL, WHITE, WIDTH, tick_label};

use super::figure_parts::{LEFT, draw_title};
use super::outline::{Side, SideRole, side_points, sides_by, widths};
use super::plane::{Extent, Plane, PlotUnit};
use super::text::rounded;
use crate::input::InputSummary;
use crate::section::Section;

mod arrows;
mod field;
mod rim;
mod sample;
mod scale;
mod surface;

#[cfg(test)]
mod tests;

pub(super) use field::{Field, Quantity};

use field::Extreme;
use rim::Rim;
use scale::Scale;
use surface::Surface;

/// Maximum height of the frame [figure pixels].
const HIGHEST: f64 = 1150.0;
/// Margin right of the frame [figure pixels].
const RIGHT: f64 = 70.0;
/// Margin above the frame, for the title and a line below it; height of a further line.
const TOP: f64 = 155.0;
const NOTE: f64 = 50.0;
/// Space between frame and color bar, for ticks and the name of the axis.
const BELOW: f64 = 165.0;
/// Space for the color bar with its ticks and its name.
const BAR: f64 = 185.0;
/// Height of a line of the legend [figure pixels].
const LINE: f64 = 58.0;
/// Width to which thinner walls are widened, so that their colors can be seen; a wall that is
/// thinner by less than a quarter is not changed.
const THINNEST: f64 = 14.0;
const QUARTER: f64 = 0.8;
/// Width below which regions are drawn without their borders.
const NARROWEST: f64 = 6.0;
/// Margin around the section, relative to its size.
const MARGIN: f64 = 0.05;

/// The figure of a field over a section.
#[derive(Debug)]
pub struct FieldPlot<'a> {
    section: &'a Section,
    unit: PlotUnit,
    /// Larger side of the section's box [m].
    size: f64,
    plane: Plane,
    field: Field,
    scale: Scale,
    /// Lowest and highest value; empty if all are the same.
    extremes: Option<[Extreme; 2]>,
    sides: Vec<Side>,
    /// Width of the walls on the figure [figure pixels].
    wall: f64,
    /// Width of each region on the figure [figure pixels].
    regions: Vec<f64>,
    /// Lines of text below the title: the load case, then further lines, if any.
    words: Vec<String>,
}

impl<'a> FieldPlot<'a> {
    /// The figure of `field` on `section`, with the lines `load` below the title.
    pub(super) fn new(
        section: &'a Section,
        summary: &InputSummary,
        field: Field,
        load: Vec<String>,
    ) -> Self {
        let bare = Extent::of(section.mesh.nodes.iter().copied());
        let size = bare.largest();
        let unit = PlotUnit::of(summary, size);
        let sides = sides_by(&section.mesh.cells, |cell| section.mesh.cells[cell].group);
        let (wall, _) = widths(section, &sides);
        let space = [f64::from(WIDTH) - LEFT - RIGHT, HIGHEST];
        let mut plane = Plane::fitted(bare.grown(MARGIN * size), [LEFT, TOP], space);
        let walls = wall_words(wall / unit.meters, wall * plane.scale, &unit);
        let notes = [field.note.clone(), walls.unwrap_or_default()];
        let notes = notes.into_iter().filter(|note| !note.is_empty());
        let notes = notes.collect::<Vec<_>>().join("; ");
        let mut words = load;
        words.extend((!notes.is_empty()).then_some(notes));
        plane.corner[1] += NOTE * words.len().saturating_sub(1) as f64;
        let regions = surface::region_widths(section, &sides);
        let [lowest, highest] = field.extremes(section);
        let ends = [lowest.value, highest.value];
        let scale = Scale::new(field.quantity, ends, field.negligible);
        Self {
            section,
            unit,
            size,
            wall: wall * plane.scale,
            regions: regions.iter().map(|width| width * plane.scale).collect(),
            plane,
            extremes: scale.distinguishes(ends).then_some([lowest, highest]),
            field,
            scale,
            sides,
            words,
        }
    }

    /// Lower edge of the frame \[figure pixels\].
    fn bottom(&self) -> f64 {
        self.plane.corner[1] + self.plane.frame[1]
    }

    /// Height of the first line of the legend \[figure pixels\].
    fn legend(&self) -> f64 {
        if self.scale.is_zero() {
            self.bottom() + BELOW
        } else {
            self.bottom() + BELOW + BAR + 0.5 * LINE
        }
    }

    /// Lines of the legend.
    fn rows(&self) -> f64 {
        if self.extremes.is_some() { 2.0 } else { 1.0 }
    }

    /// Distance by which the boundary of the section is drawn outside of its position.
    fn swelling(&self) -> f64 {
        if self.wall < QUARTER * THINNEST {
            0.5 * (THINNEST - self.wall)
        } else {
            0.0
        }
    }

    fn draw_title(&self, drawing: &mut Drawing) {
        let space = f64::from(WIDTH) - LEFT - RIGHT;
        let label = Label::new(SMALL).colored(INK);
        let what = format!(": {}", self.field.title);
        let title = [self.section.name.as_str(), &what];
        draw_title(drawing, title, [LEFT, 50.0], space);
        for (row, words) in self.words.iter().enumerate() {
            let y = 105.0 + NOTE * row as f64;
            drawing.text(&drawing.shortened(words, label, space), [LEFT, y], label);
        }
    }

    fn draw_field(&self, drawing: &mut Drawing) {
        let surface = Surface::new(self.section, &self.plane, &self.field);
        let rim = Rim::new(
            self.section,
            &self.plane,
            &self.field,
            &self.sides,
            self.swelling(),
        );
        let color = |value| self.scale.color(value);
        let mut triangles = [rim.triangles(), surface.triangles].concat();
        for triangle in &mut triangles {
            triangle.values = triangle.values.map(|value| self.scale.drawn(value));
        }
        drawing.shade(triangles, color);
        self.draw_borders(drawing);
        for line in &rim.outlines {
            drawing.line(line, if self.wall > 40.0 { 3.0 } else { 2.0 }, INK);
        }
        if !self.scale.is_zero() {
            let rim = [rim.outlines, self.material_borders()].concat();
            arrows::draw(drawing, &surface.samples, &rim, self.scale.highest());
        }
    }

    /// Lines between materials: the walls around a core are separate walls.
    fn material_borders(&self) -> Vec<Vec<[f64; 2]>> {
        let position = |node: u32| self.plane.position(self.section.mesh.nodes[node as usize]);
        let material = |cell: usize| self.section.cells[cell].material;
        sides_by(&self.section.mesh.cells, material)
            .iter()
            .filter(|side| matches!(side.role, SideRole::Interface))
            .map(|side| side_points(side.ends, side.middle, &position))
            .collect()
    }

    /// Lines between regions, if these are wide enough compared with the lines.
    fn draw_borders(&self, drawing: &mut Drawing) {
        let position = |node: u32| self.plane.position(self.section.mesh.nodes[node as usize]);
        let borders = self
            .sides
            .iter()
            .filter(|side| side.role == SideRole::Interface);
        for side in borders {
            let cells = [Some(side.cell), side.other].into_iter().flatten();
            let is_wide = |cell: usize| {
                let region = self.section.mesh.cells[cell].group;
                self.regions[region] >= NARROWEST
            };
            if cells.into_iter().all(is_wide) {
                drawing.line(&side_points(side.ends, side.middle, &position), 1.6, INK);
            }
        }
    }

    fn draw_marks(&self, drawing: &mut Drawing) {
        for (extreme, mark) in self.extremes.iter().flatten().zip(Mark::BOTH) {
            mark.draw(drawing, self.plane.position(extreme.position));
        }
    }

    /// Lowest and highest value with their positions, below the color bar.
    fn draw_legend(&self, drawing: &mut Drawing) {
        let top = self.legend();
        let label = Label::new(SMALL).colored(INK);
        let space = f64::from(WIDTH) - LEFT - RIGHT - 50.0;
        // the highest first
        let both = self.extremes.iter().flatten().zip(Mark::BOTH);
        for ((extreme, mark), row) in both.zip([1.0, 0.0]) {
            let y = top + LINE * row;
            mark.draw(drawing, [LEFT + 16.0, y]);
            let text = format!("{} {}", mark.word(), self.words(extreme));
            let text = drawing.shortened(&text, label, space);
            drawing.text(&text, [LEFT + 50.0, y], label);
        }
        if self.extremes.is_none() {
            let is_whole = !self.field.values.iter().any(|values| values[0].is_nan());
            drawing.text(&self.scale.uniform_words(is_whole), [LEFT, top], label);
        }
    }

    /// `12.3 MPa at (10, -5) mm, region skin`.
    fn words(&self, extreme: &Extreme) -> String {
        let [y, z] = extreme.position.map(|value| self.coordinate(value));
        let region = match &self.section.mesh.groups[..] {
            [_] => String::new(),
            groups => format!(", region {}", groups[extreme.region]),
        };
        let value = self.scale.shown(extreme.value);
        format!("{value} at (y, z) = ({y}, {z}) {}{region}", self.unit.name)
    }

    /// A coordinate in the unit of the figure, to a ten-thousandth of the section.
    fn coordinate(&self, value: f64) -> String {
        self.unit.shown(value, self.size)
    }
}

impl Figure for FieldPlot<'_> {
    fn size(&self) -> (u32, u32) {
        let height = self.legend() + self.rows() * LINE;
        (WIDTH, height.ceil() as u32)
    }

    fn draw(&self, drawing: &mut Drawing) {
        self.draw_title(drawing);
        self.plane.draw_axes(drawing, &self.unit);
        self.draw_field(drawing);
        self.draw_marks(drawing);
        let top = self.bottom() + BELOW;
        let ends = [LEFT, f64::from(WIDTH) - RIGHT];
        self.scale.draw_bar(drawing, ends, top, &self.field.title);
        self.draw_legend(drawing);
    }
}

/// Note on walls that are drawn thicker than in reality: `wall` in the unit of the figure and
/// in figure pixels.
fn wall_words(wall: f64, pixels: f64, unit: &PlotUnit) -> Option<String> {
    let ratio = tick_label(rounded(THINNEST / pixels), 0.0);
    let wall = tick_label(rounded(wall), 0.0);
    let words = format!(
        "walls (about {wall} {}) drawn {ratio} times thicker",
        unit.name
    );
    (pixels < QUARTER * THINNEST).then_some(words)
}

/// The marks of the lowest and the highest value.
#[derive(Debug, Clone, Copy)]
enum Mark {
    Lowest,
    Highest,
}

impl Mark {
    const BOTH: [Self; 2] = [Self::Lowest, Self::Highest];

    fn word(self) -> &'static str {
        match self {
            Self::Lowest => "min",
            Self::Highest => "max",
        }
    }

    /// A triangle that points up at the highest and down at the lowest value.
    fn draw(self, drawing: &mut Drawing, [x, y]: [f64; 2]) {
        let up = match self {
            Self::Lowest => 1.0,
            Self::Highest => -1.0,
        };
        let triangle = |size: f64| {
            [[0.0, 1.0], [0.87, -0.5], [-0.87, -0.5]]
                .map(|[dx, dy]| [x + size * dx, y + up * size * dy])
        };
        drawing.polygon(&triangle(21.0), BLACK);
        drawing.polygon(&triangle(14.0), WHITE);
    }
}
