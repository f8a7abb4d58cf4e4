//! Positions of a field for possible arrows, and the grid of arrows.

/// Distance of the arrows [figure pixels].
pub(super) const SPACING: f64 = 64.0;

/// A position on the figure with the vector there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sample {
    /// Position [figure pixels].
    pub position: [f64; 2],
    /// Vector (y, z) [SI].
    pub vector: [f64; 2],
    /// Area that it represents [square figure pixels].
    pub area: f64,
}

impl Sample {
    /// The sample of a triangle: at the point of the grid of arrows if the triangle contains
    /// it, else in its middle.
    pub fn of(positions: [[f64; 2]; 3], vectors: [[f64; 2]; 3]) -> Self {
        let mean =
            [0, 1].map(|axis| positions.iter().map(|position| position[axis]).sum::<f64>() / 3.0);
        let wanted = grid_point(mean);
        let doubled = |a: [f64; 2], b: [f64; 2]| {
            (a[0] - wanted[0]) * (b[1] - wanted[1]) - (b[0] - wanted[0]) * (a[1] - wanted[1])
        };
        let [a, b, c] = positions;
        let areas = [doubled(b, c), doubled(c, a), doubled(a, b)];
        let whole: f64 = areas.iter().sum();
        let weights = areas.map(|area| area / whole);
        let (position, weights) = if weights.iter().all(|weight| *weight >= 0.0) {
            (wanted, weights)
        } else {
            (mean, [1.0 / 3.0; 3])
        };
        let sum = |axis: usize| (0..3).map(|k| weights[k] * vectors[k][axis]).sum();
        Self {
            position,
            vector: [0, 1].map(sum),
            area: 0.5 * whole.abs(),
        }
    }
}

/// The point of the grid of arrows whose square contains a position.
pub(super) fn grid_point(position: [f64; 2]) -> [f64; 2] {
    position.map(|value| ((value / SPACING).floor() + 0.5) * SPACING)
}
