//! The requested trim: `[trim]`.
//!
//! The card is read twice: first its controls are declared, so that all expressions may read them, and
//! then, when sensors are known, the elements of controls and targets are added.

use shared_geom::document::Table;

use super::builder::ModelBuilder;
use super::drives::{Catalog, Measure, Read};
use super::sweep;
use crate::case::{
    AutoPilot, PeriodicMethod, PeriodicSettings, TrimControl, TrimMethod, TrimSettings,
};
use crate::elements::Input;
use crate::elements::control::{Balanced, Kept};
use crate::model::{Scalar, ScalarStart};

mod controls;
mod keys;
mod problem;
mod targets;

pub(super) use controls::{locations, problems};
pub(super) use keys::TRIM;
pub use problem::TrimProblem;

use keys::{
    CONTROL, FILTER, GAIN, GUESS, ITERATIONS, LOWER, METHOD, NAME, SCALE, SPEED, STEP, SWEEP,
    TOLERANCE, UPPER,
};
use targets::Named;

/// The methods in the order of their words, with these.
const METHODS: [(TrimMethod, &str); 3] = [
    (TrimMethod::Shooting, "shooting"),
    (TrimMethod::AutoPilot, "autopilot"),
    (TrimMethod::Equilibrium, "equilibrium"),
];

/// The controls whose names expressions may read.
pub(super) struct Declared {
    method: TrimMethod,
    /// All controls in their order; `None` for a wrong one.
    controls: Vec<Option<Named>>,
}

impl Declared {
    /// The unknown of the control called `name`, if there is such a control; `Some(None)` for a
    /// parameter.
    pub fn control(&self, name: &str) -> Option<Option<&Scalar>> {
        let mut all = self.controls.iter().flatten();
        let found = all.find(|own| own.control.name == name)?;
        Some(found.state.as_ref())
    }

    /// Names of the controls.
    pub fn names(&self) -> impl Iterator<Item = String> {
        let all = self.controls.iter().flatten();
        all.map(|own| own.control.name.clone())
    }
}

/// Makes the controls readable by expressions; `None` without `[trim]`, or if its method is wrong.
pub(super) fn declare(root: &Table<'_>, drives: &mut Catalog) -> Option<Declared> {
    let table = if root.has("trim") {
        root.table("trim")?
    } else {
        return None;
    };
    let method = table.get(&METHOD).map(|index| METHODS[index].0);
    let cards = if table.has(&CONTROL) {
        table.tables(&CONTROL)
    } else {
        Vec::new()
    };
    let controls = cards.iter().map(|card| named(card, method, drives));
    let controls = controls.collect();
    Some(Declared {
        method: method?,
        controls,
    })
}

/// Names and first guesses of the controls, without those that are wrong.
pub(super) fn guesses(root: &Table<'_>) -> Vec<(String, f64)> {
    let cards = controls::named_cards(root).into_iter();
    cards
        .filter_map(|(name, card)| Some((name, card.get(&GUESS)?)))
        .collect()
}

/// A control; expressions may read the name of a wrong one, too.
fn named(card: &Table<'_>, method: Option<TrimMethod>, drives: &mut Catalog) -> Option<Named> {
    let (name, guess, scale) = (card.get(&NAME), card.get(&GUESS), card.get(&SCALE));
    let (lower, upper, step) = (card.get(&LOWER), card.get(&UPPER), card.get(&STEP));
    card.finish();
    let name = name?;
    let parameters = card.document().parameters().clone();
    let parameter = parameters.into_iter().find(|own| own.0 == name);
    if parameter.is_none() && !drives.is_free(&name, card, NAME.name()) {
        return None;
    }
    let (Some(guess), Some(scale), Some(method)) = (guess, scale, method) else {
        if parameter.is_none() {
            drives.add_readable(name, None);
        }
        return None;
    };
    let lower = lower?.unwrap_or(f64::NEG_INFINITY);
    let upper = upper?.unwrap_or(f64::INFINITY);
    if parameter.is_some() && card.has(&GUESS) {
        card.note(&GUESS, &TrimProblem::GuessOfParameter { name });
        return None;
    }
    let guess = parameter.as_ref().map_or(guess, |own| own.1);
    let is_within = lower <= guess && guess <= upper && lower < upper;
    let state = parameter
        .is_none()
        .then(|| state(&name, method, (guess, scale)));
    if let Some(state) = &state {
        drives.add_readable(name.clone(), Some(readable(state)));
    }
    // The value of a wrong parameter is not a number.
    if !is_within && !guess.is_nan() {
        let problem = TrimProblem::Bounds {
            name,
            guess,
            lower,
            upper,
        };
        card.note(if card.has(&LOWER) { &LOWER } else { &UPPER }, &problem);
        return None;
    }
    let control = TrimControl {
        label: match state {
            Some(_) => format!("control {name}"),
            None => name.clone(),
        },
        name,
        scale,
        bounds: [lower, upper],
        step: step?.unwrap_or(f64::INFINITY),
    };
    Some(Named {
        control,
        guess,
        state,
    })
}

