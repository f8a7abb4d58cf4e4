//! Buckling shapes of a model, over the equilibrium in gray.

use nalgebra::Vector3;
use shared_geom::figure::{CATEGORIES, Drawing, Figure, GRAY, INK, Label, Legend, SMALL, WIDTH};

use super::fields::{base, displaced, turned};
use crate::input::short_number;
use crate::output::structure::Structure;
use crate::output::views::{Extent, MARGINS, Stroke, View, draw_view, lengths};
use crate::result::{BucklingMode, BucklingResult};

/// Shapes that are shown.
const MOST: usize = 8;
const HEAD: f64 = 170.0;
/// Height of the title of a shape \[figure pixels\].
const TITLE: f64 = 70.0;
/// Greatest height of a shape \[figure pixels\].
const TALLEST: f64 = 700.0;
const LINE: f64 = 5.0;
/// Number of columns for wide shapes, and for tall ones.
const COLUMNS: [usize; 2] = [2, 4];

/// Shapes of critical loads, ready to be saved.
#[derive(Debug, Clone, PartialEq)]
pub struct BucklingPlot {
    title: String,
    modes: Vec<Shown>,
    columns: usize,
}

#[derive(Debug, Clone, PartialEq)]
struct Shown {
    title: String,
    view: View,
    /// Titles of its axes.
    names: [String; 2],
    strokes: Vec<Stroke>,
    extent: Extent,
}

impl BucklingPlot {
    /// The first shapes, each in the plane in which it moves most; `None` without beams
    /// or critical loads.
    pub fn new(result: &BucklingResult) -> Option<Self> {
        if result.beams.is_empty() || result.modes.is_empty() {
            return None;
        }
        let structure = Structure::new(&result.nodes, &result.beams, &[]);
        let base = base(result);
        let shown = |(index, mode): (usize, &BucklingMode)| {
            let (about, view) = view(&structure, mode);
            let moved = match about {
                Some(axis) => turned(&structure, &base, mode, [axis, across(view, axis)]),
                None => displaced(&structure, &base, mode),
            };
            let mut strokes = Vec::new();
            for (positions, color) in [(&base, GRAY), (&moved, CATEGORIES[5])] {
                let lines = structure.curves(positions).into_iter();
                strokes.extend(lines.map(|points| Stroke {
                    points,
                    width: LINE,
                    color,
                }));
            }
            Shown {
                title: title(index, mode, about),
                view,
                names: names(view, about),
                extent: Extent::around(&strokes, &[]),
                strokes,
            }
        };
        let modes = result.modes.iter().take(MOST).enumerate();
        let modes: Vec<_> = modes.map(shown).collect();
        let is_tall = modes.iter().any(|mode| mode.extent.aspect(mode.view) > 1.0);
        Some(Self {
            title: format!("{}: shapes of critical loads", result.name),
            modes,
            columns: COLUMNS[usize::from(is_tall)],
        })
    }

    /// Width of a column \[figure pixels\].
    fn column(&self) -> f64 {
        (f64::from(WIDTH) - 40.0) / self.columns as f64
    }

    /// Space around the frame of a shape: width and height \[figure pixels\].
    fn frame(&self, mode: &Shown) -> [f64; 2] {
        let width = self.column() - MARGINS[0] - MARGINS[1];
        let height = width * mode.extent.aspect(mode.view);
        if height > TALLEST {
            [width * TALLEST / height, TALLEST]
        } else {
            [width, height]
        }
    }

    /// Height of each row \[figure pixels\].
    fn rows(&self) -> Vec<f64> {
        let row = |modes: &[Shown]| {
            let heights = modes.iter().map(|mode| self.frame(mode)[1]);
            heights.fold(0.0, f64::max) + TITLE + MARGINS[3]
        };
        self.modes.chunks(self.columns).map(row).collect()
    }
}

/// Number and factor, and the drawn quantity of a shape that only rotates nodes about an axis.
fn title(index: usize, mode: &BucklingMode, about: Option<usize>) -> String {
    let turns = about.and_then(|axis| ["x", "y", "z"].get(axis));
    let turns = turns.map_or_else(String::new, |axis| format!(", rotation about {axis}"));
    let factor = short_number(mode.factor, 5);
    format!("{}: factor {factor}{turns}", index + 1)
}

