//! Monotone cubic interpolation.
//!
//! On the interval of length h that begins at x_i, with v = x - x_i, d = (f_{i+1} - f_i)/h and
//! slopes s at both ends,
//!
//! ```text
//! f = f_i + s_i v + (3 d - 2 s_i - s_{i+1}) v^2/h + (s_i + s_{i+1} - 2 d) v^3/h^2
//! s = (w_- + w_+) / (w_-/d_- + w_+/d_+),  w_- = 2 h_+ + h_-,  w_+ = h_+ + 2 h_-,  if d_- d_+ > 0
//! s = 0                                                                           otherwise
//! ```
//!
//! No interval has an extremum inside, and the first derivative is continuous.
//!
//! # References
//! - F. N. Fritsch and R. E. Carlson, "Monotone piecewise cubic interpolation", SIAM Journal on
//!   Numerical Analysis 17, 1980.
//! - F. N. Fritsch and J. Butland, "A method for constructing local monotone piecewise cubic
//!   interpolants", SIAM Journal on Scientific and Statistical Computing 5, 1984.

use crate::real::Real;

/// The interpolation of a table in angle of attack and Mach number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Interpolation {
    /// Monotone cubics: continuous derivatives, no overshoot.
    #[default]
    Monotone,
    /// Straight lines, for comparisons with programs that use them.
    Linear,
}

/// The slopes at both ends of a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Ends {
    /// Zero: constant extrapolation then has a continuous derivative.
    Flat,
    /// Both ends are the same point of a periodic curve.
    Periodic,
}

/// A cubic in the distance from the start of its interval, constant term first.
pub(super) type Cubic = [f64; 4];

/// Slopes of the monotone interpolant of `f` at the ascending `x`.
pub(super) fn limited_slopes(x: &[f64], f: &[f64], ends: Ends) -> Vec<f64> {
    let n = x.len();
    let mut slopes = vec![0.0; n];
    if n < 2 {
        return slopes;
    }
    let steps: Vec<f64> = x.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let rises = f.windows(2).zip(&steps);
    let secants: Vec<f64> = rises.map(|(pair, h)| (pair[1] - pair[0]) / h).collect();
    for i in 1..n - 1 {
        slopes[i] = harmonic(steps[i - 1], steps[i], secants[i - 1], secants[i]);
    }
    if ends == Ends::Periodic {
        let s = harmonic(steps[n - 2], steps[0], secants[n - 2], secants[0]);
        slopes[0] = s;
        slopes[n - 1] = s;
    }
    slopes
}

/// The weighted harmonic mean of two secants, zero at an extremum.
fn harmonic(h_before: f64, h_after: f64, before: f64, after: f64) -> f64 {
    let differ = before == 0.0 || after == 0.0 || (before > 0.0) != (after > 0.0);
    if differ {
        return 0.0;
    }
    let w_before = 2.0 * h_after + h_before;
    let w_after = h_after + 2.0 * h_before;
    (w_before + w_after) / (w_before / before + w_after / after)
}

/// The cubic with values `f` and slopes `s` at the ends of an interval of length `h`.
pub(super) fn hermite(h: f64, f: [f64; 2], s: [f64; 2]) -> Cubic {
    let d = (f[1] - f[0]) / h;
    let second = (3.0 * d - 2.0 * s[0] - s[1]) / h;
    let third = (s[0] + s[1] - 2.0 * d) / (h * h);
    [f[0], s[0], second, third]
}

/// The straight line between two values at the ends of an interval of length `h`.
pub(super) fn straight(h: f64, f: [f64; 2]) -> Cubic {
    [f[0], (f[1] - f[0]) / h, 0.0, 0.0]
}

/// The value of a cubic at the distance `v` from the start of its interval.
pub(super) fn evaluate<T: Real>(cubic: &Cubic, v: T) -> T {
    ((v * cubic[3] + cubic[2]) * v + cubic[1]) * v + cubic[0]
}

/// The slope of a cubic at the distance `v` from the start of its interval.
pub(super) fn slope(cubic: &Cubic, v: f64) -> f64 {
    (3.0 * cubic[3] * v + 2.0 * cubic[2]) * v + cubic[1]
}

/// The interval of ascending `knots` that has `x`: the first or last one for an `x` outside,
/// the first for a value that is not a number.
pub(super) fn interval(knots: &[f64], x: f64) -> usize {
    let after = knots.partition_point(|knot| *knot <= x);
    after.saturating_sub(1).min(knots.len().saturating_sub(2))
}

/// The cubics of all intervals of the monotone interpolant.
pub(super) fn monotone(x: &[f64], f: &[f64], ends: Ends) -> Vec<Cubic> {
    let s = limited_slopes(x, f, ends);
    let intervals = 0..x.len().saturating_sub(1);
    let cubics = intervals.map(|i| hermite(x[i + 1] - x[i], [f[i], f[i + 1]], [s[i], s[i + 1]]));
    cubics.collect()
}

/// The straight lines of all intervals.
pub(super) fn lines(x: &[f64], f: &[f64]) -> Vec<Cubic> {
    let intervals = 0..x.len().saturating_sub(1);
    let lines = intervals.map(|i| straight(x[i + 1] - x[i], [f[i], f[i + 1]]));
    lines.collect()
}

#[cfg(test)]
mod tests {
    use super::{Ends, evaluate, interval, limited_slopes, monotone, slope};

    const X: [f64; 6] = [0.0, 1.0, 1.5, 3.0, 4.0, 6.0];
    const F: [f64; 6] = [0.0, 2.0, 2.1, 5.0, 1.0, 0.0];

    #[test]
    fn values_pass_through_the_knots_and_slopes_are_continuous() {
        let cubics = monotone(&X, &F, Ends::Periodic);
        for i in 0..5 {
            let h = X[i + 1] - X[i];
            let next = &cubics[(i + 1) % 5];
            assert!((evaluate(&cubics[i], h) - F[i + 1]).abs() < 1e-14);
            // Round-off of a few terms of order ten.
            assert!((slope(&cubics[i], h) - slope(next, 0.0)).abs() < 1e-13);
        }
    }

    #[test]
    fn an_interval_has_no_extremum_inside() {
        let cubics = monotone(&X, &F, Ends::Flat);
        for (i, cubic) in cubics.iter().enumerate() {
            let (low, high) = (F[i].min(F[i + 1]), F[i].max(F[i + 1]));
            for k in 0..=50 {
                let value = evaluate(cubic, (X[i + 1] - X[i]) * f64::from(k) / 50.0);
                assert!(value >= low - 1e-12 && value <= high + 1e-12);
            }
        }
    }

    /// The weighted harmonic mean by hand: h = 1, 0.5; d = 2, 0.2; w = 2, 2.5.
    #[test]
    fn slopes_are_the_weighted_harmonic_mean() {
        let slopes = limited_slopes(&X, &F, Ends::Flat);
        assert!((slopes[1] - 4.5 / (2.0 / 2.0 + 2.5 / 0.2)).abs() < 1e-14);
        assert_eq!((slopes[0], slopes[3], slopes[5]), (0.0, 0.0, 0.0));
    }

    #[test]
    fn short_lists_and_no_numbers_do_not_panic() {
        assert!(limited_slopes(&[], &[], Ends::Periodic).is_empty());
        assert_eq!(limited_slopes(&[1.0], &[1.0], Ends::Flat), [0.0]);
        assert_eq!(interval(&X, f64::NAN), 0);
        assert_eq!((interval(&X, -1.0), interval(&X, 9.0)), (0, 4));
        assert_eq!((interval(&[], 1.0), interval(&[1.0], 1.0)), (0, 0));
    }
}
