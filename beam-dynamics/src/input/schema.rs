//! The description of the dynamics input: the list of its cards.
//!
//! Each card declares its keys next to its reader; the unknown keys of a file, the JSON
//! schema for editors ([`json_schema`]) and the reference of the book ([`reference`]) follow
//! from these declarations. A new card needs one line here.

use serde_json::Value;
use shared_geom::document::schema::ValueKind::{
    NamedTables, OtherTables, Parameters, Table, Tables, Text, Texts, Word,
};
use shared_geom::document::schema::{self, UNITS};
use shared_geom::document::{ByHand, PARAMETER_TABLE};
use shared_geom::keys;

use super::{
    aerodynamics, analyses, beams, blades, bodies, clamps, columns, control, drives, electrodes,
    frames, hub, internal_forces, joints, loads, measured, nodes, periodic, properties, rods,
    rotors, speeds, springs, stability, strips, transient, trim,
};

keys! {
    /// A structure or a mechanism, its rotation and loads, and the analyses.
    pub DYNAMICS_FILE = "NAME.dynamics.toml";
    /// Name of the model in reports and tables.
    NAME: ByHand = "name", [Text], or "NAME of the file", "\"swept tip, 45 deg\"";
    /// Units of plain numbers: SI with degrees and rpm, or the units of the table.
    UNITS_KEY: ByHand = "units", [Word(&["SI"]), Table(&UNITS)], required, "\"SI\"";
    /// Files whose cards are added, relative to the folder of this file.
    INCLUDE: ByHand = "include", [Texts], optional, "[\"blade.toml\", \"mast/mast.toml\"]";
    /// Numbers with names, for expressions; a quantity is converted to the declared unit.
    PARAMETERS: ByHand = "parameters", [Parameters(&PARAMETER_TABLE)], optional,
        "{ span = \"15 ft\", chord = \"= span/4\" }";
    /// Numbers that change with time, by name.
    DRIVES: ByHand = "drives", [NamedTables(&drives::DRIVE)], optional, "";
    /// Numbers of the state that expressions read, by name.
    SENSORS: ByHand = "sensors", [NamedTables(&control::SENSOR)], optional, "";
    /// Linear systems: filters, actuators and control laws.
    STATE_SPACES: ByHand = "state_space", [Tables(&control::STATE_SPACE)], optional, "";
    /// Actuators.
    ACTUATORS: ByHand = "actuator", [Tables(&control::ACTUATOR)], optional, "";
    /// Section properties of beams, by name.
    PROPERTIES: ByHand = "properties", [NamedTables(&properties::CARD)], optional, "";
    /// Rotation and support.
    HUB: ByHand = "hub", [Table(&hub::CARD)], optional, "";
    /// The air.
    AIR: ByHand = "air", [Table(&aerodynamics::AIR)], optional, "";
    /// Airfoils, by name.
    AIRFOILS: ByHand = "airfoils", [NamedTables(&aerodynamics::AIRFOIL)], optional, "";
    /// Velocities that rotors induce.
    INFLOWS: ByHand = "inflow", [Tables(&aerodynamics::INFLOW)], optional, "";
    /// Strips in the air on bodies and beams.
    STRIPS: ByHand = "strip", [Tables(&strips::STRIP)], optional, "";
    /// Polar copies of cards.
    REPEATS: ByHand = "repeat", [Tables(&REPEAT)], optional, "";
    /// Rotors, which expand to other cards.
    ROTORS: ByHand = "rotor", [Tables(&rotors::CARD)], optional, "";
    /// Gravity.
    GRAVITY: ByHand = "gravity", [Table(&loads::GRAVITY)], optional, "";
    /// Modes at rotor speeds.
    MODES: ByHand = "modes", [Table(&speeds::CARD)], optional, "";
    /// Equilibria.
    STATIC: ByHand = "static", [Table(&analyses::STATIC)], optional, "";
    /// Critical loads.
    BUCKLING: ByHand = "buckling", [Table(&analyses::BUCKLING)], optional, "";
    /// Motion in time.
    TRANSIENT: ByHand = "transient", [Table(&transient::TRANSIENT)], optional, "";
    /// Periodic motion.
    PERIODIC: ByHand = "periodic", [Table(&periodic::PERIODIC)], optional, "";
    /// Trim.
    TRIM: ByHand = "trim", [Table(&trim::TRIM)], optional, "";
    /// Stability over a parameter.
    STABILITY: ByHand = "stability", [Table(&stability::STABILITY)], optional, "";
    /// Output of runs in time.
    OUTPUT: ByHand = "output", [Table(&columns::CARD)], optional, "";
    /// Measured frequencies.
    MEASURED: ByHand = "measured", [Table(&measured::CARD)], optional, "";
    with FRAMES.schema, NODES.schema, BLADES.schema, BEAMS.schema, CLAMPS.schema, BODIES.schema,
        HINGES.schema, RIGIDS.schema, JOINTS.schema, RODS.schema, SPRINGS.schema, LOADS.schema,
        DISTRIBUTED_LOADS.schema, IMPOSED.schema, INTERNAL_FORCES.schema, ELECTRODES.schema;
}

