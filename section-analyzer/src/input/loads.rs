//! Load cases as written: `[load.NAME]`.

use nalgebra::Vector6;
use shared_geom::document::schema::ValueKind::{Name, Named, NamedTables, Quantity, Vector};
use shared_geom::document::{ByHand, Key, NestedByName, Table};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::distributed::{self, WrittenDistribution};
use super::electrodes::WrittenElectrodes;
use super::imposed::{ImposedProblem, WrittenStates};
use super::names::is_load_name;
use super::problem::InputProblem;
use super::regions::Written;
use crate::recovery::LoadCase;

mod problem;

pub use problem::LoadProblem;

keys! {
    /// Internal forces, imposed states and distributed loads for which stresses are recovered, by
    /// name.
    pub(super) LOADS: NestedByName = "load", [NamedTables(&LOAD)], optional, "";
}

keys! {
    /// An internal force with at least one nonzero component, imposed states, a distributed load,
    /// voltages, or several of these. NAME is made of letters, digits, - and _.
    LOAD = "[load.NAME]";
    /// Axial force.
    AXIAL: f64 = "axial", [Quantity(Dimension::FORCE)], or "0" = 0.0, "\"10 kN\"";
    /// Shear force along y.
    SHEAR_Y: f64 = "shear_y", [Quantity(Dimension::FORCE)], or "0" = 0.0, "\"1 kN\"";
    /// Shear force along z.
    SHEAR_Z: f64 = "shear_z", [Quantity(Dimension::FORCE)], or "0" = 0.0, "\"2 kN\"";
    /// Torque about x.
    TORSION: f64 = "torsion", [Quantity(Dimension::MOMENT)], or "0" = 0.0, "\"120 N m\"";
    /// Bending moment about y.
    BENDING_Y: f64 = "bending_y", [Quantity(Dimension::MOMENT)], or "0" = 0.0, "\"-3 kN m\"";
    /// Bending moment about z.
    BENDING_Z: f64 = "bending_z", [Quantity(Dimension::MOMENT)], or "0" = 0.0, "\"500 N m\"";
    /// Point of application of the force, y and z.
    POINT: [f64; 2] = "point", [Vector(2, Dimension::LENGTH)]
        as "an array of 2, y and z, each a length", or "the origin of the mesh" = [0.0; 2],
        "[12.5, 0]";
    /// The temperature that acts with it, by its name.
    TEMPERATURE: Option<Written> = "temperature", [Name], optional, "\"hot\"";
    /// The initial strain that acts with it, by its name.
    INITIAL_STRAIN: Option<Written> = "initial_strain", [Name], optional, "\"cure\"";
    /// Voltages of driven electrodes by their names; all others are zero.
    VOLTAGES: ByHand = "voltages", [Named(Dimension::VOLTAGE)], optional,
        "{ top = \"100 V\" }";
    with distributed::TRACTIONS.schema, distributed::VOLUMES.schema;
}

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
    let tables = root.named_tables(&LOADS);
    note_same_files(&tables);
    tables
        .into_iter()
        .map(|(name, table)| {
            let distributed = distributed::read(&table);
            let voltages = electrodes.voltages(&name, &table, &VOLTAGES);
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
    let read = [&AXIAL, &SHEAR_Y, &SHEAR_Z, &TORSION, &BENDING_Y, &BENDING_Z];
    let read = read.map(|key| table.get(key));
    let point = table.get(&POINT);
    let imposed = [&TEMPERATURE, &INITIAL_STRAIN].map(|kind| state(name, kind, table, states));
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
    if force == Vector6::zeros() && table.has(&POINT) {
        table.note(&POINT, &LoadProblem::PointAlone { load: load.clone() });
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
    key: &Key<Option<Written>>,
    table: &Table<'_>,
    states: &WrittenStates,
) -> Option<Option<String>> {
    let Some(name) = table.get(key)?.map(|written| written.text) else {
        return Some(None);
    };
    let kind = key.name();
    let known = states.names(kind);
    if !known.contains(&name) {
        let load = load.to_owned();
        let problem = ImposedProblem::Unknown {
            kind,
            name,
            load,
            known,
        };
        table.note(key, &problem);
        return None;
    }
    Some(Some(name))
}
