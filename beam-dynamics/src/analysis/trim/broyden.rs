//! Numbers for which residuals vanish, when each evaluation is expensive and without derivatives.
//!
//! The derivative J is found by differences once, and follows the changes of the residual r:
//!
//! ```text
//! dx = -J^-1 r ,     J <- J + ( r(x + dx) - r(x) - J dx ) dx^T / dx^2              (D-323)
//! ```
//!
//! with x and r in their sizes. A step that fails, or after which r is not smaller, is halved; if no part of
//! it helps, J is found by differences again, and if the next step does not help either, no numbers nearby
//! have smaller residuals. Numbers do not change by more than their own size, or a number of sizes, in an
//! iteration.

use nalgebra::{DMatrix, DVector};

/// Difference for the derivative, in sizes.
const DIFFERENCE: f64 = 1e-3;
/// Largest number of halvings of a step.
const HALVINGS: i32 = 4;
/// Least decrease of the residual in a step, relative to it.
const DECREASE: f64 = 1e-2;
/// Largest change in an iteration, in sizes, of a number that is smaller than this.
const REACH: f64 = 100.0;

/// Residuals of numbers, in the sizes of their targets.
type Errors<'a, E> = dyn FnMut(&[f64]) -> Result<Vec<f64>, E> + 'a;

/// Numbers with their residuals.
type Found = (Vec<f64>, DVector<f64>);

/// Limits of a number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Range {
    /// Size.
    pub scale: f64,
    /// Least and largest value.
    pub bounds: [f64; 2],
    /// Largest change in an iteration.
    pub step: f64,
}

/// End of the iteration.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Stop<E> {
    /// The residuals vanish.
    Met,
    /// A number is at a bound beyond which the solution is.
    Bound(usize, f64),
    /// The residuals do not determine the numbers: their derivative.
    Singular(DMatrix<f64>),
    /// No numbers nearby have smaller residuals.
    Nearest,
    /// Too many iterations.
    Iterations,
    /// The first evaluations failed.
    Failed(E),
    /// An evaluation failed beyond the numbers.
    Beyond(E),
}

/// Finds `x` near the given one, within its ranges; returns the end and the number of iterations. At an end
/// without a solution `x` has the smallest residuals that were found.
pub(super) fn solve<E>(
    evaluate: &mut Errors<'_, E>,
    x: &mut [f64],
    ranges: &[Range],
    (tolerance, most): (f64, usize),
) -> (Stop<E>, usize) {
    let mut iterations = 0;
    let found = iterate(evaluate, x, ranges, (tolerance, most, &mut iterations));
    let stop = match found {
        Ok(stop) => stop,
        Err(failure) if iterations == 0 => Stop::Failed(failure),
        Err(failure) => Stop::Beyond(failure),
    };
    // The last evaluation is the one of the numbers that are returned.
    let is_last = matches!(stop, Stop::Met | Stop::Failed(_));
    let stop = match is_last {
        true => stop,
        false => evaluate(x).map_or_else(Stop::Failed, |_| stop),
    };
    (stop, iterations)
}

fn iterate<E>(
    evaluate: &mut Errors<'_, E>,
    x: &mut [f64],
    ranges: &[Range],
    (tolerance, most, iterations): (f64, usize, &mut usize),
) -> Result<Stop<E>, E> {
    let mut r = DVector::from_vec(evaluate(x)?);
    if r.amax() <= tolerance {
        return Ok(Stop::Met);
    }
    let mut j = derivative(evaluate, (x, &r), ranges)?;
    let mut is_new = true;
    let mut blocked = None;
    while *iterations < most {
        *iterations += 1;
        let Some(dx) = j
            .clone()
            .lu()
            .solve(&-&r)
            .filter(|dx| dx.iter().all(|d| d.is_finite()))
        else {
            return Ok(Stop::Singular(j));
        };
        let (next, at) = limited(x, &dx, ranges);
        if let (Some(index), Some(before)) = (at, blocked)
            && index == before
        {
            return Ok(Stop::Bound(index, x[index]));
        }
        blocked = at;
        if let Some((next, later)) = shortened(evaluate, (x, &r), next, (&mut j, ranges))? {
            x.copy_from_slice(&next);
            r = later;
            is_new = false;
        } else if is_new {
            return Ok(at.map_or(Stop::Nearest, |index| Stop::Bound(index, x[index])));
        } else {
            j = derivative(evaluate, (x, &r), ranges)?;
            (is_new, blocked) = (true, None);
        }
        if r.amax() <= tolerance {
            return Ok(Stop::Met);
        }
    }
    Ok(Stop::Iterations)
}

/// The next numbers, and the first one that is at a bound and would leave it.
fn limited(x: &[f64], dx: &DVector<f64>, ranges: &[Range]) -> (Vec<f64>, Option<usize>) {
    let all = || x.iter().zip(dx.iter()).zip(ranges);
    let parts = all().map(|((x, dx), range)| {
        let reach = x.abs().max(REACH * range.scale);
        range.step.min(reach) / (dx * range.scale).abs()
    });
    let part = parts.fold(1.0, f64::min);
    let mut at = None;
    let next = all().enumerate().map(|(index, ((x, dx), range))| {
        let wanted = x + part * dx * range.scale;
        let next = wanted.clamp(range.bounds[0], range.bounds[1]);
        if next != wanted && next == *x {
            at = at.or(Some(index));
        }
        next
    });
    let next = next.collect();
    (next, at)
}

