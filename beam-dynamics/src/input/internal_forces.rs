//! Forces between two nodes: `[[internal_force]]`.

use nalgebra::{Matrix3, Vector3};
use shared_geom::document::schema::ValueKind::{Quantity, Text, Texts, Vector, Vectors, Word};
use shared_geom::document::schema::{Family, TableSchema};
use shared_geom::document::{Key, Table};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::builder::ModelBuilder;
use super::frames::{Frame, IN};
use super::laws::LawProblem;
use super::loads::{CONSTANT, DRIVE};
use super::{drives, ends};
use crate::elements::loads::{Between, InternalForce, LoadFactor};

/// A force between two nodes.
pub(super) const CARD: TableSchema = TableSchema {
    title: "[[internal_force]]",
    meaning: "A force and a moment on a node, and the opposite ones on another.",
    keys: &[
        NAME.schema,
        NODES.schema,
        DRIVE.schema,
        CONSTANT.schema,
        IN.schema,
    ],
    families: &[
        Family {
            name: "along the line",
            meaning: "Along the line between the two points.",
            keys: &[TENSION.schema, OFFSETS.schema],
        },
        Family {
            name: "in axes",
            meaning: "By components, which turn with the first node; one of force and moment is \
                      needed.",
            keys: &[FORCE.schema, MOMENT.schema, OFFSET.schema, AXES.schema],
        },
    ],
};

keys! {
    /// Its name, for messages.
    NAME: Option<String> = "name", [Text], or "`internal force` and its number", "\"jack\"";
    /// The names of two nodes.
    NODES: Vec<String> = "nodes", [Texts], required, "[\"foot\", \"hook\"]";
    /// Tension along the line between the nodes.
    TENSION: f64 = "tension", [Quantity(Dimension::FORCE)], required, "\"2 kN\"";
    /// Offsets of the points from the two nodes, in their axes.
    OFFSETS: Option<Vec<Vector3<f64>>> = "offsets", [Vectors(3, Dimension::LENGTH)], or "zero",
        "[[0, 0, 0], [0.1, 0, 0]]";
    /// Force on the second node.
    FORCE: Vector3<f64> = "force", [Vector(3, Dimension::FORCE)],
        or "[0, 0, 0]" = Vector3::zeros(), "[0, 0, 120]";
    /// Moment on the second node.
    MOMENT: Vector3<f64> = "moment", [Vector(3, Dimension::MOMENT)],
        or "[0, 0, 0]" = Vector3::zeros(), "[0, 5, 0]";
    /// Point of application relative to the second node, in its axes.
    OFFSET: Vector3<f64> = "offset", [Vector(3, Dimension::LENGTH)],
        or "[0, 0, 0]" = Vector3::zeros(), "[0, 0.1, 0]";
    /// Axes of the components: the model, or the first node, both undeformed.
    AXES: usize = "axes", [Word(&["model", "node"])], or "\"model\"" = 0, "\"node\"";
}

/// Adds every `[[internal_force]]` to the model.
pub(super) fn read(root: &Table<'_>, builder: &mut ModelBuilder) {
    for (number, table) in root.tables("internal_force").iter().enumerate() {
        let label = ends::label(table, &NAME, "internal force", number);
        let is_new = builder.take_label("load", &label, table);
        let force = force(table, builder, &label);
        table.finish();
        match force {
            Some(force) if is_new => builder.add_load(Box::new(force)),
            _ => builder.note_broken(),
        }
    }
}

fn force(table: &Table<'_>, builder: &mut ModelBuilder, label: &str) -> Option<InternalForce> {
    let words = format!("internal force \"{label}\"");
    let nodes = ends::nodes((table, &NODES), builder, &words, false);
    let signal = drives::read_factor(table, &DRIVE.schema, builder.drives());
    let factor = table.get(&CONSTANT);
    let frame = builder.frames().of(table);
    let between = if table.has(&TENSION) {
        along_line(table, nodes.as_deref())
    } else {
        in_axes(table, nodes.as_deref(), (builder, frame))
    };
    let factor = if factor? {
        LoadFactor::Constant
    } else {
        LoadFactor::Proportional
    };
    Some(InternalForce::new(
        label,
        builder.nodes(),
        between?,
        factor,
        signal?,
    ))
}

fn along_line(table: &Table<'_>, nodes: Option<&[usize]>) -> Option<Between> {
    let tension = table.get(&TENSION);
    let others = [&FORCE, &MOMENT].into_iter();
    if let Some(second) = others.map(Key::name).find(|key| table.has(key)) {
        let first = TENSION.name();
        table.note(second, &LawProblem::Twice { first, second });
        for key in CARD.all_keys() {
            let _ = table.has(key);
        }
        return None;
    }
    let Some(&[a, b]) = nodes else {
        let _ = table.has(&OFFSETS);
        return None;
    };
    Some(Between::Line {
        ends: ends::points(table, &OFFSETS, [a, b])?,
        tension: tension?,
    })
}

/// A force along the axes of the model, or of the frame of its card, or of a node.
fn in_axes(
    table: &Table<'_>,
    nodes: Option<&[usize]>,
    (builder, frame): (&ModelBuilder, Option<Frame>),
) -> Option<Between> {
    let (force, moment) = (table.get(&FORCE), table.get(&MOMENT));
    let (offset, in_node) = (table.get(&OFFSET), table.get(&AXES));
    if !table.has(&FORCE) && !table.has(&MOMENT) {
        table.note("", &LawProblem::NoForce);
        return None;
    }
    let &[a, b] = nodes? else { return None };
    let axes = match in_node? {
        0 => frame?.axes(&Matrix3::identity()),
        _ => builder.nodes()[a].rotation,
    };
    Some(Between::Axes {
        nodes: [a, b],
        offset: offset?,
        force: axes * force?,
        moment: axes * moment?,
    })
}
