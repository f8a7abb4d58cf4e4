//! Electrodes of piezoelectric beams and their circuits: `[[electrode]]`.
//!
//! ```text
//! voltage = DRIVE                             held
//! charge = NUMBER                             open circuit
//! resistance, inductance, voltage = DRIVE     a source, or ground, through both
//! ```

use nalgebra::DMatrix;
use shared_geom::document::schema::ValueKind::{Drive as OneDrive, NotNegative, Quantity, Text};
use shared_geom::document::schema::{Family, TableSchema};
use shared_geom::document::{ByHand, Table};
use shared_geom::error::{Explain, nearest_name};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::builder::{ElectrodeCard, ModelBuilder, electrode_names};
use super::drives;
use super::ends::label;
use super::loads::{BEAMS, BLADE, beams};
use crate::elements::circuits::Circuit;
use crate::model::Drive;

/// An electrode and its circuit.
pub(super) const CARD: TableSchema = TableSchema {
    title: "[[electrode]]",
    meaning: "An electrode of the property file over all beams of a blade, or over named beams, \
              and its circuit.",
    keys: &[NAME.schema, ELECTRODE.schema, BLADE.schema, BEAMS.schema],
    families: &[
        Family {
            name: "open",
            meaning: "Not connected: the charge is held, and the voltage follows.",
            keys: &[CHARGE.schema],
        },
        Family {
            name: "connected",
            meaning: "At the voltage of a source, directly or through resistance and inductance; \
                      at least one key.",
            keys: &[VOLTAGE.schema, RESISTANCE.schema, INDUCTANCE.schema],
        },
    ],
};

keys! {
    /// The name of the electrode, used by columns and reports.
    NAME: Option<String> = "name", [Text], or "`electrode` and its number", "\"afc\"";
    /// Its name in the property file.
    ELECTRODE: Option<String> = "electrode", [Text], or "`name`", "\"sensor\"";
    /// Held charge; zero is the charge of the undeformed beams without voltage.
    CHARGE: f64 = "charge", [Quantity(Dimension::CHARGE)], required, "0";
    /// Voltage of the source relative to ground.
    VOLTAGE: ByHand = "voltage", [OneDrive(Dimension::VOLTAGE)], or "0", "\"= 250*sin(20*t)\"";
    /// Resistance in series.
    RESISTANCE: f64 = "resistance", [NotNegative(Dimension::RESISTANCE)], or "0" = 0.0,
        "\"20 kOhm\"";
    /// Inductance in series.
    INDUCTANCE: f64 = "inductance", [NotNegative(Dimension::INDUCTANCE)], or "0" = 0.0,
        "\"40 H\"";
}

/// Keys of a circuit without a prescribed charge.
const OF_SOURCE: [&str; 3] = [VOLTAGE.name(), RESISTANCE.name(), INDUCTANCE.name()];

/// A problem of an electrode.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ElectrodeProblem {
    /// A beam without electrodes.
    #[error(
        "beam \"{beam}\" of electrode \"{electrode}\" has no electrodes: its properties have no \"piezo\""
    )]
    NoPiezo {
        /// The electrode of the card.
        electrode: String,
        /// The beam.
        beam: String,
    },
    /// A name that a beam does not have.
    #[error("beam \"{beam}\" has no electrode \"{electrode}\"")]
    Unknown {
        /// The name.
        electrode: String,
        /// The beam.
        beam: String,
        /// The electrodes of the beam.
        known: Vec<String>,
    },
    /// A blade without the electrode on any beam.
    #[error("no beam of blade \"{blade}\" has an electrode \"{electrode}\"")]
    NotOnBlade {
        /// The name.
        electrode: String,
        /// The blade.
        blade: String,
        /// The electrodes of its beams.
        known: Vec<String>,
    },
    /// An electrode of a beam in two cards.
    #[error(
        "electrode \"{electrode}\" of beam \"{beam}\" belongs to \"{first}\" on {line} already, expected one card"
    )]
    Twice {
        /// Name in the property file.
        electrode: String,
        /// The beam.
        beam: String,
        /// Name of the card that has it.
        first: String,
        /// Its line, as text.
        line: String,
    },
    /// A card without a circuit.
    #[error(
        "electrode \"{electrode}\" has no circuit, expected \"voltage\", \"charge\", \"resistance\" or \"inductance\""
    )]
    NoCircuit {
        /// The electrode.
        electrode: String,
    },
    /// A prescribed charge, and a connection through which it would flow.
    #[error(
        "\"charge\" holds the charge of electrode \"{electrode}\", and \"{key}\" would let it flow, expected one of them"
    )]
    ChargeAnd {
        /// The electrode.
        electrode: String,
        /// The other key.
        key: &'static str,
    },
    /// No resistance and no inductance.
    #[error(
        "\"resistance\" of electrode \"{electrode}\" is zero, expected more than zero if there is no \"inductance\""
    )]
    NoResistance {
        /// The electrode.
        electrode: String,
    },
    /// A capacitance that is not positive.
    #[error(
        "the capacitance of electrode \"{electrode}\", {found:.6e} F with all beams of the card, is not positive"
    )]
    Capacitance {
        /// The electrode.
        electrode: String,
        /// The capacitance \[F\].
        found: f64,
    },
    /// Capacitances that are not positive definite.
    #[error(
        "the capacitances of electrodes {electrodes} are not positive definite: some voltages would give charges of the opposite sign"
    )]
    Indefinite {
        /// Names of the electrodes whose voltage is unknown.
        electrodes: String,
    },
}

