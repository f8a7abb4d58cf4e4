//! Statics: equilibrium under rotation and constant loads, then along the path of the
//! proportional loads.
//!
//! # Example
//!
//! ```
//! use beam_dynamics::analysis::statics::statics;
//! use beam_dynamics::input;
//!
//! // a clamped strip of 2 m under a small force at its tip
//!
//! let text = r#"
//! units = "SI"
//! [properties.strip]
//! ea = 2.8e7
//! gay = 9e6
//! gaz = 9e6
//! gj = 300
//! eiy = 240
//! eiz = 3700
//! m = 1.08
//! iy = 1e-6
//! iz = 1e-6
//! [[blade]]
//! name = "blade"
//! properties = "strip"
//! [[blade.piece]]
//! length = 2
//! elements = 8
//! [[load]]
//! node = "blade/tip"
//! force = [0, 0, 0.3]
//! [static]
//! "#;
//! let input = input::parse(text, "strip.dynamics.toml").expect("a sound file");
//! let settings = input.statics.as_ref().expect("a card [static]");
//!
//! let outcome = statics(&input.model, settings);
//! assert!(outcome.failure.is_none());
//! let last = outcome.result.steps.last().expect("an equilibrium");
//! let tip = last.positions.last().expect("a node");
//! // F L^3 / 3 EI
//! assert!((tip.z / (0.3 * 8.0 / (3.0 * 240.0)) - 1.0).abs() < 1e-4);
//! ```

use crate::case::{Model, StaticSettings};
use crate::model::{Conditions, State};
use crate::result::{StaticResult, StaticStep};
use crate::solver::LinearSolver;

use super::balance::Balance;
use super::critical::critical_part;
use super::deformation::deformation;
use super::first_order::first_order;
use super::operation::Operation;
use super::path::{Point, Walker};
use super::steady::{Equilibrium, NoEquilibrium, equilibrium};

pub use super::path::PathEnd;

