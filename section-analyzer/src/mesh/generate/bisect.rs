//! The place at which a statement about a number changes, by halving.

/// Most halvings: an interval around zero has more than the digits of its ends.
const MOST: usize = 200;

/// The place between two ends at which a statement changes; the statement is `at_a` at the first end.
pub(super) fn bisect([mut a, mut b]: [f64; 2], at_a: bool, is: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..MOST {
        let middle = 0.5 * (a + b);
        if middle == a || middle == b {
            break;
        }
        if is(middle) == at_a {
            a = middle;
        } else {
            b = middle;
        }
    }
    0.5 * (a + b)
}

/// The zero of a function between two places at which its signs differ; `None` if they do not.
pub(super) fn zero([a, b]: [f64; 2], f: impl Fn(f64) -> f64) -> Option<f64> {
    let (at_a, at_b) = (f(a), f(b));
    if at_a == 0.0 || at_b == 0.0 {
        return Some(if at_a == 0.0 { a } else { b });
    }
    let differ = (at_a > 0.0) != (at_b > 0.0) && (at_a - at_b).is_finite();
    differ.then(|| bisect([a, b], at_a > 0.0, |x| f(x) > 0.0))
}
