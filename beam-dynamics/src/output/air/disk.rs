//! Maps of the disk of a rotor: quantities of its strips over azimuth and radius.
//!
//! The azimuth is zero at the lower end and increases counterclockwise: the disk is seen from the
//! side to which the axis points, with the reference direction downward.

use shared_geom::figure::{
    Anchor, Drawing, Figure, INK, LIGHT, Label, SMALL, TEXT, ValueTriangle, WIDTH, fitting,
};

use crate::elements::{AirState, StripQuantity};
use crate::output::color_bar::{CONTOUR, ColorBar};

/// Height of the sheet with one row, and of each further row \[figure pixels\].
const HEIGHT: f64 = 800.0;
const ROW: f64 = 660.0;
/// Name, unit, quantity, and its units in one SI unit.
type Drawn = (&'static str, &'static str, StripQuantity, f64);

const QUANTITIES: [Drawn; 3] = [
    (
        "angle of attack",
        "deg",
        StripQuantity::AngleOfAttack,
        180.0 / std::f64::consts::PI,
    ),
    ("normal load", "N/m", StripQuantity::NormalLoad, 1.0),
    (
        "induced velocity",
        "m/s",
        StripQuantity::InducedVelocity,
        1.0,
    ),
];
/// Largest change of the azimuth between two times that are joined \[rad\].
pub(super) const MOST_TURN: f64 = 0.5;

/// A value at an azimuth and a radius: \[rad, m, unit\].
pub(super) type Point = [f64; 3];

/// A quantity on the disk.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Map {
    /// Name and unit.
    pub title: String,
    /// Of each blade, at each time the points along it.
    pub blades: Vec<Vec<Vec<Point>>>,
    /// The least and the largest value of all maps that have the same colors.
    pub range: [f64; 2],
}

impl Map {
    fn new(title: String, blades: Vec<Vec<Vec<Point>>>) -> Self {
        let values = blades.iter().flatten().flatten().map(|point| point[2]);
        let values = values.filter(|value| value.is_finite());
        let ends = [f64::INFINITY, f64::NEG_INFINITY];
        Self {
            range: values.fold(ends, |[low, high], value| [low.min(value), high.max(value)]),
            title,
            blades,
        }
    }
}

/// The strips of a blade at each time, with its name.
pub(super) type BladeRows<'a> = (&'a str, Vec<Vec<&'a AirState>>);

/// Maps of a rotor, a row for each blade, or one row of equal blades, with the same colors.
#[derive(Debug, Clone, PartialEq)]
pub struct DiskPlot {
    pub(super) title: String,
    /// Radius of the tip \[m\].
    pub(super) radius: f64,
    /// Names of the blades.
    pub(super) names: Vec<String>,
    pub(super) maps: Vec<Map>,
}

impl DiskPlot {
    /// The maps of the blades of a rotor; `None` for less than two times or strips.
    pub(super) fn new(title: String, blades: &[BladeRows<'_>]) -> Option<Self> {
        let is_short =
            |rows: &[Vec<&AirState>]| rows.len() < 2 || rows.iter().any(|row| row.len() < 2);
        if blades.is_empty() || blades.iter().any(|blade| is_short(&blade.1)) {
            return None;
        }
        let map = |(name, unit, quantity, factor): &Drawn| {
            let point =
                |state: &&AirState| [state.azimuth, state.radius, factor * quantity.of(state)];
            let points = |row: &Vec<&AirState>| row.iter().map(point).collect();
            let blades = blades.iter();
            let blades = blades.map(|(_, rows)| rows.iter().map(points).collect());
            Map::new(format!("{name} [{unit}]"), blades.collect())
        };
        let tips = blades
            .iter()
            .filter_map(|(_, rows)| rows.last()?.last()?.rotor);
        Some(Self {
            title,
            radius: tips.map(|rotor| rotor.tip_radius).fold(0.0, f64::max),
            names: blades.iter().map(|(name, _)| (*name).to_owned()).collect(),
            maps: QUANTITIES.iter().map(map).collect(),
        })
    }

    /// The maps with one row in place of the ones of all blades, which are equal.
    #[must_use]
    pub(super) fn of_equal_blades(mut self) -> Self {
        if let [first, others @ ..] = &self.names[..]
            && !others.is_empty()
        {
            self.names = vec![match others.len() {
                1 => format!("{first} and an equal blade"),
                count => format!("{first} and {count} equal blades"),
            }];
            for map in &mut self.maps {
                map.blades.truncate(1);
            }
        }
        self
    }

    /// Gives the maps of several rotors the same colors.
    pub(super) fn share_colors(plots: &mut [Self]) {
        for index in 0..QUANTITIES.len() {
            let ranges = plots.iter().filter_map(|plot| plot.maps.get(index));
            let ranges = ranges.map(|map| map.range);
            let Some(shared) = ranges.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]) else {
                continue;
            };
            for map in plots.iter_mut().filter_map(|plot| plot.maps.get_mut(index)) {
                map.range = shared;
            }
        }
    }
}