/// The step to `next`, halved until its residual is smaller, with this residual, and the derivative after
/// all that was tried; `None` if no part of the step has a smaller residual.
fn shortened<E>(
    evaluate: &mut Errors<'_, E>,
    (x, r): (&[f64], &DVector<f64>),
    mut next: Vec<f64>,
    (j, ranges): (&mut DMatrix<f64>, &[Range]),
) -> Result<Option<Found>, E> {
    for halvings in 0..=HALVINGS {
        match evaluate(&next).map(DVector::from_vec) {
            Ok(later) => {
                let moved = x.iter().zip(&next).zip(ranges);
                let moved = moved.map(|((x, next), range)| (next - x) / range.scale);
                let moved = DVector::from_iterator(x.len(), moved);
                let square = moved.norm_squared();
                if square == 0.0 {
                    return Ok(None);
                }
                let rest = &later - r - &*j * &moved;
                *j += rest * moved.transpose() / square;
                let part = 0.5_f64.powi(halvings);
                if later.norm() <= (1.0 - DECREASE * part) * r.norm() {
                    return Ok(Some((next, later)));
                }
            }
            Err(failure) if halvings == HALVINGS => return Err(failure),
            Err(_) => (),
        }
        let halves = next.iter().zip(x);
        next = halves.map(|(next, x)| 0.5 * (next + x)).collect();
    }
    Ok(None)
}

fn derivative<E>(
    evaluate: &mut Errors<'_, E>,
    (x, r): (&[f64], &DVector<f64>),
    ranges: &[Range],
) -> Result<DMatrix<f64>, E> {
    let mut j = DMatrix::zeros(r.len(), x.len());
    for (column, range) in ranges.iter().enumerate() {
        let mut moved = x.to_vec();
        let side = if x[column] + DIFFERENCE * range.scale <= range.bounds[1] {
            1.0
        } else {
            -1.0
        };
        moved[column] += side * DIFFERENCE * range.scale;
        let change = DVector::from_vec(evaluate(&moved)?) - r;
        j.set_column(column, &(change / (side * DIFFERENCE)));
    }
    Ok(j)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FREE: Range = Range {
        scale: 1.0,
        bounds: [f64::NEG_INFINITY, f64::INFINITY],
        step: f64::INFINITY,
    };

    // x^2 + y = 3 and x - y^3 = 0: the residuals vanish to the tolerance, from 200 starts.
    #[test]
    fn two_equations_from_many_starts() {
        for start in 0..200 {
            let mut x = [
                1.0 + f64::from(start % 20) * 0.05,
                0.8 + f64::from(start / 20) * 0.06,
            ];
            let mut of = |x: &[f64]| {
                let found = vec![x[0] * x[0] + x[1] - 3.0, x[0] - x[1].powi(3)];
                Ok::<_, ()>(found)
            };
            let (stop, iterations) = solve(&mut of, &mut x, &[FREE; 2], (1e-10, 40));
            assert_eq!(stop, Stop::Met, "{start}");
            assert!(iterations < 20, "{start}: {iterations}");
            assert!((x[0] - x[1].powi(3)).abs() < 1e-9);
        }
    }

    // A force with a largest value below the required one, from 100 starts: the number stays where the force
    // is largest, and does not run away. The derivative by differences of 1e-3 is off by 5e-4 of the
    // curvature, and steps of less than a part of 1e-2 in the residual are not made.
    #[test]
    fn the_nearest_number() {
        for start in 0..100 {
            let mut x = [f64::from(start) * 0.015];
            let mut of = |x: &[f64]| Ok::<_, ()>(vec![(2.0 * x[0] * (-x[0]).exp()) - 1.0]);
            let (stop, _) = solve(&mut of, &mut x, &[FREE], (1e-9, 60));
            assert_eq!(stop, Stop::Nearest, "{start}");
            assert!((x[0] - 1.0).abs() < 0.3, "{start}: {x:?}");
        }
    }

    // A root beyond the bound, equations without a root, nearby or far away, and one without the unknown.
    #[test]
    fn ends_without_a_solution() {
        let bounds = [0.0, 1.5];
        let range = Range { bounds, ..FREE };
        let mut x = [1.0];
        let mut of = |x: &[f64]| Ok::<_, ()>(vec![x[0] - 2.0]);
        let (stop, _) = solve(&mut of, &mut x, &[range], (1e-9, 40));
        assert_eq!(stop, Stop::Bound(0, 1.5));
        let mut of = |x: &[f64]| Ok::<_, ()>(vec![1.0 + x[0] * x[0]]);
        let mut x = [1.0];
        let (stop, _) = solve(&mut of, &mut x, &[FREE], (1e-9, 10));
        assert_eq!(stop, Stop::Nearest);
        assert!(x[0].abs() < 0.1, "{x:?}");
        let mut of = |x: &[f64]| Ok::<_, ()>(vec![1.0 / (1.0 + x[0] * x[0]).sqrt()]);
        let (stop, _) = solve(&mut of, &mut [1.0], &[FREE], (1e-12, 10));
        assert_eq!(stop, Stop::Iterations);
        let mut of = |_: &[f64]| Ok::<_, ()>(vec![1.0]);
        let (stop, _) = solve(&mut of, &mut [1.0], &[FREE], (1e-9, 10));
        assert!(matches!(stop, Stop::Singular(_)));
        let mut of = |x: &[f64]| {
            if x[0] > 1.0 {
                Err(7)
            } else {
                Ok(vec![x[0] - 2.0])
            }
        };
        let (stop, _) = solve(&mut of, &mut [0.5], &[FREE], (1e-9, 10));
        assert_eq!(stop, Stop::Beyond(7));
        let mut of = |_: &[f64]| Err(7);
        let (stop, _) = solve(&mut of, &mut [0.5], &[FREE], (1e-9, 10));
        assert_eq!(stop, Stop::Failed(7));
    }
}