/// Reason for a static analysis that ends before the end of the path.
#[derive(Debug, Clone, thiserror::Error)]
pub enum StaticFailure {
    /// No equilibrium under rotation and constant loads.
    #[error("load factor 0: {0}")]
    Base(#[from] Box<NoEquilibrium>),
    /// The path ends.
    #[error(transparent)]
    Path(#[from] PathEnd),
}

impl StaticFailure {
    /// The remedy.
    pub fn remedy(&self) -> &'static str {
        match self {
            Self::Path(PathEnd::LimitPoint { .. }) => {
                "set arc_length = true in [static] to go past the limit point"
            }
            Self::Path(PathEnd::OutOfSteps { .. }) => {
                "raise \"most_steps\" in [static], or lower \"to\""
            }
            Self::Path(PathEnd::WithoutValue { .. }) => {
                "use more elements where the beam bends, or look for the load that is too large"
            }
            Self::Path(PathEnd::Stuck { .. }) => {
                "look at the last equilibrium, and at the size of the loads beside the stiffness; smaller \"steps\" or arc_length = true may help"
            }
            Self::Base(_) | Self::Path(PathEnd::Free { .. }) => {
                "constrain the free motion, or remove the load that nothing carries"
            }
        }
    }
}

/// Equilibria reached, and the reason if it ended early.
#[derive(Debug)]
pub struct StaticOutcome {
    /// Equilibria reached.
    pub result: StaticResult,
    /// Reason why there are no more.
    pub failure: Option<StaticFailure>,
    /// The equilibrium under rotation and constant loads, if there is one.
    pub base: Option<State>,
}

/// Remark on a limit point at which prestress is beyond first order.
const OF_FIRST_ORDER: &str = "the limit point may be caused by the table of prestress: in large \
    twist without tension, sections with a table soften although they stiffen in reality, see \
    the previous remark; try without prestress = true";

/// Equilibria of `model` up to the load factor requested by `settings`.
pub fn statics(model: &Model, settings: &StaticSettings) -> StaticOutcome {
    let mut outcome = statics_from(model, settings, None);
    if let Some(step) = outcome.result.last().filter(|_| outcome.failure.is_none()) {
        let mut operation = Operation::default();
        operation.add("", &step.air, model.words);
        outcome.result.remarks.extend(operation.remarks());
    }
    outcome
}

/// The same, from the equilibrium of a similar model under rotation and constant loads if it is given, without
/// remarks on the operating point.
pub(super) fn statics_from(
    model: &Model,
    settings: &StaticSettings,
    from: Option<&State>,
) -> StaticOutcome {
    let mut result = StaticResult::new(model, settings.speed);
    let mut known = None;
    let failure = run(model, settings, (from, &mut known), &mut result).err();
    result.remarks.extend(limits_passed(&result.steps));
    let last = result.last();
    let remark = last.and_then(|step| {
        let when = format!("at factor {:.6}", step.factor);
        first_order(&step.sections, &when)
    });
    let is_limit = matches!(
        failure,
        Some(StaticFailure::Path(PathEnd::LimitPoint { .. }))
    );
    let doubt = remark.is_some() && is_limit;
    let deformed = result.last().map(|step| {
        let when = format!("at factor {:.6}", step.factor);
        deformation(&step.sections, &when)
    });
    result
        .remarks
        .extend(deformed.into_iter().flatten().flatten());
    result.remarks.extend(remark);
    result
        .remarks
        .extend(doubt.then(|| OF_FIRST_ORDER.to_owned()));
    StaticOutcome {
        result,
        failure,
        base: known,
    }
}

fn run(
    model: &Model,
    settings: &StaticSettings,
    (from, known): (Option<&State>, &mut Option<State>),
    result: &mut StaticResult,
) -> Result<(), StaticFailure> {
    let solver = LinearSolver::new(model.system.pattern());
    let conditions = model.conditions(settings.speed, 1.0, 0.0);
    let base = match from {
        Some(state) => point(
            &conditions,
            equilibrium(model, &solver, (&conditions, state), &conditions)?,
        ),
        None => base(model, &solver, &conditions)?,
    };
    *known = Some(base.state.clone());
    result
        .steps
        .push(static_step(model, &conditions, base.clone()));
    let growth = model.system.by_factor(&base.state, &conditions);
    if growth.iter().all(|value| *value == 0.0) || settings.to == 0.0 {
        return Ok(());
    }
    let walker = Walker {
        balance: Balance::new(&model.system, &solver, conditions, base.state),
        to: settings.to,
        steps: settings.steps,
        most_steps: settings.most_steps,
    };
    let (points, end) = if settings.arc_length {
        walker.by_length()
    } else {
        walker.by_factor()
    };
    result.remarks.extend(branching(&walker, &points));
    for point in points {
        let conditions = walker.conditions(point.factor);
        result.steps.push(static_step(model, &conditions, point));
    }
    end.map_or(Ok(()), |end| Err(end.into()))
}

/// The equilibrium under `conditions`, from rest.
pub(super) fn base(
    model: &Model,
    solver: &LinearSolver,
    conditions: &Conditions,
) -> Result<Point, Box<NoEquilibrium>> {
    let rest: State = model.system.rest();
    let found = equilibrium(model, solver, (&Conditions::at_rest(), &rest), conditions)?;
    Ok(point(conditions, found))
}

/// An equilibrium as a point of a path.
pub(super) fn point(conditions: &Conditions, found: Equilibrium) -> Point {
    Point {
        factor: conditions.loading.proportional,
        state: found.state,
        iterations: found.iterations,
        residual: found.residual,
    }
}

/// A point of a path with all its output.
pub(super) fn static_step(model: &Model, conditions: &Conditions, point: Point) -> StaticStep {
    let observed = model.system.observe(&point.state, conditions);
    let nodes = &point.state.nodes;
    StaticStep {
        factor: point.factor,
        positions: nodes.iter().map(|node| node.position).collect(),
        rotations: nodes.iter().map(|node| node.rotation).collect(),
        iterations: point.iterations,
        residual: point.residual,
        sections: observed.sections,
        reactions: observed.reactions,
        air: observed.air,
        electrodes: model.system.electrodes(&point.state, conditions),
    }
}

/// A remark on the first critical point that is not a limit point: there the path meets another
/// one, and the following equilibria are unstable.
fn branching(walker: &Walker<'_>, points: &[Point]) -> Option<String> {
    let balance = &walker.balance;
    let tangent = |point: &Point| {
        let conditions = walker.conditions(point.factor);
        balance.system.by_unknowns(&point.state, &conditions)
    };
    let start = Point {
        factor: 0.0,
        state: balance.state.clone(),
        iterations: 0,
        residual: 0.0,
    };
    let all: Vec<&Point> = std::iter::once(&start).chain(points).collect();
    let turns = |i: usize| match (all.get(i.wrapping_sub(1)), all.get(i + 1)) {
        (Some(a), Some(b)) => (all[i].factor - a.factor) * (b.factor - all[i].factor) < 0.0,
        _ => false,
    };
    for (i, pair) in all.windows(2).enumerate() {
        let is_limit = turns(i) || turns(i + 1);
        let [from, to] = [pair[0], pair[1]].map(|point| (&point.state, || tangent(point)));
        let part = critical_part(balance.solver, from, to);
        if let Some(part) = part.filter(|_| !is_limit) {
            let [from, to] = [pair[0], pair[1]].map(|point| point.factor);
            return Some(format!(
                "a critical point was passed near the load factor {:.4}, where another path \
                 branches off: from there on these equilibria are unstable",
                from + part * (to - from)
            ));
        }
    }
    None
}

/// Remarks on the limit points between the steps.
fn limits_passed(steps: &[StaticStep]) -> Vec<String> {
    let turns = steps.windows(3).filter(|three| {
        let [before, after] = [0, 1].map(|i| three[i + 1].factor - three[i].factor);
        before * after < 0.0
    });
    turns
        .map(|three| {
            format!(
                "a limit point was passed near the load factor {:.4}",
                three[1].factor
            )
        })
        .collect()
}