keys! {
    /// Polar copies: copy i of n of the nested cards is turned by (i - 1)/n of a turn about the
    /// axis; each name that they define gets the suffix ` i`, wherever they use it.
    REPEAT = "[[repeat]]";
    /// Further repeats, with the same cards.
    INNER_REPEATS: ByHand = "repeat", [OtherTables], optional, "";
    with frames::REPEAT_NAME.schema, frames::COPIES.schema, frames::AXIS.schema,
        frames::CENTER.schema, frames::IN.schema, FRAMES.schema, NODES.schema, BLADES.schema,
        BEAMS.schema, CLAMPS.schema, BODIES.schema, HINGES.schema, RIGIDS.schema, JOINTS.schema,
        RODS.schema, SPRINGS.schema, LOADS.schema, DISTRIBUTED_LOADS.schema, IMPOSED.schema,
        INTERNAL_FORCES.schema, ELECTRODES.schema, STRIPS.schema;
}

keys! {
    /// Frames in which cards are written.
    FRAMES: ByHand = "frame", [Tables(&frames::CARD)], optional, "";
    /// Nodes.
    NODES: ByHand = "node", [Tables(&nodes::CARD)], optional, "";
    /// Blades.
    BLADES: ByHand = "blade", [Tables(&blades::CARD)], optional, "";
    /// Beams.
    BEAMS: ByHand = "beam", [Tables(&beams::CARD)], optional, "";
    /// Nodes held by the frame.
    CLAMPS: ByHand = "clamp", [Tables(&clamps::CARD)], optional, "";
    /// Concentrated masses.
    BODIES: ByHand = "body", [Tables(&bodies::CARD)], optional, "";
    /// Revolute joints with springs.
    HINGES: ByHand = "hinge", [Tables(&joints::HINGE)], optional, "";
    /// Rigid connections.
    RIGIDS: ByHand = "rigid", [Tables(&joints::RIGID)], optional, "";
    /// Joints.
    JOINTS: ByHand = "joint", [Tables(&joints::JOINT)], optional, "";
    /// Rods.
    RODS: ByHand = "rod", [Tables(&rods::CARD)], optional, "";
    /// Springs and dampers.
    SPRINGS: ByHand = "spring", [Tables(&springs::CARD)], optional, "";
    /// Loads on nodes.
    LOADS: ByHand = "load", [Tables(&loads::LOAD)], optional, "";
    /// Loads along blades and beams.
    DISTRIBUTED_LOADS: ByHand = "distributed_load", [Tables(&loads::DISTRIBUTED_LOAD)], optional, "";
    /// Prescribed motions of nodes.
    IMPOSED: ByHand = "imposed", [Tables(&loads::IMPOSED)], optional, "";
    /// Forces between nodes.
    INTERNAL_FORCES: ByHand = "internal_force", [Tables(&internal_forces::CARD)], optional, "";
    /// Electrodes and their circuits.
    ELECTRODES: ByHand = "electrode", [Tables(&electrodes::CARD)], optional, "";
}

/// The opening of the reference page.
const OPENING: &str = "\
# Dynamics input reference

Every key of a dynamics file, `NAME.dynamics.toml`.
Made by `beam-dynamics schema --format markdown`; do not edit.
The use of the keys is described in [Dynamics input](dynamics-input.md), [drives, parameters, frames, copies](drives.md), [laws](laws.md), [joints](joints.md), [rotors](rotors.md), [output of runs in time](time-output.md), [periodic motion](periodic.md), [trim](trim.md) and [stability](stability.md).

A *quantity* is a number in the declared units, or a text with its own unit, such as `\"73.1 GPa\"`.
A *drive* is a quantity, an expression such as `\"= 3*sin(t)\"`, the name of a drive, a sensor or an output, or a table as [`[drives.NAME]`](#drivesname).
In place of any number, a text that begins with `=` is an expression of parameters.
";

/// The JSON schema of a dynamics file, draft 2020-12.
///
/// It does not check names, the dimensions of units, expressions, and values that depend on
/// other keys; `beam-dynamics check` does.
pub fn json_schema() -> Value {
    schema::shared_json_schema(&DYNAMICS_FILE, schema::Numbers::Expressions)
}

/// The reference page of the dynamics file, in Markdown.
pub fn reference() -> String {
    schema::reference(&DYNAMICS_FILE, OPENING)
}
