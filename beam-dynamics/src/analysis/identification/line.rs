//! The straight line through points, by least squares.

/// A line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Line {
    /// Slope.
    pub slope: f64,
    /// Largest difference of a point from it.
    pub scatter: f64,
}

/// The line through points (x, y); `None` for fewer than two different x.
pub(super) fn through(points: &[[f64; 2]]) -> Option<Line> {
    let count = points.len() as f64;
    let mean = |k: usize| points.iter().map(|point| point[k]).sum::<f64>() / count;
    let [x, y] = [mean(0), mean(1)];
    let sum = |of: &dyn Fn(f64, f64) -> f64| -> f64 {
        points
            .iter()
            .map(|point| of(point[0] - x, point[1] - y))
            .sum()
    };
    let slope = sum(&|a, b| a * b) / sum(&|a, _| a * a);
    let differences = points
        .iter()
        .map(|point| point[1] - y - slope * (point[0] - x));
    let scatter = differences.fold(0.0, |most: f64, off| most.max(off.abs()));
    (slope.is_finite() && scatter.is_finite()).then_some(Line { slope, scatter })
}
