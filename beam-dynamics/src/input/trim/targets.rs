//! Targets of a trim, and the elements of controls and targets.

use std::f64::consts::TAU;

use nalgebra::DMatrix;
use shared_geom::document::Table;

use super::keys::{HARMONIC, PART, SIGNAL, TARGET, TARGET_NAME, TARGET_SCALE, VALUE};
use super::problem::TrimProblem;
use crate::case::{PeriodicSettings, TrimControl, TrimMethod, TrimSettings, TrimTarget};
use crate::elements::Signal;
use crate::elements::control::{Balanced, Kept, Matrices, StateSpace, Wave};
use crate::input::builder::ModelBuilder;
use crate::input::drives;
use crate::model::{Scalar, ScalarStart};

/// A control as declared.
pub(super) struct Named {
    /// The control.
    pub control: TrimControl,
    /// Its first guess.
    pub guess: f64,
    /// Its unknown; `None` for a parameter.
    pub state: Option<Scalar>,
}

/// A target as read.
pub(super) struct Asked {
    target: TrimTarget,
    signal: Signal,
    wave: Option<Wave>,
}

/// The method and the periodic motion, if there is one.
type Context<'a> = (TrimMethod, Option<&'a PeriodicSettings>);

/// All targets; `None` for a wrong one.
pub(super) fn read(
    table: &Table<'_>,
    context: Context<'_>,
    builder: &mut ModelBuilder,
) -> Vec<Option<Asked>> {
    let cards = if table.has(&TARGET) {
        table.tables(&TARGET)
    } else {
        Vec::new()
    };
    let asked = cards.iter().map(|card| {
        let found = target(card, context, builder);
        card.finish();
        found
    });
    asked.collect()
}

fn target(card: &Table<'_>, context: Context<'_>, builder: &mut ModelBuilder) -> Option<Asked> {
    let name = card.get(&TARGET_NAME);
    let has_signal = card.require_item(&SIGNAL, &SIGNAL.schema.expected());
    let signal = if has_signal.is_some() {
        drives::read_signal(card, &SIGNAL.schema, builder.drives())
    } else {
        None
    };
    let (value, scale) = (card.get(&VALUE), card.get(&TARGET_SCALE));
    let wave = wave(card, context);
    let name = name?;
    let is_new = builder.take_label("target", &name, card);
    let target = TrimTarget {
        label: format!("target {name}"),
        name,
        value: value?,
        scale: scale?,
    };
    let (signal, wave) = (signal?, wave?);
    is_new.then_some(Asked {
        target,
        signal,
        wave,
    })
}

/// The weight of a harmonic; `Some(None)` for the mean.
fn wave(card: &Table<'_>, (method, periodic): Context<'_>) -> Option<Option<Wave>> {
    let (harmonic, part) = (card.get(&HARMONIC), card.get(&PART));
    let (harmonic, part) = (harmonic?, part?);
    if harmonic == 0 {
        if card.has(&PART) {
            card.note(&PART, &TrimProblem::PartOfMean);
            return None;
        }
        return Some(None);
    }
    if method == TrimMethod::Equilibrium {
        card.note(&HARMONIC, &TrimProblem::Harmonic { harmonic });
        return None;
    }
    let periodic = periodic?;
    let steps = periodic.steps;
    if 2 * harmonic >= steps {
        card.note(&HARMONIC, &TrimProblem::Aliased { harmonic, steps });
        return None;
    }
    let fundamental = periodic.speed.map_or(TAU / periodic.period, f64::abs);
    Some(Some(Wave {
        frequency: harmonic as f64 * fundamental,
        from: periodic.start.from,
        is_sine: part == 1,
    }))
}

/// Adds the elements of all pairs to the model, and their names to the settings.
pub(super) fn add(
    pairs: impl Iterator<Item = (Named, Asked)>,
    settings: &mut TrimSettings,
    builder: &mut ModelBuilder,
) {
    let (mut targets, mut of_parameters) = (Vec::new(), Vec::new());
    for (named, asked) in pairs {
        let Asked {
            target,
            signal,
            wave,
        } = asked;
        let quantity = match settings.method {
            TrimMethod::Equilibrium => reading(&target, signal, builder),
            _ => integral(&target, (signal, wave), builder),
        };
        let Some(state) = named.state else {
            settings.parameters.push(named.control);
            settings.guesses.push(named.guess);
            of_parameters.push(target);
            continue;
        };
        let control = (state, named.guess);
        builder.add_control(match settings.method {
            TrimMethod::Equilibrium => {
                let required = [target.value, target.scale];
                Box::new(Balanced::new(control, quantity, required))
            }
            _ => Box::new(Kept::control(control.0, control.1)),
        });
        settings.controls.push(named.control);
        targets.push(target);
    }
    targets.extend(of_parameters);
    settings.targets = targets;
}

/// Adds the integral of a signal; returns its unknown.
fn integral(
    target: &TrimTarget,
    (signal, wave): (Signal, Option<Wave>),
    builder: &mut ModelBuilder,
) -> Scalar {
    let start = ScalarStart::Value(0.0);
    let state = Kept::state(&target.label, &target.name, start, target.scale);
    builder.add_control(Box::new(Kept::integral(state.clone(), vec![signal], wave)));
    state
}

/// Adds the value of a signal as an unknown, which is returned.
fn reading(target: &TrimTarget, signal: Signal, builder: &mut ModelBuilder) -> Scalar {
    let output = StateSpace::output(&target.label, &target.name);
    let gain = Matrices::gain(DMatrix::identity(1, 1));
    let outputs = vec![output.clone()];
    let element = StateSpace::new(&target.label, gain, vec![signal], outputs, &[]);
    builder.add_control(Box::new(element));
    output
}
