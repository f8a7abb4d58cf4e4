//! Heat and other imposed strains of beams: `temperature = DRIVE` and
//! `imposed = { NAME = DRIVE }` on the card of properties, of a beam or of a blade.
//!
//! ```text
//! theta = K psi + thermal_force T(t) + sum restrained_force_i c_i(t)                (D-250)
//! ```
//!
//! Without these keys nothing is heated, whatever the property file says.

use nalgebra::Vector6;
use shared_geom::document::Table;
use shared_geom::error::{Explain, nearest_name};
use shared_geom::section::{ImposedState, SectionProperties};
use shared_geom::units::Dimension;

use super::drives::{self, Catalog};
use super::properties::Properties;
use crate::elements::laws::Driven;

/// The keys, as cards have them.
const KEYS: [&str; 2] = ["temperature", "imposed"];

/// What heat and imposed strains do to a section.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Heat {
    /// Internal force per kelvin when held \[N/K, N m/K\]; `None` where it is not known.
    thermal_force: Option<Vector6<f64>>,
    /// Named states.
    imposed: Vec<ImposedState>,
    /// What acts, of the card that was read last.
    acting: Vec<Driven<6>>,
}

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

impl Heat {
    /// What is known of a section.
    pub fn of(properties: &SectionProperties) -> Self {
        Self {
            thermal_force: properties.thermal_force,
            imposed: properties.imposed.clone(),
            acting: Vec::new(),
        }
    }

    /// What acts: forces that are held, times drives.
    pub fn acting(&self) -> &[Driven<6>] {
        &self.acting
    }
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

fn acting(table: &Table<'_>, heat: &Heat, drives: &Catalog, user: &str) -> Option<Vec<Driven<6>>> {
    let mut found = Vec::new();
    if table.has("temperature") {
        let drive = drives::read(table, "temperature", Dimension::TEMPERATURE, drives);
        match heat.thermal_force {
            Some(vector) => found.push(drive.map(|drive| Driven { vector, drive })),
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
fn states(table: &Table<'_>, heat: &Heat, drives: &Catalog, user: &str) -> Vec<Option<Driven<6>>> {
    let names = table.keys();
    let state = |name: &String| {
        let drive = drives::read(table, name, Dimension::NUMBER, drives);
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
        Some(Driven {
            vector: state.restrained_force,
            drive: drive?,
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
