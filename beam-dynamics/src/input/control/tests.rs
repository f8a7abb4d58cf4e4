//! Tests of sensors, signals and actuators as cards.

#![allow(
    clippy::unwrap_used,
    reason = "helpers of tests unwrap inputs of the tests"
)]

use crate::input::Input;
use crate::input::test_files::{STRIP, read_beside, reported};
use crate::model::{Conditions, NODE_UNKNOWNS, State};

const MODEL: &str = "
[[node]]
name = \"a\"
position = [0, 0, 0]
[[node]]
name = \"b\"
position = [1, 0, 0]
[[body]]
node = \"b\"
mass = 2
inertia = [1, 1, 1]
[[joint]]
name = \"arm\"
kind = \"revolute\"
nodes = [\"a\"]
at = [0, 0, 0]
axis = [0, 0, 1]
angle = \"servo\"
[[joint]]
name = \"tip\"
kind = \"clamp\"
nodes = [\"a\", \"b\"]
at = [1, 0, 0]
[sensors.pull]
quantity = \"reaction_force\"
of = \"tip\"
component = \"x\"
unit = \"kN\"
[sensors.turn]
quantity = \"joint_angle\"
of = \"arm\"
unit = \"rad\"
[[actuator]]
name = \"servo\"
command = \"= 0.3 + pull + 0*turn\"
frequency = 5
[transient]
to = 1
step = 0.01
";

fn input(cards: &str) -> Result<Input, String> {
    read_beside(&format!("units = \"SI\"\n{STRIP}{cards}"), &[])
}

#[track_caller]
fn refused(cards: &str) -> String {
    reported(input(cards))
}

/// The residuals of the constraints at a state at rest with all scalars at `value`.
fn constraints(cards: &str, value: f64) -> Vec<f64> {
    let system = input(cards).unwrap().model.system;
    let state = State {
        scalars: vec![value; system.scalars().len()],
        ..system.rest()
    };
    let off = system.residual(&state, &Conditions::at_rest()).values;
    let first = NODE_UNKNOWNS * system.nodes().len();
    off[first..first + 6].to_vec()
}

// The sine of 0.2 deg, of 0.2 rad and of 2 * 0.2 deg: angles are declared in degrees.
#[test]
fn names_count_in_their_own_unit_and_expressions_in_that_of_the_key() {
    let off = |cards: &str| {
        let rows = constraints(cards, 0.2);
        rows.into_iter().fold(0.0_f64, |a, b| a.max(b.abs()))
    };
    let sine = |angle: f64| angle.sin();
    assert!((off(MODEL) - sine(0.2_f64.to_radians())).abs() < 1e-15);
    let rad = MODEL.replace("frequency = 5", "frequency = 5\nunit = \"rad\"");
    assert!((off(&rad) - sine(0.2)).abs() < 1e-15);
    let twice = rad.replace("angle = \"servo\"", "angle = \"= 2*servo\"");
    assert!((off(&twice) - sine(0.4_f64.to_radians())).abs() < 1e-15);
    let force = refused(&rad.replace("\"rad\"\n[transient]", "\"N\"\n[transient]"));
    assert!(
        force.contains("\"servo\" measures a force, expected an angle"),
        "{force}"
    );
}

#[test]
fn scalars_have_the_names_and_units_of_their_readings() {
    let found = input(MODEL).unwrap();
    let scalars = found.model.system.scalars().iter();
    let words = scalars.map(|scalar| (scalar.owner.as_str(), scalar.unknown.name.as_str()));
    let words: std::collections::BTreeSet<_> = words.collect();
    let expected = [
        ("pull", "reaction force"),
        ("servo", "position"),
        ("servo", "rate"),
        ("turn", "joint angle"),
    ];
    assert_eq!(words.into_iter().collect::<Vec<_>>(), expected);
}

// Before the state is known all inputs of a signal are zero; also for ln(0) and 1/0.
#[test]
fn signals_represent_temperatures_and_laws() {
    let cards = "
[[node]]
name = \"c\"
position = [2, 0, 0]
[[beam]]
nodes = [\"a\", \"b\", \"c\"]
properties = \"hot\"
temperature = \"= 20*servo + turn\"
[[rod]]
nodes = [\"a\", \"c\"]
law = { kind = \"linear\", stiffness = 10, prestrain = 1, prestrain_drive = \"= 1/turn\" }
[[rod]]
name = \"second\"
nodes = [\"a\", \"c\"]
law = { kind = \"viscoelastic\", stiffness = 9, viscosity = 1, prestrain = 1, prestrain_drive = \"servo\" }
[properties.hot]
ea = 1e6
gay = 1e6
gaz = 1e6
gj = 100
eiy = 100
eiz = 100
m = 0.5
iy = 1e-4
iz = 1e-4
thermal_force = [-10, 0, 0, 0, 0, 0]
";
    let found = input(&format!("{MODEL}{cards}")).unwrap();
    let words = found.remarks.concat();
    let expected = "temperature 0 K while all its inputs are zero";
    assert!(words.contains(expected), "{words}");
}

/// Each error in place of a right card, and the expected message.
const MISTAKES: [[&str; 3]; 12] = [
    [
        "angle = \"servo\"",
        "angle = \"= pull\"",
        "\"angle\" follows \"pull\", whose second derivative is not known\n  help: its value, \
             or its rate, may jump, which would be an impulse: add an [[actuator]] with",
    ],
    [
        "angle = \"servo\"",
        "speed = \"= turn\"",
        "\"speed\" follows \"turn\", whose rate is not known",
    ],
    [
        "angle = \"servo\"",
        "angle = \"sevo\"",
        "unknown signal \"sevo\" in \"angle\"\n  help: did you mean \"servo\"?",
    ],
    [
        "quantity = \"joint_angle\"",
        "quantity = \"electric_energy\"",
        "\"electric_energy\" cannot be sensed: the derivatives of this energy are not known",
    ],
    [
        "quantity = \"joint_angle\"",
        "quantity = \"joint_rotation\"",
        "sensor \"turn\" reads 3 numbers, expected one\n  help: choose one \"component\"",
    ],
    [
        "quantity = \"joint_angle\"",
        "quantity = \"spring_rotation\"\ncomponent = \"x\"",
        "\"spring_rotation\" cannot be sensed: the element under \"of\" does not have it",
    ],
    [
        "of = \"tip\"\ncomponent = \"x\"",
        "of = \"arm\"\nin = \"b\"\ncomponent = \"x\"",
        "a reaction is sensed in the axes of a node of the joint, a frame, or an end",
    ],
    [
        "unit = \"kN\"",
        "unit = \"m\"",
        "\"unit\": \"m\" measures a length, expected a force",
    ],
    [
        "name = \"servo\"",
        "name = \"pull\"",
        "\"pull\" is the name of a sensor, an output or a control already",
    ],
    [
        "frequency = 5",
        "frequency = 0",
        "\"frequency\" is 0, expected a frequency greater than zero",
    ],
    [
        "frequency = 5",
        "frequency = 5\nlimits = [3, 1]",
        "expected the least and the largest command, two increasing numbers",
    ],
    [
        "frequency = 5",
        "frequency = 5\nstart = \"rest\"",
        "\"start\" is the text \"rest\", expected a number, or \"settled\"",
    ],
];

#[test]
fn mistakes_are_reported_with_their_reason() {
    for [right, wrong, reported] in MISTAKES {
        let shown = refused(&MODEL.replace(right, wrong));
        assert!(shown.contains(reported), "{reported}\nis not in\n{shown}");
    }
}

#[test]
fn an_energy_without_known_derivatives_is_refused_by_the_name_of_the_element() {
    let model = |spring: &str, quantity: &str| {
        format!(
            "
[[node]]
name = \"a\"
position = [0, 0, 0]
[[body]]
node = \"a\"
mass = 2
inertia = [1, 1, 1]
[[spring]]
name = \"holder\"
nodes = [\"a\"]
{spring}
[sensors.e]
quantity = \"{quantity}\"
[transient]
to = 1
step = 0.01
"
        )
    };
    let linear = "stiffness = [1, 1, 1]";
    for quantity in [
        "kinetic_energy",
        "elastic_energy",
        "gravity_energy",
        "energy",
    ] {
        assert!(input(&model(linear, quantity)).is_ok(), "{quantity}");
    }
    let driven = "law = { kind = \"linear\", stiffness = [1, 1, 1], prestress = [1, 0, 0], \
        prestress_drive = \"= t\" }";
    let shown = refused(&model(driven, "elastic_energy"));
    let expected = "\"elastic_energy\" cannot be sensed: the derivatives of the \
        energy of \"holder\" are not known";
    assert!(shown.contains(expected), "{shown}");
    assert!(input(&model(driven, "kinetic_energy")).is_ok());
}
