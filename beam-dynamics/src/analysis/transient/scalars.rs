//! Values of scalar unknowns consistent with a motion, at the start of a run and after a jump.
//!
//! With u the values of the scalars, the residual F of their equations is brought to zero at the
//! motion given by Newton's method, by the rates of the scalars that keep their values and by the
//! values of all others.

use std::sync::Arc;

use crate::assembly::{Pattern, Sparse, System, Tangent};
use crate::model::{Conditions, Name, ScalarStart, State};
use crate::solver::LinearSolver;

/// Correction, relative to the scales of the scalars, at which the iteration ends.
const LAST: f64 = 1e-10;
/// Correction below this that does not shrink any more is round-off.
const FLOOR: f64 = 1e-6;
/// Residual of the equations, in parts of their terms, at which they hold.
const HELD: f64 = 1e-8;
/// Largest number of iterations.
const MOST: usize = 30;

/// Unknowns of the scalars at a given motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Settling {
    /// Values of scalars that settle, at rest; rates of scalars that begin at a given value.
    AtRest,
    /// Values of scalars without a rate, and the rates of the others.
    InMotion,
}

/// Sets the scalars of `state` to their values at the start of a run, before they settle.
pub(super) fn begin(system: &System, state: &mut State) {
    for (value, scalar) in state.scalars.iter_mut().zip(system.scalars()) {
        *value = match scalar.start {
            ScalarStart::Value(value) | ScalarStart::Constant(value) => value,
            ScalarStart::Settled => 0.0,
        };
    }
    state.scalar_rates.fill(0.0);
}

/// Sets the scalars of a state at rest to their values at the start of a run, and those without such a value
/// to be consistent with them; whether there are such values.
pub(in crate::analysis) fn begin_at_rest(
    system: &System,
    state: &mut State,
    conditions: &Conditions,
) -> bool {
    begin(system, state);
    let is_settled = settle(system, state, conditions, Settling::AtRest).is_ok();
    state.scalar_rates.fill(0.0);
    is_settled
}

/// The largest difference of scalars that should agree, relative or absolute.
pub(super) fn apart(found: &[f64], expected: &[f64]) -> f64 {
    let pairs = found.iter().zip(expected);
    let off = pairs.map(|(found, expected)| (found - expected).abs() / expected.abs().max(1.0));
    off.fold(0.0, f64::max)
}

/// Makes the scalars of a state consistent with its motion and its conditions.
///
/// # Errors
///
/// The equation of the largest residual, if no solution is found; the state is then unchanged.
pub(super) fn settle(
    system: &System,
    state: &mut State,
    conditions: &Conditions,
    settling: Settling,
) -> Result<(), Name> {
    if system.scalars().is_empty() {
        return Ok(());
    }
    let before = (state.scalars.clone(), state.scalar_rates.clone());
    state.scalar_rates.fill(0.0);
    if settling == Settling::AtRest {
        system.settle_scalars(state, conditions);
    }
    if find(system, state, conditions, settling).is_some() {
        return Ok(());
    }
    let first = system.numbering().first_scalar();
    let residual = system.residual(state, conditions);
    let scales = system.scalar_equation_scales();
    let worst = scales.largest(&residual.values[first..], |i| residual.sizes[first + i]);
    (state.scalars, state.scalar_rates) = before;
    Err(system.equation(first + worst.scalar))
}

