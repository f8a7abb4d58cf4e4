//! Loads: on nodes and along beams, imposed motions, gravity.

use shared_geom::document::schema::ValueKind::{
    Boolean, Drive as OneDrive, Quantity, Table as OneTable, Text, Vector, Word,
};
use shared_geom::keys;
use std::collections::BTreeMap;

use nalgebra::Vector3;
use shared_geom::document::schema::KeySchema;
use shared_geom::document::{ByHand, Declared, Key, Table, Value};
use shared_geom::rotation::vector;
use shared_geom::units::Dimension;

use super::builder::ModelBuilder;
use super::drives;
use super::ends::label;
use super::frames::IN;
use super::misplaced_keys::OF_GRAVITY;
use super::number::short_number;
use crate::elements::loads::{self, ImposedMotion, LoadFactor, NodalForce, NodalLoad, Turning};
use crate::model::Drive;

mod along_beams;
mod problem;

pub(super) use along_beams::{BEAMS, BLADE, CARD as DISTRIBUTED_LOAD, beams, named_beams};
pub use problem::LoadProblem;

keys! {
    /// A force and a moment on a node.
    pub(super) LOAD = "[[load]]";
    /// Its name, for messages.
    NAME: Option<String> = "name", [Text], or "`load` and its number", "\"thrust\"";
    /// The name of a node.
    NODE: String = "node", [Text], required, "\"tip\"";
    /// Force; one of force and moment is needed.
    FORCE: Vector3<f64> = "force", [Vector(3, Dimension::FORCE)],
        or "[0, 0, 0]" = Vector3::zeros(), "[0, 0, 120]";
    /// Moment.
    MOMENT: Vector3<f64> = "moment", [Vector(3, Dimension::MOMENT)],
        or "[0, 0, 0]" = Vector3::zeros(), "[0, 5, 0]";
    /// Point of application relative to the node, in the node's axes.
    OFFSET: Vector3<f64> = "offset", [Vector(3, Dimension::LENGTH)],
        or "[0, 0, 0]" = Vector3::zeros(), "[0, 0.1, 0]";
    /// Axes of the components: the model, or the undeformed node.
    AXES: usize = "axes", [Word(&["model", "node"])], or "\"model\"" = 0, "\"node\"";
    with FOLLOWER.schema, CONSTANT.schema, RELEASE.schema, DRIVE.schema, IN.schema;
}

keys! {
    /// Whether the load turns with the node or the section; otherwise it is a dead load.
    FOLLOWER: bool = "follower", [Boolean], or "false" = false, "true";
    /// Whether the load is constant; otherwise it grows with the load factor of statics.
    pub(super) CONSTANT: bool = "constant", [Boolean], or "false" = false, "true";
    /// Whether the load acts in the equilibrium of the start only, and is released there.
    pub(super) RELEASE: bool = "release", [Boolean], or "false" = false, "true";
    /// Factor of the load, which may depend on time and sensors.
    pub(super) DRIVE: ByHand = "drive", [OneDrive(Dimension::NUMBER)], or "1", "\"= sin(t)\"";
}

keys! {
    /// A prescribed motion of a node.
    pub(super) IMPOSED = "[[imposed]]";
    /// Its name, for messages.
    IMPOSED_NAME: Option<String> = "name", [Text], or "`imposed` and its number", "\"pin\"";
    /// The name of a node that is not clamped.
    IMPOSED_NODE: String = "node", [Text], required, "\"end\"";
    /// Prescribed displacements at load factor one; the others are free.
    DISPLACEMENT: Option<Components> = "displacement",
        [OneTable(&DISPLACEMENTS), Vector(3, Dimension::LENGTH)], optional, "{ y = 0, z = 0 }";
    /// Prescribed components of the rotation vector; the others are free.
    ROTATION: Option<Components> = "rotation",
        [OneTable(&ROTATIONS), Vector(3, Dimension::ANGLE)], optional,
        "{ x = 5 }";
    /// Rotation vector of the axes of these components.
    ORIENTATION: Vector3<f64> = "orientation", [Vector(3, Dimension::ANGLE)],
        or "[0, 0, 0]" = Vector3::zeros(), "[0, 0, 30]";
    /// Factor of the motion, a function of time or a signal with known rates.
    FACTOR: ByHand = "drive", [OneDrive(Dimension::NUMBER)], or "1", "\"= sin(t)\"";
    with CONSTANT.schema, IN.schema;
}

