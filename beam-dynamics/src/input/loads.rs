//! Loads: on nodes and along beams, imposed motions, gravity.

use std::collections::BTreeMap;

use nalgebra::{Matrix3, Vector3};
use shared_geom::document::Table;
use shared_geom::rotation::vector;
use shared_geom::units::Dimension;

use super::draft::Draft;
use super::drives;
use crate::elements::loads::{self, ImposedMotion, LoadFactor, NodalForce, NodalLoad, Turning};
use crate::model::Drive;

mod along_beams;
mod problem;

pub(super) use along_beams::beams;
pub use problem::LoadProblem;

/// Reads `[gravity]` and its factor; zero if absent.
pub(super) fn gravity(root: &Table<'_>, draft: &Draft) -> Option<(Vector3<f64>, Drive)> {
    if !root.has("gravity") {
        return Some((Vector3::zeros(), Drive::Constant(1.0)));
    }
    let table = root.table("gravity")?;
    let _ = table.has("acceleration");
    let found = match table.has("acceleration") {
        true => table.vector("acceleration", Dimension::ACCELERATION),
        false => table
            .require_quantity("acceleration", Dimension::ACCELERATION)
            .map(|_| Vector3::zeros()),
    };
    let drive = match table.has("drive") {
        true => drives::read(&table, "drive", Dimension::NUMBER, draft.drives()),
        false => Some(Drive::Constant(1.0)),
    };
    table.finish();
    found.zip(drive)
}

/// Adds every `[[load]]`, `[[distributed_load]]` and `[[imposed]]` to the model.
pub(super) fn read(root: &Table<'_>, draft: &mut Draft) {
    for (number, table) in root.tables("load").iter().enumerate() {
        let label = label(table, "load", number);
        let is_new = draft.take_label("load", &label, table);
        let nodes = nodes(table, draft, &label);
        let load = nodal(table);
        let frame = draft.frames().of(table);
        let signal = drives::read_factor(table, "drive", draft.drives());
        table.finish();
        match (nodes, load, frame, signal) {
            (Some(nodes), Some((load, in_node)), Some(frame), Some(signal)) if is_new => {
                for &node in &nodes {
                    let on = &draft.nodes()[node];
                    let turn = |vector: Vector3<f64>| match in_node {
                        true => on.rotation * vector,
                        false => frame.direction(&vector),
                    };
                    let load = NodalForce {
                        force: turn(load.force),
                        moment: turn(load.moment),
                        ..load
                    };
                    let label = match nodes.len() {
                        1 => label.clone(),
                        _ => format!("{label} on {}", on.label),
                    };
                    let load = NodalLoad::new(label, node, on, load).driven(signal.clone());
                    draft.add_load(Box::new(load));
                }
            }
            _ => draft.note_broken(),
        }
    }
    along_beams::read(root, draft);
    read_imposed(root, draft);
}

fn label(table: &Table<'_>, kind: &str, number: usize) -> String {
    let own = table.text("name");
    own.unwrap_or_else(|| format!("{kind} {}", number + 1))
}

fn node(table: &Table<'_>, draft: &mut Draft, label: &str) -> Option<usize> {
    let name = table.require_text("node", "the name of a node")?;
    draft.find_node(&name, table, "node", &format!("\"{label}\""))
}

/// The node of a load, or one node of each blade of a card.
fn nodes(table: &Table<'_>, draft: &mut Draft, label: &str) -> Option<Vec<usize>> {
    let name = table.require_text("node", "the name of a node")?;
    let user = format!("\"{label}\"");
    let names = draft.node_names(&name);
    let found = names
        .iter()
        .map(|name| draft.find_node(name, table, "node", &user));
    // The first unknown name ends the search: the others differ only in the blade.
    found.collect()
}

/// The load of a card, and whether it is in the axes of its node.
fn nodal(table: &Table<'_>) -> Option<(NodalForce, bool)> {
    let force = vector_or_zero(table, "force", Dimension::FORCE);
    let moment = vector_or_zero(table, "moment", Dimension::MOMENT);
    let offset = vector_or_zero(table, "offset", Dimension::LENGTH);
    let in_node = axes(table, "node");
    let kind = kind(table);
    if !table.has("force") && !table.has("moment") {
        table.note("", &LoadProblem::NoLoad);
        return None;
    }
    let (turning, factor) = kind?;
    let load = NodalForce {
        force: force?,
        moment: moment?,
        offset: offset?,
        turning,
        factor,
    };
    Some((load, in_node?))
}

