//! Rotors: `[[rotor]]`, a card that expands to others.
//!
//! The cards to which it expands are appended to the document before any card is read, so that
//! a rotor has no physics of its own; the same cards in a file give the same results.

use std::f64::consts::TAU;

use nalgebra::{Matrix3, Vector3};
use shared_geom::document::{Card, Document, Table};
use shared_geom::error::Diagnostics;

use super::analyses::Analyses;
use super::builder::ModelBuilder;
use super::declare;
use super::hub::{HUB, Hub};
use super::periodic;
use super::rotor_speed::{RPM, SAME_SPEED};
use super::schema::DYNAMICS_FILE;
use crate::case::{PeriodicSettings, StabilityMethod, Start, TransientSettings, Words};

mod arms;
mod base;
mod card;
mod context;
mod controls;
mod damper;
mod damper_keys;
mod damper_law;
mod damper_parts;
mod distributor;
mod flexbeam;
mod flexbeam_keys;
mod flexbeam_parts;
mod held_pitch;
mod hubs;
mod keys;
mod mounts;
mod parts;
mod pitch;
mod plate;
mod problem;
mod run_problem;
mod shaft;
mod shaft_parts;
mod speeds;
mod stops;
mod train;
mod train_keys;
mod train_parts;

#[cfg(test)]
mod tests;

pub(super) use keys::CARD;
pub use problem::RotorProblem;
pub use run_problem::RotorRunProblem;

use card::Rotor;
use context::Context;
use held_pitch::HeldPitch;

/// The key of the cards.
const KEY: &str = "rotor";
/// Difference of axes, and part of the size of the model, below which axes are the same.
const SAME_AXIS: f64 = 1e-9;

/// Part of the turns by which a first instant that is written with fewer digits than the speed may be off: half
/// a thousandth of a degree in the first turn.
const WRITTEN: f64 = 1.5e-6;

/// Least number of blades of averaged coefficients.
const LEAST_AVERAGED: usize = 3;

/// A rotor of an input, for checks of its analyses.
#[derive(Debug, Clone)]
pub(super) struct PlacedRotor {
    name: String,
    line: usize,
    center: Vector3<f64>,
    axes: Matrix3<f64>,
    /// Its speed, if it is constant [rad/s].
    speed: Option<f64>,
    /// The key of a part of its drive that has no state of steady rotation, if there is one.
    unsteady: Option<&'static str>,
    /// The node that carries its shaft, as of a tower, if there is one.
    carrier: Option<String>,
    /// Whether a nacelle carries its shaft.
    has_nacelle: bool,
    /// Number of its blades.
    blades: usize,
    /// Whether its blades have strips in the air.
    has_air: bool,
    /// Whether its drive has a free wheel.
    has_free_wheel: bool,
    /// Required speed of its governor, if it has one \[rad/s\].
    governed: Option<f64>,
    /// Speed that the file gives \[rad/s\].
    initial: Option<f64>,
    /// Speed at the time zero of an angle that is an expression of time \[rad/s\].
    turning: Option<f64>,
    /// The pitch that analyses without time hold.
    held: Option<HeldPitch>,
}

impl PlacedRotor {
    /// Lines of the keys of its pitch.
    pub fn pitch_lines(&self) -> &[usize] {
        self.held.as_ref().map_or(&[], HeldPitch::lines)
    }
}

/// The rotors of an input, or the names of those that could not be expanded.
pub(super) type Rotors = Result<Vec<PlacedRotor>, Vec<String>>;

/// Words for remarks on the operation of rotors: the given ones, or the ones of turbines if there is a nacelle.
pub(super) fn words(rotors: &Rotors, given: Words) -> Words {
    let mut all = rotors.iter().flatten();
    match all.any(|rotor| rotor.has_nacelle) {
        true => Words::Wind,
        false => given,
    }
}

/// Appends the cards of all rotors. If one is wrong, which has been noted, the names of the rotors whose
/// cards are missing: the cards of a rotor with wrong controls are appended too. Drives that are `inputs` of a linear model are
/// scalars, which only expressions read.
pub(super) fn expand(document: &mut Document, inputs: &[String]) -> Rotors {
    let Some((rotors, is_sound)) = read(document, inputs) else {
        return Err(names(document));
    };
    document.append(rotors.iter().flat_map(|(_, cards)| cards));
    let place = |rotor: Rotor| PlacedRotor {
        has_nacelle: rotor.has_nacelle(),
        carrier: rotor.base.carrier.clone(),
        blades: rotor.base.count,
        has_air: rotor.has_air(),
        name: rotor.base.name,
        line: rotor.base.line,
        center: rotor.center,
        axes: rotor.axes,
        speed: rotor.shaft.constant_speed(),
        unsteady: rotor.shaft.unsteady(),
        has_free_wheel: rotor.shaft.has_free_wheel(),
        governed: rotor.shaft.governed(),
        initial: rotor.shaft.given,
        turning: rotor.shaft.turning,
        held: rotor.held,
    };
    let placed = rotors.into_iter().map(|(rotor, _)| place(rotor));
    is_sound.then(|| placed.collect()).ok_or_else(Vec::new)
}

