//! Lines and marks of the modes, and rings for measured points.

use plotters::backend::DrawingBackend;
use plotters::style::{BLACK, RGBColor};
use shared_geom::figure::{Canvas, FigureProblem};

use super::axes::Axes;
use super::{Curve, FanPlot};
use crate::result::ModeKind;

/// Radius of the rings of measured points \[figure pixels\].
pub(super) const RING: f64 = 13.0;
/// Half the size of a mark.
const MARK: f64 = 9.0;
/// Smallest distance of two marks of a line.
const BETWEEN_MARKS: f64 = 80.0;
const LINE: f64 = 4.0;
/// Critical speeds beyond which their marks are small.
const MANY: usize = 20;
/// Lengths of dashes and gaps in turns; none for a solid line.
const PATTERNS: [&[f64]; 4] = [&[], &[26.0, 14.0], &[7.0, 11.0], &[26.0, 9.0, 7.0, 9.0]];

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
pub(super) fn draw<B: DrawingBackend>(
    canvas: &Canvas<B>,
    plot: &FanPlot,
    axes: &Axes,
) -> Result<(), FigureProblem> {
    for curve in &plot.curves {
        for run in frequency_runs(plot, curve, axes) {
            line(canvas, &run, curve.pattern, curve.color)?;
        }
    }
    // Below the marks, which are not covered.
    for &point in &plot.measured {
        ring(canvas, axes.position(point))?;
    }
    let step = marked_every(plot, axes);
    for curve in &plot.curves {
        for (k, frequency) in curve.frequencies.iter().enumerate() {
            let is_end = curve.end().is_some_and(|end| end.0 == k);
            let shown = frequency.filter(|_| k % step == 0 || is_end);
            if let (Some(frequency), Some(kind)) = (shown, curve.kinds[k]) {
                let position = axes.position([plot.speeds[k], frequency]);
                mark(canvas, position, kind, curve.color)?;
            }
        }
    }
    let mut critical = plot.critical.iter();
    let size = diamond_size(plot.critical.len());
    critical.try_for_each(|point| diamond(canvas, axes.position(*point), size))
}

/// Distance in speeds between two marks of a line.
fn marked_every(plot: &FanPlot, axes: &Axes) -> usize {
    let between = (axes.right - axes.left) / plot.speeds.len() as f64;
    (BETWEEN_MARKS / between).ceil().max(1.0) as usize
}

/// A solid or dashed line, by the number of its pattern.
pub(super) fn line<B: DrawingBackend>(
    canvas: &Canvas<B>,
    points: &[[f64; 2]],
    pattern: usize,
    color: RGBColor,
) -> Result<(), FigureProblem> {
    let pattern = PATTERNS[pattern % PATTERNS.len()];
    if pattern.is_empty() {
        return canvas.line(points, LINE, color);
    }
    for dash in dashes(points, pattern) {
        canvas.line(&dash, LINE, color)?;
    }
    Ok(())
}

/// The dashes of a line, which continue around its corners.
fn dashes(points: &[[f64; 2]], pattern: &[f64]) -> Vec<[[f64; 2]; 2]> {
    let mut dashes = Vec::new();
    // Length reached by the dash or gap, and its number: gaps are odd.
    let (mut left, mut part) = (pattern[0], 0);
    for pair in points.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        let at = |s: f64| std::array::from_fn(|i| a[i] + (b[i] - a[i]) * s / length);
        let mut done = 0.0;
        while done < length {
            let step = left.min(length - done);
            if part % 2 == 0 {
                dashes.push([at(done), at(done + step)]);
            }
            done += step;
            left -= step;
            if left <= 0.0 {
                part = (part + 1) % pattern.len();
                left = pattern[part];
            }
        }
    }
    dashes
}