fn find(
    system: &System,
    state: &mut State,
    conditions: &Conditions,
    settling: Settling,
) -> Option<()> {
    let is_rate = system.scalars().iter().map(|scalar| {
        let stays = settling == Settling::InMotion || scalar.start != ScalarStart::Settled;
        scalar.has_rate && stays
    });
    let mut is_rate: Vec<bool> = is_rate.collect();
    let pattern = pattern_of_scalars(system);
    let solver = LinearSolver::new(&pattern);
    let scales = system.scalar_scales(|_| true);
    let of_rates = scales.finer(0.0);
    let mut before = f64::INFINITY;
    for iteration in 0..MOST {
        let tangent = system.tangent(state, conditions);
        let residual = system.residual(state, conditions).values;
        let first = system.numbering().first_scalar();
        if iteration == 0 {
            keep_known_rates(&tangent, system, &mut is_rate);
        }
        let mut change: Vec<_> = residual[first..].iter().map(|value| -value).collect();
        let matrix = matrix_of_scalars(&tangent, &pattern, (first, &is_rate));
        solver.factorize(matrix)?.solve(&mut change)?;
        let mut changes = [vec![0.0; change.len()], vec![0.0; change.len()]];
        for (i, change) in change.into_iter().enumerate() {
            let of = usize::from(is_rate[i]);
            changes[of][i] = change;
            [&mut state.scalars, &mut state.scalar_rates][of][i] += change;
        }
        if settling == Settling::AtRest {
            system.settle_scalars(state, conditions);
        }
        let of_values = scales.largest(&changes[0], |i| state.scalars[i].abs());
        let of_rates = of_rates.largest(&changes[1], |i| state.scalar_rates[i].abs());
        let last = of_values.part.max(of_rates.part);
        if last <= LAST || last <= FLOOR && last >= 0.5 * before {
            return Some(());
        }
        before = last;
        // The first step has the scalars on which the flow at strips depends, as the radius of a tip.
        if iteration == 0 && settling == Settling::AtRest {
            system.begin_scalars(state, conditions);
            system.settle_scalars(state, conditions);
        }
    }
    // Rates that vanish are round-off of the terms of their equations, whatever their last change.
    let residual = system.residual(state, conditions);
    let first = system.numbering().first_scalar();
    let equations = system.scalar_equation_scales();
    let worst = equations.largest(&residual.values[first..], |i| residual.sizes[first + i]);
    (worst.part <= HELD).then_some(())
}

/// Excludes rates that no equation of a scalar contains, rates of scalars whose own equation gives
/// their value without any rate, as the one of the momentum of an added mass, and rates of scalars
/// whose equation would then have no unknown: the values of these scalars follow from the equations,
/// and their rates only from the accelerations.
fn keep_known_rates(tangent: &Tangent, system: &System, is_rate: &mut [bool]) {
    let first = system.numbering().first_scalar();
    let scalars = first..first + is_rate.len();
    let entries = |of: &Sparse| -> Vec<(usize, usize)> {
        let own = of.triplets().filter(|&(row, column, value)| {
            scalars.contains(&row) && scalars.contains(&column) && value != 0.0
        });
        own.map(|(row, column, _)| (row - first, column - first))
            .collect()
    };
    let (by_rates, by_values) = (entries(&tangent.by_rates), entries(&tangent.by_unknowns));
    let mut is_contained = vec![false; is_rate.len()];
    let mut has_rates = vec![false; is_rate.len()];
    for &(row, column) in &by_rates {
        is_contained[column] = true;
        has_rates[row] = true;
    }
    for &(row, column) in &by_values {
        let follows = row == column && !has_rates[row];
        is_rate[row] &= !(follows && system.scalars()[row].start == ScalarStart::Settled);
    }
    for (is_rate, is_contained) in is_rate.iter_mut().zip(is_contained) {
        *is_rate &= is_contained;
    }
    let mut has_unknown = vec![false; is_rate.len()];
    for (entries, wanted) in [(by_rates, true), (by_values, false)] {
        for (row, column) in entries {
            has_unknown[row] |= is_rate[column] == wanted;
        }
    }
    for (is_rate, has_unknown) in is_rate.iter_mut().zip(has_unknown) {
        *is_rate &= has_unknown;
    }
}

/// The block of the scalars in the pattern of the system.
fn pattern_of_scalars(system: &System) -> Arc<Pattern> {
    let first = system.numbering().first_scalar();
    let whole = Sparse::zero(Arc::clone(system.pattern()));
    let own = first..first + system.scalars().len();
    let block = whole
        .triplets()
        .filter(|(i, j, _)| own.contains(i) && own.contains(j));
    let block = block.map(|(i, j, _)| (i - first, j - first)).collect();
    Arc::new(Pattern::new(system.scalars().len(), block))
}

/// Derivatives of the equations of scalars, which begin at `first`, by the rates of the ones for
/// which it `is_rate` and by the values of the others.
fn matrix_of_scalars(
    tangent: &Tangent,
    pattern: &Arc<Pattern>,
    (first, is_rate): (usize, &[bool]),
) -> Sparse {
    let mut matrix = Sparse::zero(Arc::clone(pattern));
    for (from, wanted) in [(&tangent.by_unknowns, false), (&tangent.by_rates, true)] {
        let scalars = first..first + is_rate.len();
        let own = from.triplets();
        let own = own.filter(|(i, j, _)| scalars.contains(i) && scalars.contains(j));
        for (i, j, value) in own.filter(|&(_, j, _)| is_rate[j - first] == wanted) {
            if let Some(index) = pattern.index(i - first, j - first) {
                matrix.values_mut()[index] += value;
            }
        }
    }
    matrix
}
