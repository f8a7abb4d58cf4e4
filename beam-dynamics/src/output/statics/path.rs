//! The factor of the loads over the displacement of a node.

use shared_geom::figure::{Axes, CATEGORIES, Color, Drawing, Figure, Legend, Stroke, WIDTH, range};

use super::floors::ROUND_OFF;
use super::text::most_displaced;
use crate::output::structure::Structure;
use crate::result::StaticResult;

const HEIGHT: u32 = 1100;
const LINE: f64 = 4.0;
const POINT: f64 = 7.0;
/// Least number of steps for a line.
const LEAST_STEPS: usize = 3;
/// Number of points above which a path has no marks.
const MOST_POINTS: usize = 60;
/// Components below this part of the largest are omitted.
const SMALL_PART: f64 = 0.01;
const NAMES: [&str; 3] = ["along x", "along y", "along z"];

/// A load path, ready to be saved.
#[derive(Debug, Clone, PartialEq)]
pub struct PathPlot {
    title: String,
    curves: Vec<Curve>,
}

/// One component of the displacement.
#[derive(Debug, Clone, PartialEq)]
struct Curve {
    name: &'static str,
    color: Color,
    /// Displacement \[m\] and factor.
    points: Vec<[f64; 2]>,
}

impl PathPlot {
    /// The path of the node of the largest displacement; `None` for fewer than three equilibria, or
    /// without displacement.
    pub fn new(result: &StaticResult) -> Option<Self> {
        if result.steps.len() < LEAST_STEPS {
            return None;
        }
        let most = result.steps.iter().map(|step| most_displaced(result, step));
        let (node, largest) = most.max_by(|a, b| a.1.total_cmp(&b.1))?;
        let structure = Structure::new(&result.nodes, &result.beams, &result.blades);
        if largest <= ROUND_OFF * structure.size() {
            return None;
        }
        let position = &result.nodes.get(node)?.position;
        let curve = |axis: usize| Curve {
            name: NAMES[axis],
            color: CATEGORIES[[0, 5, 2][axis]],
            points: result
                .steps
                .iter()
                .map(|step| [step.positions[node][axis] - position[axis], step.factor])
                .collect(),
        };
        let moves = |curve: &Curve| {
            let sizes = curve.points.iter().map(|point| point[0].abs());
            sizes.fold(0.0, f64::max) > SMALL_PART * largest
        };
        let curves: Vec<_> = (0..3).map(curve).filter(moves).collect();
        (!curves.is_empty()).then(|| Self {
            title: format!(
                "{}: load path, displacement of node {}",
                result.name, result.nodes[node].label
            ),
            curves,
        })
    }
}

impl Figure for PathPlot {
    fn size(&self) -> (u32, u32) {
        (WIDTH, HEIGHT)
    }

    fn draw(&self, drawing: &mut Drawing) {
        let (width, height) = drawing.size();
        let points = || self.curves.iter().flat_map(|curve| &curve.points);
        let axes = Axes {
            left: 190.0,
            right: width - 50.0,
            top: 150.0,
            bottom: height - 130.0,
            x: range(points().map(|point| point[0]), 0.0),
            y: range(points().map(|point| point[1]), 0.0),
        };
        drawing.title(&self.title, [40.0, 44.0]);
        let entry = |curve: &Curve| (curve.name.to_owned(), LINE, curve.color);
        let legend = Legend::of_lines(self.curves.iter().map(entry));
        legend.draw(drawing, [axes.left, 86.0], axes.right - axes.left);
        axes.draw_grid(drawing);
        for curve in &self.curves {
            axes.curve(drawing, &curve.points, Stroke::new(LINE, curve.color));
            if curve.points.len() <= MOST_POINTS {
                for point in &curve.points {
                    drawing.disc(axes.position(*point), POINT, curve.color);
                }
            }
        }
        axes.draw(drawing, Some("displacement [m]"), "factor of the loads [-]");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples;

    #[test]
    fn the_path_of_the_tip_is_drawn() {
        let factors: Vec<_> = (0..=10).map(|k| f64::from(k) / 10.0).collect();
        let plot = PathPlot::new(&samples::bent(&factors)).unwrap();
        assert_eq!(plot.curves.len(), 3);
        let [displacement, factor] = plot.curves[1].points[5];
        assert!((displacement - 0.2).abs() < 1e-14 && factor == 0.5);
        let text = samples::texts(&plot);
        for expected in [
            "bent blade: load path, displacement of node n8",
            "along z",
            "displacement [m]",
            "factor of the loads [-]",
        ] {
            assert!(text.contains(&format!("\n{expected}\n")), "{expected}");
        }
    }

    #[test]
    fn two_equilibria_are_no_path() {
        assert_eq!(PathPlot::new(&samples::bent(&[0.0, 1.0])), None);
        assert_eq!(PathPlot::new(&samples::bent(&[0.0; 4])), None);
        assert_eq!(PathPlot::new(&samples::bent(&[0.0, 1e-14, 2e-14])), None);
    }
}
