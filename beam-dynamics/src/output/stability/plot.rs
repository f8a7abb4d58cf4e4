//! The figure of stability: growth, damping and frequency over the parameter, and the root locus.

use std::f64::consts::TAU;

use shared_geom::figure::{Axes, BLACK, Color, Drawing, Figure, Mark, Stroke, WIDTH, range};

use super::looks::Looks;
use crate::result::StabilityResult;

/// Heights of the panels, the gaps between them, and the upper and lower margins \[figure pixels\].
const PANELS: [f64; 4] = [520.0, 520.0, 440.0, 640.0];
const GAPS: [f64; 3] = [50.0, 50.0, 150.0];
const TOP: f64 = 100.0;
const BOTTOM: f64 = 130.0;
/// Upper edge of the legends \[figure pixels\].
const LEGEND: f64 = 78.0;
/// Left and right edges \[figure pixels\].
const LEFT: f64 = 230.0;
const RIGHT: f64 = 50.0;
const RING: f64 = 12.0;
/// Lines of boundaries.
const MARKED: Color = Color(120, 120, 120);
/// Half the width of the axis of a single value, as a part of it.
const ABOUT: f64 = 0.1;
/// Damping up to which the panel of damping reaches if some modes have more than twice as much: lightly
/// damped modes are the ones to be seen \[%\].
const MOST_DAMPING: f64 = 10.0;

/// A mode over the parameter: value, growth \[1/s\], frequency \[Hz\] and damping \[%\].
type Curve = Vec<[f64; 4]>;
/// Indices of these numbers across and up, and the title of the axis up, of each panel.
const CONTENT: [([usize; 2], &str); 4] = [
    ([0, 1], "growth [1/s]"),
    ([0, 3], "damping [%]"),
    ([0, 2], "frequency [Hz]"),
    ([1, 2], "frequency [Hz]"),
];

/// A figure of roots, ready to be saved.
#[derive(Debug, Clone, PartialEq)]
pub struct StabilityPlot {
    title: String,
    across: String,
    looks: Looks,
    curves: Vec<Curve>,
    /// Value, growth, frequency and damping of each boundary.
    boundaries: Curve,
}

impl StabilityPlot {
    /// The roots of `result`; `None` without values.
    pub fn new(result: &StabilityResult) -> Option<Self> {
        let curve = |mode: usize| -> Curve {
            let points = result.points.iter();
            let roots = points.map(|point| match point.root_of(mode) {
                Some(root) => {
                    let damping = root.damping_ratio().unwrap_or(f64::NAN);
                    [
                        point.at,
                        root.growth(),
                        root.frequency() / TAU,
                        100.0 * damping,
                    ]
                }
                None => [point.at, f64::NAN, f64::NAN, f64::NAN],
            });
            roots.collect()
        };
        let boundaries = result.boundaries.iter();
        (!result.points.is_empty()).then(|| Self {
            title: format!("{}: stability over {}", result.name, result.parameter),
            across: result.parameter.clone(),
            looks: Looks::new(&result.modes),
            curves: (0..result.modes.len()).map(curve).collect(),
            boundaries: boundaries
                .map(|own| [own.at, own.growth, own.frequency / TAU, 0.0])
                .collect(),
        })
    }

    /// Height of the legends \[figure pixels\].
    fn above(&self) -> f64 {
        let legends = self.looks.legends();
        legends
            .iter()
            .map(|legend| legend.height(Self::space()))
            .sum()
    }

    fn space() -> f64 {
        f64::from(WIDTH) - LEFT - RIGHT
    }

    /// The axes of a panel below the legend.
    fn axes(&self, panel: usize) -> Axes {
        let [across, up] = CONTENT[panel].0;
        let before = PANELS.iter().zip(GAPS).take(panel);
        let above: f64 = before.map(|(height, gap)| height + gap).sum();
        let top = TOP + self.above() + above;
        let values = |k: usize| self.curves.iter().flatten().map(move |point| point[k]);
        let x = match across {
            0 => {
                let finite = values(0);
                let ends = finite.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], at| {
                    [low.min(at), high.max(at)]
                });
                let about = match ABOUT * ends[0].abs() {
                    0.0 => 1.0,
                    about => about,
                };
                match ends[0] < ends[1] {
                    true => ends,
                    false => [ends[0] - about, ends[0] + about],
                }
            }
            _ => range(values(across).chain([0.0]), 0.0),
        };
        let most = values(up).fold(0.0, f64::max);
        let is_cut = up == 3 && most > 2.0 * MOST_DAMPING;
        let shown = |value: &f64| !is_cut || (-MOST_DAMPING..=MOST_DAMPING).contains(value);
        let y = range(values(up).chain([0.0]).filter(shown), 0.0);
        Axes {
            left: LEFT,
            right: f64::from(WIDTH) - RIGHT,
            top,
            bottom: top + PANELS[panel],
            x,
            y: [y[0], if is_cut { MOST_DAMPING } else { y[1] }],
        }
    }

    fn draw_panel(&self, drawing: &mut Drawing, panel: usize) {
        let ([across, up], axes) = (CONTENT[panel].0, self.axes(panel));
        axes.draw_grid(drawing);
        if across != 0 {
            let zero = [[0.0, axes.y[0]], [0.0, axes.y[1]]];
            axes.curve(drawing, &zero, Stroke::new(2.0, MARKED));
        }
        for [at, ..] in self.boundaries.iter().filter(|_| across == 0) {
            let ends = [[*at, axes.y[0]], [*at, axes.y[1]]];
            axes.curve(drawing, &ends, Stroke::new(2.0, MARKED).dashed(1));
        }
        for (look, index) in self.looks.in_order() {
            let curve = &self.curves[index];
            for run in curve.split(|point| !point[up].is_finite()) {
                let points: Vec<_> = run.iter().map(|point| [point[across], point[up]]).collect();
                for pair in points.windows(2) {
                    if let Some(ends) = inside([pair[0], pair[1]], axes.y) {
                        axes.curve(drawing, &ends, look.stroke());
                    }
                }
                let is_inside = |point: &[f64; 2]| (axes.y[0]..=axes.y[1]).contains(&point[1]);
                for point in points.into_iter().filter(is_inside) {
                    look.draw_mark(drawing, axes.position(point));
                }
            }
        }
        for boundary in &self.boundaries {
            let at = axes.position([boundary[across], boundary[up]]);
            Mark::Ring.draw(drawing, at, RING, BLACK);
        }
    }
}

