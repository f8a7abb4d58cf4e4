//! The line of a web, or of a bound of a fill, between two points of the contour.

use super::super::super::distance;

/// A line across a section.
#[derive(Debug, Clone, Copy)]
pub(in super::super) struct Line {
    origin: [f64; 2],
    /// Its unit normal, forward.
    pub normal: [f64; 2],
}

impl Line {
    /// From a point of the suction side to one of the pressure side.
    pub fn between([from, to]: [[f64; 2]; 2]) -> Self {
        let height = distance(from, to);
        let along = [0, 1].map(|i| (to[i] - from[i]) / height);
        Self {
            origin: from,
            normal: [-along[1], along[0]],
        }
    }

    /// Distance of a point from it, positive ahead of it.
    pub fn offset(&self, point: [f64; 2]) -> f64 {
        let along = |i: usize| (point[i] - self.origin[i]) * self.normal[i];
        along(0) + along(1)
    }
}
