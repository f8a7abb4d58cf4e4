//! The requested periodic motion: `[periodic]`.

use std::f64::consts::TAU;

use shared_geom::document::Table;
use shared_geom::error::Explain;

use super::builder::ModelBuilder;
use super::drives::{self, Catalog, Measure, Read};
use super::transient::{FROM, REDUNDANT, START};
use crate::case::{
    FloquetSettings, PeriodicMethod, PeriodicSettings, PeriodicTarget, Redundant, Start,
};
use crate::elements::Input;
use crate::elements::control::Kept;
use crate::model::Scalar;

mod keys;

pub(super) use keys::PERIODIC;
use keys::{
    CONTROL, COUNT, ERROR, FLOQUET, GUESS, HARMONICS, ITERATIONS, METHOD, NAME, NEAR, PERIOD,
    PERIODS, REVOLUTIONS, SCALE, SETTLE, SIGNAL, SPEED, STAGES, STEPS, TARGET, TARGET_NAME,
    TARGET_SCALE, TOLERANCE, VALUE,
};

/// Least number of steps in a period: shorter periods of the motion are not seen with fewer.
const LEAST_STEPS: usize = 4;

/// A problem of `[periodic]`.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PeriodicProblem {
    /// The period is not given, or twice.
    #[error("the period is given by {found}, expected either \"period\" or \"speed\"")]
    Ways {
        /// The keys found, as text.
        found: &'static str,
    },
    /// A rotor at rest.
    #[error("\"speed\" is 0, expected the speed of the rotor")]
    AtRest,
    /// A start without speed.
    #[error("\"start\" is \"rotating\", but there is no \"speed\"")]
    NoSpeed,
    /// Controls and targets differ in number.
    #[error("there are {controls} controls and {targets} targets, expected as many of each")]
    Counts {
        /// Number of controls.
        controls: usize,
        /// Number of targets.
        targets: usize,
    },
    /// Controls with a march.
    #[error("controls are found by shooting, but \"method\" is \"march\"")]
    MarchedControls,
    /// Controls beside an analysis without time.
    #[error("[periodic] has controls, which [{card}] does not find")]
    Beside {
        /// The other card.
        card: &'static str,
    },
}

impl Explain for PeriodicProblem {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::Ways { .. } => "write period = \"0.2 s\", or speed = \"300 rpm\"",
            Self::AtRest => "write the speed, or \"period\" for a model without rotor",
            Self::NoSpeed => "add \"speed\", or write start = \"equilibrium\"",
            Self::Counts { .. } => "give each [[periodic.control]] one [[periodic.target]]",
            Self::MarchedControls => "write method = \"shooting\"",
            Self::Beside { .. } => {
                "write the analyses into two files, which include the same model: replace the \
                 controls by parameters in the other one"
            }
        };
        Some(text.to_owned())
    }
}

/// A control with its table.
pub(super) struct Control {
    name: String,
    state: Scalar,
    guess: f64,
}

/// Makes the controls readable by expressions.
pub(super) fn declare(root: &Table<'_>, drives: &mut Catalog) -> Vec<Control> {
    let table = match root.has("periodic") {
        true => root.table("periodic"),
        false => None,
    };
    let tables = table.filter(|table| table.has(&CONTROL));
    let tables = tables
        .map(|table| table.tables(&CONTROL))
        .unwrap_or_default();
    let control = |card: &Table<'_>| {
        let (name, guess, scale) = (card.get(&NAME), card.get(&GUESS), card.get(&SCALE));
        card.finish();
        let name = name?;
        if !drives.is_free(&name, card, NAME.name()) {
            return None;
        }
        let (guess, scale) = (guess?, scale?);
        let state = Kept::state(&control_label(&name), &name, guess, scale);
        let input = Input {
            scalar: state.clone(),
            unit: 1.0,
        };
        let read = Read {
            input,
            measure: Measure::Plain,
        };
        drives.add_readable(name.clone(), Some(read));
        Some(Control { name, state, guess })
    };
    tables.iter().filter_map(control).collect()
}

/// Label of the element of a control.
fn control_label(name: &str) -> String {
    format!("control {name}")
}

