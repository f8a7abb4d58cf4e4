//! The figures of electrodes: potential and electric field at one volt.

use shared_geom::figure::tick_label;

use super::field_plot::{Field, FieldPlot, Quantity};
use crate::input::InputSummary;
use crate::recovery::{ElectricRecovery, Recovery};
use crate::section::{ElectrodeShape, Section};

/// A field below this fraction of the largest is round-off.
const NEGLIGIBLE: f64 = 1e-9;

/// Largest number of voltages shown.
const MOST_REPORTED: usize = 4;

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

/// The potential; white in cells without potential.
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
    report_white(&mut field, "without potential");
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
        (true, true) => "arrows: in the section, mean nearby",
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
    report_white(&mut field, "no field");
    field
}

/// Adds the meaning of white cells, which have no number, to the note.
fn report_white(field: &mut Field, what: &str) {
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
    let mut reported: Vec<_> = pairs
        .clone()
        .filter(|(_, voltage)| voltage.abs() > NEGLIGIBLE * scale)
        .take(MOST_REPORTED)
        .map(|(known, voltage)| {
            let value: f64 = format!("{voltage:.3e}").parse().unwrap_or(*voltage);
            format!("{} {} V", known.name, tick_label(value, 0.0))
        })
        .collect();
    if reported.len() < pairs.len() {
        reported.push("others 0".to_owned());
    }
    vec![format!("voltages: {}", reported.join(", "))]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::analyze;
    use crate::recovery::{LoadCase, recover};
    use crate::section::piezo_samples::{LAYER, bimorph, fingered};
    use nalgebra::Vector6;

    fn at_one_volt(section: &Section, electrode: &str) -> Recovery {
        let load = LoadCase {
            voltages: vec![(electrode.into(), 1.0)],
            ..LoadCase::at_point("volt", &Vector6::zeros(), [0.0; 2])
        };
        recover(section, &analyze(section).unwrap(), &load).unwrap()
    }

    /// One volt at the top of a bimorph: nodes of the upper face are at one, nodes of the
    /// lower face at zero; the field is normal to the faces: arrows down, against the potential.
    #[test]
    fn potential_and_field_of_a_driven_face() {
        let section = bimorph();
        let recovery = at_one_volt(&section, "top");
        let electric = recovery.electric.as_ref().unwrap();
        let drawn = potential(&section, electric).unwrap();
        for (cell, values) in section.mesh.cells.iter().zip(&drawn.values) {
            for (&node, value) in cell.nodes().iter().zip(values) {
                let z = section.mesh.nodes[node as usize][1];
                if z.abs() > 0.99 * LAYER {
                    assert_eq!(*value, f64::from(u8::from(z > 0.0)));
                }
            }
        }
        let sizes = magnitude(&recovery, electric);
        let arrows = sizes.vectors.as_ref().unwrap();
        for (cell, (sizes, arrows)) in sizes.values.iter().zip(arrows).enumerate() {
            let above = section.mesh.middle(&section.mesh.cells[cell])[1] > 0.5 * LAYER;
            // the field of the other layer, held by this layer, is a fraction of 1/LAYER
            assert!(!above || (arrows[0][1] < -0.5 / LAYER && sizes[0] > 0.5 / LAYER));
        }
        assert_eq!(
            voltages(&section, electric),
            ["voltages: top 1 V, others 0"]
        );
        assert_eq!(sizes.note, "arrows: its mean nearby");
    }

    /// Fingers over the upper half: a field of `1/LAYER` there and none below, no potential.
    #[test]
    fn fields_of_fingers_have_no_potential() {
        let section = fingered();
        let recovery = at_one_volt(&section, "fingers");
        let electric = recovery.electric.as_ref().unwrap();
        assert!(potential(&section, electric).is_none());
        let field = magnitude(&recovery, electric);
        for (cell, sizes) in section.mesh.cells.iter().zip(&field.values) {
            match section.mesh.middle(cell)[1] > 0.0 {
                // round-off of the smoothing
                true => assert!((sizes[0] * LAYER - 1.0).abs() < 1e-12),
                false => assert!(sizes.iter().all(|size| size.is_nan())),
            }
        }
        assert_eq!(field.note, "arrows: its mean nearby; white: no field");
        assert_eq!(voltages(&section, electric), ["voltages: fingers 1 V"]);
    }
}
