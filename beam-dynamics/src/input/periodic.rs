//! The requested periodic motion: `[periodic]`.

use std::f64::consts::TAU;

use shared_geom::document::Table;
use shared_geom::error::{Explain, SourceLocation};

use super::builder::ModelBuilder;
use super::rotor_speed::rpm;
use super::short_number;
use super::transient::{FROM, REDUNDANT, START};
use crate::case::{FloquetSettings, PeriodicMethod, PeriodicSettings, Redundant, Start, Words};

mod keys;

pub(super) use keys::PERIODIC;
use keys::{
    COUNT, ERROR, FLOQUET, HARMONICS, ITERATIONS, METHOD, NEAR, PERIOD, PERIODS, REVOLUTIONS,
    SETTLE, SPEED, STAGES, STEPS, TOLERANCE,
};

/// Least number of steps in a period: shorter periods of the motion are not seen with fewer.
const LEAST_STEPS: usize = 4;
/// Number of steps below which the fundamental of the motion itself is coarse.
const FEW_STEPS: usize = 8;
/// Smallest tolerance: a period sums some hundred round-offs of 1e-16.
const LEAST_TOLERANCE: f64 = 1e-13;
const TOLERANCE_EXPECTED: &str = "at least 1e-13: round-off of a period is not smaller";
/// Part of the turns by which a period that is written with fewer digits than the speed of a rotor may be off.
const WRITTEN: f64 = 1e-6;
/// Part of a period that is its round-off.
const ROUND_OFF: f64 = 1e-12;
/// Digits of periods.
const DIGITS: usize = 9;

/// A problem of `[periodic]`.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PeriodicProblem {
    /// The period is not given, or twice.
    #[error("the period is given by {found}, expected one of \"period\" and \"speed\"")]
    Ways {
        /// The keys found, as text.
        found: &'static str,
    },
    /// A rotor at rest.
    #[error("\"speed\" is 0, expected the speed of the rotor")]
    AtRest,
    /// A rotor at rest has no period.
    #[error("the period is the one of rotor \"{name}\", whose speed is 0")]
    RotorAtRest {
        /// Name of the rotor.
        name: String,
    },
    /// A start without speed.
    #[error("\"start\" is \"rotating\", but there is no \"speed\"")]
    NoSpeed,
}

impl Explain for PeriodicProblem {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::Ways { .. } => "write period = \"0.2 s\", or speed = \"300 rpm\"",
            Self::RotorAtRest { .. } => "give it another speed, or write \"period\"",
            Self::AtRest => "write the speed, or \"period\" for a model without rotor",
            Self::NoSpeed => "add \"speed\", or write start = \"equilibrium\"",
        };
        Some(text.to_owned())
    }
}

/// Names of rotors of constant speed, and their speeds \[rad/s\]; `None` if a rotor is wrong.
type Turning<'a> = Option<Vec<(&'a str, f64)>>;

/// The first rotor that turns.
fn first_turning<'a>(rotors: &Turning<'a>) -> Option<(&'a str, f64)> {
    let mut rotors = rotors.iter().flatten();
    rotors.find(|(_, speed)| *speed != 0.0).copied()
}

/// Reads `[periodic]` of a file with rotors that turn at constant speeds; `Some(None)` without the card.
pub(super) fn read(
    root: &Table<'_>,
    rotors: &Turning<'_>,
    builder: &mut ModelBuilder,
) -> Option<Option<PeriodicSettings>> {
    if !root.has("periodic") {
        return Some(None);
    }
    let table = root.table("periodic")?;
    let (settings, floquet) = (settings(&table, rotors, builder), floquet(&table));
    table.finish();
    let mut settings = settings?;
    settings.floquet = floquet?;
    Some(Some(settings))
}

/// Whether the card has the speed of the first rotor.
pub(super) fn takes_the_rotors(root: &Table<'_>) -> bool {
    let table = root.is_table("periodic").then(|| root.table("periodic"));
    let own = table.flatten();
    own.is_some_and(|table| !table.has(&PERIOD) && !table.has(&SPEED))
}

/// The place of the card.
pub(super) fn location(root: &Table<'_>) -> Option<SourceLocation> {
    let table = root
        .is_table("periodic")
        .then(|| root.table("periodic"))??;
    Some(table.document().location(table.line()))
}