/// Reads `[periodic]`, and adds its controls and targets to the model; `Some(None)` without the
/// card.
pub(super) fn read(
    root: &Table<'_>,
    controls: Vec<Control>,
    builder: &mut ModelBuilder,
) -> Option<Option<PeriodicSettings>> {
    if !root.has("periodic") {
        return Some(None);
    }
    let table = root.table("periodic")?;
    let count = match table.has(&CONTROL) {
        true => table.tables(&CONTROL).len(),
        false => 0,
    };
    let is_complete = count == controls.len();
    let pairs = controls.iter().map(|control| {
        let label = control_label(&control.name);
        (control.name.clone(), label)
    });
    let pairs: Vec<_> = pairs.collect();
    for control in controls {
        builder.add_control(Box::new(Kept::new(
            control.state,
            control.guess,
            Vec::new(),
        )));
    }
    let targets = targets(&table, builder);
    let settings = settings(&table);
    let floquet = floquet(&table);
    table.finish();
    let (targets, mut settings) = (targets?, settings?);
    if count != targets.len() {
        let (controls, targets) = (count, targets.len());
        let key = if controls > 0 { &CONTROL } else { &TARGET };
        table.note(key, &PeriodicProblem::Counts { controls, targets });
        return None;
    }
    if count > 0 && settings.method == PeriodicMethod::March {
        table.note(&METHOD, &PeriodicProblem::MarchedControls);
        return None;
    }
    if count > 0 {
        let mut others = ["modes", "static", "buckling"].into_iter();
        if let Some(card) = others.find(|card| root.has(card)) {
            table.note(&CONTROL, &PeriodicProblem::Beside { card });
            return None;
        }
    }
    (settings.controls, settings.targets, settings.floquet) = (pairs, targets, floquet?);
    is_complete.then_some(Some(settings))
}

/// Adds the integrals of the targets to the model.
fn targets(table: &Table<'_>, builder: &mut ModelBuilder) -> Option<Vec<PeriodicTarget>> {
    let cards = match table.has(&TARGET) {
        true => table.tables(&TARGET),
        false => Vec::new(),
    };
    let mut complete = true;
    let mut targets = Vec::new();
    for card in cards {
        let found = target(&card, builder);
        card.finish();
        complete &= found.is_some();
        targets.extend(found);
    }
    complete.then_some(targets)
}

fn target(card: &Table<'_>, builder: &mut ModelBuilder) -> Option<PeriodicTarget> {
    let name = card.get(&TARGET_NAME);
    let has_signal = card
        .require_item(&SIGNAL, &SIGNAL.schema.expected())
        .is_some();
    let signal = match has_signal {
        true => drives::read_signal(card, &SIGNAL.schema, builder.drives()),
        false => None,
    };
    let (value, scale) = (card.get(&VALUE), card.get(&TARGET_SCALE));
    let name = name?;
    let is_new = builder.take_label("target", &name, card);
    let (signal, value, scale) = (signal?, value?, scale?);
    let integral = format!("target {name}");
    let state = Kept::state(&integral, &name, 0.0, scale);
    builder.add_control(Box::new(Kept::new(state, 0.0, vec![signal])));
    is_new.then_some(PeriodicTarget {
        name,
        integral,
        value,
        scale,
    })
}

/// Everything but controls, targets and multipliers.
fn settings(table: &Table<'_>) -> Option<PeriodicSettings> {
    let from = table.get(&FROM);
    let period = period(table);
    let steps = table.get_if(&STEPS, |steps| *steps >= LEAST_STEPS, "at least 4 steps");
    let (stages, method) = (table.get(&STAGES), table.get(&METHOD));
    let (tolerance, iterations) = (table.get(&TOLERANCE), table.get(&ITERATIONS));
    let (periods, settle) = (table.get(&PERIODS), table.get(&SETTLE));
    let harmonics = table.get(&HARMONICS);
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

/// The period \[s\], and the speed of the rotor \[rad/s\].
fn period(table: &Table<'_>) -> Option<(f64, Option<f64>)> {
    let (period, speed) = (table.get(&PERIOD), table.get(&SPEED));
    let revolutions = table.get(&REVOLUTIONS);
    let (period, speed, revolutions) = (period?, speed?, revolutions?);
    match (period, speed) {
        (Some(period), None) => Some((period, None)),
        (None, Some(0.0)) => {
            table.note(&SPEED, &PeriodicProblem::AtRest);
            None
        }
        (None, Some(speed)) => Some((revolutions as f64 * TAU / speed.abs(), Some(speed))),
        (found, _) => {
            let (key, found) = match found {
                Some(_) => (PERIOD.name(), "both \"period\" and \"speed\""),
                None => ("", "nothing"),
            };
            table.note(key, &PeriodicProblem::Ways { found });
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
    }))
}