/// The unknown of a control in expressions.
fn readable(state: &Scalar) -> Read {
    Read {
        input: Input {
            scalar: state.clone(),
            unit: 1.0,
        },
        measure: Measure::Plain,
    }
}

/// The unknown of a control.
fn state(name: &str, method: TrimMethod, (guess, scale): (f64, f64)) -> Scalar {
    let owner = format!("control {name}");
    match method {
        TrimMethod::Equilibrium => Balanced::control(&owner, name, guess, scale),
        _ => Kept::state(&owner, name, ScalarStart::Constant(guess), scale),
    }
}

/// Reads `[trim]`, adds its controls and targets to the model and to the periodic motion;
/// `Some(None)` without the card.
pub(super) fn read(
    root: &Table<'_>,
    declared: Option<Declared>,
    mut periodic: Option<&mut PeriodicSettings>,
    builder: &mut ModelBuilder,
) -> Option<Option<TrimSettings>> {
    if !root.has("trim") {
        return Some(None);
    }
    let table = root.table("trim")?;
    let Declared { method, controls } = declared?;
    let is_possible = fits(root, &table, method, periodic.as_deref());
    let (own, pilot) = (settings(&table, method), pilot(&table, method));
    let asked = targets::read(&table, (method, periodic.as_deref()), builder);
    let sweep = sweep::under(&table, &SWEEP);
    let _declared = table.has(&CONTROL);
    table.finish();
    let counts = [controls.len(), asked.len()];
    if counts[0] != counts[1] || counts[0] == 0 {
        let [controls, targets] = counts;
        table.note("", &TrimProblem::Counts { controls, targets });
        return None;
    }
    let controls: Option<Vec<_>> = controls.into_iter().collect();
    let asked: Option<Vec<_>> = asked.into_iter().collect();
    let (mut settings, pilot, sweep) = (own?, pilot?, sweep?);
    let (controls, asked) = (controls?, asked?);
    if let Some(name) = sweep.as_ref().map(|sweep| &sweep.parameter)
        && controls.iter().any(|own| own.control.name == *name)
    {
        let name = name.clone();
        table.note(&SWEEP, &TrimProblem::SweptControl { name });
        return None;
    }
    settings.sweep = sweep;
    targets::add(controls.into_iter().zip(asked), &mut settings, builder);
    if let Some(periodic) = &mut periodic {
        periodic.controls.clone_from(&settings.controls);
        periodic.targets.clone_from(&settings.targets);
        periodic.pilot = pilot;
    }
    is_possible.then_some(Some(settings))
}

/// Whether the other analyses of the file suit the method; notes the first that does not.
fn fits(
    root: &Table<'_>,
    table: &Table<'_>,
    method: TrimMethod,
    periodic: Option<&PeriodicSettings>,
) -> bool {
    let is_static = method == TrimMethod::Equilibrium;
    let others: &[&str] = if is_static {
        &["modes", "static", "buckling", "transient", "periodic"]
    } else {
        &["modes", "static", "buckling"]
    };
    let word = METHODS
        .iter()
        .find(|own| own.0 == method)
        .map_or("", |own| own.1);
    // The command `stability` finds the controls before the modes.
    let is_suited = |card: &str| is_static && card == "modes" && root.has("stability");
    let mut others = others.iter().filter(|card| !is_suited(card));
    let beside = others.find(|card| root.has(card));
    let is_marched = periodic.is_some_and(|own| own.method == PeriodicMethod::March);
    let problem = match beside {
        Some(card) => TrimProblem::Beside { card },
        None if !is_static && !root.has("periodic") => TrimProblem::NoPeriod { method: word },
        None if is_marched && method == TrimMethod::Shooting => TrimProblem::Marched,
        None => return true,
    };
    table.note(&METHOD, &problem);
    false
}

/// Everything but controls, targets and sweep.
fn settings(table: &Table<'_>, method: TrimMethod) -> Option<TrimSettings> {
    let (speed, tolerance) = (table.get(&SPEED), table.get(&TOLERANCE));
    let iterations = table.get(&ITERATIONS);
    if table.has(&SPEED) && method != TrimMethod::Equilibrium {
        table.note(&SPEED, &TrimProblem::Idle { key: SPEED.name() });
        return None;
    }
    Some(TrimSettings {
        method,
        speed: speed?,
        tolerance: tolerance?,
        iterations: iterations?,
        controls: Vec::new(),
        parameters: Vec::new(),
        guesses: Vec::new(),
        targets: Vec::new(),
        sweep: None,
    })
}

/// The auto-pilot; `Some(None)` with another method.
fn pilot(table: &Table<'_>, method: TrimMethod) -> Option<Option<AutoPilot>> {
    let (gain, filter) = (table.get(&GAIN), table.get(&FILTER));
    let (gain, filter) = (gain?, filter?);
    if method == TrimMethod::AutoPilot {
        let tolerance = table.get(&TOLERANCE)?;
        return Some(Some(AutoPilot {
            gain,
            filter,
            tolerance,
        }));
    }
    let mut idle = [GAIN.name(), FILTER.name()].into_iter();
    match idle.find(|key| table.has(key)) {
        Some(key) => {
            table.note(key, &TrimProblem::Idle { key });
            None
        }
        None => Some(None),
    }
}
