//! The requested motion in time: `[transient]`.

use shared_geom::document::{Key, Table};
use shared_geom::error::{Explain, SourceLocation};

use super::misplaced_keys::OF_TRANSIENT;
use super::number::short_number;
use crate::assembly::System;
use crate::case::{Redundant, Start, StartAccelerations, StartShape, TransientSettings};
use crate::integrator::{Jacobians, Scheme, StepControl, StepLimits, Stepping};

mod keys;
mod node;
#[cfg(test)]
mod tests;

use keys::{
    CORRECTION, DISPLACEMENT, FIRST, ITERATIONS, JACOBIAN, LEAST, METHOD, MODE, MOST, NEWTON,
    RADIUS, SCHEME, SHAPE, SPEED, START_ACCELERATIONS, STEP, TO, TOLERANCE, ZETA,
};
pub(super) use keys::{FROM, REDUNDANT, START, TRANSIENT};
pub(super) use node::{
    ANGULAR_VELOCITY, INITIAL_WEIGHT, VELOCITY, VELOCITY_WEIGHT, check, initial_motion,
};

/// Largest accepted number of iterations of a step.
const MOST_ITERATIONS: usize = 1000;
/// Largest number of steps of a run: more are treated as an error.
const MOST_STEPS: f64 = 1e9;
/// Largest number of a mode whose shape a start has.
const MOST_MODES: usize = 100;
/// Smallest tolerance of the iteration that round-off allows.
const LEAST_TOLERANCE: f64 = 1e-13;
/// Default smallest variable step, as a part of the first step.
const LEAST_STEP: f64 = 1e-6;
/// Largest radius of the two-step scheme below one: an oscillation from step to step decays
/// by the radius, and grows in rotations by about the square of the angle of a step, which
/// is more at steps of 0.1 rad.
const MOST_RADIUS: f64 = 0.99;
/// Default largest variable step, as a part of the run.
const MOST_STEP: f64 = 1.0 / 50.0;

/// A problem of `[transient]` or of the initial motion of a node.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum TransientProblem {
    /// A run that ends before it starts.
    #[error("\"to\" is {} s, expected later than \"from\", which is {} s", six(*.to), six(*.from))]
    EndsBefore {
        /// First instant \[s\].
        from: f64,
        /// Last instant \[s\].
        to: f64,
    },
    /// A step that is longer than the run.
    #[error("\"{key}\" is {} s, but the whole run lasts {} s", six(*.step), six(*.length))]
    LongStep {
        /// The key.
        key: &'static str,
        /// The step \[s\].
        step: f64,
        /// Length of the run \[s\].
        length: f64,
    },
    /// Too many steps.
    #[error("the run would take {} steps of {} s", six(*.steps), six(*.step))]
    ManySteps {
        /// Number of steps.
        steps: f64,
        /// The step \[s\].
        step: f64,
    },
    /// Limits of the step that exclude each other.
    #[error("\"{lower}\" is {} s, more than \"{upper}\", which is {} s", six(*.low), six(*.high))]
    Limits {
        /// The key of the smaller.
        lower: &'static str,
        /// Its value \[s\].
        low: f64,
        /// The key of the larger.
        upper: &'static str,
        /// Its value \[s\].
        high: f64,
    },
    /// A number outside of its range.
    #[error("\"{key}\" is {}, expected {expected}", six(*.found))]
    Range {
        /// The key.
        key: &'static str,
        /// The number found.
        found: f64,
        /// The expected values, as text.
        expected: &'static str,
    },
    /// A radius at which the two-step scheme adds energy to rotations.
    #[error(
        "\"radius\" of \"two-step\" is {}, expected at most {MOST_RADIUS}, or 1: nearer to 1 it \
         adds energy to rotations",
        six(*.found)
    )]
    UndampedRadius {
        /// The radius.
        found: f64,
    },
    /// A key that the scheme does not use.
    #[error("the scheme \"{scheme}\" has no \"{key}\"")]
    NotOfScheme {
        /// The key.
        key: &'static str,
        /// The scheme.
        scheme: &'static str,
    },
    /// A speed without rotation.
    #[error("\"speed\" is the speed of a rotating start, but \"start\" is not \"rotating\"")]
    IdleSpeed,
    /// A shape without an equilibrium to which it is added.
    #[error("\"shape\" is added to an equilibrium, but \"start\" is \"given\"")]
    IdleShape,
    /// Stages at Gauss' points, with constraints: they are enforced at the ends of steps only.
    #[error(
        "\"scheme\" is \"gauss\", which cannot enforce constraints, but the model has {}",
        counted(*.constraints)
    )]
    WithConstraints {
        /// Number of constraint equations.
        constraints: usize,
    },
    /// Initial velocities without `[transient]`.
    #[error("node \"{node}\" has \"{key}\", but there is no [transient]")]
    IdleVelocity {
        /// Name of the node.
        node: String,
        /// The key.
        key: &'static str,
    },
}

