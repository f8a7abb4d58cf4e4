//! The keys of `[[joint]]`, by its kinds.

use nalgebra::Vector3;
use shared_geom::document::ByHand;
use shared_geom::document::schema::ValueKind::{Drive, Table, Text, Texts, Vector, Vectors, Words};
use shared_geom::document::schema::{Family, KeySchema, Need, TableSchema, key};
use shared_geom::units::Dimension;
use shared_geom::{choice, keys};

use super::{AXIS, AXIS_IN};
use crate::input::frames::IN;

/// Degrees of freedom of a total joint.
pub(super) const FREEDOMS: [&str; 6] = ["x", "y", "z", "about x", "about y", "about z"];

/// The key that distinguishes the families, and its meaning.
pub(super) const KIND: [&str; 2] = ["kind", "Kind of the joint."];

/// A joint.
pub(in crate::input) const JOINT: TableSchema = TableSchema {
    title: "[[joint]]",
    meaning: "A joint of two nodes, of which the second moves relative to the first, or of one \
              node, which moves relative to the frame of the model.",
    keys: &[NAME.schema, NODES.schema, AT.schema, IN.schema],
    families: &[
        Family {
            name: "fixed",
            meaning: "No relative motion, or rotation about a point only.",
            keys: &[choice!(KIND, "clamp", "spherical")],
        },
        Family {
            name: "rotation about an axis",
            meaning: "Free or driven rotation about an axis.",
            keys: &[
                choice!(KIND, "revolute", "plane-rotation", "spin"),
                AXIS.schema,
                AXIS_IN.schema,
                ANGLE.schema,
                SPEED.schema,
            ],
        },
        Family {
            name: "cylindrical",
            meaning: "Free or driven rotation about an axis and displacement along it.",
            keys: &[
                choice!(KIND, "cylindrical"),
                FROM.schema,
                AXIS.schema,
                AXIS_IN.schema,
                ANGLE.schema,
                SPEED.schema,
                DISPLACEMENT.schema,
            ],
        },
        Family {
            name: "displacement along an axis",
            meaning: "Free or driven along the axis, or held along it for `in-plane`.",
            keys: &[
                choice!(KIND, "prismatic", "in-plane"),
                FROM.schema,
                AXIS.schema,
                AXIS_IN.schema,
                DISPLACEMENT.schema,
            ],
        },
        Family {
            name: "in-line",
            meaning: "A point that moves along a line.",
            keys: &[
                choice!(KIND, "in-line"),
                FROM.schema,
                AXIS.schema,
                AXIS_IN.schema,
            ],
        },
        Family {
            name: "universal",
            meaning: "Rotation about two axes.",
            keys: &[choice!(KIND, "universal"), AXES.schema, AXIS_IN.schema],
        },
        Family {
            name: "distance",
            meaning: "A given distance of two points.",
            keys: &[choice!(KIND, "distance"), FROM.schema, LENGTH.schema],
        },
        Family {
            name: "position",
            meaning: "Driven components of the position.",
            keys: &[
                choice!(KIND, "position"),
                FROM.schema,
                ORIENTATION.schema,
                DISPLACEMENTS.schema,
            ],
        },
        Family {
            name: "rotation",
            meaning: "Driven components of the rotation.",
            keys: &[
                choice!(KIND, "rotation"),
                ORIENTATION.schema,
                ROTATION.schema,
            ],
        },
        Family {
            name: "velocity",
            meaning: "Driven components of the velocities.",
            keys: &[
                choice!(KIND, "velocity"),
                FROM.schema,
                ORIENTATION.schema,
                VELOCITY.schema,
                ANGULAR_VELOCITY.schema,
            ],
        },
        Family {
            name: "total",
            meaning: "Any degrees of freedom locked or driven, the others free.",
            keys: &[
                choice!(KIND, "total"),
                FROM.schema,
                ORIENTATION.schema,
                LOCKED.schema,
                DISPLACEMENTS.schema,
                ROTATION.schema,
            ],
        },
    ],
};