impl Explain for ElectrodeProblem {
    fn help(&self) -> Option<String> {
        Some(match self {
            Self::NoPiezo { .. } => "name beams whose property file has electrodes, or analyze \
                 the section with electrodes"
                .to_owned(),
            Self::Unknown {
                electrode, known, ..
            }
            | Self::NotOnBlade {
                electrode, known, ..
            } => match nearest_name(electrode, known.iter().map(String::as_str)) {
                Some(near) => format!("did you mean \"{near}\"? write electrode = \"{near}\""),
                None if known.is_empty() => {
                    "property files with \"piezo\" have electrodes; blades \
                     from blade files have none"
                        .to_owned()
                }
                None => format!("electrodes of the property files: {}", known.join(", ")),
            },
            Self::Twice { .. } => {
                "remove the beam from one of the cards, or remove the card".to_owned()
            }
            Self::NoCircuit { .. } => "voltage = 0 connects it to ground, charge = 0 leaves it \
                 open, resistance = 1e4 is a resistor to ground"
                .to_owned(),
            Self::ChargeAnd { .. } => "without \"charge\", the charge follows from the circuit \
                 and begins with the charge at the voltage of its source"
                .to_owned(),
            Self::NoResistance { .. } => {
                "leave \"resistance\" out: the voltage is then the voltage of its source".to_owned()
            }
            Self::Capacitance { .. } | Self::Indefinite { .. } => {
                "correct \"capacitance\" in the property file, charge per length and volt at \
                 constant strain; only electrodes with a given voltage work without it"
                    .to_owned()
            }
        })
    }
}

/// Adds every `[[electrode]]` to the model.
pub(super) fn read(root: &Table<'_>, builder: &mut ModelBuilder) {
    let tables = root.tables("electrode");
    for (number, table) in tables.iter().enumerate() {
        let label = label(table, &NAME, "electrode", number);
        let is_new = builder.take_label("electrode", &label, table);
        let card = card(table, builder, label);
        table.finish();
        match card {
            Some(card) if is_new => builder.add_electrode(card),
            _ => builder.note_broken(),
        }
    }
    check_capacitances(&tables, builder);
}

fn card(table: &Table<'_>, builder: &ModelBuilder, label: String) -> Option<ElectrodeCard> {
    // The name in the property file; by default the name of the card.
    let name = table.get(&ELECTRODE);
    let name = name.map(|name| name.unwrap_or_else(|| label.clone()));
    let circuit = circuit(table, builder, &label);
    let beams = beams(table, builder, &label)?;
    let on = on(table, builder, (&name?, &label), &beams)?;
    Some(ElectrodeCard {
        label,
        on,
        circuit: circuit?,
        line: table.line_of(&NAME),
    })
}

/// The beams that have an electrode, with its column; a beam that is named explicitly must have it.
fn on(
    table: &Table<'_>,
    builder: &ModelBuilder,
    (name, label): (&str, &str),
    beams: &[usize],
) -> Option<Vec<(usize, usize)>> {
    let names = |beam: usize| electrode_names(&builder.beams()[beam]);
    let column = |beam: usize| names(beam).iter().position(|own| own == name);
    let found = beams.iter().map(|&beam| (beam, column(beam)));
    let (mut on, mut is_sound) = (Vec::new(), true);
    let of_blade = table.has(&BLADE);
    for (beam, column) in found {
        match column {
            Some(column) => on.push((beam, column)),
            None if of_blade => {}
            None => {
                let own = builder.beams()[beam].label.clone();
                let electrode = name.to_owned();
                let problem = match names(beam) {
                    [] => ElectrodeProblem::NoPiezo {
                        electrode: label.to_owned(),
                        beam: own,
                    },
                    known => ElectrodeProblem::Unknown {
                        electrode,
                        beam: own,
                        known: known.to_vec(),
                    },
                };
                table.note(&BEAMS, &problem);
                is_sound = false;
            }
        }
    }
    if on.is_empty() && of_blade {
        let mut known: Vec<_> = beams
            .iter()
            .flat_map(|&beam| names(beam))
            .cloned()
            .collect();
        known.sort();
        known.dedup();
        let (electrode, blade) = (name.to_owned(), table.get(&BLADE)??);
        let problem = ElectrodeProblem::NotOnBlade {
            electrode,
            blade,
            known,
        };
        table.note(&BLADE, &problem);
        return None;
    }
    (is_sound && is_first(table, builder, name, &on)).then_some(on)
}

