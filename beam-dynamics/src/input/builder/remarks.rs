//! Remarks on a model for the user: heat and electrodes of its beams, effects that are left
//! out.

use super::{ElectrodeCard, ModelBuilder};
use crate::elements::circuits::Circuit;
use crate::elements::{Instant, Signal};
use crate::input::beam_properties::BeamProperties;
use crate::input::driven_joint::{self, DrivenJoint};
use crate::input::formulation::Inertia;
use crate::input::heat;
use crate::input::number::short_number;
use crate::model::Drive;

/// Digits of voltages.
const DIGITS: usize = 6;
/// Number of beams that are named.
const MOST_BEAMS: usize = 3;

impl ModelBuilder {
    /// Adds remarks on a file that was read.
    pub fn add_remarks(&mut self, remarks: Vec<String>) {
        self.remarks.extend(remarks);
    }

    /// Notes a driven joint.
    pub fn note_driven(&mut self, joint: DrivenJoint) {
        self.driven.push(joint);
    }

    /// Remarks on the files that were read, for a file with critical loads and with modes.
    pub fn remarks(&self, of_buckling: bool, of_modes: bool) -> Vec<String> {
        let heat = heat::reported(self.beams.iter().map(|beam| beam.properties.heat()));
        let buckling = of_buckling.then(|| self.properties.of_buckling());
        let plain = self.beams.iter().map(|beam| &beam.properties);
        let plain = plain.filter(|properties| !properties.knows_prestress());
        let stiffness = heat::unused_stiffness(plain.map(BeamProperties::heat));
        let electrodes = self.electrode_remarks();
        let masses = self.jumping_masses();
        let driven = if of_modes {
            driven_joint::remarks(&self.driven)
        } else {
            Vec::new()
        };
        let remarks = [
            self.remarks.clone(),
            driven,
            masses,
            heat,
            stiffness,
            electrodes,
        ];
        [remarks.concat(), buckling.unwrap_or_default()].concat()
    }

    /// A remark if masses jump within elements so that their bodies are found with hat
    /// functions.
    fn jumping_masses(&self) -> Vec<String> {
        let lumped = self
            .beams
            .iter()
            .filter(|beam| beam.inertia == Inertia::Lumped);
        let jumping = lumped.filter(|beam| self.lumped(beam).by_hats);
        let names: Vec<_> = jumping.map(|beam| beam.label.as_str()).collect();
        let remark = || {
            format!(
                "the mass of {} jumps within the element: its bodies at the nodes are of second \
                 order there; let an element end at the jump",
                listed(&names)
            )
        };
        (!names.is_empty()).then(remark).into_iter().collect()
    }

    /// Remarks on electrodes: their connections, and those without a card.
    pub(super) fn electrode_remarks(&self) -> Vec<String> {
        let reported = self.electrodes.iter().map(reported);
        reported.chain(self.unnamed()).collect()
    }

    /// A remark for each electrode of property files that no card names on some beams.
    fn unnamed(&self) -> Vec<String> {
        let mut found: Vec<(&str, Vec<&str>)> = Vec::new();
        for (index, beam) in self.beams.iter().enumerate() {
            let names = beam
                .properties
                .piezo
                .as_ref()
                .map(|piezo| &piezo.electrodes);
            for (column, name) in names.into_iter().flatten().enumerate() {
                let mut cards = self.electrodes.iter();
                if cards.any(|card| card.column(index) == Some(column)) {
                    continue;
                }
                match found.iter_mut().find(|own| own.0 == name) {
                    Some(own) => own.1.push(&beam.label),
                    None => found.push((name, vec![&beam.label])),
                }
            }
        }
        let remark = |(name, beams): (&str, Vec<&str>)| {
            let beams = listed(&beams);
            format!("no [[electrode]] names electrode \"{name}\" of {beams}: its voltage is zero")
        };
        found.into_iter().map(remark).collect()
    }
}

/// The first of some names, and the number of the others.
fn listed(names: &[&str]) -> String {
    let first = names.iter().take(MOST_BEAMS);
    let first: Vec<_> = first.map(|name| format!("\"{name}\"")).collect();
    match names.len().saturating_sub(MOST_BEAMS) {
        0 => first.join(", "),
        more => format!("{} and {more} more", first.join(", ")),
    }
}

/// Description of the circuit of an electrode.
fn reported(card: &ElectrodeCard) -> String {
    let volts = |source: &Signal| {
        let now = short_number(source.value(&Instant::START), DIGITS);
        match source {
            Signal::Drive(Drive::Constant(_)) => format!("{now} V"),
            Signal::Drive(_) => format!("{now} V at time zero"),
            Signal::Sensing { .. } => format!("{now} V while all its inputs are zero"),
        }
    };
    let words = match &card.circuit {
        Circuit::Held(source) => format!("voltage {}", volts(source)),
        Circuit::Open { charge } => {
            format!("open circuit, charge {} C", short_number(*charge, DIGITS))
        }
        Circuit::Shunt {
            source,
            resistance,
            inductance,
        } => {
            let coil = if *inductance > 0.0 {
                format!(" and {} H", short_number(*inductance, DIGITS))
            } else {
                String::new()
            };
            let resistance = short_number(*resistance, DIGITS);
            format!("{} through {resistance} Ohm{coil}", volts(source))
        }
    };
    format!("electrode \"{}\": {words}", card.label)
}
