//! Springs and dampers between two nodes, or between a node and the frame or the ground.

use nalgebra::{Matrix3, Vector3};
use shared_geom::document::schema::ValueKind::{Text, Vector, Word};
use shared_geom::document::schema::{Family, TableSchema};
use shared_geom::document::{Key, Table};
use shared_geom::keys;
use shared_geom::rotation::{skew, vector};
use shared_geom::units::Dimension;

use super::builder::ModelBuilder;
use super::ends::label;
use super::frames::IN;
use super::laws::LawProblem;
use super::problem::InputProblem;
use super::too_stiff;
use crate::elements::springs::{SupportFrame, SupportLaw, SupportSpring};

mod between;

/// Words of `fixed_to`.
const FIXED_TO_WORDS: [&str; 2] = ["frame", "world"];

/// A spring between a node and the frame or the ground, or between two nodes.
pub(super) const CARD: TableSchema = TableSchema {
    title: "[[spring]]",
    meaning: "A spring and damper of displacements and rotations.",
    keys: &[
        NAME.schema,
        ORIENTATION.schema,
        STIFFNESS.schema,
        ROTATIONAL_STIFFNESS.schema,
        DAMPING.schema,
        ROTATIONAL_DAMPING.schema,
        IN.schema,
    ],
    families: &[
        Family {
            name: "support",
            meaning: "Between a node and the frame or the ground.",
            keys: &[NODE.schema, FIXED_TO.schema],
        },
        between::OF_TWO_NODES,
        between::OF_ONE_NODE,
    ],
};

keys! {
    /// Its name, for messages and output.
    NAME: Option<String> = "name", [Text], or "`spring` and its number", "\"mount\"";
    /// The name of a node; the spring is between it and the frame.
    NODE: String = "node", [Text], required, "\"engine\"";
    /// Rotation vector of the axes of the spring, in the undeformed model.
    ORIENTATION: Vector3<f64> = "orientation", [Vector(3, Dimension::ANGLE)],
        or "[0, 0, 0]" = Vector3::zeros(), "[0, 0, 30]";
    /// Stiffnesses along the axes, zero or more.
    STIFFNESS: Vector3<f64> = "stiffness", [Vector(3, Dimension::SPRING_STIFFNESS)],
        or "[0, 0, 0]" = Vector3::zeros(),
        "[4e6, 4e6, 9e6]";
    /// Stiffnesses about the axes, moment per radian, zero or more.
    ROTATIONAL_STIFFNESS: Vector3<f64> = "rotational_stiffness", [Vector(3, Dimension::MOMENT)],
        or "[0, 0, 0]" = Vector3::zeros(), "[2e4, 2e4, 0]";
    /// Dampers along the axes, zero or more.
    DAMPING: Vector3<f64> = "damping", [Vector(3, Dimension::DAMPER)],
        or "[0, 0, 0]" = Vector3::zeros(), "[300, 300, 0]";
    /// Dampers about the axes, moment per angular velocity in radians per time, zero or more.
    ROTATIONAL_DAMPING: Vector3<f64> = "rotational_damping",
        [Vector(3, Dimension::TURNING_DAMPER)], or "[0, 0, 0]" = Vector3::zeros(), "[5, 5, 0]";
    /// Fixed end: the frame of the model, which turns with the hub, or the ground.
    FIXED_TO: usize = "fixed_to", [Word(&FIXED_TO_WORDS)], or "\"frame\"" = 0, "\"world\"";
}

/// Keys of stiffnesses along and about the axes.
const STIFFNESSES: [&Key<Vector3<f64>>; 2] = [&STIFFNESS, &ROTATIONAL_STIFFNESS];
/// Keys of dampers along and about the axes.
const DAMPERS: [&Key<Vector3<f64>>; 2] = [&DAMPING, &ROTATIONAL_DAMPING];

/// Part of the largest entry below which a matrix, and part of the largest coordinate below
/// which a distance from the axis, is treated as zero: digits lost in the input.
const ROUNDING: f64 = 1e-9;

/// A spring as its card defines it.
struct Spring {
    axes: Matrix3<f64>,
    /// Along the axes \[N/m\], about them \[N m\].
    stiffness: [f64; 6],
    /// Along the axes \[N s/m\], about them \[N m s\].
    damping: [f64; 6],
    support_frame: SupportFrame,
}

