//! Curves in panels below each other, over one axis.

use super::axes::{Axes, TITLE, range};
use super::color::{Color, category};
use super::drawing::Drawing;
use super::legend::Legend;
use super::stroke::Stroke;
use super::{Figure, WIDTH};

/// Height of a panel and the gap below it \[figure pixels\].
const PANEL: f64 = 420.0;
const GAP: f64 = 50.0;
/// Upper and left edge of the first panel, and the margins to the right and below it.
const TOP: f64 = 100.0;
const LEFT: f64 = 230.0;
const RIGHT: f64 = 50.0;
const BOTTOM: f64 = TITLE + 50.0;
const LINE: f64 = 4.0;
const POINT: f64 = 6.0;
/// Number of points of a curve above which it has no marks.
const MOST_MARKS: usize = 40;
/// Number of curves above which a legend does not help.
const MOST_NAMES: usize = 21;

/// A quantity over the axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// Name and unit.
    pub title: String,
    /// Points of each curve: position on the axis and value [unit of the axis, unit of the title].
    pub curves: Vec<Vec<[f64; 2]>>,
}

impl Panel {
    /// Curves of a quantity, in a multiple of its unit in which the largest value has few digits.
    pub fn scaled((name, unit): (&str, &str), mut curves: Vec<Vec<[f64; 2]>>) -> Self {
        let values = curves.iter().flatten().map(|point| point[1]);
        let (prefix, factor) = scale(unit, values);
        for point in curves.iter_mut().flatten() {
            point[1] *= factor;
        }
        Self {
            title: format!("{name} [{prefix}{unit}]"),
            curves,
        }
    }
}

/// Panels with a common axis.
#[derive(Debug, Clone, PartialEq)]
pub struct PanelPlot {
    /// The title of the figure.
    pub title: String,
    /// Name and unit of the axis.
    pub across: String,
    /// Names of the curves of each panel.
    pub names: Vec<String>,
    /// The panels, from the top.
    pub panels: Vec<Panel>,
}

impl PanelPlot {
    fn legend(&self) -> Legend {
        let is_named = self.names.len() <= MOST_NAMES && self.names.iter().any(|it| !it.is_empty());
        let names = self.names.iter().enumerate().filter(|_| is_named);
        Legend::of_lines(names.map(|(index, name)| (name.clone(), LINE, category(index))))
    }

    fn space() -> f64 {
        f64::from(WIDTH) - LEFT - RIGHT
    }

    /// Upper edge of the first panel.
    fn top(&self) -> f64 {
        TOP + self.legend().height(Self::space())
    }

    /// Values at the ends of the axis.
    fn across_range(&self) -> [f64; 2] {
        let points = self
            .panels
            .iter()
            .flat_map(|panel| panel.curves.iter().flatten());
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for [x, _] in points.filter(|point| point[0].is_finite()) {
            low = low.min(*x);
            high = high.max(*x);
        }
        if low < high {
            [low, high]
        } else {
            range([low], 0.0)
        }
    }
}

/// The parts of a curve between points without a value.
fn pieces(points: &[[f64; 2]]) -> impl Iterator<Item = &[[f64; 2]]> {
    let is_gap = |point: &[f64; 2]| !(point[0].is_finite() && point[1].is_finite());
    points.split(is_gap).filter(|piece| !piece.is_empty())
}

impl Figure for PanelPlot {
    fn size(&self) -> (u32, u32) {
        let panels = self.panels.len() as f64;
        let height = self.top() + panels * (PANEL + GAP) - GAP + BOTTOM;
        (WIDTH, height.ceil() as u32)
    }

    fn draw(&self, drawing: &mut Drawing) {
        drawing.title(&self.title, [40.0, 44.0]);
        self.legend().draw(drawing, [LEFT, 78.0], Self::space());
        let x = self.across_range();
        let last = self.panels.len().saturating_sub(1);
        for (index, panel) in self.panels.iter().enumerate() {
            let top = self.top() + index as f64 * (PANEL + GAP);
            let values = panel.curves.iter().flatten().map(|point| point[1]);
            let axes = Axes {
                left: LEFT,
                right: f64::from(WIDTH) - RIGHT,
                top,
                bottom: top + PANEL,
                x,
                y: range(values, 0.0),
            };
            axes.draw_grid(drawing);
            for (index, curve) in panel.curves.iter().enumerate() {
                draw_curve(drawing, &axes, curve, category(index));
            }
            let across = (index == last).then_some(self.across.as_str());
            axes.draw(drawing, across, &panel.title);
        }
    }
}

/// A prefix of a unit and its factor, by which the largest of some values has few digits; none for
/// units in which values are small.
pub fn scale(unit: &str, values: impl Iterator<Item = f64>) -> (&'static str, f64) {
    if !matches!(unit, "W" | "N" | "N m" | "N/m" | "N m^2") {
        return ("", 1.0);
    }
    let largest = values
        .filter(|it| it.is_finite())
        .fold(0.0, |a: f64, b| a.max(b.abs()));
    match largest {
        large if large >= 1e9 => ("G", 1e-9),
        large if large >= 1e6 => ("M", 1e-6),
        large if large >= 1e3 => ("k", 1e-3),
        _ => ("", 1.0),
    }
}

fn draw_curve(drawing: &mut Drawing, axes: &Axes, curve: &[[f64; 2]], color: Color) {
    for piece in pieces(curve) {
        axes.curve(drawing, piece, Stroke::new(LINE, color));
        if curve.len() <= MOST_MARKS {
            for point in piece {
                drawing.disc(axes.position(*point), POINT, color);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prefixes_follow_the_largest_value() {
        assert_eq!(scale("W", [5e6, 1.0].into_iter()), ("M", 1e-6));
        assert_eq!(scale("N m^2", [2e10].into_iter()), ("G", 1e-9));
        assert_eq!(scale("N", [-2e3, f64::NAN].into_iter()), ("k", 1e-3));
        assert_eq!(scale("deg", [2e3].into_iter()), ("", 1.0));
    }
}
