//! The root of a function of one number between two of its values of opposite sign.
//!
//! ```text
//! x = b - f(b) (b - a) / (f(b) - f(a))                                              (D-331)
//! ```
//!
//! where the value of an end that is kept twice is halved. If the function is nearly zero at one of
//! the ends, as before a square root, the interval is halved instead.
//!
//! References: [DowellJarratt1971].

/// Largest number of values.
const MOST: usize = 200;
/// Times an end may be kept before the interval is halved.
const KEPT: usize = 4;
/// Part of the value at the other end below which a function is nearly zero.
const FLAT: f64 = 1e-4;
/// Step beyond an argument that may be the root, as a part of the tolerance.
const PROBE: f64 = 0.1;

/// A root of `f` between the `ends`, each an argument with its value, of opposite signs: the last
/// argument at which `f` was evaluated, when the root is known to be nearer than `tolerance`.
///
/// Where two arguments are that near, the next one is a little beyond: a function that is nearly zero
/// on one side of the root moves the secant as little.
///
/// # Errors
/// The error of `f`.
pub fn root<E>(
    f: &mut dyn FnMut(f64) -> Result<f64, E>,
    ends: [[f64; 2]; 2],
    tolerance: f64,
) -> Result<f64, E> {
    let [mut a, mut b] = ends;
    let (mut last, mut kept, mut sign) = (f64::INFINITY, 0, 0.0);
    let sizes = [a[1].abs(), b[1].abs()];
    let mut is_flat = sizes[0].min(sizes[1]) < FLAT * sizes[0].max(sizes[1]);
    let (mut is_halved, mut is_probe) = (is_flat, false);
    for _ in 0..MOST {
        let secant = b[0] - b[1] * (b[0] - a[0]) / (b[1] - a[1]);
        let (low, high) = (a[0].min(b[0]), a[0].max(b[0]));
        let is_inside = secant > low && secant < high;
        let x = if is_probe {
            // Toward the end of the other sign.
            let other = if last == a[0] { b[0] } else { a[0] };
            last + (PROBE * tolerance)
                .min(0.5 * (high - low))
                .copysign(other - last)
        } else if is_inside && !is_halved {
            secant
        } else {
            0.5 * (low + high)
        };
        let value = f(x)?;
        let passed = is_probe && value.signum() != sign;
        if value == 0.0 || passed || high - low <= tolerance {
            return Ok(x);
        }
        let was_probe = is_probe;
        is_probe = !is_halved && !is_probe && (x - last).abs() <= tolerance;
        last = x;
        kept = if value.signum() == sign { kept + 1 } else { 0 };
        sign = value.signum();
        // The secant stays at a side where the function is nearly zero.
        is_flat |= was_probe;
        is_halved = is_flat || kept >= KEPT;
        // The end of the other sign is kept.
        let (changed, other) = if value.signum() == a[1].signum() {
            (&mut a, &mut b)
        } else {
            (&mut b, &mut a)
        };
        *changed = [x, value];
        if kept > 0 {
            other[1] *= 0.5;
        }
    }
    Ok(last)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The root found, and the number of values.
    fn solved(f: impl Fn(f64) -> f64, [a, b]: [f64; 2], tolerance: f64) -> (f64, usize) {
        let mut count = 0;
        let ends = [[a, f(a)], [b, f(b)]];
        let mut counted = |x: f64| {
            count += 1;
            Ok::<_, ()>(f(x))
        };
        let x = root(&mut counted, ends, tolerance).unwrap();
        (x, count)
    }

    // Closed forms; superlinear on smooth functions, 14 values for 1e-10 of the interval.
    #[test]
    fn roots_of_smooth_functions() {
        type Case = (fn(f64) -> f64, [f64; 2], f64);
        let cases: [Case; 4] = [
            (|x| x * x - 2.0, [0.0, 2.0], 2.0_f64.sqrt()),
            (|x| x.exp() - 3.0, [0.0, 3.0], 3.0_f64.ln()),
            (|x| 1.0 - x, [0.0, 4.0], 1.0),
            (|x| (x - 0.3).tanh() * 5.0, [-4.0, 9.0], 0.3),
        ];
        for (f, ends, expected) in cases {
            let (x, count) = solved(f, ends, 1e-10 * (ends[1] - ends[0]));
            assert!((x - expected).abs() < 1e-9, "{x} {expected}");
            assert!(count <= 25, "{count}");
        }
    }

    // Half of a root: constant, and nearly zero, before the boundary.
    #[test]
    fn a_square_root_beside_a_constant() {
        for kink in [0.137, 0.5, 0.9001] {
            let f = |x: f64| (x - kink).max(0.0).sqrt() - 1e-9;
            let (x, count) = solved(f, [0.0, 1.0], 1e-8);
            assert!((x - kink).abs() < 3e-8, "{x} {kink}");
            assert!(count < 30, "{count}");
        }
    }

    // As before the end of a tongue of parametric resonance: constant, and far below the values beyond
    // it, but not as nearly zero as round-off.
    #[test]
    fn a_small_constant_is_not_taken_for_a_root() {
        for (place, constant) in [(0.137, 3e-6), (0.5, 1e-5), (0.9001, 1e-4)] {
            let f = |x: f64| (x - place).max(0.0).sqrt() - constant;
            let (x, count) = solved(f, [0.0, 1.0], 1e-8);
            let exact = place + constant * constant;
            assert!((x - exact).abs() < 2e-8, "{x} {exact}");
            assert!(count < 100, "{count}");
        }
    }

    #[test]
    fn an_error_is_passed_on() {
        let mut f = |x: f64| if x > 0.5 { Err("no") } else { Ok(x - 0.6) };
        assert_eq!(root(&mut f, [[0.0, -0.6], [1.0, 0.4]], 1e-9), Err("no"));
    }
}