/// The disk of a map on the sheet.
struct Disk {
    center: [f64; 2],
    /// Figure pixels per meter.
    scale: f64,
    /// Radius of the tip \[m\].
    radius: f64,
}

impl Disk {
    fn position(&self, azimuth: f64, radius: f64) -> [f64; 2] {
        let (sin, cos) = azimuth.sin_cos();
        let [x, y] = self.center;
        [x + self.scale * radius * sin, y + self.scale * radius * cos]
    }

    /// The cells between two times, two triangles each.
    fn cells(&self, before: &[Point], after: &[Point], triangles: &mut Vec<ValueTriangle>) {
        for (a, b) in before.windows(2).zip(after.windows(2)) {
            let corners = [a[0], a[1], b[1], b[0]];
            // The remainder by a full turn, from minus to plus half of it.
            let turn = (b[0][0] - a[0][0] + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU);
            let turn = (turn - std::f64::consts::PI).abs();
            let is_known = corners.iter().flatten().all(|value| value.is_finite());
            if !is_known || turn > MOST_TURN {
                continue;
            }
            for three in [[0, 1, 2], [0, 2, 3]] {
                triangles.push(ValueTriangle {
                    corners: three.map(|k| self.position(corners[k][0], corners[k][1])),
                    values: three.map(|k| corners[k][2]),
                });
            }
        }
    }

    /// Circles at parts of the radius, and the azimuths of the quarters.
    fn draw_frame(&self, drawing: &mut Drawing) {
        for (part, color) in [(0.25, LIGHT), (0.5, LIGHT), (0.75, LIGHT), (1.0, INK)] {
            let points: Vec<_> = (0..=180)
                .map(|k| self.position(f64::from(2 * k).to_radians(), part * self.radius))
                .collect();
            drawing.line(&points, CONTOUR, color);
        }
        let label = Label::new(SMALL).colored(INK).anchored(Anchor::Middle);
        for quarter in 0..4 {
            let azimuth = f64::from(90 * quarter).to_radians();
            let [inner, outer] = [0.0, self.radius].map(|radius| self.position(azimuth, radius));
            drawing.line(&[inner, outer], 1.0, LIGHT);
            let beside = self.position(azimuth, self.radius + 0.85 * TEXT / self.scale);
            drawing.text(&format!("{}", 90 * quarter), beside, label);
        }
    }
}

impl Figure for DiskPlot {
    fn size(&self) -> (u32, u32) {
        let further = self.names.len().saturating_sub(1);
        (WIDTH, (HEIGHT + ROW * further as f64) as u32)
    }

    fn draw(&self, drawing: &mut Drawing) {
        drawing.title(&self.title, [40.0, 44.0]);
        let label = Label::new(SMALL).colored(INK);
        for (blade, name) in self.names.iter().enumerate() {
            let top = ROW * blade as f64;
            drawing.text(name, [40.0, top + 100.0], label);
            for (index, map) in self.maps.iter().enumerate() {
                self.draw_map(drawing, map, (blade, index));
            }
        }
        let note = "azimuth [deg], counterclockwise as seen from the side of the axis";
        let (_, height) = self.size();
        drawing.text(note, [40.0, f64::from(height) - 36.0], label);
    }
}

impl DiskPlot {
    /// Draws a map of a blade: its row and column.
    fn draw_map(&self, drawing: &mut Drawing, map: &Map, (blade, column): (usize, usize)) {
        let width = f64::from(WIDTH) / self.maps.len().max(1) as f64;
        let (left, top) = (width * column as f64, 40.0 + ROW * blade as f64);
        let pixels = 0.5 * (width - 230.0);
        let disk = Disk {
            center: [left + 70.0 + pixels, top + 190.0 + TEXT + pixels],
            scale: pixels / self.radius,
            radius: self.radius,
        };
        let title = Label::new(TEXT).colored(INK).anchored(Anchor::Middle);
        let title = fitting(title, &map.title, 2.0 * pixels);
        drawing.text(&map.title, [disk.center[0], top + 140.0], title);
        if let Some(bar) = ColorBar::of(map.range) {
            let mut triangles = Vec::new();
            for pair in map.blades[blade].windows(2) {
                disk.cells(&pair[0], &pair[1], &mut triangles);
            }
            drawing.shade(triangles, |value| bar.color(value));
            let [x, y] = disk.center;
            bar.draw(drawing, x + pixels + 30.0, [y - pixels, y + pixels]);
        }
        disk.draw_frame(drawing);
    }
}
