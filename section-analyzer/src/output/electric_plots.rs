//! The figures of electrodes: potential and electric field at one volt.

use shared_geom::figure::tick_label;

use super::field_plot::{Field, FieldPlot, Quantity};
use crate::input::InputSummary;
use crate::recovery::{ElectricRecovery, Recovery};
use crate::section::{ElectrodeShape, Section};

/// A field below this part of the largest is round-off.
const NEGLIGIBLE: f64 = 1e-9;

/// Voltages that are told at most.
const TOLD: usize = 4;

/// The figures of one recovery.
#[derive(Debug)]
pub struct ElectricPlot<'a> {
    /// The potential; `None` for a section without conductors.
    pub potential: Option<FieldPlot<'a>>,
    /// Magnitude and direction of the electric field.
    pub field: FieldPlot<'a>,
}

/// Potential and electric field of `recovery`; `None` without electrodes.
pub fn electric_plots<'a>(
    section: &'a Section,
    summary: &InputSummary,
    recovery: &Recovery,
) -> Option<ElectricPlot<'a>> {
    let electric = recovery.electric.as_ref()?;
    let words = voltages(section, electric);
    let plot = |field| FieldPlot::new(section, summary, field, words.clone());
    Some(ElectricPlot {
        potential: potential(section, electric).map(plot),
        field: plot(magnitude(recovery, electric)),
    })
}

/// White where there is none.
fn potential(section: &Section, electric: &ElectricRecovery) -> Option<Field> {
    let mut electrodes = section.electrodes.iter();
    if !electrodes.any(|known| matches!(known.shape, ElectrodeShape::Conductor { .. })) {
        return None;
    }
    let is_fingered = fingered(section);
    let cells = section.mesh.cells.iter().enumerate();
    let values = cells.map(|(index, cell)| {
        let mut values = [f64::NAN; 9];
        if electric.has_field[index] && !is_fingered[index] {
            values = [0.0; 9];
            for (value, &node) in values.iter_mut().zip(cell.nodes()) {
                *value = electric.potential[node as usize];
            }
        }
        values
    });
    let mut field = Field {
        title: "electric potential".to_owned(),
        note: String::new(),
        quantity: Quantity::Potential,
        values: values.collect(),
        vectors: None,
        negligible: NEGLIGIBLE * electric.potential.amax(),
    };
    tell_white(&mut field, "without potential");
    Some(field)
}

/// Whether each cell is between fingers.
fn fingered(section: &Section) -> Vec<bool> {
    let mut found = vec![false; section.mesh.cells.len()];
    for electrode in &section.electrodes {
        if let ElectrodeShape::Interdigitated { cells } = &electrode.shape {
            for cell in cells {
                found[cell.cell as usize] = true;
            }
        }
    }
    found
}

fn magnitude(recovery: &Recovery, electric: &ElectricRecovery) -> Field {
    let (mut values, mut vectors) = (Vec::new(), Vec::new());
    let (mut along, mut across) = (0.0_f64, 0.0_f64);
    for (cell, states) in recovery.cell_nodes.iter().enumerate() {
        let (mut sizes, mut arrows) = ([f64::NAN; 9], [[0.0; 2]; 9]);
        if electric.has_field[cell] {
            sizes = [0.0; 9];
            for (i, &state) in states.iter().enumerate() {
                let field = &electric.nodes[state as usize].field;
                (sizes[i], arrows[i]) = (field.norm(), [field.y, field.z]);
                along = along.max(field.x.abs());
                across = across.max(field.y.hypot(field.z));
            }
        }
        values.push(sizes);
        vectors.push(arrows);
    }
    let note = match (along > NEGLIGIBLE * across, across > NEGLIGIBLE * along) {
        (true, true) => "arrows: the part in the section, its mean nearby",
        (true, false) => "along the beam",
        _ => "arrows: its mean nearby",
    };
    let mut field = Field {
        title: "electric field".to_owned(),
        note: note.to_owned(),
        quantity: Quantity::ElectricField,
        values,
        vectors: (across > NEGLIGIBLE * along).then_some(vectors),
        negligible: NEGLIGIBLE * electric.field_scale,
    };
    tell_white(&mut field, "without field");
    field
}

/// Says what cells without a number are.
fn tell_white(field: &mut Field, what: &str) {
    if field.values.iter().any(|values| values[0].is_nan()) {
        let comma = if field.note.is_empty() { "" } else { "; " };
        field.note += &format!("{comma}white: {what}");
    }
}

/// `voltages: top 1 V, bottom 0 V`.
fn voltages(section: &Section, electric: &ElectricRecovery) -> Vec<String> {
    let scale = electric
        .voltages
        .iter()
        .fold(0.0, |s: f64, v| s.max(v.abs()));
    let pairs = section.electrodes.iter().zip(&electric.voltages);
    let mut told: Vec<_> = pairs
        .clone()
        .filter(|(_, voltage)| voltage.abs() > NEGLIGIBLE * scale)
        .take(TOLD)
        .map(|(known, voltage)| {
            let value: f64 = format!("{voltage:.3e}").parse().unwrap_or(*voltage);
            format!("{} {} V", known.name, tick_label(value, 0.0))
        })
        .collect();
    if told.len() < pairs.len() {
        told.push("others 0".to_owned());
    }
    vec![format!("voltages: {}", told.join(", "))]
}