impl Figure for StabilityPlot {
    fn size(&self) -> (u32, u32) {
        let height =
            TOP + self.above() + PANELS.iter().sum::<f64>() + GAPS.iter().sum::<f64>() + BOTTOM;
        (WIDTH, height.ceil() as u32)
    }

    fn draw(&self, drawing: &mut Drawing) {
        drawing.title(&self.title, [40.0, 44.0]);
        let mut top = LEGEND;
        for legend in self.looks.legends() {
            legend.draw(drawing, [LEFT, top], Self::space());
            top += legend.height(Self::space());
        }
        let across = [None, None, Some(self.across.as_str()), Some("growth [1/s]")];
        for (panel, across) in across.into_iter().enumerate() {
            self.draw_panel(drawing, panel);
            self.axes(panel).draw(drawing, across, CONTENT[panel].1);
        }
    }
}

/// The part of a straight piece between two heights; `None` if it is outside.
fn inside([a, b]: [[f64; 2]; 2], [low, high]: [f64; 2]) -> Option<[[f64; 2]; 2]> {
    let at = |part: f64| [a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])];
    let parts = [low, high].map(|y| (y - a[1]) / (b[1] - a[1]));
    let [first, last] = match b[1] == a[1] {
        true if (low..=high).contains(&a[1]) => [0.0, 1.0],
        true => return None,
        false => [
            parts[0].min(parts[1]).max(0.0),
            parts[0].max(parts[1]).min(1.0),
        ],
    };
    (first <= last).then(|| [at(first), at(last)])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A plot of modes with these dampings \[%\] at some values.
    fn plot(values: &[f64], dampings: &[f64]) -> StabilityPlot {
        let curve = |damping: &f64| -> Curve {
            let point = |at: &f64| [*at, -0.1, 1.0, *damping];
            values.iter().map(point).collect()
        };
        let names: Vec<_> = (1..=dampings.len()).map(|k| format!("flap {k}")).collect();
        StabilityPlot {
            title: String::new(),
            across: String::new(),
            looks: Looks::new(&names),
            curves: dampings.iter().map(curve).collect(),
            boundaries: Vec::new(),
        }
    }

    // Modes of 60 % are beyond the edge at 10 %. Below zero the panel has a margin of the shown values, 6 %
    // of them, not of the whole range.
    #[test]
    fn the_panel_of_damping_has_the_range_of_shown_values() {
        let [low, high] = plot(&[1.0, 2.0], &[-0.1, 4.0, 60.0]).axes(1).y;
        assert!(
            high == MOST_DAMPING && (-0.5..=-0.1).contains(&low),
            "{low} {high}"
        );
        let [low, high] = plot(&[1.0, 2.0], &[0.5, 12.0]).axes(1).y;
        assert!(high > 12.0 && (-1.0..=0.0).contains(&low), "{low} {high}");
    }

    // The points of one value are in the middle.
    #[test]
    fn one_value_has_points() {
        for at in [0.0, -4.0, 11.0] {
            let plot = plot(&[at], &[1.0, 2.0]);
            let axes = plot.axes(0);
            let x = axes.position([at, 0.0])[0];
            assert!((x - 0.5 * (axes.left + axes.right)).abs() < 1e-9, "{x}");
            let mut drawing = Drawing::new(plot.size());
            plot.draw(&mut drawing);
            assert!(drawing.texts().any(|text| text == "flap 2"));
        }
    }

    #[test]
    fn pieces_end_at_the_edges_of_a_panel() {
        let piece = |y: [f64; 2]| inside([[0.0, y[0]], [2.0, y[1]]], [0.0, 10.0]);
        assert_eq!(piece([2.0, 8.0]), Some([[0.0, 2.0], [2.0, 8.0]]));
        assert_eq!(piece([5.0, 15.0]), Some([[0.0, 5.0], [1.0, 10.0]]));
        assert_eq!(piece([20.0, -20.0]), Some([[0.5, 10.0], [1.0, 0.0]]));
        assert_eq!(piece([3.0, 3.0]), Some([[0.0, 3.0], [2.0, 3.0]]));
        assert_eq!([piece([11.0, 12.0]), piece([12.0, 12.0])], [None, None]);
    }
}
