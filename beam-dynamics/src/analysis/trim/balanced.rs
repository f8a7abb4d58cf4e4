//! The trim of an equilibrium: the equations of the controls are the ones of the targets (D-321), so
//! that the equilibrium of the first guesses leads to the trim as any change of the conditions does.

use nalgebra::DMatrix;

use super::TrimEnd;
use crate::analysis::balance::Balance;
use crate::analysis::effects;
use crate::analysis::stall::StallSum;
use crate::analysis::steady::{Equilibrium, NoEquilibrium, equilibrium};
use crate::analysis::transient::begin_at_rest;
use crate::case::{Model, TrimSettings, TrimTarget};
use crate::input::{Input, short_number};
use crate::model::{Conditions, State};
use crate::result::Stall;
use crate::solver::{LinearSolver, Newton, NewtonStatus, solve};

/// Part of its sensitivity to relative changes of the equations up to which a change is round-off \[-\].
const ROUND_OFF: f64 = 1e-11;

/// Reason why an equilibrium is not trimmed.
#[derive(Debug, thiserror::Error)]
pub(super) enum NotBalanced {
    /// No equilibrium of the first guesses.
    #[error("the first guesses: {0}")]
    Guess(Box<NoEquilibrium>),
    /// The equilibrium does not reach the targets.
    #[error("the targets are not reached: {reached}; beyond it {failure}")]
    Targets {
        /// The farthest target of the last equilibrium on the way, and the controls there, as text.
        reached: String,
        /// The failure beyond it.
        failure: Box<NoEquilibrium>,
    },
    /// The controls do not determine the targets.
    #[error("{0}")]
    Idle(String),
    /// A control is beyond a bound.
    #[error(
        "the control \"{control}\" is {value} where the targets are met, beyond its bound {bound}"
    )]
    Bound {
        control: String,
        value: f64,
        bound: f64,
    },
}

impl NotBalanced {
    /// The likeliest remedy.
    pub fn remedy(&self) -> &'static str {
        match self {
            Self::Guess(_) => "give first guesses at which the model has an equilibrium",
            Self::Targets { .. } => {
                "give first guesses nearer to the trim, or targets that the model can reach"
            }
            Self::Idle(_) => "replace a control, or a target",
            Self::Bound { .. } => {
                "move the bound, require another value of the target, or replace the control"
            }
        }
    }
}

/// Why controls of blades have no effect, as text, if the model does not turn.
pub(super) fn at_rest(model: &Model, settings: &TrimSettings) -> Option<&'static str> {
    let is_still = settings.speed == 0.0 && !model.blades.is_empty();
    is_still.then_some("; the blades do not turn, because \"speed\" of [trim] is 0")
}

/// The index of the scalar of an element among all scalars.
pub(super) fn scalar(model: &Model, label: &str) -> Option<usize> {
    let mut scalars = model.system.scalars().iter();
    scalars.position(|scalar| scalar.owner == label)
}

/// Values of the scalars of elements at a state; NaN for others.
pub(super) fn values<'a>(
    model: &Model,
    state: &State,
    labels: impl Iterator<Item = &'a String>,
) -> Vec<f64> {
    let value = |label| scalar(model, label).map_or(f64::NAN, |index| state.scalars[index]);
    labels.map(|label| value(label)).collect()
}

/// The conditions of small motions about the equilibrium of a trimmed file, at the speed \[rad/s\] of its own
/// reading: controls are constant in them. `None` if the file has no trim.
pub(in crate::analysis) fn small_motions(input: &Input) -> Option<(Conditions, f64)> {
    let settings = input.trim.as_ref()?;
    let mut conditions = conditions(&input.model, settings);
    conditions.loading.start();
    Some((conditions, settings.speed))
}

/// The conditions of a trim.
pub(super) fn conditions(model: &Model, settings: &TrimSettings) -> Conditions {
    model.conditions(settings.speed, 1.0, 1.0)
}

/// Stall of the blades in the equilibrium of a trim, if its model turns.
pub(super) fn stall(end: &TrimEnd) -> Option<Stall> {
    let (settings, state) = (end.input.trim.as_ref()?, end.state.as_ref()?);
    if settings.speed == 0.0 {
        return None;
    }
    let model = &end.input.model;
    let mut sum = StallSum::new(&model.system);
    sum.add(state, &conditions(model, settings));
    sum.found()
}

/// The trimmed equilibrium, from the trimmed state of a similar model if one is given.
pub(super) fn balanced(
    model: &Model,
    settings: &TrimSettings,
    from: Option<&State>,
) -> Result<Equilibrium, NotBalanced> {
    let solver = LinearSolver::new(model.system.pattern());
    let full = conditions(model, settings);
    let near = from.map(|state| equilibrium(model, &solver, (&full, state), &full));
    match near {
        Some(Ok(found)) => Ok(found),
        _ => from_guesses(model, settings, (&solver, &full)),
    }
}

/// The first control whose value is beyond a bound.
pub(super) fn beyond_bound(settings: &TrimSettings, values: &[f64]) -> Option<NotBalanced> {
    let mut pairs = settings.controls.iter().zip(values);
    pairs.find_map(|(control, value)| {
        let bound = value.clamp(control.bounds[0], control.bounds[1]);
        (*value != bound).then(|| NotBalanced::Bound {
            control: control.name.clone(),
            value: *value,
            bound,
        })
    })
}

