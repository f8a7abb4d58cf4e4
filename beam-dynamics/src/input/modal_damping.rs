//! Damping ratios of modes that are given: `damping_ratio` of `[modes]`.

use shared_geom::document::schema::ValueKind::{Named, Quantities};
use shared_geom::document::{ByHand, Table};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::problem::InputProblem;
use crate::case::{ModalDamping, Words};
use crate::result::ModeKind;

keys! {
    /// Damping ratios from 0 to below 1 that replace the model's: one for all modes, a list in the
    /// order of the modes at the first speed, or by the names of the modes.
    pub(super) RATIO: ByHand = "damping_ratio",
        [Quantities(Dimension::NUMBER), Named(Dimension::NUMBER)], or "damping of the model",
        "{ \"flap 1\" = 0.01, \"lag 1\" = 0.004 }";
}

const KEY: &str = RATIO.name();

/// Reads the key; `None` if it is wrong.
pub(super) fn read(modes: &Table<'_>) -> Option<ModalDamping> {
    if !modes.has(KEY) {
        return Some(ModalDamping::Found);
    }
    if modes.is_table(KEY) {
        return by_name(&modes.table(KEY)?);
    }
    let ratios = modes.quantities(KEY, Dimension::NUMBER)?;
    let wrong = ratios.iter().find(|ratio| !is_ratio(**ratio));
    if let Some(&found) = wrong {
        let name = KEY.to_owned();
        modes.note(KEY, &InputProblem::NoRatio { name, found });
        return None;
    }
    // One number applies to all modes, a list of one to the first.
    Some(match (modes.is_list(KEY), &ratios[..]) {
        (false, [all]) => ModalDamping::All(*all),
        _ => ModalDamping::ByOrder(ratios),
    })
}

fn by_name(table: &Table<'_>) -> Option<ModalDamping> {
    let mut ratios = Vec::new();
    let mut sound = true;
    for name in table.keys() {
        let ratio = table.quantity(&name, Dimension::NUMBER);
        match ratio {
            Some(found) if !is_ratio(found) => {
                let name = name.clone();
                table.note(name.clone(), &InputProblem::NoRatio { name, found });
                sound = false;
            }
            Some(ratio) => ratios.push((name.clone(), ratio)),
            None => sound = false,
        }
        if !begins_with_kind(&name) {
            table.note(&name, &InputProblem::NoModeName { name: name.clone() });
            sound = false;
        }
    }
    sound.then_some(ModalDamping::ByName(ratios))
}

/// Whether a number is the damping ratio of an oscillation.
fn is_ratio(number: f64) -> bool {
    (0.0..1.0).contains(&number)
}

/// Whether a name begins with a kind of mode.
fn begins_with_kind(name: &str) -> bool {
    let others = [
        ModeKind::Coupled,
        ModeKind::Lateral,
        ModeKind::ForeAft,
        ModeKind::SideSide,
    ];
    let others = others.map(ModeKind::word);
    let mut kinds = ModeKind::PURE
        .iter()
        .map(|kind| kind.word())
        .chain(others)
        .chain([ModeKind::Lag.word_in(Words::Wind)]);
    kinds.any(|kind| {
        name.strip_prefix(kind)
            .is_some_and(|rest| rest.starts_with(' '))
    })
}
