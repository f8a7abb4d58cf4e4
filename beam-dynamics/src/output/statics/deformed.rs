//! The deformed shape along a load path, over the undeformed one.

use nalgebra::Vector3;
use shared_geom::figure::{CATEGORIES, Color, Drawing, Figure, GRAY, Legend, WIDTH, sequential};

use super::floors::ROUND_OFF;
use super::text::most_displaced;
use crate::input::short_number;
use crate::output::structure::Structure;
use crate::output::views::{Arrangement, Extent, Stroke};
use crate::result::StaticResult;

/// Height of title and legend \[figure pixels\].
const HEAD: f64 = 170.0;
/// Greatest height of the views \[figure pixels\].
const TALLEST: f64 = 1700.0;
/// Steps shown, including the last one.
const SHOWN: usize = 5;
/// Part of the size of the model below which displacements are shown enlarged...
const VISIBLE: f64 = 0.02;
/// ...to about this part of it.
const ENLARGED: f64 = 0.1;
const LINE: f64 = 6.0;
const THIN: f64 = 3.5;

/// Deformed shapes, ready to be saved.
#[derive(Debug, Clone, PartialEq)]
pub struct DeformedPlot {
    title: String,
    strokes: Vec<Stroke>,
    marks: Vec<(Vector3<f64>, Color)>,
    legend: Vec<(String, f64, Color)>,
    views: Arrangement,
}

impl DeformedPlot {
    /// The shapes at the end of the path and at some earlier steps, over the undeformed one in
    /// gray; `None` without beams or equilibria.
    pub fn new(result: &StaticResult) -> Option<Self> {
        let last = result.last().filter(|_| !result.beams.is_empty())?;
        let structure = Structure::new(&result.nodes, &result.beams, &result.blades);
        let times = enlargement(most_displaced(result, last).1 / structure.size());
        let mut plot = Self {
            title: match times {
                1.0 => format!("{}: deformed shape", result.name),
                _ => format!(
                    "{}: deformed shape, displacements times {times}",
                    result.name
                ),
            },
            strokes: Vec::new(),
            marks: Vec::new(),
            legend: Vec::new(),
            views: Arrangement::new(&Extent::around(&[], &[]), [1.0; 2]),
        };
        plot.add(&structure, &structure.positions, ("undeformed", LINE, GRAY));
        for index in shown(result.steps.len()) {
            let step = &result.steps[index];
            let is_last = index + 1 == result.steps.len();
            let part = index as f64 / result.steps.len() as f64;
            let (width, color) = if is_last {
                (LINE, CATEGORIES[5])
            } else {
                (THIN, sequential(0.15 + 0.75 * part))
            };
            let moved: Vec<_> = structure
                .positions
                .iter()
                .zip(&step.positions)
                .map(|(from, to)| from + times * (to - from))
                .collect();
            let name = match step.factor {
                0.0 => "constant loads".to_owned(),
                factor => format!("factor {}", short_number(factor, 4)),
            };
            plot.add(&structure, &moved, (&name, width, color));
        }
        let marks: Vec<_> = plot.marks.iter().map(|mark| mark.0).collect();
        let extent = Extent::around(&plot.strokes, &marks);
        plot.views = Arrangement::new(&extent, [f64::from(WIDTH), TALLEST]);
        Some(plot)
    }

    fn add(
        &mut self,
        structure: &Structure,
        positions: &[Vector3<f64>],
        (name, width, color): (&str, f64, Color),
    ) {
        for points in structure.curves(positions) {
            self.strokes.push(Stroke {
                points,
                width,
                color,
            });
        }
        let loose = structure.loose_nodes().into_iter();
        self.marks
            .extend(loose.map(|node| (positions[node], color)));
        self.legend.push((name.to_owned(), width, color));
    }
}

impl Figure for DeformedPlot {
    fn size(&self) -> (u32, u32) {
        let height = HEAD + self.views.size[1];
        (WIDTH, height.ceil() as u32)
    }

    fn draw(&self, drawing: &mut Drawing) {
        drawing.title(&self.title, [40.0, 44.0]);
        let legend = Legend::of_lines(self.legend.iter().cloned());
        legend.draw(drawing, [40.0, 86.0], f64::from(WIDTH) - 80.0);
        let left = 0.5 * (drawing.size().0 - self.views.size[0]).max(0.0);
        self.views
            .draw(drawing, [left, HEAD], &self.strokes, &self.marks);
    }
}

/// The number 1, 2 or 5 times a power of ten by which displacements of this part of the size are
/// enlarged; one if they are visible.
fn enlargement(part: f64) -> f64 {
    if part >= VISIBLE || part <= ROUND_OFF || !part.is_finite() {
        return 1.0;
    }
    let wanted = ENLARGED / part;
    let power = 10_f64.powi(wanted.log10().floor() as i32);
    let mantissa = [5.0, 2.0, 1.0].into_iter().find(|m| m * power <= wanted);
    mantissa.unwrap_or(1.0) * power
}

/// Steps shown: the last, and some at equal distances before; the first, with constant loads only,
/// is omitted if there are others.
fn shown(count: usize) -> Vec<usize> {
    let Some(last) = count.checked_sub(1) else {
        return Vec::new();
    };
    let parts = last.min(SHOWN);
    let mut shown: Vec<_> = (1..parts).map(|k| k * last / parts).collect();
    shown.push(last);
    shown
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples;

    #[test]
    fn small_displacements_are_enlarged_by_round_numbers() {
        for (part, times) in [
            (0.5, 1.0),
            (0.0, 1.0),
            (1e-13, 1.0),
            (0.01, 10.0),
            (1.9e-5, 5000.0),
        ] {
            assert_eq!(enlargement(part), times, "{part}");
        }
    }

    #[test]
    fn the_last_step_and_some_before_are_shown() {
        assert_eq!(shown(0), [0; 0]);
        assert_eq!(shown(1), [0]);
        assert_eq!(shown(3), [1, 2]);
        assert_eq!(shown(101), [20, 40, 60, 80, 100]);
    }

    #[test]
    fn the_plot_names_axes_and_factors() {
        let result = samples::bent(&[0.0, 0.25, 0.5, 0.75, 1.0]);
        let text = samples::texts(&DeformedPlot::new(&result).unwrap());
        for expected in [
            "bent blade: deformed shape",
            "undeformed",
            "factor 0.25",
            "factor 1",
            "x [m]",
            "y [m]",
            "z [m]",
        ] {
            assert!(text.contains(&format!("\n{expected}\n")), "{expected}");
        }
        assert_eq!(DeformedPlot::new(&samples::bent(&[])), None);
    }
}
