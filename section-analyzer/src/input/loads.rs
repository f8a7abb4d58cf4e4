//! Load cases as written: `[load.NAME]`.

use nalgebra::Vector6;
use shared_geom::document::Table;
use shared_geom::units::Dimension;

use super::distributed::{self, WrittenDistribution};
use super::electrodes::WrittenElectrodes;
use super::imposed::{ImposedProblem, WrittenStates};
use super::names::is_load_name;
use super::problem::InputProblem;
use crate::recovery::LoadCase;

mod problem;

pub use problem::LoadProblem;

/// Keys of the six components, in their order, with their dimensions.
pub const LOAD_KEYS: [(&str, Dimension); 6] = [
    ("axial", Dimension::FORCE),
    ("shear_y", Dimension::FORCE),
    ("shear_z", Dimension::FORCE),
    ("torsion", Dimension::MOMENT),
    ("bending_y", Dimension::MOMENT),
    ("bending_z", Dimension::MOMENT),
];

/// Largest component \[N, N m\]: far beyond all structures; the squares of its stresses
/// are still finite.
const LARGEST: f64 = 1e20;

/// `load`, if none of its components is beyond all structures.
///
/// # Errors
/// [`InputProblem::HugeLoad`].
pub fn checked_load(load: LoadCase) -> Result<LoadCase, InputProblem> {
    let is_huge = |value: &f64| value.is_nan() || value.abs() > LARGEST;
    match load.force.iter().position(is_huge) {
        Some(component) => Err(InputProblem::HugeLoad {
            component,
            value: load.force[component],
            limit: LARGEST,
            load: load.name,
        }),
        None => Ok(load),
    }
}

/// Reads every `[load.NAME]` with its distributed loads; loads may refer to imposed
/// `states`. Notes problems. Loads without sound components are `None`, but their
/// distributed loads are kept.
pub(super) fn read(
    root: &Table<'_>,
    states: &WrittenStates,
    electrodes: &WrittenElectrodes,
) -> Vec<(Option<LoadCase>, WrittenDistribution)> {
    let tables = root.named_tables("load");
    note_same_files(&tables);
    tables
        .into_iter()
        .map(|(name, table)| {
            let distributed = distributed::read(&table);
            let voltages = electrodes.voltages(&name, &table, "voltages");
            let load = read_one(&name, &table, (states, &distributed), voltages);
            table.finish();
            (load, distributed)
        })
        .collect()
}

/// Notes names that differ only in upper and lower case.
fn note_same_files(tables: &[(String, Table<'_>)]) {
    for (number, (load, table)) in tables.iter().enumerate() {
        let is_same = |(other, _): &&(String, Table<'_>)| {
            other != load && other.to_lowercase() == load.to_lowercase()
        };
        if let Some((other, before)) = tables[..number].iter().find(is_same) {
            let problem = LoadProblem::SameFile {
                load: load.clone(),
                other: other.clone(),
                line: before.line(),
            };
            table.note("", &problem);
        }
    }
}

fn read_one(
    name: &str,
    table: &Table<'_>,
    (states, distributed): (&WrittenStates, &WrittenDistribution),
    voltages: Option<Vec<(String, f64)>>,
) -> Option<LoadCase> {
    let load = name.to_owned();
    if !is_load_name(name) {
        table.note("", &InputProblem::LoadName { load: load.clone() });
    }
    // All keys are read before the first wrong one ends the reading.
    let read = LOAD_KEYS.map(|(key, dimension)| match table.has(key) {
        true => table.quantity(key, dimension),
        false => Some(0.0),
    });
    let point = point(table);
    let imposed = ["temperature", "initial_strain"].map(|kind| state(name, kind, table, states));
    let components: Option<Vec<f64>> = read.into_iter().collect();
    let force = Vector6::from_vec(components?);
    let [temperature, initial_strain] = imposed;
    let imposed: Vec<_> = temperature?.into_iter().chain(initial_strain?).collect();
    let voltages = voltages?;
    let is_driven = voltages.iter().any(|(_, voltage)| *voltage != 0.0);
    let has_force = force != Vector6::zeros() || !distributed.is_empty();
    if !has_force && imposed.is_empty() && !is_driven {
        table.note("", &InputProblem::ZeroLoad { load });
        return None;
    }
    if force == Vector6::zeros() && table.has("point") {
        table.note("point", &LoadProblem::PointAlone { load: load.clone() });
    }
    let load = LoadCase {
        imposed,
        voltages,
        ..LoadCase::at_point(load, &force, point?)
    };
    let load = checked_load(load);
    load.map_err(|problem| table.note("", &problem)).ok()
}

/// The imposed state of a kind that acts with the load, if there is one; `None` for an
/// unknown name, which is noted.
fn state(
    load: &str,
    kind: &'static str,
    table: &Table<'_>,
    states: &WrittenStates,
) -> Option<Option<String>> {
    if !table.has(kind) {
        return Some(None);
    }
    let name = table.text(kind)?;
    let known = states.names(kind);
    if !known.contains(&name) {
        let load = load.to_owned();
        let problem = ImposedProblem::Unknown {
            kind,
            name,
            load,
            known,
        };
        table.note(kind, &problem);
        return None;
    }
    Some(Some(name))
}

/// Point of application of the force (y, z) \[m\]; the reference point if not given.
fn point(table: &Table<'_>) -> Option<[f64; 2]> {
    if !table.has("point") {
        return Some([0.0; 2]);
    }
    let numbers = table.quantities("point", Dimension::LENGTH)?;
    match numbers[..] {
        [y, z] => Some([y, z]),
        _ => {
            table.wrong("point", "an array of 2, y and z, each a length");
            None
        }
    }
}
