//! Columns that lean along the surface, beside a corner of the contour or of a spar.
//!
//! From a depth on, at the depth d below it, a node is at `a n + b e`, n the normal of the surface and
//! e a direction along it. On a surface of curvature k it has this depth if
//!
//! ```text
//! (1 - k a)^2 + (k b)^2 = (1 - k d)^2
//! ```
//!
//! Beside a corner of the contour `b = M a`, with M the lean. At a corner of a spar a node has the same
//! depth below the web, whose normal has the components (cos, sin), if `a cos + b sin = d`; beside the
//! corner b is smaller by the part that the lean has of its value there.

/// Steps of the search for a node at a corner.
const STEPS: usize = 30;
/// Sine of a turn below which the surface counts as straight.
const STRAIGHT: f64 = 0.1;

/// The lean of a column from a depth on.
#[derive(Debug, Clone, PartialEq)]
pub(in super::super) struct Bend {
    /// The depth at which it begins.
    pub depth: f64,
    /// Normal of the surface.
    pub normal: [f64; 2],
    /// Direction along the surface.
    pub direction: [f64; 2],
    /// Curvature of the surface.
    pub bend: f64,
    pub lean: Lean,
}

/// The source of a lean.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in super::super) enum Lean {
    /// M.
    Along(f64),
    /// The part that it has of the lean at the corner of a spar, with this turn.
    Part(f64, Turn),
}

/// The turn from a surface into a web.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in super::super) struct Turn {
    /// Component of the normal of the web along the normal of the surface.
    pub cosine: f64,
    /// Its component along the surface, into the spar.
    pub sine: f64,
    /// Curvature of the surface.
    pub bend: f64,
}

impl Turn {
    /// The lean of the line of the mitre between straight surfaces.
    pub fn lean(&self) -> f64 {
        self.sine / (1.0 + self.cosine)
    }

    /// Distance along the surface of the node at a depth below surface and web.
    fn along(&self, depth: f64) -> f64 {
        let mut along = self.lean() * depth;
        if self.sine < STRAIGHT {
            return along;
        }
        for _ in 0..STEPS {
            along = (depth - normal(depth, along, self.bend) * self.cosine) / self.sine;
        }
        along
    }
}

impl Bend {
    /// Distance along the surface of the node at a depth below the begin.
    pub fn along(&self, depth: f64) -> f64 {
        match self.lean {
            Lean::Part(part, turn) => part * turn.along(depth),
            Lean::Along(lean) => {
                let twice = depth * (2.0 - self.bend * depth);
                let root = 1.0 - (1.0 + lean * lean) * self.bend * twice;
                lean * twice / (1.0 + root.max(0.0).sqrt())
            }
        }
    }

    /// The offset from the begin of a node at a depth below it, with a distance along the surface.
    pub fn beyond(&self, depth: f64, along: f64) -> [f64; 2] {
        let across = normal(depth, along, self.bend);
        [0, 1].map(|i| across * self.normal[i] + along * self.direction[i])
    }
}

/// Distance along the normal of a node at a depth, with a distance along the surface.
fn normal(depth: f64, along: f64, bend: f64) -> f64 {
    let root = (1.0 - bend * depth).powi(2) - (bend * along).powi(2);
    let twice = 2.0 * depth - bend * depth * depth + bend * along * along;
    twice / (1.0 + root.max(0.0).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// On a circle of radius 10 beside a plane that it meets at 70 degrees: both depths are exact.
    #[test]
    fn a_node_at_a_corner_has_one_depth_below_both_faces() {
        for angle in [1.2_f64, 1.9] {
            let turn = Turn {
                cosine: angle.cos(),
                sine: angle.sin(),
                bend: 0.1,
            };
            let bend = Bend {
                depth: 0.0,
                normal: [1.0, 0.0],
                direction: [0.0, 1.0],
                bend: 0.1,
                lean: Lean::Part(1.0, turn),
            };
            let [a, b] = bend.beyond(1.5, bend.along(1.5));
            let below_circle = 10.0 - (10.0 - a).hypot(b);
            let below_plane = a * turn.cosine + b * turn.sine;
            assert!((below_circle - 1.5).abs() < 1e-12, "{below_circle}");
            assert!((below_plane - 1.5).abs() < 1e-12, "{below_plane}");
            let lean = Bend {
                lean: Lean::Along(0.7),
                ..bend
            };
            let [a, b] = lean.beyond(1.5, lean.along(1.5));
            assert!((b / a - 0.7).abs() < 1e-12, "{a} {b}");
            let below_circle = 10.0 - (10.0 - a).hypot(b);
            assert!((below_circle - 1.5).abs() < 1e-12, "{below_circle}");
        }
    }
}
