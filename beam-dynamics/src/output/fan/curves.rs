//! Lines and marks of the modes, and rings for measured points.

use shared_geom::figure::{Axes, Color, Drawing, Mark, Stroke};

use super::{Curve, FanPlot, looks};
use crate::result::ModeKind;

pub(super) use shared_geom::figure::BLACK;

/// Radius of the rings of measured points \[figure pixels\].
pub(super) const RING: f64 = 13.0;
/// Half the size of a mark \[figure pixels\].
pub(super) const MARK: f64 = 9.0;
/// Smallest distance of two marks of a line.
const BETWEEN_MARKS: f64 = 80.0;
/// Width of a line \[figure pixels\].
pub(super) const LINE: f64 = 4.0;
/// Additional width of a line and size of a mark for each one that covers it.
const RIM: f64 = 6.0;
/// Critical speeds beyond which their marks are small.
const MANY: usize = 20;

/// Runs of neighboring points of a curve.
pub(super) fn frequency_runs(plot: &FanPlot, curve: &Curve, axes: &Axes) -> Vec<Vec<[f64; 2]>> {
    let found = runs(&plot.speeds, &curve.frequencies, |point| point);
    let with_zeros = |run: Vec<[f64; 2]>| {
        let mut positions = Vec::with_capacity(run.len() + 1);
        for pair in run.windows(2) {
            positions.push(axes.position(pair[0]));
            let between = |zero: &&f64| (pair[0][0]..pair[1][0]).contains(*zero);
            let zeros = curve.zeros.iter().filter(between);
            positions.extend(zeros.map(|zero| axes.position([*zero, 0.0])));
        }
        positions.extend(run.last().map(|last| axes.position(*last)));
        positions
    };
    found.into_iter().map(with_zeros).collect()
}

/// Runs of neighboring points at speeds with a value, as positions.
pub(super) fn runs(
    speeds: &[f64],
    values: &[Option<f64>],
    position: impl Fn([f64; 2]) -> [f64; 2],
) -> Vec<Vec<[f64; 2]>> {
    let points = speeds.iter().zip(values);
    let positions: Vec<_> = points
        .map(|(speed, value)| value.map(|value| position([*speed, value])))
        .collect();
    let runs = positions.split(Option::is_none);
    runs.map(|run| run.iter().flatten().copied().collect::<Vec<_>>())
        .filter(|run| !run.is_empty())
        .collect()
}

/// Draws the lines, the measured points, and the marks.
pub(super) fn draw(drawing: &mut Drawing, plot: &FanPlot, axes: &Axes) {
    let lines = plot.curves.iter().map(|c| (c.color, &*c.frequencies));
    let lines: Vec<_> = lines.collect();
    let covers = looks::covers(&lines);
    for (curve, covers) in plot.curves.iter().zip(&covers) {
        for run in frequency_runs(plot, curve, axes) {
            curve.stroke(*covers).draw(drawing, &run);
        }
    }
    // Below the marks, which are not covered.
    for &point in &plot.measured {
        Mark::Ring.draw(drawing, axes.position(point), RING, BLACK);
    }
    let step = marked_every(plot, axes);
    for (curve, covers) in plot.curves.iter().zip(covers) {
        let size = MARK + RIM * covers as f64;
        for (k, frequency) in curve.frequencies.iter().enumerate() {
            let is_end = curve.end().is_some_and(|end| end.0 == k);
            let shown = frequency.filter(|_| k % step == 0 || is_end);
            if let (Some(frequency), Some(kind)) = (shown, curve.kinds[k]) {
                let position = axes.position([plot.speeds[k], frequency]);
                mark(kind).draw(drawing, position, size, curve.color_of(kind));
            }
        }
    }
    let size = diamond_size(plot.critical.len());
    for point in &plot.critical {
        Mark::OpenDiamond.draw(drawing, axes.position(*point), size, BLACK);
    }
}

/// Distance in speeds between two marks of a line.
fn marked_every(plot: &FanPlot, axes: &Axes) -> usize {
    let between = (axes.right - axes.left) / plot.speeds.len() as f64;
    (BETWEEN_MARKS / between).ceil().max(1.0) as usize
}

/// The mark of a kind of mode.
pub(super) fn mark(kind: ModeKind) -> Mark {
    match kind {
        ModeKind::Flap => Mark::Disc,
        ModeKind::Lag => Mark::Square,
        ModeKind::Torsion => Mark::Up,
        ModeKind::Axial => Mark::Diamond,
        ModeKind::Lateral | ModeKind::ForeAft => Mark::Down,
        ModeKind::SideSide => Mark::OpenDiamond,
        ModeKind::Rigid => Mark::Dash,
        ModeKind::Coupled => Mark::Cross,
    }
}

impl Curve {
    /// The line of the curve, broader below the number of lines that cover it.
    pub fn stroke(&self, covers: usize) -> Stroke {
        Stroke::new(LINE + RIM * covers as f64, self.color).dashed(self.pattern)
    }

    /// The color of its marks at speeds where it has this kind.
    fn color_of(&self, kind: ModeKind) -> Color {
        if kind == self.kind {
            self.color
        } else {
            looks::color(kind)
        }
    }
}

/// Half the size of each of `count` diamonds \[figure pixels\]: many are drawn smaller.
pub(super) fn diamond_size(count: usize) -> f64 {
    if count > MANY { 11.0 } else { 17.0 }
}
