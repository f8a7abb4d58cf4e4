//! The figure of stability: growth and frequency over the parameter, and the root locus.

use std::f64::consts::TAU;

use shared_geom::figure::{
    Axes, BLACK, Color, Drawing, Figure, Legend, Mark, Stroke, WIDTH, category, range,
};

use crate::result::StabilityResult;

/// Heights of the panels, the gap below the first one and the second one, and the upper and lower
/// margins \[figure pixels\].
const PANELS: [f64; 3] = [520.0, 440.0, 640.0];
const GAPS: [f64; 2] = [50.0, 150.0];
const TOP: f64 = 100.0;
const BOTTOM: f64 = 130.0;
/// Left and right edges \[figure pixels\].
const LEFT: f64 = 230.0;
const RIGHT: f64 = 50.0;
const LINE: f64 = 4.0;
const POINT: f64 = 6.0;
const RING: f64 = 12.0;
/// Lines of boundaries.
const MARKED: Color = Color(120, 120, 120);
/// Number of modes above which a legend does not help.
const MOST_NAMES: usize = 14;

/// A mode over the parameter: value, growth \[1/s\] and frequency \[Hz\].
type Curve = Vec<[f64; 3]>;

/// A figure of roots, ready to be saved.
#[derive(Debug, Clone, PartialEq)]
pub struct StabilityPlot {
    title: String,
    across: String,
    names: Vec<String>,
    curves: Vec<Curve>,
    /// Value, growth and frequency of each boundary.
    boundaries: Vec<[f64; 3]>,
}

impl StabilityPlot {
    /// The roots of `result`; `None` for less than two values.
    pub fn new(result: &StabilityResult) -> Option<Self> {
        let curve = |mode: usize| -> Curve {
            let points = result.points.iter();
            let roots = points.map(|point| match point.root_of(mode) {
                Some(root) => [point.at, root.growth(), root.frequency() / TAU],
                None => [point.at, f64::NAN, f64::NAN],
            });
            roots.collect()
        };
        let boundaries = result.boundaries.iter();
        (result.points.len() > 1).then(|| Self {
            title: format!("{}: stability over {}", result.name, result.parameter),
            across: result.parameter.clone(),
            names: result.modes.clone(),
            curves: (0..result.modes.len()).map(curve).collect(),
            boundaries: boundaries
                .map(|own| [own.at, own.growth, own.frequency / TAU])
                .collect(),
        })
    }

    fn legend(&self) -> Legend {
        let shown = self.names.len() <= MOST_NAMES;
        let names = self.names.iter().enumerate().filter(|_| shown);
        Legend::of_lines(names.map(|(index, name)| (name.clone(), LINE, category(index))))
    }

    fn space() -> f64 {
        f64::from(WIDTH) - LEFT - RIGHT
    }

    /// The axes of a panel below the legend, of the values k = 0, 1, 2 of the curves.
    fn axes(&self, panel: usize, across: usize, up: usize) -> Axes {
        let before = PANELS.iter().zip(GAPS).take(panel);
        let above: f64 = before.map(|(height, gap)| height + gap).sum();
        let top = TOP + self.legend().height(Self::space()) + above;
        let values = |k: usize| self.curves.iter().flatten().map(move |point| point[k]);
        let x = match across {
            0 => {
                let finite = values(0);
                let ends = finite.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], at| {
                    [low.min(at), high.max(at)]
                });
                if ends[0] < ends[1] { ends } else { [0.0, 1.0] }
            }
            _ => range(values(across).chain([0.0]), 0.0),
        };
        Axes {
            left: LEFT,
            right: f64::from(WIDTH) - RIGHT,
            top,
            bottom: top + PANELS[panel],
            x,
            y: range(values(up).chain([0.0]), 0.0),
        }
    }

    fn draw_panel(&self, drawing: &mut Drawing, panel: usize, [across, up]: [usize; 2]) {
        let axes = self.axes(panel, across, up);
        axes.draw_grid(drawing);
        axes.draw_zero(drawing);
        if across != 0 {
            let zero = [[0.0, axes.y[0]], [0.0, axes.y[1]]];
            axes.curve(drawing, &zero, Stroke::new(2.0, MARKED));
        }
        for [at, ..] in self.boundaries.iter().filter(|_| across == 0) {
            let ends = [[*at, axes.y[0]], [*at, axes.y[1]]];
            axes.curve(drawing, &ends, Stroke::new(2.0, MARKED).dashed(1));
        }
        for (index, curve) in self.curves.iter().enumerate() {
            let color = category(index);
            for run in curve.split(|point| !point[1].is_finite()) {
                let points: Vec<_> = run.iter().map(|point| [point[across], point[up]]).collect();
                if points.is_empty() {
                    continue;
                }
                axes.curve(drawing, &points, Stroke::new(LINE, color));
                for point in points {
                    drawing.disc(axes.position(point), POINT, color);
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
        let legend = self.legend().height(Self::space());
        let height = TOP + legend + PANELS.iter().sum::<f64>() + GAPS.iter().sum::<f64>() + BOTTOM;
        (WIDTH, height.ceil() as u32)
    }

    fn draw(&self, drawing: &mut Drawing) {
        drawing.title(&self.title, [40.0, 44.0]);
        self.legend().draw(drawing, [LEFT, 78.0], Self::space());
        let titles = [
            (None, "growth [1/s]"),
            (Some(self.across.as_str()), "frequency [Hz]"),
            (Some("growth [1/s]"), "frequency [Hz]"),
        ];
        let values = [[0, 1], [0, 2], [1, 2]];
        for (panel, ((across, up), values)) in titles.into_iter().zip(values).enumerate() {
            self.draw_panel(drawing, panel, values);
            let [x, y] = values;
            self.axes(panel, x, y).draw(drawing, across, up);
        }
    }
}
