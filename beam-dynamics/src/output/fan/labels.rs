//! Names of the modes at the right ends of their lines.

use shared_geom::figure::{Anchor, Axes, Drawing, INK, Label, SMALL, WHITE, text_width};

use super::axes::LEADER;
use super::boxes::{Box2, Obstacles, spread};
use super::{Curve, FanPlot};

/// Distance of two names, in sizes of their letters.
const LINE_SPACING: f64 = 1.15;
const LEADER_LINE: f64 = 2.0;

/// Writes the names of the modes that reach the last speed in a column to the right,
/// each joined with its line.
pub(super) fn draw_column(drawing: &mut Drawing, plot: &FanPlot, axes: &Axes) {
    let mut ends: Vec<_> = plot
        .curves
        .iter()
        .filter_map(|curve| Some((curve, last_position(plot, curve, axes)?)))
        .collect();
    ends.sort_by(|a, b| a.1[1].total_cmp(&b.1[1]));
    let wanted: Vec<_> = ends.iter().map(|end| end.1[1]).collect();
    let space = axes.bottom - axes.top;
    let gap = (LINE_SPACING * SMALL).min(space / ends.len().max(1) as f64);
    let size = SMALL.min(gap / LINE_SPACING);
    let heights = spread(&wanted, gap, [axes.top, axes.bottom]);
    for ((curve, end), height) in ends.into_iter().zip(heights) {
        // Out of the curve, over to the height of the name, and on to it.
        let text = axes.right.max(end[0]) + LEADER;
        let bends = [end[0] + 20.0, text - 22.0];
        let leader = [
            end,
            [bends[0], end[1]],
            [bends[1], height],
            [text - 10.0, height],
        ];
        drawing.line(&leader, LEADER_LINE, curve.color);
        drawing.text(&curve.name, [text, height], Label::new(size).colored(INK));
    }
}

/// Position of the end of a curve that reaches the last speed, at the edge of the frame.
fn last_position(plot: &FanPlot, curve: &Curve, axes: &Axes) -> Option<[f64; 2]> {
    let (k, frequency) = curve.end()?;
    let position = axes.position([plot.speeds[k], frequency]);
    // If measured points lie beyond the last speed, a line across to the column would look like
    // more of the curve.
    let at_edge = position[0] + LEADER >= axes.right;
    (k + 1 == plot.speeds.len() && at_edge).then_some(position)
}

/// Names placed within the frame.
#[derive(Debug, Clone, Default)]
pub(super) struct Placed(Vec<(String, Box2)>);

/// Positions of the names of modes that end before the edge of the frame, without short pieces of
/// lines: the table names them.
pub(super) fn beside_ends(plot: &FanPlot, axes: &Axes, obstacles: &mut Obstacles) -> Placed {
    let mut placed = Placed::default();
    for curve in plot
        .curves
        .iter()
        .filter(|curve| last_position(plot, curve, axes).is_none() && curve.is_long())
    {
        let Some((k, frequency)) = curve.end() else {
            continue;
        };
        let [x, y] = axes.position([plot.speeds[k], frequency]);
        let width = text_width(&curve.name, Label::new(SMALL));
        let right = x + 0.5 * width + 26.0;
        let steps = [0.0, -0.7, 0.7, -1.1, 1.1, -1.6, 1.6];
        let beside = steps.map(|step| [right, y + step * SMALL]);
        let above = [-1.0, 1.0, -1.6, 1.6].map(|step| [x, y + step * SMALL]);
        let candidates = beside.into_iter().chain(above);
        let boxes = candidates.map(|center| Box2::around(center, width, SMALL));
        if let Some(position) = obstacles.best(boxes) {
            obstacles.add_box(position);
            placed.0.push((curve.name.clone(), position));
        }
    }
    placed
}

impl Placed {
    /// Writes the names, on white.
    pub fn draw(&self, drawing: &mut Drawing) {
        for (name, position) in &self.0 {
            drawing.polygon(&position.corners(), WHITE);
            drawing.text(
                name,
                position.center(),
                Label::new(SMALL).anchored(Anchor::Middle),
            );
        }
    }
}