keys! {
    /// Its name, for messages and output.
    pub(super) NAME: Option<String> = "name", [Text], or "`joint` and its number", "\"crank\"";
    /// The names of two nodes, or of one, which is joined to the frame.
    pub(super) NODES: Vec<String> = "nodes", [Texts], required, "[\"hub\", \"root\"]";
    /// The point of the joint in the undeformed model; without it the last node. For the distance of one node from a fixed
    /// point it is the point of the frame.
    pub(super) AT: Option<Vector3<f64>> = "at", [Vector(3, Dimension::LENGTH)], optional,
        "[0, 0, 1]";
    /// The point on the first end; without it the point `at`, or for `distance` the first node.
    pub(super) FROM: Option<Vector3<f64>> = "from", [Vector(3, Dimension::LENGTH)], optional,
        "[0, 0, 0]";
    /// The axis on the first end, and the axis on the second.
    pub(super) AXES: Vec<Vector3<f64>> = "axes", [Vectors(3, Dimension::NUMBER)]
        as "the axis on the first end and on the second", required,
        "[[0, 1, 0], [0, 0, 1]]";
    /// Rotation vector of the axes of the components; they turn with the first end.
    pub(super) ORIENTATION: Vector3<f64> = "orientation", [Vector(3, Dimension::ANGLE)],
        or "[0, 0, 0]" = Vector3::zeros(), "[0, 0, 30]";
    /// Prescribed angle about the axis.
    pub(super) ANGLE: ByHand = "angle", [Drive(Dimension::ANGLE)], optional, "\"= 360*t\"";
    /// Prescribed angular velocity about the axis.
    pub(super) SPEED: ByHand = "speed", [Drive(Dimension::ROTATION_SPEED)], optional, "60";
    /// Prescribed displacement along the axis.
    pub(super) DISPLACEMENT: ByHand = "displacement", [Drive(Dimension::LENGTH)], optional,
        "\"= 0.1*sin(t)\"";
    /// Prescribed distance.
    pub(super) LENGTH: ByHand = "length", [Drive(Dimension::LENGTH)],
        or "the distance in the undeformed model", "\"= 2 - 0.1*t\"";
    /// Driven components of the displacement; the others are free.
    pub(super) DISPLACEMENTS: ByHand = "displacement",
        [Table(&LENGTHS), Vector(3, Dimension::LENGTH)], optional, "{ x = 0, z = \"= 0.1*sin(t)\" }";
    /// Driven components of the rotation; the others are free.
    pub(super) ROTATION: ByHand = "rotation", [Table(&ANGLES), Vector(3, Dimension::ANGLE)],
        optional, "{ z = \"= 10*t\" }";
    /// Driven components of the velocity of the point, relative to the first end.
    pub(super) VELOCITY: ByHand = "velocity", [Table(&VELOCITIES), Vector(3, Dimension::VELOCITY)],
        optional, "{ x = 1 }";
    /// Driven components of the angular velocity, relative to the first end.
    pub(super) ANGULAR_VELOCITY: ByHand = "angular_velocity",
        [Table(&SPEEDS), Vector(3, Dimension::ROTATION_SPEED)], optional, "{ z = 60 }";
    /// Degrees of freedom that are fixed at their undeformed values, at the distance between
    /// `from` and `at`.
    pub(super) LOCKED: Vec<usize> = "locked", [Words(&FREEDOMS)], or "none" = Vec::new(),
        "[\"z\", \"about x\", \"about y\"]";
}

/// A table of the driven components of a vector.
macro_rules! components {
    ($TABLE:ident, $title:literal, $meaning:literal, $dimension:expr) => {
        const $TABLE: TableSchema = TableSchema {
            title: $title,
            meaning: $meaning,
            keys: &[
                component("x", &[Drive($dimension)], "Along x."),
                component("y", &[Drive($dimension)], "Along y."),
                component("z", &[Drive($dimension)], "Along z."),
            ],
            families: &[],
        };
    };
}

/// A driven component.
const fn component(
    name: &'static str,
    kinds: &'static [shared_geom::document::schema::ValueKind],
    meaning: &'static str,
) -> KeySchema {
    key(name, kinds, Need::Default("free"), "\"= 0.1*t\"", meaning)
}

components!(
    LENGTHS,
    "displacement = { ... } of [[joint]]",
    "Driven displacements.",
    Dimension::LENGTH
);
components!(
    ANGLES,
    "rotation = { ... } of [[joint]]",
    "Driven components of the rotation.",
    Dimension::ANGLE
);
components!(
    VELOCITIES,
    "velocity = { ... } of [[joint]]",
    "Driven velocities.",
    Dimension::VELOCITY
);
components!(
    SPEEDS,
    "angular_velocity = { ... } of [[joint]]",
    "Driven angular velocities.",
    Dimension::ROTATION_SPEED
);