/// The rotors of constant speed, by name \[rad/s\]; `None` if one is wrong.
pub(super) fn turning(rotors: &Rotors) -> Option<Vec<(&str, f64)>> {
    let rotors = rotors.as_deref().ok()?.iter();
    let turning = rotors.filter_map(|rotor| Some((rotor.name.as_str(), rotor.speed?)));
    Some(turning.collect())
}

/// Notes `[stability]` by averaged coefficients if a rotor, or the model, has too few blades.
pub(super) fn check_averaged(
    root: &Table<'_>,
    rotors: &Rotors,
    builder: &ModelBuilder,
    analyses: &Analyses,
) {
    let own = analyses.stability.as_ref();
    let is_averaged = own.is_some_and(|own| own.method == StabilityMethod::Averaged);
    let is_whole = !builder.has_broken_rotors();
    let (true, Ok(rotors)) = (is_averaged && is_whole, rotors) else {
        return;
    };
    let of_rotors = rotors.iter().map(|rotor| {
        let subject = format!("rotor \"{}\"", rotor.name);
        (subject, rotor.blades)
    });
    let mut all = of_rotors.chain([("the model".to_owned(), builder.blades().len())]);
    let few = all.find(|(_, blades)| *blades < LEAST_AVERAGED);
    if let Some(((subject, blades), table)) = few.zip(root.table("stability")) {
        table.note("by", &RotorRunProblem::FewBlades { subject, blades });
    }
}

/// The names of all rotors that have one.
fn names(document: &Document) -> Vec<String> {
    let root = document.root_of(&DYNAMICS_FILE);
    let rotors = if root.is_list(KEY) {
        root.tables(KEY)
    } else {
        Vec::new()
    };
    let named = rotors.iter().filter(|rotor| rotor.is_text(&keys::NAME));
    named
        .filter_map(|rotor| rotor.text(keys::NAME.name()))
        .collect()
}

/// The text of a file with the cards of each rotor in its place; parameters whose values are numbers in these
/// cards are named in a comment.
pub(super) fn expanded(text: &str, file: &str) -> Result<String, Diagnostics> {
    let with = |given: &[(String, f64)]| {
        let document = Document::parse_with_includes(text, file)?;
        declare(&document, &document.root_of(&DYNAMICS_FILE), given);
        let parameters = document.parameters().clone();
        let expanded = expanded_text(&document, text);
        Ok((document.finish(expanded)?, parameters))
    };
    let (expanded, parameters) = with(&[])?;
    let is_fixed = |(name, value): &&(String, f64)| {
        // Any other value of the same size.
        let other = [(name.clone(), value * 1.0137 + 1.37e-3)];
        let found: Result<_, Diagnostics> = with(&other);
        found.is_ok_and(|(other, _)| other != expanded)
    };
    let fixed = parameters.iter().filter(is_fixed);
    let fixed: Vec<_> = fixed.map(|(name, _)| format!("\"{name}\"")).collect();
    Ok(if fixed.is_empty() {
        expanded
    } else {
        let names = fixed.join(", ");
        format!(
            "# Cards of rotors have values of {names} of [parameters] as numbers, which do not follow them.\n\
             {expanded}"
        )
    })
}

/// The text of a file with the cards of each rotor in its place, with the content of all included
/// files if a rotor is in one of them, or is no table of its own; `None` if one is wrong, which has
/// been noted.
fn expanded_text(document: &Document, source: &str) -> Option<String> {
    let (rotors, is_sound) = read(document, &[])?;
    let text = |cards: &[Card]| {
        let cards: Vec<_> = cards.iter().map(ToString::to_string).collect();
        cards.join("\n")
    };
    let texts: Vec<_> = rotors.iter().map(|(_, cards)| text(cards)).collect();
    let replaced = document.replaced(source, KEY, &texts);
    let text = replaced.unwrap_or_else(|| document.joined(KEY, &texts));
    let mut speeds = rotors
        .iter()
        .filter_map(|(rotor, _)| rotor.shaft.constant_speed());
    let text = match speeds.find(|speed| *speed != 0.0) {
        Some(speed) if periodic::takes_the_rotors(&document.root_of(&DYNAMICS_FILE)) => {
            with_speed(&text, speed)
        }
        _ => text,
    };
    is_sound.then_some(text)
}

