//! Derivatives of the properties of a section, as a file and in the report.

use nalgebra::{Matrix6, Vector3};
use serde_json::{Value, json};
use shared_geom::figure::tick_label;
use shared_geom::wrench::{self, COMPONENTS};

use super::text::{rows, table};
use crate::material::Constant;
use crate::section::Section;
use crate::sensitivity::{Axis, Cells, Derivative, Parameter};
use crate::solution::SectionSolution;

/// Changes below this are shown as zero \[%\].
const SMALL: f64 = 5e-7;

/// The derivatives with respect to `parameters` as JSON, in SI about the origin of the
/// mesh; `input_hash` is the fingerprint of the input.
pub fn sensitivity_json(
    section: &Section,
    parameters: &[Parameter],
    derivatives: &[Derivative],
    input_hash: &str,
) -> String {
    let of_parameter = |(parameter, derivative): (&Parameter, &Derivative)| {
        json!({
            "name": parameter.name(section),
            "value": value(section, parameter),
            "unit": unit(parameter),
            "stiffness": rows(&derivative.stiffness),
            "compliance": rows(&derivative.compliance),
            "mass": rows(&derivative.mass),
            "tension_center": derivative.tension,
            "shear_center": derivative.shear,
            "mass_center": derivative.mass_center,
        })
    };
    let list: Vec<Value> = parameters
        .iter()
        .zip(derivatives)
        .map(of_parameter)
        .collect();
    let file = json!({
        "format": "helicoid section sensitivity",
        "version": 1,
        "section": section.name,
        "program": format!("{} {}", env!("CARGO_PKG_NAME"), env!("CARGO_PKG_VERSION")),
        "input": input_hash,
        "units": "SI, per unit of the parameter; angles in rad",
        "reference_point": [0.0, 0.0],
        "order": COMPONENTS,
        "parameters": list,
    });
    // strings, numbers and lists always have a JSON form
    serde_json::to_string_pretty(&file).unwrap_or_default() + "\n"
}

/// The value of a parameter in SI; `None` for angles that are not the same in all cells,
/// and for motions.
fn value(section: &Section, parameter: &Parameter) -> Option<f64> {
    match parameter {
        Parameter::Constant { material, constant } => {
            section.materials.get(*material)?.value(*constant)
        }
        Parameter::FiberAngle(cells) => {
            common(section, cells, |cell| section.cells[cell].fiber_angle)
        }
        Parameter::PlaneAngle(cells) => {
            common(section, cells, |cell| section.cells[cell].plane_angle)
        }
        Parameter::Node { node, axis } => {
            let [y, z] = section.mesh.nodes.get(*node)?;
            Some(match axis {
                Axis::Y => *y,
                Axis::Z => *z,
            })
        }
        Parameter::MeshNode(node) => Some(node.value),
        Parameter::Motion(_) => None,
    }
}

fn common(section: &Section, cells: &Cells, angle: impl Fn(usize) -> f64) -> Option<f64> {
    let all: Vec<usize> = match cells {
        Cells::Region(group) => {
            let cells = section.mesh.cells.iter().enumerate();
            let of_group = cells.filter(|(_, cell)| cell.group == *group);
            of_group.map(|(index, _)| index).collect()
        }
        Cells::List(list) => list.clone(),
    };
    let first = angle(*all.first()?);
    all.iter()
        .all(|&cell| angle(cell) == first)
        .then_some(first)
}

fn unit(parameter: &Parameter) -> &'static str {
    match parameter {
        Parameter::Constant { constant, .. } => constant.unit(),
        Parameter::FiberAngle(_) | Parameter::PlaneAngle(_) => "rad",
        Parameter::Node { .. } | Parameter::MeshNode(_) => "m",
        Parameter::Motion(_) => "-",
    }
}

/// The part of the report: changes of the stiffnesses about their centers and of the mass
/// in per cent, and of the centers; of many parameters the ones that change most.
pub fn sensitivity_table(
    section: &Section,
    solution: &SectionSolution,
    parameters: &[Parameter],
    derivatives: &[Derivative],
) -> String {
    let size = size(section);
    let rows: Vec<Row> = parameters
        .iter()
        .zip(derivatives)
        .map(|(parameter, derivative)| {
            let step = step(section, parameter, size);
            let of_centers = per_size(derivative, 100.0 * step / size);
            Row {
                name: parameter.name(section),
                changes: per_cent(solution, derivative, 100.0 * step),
                centers: of_centers,
            }
        })
        .collect();
    let (rows, left_out) = largest(rows);
    let changes = table_of(
        &STIFFNESSES,
        rows.iter().map(|row| (&row.name, &row.changes[..])),
    );
    let centers = table_of(
        &CENTERS,
        rows.iter().map(|row| (&row.name, &row.centers[..])),
    );
    let left_out = match left_out {
        0 => String::new(),
        count => format!(
            "  The {MOST} parameters that change most; {count} more are in the file of derivatives\n"
        ),
    };
    format!(
        "Sensitivities: change by 1 % of a constant (of 1 for a Poisson's ratio of zero, of the\n\
         largest entry for an entry of a full stiffness that is zero), by 1 deg of an angle, or of\n\
         a node by 1 % of the size of the section, {} m (first order; all else unchanged)\n{left_out}  \
         Stiffnesses about their centers (as 1/C), and mass [%]\n{changes}\n  \
         Centers [% of that size]\n{centers}",
        tick_label(size, 0.0),
    )
}

