//! Electric laws and electrodes in the report.

use shared_geom::figure::tick_label;

use super::text::{ZERO, number, table};
use crate::input::{InputSummary, circuit_word};
use crate::material::{ElectricLaw, VACUUM_PERMITTIVITY};
use crate::mesh::counted;
use crate::section::{ElectrodeShape, FingeredCell, Section};

/// Constants per line.
const IN_LINE: usize = 6;

/// The lines of the electric law of a material, in its axes.
pub(super) fn electric_law(law: &ElectricLaw) -> String {
    let eps = law.permittivity / VACUUM_PERMITTIVITY;
    let diagonal: Vec<_> = eps.diagonal().iter().copied().collect();
    let mut shown = numbers(&diagonal);
    let shears = [eps[(1, 2)], eps[(0, 2)], eps[(0, 1)]];
    if shears.iter().any(|part| part.abs() > ZERO * eps.amax()) {
        shown += &format!("; 23, 13, 12 {}", numbers(&shears));
    }
    let mut text = format!("      relative permittivity at constant strain {shown}\n");
    let e = &law.coupling;
    let mut constants = Vec::new();
    for row in 0..3 {
        for column in 0..6 {
            let value: f64 = e[(row, column)];
            if value.abs() > ZERO * e.amax() {
                constants.push(format!("e{}{} {}", row + 1, column + 1, digits(value)));
            }
        }
    }
    for line in constants.chunks(IN_LINE) {
        text += &format!("      {} C/m^2\n", line.join(", "));
    }
    text
}

/// The electrodes; empty without electrodes.
pub(super) fn electrodes(section: &Section, summary: &InputSummary) -> String {
    if section.electrodes.is_empty() {
        return String::new();
    }
    let heading = [
        "electrode",
        "circuit",
        "location",
        "size",
        "field per volt [1/m]",
    ];
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    let mut positions = summary.electrodes.iter();
    for electrode in &section.electrodes {
        let (size, field) = match &electrode.shape {
            ElectrodeShape::Conductor { nodes } => (counted(nodes.len(), "node"), String::new()),
            ElectrodeShape::Interdigitated { cells } => {
                (counted(cells.len(), "cell"), field(cells))
            }
        };
        rows.push(vec![
            electrode.name.clone(),
            circuit_word(electrode.circuit).to_owned(),
            positions.next().cloned().unwrap_or_default(),
            size,
            field,
        ]);
    }
    format!("Electrodes\n{}", table(&rows, "lllrl"))
}

/// The field between fingers: `3225.81 along axis 1, in 12 cells reversed`.
fn field(cells: &[FingeredCell]) -> String {
    let Some(first) = cells.first() else {
        return String::new();
    };
    let field = first.field;
    let axis = field.iamax() + 1;
    let other = cells
        .iter()
        .filter(|cell| cell.field.dot(&field) < 0.0)
        .count();
    let words = format!("{} along axis {axis}", number(field[field.iamax()]));
    match other {
        0 => words,
        _ => format!("{words}, in {} reversed", counted(other, "cell")),
    }
}

fn numbers(values: &[f64]) -> String {
    let shown: Vec<_> = values.iter().map(|value| digits(*value)).collect();
    shown.join(", ")
}

fn digits(value: f64) -> String {
    tick_label(value, 0.0)
}
