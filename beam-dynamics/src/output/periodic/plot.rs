//! Multipliers in the plane of complex numbers, with the unit circle.

use std::f64::consts::TAU;

use shared_geom::figure::{Axes, CATEGORIES, Drawing, Figure, GRAY, Label, SMALL, WIDTH};

use crate::result::{FloquetMode, PeriodicResult, Stability};

/// Height of the figure \[figure pixels\].
const HEIGHT: u32 = 1700;
/// Radius of a mark \[figure pixels\].
const MARK: f64 = 11.0;
/// Corners of the circle.
const CORNERS: usize = 180;
/// Multipliers with a number at their mark.
const NUMBERED: usize = 12;

/// A figure of multipliers, ready to be saved.
#[derive(Debug, Clone, PartialEq)]
pub struct MultiplierPlot {
    title: String,
    modes: Vec<FloquetMode>,
}

impl MultiplierPlot {
    /// The multipliers of `result`; `None` without any.
    pub fn new(result: &PeriodicResult) -> Option<Self> {
        let modes = result.floquet.as_ref()?.modes.clone();
        (!modes.is_empty()).then(|| Self {
            title: format!("{}: multipliers of a period", result.name),
            modes,
        })
    }

    fn axes(&self) -> Axes {
        let sizes = self.modes.iter().map(|mode| mode.multiplier.norm());
        let most = 1.15 * sizes.fold(1.0, f64::max);
        let side = f64::from(HEIGHT) - 320.0;
        let left = 0.5 * (f64::from(WIDTH) - side) + 40.0;
        Axes {
            left,
            right: left + side,
            top: 120.0,
            bottom: 120.0 + side,
            x: [-most, most],
            y: [-most, most],
        }
    }
}

impl Figure for MultiplierPlot {
    fn size(&self) -> (u32, u32) {
        (WIDTH, HEIGHT)
    }

    fn draw(&self, drawing: &mut Drawing) {
        drawing.title(&self.title, [40.0, 44.0]);
        let axes = self.axes();
        axes.draw_grid(drawing);
        let corner = |k: usize| {
            let (y, x) = (TAU * k as f64 / CORNERS as f64).sin_cos();
            axes.position([x, y])
        };
        let circle: Vec<_> = (0..=CORNERS).map(corner).collect();
        drawing.line(&circle, 4.0, GRAY);
        axes.draw(drawing, Some("real part [-]"), "imaginary part [-]");
        for (index, mode) in self.modes.iter().enumerate() {
            let color = match mode.stability() {
                Stability::Unstable => CATEGORIES[1],
                Stability::Stable => CATEGORIES[0],
                Stability::Neutral | Stability::Unknown => GRAY,
            };
            let value = mode.multiplier;
            for imaginary in [value.im, -value.im] {
                drawing.disc(axes.position([value.re, imaginary]), MARK, color);
            }
            if index < NUMBERED {
                let [x, y] = axes.position([value.re, value.im]);
                let at = [x + 1.6 * MARK, y - 1.6 * MARK];
                drawing.text(&(index + 1).to_string(), at, Label::new(SMALL));
            }
        }
    }
}
