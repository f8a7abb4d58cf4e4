//! Directions that follow a curve: the tangent of the curve at the point nearest to a
//! given point.
//!
//! # Symbols
//!
//! | symbol | meaning | unit | shape |
//! | --- | --- | --- | --- |
//! | `t` | parameter along a line, -1 at its first and 1 at its second end | - | |
//! | `x(t)` | `c0 + c1 t + c2 t^2`, position on the line | m | 2 |
//! | `g(t)` | `(x - p) . x'`, half the derivative of the squared distance from p | m^2 | |

use nalgebra::Vector2;

/// Largest number of steps of the search for a root of `g` in an interval; bisection, the
/// fallback of the search, alone reaches full precision.
const STEPS: usize = 80;
/// Distances that differ by less, relative to the nearest, are treated as equal: the
/// point is then nearest to the corner of two lines.
const TIE: f64 = 1e-9;

/// One line of a curve, in the direction of its nodes: a parabola, or straight.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Parabola {
    c0: Vector2<f64>,
    c1: Vector2<f64>,
    c2: Vector2<f64>,
    /// Corners of a box that contains the line.
    low: Vector2<f64>,
    high: Vector2<f64>,
}

/// The point of a line that is nearest to a given point.
#[derive(Debug, Clone, Copy)]
struct Nearest {
    squared_distance: f64,
    /// Sine of the angle between the tangent and the direction to the point: 1 if the
    /// line passes the point abreast.
    abreast: f64,
    tangent: Vector2<f64>,
}

impl Parabola {
    /// The line from `first` to `second`, through `middle` at `t = 0` if it is
    /// quadratic.
    pub fn new(first: [f64; 2], second: [f64; 2], middle: Option<[f64; 2]>) -> Self {
        let (a, b) = (Vector2::from(first), Vector2::from(second));
        let mean = 0.5 * (a + b);
        let m = middle.map_or(mean, Vector2::from);
        // The parabola lies within the triangle of its ends and this point.
        let control = 2.0 * m - mean;
        Self {
            c0: m,
            c1: 0.5 * (b - a),
            c2: mean - m,
            low: a.inf(&b).inf(&control),
            high: a.sup(&b).sup(&control),
        }
    }

    fn position(&self, t: f64) -> Vector2<f64> {
        self.c0 + t * (self.c1 + t * self.c2)
    }

    fn tangent(&self, t: f64) -> Vector2<f64> {
        self.c1 + 2.0 * t * self.c2
    }

    /// Squared distance from `p` to the box of the line: a lower bound of the distance to
    /// the line.
    fn squared_bound(&self, p: &Vector2<f64>) -> f64 {
        (p - p.sup(&self.low).inf(&self.high)).norm_squared()
    }

    /// The nearest point to `p`, among the ends and the minima between them.
    ///
    /// ```text
    /// g  = -d.c1 + (c1.c1 - 2 d.c2) t + 3 c1.c2 t^2 + 2 c2.c2 t^3      with d = p - c0
    /// g' =         (c1.c1 - 2 d.c2)   + 6 c1.c2 t   + 6 c2.c2 t^2
    /// ```
    /// The roots of g' part [-1, 1] into pieces on which g has at most one root.
    fn nearest(&self, p: &Vector2<f64>) -> Nearest {
        let d = p - self.c0;
        let linear = self.c1.norm_squared() - 2.0 * d.dot(&self.c2);
        let (mixed, cubic) = (self.c1.dot(&self.c2), self.c2.norm_squared());
        let g = |t: f64| -d.dot(&self.c1) + t * (linear + t * (3.0 * mixed + t * 2.0 * cubic));
        let slope = |t: f64| linear + t * 6.0 * (mixed + t * cubic);

        let mut nearest = self.at(-1.0, p);
        let mut start = -1.0;
        let breaks = quadratic_roots(linear, 6.0 * mixed, 6.0 * cubic);
        for end in breaks.into_iter().flatten().chain([1.0]) {
            if end <= start || end > 1.0 {
                continue;
            }
            let candidate = if g(start) < 0.0 && g(end) > 0.0 {
                self.at(rising_root(g, slope, start, end), p)
            } else {
                self.at(end, p)
            };
            if candidate.squared_distance < nearest.squared_distance {
                nearest = candidate;
            }
            start = end;
        }
        let at_end = self.at(1.0, p);
        if at_end.squared_distance < nearest.squared_distance {
            at_end
        } else {
            nearest
        }
    }

    fn at(&self, t: f64, p: &Vector2<f64>) -> Nearest {
        let way = p - self.position(t);
        let tangent = self.tangent(t);
        let product = way.norm() * tangent.norm();
        let abreast = if product > 0.0 {
            way.perp(&tangent).abs() / product
        } else {
            1.0
        };
        Nearest {
            squared_distance: way.norm_squared(),
            abreast,
            tangent,
        }
    }
}

/// Real roots of `a + b t + c t^2`, ascending.
fn quadratic_roots(a: f64, b: f64, c: f64) -> [Option<f64>; 2] {
    let discriminant = b * b - 4.0 * a * c;
    if c == 0.0 {
        let root = (b != 0.0).then(|| -a / b);
        return [root, None];
    }
    if discriminant < 0.0 {
        return [None, None];
    }
    // Adding terms of equal sign loses no digits; the product of the roots is a/c.
    let q = -0.5 * (b + discriminant.sqrt().copysign(b));
    let (first, second) = (q / c, if q != 0.0 { a / q } else { 0.0 });
    [Some(first.min(second)), Some(first.max(second))]
}

/// The root of a function that rises through zero between `low` and `high`: Newton steps
/// if they remain inside, otherwise bisection.
fn rising_root(g: impl Fn(f64) -> f64, slope: impl Fn(f64) -> f64, low: f64, high: f64) -> f64 {
    let (mut low, mut high) = (low, high);
    let mut t = 0.5 * (low + high);
    for _ in 0..STEPS {
        let value = g(t);
        if value > 0.0 {
            high = t;
        } else {
            low = t;
        }
        let newton = t - value / slope(t);
        let next = if newton > low && newton < high {
            newton
        } else {
            0.5 * (low + high)
        };
        if next == t || value == 0.0 {
            return t;
        }
        t = next;
    }
    t
}

/// Angle from +y to the tangent of the curve at its point nearest to `p`, in (-pi, pi]
/// \[rad\]; `None` for a curve without extent.
///
/// At a corner of the curve that is nearest with both its lines, the line that passes the
/// point abreast is used.
pub(super) fn direction(curve: &[Parabola], p: [f64; 2]) -> Option<f64> {
    let p = Vector2::from(p);
    let mut best: Option<Nearest> = None;
    for line in curve {
        let limit = best.map_or(f64::INFINITY, |best| best.squared_distance);
        if line.squared_bound(&p) > limit * (1.0 + TIE) {
            continue;
        }
        let found = line.nearest(&p);
        let equal = (found.squared_distance - limit).abs() <= TIE * limit;
        let better = match best {
            Some(best) if equal => found.abreast > best.abreast + TIE,
            _ => found.squared_distance < limit,
        };
        if better {
            best = Some(found);
        }
    }
    let tangent = best?.tangent;
    (tangent.norm() > 0.0).then(|| tangent.y.atan2(tangent.x))
}

#[cfg(test)]
#[path = "follow_tests.rs"]
mod tests;
