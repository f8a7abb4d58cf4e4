//! Derivatives of the properties of a section, as a file and in the report.

use nalgebra::Matrix6;
use serde_json::{Value, json};
use shared_geom::figure::tick_label;
use shared_geom::wrench::COMPONENTS;

use super::text::table;
use crate::section::Section;
use crate::sensitivity::{Axis, Cells, Derivative, Parameter};
use crate::solution::SectionSolution;

/// Changes below this are shown as zero \[%\].
const SMALL: f64 = 5e-7;

/// The derivatives with respect to `parameters` as JSON, in SI about the origin of the
/// mesh; `input_hash` is the fingerprint of what they were made from.
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
    // words, numbers and lists of them always have a JSON form
    serde_json::to_string_pretty(&file).unwrap_or_default() + "\n"
}

fn rows(matrix: &Matrix6<f64>) -> [[f64; 6]; 6] {
    std::array::from_fn(|i| std::array::from_fn(|j| matrix[(i, j)]))
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

/// The part of the report: changes of the diagonal of the stiffness and of the mass in
/// per cent, and of the centers.
pub fn sensitivity_table(
    section: &Section,
    solution: &SectionSolution,
    parameters: &[Parameter],
    derivatives: &[Derivative],
) -> String {
    let mut changes = vec![heading(COMPONENTS.into_iter().chain(["mass"]))];
    let mut centers = vec![heading(
        [
            "tension y",
            "tension z",
            "shear y",
            "shear z",
            "mass y",
            "mass z",
        ]
        .into_iter(),
    )];
    let (k, m) = (&solution.stiffness, &solution.mass);
    let size = size(section);
    for (parameter, derivative) in parameters.iter().zip(derivatives) {
        let step = step(section, parameter, size);
        let per_cent = |change: f64, of: f64| match of == 0.0 {
            true => 0.0,
            false => 100.0 * step * change / of,
        };
        let diagonal = (0..6).map(|i| per_cent(derivative.stiffness[(i, i)], k[(i, i)]));
        let mass = per_cent(derivative.mass[(0, 0)], m[(0, 0)]);
        let name = parameter.name(section);
        changes.push(row(&name, diagonal.chain([mass])));
        let of_mass = derivative.mass_center.unwrap_or_default();
        let places = [derivative.tension, derivative.shear, of_mass];
        let places = places.into_iter().flatten();
        centers.push(row(&name, places.map(|place| 100.0 * step * place / size)));
    }
    format!(
        "Sensitivities: change by 1 % of a constant, by 1 deg of an angle, or of a node by\n\
         1 % of the size of the section, {} m (first order; all else as it is)\n  \
         Diagonal of the stiffness, and mass [%]\n{}\n  \
         Centers [% of that size]\n{}",
        tick_label(size, 0.0),
        table(&changes, "lr"),
        table(&centers, "lr")
    )
}

/// Amount of a parameter that the table is about.
fn step(section: &Section, parameter: &Parameter, size: f64) -> f64 {
    match parameter {
        Parameter::Constant { .. } => 0.01 * value(section, parameter).unwrap_or_default(),
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
            let place = mesh.nodes[node as usize][axis];
            low[axis] = low[axis].min(place);
            high[axis] = high[axis].max(place);
        }
    }
    (high[0] - low[0]).max(high[1] - low[1])
}

fn heading<'a>(columns: impl Iterator<Item = &'a str>) -> Vec<String> {
    let columns = std::iter::once("parameter").chain(columns);
    columns.map(str::to_owned).collect()
}

fn row(name: &str, values: impl Iterator<Item = f64>) -> Vec<String> {
    std::iter::once(name.to_owned())
        .chain(values.map(shown))
        .collect()
}

/// A change in per cent, with four digits behind the point or, if small, three in all.
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