impl Explain for TransientProblem {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::EndsBefore { .. } => "times are in the unit of time of the file",
            Self::LongStep { .. } | Self::ManySteps { .. } => {
                "give \"step\" in the unit of time of the file; some hundred steps per period of \
                 the fastest motion of interest are usual"
            }
            Self::Limits { .. } => "steps are between \"least\" and \"most\"",
            Self::NotOfScheme { key: "radius", .. } => {
                "\"radius\" is a key of \"two-step\" and \"cubic\""
            }
            Self::NotOfScheme { .. } => "\"zeta\" is a key of \"parabolic\"",
            Self::UndampedRadius { .. } => {
                "use radius = 0.99, scheme = \"crank-nicolson\", or scheme = \"cubic\" with \
                 radius = 1, which conserves energy best"
            }
            Self::WithConstraints { .. } => {
                "use scheme = \"two-step\" or \"radau-iia\"; clamps, hinges, rods and joints are \
                 constraints"
            }
            Self::IdleSpeed => "write start = \"rotating\", or remove \"speed\"",
            Self::IdleShape => "write start = \"equilibrium\", or remove \"shape\"",
            Self::IdleVelocity { .. } => "add [transient] with \"to\" and \"step\", or remove it",
            Self::Range { .. } => return None,
        };
        Some(text.to_owned())
    }
}

fn counted(constraints: usize) -> String {
    match constraints {
        1 => "one equation of constraint".to_owned(),
        _ => format!("{constraints} equations of constraint"),
    }
}

fn six(value: f64) -> String {
    short_number(value, 6)
}

/// Reads `[transient]`; `Some(None)` without the card.
pub(super) fn read(root: &Table<'_>) -> Option<Option<TransientSettings>> {
    if !root.has("transient") {
        return Some(None);
    }
    let table = root.table("transient")?;
    let settings = settings(&table, has_strips(root));
    table.finish_beside(&OF_TRANSIENT);
    settings.map(Some)
}

/// Whether the model has strips in the air.
fn has_strips(root: &Table<'_>) -> bool {
    let is_in_air = |blade: &Table<'_>| blade.has("aerodynamics");
    root.has("strip") || root.is_list("blade") && root.tables("blade").iter().any(is_in_air)
}

fn settings(table: &Table<'_>, has_strips: bool) -> Option<TransientSettings> {
    let times = times(table);
    let stepping = stepping(table, times.map(|[from, to]| to - from));
    let scheme = scheme(table);
    let newton = newton(table, has_strips);
    let jacobian = table.get(&JACOBIAN);
    let start = start(table);
    let shape = shape(table, start);
    let accelerations = table.get(&START_ACCELERATIONS);
    let redundant = table.get(&REDUNDANT);
    let [from, to] = times?;
    Some(TransientSettings {
        from,
        to,
        stepping: stepping?,
        scheme: scheme?,
        newton: newton?,
        simplified_jacobian: jacobian? == 1,
        start: start?,
        shape: shape?,
        start_accelerations: [
            StartAccelerations::Consistent,
            StartAccelerations::Zero,
            StartAccelerations::Dummy,
            StartAccelerations::AtRest,
        ][accelerations?],
        redundant: [Redundant::Error, Redundant::Remove][redundant?],
    })
}

