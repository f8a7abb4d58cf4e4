//! The figures of a load case: axial stress, shear stress, von Mises stress, and the
//! failure index if materials have strengths.

use shared_geom::figure::tick_label;
use shared_geom::wrench::COMPONENTS;

use super::field_plot::{Field, FieldPlot, Quantity};
use crate::input::InputSummary;
use crate::material::MaterialLimits;
use crate::recovery::{Criterion, FailureIndex, NodalState, Recovery, Tensors, failure_indices};
use crate::section::Section;

/// A stress below this fraction of the largest of the load case is round-off.
const NEGLIGIBLE: f64 = 1e-9;

/// Largest number of characters in a line about the load in a figure.
const LINE: usize = 85;

/// The parts of the file names that distinguish the figures of a load case.
pub(super) const STRESS_PLOTS: [&str; 4] = ["stress_xx", "shear", "von_mises", "failure"];

/// For each criterion that the limits of some material allow, its key and the index
/// of each cell by its mean stress and strain; not a number if the limits of the cell's
/// own material do not allow it. `limits` is parallel to the materials.
pub fn failure_indices_of_cells(
    section: &Section,
    limits: &[MaterialLimits],
    recovery: &Recovery,
) -> Vec<(String, Vec<f64>)> {
    let cells = recovery.cells.iter().zip(&section.cells);
    let of_cells: Vec<_> = cells
        .map(|(cell, made_of)| failure_indices(&limits[made_of.material], &cell.tensors))
        .collect();
    let indices = |criterion: Criterion| {
        let of_cell = |all: &Vec<FailureIndex>| {
            let found = all.iter().find(|index| index.criterion == criterion);
            found.map_or(f64::NAN, |found| found.index)
        };
        let indices: Vec<f64> = of_cells.iter().map(of_cell).collect();
        let is_used = indices.iter().any(|index| !index.is_nan());
        is_used.then(|| (criterion.key().to_owned(), indices))
    };
    Criterion::ALL.into_iter().filter_map(indices).collect()
}

/// The figures of `recovery`, each with the part of its file name that distinguishes it:
/// `stress_xx`, `shear`, `von_mises`, and `failure` if there is a criterion. `failure` has
/// for each criterion its key and the index of each cell, not a number in cells without
/// strengths; the largest is shown.
pub fn stress_plots<'a>(
    section: &'a Section,
    summary: &InputSummary,
    recovery: &Recovery,
    failure: &[(String, Vec<f64>)],
) -> Vec<(&'static str, FieldPlot<'a>)> {
    let load = load_words(recovery);
    let plot = |field: Field| FieldPlot::new(section, summary, field, load.clone());
    let mut fields = vec![axial(recovery), shear(recovery), equivalent(recovery)];
    if !failure.is_empty() {
        let mut field = largest_index(section, failure);
        if largest_stress(recovery) <= NEGLIGIBLE * recovery.stress_scale {
            field.negligible = f64::INFINITY;
        }
        fields.push(field);
    }
    let plots = fields.into_iter().map(plot);
    STRESS_PLOTS.into_iter().zip(plots).collect()
}

fn axial(recovery: &Recovery) -> Field {
    let title = "axial stress xx";
    of_nodes(recovery, Quantity::SignedStress, title, |t| t.stress[0])
}

fn shear(recovery: &Recovery) -> Field {
    let title = "shear stress in the section";
    let mut field = of_nodes(recovery, Quantity::Stress, title, |t| {
        t.stress[4].hypot(t.stress[5])
    });
    let vectors = at_nodes(recovery, |t| [t.stress[5], t.stress[4]]);
    field.vectors = Some(vectors);
    field.note = "resultant of xy and xz, arrows: its mean nearby, on the face +x".to_owned();
    field
}

fn equivalent(recovery: &Recovery) -> Field {
    let title = "von Mises stress";
    of_nodes(recovery, Quantity::Stress, title, Tensors::von_mises)
}

/// The largest index of each cell.
fn largest_index(section: &Section, failure: &[(String, Vec<f64>)]) -> Field {
    let largest = |cell: usize| {
        let indices = failure.iter().filter_map(|(_, indices)| indices.get(cell));
        // `max` ignores values that are not a number
        indices.copied().fold(f64::NAN, f64::max)
    };
    let values: Vec<_> = (0..section.mesh.cells.len()).map(largest).collect();
    let is_used = |criterion: &Criterion| failure.iter().any(|(key, _)| key == criterion.key());
    let used = Criterion::ALL.into_iter().filter(is_used);
    let names: Vec<_> = used.map(Criterion::name).collect();
    let mut field = Field::of_cells(Quantity::Index, "largest failure index".to_owned(), &values);
    field.note = format!("of each cell, by its mean stress: {}", names.join(", "));
    if values.iter().any(|value| value.is_nan()) {
        field.note += "; white: without strengths";
    }
    field
}