/// The mark of a kind of mode.
pub(super) fn mark<B: DrawingBackend>(
    canvas: &Canvas<B>,
    [x, y]: [f64; 2],
    kind: ModeKind,
    color: RGBColor,
) -> Result<(), FigureProblem> {
    let polygon = |corners: &[[f64; 2]], size: f64| {
        let moved = corners
            .iter()
            .map(|[u, v]| [x + size * MARK * u, y + size * MARK * v]);
        moved.collect::<Vec<_>>()
    };
    match kind {
        ModeKind::Flap => canvas.disc([x, y], MARK, color),
        ModeKind::Lag => {
            let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
            canvas.polygon(&polygon(&square, 0.95), color)
        }
        ModeKind::Torsion => {
            let triangle = [[0.0, -1.2], [1.1, 0.8], [-1.1, 0.8]];
            canvas.polygon(&polygon(&triangle, 1.1), color)
        }
        ModeKind::Axial => {
            let diamond = [[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]];
            canvas.polygon(&polygon(&diamond, 1.35), color)
        }
        ModeKind::Lateral => {
            let triangle = [[0.0, 1.2], [1.1, -0.8], [-1.1, -0.8]];
            canvas.polygon(&polygon(&triangle, 1.1), color)
        }
        ModeKind::Rigid => {
            canvas.line(&polygon(&[[-1.2, 0.0], [1.2, 0.0]], 1.0), 1.4 * LINE, color)
        }
        ModeKind::Coupled => {
            for arm in [[[-1.0, -1.0], [1.0, 1.0]], [[-1.0, 1.0], [1.0, -1.0]]] {
                canvas.line(&polygon(&arm, 1.0), 1.4 * LINE, color)?;
            }
            Ok(())
        }
    }
}

/// Half the size of each of `count` diamonds \[figure pixels\]: many are drawn smaller.
pub(super) fn diamond_size(count: usize) -> f64 {
    if count > MANY { 11.0 } else { 17.0 }
}

/// An open diamond, for critical speeds.
pub(super) fn diamond<B: DrawingBackend>(
    canvas: &Canvas<B>,
    [x, y]: [f64; 2],
    size: f64,
) -> Result<(), FigureProblem> {
    let corners = [
        [x, y - size],
        [x + size, y],
        [x, y + size],
        [x - size, y],
        [x, y - size],
    ];
    canvas.line(&corners, 0.8 * LINE, BLACK)
}

/// An open ring, through which lines are visible.
pub(super) fn ring<B: DrawingBackend>(
    canvas: &Canvas<B>,
    [x, y]: [f64; 2],
) -> Result<(), FigureProblem> {
    const CORNERS: u32 = 48;
    let circle: Vec<_> = (0..=CORNERS)
        .map(|k| {
            let (sine, cosine) =
                (f64::from(k) / f64::from(CORNERS) * std::f64::consts::TAU).sin_cos();
            [x + RING * cosine, y + RING * sine]
        })
        .collect();
    canvas.line(&circle, 0.8 * LINE, BLACK)
}

#[cfg(test)]
mod tests {
    use super::*;

    // 100 pixels: dashes from 0 to 26, 40 to 66 and 80 to 100, also around a corner
    // at 50.
    #[test]
    fn dashes_go_on_around_corners() {
        let lengths = |points: &[[f64; 2]]| -> Vec<f64> {
            let length = |[a, b]: &[[f64; 2]; 2]| (b[0] - a[0]).hypot(b[1] - a[1]);
            dashes(points, PATTERNS[1]).iter().map(length).collect()
        };
        assert_eq!(lengths(&[[0.0, 0.0], [100.0, 0.0]]), [26.0, 26.0, 20.0]);
        let bent = [[0.0, 0.0], [50.0, 0.0], [50.0, 50.0]];
        assert_eq!(lengths(&bent), [26.0, 10.0, 16.0, 20.0]);
        assert_eq!(lengths(&[[1.0, 1.0], [1.0, 1.0]]), [0.0; 0]);
    }
}