fn times(table: &Table<'_>) -> Option<[f64; 2]> {
    let (from, to) = (table.get(&FROM), table.get(&TO));
    let (from, to) = (from?, to?);
    if to <= from {
        table.note(&TO, &TransientProblem::EndsBefore { from, to });
        return None;
    }
    Some([from, to])
}

/// The place of `scheme` in `[transient]`, if both are there.
pub(super) fn scheme_location(root: &Table<'_>) -> Option<SourceLocation> {
    let is_there = root.has("transient") && root.is_table("transient");
    let table = is_there.then(|| root.table("transient")).flatten()?;
    let is_given = table.has(&SCHEME);
    is_given.then(|| table.document().location(table.line_of(&SCHEME)))
}

/// The problem of a scheme that cannot enforce the constraints of `system`.
pub(super) fn unenforced(
    settings: Option<&TransientSettings>,
    system: &System,
) -> Option<TransientProblem> {
    let constraints = system.numbering().multipliers();
    let is_gauss = settings.is_some_and(|settings| settings.scheme == Scheme::CubicGauss);
    (is_gauss && constraints > 0).then_some(TransientProblem::WithConstraints { constraints })
}

/// Reads `step`: a length, or limits; `length` is the length of the run, if it is known.
fn stepping(table: &Table<'_>, length: Option<f64>) -> Option<Stepping> {
    if table.is_table(&STEP) {
        return variable(&table.table(&STEP)?, length).map(Stepping::Variable);
    }
    let step = table.get(&STEP)?;
    is_possible(table, STEP.name(), step, length).then_some(Stepping::Constant { step })
}

/// Whether a step fits into a run; otherwise notes the problem.
fn is_possible(table: &Table<'_>, key: &'static str, step: f64, length: Option<f64>) -> bool {
    let Some(length) = length else { return true };
    let steps = length / step;
    let problem = if step > length * (1.0 + 1e-9) {
        TransientProblem::LongStep { key, step, length }
    } else if steps > MOST_STEPS {
        TransientProblem::ManySteps { steps, step }
    } else {
        return true;
    };
    table.note(key, &problem);
    false
}

fn variable(table: &Table<'_>, length: Option<f64>) -> Option<StepControl> {
    let first = table.get(&FIRST);
    let (least, most) = (table.get(&LEAST), table.get(&MOST));
    let tolerance = table.get(&TOLERANCE);
    table.finish();
    let first = first?;
    if !is_possible(table, FIRST.name(), first, length) {
        return None;
    }
    let least = least?.unwrap_or(LEAST_STEP * first);
    let by_run = length.map_or(f64::INFINITY, |length| MOST_STEP * length);
    let most = most?.unwrap_or(by_run.max(first));
    for (lower, low, upper, high) in [
        (LEAST.name(), least, FIRST.name(), first),
        (FIRST.name(), first, MOST.name(), most),
    ] {
        if low > high {
            let key = if table.has(lower) { lower } else { upper };
            let problem = TransientProblem::Limits {
                lower,
                low,
                upper,
                high,
            };
            table.note(key, &problem);
            return None;
        }
    }
    Some(StepControl {
        first,
        least,
        most,
        tolerance: tolerance?,
    })
}

/// The words of schemes.
const SCHEMES: [&str; 8] = [
    "two-step",
    "crank-nicolson",
    "bdf2",
    "implicit-euler",
    "cubic",
    "parabolic",
    "radau-iia",
    "gauss",
];

