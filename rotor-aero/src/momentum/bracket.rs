//! A root of a function of one variable in a bracket: Brent's method (Brent 1973, chapter 4).

/// Root of `function` between `low` and `high`, at which its values have opposite signs.
///
/// The values at the ends are arguments, since the caller knows them from its search. The result
/// is none if they do not have opposite signs, or if a value is not a number. At a pole the sign
/// changes too: the caller checks the value at the root.
///
/// # Examples
///
/// ```
/// use rotor_aero::momentum::bracketed_root;
///
/// let square = |x: f64| x * x - 2.0;
/// let root = bracketed_root(square, (0.0, -2.0), (2.0, 2.0), 1e-14);
/// assert!((root.unwrap_or_default() - 2f64.sqrt()).abs() < 1e-13);
/// ```
pub fn root(
    mut function: impl FnMut(f64) -> f64,
    low: (f64, f64),
    high: (f64, f64),
    tolerance: f64,
) -> Option<f64> {
    if !opposite(low.1, high.1) {
        return None;
    }
    let mut state = State::of(low, high);
    for _ in 0..200 {
        let half = 0.5 * (state.contra.0 - state.best.0);
        let limit = 2.0 * f64::EPSILON * state.best.0.abs() + 0.5 * tolerance;
        if half.abs() <= limit || state.best.1 == 0.0 {
            return Some(state.best.0);
        }
        let step = state.step(half, limit);
        let next = state.best.0 + step;
        let value = function(next);
        if value.is_nan() {
            return None;
        }
        state.accept((next, value));
    }
    Some(state.best.0)
}

/// Intervals of the first search of a state of a ring, in a quarter of a turn. One number for all forms of the
/// balance, so that among several states in stall a turbine and its image in the mirror have the same one.
pub(crate) const FIRST: usize = 40;

/// The first root that is accepted, searched in each bracket from its start, by a number of equal
/// intervals; by the next number if none is found. `accepted` gives the result of a root, none for a
/// pole.
pub(crate) fn first_root<T>(
    function: impl Fn(f64) -> f64,
    brackets: &[(f64, f64)],
    intervals: &[usize],
    accepted: impl Fn(f64) -> Option<T>,
) -> Option<T> {
    for &count in intervals {
        for &(start, end) in brackets {
            let mut last = (start, function(start));
            for interval in 1..=count {
                let x = start + (end - start) * interval as f64 / count as f64;
                let next = (x, function(x));
                if opposite(last.1, next.1)
                    && let Some(found) = root(&function, last, next, 1e-14)
                    && let Some(result) = accepted(found)
                {
                    return Some(result);
                }
                last = next;
            }
        }
    }
    None
}

/// Whether two values have opposite signs, or one is zero.
pub(crate) fn opposite(one: f64, other: f64) -> bool {
    (one <= 0.0 && other >= 0.0) || (one >= 0.0 && other <= 0.0)
}

/// Points of the method, as (argument, value).
struct State {
    /// The best point.
    best: (f64, f64),
    /// The best point of the step before.
    previous: (f64, f64),
    /// The point on the other side of the root.
    contra: (f64, f64),
    /// The present step, and the step before.
    steps: (f64, f64),
}

impl State {
    fn of(low: (f64, f64), high: (f64, f64)) -> Self {
        let mut state = Self {
            best: high,
            previous: low,
            contra: low,
            steps: (high.0 - low.0, high.0 - low.0),
        };
        state.order();
        state
    }

    /// The smaller value is the best point.
    fn order(&mut self) {
        if self.contra.1.abs() < self.best.1.abs() {
            self.previous = self.best;
            self.best = self.contra;
            self.contra = self.previous;
        }
    }

    /// The next step: interpolation if it is safe, else half of the bracket.
    fn step(&mut self, half: f64, limit: f64) -> f64 {
        let useful = self.steps.1.abs() >= limit && self.previous.1.abs() > self.best.1.abs();
        let interpolated = if useful {
            self.interpolated(half)
        } else {
            None
        };
        let bound = (3.0 * half.abs() - limit).min(self.steps.1.abs());
        self.steps = match interpolated {
            Some(step) if step * half > 0.0 && 2.0 * step.abs() < bound.max(0.0) => {
                (step, self.steps.0)
            }
            _ => (half, half),
        };
        if self.steps.0.abs() > limit {
            self.steps.0
        } else {
            limit.copysign(half)
        }
    }

    /// Inverse quadratic interpolation, or the secant if there are two points only.
    fn interpolated(&self, half: f64) -> Option<f64> {
        let ratio = self.best.1 / self.previous.1;
        let (p, q) = if self.previous.0 == self.contra.0 {
            (2.0 * half * ratio, 1.0 - ratio)
        } else {
            let q = self.previous.1 / self.contra.1;
            let r = self.best.1 / self.contra.1;
            let difference = self.best.0 - self.previous.0;
            (
                ratio * (2.0 * half * q * (q - r) - difference * (r - 1.0)),
                (q - 1.0) * (r - 1.0) * (ratio - 1.0),
            )
        };
        let step = -p / q;
        step.is_finite().then_some(step)
    }

    fn accept(&mut self, next: (f64, f64)) {
        self.previous = self.best;
        self.best = next;
        if (self.best.1 > 0.0) == (self.contra.1 > 0.0) {
            self.contra = self.previous;
            let step = self.best.0 - self.previous.0;
            self.steps = (step, step);
        }
        self.order();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn root_of(function: fn(f64) -> f64, low: f64, high: f64) -> Option<(f64, usize)> {
        let mut calls = 0;
        let ends = ((low, function(low)), (high, function(high)));
        let count = |x: f64| {
            calls += 1;
            function(x)
        };
        root(count, ends.0, ends.1, 1e-13).map(|root| (root, calls))
    }

    #[test]
    fn roots_of_smooth_and_flat_functions_in_few_steps() {
        type Case = (fn(f64) -> f64, f64, f64, f64);
        let cases: [Case; 5] = [
            (|x| x * x - 2.0, 0.0, 2.0, 2f64.sqrt()),
            (|x| x.cos() - x, 0.0, 1.0, 0.739_085_133_215_160_6),
            (|x| (x - 0.3).powi(3), -1.0, 1.0, 0.3),
            (|x| (1.0 - x).exp() - 1.0, -5.0, 9.0, 1.0),
            (|x| 1.0 - x, 3.0, -2.0, 1.0),
        ];
        for (function, low, high, expected) in cases {
            let (found, calls) = root_of(function, low, high).expect("opposite signs");
            // the triple root is flat: a value of 1e-40 has an argument of 1e-13
            assert!((found - expected).abs() < 1e-12, "{found} {expected}");
            assert!(calls < 150, "{calls} calls");
        }
        assert!(root_of(|x| x.cos() - x, 0.0, 1.0).expect("a root").1 < 10);
    }

    #[test]
    fn no_bracket_no_root() {
        assert_eq!(root_of(|x| x * x + 1.0, -1.0, 1.0), None);
        assert_eq!(root_of(|_| f64::NAN, -1.0, 1.0), None);
        assert_eq!(
            root_of(|x| if x == 1.0 { 1.0 } else { f64::NAN }, -1.0, 1.0),
            None
        );
        let inside = |x: f64| if x.abs() < 0.9 { f64::NAN } else { x };
        assert_eq!(root_of(inside, -1.0, 1.0), None);
    }
}