fn of_nodes(
    recovery: &Recovery,
    quantity: Quantity,
    title: &str,
    take: impl Fn(&Tensors) -> f64,
) -> Field {
    let largest = largest_stress(recovery).max(recovery.stress_scale);
    Field {
        title: title.to_owned(),
        note: String::new(),
        quantity,
        values: at_nodes(recovery, take),
        vectors: None,
        negligible: NEGLIGIBLE * largest,
    }
}

/// The largest component at a node \[Pa\].
fn largest_stress(recovery: &Recovery) -> f64 {
    let stress = |state: &NodalState| state.tensors.stress.amax();
    recovery.nodes.iter().map(stress).fold(0.0, f64::max)
}

/// A value of the state at each node of each cell.
fn at_nodes<T: Copy + Default>(recovery: &Recovery, take: impl Fn(&Tensors) -> T) -> Vec<[T; 9]> {
    let of_cell = |states: &Vec<u32>| {
        let mut values = [T::default(); 9];
        for (value, &state) in values.iter_mut().zip(states) {
            *value = take(&recovery.nodes[state as usize].tensors);
        }
        values
    };
    recovery.cell_nodes.iter().map(of_cell).collect()
}

/// `load case "gust": shear z 1200 N, torsion -35 N m` and all further actions, in
/// lines that fit.
fn load_words(recovery: &Recovery) -> Vec<String> {
    let mut lines = vec![format!("load case \"{}\":", recovery.load.name)];
    let force = recovery.load.force.iter().enumerate();
    let parts = force.filter(|(_, value)| **value != 0.0);
    let parts = parts.map(|(component, value)| {
        let unit = if component < 3 { "N" } else { "N m" };
        let (name, value) = (COMPONENTS[component], tick_label(*value, 0.0));
        format!("{name} {value} {unit}")
    });
    let mut parts: Vec<_> = parts.collect();
    if parts.is_empty() {
        parts.push("no internal force".to_owned());
    }
    let states = recovery.load.imposed.iter();
    parts.extend(states.map(|state| format!("imposed strain \"{state}\"")));
    let voltages = recovery.load.voltages.iter();
    let voltages = voltages.filter(|(_, voltage)| *voltage != 0.0);
    parts.extend(voltages.map(|(name, voltage)| {
        let value = tick_label(*voltage, 0.0);
        format!("electrode \"{name}\" {value} V")
    }));
    parts.extend(
        recovery
            .is_distributed
            .then(|| "load along the beam".to_owned()),
    );
    for (count, part) in parts.iter().enumerate() {
        let comma = if count + 1 < parts.len() { "," } else { "" };
        let words = format!("{part}{comma}");
        match lines.last_mut() {
            Some(line) if line.len() + words.len() < LINE => *line += &format!(" {words}"),
            _ => lines.push(words),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector6;
    use shared_geom::mesh::CellKind;

    use super::*;
    use crate::output::samples::{recovery, rectangle};

    /// All components are shown, in as many lines as necessary.
    #[test]
    fn load_is_reported_in_lines_that_fit() {
        let section = rectangle(CellKind::Triangle6);
        let words = |force: [f64; 6]| {
            let zero = |_, _| Vector6::zeros();
            load_words(&recovery(&section, "gust", Vector6::from(force), zero))
        };
        assert_eq!(
            words([0.0, 0.0, 1200.0, -35.0, 0.0, 0.0]),
            ["load case \"gust\": shear z 1200 N, torsion -35 N m"]
        );
        assert_eq!(words([0.0; 6]), ["load case \"gust\": no internal force"]);
        let mut heated = recovery(&section, "sun", Vector6::zeros(), |_, _| Vector6::zeros());
        heated.load.imposed = vec!["hot".into(), "cure".into()];
        heated.load.voltages = vec![("top".into(), 150.0), ("bottom".into(), 0.0)];
        heated.is_distributed = true;
        assert_eq!(
            load_words(&heated),
            [
                "load case \"sun\": no internal force, imposed strain \"hot\", imposed strain \"cure\",",
                "electrode \"top\" 150 V, load along the beam"
            ]
        );
        let lines = words([-20123.0, 1234.5, -123450.0, 12345.0, -23456.0, -34567.0]);
        assert_eq!(
            lines,
            [
                "load case \"gust\": axial -20123 N, shear y 1234.5 N, shear z -123450 N,",
                "torsion 12345 N m, bending y -23456 N m, bending z -34567 N m"
            ]
        );
        assert!(lines.iter().all(|line| line.len() <= LINE));
    }

    /// The face +x: xy along y, xz along z.
    #[test]
    fn shear_is_that_of_xy_and_xz_in_their_direction() {
        let section = rectangle(CellKind::Triangle6);
        let stress = Vector6::new(9.0, 9.0, 9.0, 9.0, 3.0, -4.0);
        let recovery = recovery(&section, "load", Vector6::zeros(), |_, _| stress);
        let field = shear(&recovery);
        assert_eq!(field.values[0][..6], [5.0; 6]);
        let vectors = field.vectors.expect("arrows");
        assert_eq!(vectors[0][..6], [[-4.0, 3.0]; 6]);
    }
}