/// Largest number of parameters in the table.
const MOST: usize = 60;

const STIFFNESSES: [&str; 7] = ["EA", "GAy", "GAz", "GJ", "EIy", "EIz", "mass"];

const CENTERS: [&str; 6] = [
    "tension y",
    "tension z",
    "shear y",
    "shear z",
    "mass y",
    "mass z",
];

/// A parameter in the table; `None` for quantities that the section does not have.
struct Row {
    name: String,
    changes: [Option<f64>; 7],
    centers: [Option<f64>; 6],
}

/// Changes of EA, GAy, GAz, GJ, EIy, EIz and of the mass, relative to each, times `step`.
///
/// ```text
/// d ln S_i = -dC_ii / C_ii        C about the tension center for EA, EI, the shear center for GA, GJ
/// ```
/// as the motion of the centers does not change these entries, to first order.
fn per_cent(solution: &SectionSolution, derivative: &Derivative, step: f64) -> [Option<f64>; 7] {
    let about = |matrix: &Matrix6<f64>, [y, z]: [f64; 2]| {
        let back = wrench::shift_matrix(&-Vector3::new(0.0, y, z));
        back.transpose() * matrix * back
    };
    std::array::from_fn(|i| {
        let (change, of) = match i {
            6 => (derivative.mass[(0, 0)], solution.mass[(0, 0)]),
            _ => {
                let centers = &solution.centers;
                let center = match i {
                    1..=3 => centers.shear,
                    _ => centers.tension,
                };
                let at = |matrix| about(matrix, center)[(i, i)];
                (-at(&derivative.compliance), at(&solution.compliance))
            }
        };
        (of != 0.0).then(|| step * change / of)
    })
}

/// Changes of the centers, times `step`.
fn per_size(derivative: &Derivative, step: f64) -> [Option<f64>; 6] {
    let of_mass = derivative.mass_center.map(|position| position.map(Some));
    let positions = [
        derivative.tension.map(Some),
        derivative.shear.map(Some),
        of_mass.unwrap_or_default(),
    ];
    std::array::from_fn(|i| positions[i / 2][i % 2].map(|position| step * position))
}

/// The [`MOST`] rows that change most, in their order, and the number of the others.
fn largest(rows: Vec<Row>) -> (Vec<Row>, usize) {
    let left_out = rows.len().saturating_sub(MOST);
    if left_out == 0 {
        return (rows, 0);
    }
    let size = |row: &Row| {
        let all = row.changes.iter().chain(&row.centers).flatten();
        all.fold(0.0_f64, |size, change| size.max(change.abs()))
    };
    let mut sizes: Vec<f64> = rows.iter().map(size).collect();
    sizes.sort_by(|a, b| b.total_cmp(a));
    let least = sizes[MOST - 1];
    let mut shown: Vec<Row> = rows.into_iter().filter(|row| size(row) >= least).collect();
    shown.truncate(MOST);
    (shown, left_out)
}

/// Change of a parameter to which the table refers.
fn step(section: &Section, parameter: &Parameter, size: f64) -> f64 {
    match parameter {
        Parameter::Constant { material, constant } => {
            let value = value(section, parameter).unwrap_or_default();
            match (constant, value == 0.0) {
                (Constant::Stiffness(..), true) => {
                    0.01 * section.materials[*material].law.stiffness().amax()
                }
                (_, true) => 0.01,
                _ => 0.01 * value,
            }
        }
        Parameter::FiberAngle(_) | Parameter::PlaneAngle(_) => 1f64.to_radians(),
        Parameter::Node { .. } | Parameter::MeshNode(_) => 0.01 * size,
        Parameter::Motion(_) => 1.0,
    }
}

/// Largest extent of the cells along y or z.
fn size(section: &Section) -> f64 {
    let mesh = &section.mesh;
    let nodes = mesh.cells.iter().flat_map(|cell| cell.nodes());
    let mut low = [f64::INFINITY; 2];
    let mut high = [f64::NEG_INFINITY; 2];
    for &node in nodes {
        for axis in 0..2 {
            let position = mesh.nodes[node as usize][axis];
            low[axis] = low[axis].min(position);
            high[axis] = high[axis].max(position);
        }
    }
    (high[0] - low[0]).max(high[1] - low[1])
}

fn table_of<'a>(
    columns: &[&str],
    rows: impl Iterator<Item = (&'a String, &'a [Option<f64>])>,
) -> String {
    let heading = std::iter::once("parameter").chain(columns.iter().copied());
    let mut lines = vec![heading.map(str::to_owned).collect::<Vec<_>>()];
    for (name, values) in rows {
        let values = values
            .iter()
            .map(|value| value.map_or_else(|| "-".to_owned(), shown));
        lines.push(std::iter::once(name.clone()).chain(values).collect());
    }
    table(&lines, "lr")
}

/// A change in per cent, with four digits after the point or, if small, three in all.
fn shown(value: f64) -> String {
    match value.abs() {
        size if size < SMALL => "0".to_owned(),
        size if size < 1e-2 => format!("{value:.2e}"),
        _ => format!("{value:.4}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changes_are_shown_short() {
        assert_eq!(shown(-1e-9), "0");
        assert_eq!(shown(1.0), "1.0000");
        assert_eq!(shown(-0.001234), "-1.23e-3");
    }
}