/// Everything but the multipliers.
fn settings(
    table: &Table<'_>,
    rotors: &Turning<'_>,
    builder: &mut ModelBuilder,
) -> Option<PeriodicSettings> {
    let from = table.get(&FROM);
    let period = period(table, rotors).map(|own| in_turns(own, rotors, builder));
    let steps = table.get_if(&STEPS, |steps| *steps >= LEAST_STEPS, "at least 4 steps");
    let (stages, method) = (table.get(&STAGES), table.get(&METHOD));
    let tolerance = table.get_if(
        &TOLERANCE,
        |own| *own >= LEAST_TOLERANCE,
        TOLERANCE_EXPECTED,
    );
    let iterations = table.get(&ITERATIONS);
    let (periods, settle) = (table.get(&PERIODS), table.get(&SETTLE));
    let harmonics = table.get(&HARMONICS);
    if let Some(few) = steps.filter(|steps| *steps < FEW_STEPS) {
        builder.add_remarks(vec![format!(
            "\"steps\" = {few} of [periodic] are few: {FEW_STEPS} or more for each oscillation in the period resolve \
             the motion"
        )]);
    }
    let (start, redundant) = (table.get(&START), table.get(&REDUNDANT));
    let ((period, speed), from, steps) = (period?, from?, steps?);
    let start = match (start?, speed) {
        (0, _) => Start::Given,
        (1, _) => Start::Equilibrium,
        (_, Some(speed)) => Start::Rotating { speed },
        (_, None) => {
            table.note(&START, &PeriodicProblem::NoSpeed);
            return None;
        }
    };
    let mut settings = PeriodicSettings::new(period, steps);
    (settings.start.from, settings.start.to) = (from, from + period);
    (settings.start.start, settings.speed) = (start, speed);
    settings.start.redundant = [Redundant::Error, Redundant::Remove][redundant?];
    settings.three_stages = stages? == 0;
    settings.method = [PeriodicMethod::Shooting, PeriodicMethod::March][method?];
    (settings.tolerance, settings.iterations) = (tolerance?, iterations?);
    (settings.periods, settings.settle) = (periods?, settle?);
    settings.harmonics = harmonics?;
    Some(settings)
}

/// The period of whole turns of the first rotor, if it is that one but for digits that were not written, which
/// a remark states.
fn in_turns(
    (period, speed): (f64, Option<f64>),
    rotors: &Turning<'_>,
    builder: &mut ModelBuilder,
) -> (f64, Option<f64>) {
    let Some((name, own)) = first_turning(rotors) else {
        return (period, speed);
    };
    let turns = own.abs() * period / TAU;
    let whole = turns.round();
    let off = (turns - whole).abs();
    if whole == 0.0 || off <= ROUND_OFF * whole || off > WRITTEN * whole {
        return (period, speed);
    }
    let exact = whole * TAU / own.abs();
    builder.add_remarks(vec![format!(
        "the period of [periodic] is {} s, the time of {} of rotor \"{name}\" at {}, in place of {} s",
        short_number(exact, DIGITS),
        if whole == 1.0 { "one turn".to_owned() } else { format!("{whole} turns") },
        rpm(own),
        short_number(period, DIGITS)
    )]);
    (exact, speed.map(|speed| speed * period / exact))
}

/// The period \[s\], and the speed of the rotor \[rad/s\]: without both the one of the first rotor.
fn period(table: &Table<'_>, rotors: &Turning<'_>) -> Option<(f64, Option<f64>)> {
    let (period, speed) = (table.get(&PERIOD), table.get(&SPEED));
    let revolutions = table.get(&REVOLUTIONS);
    let (period, speed, revolutions) = (period?, speed?, revolutions?);
    let of_rotor = first_turning(rotors).map(|rotor| rotor.1);
    let at_rest = rotors.iter().flatten().next();
    let speed = speed.or(of_rotor.filter(|_| period.is_none()));
    match (period, speed) {
        (Some(period), None) => Some((period, None)),
        (None, Some(0.0)) => {
            table.note(&SPEED, &PeriodicProblem::AtRest);
            None
        }
        (None, Some(speed)) => Some((revolutions as f64 * TAU / speed.abs(), Some(speed))),
        // The rotor that has the speed is wrong, which is noted.
        (None, None) if rotors.is_none() => None,
        (found, _) => {
            let (key, problem) = match (found, at_rest) {
                (Some(_), _) => {
                    let found = "both \"period\" and \"speed\"";
                    (PERIOD.name(), PeriodicProblem::Ways { found })
                }
                (None, Some((name, _))) => {
                    let name = (*name).to_owned();
                    ("", PeriodicProblem::RotorAtRest { name })
                }
                (None, None) => ("", PeriodicProblem::Ways { found: "nothing" }),
            };
            table.note(key, &problem);
            None
        }
    }
}

/// Reads `[periodic.floquet]`; `Some(None)` without it.
fn floquet(table: &Table<'_>) -> Option<Option<FloquetSettings>> {
    if !table.has(&FLOQUET) {
        return Some(None);
    }
    let table = table.table(&FLOQUET)?;
    let (count, near, error) = (table.get(&COUNT), table.get(&NEAR), table.get(&ERROR));
    table.finish();
    let near = near?.unwrap_or_default();
    Some(Some(FloquetSettings {
        count: count?,
        near: near.into_iter().map(|frequency| TAU * frequency).collect(),
        estimates_error: error?,
        words: Words::default(),
    }))
}