keys! {
    /// Prescribed displacements.
    DISPLACEMENTS = "displacement = { ... } of [[imposed]]";
    /// Along x.
    X: Option<f64> = "x", [Quantity(Dimension::LENGTH)], or "free", "0";
    /// Along y.
    Y: Option<f64> = "y", [Quantity(Dimension::LENGTH)], or "free", "0";
    /// Along z.
    Z: Option<f64> = "z", [Quantity(Dimension::LENGTH)], or "free", "0.1";
}

keys! {
    /// Prescribed components of the rotation vector.
    ROTATIONS = "rotation = { ... } of [[imposed]]";
    /// About x.
    ABOUT_X: Option<f64> = "x", [Quantity(Dimension::ANGLE)], or "free", "5";
    /// About y.
    ABOUT_Y: Option<f64> = "y", [Quantity(Dimension::ANGLE)], or "free", "0";
    /// About z.
    ABOUT_Z: Option<f64> = "z", [Quantity(Dimension::ANGLE)], or "free", "0";
}

keys! {
    /// Acceleration of gravity, a constant load.
    pub(super) GRAVITY = "[gravity]";
    /// Acceleration in the axes of the model.
    ACCELERATION: Vector3<f64> = "acceleration", [Vector(3, Dimension::ACCELERATION)], required,
        "[0, 0, -9.81]";
    /// Factor that depends on time.
    GRAVITY_DRIVE: ByHand = "drive", [OneDrive(Dimension::NUMBER)], or "1", "\"= min(t, 1)\"";
}

/// Reads `[gravity]` and its factor; zero if absent.
pub(super) fn gravity(
    root: &Table<'_>,
    builder: &mut ModelBuilder,
) -> Option<(Vector3<f64>, Drive)> {
    if !root.has("gravity") {
        return Some((Vector3::zeros(), Drive::Constant(1.0)));
    }
    let table = root.table("gravity")?;
    let found = table.get(&ACCELERATION);
    let drive = if table.has(&GRAVITY_DRIVE) {
        drives::read(&table, &GRAVITY_DRIVE.schema, builder.drives())
    } else {
        Some(Drive::Constant(1.0))
    };
    table.finish_beside(&OF_GRAVITY);
    let remark = found.as_ref().and_then(remark_on_gravity);
    builder.add_remarks(remark.into_iter().collect());
    found.zip(drive)
}

/// A remark on the acceleration of the earth in another unit: inches or millimeters as meters, or
/// meters as one of both.
fn remark_on_gravity(acceleration: &Vector3<f64>) -> Option<String> {
    const EARTH: f64 = 9.806_65;
    const FACTORS: [f64; 4] = [1e3, 39.37, 1e-3, 0.0254];
    let size = acceleration.norm();
    let is_it = |factor: &f64| (size / (factor * EARTH) - 1.0).abs() < 5e-3;
    FACTORS.iter().any(is_it).then(|| {
        let [size, times] = [size, size / EARTH].map(|x| short_number(x, 4));
        format!("[gravity] is {size} m/s^2, {times} times the one of the earth: check the unit")
    })
}