fn from_guesses(
    model: &Model,
    settings: &TrimSettings,
    (solver, full): (&LinearSolver, &Conditions),
) -> Result<Equilibrium, NotBalanced> {
    let mut guesses = *full;
    guesses.loading.start();
    let determined = |found: Equilibrium| {
        let balance = Balance::new(&model.system, solver, guesses, found.state.clone());
        match undetermined(model, settings, &balance) {
            Some(reason) => Err(NotBalanced::Idle(reason)),
            None => Ok(found),
        }
    };
    if let Some(found) = at_once(model, solver, (&guesses, full)) {
        return determined(found);
    }
    let rest = model.system.rest();
    let first = equilibrium(model, solver, (&Conditions::at_rest(), &rest), &guesses);
    let first = first.map_err(NotBalanced::Guess)?;
    let found = equilibrium(model, solver, (&guesses, &first.state), full);
    let iterations = first.iterations;
    match found {
        Ok(found) => determined(Equilibrium {
            iterations: iterations + found.iterations,
            ..found
        }),
        Err(failure) => {
            let balance = Balance::new(&model.system, solver, guesses, first.state);
            let idle = response(model, settings, &balance).and_then(|response| {
                effects::idle(
                    (&response, effects::EXACT),
                    &settings.controls,
                    &settings.targets,
                )
            });
            let still = at_rest(model, settings).unwrap_or_default();
            let idle = idle.map(|reason| NotBalanced::Idle(reason + still));
            Err(idle.unwrap_or_else(|| NotBalanced::Targets {
                reached: farthest(model, settings, &failure.last),
                failure,
            }))
        }
    }
}

/// The target that is farthest from its value in an equilibrium, and the controls, as text.
fn farthest(model: &Model, settings: &TrimSettings, state: &State) -> String {
    let labels = settings.targets.iter().map(|target| &target.label);
    let values = values(model, state, labels);
    let off =
        |(target, value): &(&TrimTarget, &f64)| ((*value - target.value) / target.scale).abs();
    let pairs = settings.targets.iter().zip(&values);
    let farthest = pairs.max_by(|a, b| off(a).total_cmp(&off(b)));
    let target = farthest.map_or_else(String::new, |(target, value)| {
        let [value, wanted] = [*value, target.value].map(|value| short_number(value, 4));
        format!(
            "\"{}\" is farthest, {value} in place of {wanted}",
            target.name
        )
    });
    let labels = settings.controls.iter().map(|control| &control.label);
    let controls = settings
        .controls
        .iter()
        .zip(self::values(model, state, labels));
    let controls =
        controls.map(|(own, value)| format!("{} = {}", own.name, short_number(value, 6)));
    format!("{target}, with {}", controls.collect::<Vec<_>>().join(", "))
}

/// Why the controls of an equilibrium with its targets do not determine them, in whatever units both are:
/// targets that depend on each other are met by any of many controls.
fn undetermined(model: &Model, settings: &TrimSettings, balance: &Balance<'_>) -> Option<String> {
    let response = response(model, settings, balance)?;
    let (controls, targets) = (&settings.controls, &settings.targets);
    effects::idle((&response, effects::EXACT), controls, targets)
}

/// The trim of a model in a frame at rest, from the undeformed model with first guesses of the controls and
/// states as at the start of a run. `None` if Newton's method does not converge from there: the loads are
/// then raised first.
fn at_once(
    model: &Model,
    solver: &LinearSolver,
    (guesses, full): (&Conditions, &Conditions),
) -> Option<Equilibrium> {
    if full.frame.angular_velocity.norm() > 0.0 {
        return None;
    }
    let mut start = model.system.rest();
    if !begin_at_rest(&model.system, &mut start, guesses) {
        return None;
    }
    let mut balance = Balance::new(&model.system, solver, *full, start);
    let report = solve(&mut balance, &Newton::default());
    (report.status == NewtonStatus::Converged).then_some(Equilibrium {
        state: balance.state,
        conditions: *full,
        iterations: report.history.len(),
        residual: report.worst.relative,
    })
}

/// The change of the targets (rows, of size one) by each control of size one about the equilibrium of
/// the first guesses, without round-off: changes that are zero but for it are zero.
fn response(model: &Model, settings: &TrimSettings, balance: &Balance<'_>) -> Option<DMatrix<f64>> {
    let factors = balance.factorize()?;
    let first = model.system.numbering().first_scalar();
    let count = settings.controls.len();
    let mut response = DMatrix::zeros(count, count);
    for (column, control) in settings.controls.iter().enumerate() {
        // The equation of a control is (u - u_0)/s there.
        let mut change = vec![0.0; model.system.numbering().unknowns()];
        change[first + scalar(model, &control.label)?] = 1.0;
        factors.solve(&mut change)?;
        let sensitivity = balance.sensitivity(&factors, &change)?;
        for (row, target) in settings.targets.iter().take(count).enumerate() {
            let index = first + scalar(model, &target.label)?;
            let own = change[index] / target.scale;
            if change[index].abs() > ROUND_OFF * sensitivity[index] {
                response[(row, column)] = own;
            }
        }
    }
    Some(response)
}