/// A text whose `[periodic]` has the speed \[rad/s\] of a rotor that it no longer has.
fn with_speed(text: &str, speed: f64) -> String {
    let line = |line: &str| match line.trim_start().starts_with("[periodic]") {
        true => format!("{line}\nspeed = \"{speed:?} rad/s\"\n"),
        false => format!("{line}\n"),
    };
    text.lines().map(line).collect()
}

/// Rotors with their cards.
type Expanded = Vec<(Rotor, Vec<Card>)>;

/// The rotors of a document, and whether all of their controls are right.
fn read(document: &Document, inputs: &[String]) -> Option<(Expanded, bool)> {
    let root = document.root_of(&DYNAMICS_FILE);
    let repeated = note_repeated(&root);
    if !root.has(KEY) {
        return (!repeated).then(|| (Vec::new(), true));
    }
    let tables = root.tables(KEY);
    let context = Context::of(&root, inputs);
    let read: Vec<_> = tables
        .iter()
        .map(|table| card::read(table, &context))
        .collect();
    let rotors: Vec<Rotor> = read.into_iter().collect::<Option<_>>()?;
    for (number, (rotor, table)) in rotors.iter().zip(&tables).enumerate() {
        let name = &rotor.base.name;
        if rotors[..number]
            .iter()
            .any(|other| other.base.name == *name)
        {
            table.note(
                &keys::NAME,
                &RotorProblem::DoubledName { name: name.clone() },
            );
            return None;
        }
    }
    let is_alone = rotors.len() == 1 && rotors.iter().all(|rotor| rotor.base.carrier.is_none());
    let has_hub = root.has("hub") || !is_alone;
    let expanded: Vec<_> = rotors
        .into_iter()
        .map(|rotor| match rotor.cards(has_hub) {
            Ok(cards) => Some((rotor, cards)),
            Err((line, problem)) => {
                document.note(line, &problem);
                None
            }
        })
        .collect();
    let expanded: Option<Vec<_>> = expanded.into_iter().collect();
    let is_complete = !repeated && tables.len() == root.row_count(KEY).unwrap_or(0);
    Some((expanded.filter(|_| is_complete)?, context.is_sound()))
}

/// Notes rotors in polar copies; whether there are some.
fn note_repeated(table: &Table<'_>) -> bool {
    if !table.is_list("repeat") {
        return false;
    }
    let repeats = table.tables("repeat");
    let found = repeats.iter().map(|repeat| {
        let has_one = repeat.has(KEY);
        if has_one {
            repeat.note(KEY, &RotorProblem::Repeated);
        }
        has_one | note_repeated(repeat)
    });
    found.fold(false, |one, other| one | other)
}

/// Problems of rotors with `[periodic]`, which concern its analyses only: rotors that are not where they were
/// after a period, or not at azimuth zero at its beginning.
pub(super) fn unrepeated(document: &Document, rotors: &Rotors, analyses: &Analyses) -> Diagnostics {
    let mut found = Diagnostics::new();
    let rotors = rotors.as_deref().unwrap_or_default();
    if let Some(periodic) = &analyses.periodic {
        let mut note =
            |line, problem: RotorRunProblem| found.push(document.location(line), &problem);
        check_period(rotors, periodic, &mut note);
        check_first_instant(rotors, ("[periodic]", &periodic.start), &mut note);
    }
    found
}

/// Notes rotors that are not where they were after a period.
fn check_period(
    rotors: &[PlacedRotor],
    periodic: &PeriodicSettings,
    note: &mut impl FnMut(usize, RotorRunProblem),
) {
    for rotor in rotors {
        if let Some(key) = rotor.unsteady {
            let name = rotor.name.clone();
            note(rotor.line, RotorRunProblem::Unsteady { name, key });
        }
        let turns = rotor.speed.unwrap_or_default() * periodic.period / TAU;
        if beyond_whole(turns, SAME_SPEED).is_some() {
            let problem = RotorRunProblem::Period {
                name: rotor.name.clone(),
                turns,
                period: periodic.period,
            };
            note(rotor.line, problem);
        }
    }
}

/// The part of a turn beyond whole turns, if it is more than a part `same` of the turns.
fn beyond_whole(turns: f64, same: f64) -> Option<f64> {
    let beyond = turns - turns.round();
    (beyond.abs() > same * turns.abs().max(1.0)).then_some(beyond)
}

