//! The keys of quantities, for columns and sensors.

use nalgebra::Vector3;
use shared_geom::document::schema::ValueKind::{Count, NotNegative, Text, Vector, Word, Words};
use shared_geom::document::schema::{Family, KeySchema, Need, key};
use shared_geom::units::Dimension;
use shared_geom::{choice, keys};

use super::kind::SIX;

/// Components of a vector.
const PARTS: [&str; 4] = ["x", "y", "z", "magnitude"];
/// Words of the definitions of coefficients.
pub(super) const DEFINITIONS: [&str; 3] = ["rotor", "wind", "propeller"];
/// Angles about three axes.
const TURNS: [&str; 3] = ["first", "second", "third"];

/// The key that distinguishes the families, and its meaning.
const QUANTITY: [&str; 2] = ["quantity", "The quantity."];

/// The key of the object of a quantity.
pub(super) const OF: &str = "of";

/// Object of a quantity.
const fn of(example: &'static str, meaning: &'static str) -> KeySchema {
    key(OF, &[Text], Need::Required, example, meaning)
}

/// Components of a quantity.
const fn component(
    kinds: &'static [shared_geom::document::schema::ValueKind],
    example: &'static str,
) -> KeySchema {
    let meaning = "One component, or a list; a sensor has one.";
    key("component", kinds, Need::Default("all"), example, meaning)
}

const PART: KeySchema = component(&[Words(&PARTS)], "\"z\"");

/// Motions of nodes.
pub(in crate::input) const NODES: Family = Family {
    name: "motion of a node",
    meaning: "A vector of a node.",
    keys: &[
        choice!(
            QUANTITY,
            "position",
            "displacement",
            "velocity",
            "velocity_in_space",
            "rotation",
            "attitude",
            "angular_velocity",
            "angular_velocity_in_space"
        ),
        of("\"tip\"", "The name of a node."),
        AGAINST.schema,
        PART,
        IN.schema,
    ],
};
/// Momenta of nodes.
pub(in crate::input) const MOMENTA: Family = Family {
    name: "momentum of a node",
    meaning: "The momentum of the bodies on a node, the angular one about the node.",
    keys: &[
        choice!(QUANTITY, "momentum", "angular_momentum"),
        of("\"tip\"", "The name of a node."),
        AGAINST.schema,
        PART,
        IN.schema,
    ],
};
/// Sections of beams.
pub(in crate::input) const SECTIONS: Family = Family {
    name: "section of a beam",
    meaning: "Internal force and moment, or strain and curvature, in section axes.",
    keys: &[
        choice!(QUANTITY, "internal_force", "strain"),
        of("\"blade/beam 1\"", "The name of a beam."),
        POINT.schema,
        component(&[Words(&SIX)], "\"bending_y\""),
    ],
};
/// Reactions of joints.
pub(in crate::input) const REACTIONS: Family = Family {
    name: "reaction",
    meaning: "The load of a joint on a node, about the node.",
    keys: &[
        choice!(QUANTITY, "reaction_force", "reaction_moment"),
        of(
            "\"pin\"",
            "The name of a joint, a support or an imposed motion; a clamp is called \
             `clamp of NODE`.",
        ),
        NODE.schema,
        PART,
        IN_JOINT.schema,
    ],
};
/// Motions of joints.
pub(in crate::input) const JOINTS: Family = Family {
    name: "motion of a joint",
    meaning: "The motion of the second end relative to the first, in the axes of the joint that \
              turn with the first.",
    keys: &[
        choice!(
            QUANTITY,
            "joint_displacement",
            "joint_rotation",
            "joint_velocity",
            "joint_angular_velocity"
        ),
        of("\"pin\"", "The name of a joint."),
        PART,
    ],
};
/// Angles of joints.
pub(in crate::input) const ANGLES: Family = Family {
    name: "angle of a joint",
    meaning: "The angle about the axis of a joint.",
    keys: &[
        choice!(QUANTITY, "joint_angle"),
        of("\"pin\"", "The name of a joint with an axis."),
    ],
};
/// Springs and rods.
pub(in crate::input) const SPRINGS: Family = Family {
    name: "rod or spring",
    meaning: "Deformation and force of a rod or a spring between two nodes.",
    keys: &[
        choice!(
            QUANTITY,
            "spring_displacement",
            "spring_rotation",
            "spring_force",
            "spring_moment"
        ),
        of("\"stay\"", "The name of a rod or a spring."),
        PART,
    ],
};
/// Electrodes.
pub(in crate::input) const ELECTRODES: Family = Family {
    name: "electrode",
    meaning: "Voltage relative to ground, free charge, or current into an electrode.",
    keys: &[
        choice!(QUANTITY, "voltage", "charge", "current"),
        of("\"afc\"", "The name of an electrode."),
    ],
};
/// Energies that sensors read.
pub(in crate::input) const ENERGIES: Family = Family {
    name: "energy",
    meaning: "An energy of the whole model; `energy` is the sum.",
    keys: &[choice!(
        QUANTITY,
        "kinetic_energy",
        "elastic_energy",
        "gravity_energy",
        "energy"
    )],
};

/// The blade or card of a strip.
const OF_STRIPS: KeySchema = of(
    "\"blade 1\"",
    "The name of a blade with strips, or of a `[[strip]]`.",
);

/// Strips.
pub(in crate::input) const STRIPS: Family = Family {
    name: "strip",
    meaning: "Flow, coefficients and loads at a point of a blade or of a line of strips in the air.",
    keys: &[
        choice!(
            QUANTITY,
            "angle_of_attack",
            "inflow_angle",
            "induced_velocity",
            "induced_swirl",
            "flow_speed",
            "lift_coefficient",
            "drag_coefficient",
            "moment_coefficient",
            "mach",
            "reynolds",
            "normal_load",
            "lift_load",
            "drag_load",
            "moment_load"
        ),
        OF_STRIPS,
        AT.schema,
        STRIP.schema,
    ],
};

