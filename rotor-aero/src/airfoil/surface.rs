//! One coefficient over angle of attack and Mach number.
//!
//! At each Mach number M_j the coefficient f_j is a monotone cubic in the angle of attack, and so
//! is its limited slope g_j in the Mach number, with g = 0 at the first and last one. Between two
//! Mach numbers of distance h, with t = (M - M_j)/h,
//!
//! ```text
//! f = (1 - 3 t^2 + 2 t^3) f_j + (3 t^2 - 2 t^3) f_{j+1} + h (t - 2 t^2 + t^3) g_j + h (t^3 - t^2) g_{j+1}
//! ```
//!
//! so that the derivatives by both are continuous. The slopes are limited as in
//! [`super::cubic`].

use std::f64::consts::TAU;
use std::fmt;

use super::cubic::{self, Cubic, Ends, Interpolation};
use super::data::Curve;
use crate::real::Real;

/// Angles nearer than this are one knot \[rad\].
const SAME_ANGLE: f64 = 1e-9;

/// Start and factor of the digest.
const FNV_OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
const FNV_PRIME: u64 = 0x0000_0100_0000_01b3;

/// A coefficient over angle of attack (periodic) and Mach number (constant outside its range).
#[derive(Clone, PartialEq)]
pub(super) struct Surface {
    /// Knots, from -pi to pi.
    alpha: Vec<f64>,
    /// Mach numbers, ascending; one or more.
    mach: Vec<f64>,
    /// Values: interval by interval, and in it by Mach number.
    values: Vec<Cubic>,
    /// Slopes by Mach number, in the same order; empty for linear interpolation.
    rises: Vec<Cubic>,
}

/// A surface has thousands of numbers, and each strip of a model refers to some surfaces: only their
/// counts and a digest (FNV-1a of their bytes) are written.
impl fmt::Debug for Surface {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let cubics = self.values.iter().chain(&self.rises).flatten();
        let numbers = self.alpha.iter().chain(&self.mach).chain(cubics);
        let bytes = numbers.flat_map(|number| number.to_le_bytes());
        let digest = bytes.fold(FNV_OFFSET, |digest, byte| {
            (digest ^ u64::from(byte)).wrapping_mul(FNV_PRIME)
        });
        f.debug_struct("Surface")
            .field("angles", &self.alpha.len())
            .field("mach", &self.mach.len())
            .field("digest", &format_args!("{digest:016x}"))
            .finish_non_exhaustive()
    }
}

impl Surface {
    /// The surface of curves of ascending Mach number, each complete from -pi to pi.
    pub(super) fn new(curves: &[Curve], interpolation: Interpolation) -> Self {
        let mach: Vec<f64> = curves
            .iter()
            .map(|curve| curve.mach.unwrap_or(0.0))
            .collect();
        let alpha = union(curves);
        let nodes: Vec<Vec<[f64; 2]>> = curves
            .iter()
            .map(|curve| resampled(curve, &alpha, interpolation))
            .collect();
        let pieces: Vec<Vec<Cubic>> = nodes.iter().map(|at| cubics(&alpha, at)).collect();
        let (values, rises) = match interpolation {
            Interpolation::Monotone if mach.len() > 1 => {
                let rises = mach_slopes(&alpha, &mach, &nodes);
                (interleaved(&pieces), interleaved(&rises))
            }
            Interpolation::Monotone => (interleaved(&pieces), Vec::new()),
            Interpolation::Linear => {
                let value = |at: &Vec<[f64; 2]>| at.iter().map(|node| node[0]).collect::<Vec<_>>();
                let lines: Vec<_> = nodes
                    .iter()
                    .map(|at| cubic::lines(&alpha, &value(at)))
                    .collect();
                (interleaved(&lines), Vec::new())
            }
        };
        Self {
            alpha,
            mach,
            values,
            rises,
        }
    }

    /// The coefficient at an angle of attack and a Mach number.
    pub(super) fn at<T: Real>(&self, alpha: T, mach: T) -> T {
        let alpha = wrapped(alpha);
        let i = cubic::interval(&self.alpha, alpha.re());
        let v = alpha - self.alpha[i];
        let first = i * self.mach.len();
        let last = self.mach.len() - 1;
        let m = mach.re();
        if last == 0 || m <= self.mach[0] {
            return cubic::evaluate(&self.values[first], v);
        }
        if m >= self.mach[last] {
            return cubic::evaluate(&self.values[first + last], v);
        }
        let j = cubic::interval(&self.mach, m);
        let h = self.mach[j + 1] - self.mach[j];
        let t = (mach - self.mach[j]) / h;
        let k = first + j;
        let low = cubic::evaluate(&self.values[k], v);
        let rise = cubic::evaluate(&self.values[k + 1], v) - low;
        if self.rises.is_empty() {
            return low + t * rise;
        }
        let (g, g_next) = (&self.rises[k], &self.rises[k + 1]);
        let (g, g_next) = (cubic::evaluate(g, v) * h, cubic::evaluate(g_next, v) * h);
        low + t * (g + t * (rise * 3.0 - g * 2.0 - g_next + t * (g + g_next - rise * 2.0)))
    }
}