fn vector_or_zero(table: &Table<'_>, key: &str, dimension: Dimension) -> Option<Vector3<f64>> {
    match table.has(key) {
        true => table.vector(key, dimension),
        false => Some(Vector3::zeros()),
    }
}

/// Whether the components are in the axes called `own` instead of the model's.
fn axes(table: &Table<'_>, own: &str) -> Option<bool> {
    match table.has("axes") {
        true => Some(table.word("axes", &["model", own])? == 1),
        false => Some(false),
    }
}

/// Dead or follower; constant, proportional, or released at the start of a run in time.
fn kind(table: &Table<'_>) -> Option<(Turning, LoadFactor)> {
    let follower = flag(table, "follower");
    let release = flag(table, "release");
    let factor = factor(table);
    if release == Some(true) && table.has("constant") {
        table.note("release", &LoadProblem::ReleasedAndConstant);
        return None;
    }
    let factor = match release? {
        true => factor.map(|_| LoadFactor::Released),
        false => factor,
    };
    let turning = match follower? {
        true => Turning::Follower,
        false => Turning::Dead,
    };
    Some((turning, factor?))
}

fn factor(table: &Table<'_>) -> Option<LoadFactor> {
    Some(match flag(table, "constant")? {
        true => LoadFactor::Constant,
        false => LoadFactor::Proportional,
    })
}

/// A truth value, false when absent.
pub(super) fn flag(table: &Table<'_>, key: &str) -> Option<bool> {
    match table.has(key) {
        true => table.boolean(key),
        false => Some(false),
    }
}

fn read_imposed(root: &Table<'_>, draft: &mut Draft) {
    // Line of the card that holds each component of each node.
    let mut held = BTreeMap::new();
    for (number, table) in root.tables("imposed").iter().enumerate() {
        let label = label(table, "imposed", number);
        let is_new = draft.take_label("imposed", &label, table);
        let node = node(table, draft, &label);
        let motion = imposed(table);
        let frame = draft.frames().of(table);
        let drive = match table.has("drive") {
            true => drives::read_place(table, "drive", Dimension::NUMBER, draft.drives()).map(Some),
            false => Some(None),
        };
        table.finish();
        let (Some(node), Some(mut motion), Some(frame), Some(drive), true) =
            (node, motion, frame, drive, is_new)
        else {
            draft.note_broken();
            continue;
        };
        if draft.clamped().any(|clamped| clamped == node) {
            let node = draft.nodes()[node].label.clone();
            table.note("node", &LoadProblem::Clamped { node });
            draft.note_broken();
            continue;
        }
        if let Some(line) = held.insert(node, table.line()) {
            let line = table.document().line_words(line);
            let node = draft.nodes()[node].label.clone();
            table.note("node", &LoadProblem::ImposedTwice { node, line });
            draft.note_broken();
            continue;
        }
        motion.axes = frame.axes(&motion.axes);
        let imposed = loads::imposed(label, node, &draft.nodes()[node], motion);
        let imposed = match drive {
            Some(signal) => imposed.scaled_by(signal),
            None => imposed,
        };
        draft.add_load(Box::new(imposed));
    }
}

fn imposed(table: &Table<'_>) -> Option<ImposedMotion> {
    let displacement = components(table, "displacement", Dimension::LENGTH);
    let rotation = components(table, "rotation", Dimension::ANGLE);
    let axes = match table.has("orientation") {
        true => table
            .vector("orientation", Dimension::ANGLE)
            .map(|phi| vector::to_rotation(&phi)),
        false => Some(Matrix3::identity()),
    };
    let factor = factor(table);
    let (displacement, rotation) = (displacement?, rotation?);
    if displacement.iter().chain(&rotation).all(Option::is_none) {
        table.note("", &LoadProblem::NothingImposed);
        return None;
    }
    Some(ImposedMotion {
        displacement,
        rotation,
        axes: axes?,
        factor: factor?,
    })
}

/// The held components: `{ x = 0, z = 0.1 }`, or all three as a list.
fn components(table: &Table<'_>, key: &str, dimension: Dimension) -> Option<[Option<f64>; 3]> {
    if !table.has(key) {
        return Some([None; 3]);
    }
    if !table.is_table(key) {
        return table
            .vector(key, dimension)
            .map(|vector| [0, 1, 2].map(|i| Some(vector[i])));
    }
    let inner = table.table(key)?;
    let component = |axis: &str| match inner.has(axis) {
        true => inner.quantity(axis, dimension).map(Some),
        false => Some(None),
    };
    let found = ["x", "y", "z"].map(component);
    inner.finish();
    let [x, y, z] = found;
    Some([x?, y?, z?])
}