/// Titles of the axes of a view: lengths, except for the axis along which a rotation is drawn.
fn names(view: View, about: Option<usize>) -> [String; 2] {
    let mut names = lengths(view);
    if let Some(axis) = about {
        let turn = format!("rotation about {}", ["x", "y", "z"][axis % 3]);
        names[usize::from(across(view, axis) == view[1])] = turn;
    }
    names
}

/// The axis of a view across which a rotation about another axis is drawn.
fn across([first, second]: View, about: usize) -> usize {
    if second == about { first } else { second }
}

/// The plane of a shape, and the axis about which it turns if it displaces nothing: the
/// direction in which it moves most, or one across that axis, and the longest other one
/// of the model.
fn view(structure: &Structure, mode: &BucklingMode) -> (Option<usize>, View) {
    let most = |vectors: &[Vector3<f64>]| {
        let most = vectors.iter();
        let most = most.fold(Vector3::zeros(), |most: Vector3<f64>, v| most.sup(&v.abs()));
        most.imax()
    };
    if mode.is_rotation() {
        let about = most(&mode.rotations);
        let across = match about {
            2 => 1,
            _ => 2,
        };
        return (Some(about), in_plane(structure, across));
    }
    (None, in_plane(structure, most(&mode.displacements)))
}

/// A direction, and the longest other one of the model.
fn in_plane(structure: &Structure, toward: usize) -> View {
    let length = |axis: &usize| structure.length(*axis);
    let others = (0..3).filter(|axis| *axis != toward);
    let along = others.max_by(|a, b| length(a).total_cmp(&length(b)));
    let along = along.unwrap_or((toward + 1) % 3);
    [along.min(toward), along.max(toward)]
}

impl Figure for BucklingPlot {
    fn size(&self) -> (u32, u32) {
        let height = HEAD + self.rows().iter().sum::<f64>();
        (WIDTH, height.ceil() as u32)
    }

    fn draw(&self, drawing: &mut Drawing) {
        drawing.title(&self.title, [40.0, 44.0]);
        let legend = [
            ("equilibrium".to_owned(), LINE, GRAY),
            ("shape, arbitrary scale".to_owned(), LINE, CATEGORIES[5]),
        ];
        Legend::of_lines(legend).draw(drawing, [40.0, 82.0], f64::from(WIDTH) - 80.0);
        let mut top = HEAD;
        for (modes, height) in self.modes.chunks(self.columns).zip(self.rows()) {
            for (column, mode) in modes.iter().enumerate() {
                let left = 20.0 + self.column() * column as f64 + MARGINS[0];
                let frame = self.frame(mode);
                let panel = mode.extent.panel(mode.view, [left, top + TITLE], frame);
                let label = Label::new(SMALL).bold().colored(INK);
                drawing.text(&mode.title, [left, top + 0.5 * TITLE], label);
                let seen = (mode.view, &mode.names);
                draw_view(drawing, seen, &panel, &mode.strokes, &[]);
            }
            top += height;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples;

    #[test]
    fn every_shape_is_seen_in_the_plane_of_its_motion() {
        let plot = BucklingPlot::new(&samples::column()).unwrap();
        let views: Vec<_> = plot.modes.iter().map(|mode| mode.view).collect();
        assert_eq!(views, [[0, 2], [0, 1], [0, 2], [0, 1]]);
        let text = samples::texts(&plot);
        for expected in [
            "column: shapes of critical loads",
            "1: factor 2.4674",
            "2: factor -9.8696",
            "y [m]",
            "z [m]",
        ] {
            assert!(text.contains(&format!("\n{expected}\n")), "{expected}");
        }
        let mut torsion = samples::column();
        torsion.modes = vec![samples::torsion(&torsion.modes[0])];
        let plot = BucklingPlot::new(&torsion).unwrap();
        assert_eq!(plot.modes[0].view, [0, 2]);
        assert_eq!(plot.modes[0].title, "1: factor 2.4674, rotation about x");
        assert_eq!(plot.modes[0].names, ["x [m]", "rotation about x"]);
        // the rotation of the tip is drawn across the bar
        let tip = plot.modes[0].strokes.last().unwrap().points.last().unwrap();
        assert!(tip.z > 0.1, "{tip}");
        let mut none = samples::column();
        none.modes.clear();
        assert_eq!(BucklingPlot::new(&none), None);
    }
}