/// Whether no other card has the electrode of one of the beams; otherwise notes the first.
fn is_first(table: &Table<'_>, builder: &ModelBuilder, name: &str, on: &[(usize, usize)]) -> bool {
    let mut others = builder.electrodes().iter();
    let twice = others.find_map(|card| {
        let shared = on.iter().find(|own| card.on.contains(own))?;
        Some((card, shared.0))
    });
    let Some((card, beam)) = twice else {
        return true;
    };
    let problem = ElectrodeProblem::Twice {
        electrode: name.to_owned(),
        beam: builder.beams()[beam].label.clone(),
        first: card.label.clone(),
        line: table.document().line_words(card.line),
    };
    table.note(&ELECTRODE, &problem);
    false
}

fn circuit(table: &Table<'_>, builder: &ModelBuilder, label: &str) -> Option<Circuit> {
    let electrode = label.to_owned();
    let given = OF_SOURCE.map(|key| table.has(key));
    if table.has(&CHARGE) {
        let charge = table.get(&CHARGE);
        if let Some(other) = given.iter().position(|given| *given) {
            let key = OF_SOURCE[other];
            table.note(key, &ElectrodeProblem::ChargeAnd { electrode, key });
            return None;
        }
        return charge.map(|charge| Circuit::Open { charge });
    }
    if given == [false; 3] {
        table.note(&NAME, &ElectrodeProblem::NoCircuit { electrode });
        return None;
    }
    let source = if given[0] {
        drives::read_signal(table, &VOLTAGE.schema, builder.drives())
    } else {
        Some(Drive::Constant(0.0).into())
    };
    let (resistance, inductance) = (table.get(&RESISTANCE), table.get(&INDUCTANCE));
    let (source, resistance, inductance) = (source?, resistance?, inductance?);
    if given == [true, false, false] {
        return Some(Circuit::Held(source));
    }
    if resistance == 0.0 && inductance == 0.0 {
        let key = if given[1] { "resistance" } else { "inductance" };
        table.note(key, &ElectrodeProblem::NoResistance { electrode });
        return None;
    }
    Some(Circuit::Shunt {
        source,
        resistance,
        inductance,
    })
}

/// Notes electrodes whose voltage does not follow from their charge.
fn check_capacitances(tables: &[Table<'_>], builder: &mut ModelBuilder) {
    let cards = builder.electrodes().iter();
    let free = cards.filter(|card| card.circuit.has_unknowns());
    let free: Vec<_> = free.collect();
    if free.is_empty() {
        return;
    }
    let table = |card: &ElectrodeCard| {
        let mut tables = tables.iter();
        tables.find(|table| table.line_of(&NAME) == card.line)
    };
    let mut is_sound = true;
    for card in &free {
        let found = builder.capacitance(card, card);
        if found > 0.0 {
            continue;
        }
        is_sound = false;
        let electrode = card.label.clone();
        if let Some(table) = table(card) {
            table.note(&NAME, &ElectrodeProblem::Capacitance { electrode, found });
        }
    }
    let matrix = DMatrix::from_fn(free.len(), free.len(), |i, j| {
        let own = |k: usize| builder.capacitance(free[k], free[k]);
        builder.capacitance(free[i], free[j]) / (own(i) * own(j)).sqrt()
    });
    if is_sound && matrix.cholesky().is_none() {
        let names = free.iter().map(|card| format!("\"{}\"", card.label));
        let electrodes = names.collect::<Vec<_>>().join(", ");
        if let Some(table) = free.first().and_then(|card| table(card)) {
            table.note(&NAME, &ElectrodeProblem::Indefinite { electrodes });
        }
        is_sound = false;
    }
    if !is_sound {
        builder.note_broken();
    }
}