/// Adds every `[[spring]]` to the model.
pub(super) fn read(root: &Table<'_>, builder: &mut ModelBuilder) {
    for (number, table) in root.tables("spring").iter().enumerate() {
        let label = label(table, &NAME, "spring", number);
        let is_new = builder.take_label("spring", &label, table);
        if between::is_one(table) {
            let spring = between::read(table, builder, &label);
            table.finish();
            match spring {
                Some(spring) if is_new => builder.add_joint(Box::new(spring)),
                _ => builder.note_broken(),
            }
            continue;
        }
        let words = format!("spring \"{label}\"");
        let name = table.get(&NODE);
        let node = name.and_then(|name| builder.find_node(&name, table, NODE.name(), &words));
        let spring = spring(table).zip(builder.frames().of(table));
        let spring = spring.map(|(spring, frame)| Spring {
            axes: frame.axes(&spring.axes),
            ..spring
        });
        table.finish();
        match (node, spring) {
            (Some(node), Some(spring)) if is_new => add(&spring, (node, label), table, builder),
            _ => builder.note_broken(),
        }
    }
}

fn spring(table: &Table<'_>) -> Option<Spring> {
    let axes = table.get(&ORIENTATION);
    let stiffness = six(table, STIFFNESSES);
    let damping = six(table, DAMPERS);
    let support_frame = table.get(&FIXED_TO);
    Some(Spring {
        axes: vector::to_rotation(&axes?),
        stiffness: stiffness?,
        damping: damping?,
        support_frame: [SupportFrame::Frame, SupportFrame::World][support_frame?],
    })
}

/// Three numbers under each key, zero or more; zeros if absent.
fn six(table: &Table<'_>, keys: [&Key<Vector3<f64>>; 2]) -> Option<[f64; 6]> {
    let three = |key: &Key<Vector3<f64>>| {
        if table.has(key) && !table.is_list(key) {
            table.note(key, &LawProblem::OneNumber { key: key.name() });
            return None;
        }
        let dimension = key.schema.dimension();
        let expected = format!("an array of 3, each {dimension}, zero or more");
        let found = table.get_if(key, |numbers| numbers.min() >= 0.0, &expected)?;
        too_stiff::is_resolved(table, key.name(), found.iter().copied()).then_some(found)
    };
    let [along, about] = keys.map(three);
    let (along, about) = (along?, about?);
    Some([along.x, along.y, along.z, about.x, about.y, about.z])
}

fn add(
    spring: &Spring,
    (index, label): (usize, String),
    table: &Table<'_>,
    builder: &mut ModelBuilder,
) {
    let law = SupportLaw::along(&spring.axes, &spring.stiffness, &spring.damping);
    let node = builder.nodes()[index].clone();
    let turns_with = builder.hub().map(|hub| hub.frame_rotation());
    if let (SupportFrame::World, Some(frame_rotation)) = (spring.support_frame, turns_with) {
        let off = node.position - frame_rotation.center;
        let across = off - frame_rotation.axis * frame_rotation.axis.dot(&off);
        let size = node.position.amax().max(frame_rotation.center.amax());
        if across.amax() > ROUNDING * size {
            let (spring, node) = (label, node.label);
            table.note(&FIXED_TO, &InputProblem::OffAxis { spring, node });
            return builder.note_broken();
        }
        if !is_isotropic(&law, &frame_rotation.axis) {
            table.note(&FIXED_TO, &InputProblem::Anisotropic { spring: label });
            return builder.note_broken();
        }
    }
    let support = SupportSpring::new(label, index, &node, law, spring.support_frame);
    builder.add_joint(Box::new(support));
}

/// Whether a law is isotropic about an axis: its matrices
/// commute with the rotations about it.
fn is_isotropic(law: &SupportLaw, axis: &Vector3<f64>) -> bool {
    let turn = skew(axis);
    let parts = [
        law.stiffness,
        law.damping,
        law.turning_stiffness,
        law.turning_damping,
    ];
    let turned = |part: &Matrix3<f64>| (part * turn - turn * part).amax();
    parts
        .iter()
        .all(|part| turned(part) <= ROUNDING * part.amax())
}
