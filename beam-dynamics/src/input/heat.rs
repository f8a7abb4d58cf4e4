//! Heat and other imposed strains of beams: `temperature = DRIVE` and
//! `imposed = { NAME = DRIVE }` on the card of properties, of a beam or of a blade.
//!
//! ```text
//! theta = K psi + thermal_force T(t) + sum restrained_force_i c_i(t)                (D-250)
//! ```
//!
//! Prestressed sections take what each state does to their stiffness too, (D-252).
//!
//! Without these keys nothing is heated, whatever the property file says.

use shared_geom::document::Table;
use shared_geom::error::{Explain, nearest_name};
use shared_geom::units::Dimension;

use super::beam_section::{Acting, Heat, Properties, TEMPERATURE};
use super::drives::{self, Catalog};
use super::number::short_number;
use crate::elements::laws::Driven;
use crate::elements::{Instant, Signal};
use crate::model::Drive;

/// The keys, as cards have them.
const KEYS: [&str; 2] = ["temperature", "imposed"];

/// Cards that are named.
const MOST_CARDS: usize = 3;
/// Digits of temperatures and factors.
const DIGITS: usize = 6;
/// A problem of heat.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum HeatProblem {
    /// A temperature where nothing is known of expansion.
    #[error("{user} has a \"temperature\", but its properties have no \"thermal_force\"")]
    NoThermalForce {
        /// What is heated, in words.
        user: String,
    },
    /// A state that the properties do not have.
    #[error("unknown imposed state \"{name}\" in {user}")]
    UnknownState {
        /// The name found.
        name: String,
        /// What uses it, in words.
        user: String,
        /// The states of the properties.
        known: Vec<String>,
    },
    /// Heat on what has no properties that could know of it.
    #[error("{user} has \"{key}\", which needs properties with a name")]
    NoProperties {
        /// What is heated, in words.
        user: String,
        /// The key.
        key: &'static str,
    },
}

impl Explain for HeatProblem {
    fn help(&self) -> Option<String> {
        Some(match self {
            Self::NoThermalForce { .. } => {
                "give the materials of the section an \"expansion\" and analyze it again, or write \
                 \"thermal_force\", six numbers, beside stiffnesses given in place"
                    .to_owned()
            }
            Self::UnknownState { name, known, .. } => {
                match nearest_name(name, known.iter().map(String::as_str)) {
                    Some(near) => format!("did you mean \"{near}\"?"),
                    None if known.is_empty() => {
                        "the property file has none: add [temperature.NAME] or \
                         [initial_strain.NAME] to the section file"
                            .to_owned()
                    }
                    None => format!("those of the properties: {}", known.join(", ")),
                }
            }
            Self::NoProperties { .. } => {
                "blade files and laws do not carry thermal forces: use pieces or beams whose \
                 properties are property files, or a prestress in the law"
                    .to_owned()
            }
        })
    }
}

/// What acts on beams, a line for all cards on which the same acts: the values at the time
/// zero.
pub(super) fn told<'a>(beams: impl Iterator<Item = &'a [Acting]>) -> Vec<String> {
    let mut known: Vec<(Vec<&str>, &[Acting])> = Vec::new();
    for acting in beams {
        let Some(first) = acting.first() else {
            continue;
        };
        match known.iter_mut().find(|known| same(known.1, acting)) {
            Some((cards, _)) if cards.contains(&first.card.as_str()) => {}
            Some((cards, _)) => cards.push(&first.card),
            None => known.push((vec![&first.card], acting)),
        }
    }
    known.iter().map(line).collect()
}

/// A remark on what heat and imposed strains would do to the stiffness of beams that do not
/// use tables of prestress; given is what acts on each of these.
pub(super) fn unused_stiffness<'a>(beams: impl Iterator<Item = &'a [Acting]>) -> Vec<String> {
    let mut cards: Vec<&str> = Vec::new();
    let acting = beams.flatten().filter(|state| state.stiffness.is_some());
    for state in acting {
        if !cards.contains(&state.card.as_str()) {
            cards.push(&state.card);
        }
    }
    let remark = |card: &str| {
        format!(
            "what heat and imposed strains of {card} do to the stiffness is left out, as the table \
             of prestress of the property file is not used: add prestress = true"
        )
    };
    cards.into_iter().map(remark).collect()
}

