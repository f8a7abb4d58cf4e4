//! Heat and other imposed strains of beams: `temperature = DRIVE` and
//! `imposed = { NAME = DRIVE }` on the card of properties, of a beam or of a blade.
//!
//! ```text
//! theta = K psi + thermal_force T(t) + sum restrained_force_i c_i(t)                (D-250)
//! ```
//!
//! Prestressed sections also take the effect of each state on their stiffness, (D-252).
//!
//! Without these keys nothing is heated, whatever the property file contains.

use shared_geom::document::schema::KeySchema;
use shared_geom::document::schema::ValueKind::{Drive as OneDrive, NamedDrives};
use shared_geom::document::{ByHand, Table};
use shared_geom::error::{Explain, nearest_name};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::beam_section::{Acting, Heat, Properties, TEMPERATURE};
use super::drives::{self, Catalog};
use super::number::short_number;
use crate::elements::laws::Driven;
use crate::elements::{Instant, Signal};
use crate::model::Drive;

keys! {
    /// Uniform rise of temperature; needs the thermal force of the properties.
    TEMPERATURE_RISE: ByHand = "temperature", [OneDrive(Dimension::TEMPERATURE)], optional, "50";
    /// Factors of the named imposed states of the property file.
    IMPOSED: ByHand = "imposed", [NamedDrives(Dimension::NUMBER)], optional, "{ cure = 1 }";
}

/// The keys of heat, for the descriptions of cards that have them.
pub(super) const HEAT: [KeySchema; 2] = [TEMPERATURE_RISE.schema, IMPOSED.schema];

/// The keys, as cards have them.
const KEYS: [&str; 2] = [TEMPERATURE_RISE.name(), IMPOSED.name()];

/// Number of cards that are named.
const MOST_CARDS: usize = 3;
/// Digits of temperatures and factors.
const DIGITS: usize = 6;
/// A problem of heat.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum HeatProblem {
    /// A temperature for properties without thermal forces.
    #[error("{user} has a \"temperature\", but its properties have no \"thermal_force\"")]
    NoThermalForce {
        /// The heated part, as text.
        user: String,
    },
    /// A state that the properties do not have.
    #[error("unknown imposed state \"{name}\" in {user}")]
    UnknownState {
        /// The name.
        name: String,
        /// The user of the state, as text.
        user: String,
        /// The states of the properties.
        known: Vec<String>,
    },
    /// Heat on a part without named properties.
    #[error("{user} has \"{key}\", which needs properties with a name")]
    NoProperties {
        /// The heated part, as text.
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
                 \"thermal_force\", six numbers, next to the stiffnesses of the card"
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
                    None => format!("states of the properties: {}", known.join(", ")),
                }
            }
            Self::NoProperties { .. } => {
                "blade files and laws have no thermal forces: use pieces or beams whose \
                 properties are property files, or a prestress in the law"
                    .to_owned()
            }
        })
    }
}

/// Remarks on heat and imposed strains of beams, a line for all cards with the same states:
/// the values at time zero.
pub(super) fn reported<'a>(beams: impl Iterator<Item = &'a [Acting]>) -> Vec<String> {
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

/// A remark on the effect of heat and imposed strains on the stiffness of beams that do not
/// use tables of prestress; given are the states of each of these beams.
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
            "the effect of heat and imposed strains of {card} on the stiffness is ignored, as the \
             table of prestress of the property file is not used: add prestress = true"
        )
    };
    cards.into_iter().map(remark).collect()
}

/// Whether two states are equal except for the names of the cards.
fn same(a: &[Acting], b: &[Acting]) -> bool {
    let pairs = || a.iter().zip(b);
    a.len() == b.len() && pairs().all(|(a, b)| a.name == b.name && a.force == b.force)
}

fn line((cards, acting): &(Vec<&str>, &[Acting])) -> String {
    let state = |state: &Acting| {
        let now = short_number(state.force.signal.value(&Instant::START), DIGITS);
        let when = match &state.force.signal {
            Signal::Drive(Drive::Constant(_)) => "",
            Signal::Drive(_) => " at time zero",
            Signal::Sensing { .. } => " while all its inputs are zero",
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

/// Whether a card has a key of heat.
pub(super) fn is_given(table: &Table<'_>) -> bool {
    // Both are read, so that neither is reported as unknown.
    let given = KEYS.map(|key| table.has(key));
    given.contains(&true)
}

/// The properties with the heat of a card, described by `user`, in place of the heat of the
/// previous card; unchanged if the card has none. Problems are noted.
pub(super) fn read(
    table: &Table<'_>,
    properties: Option<Properties>,
    drives: &Catalog,
    user: &str,
) -> Option<Properties> {
    if !is_given(table) {
        return properties;
    }
    // Without properties the names cannot be looked up, and the problems of the properties
    // have been reported.
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
    if table.has(&TEMPERATURE_RISE) {
        let signal = drives::read_signal(table, &TEMPERATURE_RISE.schema, drives);
        match heat.thermal_force {
            Some(vector) => found.push(signal.map(|signal| Acting {
                card: user.to_owned(),
                name: TEMPERATURE.to_owned(),
                force: Driven { vector, signal },
                stiffness: heat.stiffness_per_kelvin,
            })),
            None => {
                let user = user.to_owned();
                table.note(&TEMPERATURE_RISE, &HeatProblem::NoThermalForce { user });
                found.push(None);
            }
        }
    }
    if table.has(&IMPOSED) {
        match table.table(&IMPOSED) {
            Some(inner) => found.extend(states(&inner, heat, drives, user)),
            None => found.push(None),
        }
    }
    // All states are read before the first wrong one ends the function.
    found.into_iter().collect()
}

/// The states of `imposed = { NAME = DRIVE }`; wrong states are `None`.
fn states(table: &Table<'_>, heat: &Heat, drives: &Catalog, user: &str) -> Vec<Option<Acting>> {
    let names = table.keys();
    let state = |name: &String| {
        let item = table.item(name)?;
        let signal = drives::signal_of(&item, IMPOSED.schema.dimension(), drives);
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

/// Notes heat on a card without named properties; `None` if there is any.
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