/// Notes rotors that are between whole turns at the first instant of a run.
fn check_first_instant(
    rotors: &[PlacedRotor],
    (card, run): (&'static str, &TransientSettings),
    note: &mut impl FnMut(usize, RotorRunProblem),
) {
    for rotor in rotors {
        let speed = rotor.speed.filter(|speed| *speed != 0.0);
        let Some(speed) = speed else { continue };
        if let Some(beyond) = beyond_whole(speed * run.from / TAU, WRITTEN) {
            let problem = RotorRunProblem::FirstInstant {
                name: rotor.name.clone(),
                card,
                from: run.from,
                degrees: 360.0 * beyond,
                turn: TAU / speed.abs(),
            };
            note(rotor.line, problem);
        }
    }
}

/// Whether a rotor turns on a part that stands: the node of `[hub]` with a support turns with the model;
/// another one does not, also on the axis.
fn is_carried(rotor: &PlacedRotor, hub: &Hub) -> bool {
    let is_held = |node: &String| hub.moving().is_none() || node != HUB;
    rotor.carrier.as_ref().is_some_and(is_held)
}

/// Notes runs whose start turns the whole model with a part that stands; whether there are some.
pub(super) fn check_starts(
    root: &Table<'_>,
    rotors: &Rotors,
    analyses: &Analyses,
    hub: &Hub,
) -> bool {
    let rotors = rotors.as_deref().unwrap_or_default();
    let Some(carried) = rotors.iter().find(|rotor| is_carried(rotor, hub)) else {
        return false;
    };
    let of_run = analyses.transient.as_ref().map(|run| ("transient", run));
    let of_period = analyses
        .periodic
        .as_ref()
        .map(|own| ("periodic", &own.start));
    let turned = [of_run, of_period].into_iter().flatten();
    let turned = turned.filter(|(_, run)| run.rotating_speed().is_some_and(|speed| speed != 0.0));
    let mut found = false;
    for table in turned.filter_map(|(card, _)| root.table(card)) {
        let (name, carrier) = (carried.name.clone(), carried.carrier.clone());
        let carrier = carrier.unwrap_or_default();
        table.note("start", &RotorRunProblem::CarriedStart { name, carrier });
        found = true;
    }
    found
}

/// Notes rotors whose speed or axis is not the one of the turning model, that turn against their parts,
/// or that do not turn as often as a period needs. Returns remarks on speeds and on pitch that analyses
/// without time do not follow.
pub(super) fn check(
    document: &Document,
    rotors: &Rotors,
    analyses: &Analyses,
    hub: &Hub,
) -> Vec<String> {
    let rotors = rotors.as_deref().unwrap_or_default();
    if let Some(run) = &analyses.transient {
        let mut note = |line, problem: RotorRunProblem| document.note(line, &problem);
        check_first_instant(rotors, ("[transient]", run), &mut note);
    }
    check_turning(document, (rotors, hub), analyses);
    speeds::check(document, rotors, analyses);
    let of_pitch = held_pitch::check(document, rotors, analyses);
    [speeds::remarks(rotors, analyses), of_pitch].concat()
}

/// Notes rotors whose speed or axis is not the one of the turning model.
fn check_turning(document: &Document, (rotors, hub): (&[PlacedRotor], &Hub), analyses: &Analyses) {
    let starts = analyses.transient.iter().map(|run| &run.start);
    let speeds = starts.filter_map(|start| match start {
        Start::Rotating { speed } => Some(*speed),
        _ => None,
    });
    let speeds: Vec<f64> = speeds.filter(|speed| *speed != 0.0).collect();
    let turns = analyses.highest_speed() > 0.0 || !speeds.is_empty();
    let rotation = hub.frame_rotation();
    for rotor in rotors.iter().filter(|_| turns) {
        let size = rotor.center.norm().max(rotation.center.norm());
        let is_apart = hub.distance(&rotor.center) > SAME_AXIS * size
            || (rotor.axes.column(2) - rotation.axis).norm() > SAME_AXIS;
        let name = rotor.name.clone();
        if let Some(key) = rotor.unsteady {
            let name = name.clone();
            document.note(rotor.line, &RotorRunProblem::Unsteady { name, key });
        }
        let is_carried = is_carried(rotor, hub);
        // Starts of runs are noted at their line.
        if is_carried && analyses.highest_speed() == 0.0 {
            continue;
        }
        if is_apart || is_carried {
            let problem = if is_carried {
                RotorProblem::Carried { name }
            } else {
                RotorProblem::Axes { name }
            };
            document.note(rotor.line, &problem);
            continue;
        }
        let differs = |own: f64| {
            let mut speeds = speeds.iter().copied();
            speeds.find(|start| (start - own).abs() > SAME_SPEED * own.abs().max(*start))
        };
        if let Some((own, start)) = rotor.speed.and_then(|own| Some((own, differs(own)?))) {
            let [own, start] = [own, start].map(|speed| speed / RPM);
            document.note(rotor.line, &RotorProblem::Speeds { name, own, start });
        }
    }
}