fn scheme(table: &Table<'_>) -> Option<Scheme> {
    let number = table.get(&SCHEME);
    let radius = within(table, &RADIUS, |radius| radius <= 1.0);
    let zeta = within(table, &ZETA, |zeta| -1.0 < zeta && zeta < 0.0);
    let (number, radius, zeta) = (number?, radius?, zeta?);
    let name = SCHEMES[number];
    let has_radius = matches!(name, "two-step" | "cubic");
    for (key, is_given, is_used) in [
        (RADIUS.name(), radius.is_some(), has_radius),
        (ZETA.name(), zeta.is_some(), name == "parabolic"),
    ] {
        if is_given && !is_used {
            let problem = TransientProblem::NotOfScheme { key, scheme: name };
            table.note(key, &problem);
            return None;
        }
    }
    let radius = radius.unwrap_or(0.6);
    if name == "two-step" && radius > MOST_RADIUS && radius < 1.0 {
        let problem = TransientProblem::UndampedRadius { found: radius };
        table.note(&RADIUS, &problem);
        return None;
    }
    Some(match name {
        "two-step" => Scheme::TwoStep { radius },
        "crank-nicolson" => Scheme::CrankNicolson,
        "bdf2" => Scheme::Bdf2,
        "implicit-euler" => Scheme::ImplicitEuler,
        "cubic" => Scheme::Cubic { radius },
        "gauss" => Scheme::CubicGauss,
        _ => Scheme::Parabolic {
            zeta: zeta.unwrap_or(-2.0 / 3.0),
        },
    })
}

/// An optional number within a range, which the declaration of its key describes.
fn within(
    table: &Table<'_>,
    key: &Key<Option<f64>>,
    is_right: impl Fn(f64) -> bool,
) -> Option<Option<f64>> {
    table.get_if(key, |found| found.is_none_or(is_right), key.schema.expected)
}

/// The iteration of a step. Jacobians of strips cost as much as several corrections: with strips
/// they are kept unless the file states otherwise.
fn newton(table: &Table<'_>, has_strips: bool) -> Option<StepLimits> {
    const METHODS: [Jacobians; 2] = [Jacobians::Full, Jacobians::Modified];
    let own = METHODS[usize::from(has_strips)];
    let standard = StepLimits {
        jacobians: own,
        ..StepLimits::default()
    };
    if !table.has(&NEWTON) {
        return Some(standard);
    }
    let table = table.table(&NEWTON)?;
    let method = table.get(&METHOD);
    let iterations = table.get(&ITERATIONS);
    let is_right = |tolerance: f64| (LEAST_TOLERANCE..=1e-2).contains(&tolerance);
    let tolerance = within(&table, &CORRECTION, is_right);
    table.finish();
    let correction = tolerance?.unwrap_or(standard.correction);
    Some(StepLimits {
        jacobians: method?.map_or(own, |method| METHODS[method]),
        iterations: iterations?.unwrap_or(standard.iterations),
        correction,
        residual: correction / standard.correction * standard.residual,
    })
}

fn start(table: &Table<'_>) -> Option<Start> {
    let (number, speed) = (table.get(&START), table.get(&SPEED));
    match (number?, speed?) {
        (2, Some(speed)) => Some(Start::Rotating { speed }),
        (2, None) => {
            let expected = SPEED.schema.expected();
            let _ = table.require_item(&SPEED, &expected);
            None
        }
        (_, Some(_)) => {
            table.note(&SPEED, &TransientProblem::IdleSpeed);
            None
        }
        (0, None) => Some(Start::Given),
        (_, None) => Some(Start::Equilibrium),
    }
}

/// Reads `shape`; `Some(None)` without it.
fn shape(table: &Table<'_>, start: Option<Start>) -> Option<Option<StartShape>> {
    if !table.has(&SHAPE) {
        return Some(None);
    }
    let inner = table.table(&SHAPE)?;
    let (mode, displacement) = (inner.get(&MODE), inner.get(&DISPLACEMENT));
    inner.finish();
    if start == Some(Start::Given) {
        table.note(&SHAPE, &TransientProblem::IdleShape);
        return None;
    }
    Some(Some(StartShape {
        mode: mode?,
        displacement: displacement?,
    }))
}
