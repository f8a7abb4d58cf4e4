//! Pitch that changes with azimuth or time, which equilibria and modes hold as it is at the time zero.

use shared_geom::document::{Document, Table};
use shared_geom::error::joined;

use super::PlacedRotor;
use super::base::Base;
use super::context::Context;
use super::controls::{Control, Pitch, at_start};
use super::problem::RotorProblem;
use super::shaft::{self, Shaft};
use crate::input::analyses::Analyses;
use crate::input::short_number;

/// Digits of pitch.
const DIGITS: usize = 5;
/// Number of blades whose pitch is listed.
const MOST: usize = 6;
/// Difference of pitch below which blades have the same \[deg\].
const SAME: f64 = 1e-9;

/// Pitch of a rotor that changes with azimuth or time.
#[derive(Debug, Clone)]
pub(super) struct HeldPitch {
    /// Keys of factors of cosines and sines of the azimuth.
    cyclic: Vec<&'static str>,
    /// Keys of pitch that changes with time.
    changing: Vec<&'static str>,
    /// A number of a trim in the cyclic pitch, and its line.
    trimmed: Option<(usize, String)>,
    /// Pitch of each blade at the time zero \[deg\]; empty if it is not known.
    pitches: Vec<f64>,
    /// Lines of all keys of the pitch: the pitch of a blade is on one of them.
    lines: Vec<usize>,
}

impl HeldPitch {
    /// Of the pitch of a rotor; `None` if all of it is constant.
    pub fn of(
        pitch: Option<&Pitch>,
        (base, shaft): (&Base, &Shaft),
        (table, context): (&Table<'_>, &Context),
    ) -> Option<Self> {
        let pitch = pitch?;
        let constants = &context.constants(table.document());
        let trimmed = |control: &Control| {
            let mut names = context.guesses.iter().map(|own| &own.0);
            let name = names.find(|name| control.uses(name))?;
            Some((control.line(), name.clone()))
        };
        let acts = |control: &&Control| {
            let is_zero = control.at_start(constants) == Some(0.0);
            !is_zero || control.changes() || trimmed(control).is_some()
        };
        let cyclic: Vec<_> = pitch.cyclic().filter(acts).collect();
        let changing: Vec<_> = pitch.changing().collect();
        let held = Self {
            lines: pitch.all().map(Control::line).collect(),
            trimmed: cyclic.iter().find_map(|control| trimmed(control)),
            cyclic: keys(cyclic.into_iter()),
            changing: keys(changing.into_iter()),
            pitches: pitches(pitch, (base, shaft), constants).unwrap_or_default(),
        };
        (!held.cyclic.is_empty() || !held.changing.is_empty()).then_some(held)
    }

    /// Lines of its keys.
    pub fn lines(&self) -> &[usize] {
        &self.lines
    }
}

/// The keys of controls, each once.
fn keys<'a>(controls: impl Iterator<Item = &'a Control>) -> Vec<&'static str> {
    let mut keys = Vec::new();
    for control in controls {
        if !keys.contains(&control.key()) {
            keys.push(control.key());
        }
    }
    keys
}

/// The pitch of each blade at the time zero \[deg\], if it is known.
fn pitches(
    pitch: &Pitch,
    (base, shaft): (&Base, &Shaft),
    constants: &[(String, f64)],
) -> Option<Vec<f64>> {
    let mut constants = constants.to_vec();
    constants.push((shaft::sensor(&base.name), 0.0));
    let turned = shaft.azimuth(base).unwrap_or_else(|_| "0".to_owned());
    let of_blade = |k: usize| {
        let azimuth = format!("{turned} + {}", base.azimuth_of(k));
        let text = pitch.of_blade(k, Some(&azimuth)).text()?;
        let own = at_start(&text, &constants)?.value + pitch.built_in;
        Some((own * base.units.angle).to_degrees())
    };
    (0..base.count).map(of_blade).collect()
}

/// Remarks on pitch that analyses without time hold. Notes cyclic pitch that the trim of an equilibrium
/// should find.
pub(super) fn check(
    document: &Document,
    rotors: &[PlacedRotor],
    analyses: &Analyses,
) -> Vec<String> {
    let cards: Vec<_> = analyses
        .without_time()
        .into_iter()
        .map(|card| card.0)
        .collect();
    let turns = analyses.highest_speed() > 0.0;
    let mut remarks = Vec::new();
    for (rotor, held) in rotors
        .iter()
        .filter_map(|own| Some((own, own.held.as_ref()?)))
    {
        let of_trim = analyses.trimmed_equilibrium().and(held.trimmed.as_ref());
        if let Some((line, control)) = of_trim.filter(|_| turns) {
            let (name, control) = (rotor.name.clone(), control.clone());
            document.note(*line, &RotorProblem::HeldControl { name, control });
            continue;
        }
        let cyclic = held.cyclic.iter().filter(|_| turns);
        let mut keys: Vec<_> = cyclic.chain(&held.changing).copied().collect();
        keys.dedup();
        if !keys.is_empty() && !cards.is_empty() {
            remarks.push(remark(rotor, held, (&keys, &cards)));
        }
    }
    remarks
}

fn remark(rotor: &PlacedRotor, held: &HeldPitch, (keys, cards): (&[&str], &[&str])) -> String {
    let quoted: Vec<_> = keys.iter().map(|key| format!("\"{key}\"")).collect();
    let has = if cards.len() == 1 { "has" } else { "have" };
    let [keys, cards] = [joined(&quoted), joined(cards)];
    let pitches = match held.pitches.as_slice() {
        [] => String::new(),
        [first, others @ ..] if others.iter().all(|own| (own - first).abs() < SAME) => {
            format!(" ({} deg)", short_number(*first, DIGITS))
        }
        all => {
            let shown = all.iter().take(MOST);
            let shown: Vec<_> = shown.map(|own| short_number(*own, DIGITS)).collect();
            let more = if all.len() > MOST { ", ..." } else { "" };
            format!(" ({}{more} deg of blade 1, 2, ...)", shown.join(", "))
        }
    };
    format!(
        "the pitch of rotor \"{}\" changes with azimuth or time by {keys}: {cards} {has} it as it is \
         at the time zero{pitches}; [periodic] has the motion with it",
        rotor.name
    )
}