/// Adds every `[[load]]`, `[[distributed_load]]` and `[[imposed]]` to the model.
pub(super) fn read(root: &Table<'_>, builder: &mut ModelBuilder) {
    for (number, table) in root.tables("load").iter().enumerate() {
        let label = label(table, &NAME, "load", number);
        let is_new = builder.take_label("load", &label, table);
        let nodes = nodes(table, builder, &label);
        let load = nodal(table);
        let frame = builder.frames().of(table);
        let signal = drives::read_factor(table, &DRIVE.schema, builder.drives());
        table.finish();
        match (nodes, load, frame, signal) {
            (Some(nodes), Some((load, in_node)), Some(frame), Some(signal)) if is_new => {
                for &node in &nodes {
                    let on = &builder.nodes()[node];
                    let turn = |vector: Vector3<f64>| {
                        if in_node {
                            on.rotation * vector
                        } else {
                            frame.direction(&vector)
                        }
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
                    builder.add_load(Box::new(load));
                }
            }
            _ => builder.note_broken(),
        }
    }
    along_beams::read(root, builder);
    read_imposed(root, builder);
}

fn node(table: &Table<'_>, builder: &mut ModelBuilder, label: &str) -> Option<usize> {
    let name = table.get(&IMPOSED_NODE)?;
    builder.find_node(&name, table, IMPOSED_NODE.name(), &format!("\"{label}\""))
}

/// The node of a load, or one node of each blade of a card.
fn nodes(table: &Table<'_>, builder: &mut ModelBuilder, label: &str) -> Option<Vec<usize>> {
    let name = table.get(&NODE)?;
    let user = format!("\"{label}\"");
    let names = builder.node_names(&name);
    let found = names
        .iter()
        .map(|name| builder.find_node(name, table, NODE.name(), &user));
    // The first unknown name ends the search: the others differ only in the blade.
    found.collect()
}

/// The load of a card, and whether it is in the axes of its node.
fn nodal(table: &Table<'_>) -> Option<(NodalForce, bool)> {
    let (force, moment) = (table.get(&FORCE), table.get(&MOMENT));
    let (offset, in_node) = (table.get(&OFFSET), table.get(&AXES));
    let kind = kind(table);
    if !table.has(&FORCE) && !table.has(&MOMENT) {
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
    Some((load, in_node? == 1))
}

/// Dead or follower; constant, proportional, or released at the start of a run in time.
fn kind(table: &Table<'_>) -> Option<(Turning, LoadFactor)> {
    let follower = table.get(&FOLLOWER);
    let release = table.get(&RELEASE);
    let factor = factor(table);
    if release == Some(true) && table.has(&CONSTANT) {
        table.note(&RELEASE, &LoadProblem::ReleasedAndConstant);
        return None;
    }
    let factor = if release? {
        factor.map(|_| LoadFactor::Released)
    } else {
        factor
    };
    let turning = if follower? {
        Turning::Follower
    } else {
        Turning::Dead
    };
    Some((turning, factor?))
}

fn factor(table: &Table<'_>) -> Option<LoadFactor> {
    Some(if table.get(&CONSTANT)? {
        LoadFactor::Constant
    } else {
        LoadFactor::Proportional
    })
}

fn read_imposed(root: &Table<'_>, builder: &mut ModelBuilder) {
    // Line of the card that holds each component of each node.
    let mut held = BTreeMap::new();
    for (number, table) in root.tables("imposed").iter().enumerate() {
        let label = label(table, &IMPOSED_NAME, "imposed", number);
        let is_new = builder.take_label("imposed", &label, table);
        let node = node(table, builder, &label);
        let motion = imposed(table);
        let frame = builder.frames().of(table);
        let drive = if table.has(&FACTOR) {
            drives::read_position(table, &FACTOR.schema, builder.drives()).map(Some)
        } else {
            Some(None)
        };
        table.finish();
        let (Some(node), Some(mut motion), Some(frame), Some(drive), true) =
            (node, motion, frame, drive, is_new)
        else {
            builder.note_broken();
            continue;
        };
        if builder.clamped().any(|clamped| clamped == node) {
            let node = builder.nodes()[node].label.clone();
            table.note(&IMPOSED_NODE, &LoadProblem::Clamped { node });
            builder.note_broken();
            continue;
        }
        if let Some(line) = held.insert(node, table.line()) {
            let line = table.document().line_words(line);
            let node = builder.nodes()[node].label.clone();
            table.note(&IMPOSED_NODE, &LoadProblem::ImposedTwice { node, line });
            builder.note_broken();
            continue;
        }
        motion.axes = frame.axes(&motion.axes);
        let imposed = loads::imposed(label, node, &builder.nodes()[node], motion);
        let imposed = match drive {
            Some(signal) => imposed.scaled_by(signal),
            None => imposed,
        };
        builder.add_load(Box::new(imposed));
    }
}

fn imposed(table: &Table<'_>) -> Option<ImposedMotion> {
    let (displacement, rotation) = (table.get(&DISPLACEMENT), table.get(&ROTATION));
    let axes = table.get(&ORIENTATION).map(|phi| vector::to_rotation(&phi));
    let factor = factor(table);
    let (displacement, rotation) = (displacement?, rotation?);
    let [displacement, rotation] =
        [displacement, rotation].map(|found| found.map_or([None; 3], |found| found.0));
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
#[derive(Debug)]
struct Components([Option<f64>; 3]);

impl Declared for Components {}

impl Value for Components {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        let axes = key.kinds[0].table()?.keys;
        if !table.is_table(key) {
            let vector = table.vector(key.name, axes[0].dimension())?;
            return Some(Self([0, 1, 2].map(|i| Some(vector[i]))));
        }
        let inner = table.table(key)?;
        let found = [0, 1, 2].map(|i| inner.get(&Key::<Option<f64>>::new(axes[i], None)));
        inner.finish();
        let [x, y, z] = found;
        Some(Self([x?, y?, z?]))
    }
}
