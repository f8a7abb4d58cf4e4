//! The requested motion in time: `[transient]`.

use shared_geom::document::Table;
use shared_geom::error::Explain;
use shared_geom::units::Dimension;

use super::misplaced_keys::OF_TRANSIENT;
use super::number::short_number;
use crate::case::{Redundant, Start, StartAccelerations, StartShape, TransientSettings};
use crate::integrator::{Jacobians, Scheme, StepControl, StepLimits, Stepping};

mod keys;
mod node;
#[cfg(test)]
mod tests;

pub(super) use keys::TRANSIENT;
use keys::{
    DISPLACEMENT, FIRST, FROM, ITERATIONS, JACOBIAN, LEAST, METHOD, MODE, MOST, REDUNDANT, SCHEME,
    SHAPE, SPEED, START, START_ACCELERATIONS, TO, TOLERANCE,
};
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
    /// Initial velocities without `[transient]`.
    #[error("node \"{node}\" has a \"{key}\", but there is no [transient]")]
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
            Self::IdleSpeed => "write start = \"rotating\", or remove \"speed\"",
            Self::IdleShape => "write start = \"equilibrium\", or remove \"shape\"",
            Self::IdleVelocity { .. } => "add [transient] with \"to\" and \"step\", or remove it",
            Self::Range { .. } => return None,
        };
        Some(text.to_owned())
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
    let settings = settings(&table);
    table.finish_beside(&OF_TRANSIENT);
    settings.map(Some)
}

fn settings(table: &Table<'_>) -> Option<TransientSettings> {
    let times = times(table);
    let stepping = stepping(table, times.map(|[from, to]| to - from));
    let scheme = scheme(table);
    let newton = newton(table);
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
        table.note("to", &TransientProblem::EndsBefore { from, to });
        return None;
    }
    Some([from, to])
}

/// Reads `step`: a length, or limits; `length` is the length of the run, if it is known.
fn stepping(table: &Table<'_>, length: Option<f64>) -> Option<Stepping> {
    if table.is_table("step") {
        return variable(&table.table("step")?, length).map(Stepping::Variable);
    }
    let step = table.require_positive("step", Dimension::TIME)?;
    is_possible(table, "step", step, length).then_some(Stepping::Constant { step })
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
    if !is_possible(table, "first", first, length) {
        return None;
    }
    let least = least?.unwrap_or(LEAST_STEP * first);
    let by_run = length.map_or(f64::INFINITY, |length| MOST_STEP * length);
    let most = most?.unwrap_or(by_run.max(first));
    for (lower, low, upper, high) in [
        ("least", least, "first", first),
        ("first", first, "most", most),
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
    let radius = number_in(table, "radius", (0.0, 1.0), "a number from 0 to 1");
    let zeta = number_in(table, "zeta", (-1.0, 0.0), "a number above -1 and below 0");
    let (number, radius, zeta) = (number?, radius?, zeta?);
    let name = SCHEMES[number];
    let has_radius = matches!(name, "two-step" | "cubic");
    for (key, is_given, is_used) in [
        ("radius", radius.is_some(), has_radius),
        ("zeta", zeta.is_some(), name == "parabolic"),
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
        table.note("radius", &problem);
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

fn number_in(
    table: &Table<'_>,
    key: &'static str,
    (low, high): (f64, f64),
    expected: &'static str,
) -> Option<Option<f64>> {
    if !table.has(key) {
        return Some(None);
    }
    let found = table.quantity(key, Dimension::NUMBER)?;
    // The ends of the range of zeta make the weights of the scheme infinite.
    let is_end = key == "zeta" && (found == low || found == high);
    if !(low..=high).contains(&found) || is_end {
        let problem = TransientProblem::Range {
            key,
            found,
            expected,
        };
        table.note(key, &problem);
        return None;
    }
    Some(Some(found))
}

fn newton(table: &Table<'_>) -> Option<StepLimits> {
    let standard = StepLimits::default();
    if !table.has("newton") {
        return Some(standard);
    }
    let table = table.table("newton")?;
    let method = table.get(&METHOD);
    let iterations = table.get(&ITERATIONS);
    let tolerance = match table.has("tolerance") {
        true => number_in(
            &table,
            "tolerance",
            (LEAST_TOLERANCE, 1e-2),
            "a number from 1e-13 to 0.01",
        ),
        false => Some(None),
    };
    table.finish();
    Some(StepLimits {
        jacobians: [Jacobians::Full, Jacobians::Modified][method?],
        iterations: iterations?.unwrap_or(standard.iterations),
        correction: tolerance?.unwrap_or(standard.correction),
        ..standard
    })
}

fn start(table: &Table<'_>) -> Option<Start> {
    let (number, speed) = (table.get(&START), table.get(&SPEED));
    match (number?, speed?) {
        (2, Some(speed)) => Some(Start::Rotating { speed }),
        (2, None) => {
            let _ = table.require_quantity("speed", Dimension::ROTATION_SPEED);
            None
        }
        (_, Some(_)) => {
            table.note("speed", &TransientProblem::IdleSpeed);
            None
        }
        (0, None) => Some(Start::Given),
        (_, None) => Some(Start::Equilibrium),
    }
}

/// Reads `shape`; `Some(None)` without it.
fn shape(table: &Table<'_>, start: Option<Start>) -> Option<Option<StartShape>> {
    if !table.has(SHAPE.name()) {
        return Some(None);
    }
    let inner = table.table(SHAPE.name())?;
    let (mode, displacement) = (inner.get(&MODE), inner.get(&DISPLACEMENT));
    inner.finish();
    if start == Some(Start::Given) {
        table.note("shape", &TransientProblem::IdleShape);
        return None;
    }
    Some(Some(StartShape {
        mode: mode?,
        displacement: displacement?,
    }))
}
