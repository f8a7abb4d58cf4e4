//! Version 2: `structure.elastic_properties` with named entries.

use super::super::problem::{ExchangeProblem, Problems};
use super::super::text::from_upper;
use super::assemble::{Matrices, Tables};
use super::fields::{self, Column, required};
use super::mass;
use crate::error::nearest_name;
use crate::exchange::yaml::Node;

/// Table of the matrices.
const PROPERTIES: &str = "elastic_properties";

/// The tables of the blade of version 2.
pub(super) fn tables(root: &Node, problems: &mut Problems) -> Option<Tables> {
    let components = required(root, "the file", "components", problems)?;
    let blade = required(components, "components", "blade", problems)?;
    let axis = required(blade, "components.blade", "reference_axis", problems);
    let axis = axis.and_then(|node| fields::axis(node, problems));
    let twist = twist(blade, problems);
    let structure = required(blade, "components.blade", "structure", problems)?;
    let properties = required(
        structure,
        "components.blade.structure",
        PROPERTIES,
        problems,
    )?;
    let stiffness = required(properties, PROPERTIES, "stiffness_matrix", problems);
    let mut remarks = Vec::new();
    let stiffness = stiffness.and_then(|node| stiffnesses(node, &mut remarks, problems));
    let inertia = required(properties, PROPERTIES, "inertia_matrix", problems);
    let inertia = inertia.and_then(|node| inertias(node, problems));
    let times = times(properties, problems);
    if properties.entry("point_mass").is_some() {
        remarks.push("point masses of the file are not read: add them to the model".to_owned());
    }
    Some(Tables {
        version: 2,
        axis: axis?,
        twist: twist?,
        stiffness: stiffness?,
        inertia: inertia?,
        times: times?,
        remarks,
    })
}

/// The twist in radians.
fn twist(blade: &Node, problems: &mut Problems) -> Option<Column> {
    let shape = required(blade, "components.blade", "outer_shape", problems)?;
    let node = required(shape, "outer_shape", "twist", problems)?;
    let mut column = fields::column(node, "twist", problems)?;
    for value in &mut column.values {
        *value = value.to_radians();
    }
    Some(column)
}

fn stiffnesses(
    node: &Node,
    remarks: &mut Vec<String>,
    problems: &mut Problems,
) -> Option<Matrices> {
    let what = "stiffness_matrix";
    let grid = fields::grid(node, what, problems)?;
    let names: Vec<String> = (1..=6)
        .flat_map(|i| (i..=6).map(move |j| format!("K{i}{j}")))
        .collect();
    let known: Vec<&str> = names.iter().map(String::as_str).chain(["grid"]).collect();
    unknown_keys(node, what, &known, problems);
    let mut absent = Vec::new();
    let mut entries = Vec::new();
    for name in &names {
        let is_diagonal = name.as_bytes().get(1) == name.as_bytes().get(2);
        let entry = match node.entry(name) {
            // Zero is the default of the schema; on the diagonal it is not a stiffness.
            None if !is_diagonal => {
                absent.push(name.as_str());
                Some(vec![0.0; grid.len()])
            }
            _ => entry(node, what, name, &grid, problems),
        };
        entries.push(entry);
    }
    if !absent.is_empty() {
        remarks.push(format!(
            "{what}: {} not given, set to zero",
            absent.join(", ")
        ));
    }
    let entries: Vec<Vec<f64>> = entries.into_iter().collect::<Option<_>>()?;
    let station = |i: usize| {
        let upper: Vec<f64> = entries
            .iter()
            .filter_map(|entry| entry.get(i).copied())
            .collect();
        from_upper(&upper)
    };
    let matrices = (0..grid.len()).map(station).collect();
    Some(Matrices { grid, matrices })
}

fn inertias(node: &Node, problems: &mut Problems) -> Option<Matrices> {
    let what = "inertia_matrix";
    let grid = fields::grid(node, what, problems)?;
    let known: Vec<&str> = mass::NAMES.iter().copied().chain(["grid"]).collect();
    unknown_keys(node, what, &known, problems);
    let columns = mass::NAMES.map(|name| entry(node, what, name, &grid, problems));
    let columns: Vec<Vec<f64>> = columns.into_iter().collect::<Option<_>>()?;
    let station = |i: usize| {
        let value = |column: &Vec<f64>| column.get(i).copied().unwrap_or(0.0);
        let seven: Vec<f64> = columns.iter().map(value).collect();
        seven.try_into().ok().map(mass::matrix)
    };
    let matrices = (0..grid.len()).map(station).collect::<Option<_>>()?;
    Some(Matrices { grid, matrices })
}

/// The values of one named entry on the grid of its table.
fn entry(
    node: &Node,
    what: &str,
    name: &str,
    grid: &[f64],
    problems: &mut Problems,
) -> Option<Vec<f64>> {
    let at = required(node, what, name, problems)?;
    let what = format!("{what}.{name}");
    let values = fields::numbers(at, &what, problems)?;
    fields::same_length(at.line, &what, grid, values.len(), problems)?;
    Some(values)
}

/// Notes keys that no entry has.
fn unknown_keys(node: &Node, what: &str, known: &[&str], problems: &mut Problems) {
    for key in node.keys() {
        if known.contains(&key) {
            continue;
        }
        let near = nearest_name(key, known.iter().copied());
        problems.push(
            node.line,
            &ExchangeProblem::Other {
                what: format!("key of {what}"),
                found: format!("\"{key}\""),
                expected: format!("one of {}", known.join(", ")),
                help: match near {
                    Some(near) => format!("did you mean \"{near}\"?"),
                    None => "remove it".to_owned(),
                },
            },
        );
    }
}

/// The damping times in the order of BeamDyn: `Some(None)` without damping.
fn times(properties: &Node, problems: &mut Problems) -> Option<Option<[f64; 6]>> {
    let Some(mu) = properties.path(&["structural_damping", "mu"]) else {
        return Some(None);
    };
    let what = "structural_damping.mu";
    let values = fields::numbers(mu, what, problems)?;
    let found = values.len();
    if let Ok(times) = <[f64; 6]>::try_from(values) {
        return Some(Some(times));
    }
    let problem = ExchangeProblem::Count {
        what: what.to_owned(),
        expected: 6,
        found,
        separator: "commas",
    };
    problems.push(mu.line, &problem);
    None
}