/// Whether the same acts, whatever the cards are called.
fn same(a: &[Acting], b: &[Acting]) -> bool {
    let pairs = || a.iter().zip(b);
    a.len() == b.len() && pairs().all(|(a, b)| a.name == b.name && a.force == b.force)
}

fn line((cards, acting): &(Vec<&str>, &[Acting])) -> String {
    let state = |state: &Acting| {
        let now = short_number(state.force.signal.value(&Instant::START), DIGITS);
        let when = match &state.force.signal {
            Signal::Drive(Drive::Constant(_)) => "",
            Signal::Drive(_) => " at the time zero",
            Signal::Sensing { .. } => " while all that it reads is zero",
        };
        match state.name.as_str() {
            TEMPERATURE => format!("temperature {now} K{when}"),
            name => format!("\"{name}\" times {now}{when}"),
        }
    };
    let states: Vec<_> = acting.iter().map(state).collect();
    let more = match cards.len().saturating_sub(MOST_CARDS) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    let cards = cards.iter().take(MOST_CARDS).copied().collect::<Vec<_>>();
    format!(
        "heat and imposed strains of {}{more}: {}",
        cards.join("; "),
        states.join(", ")
    )
}

/// Whether a card says anything about heat.
pub(super) fn is_given(table: &Table<'_>) -> bool {
    // Both are asked for, so that none of them counts as unknown.
    let given = KEYS.map(|key| table.has(key));
    given.contains(&true)
}

/// The properties under the heat of a card, `user` in words, in place of that of the card
/// before; as they are where the card says nothing. What is wrong is noted.
pub(super) fn read(
    table: &Table<'_>,
    properties: Option<Properties>,
    drives: &Catalog,
    user: &str,
) -> Option<Properties> {
    if !is_given(table) {
        return properties;
    }
    // Without properties the names cannot be looked up, and what is wrong with the
    // properties has been told.
    let properties = properties?;
    let acting = acting(table, &properties.heat, drives, user)?;
    Some(Properties {
        heat: Heat {
            acting,
            ..properties.heat
        },
        ..properties
    })
}

fn acting(table: &Table<'_>, heat: &Heat, drives: &Catalog, user: &str) -> Option<Vec<Acting>> {
    let mut found = Vec::new();
    if table.has("temperature") {
        let signal = drives::read_signal(table, "temperature", Dimension::TEMPERATURE, drives);
        match heat.thermal_force {
            Some(vector) => found.push(signal.map(|signal| Acting {
                card: user.to_owned(),
                name: TEMPERATURE.to_owned(),
                force: Driven { vector, signal },
                stiffness: heat.stiffness_per_kelvin,
            })),
            None => {
                let user = user.to_owned();
                table.note("temperature", &HeatProblem::NoThermalForce { user });
                found.push(None);
            }
        }
    }
    if table.has("imposed") {
        match table.table("imposed") {
            Some(inner) => found.extend(states(&inner, heat, drives, user)),
            None => found.push(None),
        }
    }
    // Every state is read before the first wrong one ends the reading.
    found.into_iter().collect()
}

/// The states of `imposed = { NAME = DRIVE }`; those that are wrong are `None`.
fn states(table: &Table<'_>, heat: &Heat, drives: &Catalog, user: &str) -> Vec<Option<Acting>> {
    let names = table.keys();
    let state = |name: &String| {
        let signal = drives::read_signal(table, name, Dimension::NUMBER, drives);
        let known = heat.imposed.iter().find(|state| state.name == *name);
        let Some(state) = known else {
            let problem = HeatProblem::UnknownState {
                name: name.clone(),
                user: user.to_owned(),
                known: heat
                    .imposed
                    .iter()
                    .map(|state| state.name.clone())
                    .collect(),
            };
            table.note(name, &problem);
            return None;
        };
        Some(Acting {
            card: user.to_owned(),
            name: name.clone(),
            force: Driven {
                vector: state.restrained_force,
                signal: signal?,
            },
            stiffness: state.stiffness_change,
        })
    };
    names.iter().map(state).collect()
}

/// Notes heat on a card without named properties; `None` where there is any.
pub(super) fn refuse_without_properties(table: &Table<'_>, user: &str) -> Option<()> {
    let mut is_free = Some(());
    for key in KEYS {
        if table.has(key) {
            let user = user.to_owned();
            table.note(key, &HeatProblem::NoProperties { user, key });
            is_free = None;
        }
    }
    is_free
}