/// Sums over the strips of a rotor.
pub(in crate::input) const ROTORS: Family = Family {
    name: "rotor",
    meaning: "Thrust along the axis of the hub and torque about it, of the air on the blades; power, the \
              torque times the speed of rotation, positive for turbines.",
    keys: &[choice!(QUANTITY, "thrust", "torque", "power"), ROTOR.schema],
};

/// All quantities of columns.
pub(in crate::input) const OF_COLUMNS: [Family; 19] = [
    NODES,
    Family {
        name: "Euler angles",
        meaning: "The attitude as rotations about the axes of the node, each moved by the \
                  previous ones.",
        keys: &[
            choice!(QUANTITY, "euler_angles"),
            of("\"tip\"", "The name of a node."),
            AGAINST.schema,
            SEQUENCE.schema,
            component(&[Words(&TURNS)], "\"first\""),
        ],
    },
    MOMENTA,
    Family {
        name: "momentum of the model",
        meaning: "The momentum of the whole model.",
        keys: &[choice!(QUANTITY, "momentum"), PART],
    },
    Family {
        name: "angular momentum of the model",
        meaning: "The angular momentum of the whole model about a point.",
        keys: &[choice!(QUANTITY, "angular_momentum"), PART, ABOUT.schema],
    },
    SECTIONS,
    REACTIONS,
    JOINTS,
    ANGLES,
    SPRINGS,
    ELECTRODES,
    STRIPS,
    Family {
        name: "load around the shaft",
        meaning: "Force per length around the shaft of the rotor, without a rotor along the chord, at \
                  a point of a blade or of a line of strips.",
        keys: &[
            choice!(QUANTITY, "tangential_load"),
            OF_STRIPS,
            AT.schema,
            STRIP.schema,
        ],
    },
    ROTORS,
    Family {
        name: "coefficient of a rotor",
        meaning: "Thrust, torque, power and speeds of a rotor as numbers.",
        keys: &[
            choice!(
                QUANTITY,
                "thrust_coefficient",
                "torque_coefficient",
                "power_coefficient",
                "efficiency",
                "advance_ratio",
                "tip_speed_ratio",
                "figure_of_merit"
            ),
            ROTOR.schema,
            DEFINITION.schema,
        ],
    },
    Family {
        name: "drive",
        meaning: "The value of a drive, in the `unit` of the column.",
        keys: &[
            choice!(QUANTITY, "drive"),
            of(
                "\"swing\"",
                "The name of a drive, or an expression of time.",
            ),
        ],
    },
    Family {
        name: "signal",
        meaning: "The value of a sensor, an output, or an expression of them and of time.",
        keys: &[
            choice!(QUANTITY, "signal"),
            of("\"torque\"", "The name of a signal, or an expression."),
        ],
    },
    ENERGIES,
    Family {
        name: "model and step",
        meaning: "The electric energy, and length and iterations of the step.",
        keys: &[choice!(
            QUANTITY,
            "electric_energy",
            "step_length",
            "iterations"
        )],
    },
];

keys! {
    /// Another node to which the quantity is relative: vectors are subtracted, rotations are seen
    /// by it, with components in its axes without `in`.
    pub(super) AGAINST: Option<String> = "against", [Text], optional, "\"mast\"";
    /// Axes of the components: `"model"`, the name of a node for its current axes, or of a frame.
    pub(super) IN: Option<String> = "in", [Text], or "\"model\"", "\"mast\"";
    /// The same, or `"first"` or `"second"` for the axes of the joint that turn with that end.
    IN_JOINT: Option<String> = "in", [Text], or "\"model\"", "\"first\"";
    /// Order of the three axes: `"zyx"` are yaw, pitch and roll.
    pub(super) SEQUENCE: String = "sequence", [Text], or "\"zyx\"" = "zyx".to_owned(), "\"zxz\"";
    /// The point about which the angular momentum is taken.
    pub(super) ABOUT: Vector3<f64> = "about", [Vector(3, Dimension::LENGTH)],
        or "[0, 0, 0]" = Vector3::zeros(), "[0, 0, 1]";
    /// Evaluation point: 1 is near the first node.
    pub(super) POINT: usize = "point", [Count(2)] as "1 or 2: beams have two evaluation points, 1 near the first node",
        or "1" = 1, "2";
    /// Position as a part of the radius of the tip, undeformed, or of the length of a line of strips
    /// without a rotor; linear between two strips. One of `at` and `strip` is needed.
    pub(super) AT: Option<f64> = "at", [NotNegative(Dimension::NUMBER)], optional, "0.75";
    /// Number of the strip, from the root.
    pub(super) STRIP: Option<usize> = "strip", [Count(usize::MAX)], optional, "7";
    /// The name of the inflow of the rotor; `"rotor"` for blades without one.
    pub(super) ROTOR: Option<String> = "of", [Text], or "the only rotor", "\"rotor\"";
    /// Field whose definition is used: by the speed of the tip (`rotor`, helicopters), by the wind
    /// (`wind`, turbines), or by revolutions per second and the diameter (`propeller`).
    pub(super) DEFINITION: Option<usize> = "definition", [Word(&DEFINITIONS)],
        or "the first that has the quantity", "\"wind\"";
    /// The node on which the reaction acts.
    pub(super) NODE: Option<String> = "node", [Text], or "the last node of the joint", "\"root\"";
}