impl Surface {
    /// The coefficient, and its derivatives by the angle of attack and by the Mach number: the same
    /// as [`Self::at`] in plain numbers.
    pub(super) fn slopes(&self, alpha: f64, mach: f64) -> [f64; 3] {
        let alpha = wrapped(alpha);
        let i = cubic::interval(&self.alpha, alpha);
        let v = alpha - self.alpha[i];
        let first = i * self.mach.len();
        let last = self.mach.len() - 1;
        let of = |cubic: &Cubic| [cubic::evaluate(cubic, v), cubic::slope(cubic, v)];
        let constant = |k: usize| {
            let [value, slope] = of(&self.values[k]);
            [value, slope, 0.0]
        };
        if last == 0 || mach <= self.mach[0] {
            return constant(first);
        }
        if mach >= self.mach[last] {
            return constant(first + last);
        }
        let j = cubic::interval(&self.mach, mach);
        let h = self.mach[j + 1] - self.mach[j];
        let (t, k) = ((mach - self.mach[j]) / h, first + j);
        let (low, high) = (of(&self.values[k]), of(&self.values[k + 1]));
        let rise = [0, 1].map(|i| high[i] - low[i]);
        if self.rises.is_empty() {
            return [low[0] + t * rise[0], low[1] + t * rise[1], rise[0] / h];
        }
        let (g, g_next) = (of(&self.rises[k]), of(&self.rises[k + 1]));
        let (g, g_next) = (g.map(|g| g * h), g_next.map(|g| g * h));
        let square = [0, 1].map(|i| rise[i] * 3.0 - g[i] * 2.0 - g_next[i]);
        let third = [0, 1].map(|i| g[i] + g_next[i] - rise[i] * 2.0);
        let at = |i: usize| low[i] + t * (g[i] + t * (square[i] + t * third[i]));
        let by_mach = g[0] + t * (2.0 * square[0] + 3.0 * t * third[0]);
        [at(0), at(1), by_mach / h]
    }
}

/// The angle in the turn from -pi to pi.
pub(super) fn wrapped<T: Real>(alpha: T) -> T {
    let turns = (alpha.re() / TAU).round();
    if turns == 0.0 {
        alpha
    } else {
        alpha - TAU * turns
    }
}

/// All angles of the curves, ascending.
fn union(curves: &[Curve]) -> Vec<f64> {
    let mut all: Vec<f64> = curves
        .iter()
        .flat_map(|curve| curve.alpha.clone())
        .collect();
    all.sort_by(f64::total_cmp);
    all.dedup_by(|next, kept| *next - *kept < SAME_ANGLE);
    all
}

/// Value and slope of a curve at other knots, among which its own are.
fn resampled(curve: &Curve, alpha: &[f64], interpolation: Interpolation) -> Vec<[f64; 2]> {
    let pieces = match interpolation {
        Interpolation::Monotone => cubic::monotone(&curve.alpha, &curve.values, Ends::Periodic),
        Interpolation::Linear => cubic::lines(&curve.alpha, &curve.values),
    };
    let node = |angle: &f64| {
        let i = cubic::interval(&curve.alpha, *angle);
        let v = angle - curve.alpha[i];
        [cubic::evaluate(&pieces[i], v), cubic::slope(&pieces[i], v)]
    };
    alpha.iter().map(node).collect()
}

/// The cubics between nodes of given value and slope.
fn cubics(alpha: &[f64], nodes: &[[f64; 2]]) -> Vec<Cubic> {
    let pairs = alpha.windows(2).zip(nodes.windows(2));
    let cubic = |(a, n): (&[f64], &[[f64; 2]])| {
        cubic::hermite(a[1] - a[0], [n[0][0], n[1][0]], [n[0][1], n[1][1]])
    };
    pairs.map(cubic).collect()
}

/// Limited slopes by Mach number, as monotone cubics in the angle, one list per Mach number.
fn mach_slopes(alpha: &[f64], mach: &[f64], nodes: &[Vec<[f64; 2]>]) -> Vec<Vec<Cubic>> {
    let mut slopes = vec![Vec::with_capacity(alpha.len()); mach.len()];
    for k in 0..alpha.len() {
        let over_mach: Vec<f64> = nodes.iter().map(|at| at[k][0]).collect();
        let limited = cubic::limited_slopes(mach, &over_mach, Ends::Flat);
        for (list, slope) in slopes.iter_mut().zip(limited) {
            list.push(slope);
        }
    }
    let list = slopes.iter();
    list.map(|g| cubic::monotone(alpha, g, Ends::Periodic))
        .collect()
}

/// Lists of all intervals, one per Mach number, as one list by interval and Mach number.
fn interleaved(lists: &[Vec<Cubic>]) -> Vec<Cubic> {
    let intervals = lists.first().map_or(0, Vec::len);
    let at = |i: usize| lists.iter().map(move |list| list[i]);
    (0..intervals).flat_map(at).collect()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::Surface;

    /// The digest distinguishes all choices of signs of eight numbers: two changes do not cancel.
    #[test]
    fn signs_change_the_digest() {
        let text = |signs: u32| {
            let number = |i: usize| match (signs >> i) & 1 {
                0 => 1.0 + i as f64,
                _ => -1.0 - i as f64,
            };
            let cubic = |first: usize| std::array::from_fn(|i| number(first + i));
            let surface = Surface {
                alpha: vec![0.0, 1.0],
                mach: vec![0.0],
                values: vec![cubic(0), cubic(4)],
                rises: Vec::new(),
            };
            format!("{surface:?}")
        };
        let texts: BTreeSet<String> = (0..256).map(text).collect();
        assert_eq!(texts.len(), 256);
    }
}
