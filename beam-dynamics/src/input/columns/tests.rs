use approx::assert_relative_eq;
use nalgebra::Vector3;
use shared_geom::rotation::vector;

use crate::case::{Column, Every, Quantity};
use crate::elements::{Axes, NodeQuantity, NodeVector, Part, Reading};
use crate::input::Input;
use crate::input::test_files::read_beside;
use crate::model::{Conditions, State};
use crate::result::{AcceptedStep, ColumnValues};

const MODEL: &str = "
units = \"SI\"
[properties.strip]
ea = 7e6
gay = 2e6
gaz = 1e6
gj = 30
eiy = 40
eiz = 900
m = 2
iy = 0.01
iz = 0.04
[[node]]
name = \"root\"
position = [0, 0, 0]
[[node]]
name = \"mid\"
position = [1, 0, 0]
[[node]]
name = \"the tip\"
position = [2, 0, 0]
[[beam]]
name = \"mast\"
nodes = [\"root\", \"mid\", \"the tip\"]
properties = \"strip\"
[[clamp]]
node = \"root\"
";

/// Columns of every kind of source.
const CHOSEN: &str = "[output]
        every = \"2 ms\"
        restart_every = 100
        vtu = 5
        netcdf = false
        [[output.column]]
        name = \"tip\"
        quantity = \"displacement\"
        of = \"the tip\"
        unit = \"mm\"
        [[output.column]]
        name = \"pitch\"
        quantity = \"euler_angles\"
        sequence = \"zxz\"
        of = \"the tip\"
        against = \"root\"
        component = \"second\"
        [[output.column]]
        name = \"root_bending\"
        quantity = \"internal_force\"
        of = \"mast\"
        component = \"bending_y\"
        unit = \"kN*m\"
        [[output.column]]
        name = \"held\"
        quantity = \"reaction_force\"
        of = \"clamp of root\"
        in = \"the tip\"
        component = [\"x\", \"magnitude\"]
        [[output.column]]
        name = \"spin\"
        quantity = \"angular_momentum\"
        about = [0, 0, 1]
        component = \"z\"
        [[output.column]]
        name = \"rate\"
        quantity = \"angular_velocity\"
        of = \"mid\"
        component = \"x\"
        unit = \"rpm\"\n";

/// An error in every card.
const WRONG: &str = "[output]
every = 0.005
[[output.column]]
name = \"1st\"
quantity = \"posizion\"
[[output.column]]
name = \"a\"
quantity = \"position\"
of = \"the tib\"
component = \"w\"
[[output.column]]
name = \"b\"
quantity = \"velocity\"
of = \"mid\"
unit = \"mm\"
colour = 1
[[output.column]]
name = \"c\"
quantity = \"strain\"
of = \"mest\"
point = 3
[[output.column]]
name = \"d\"
quantity = \"reaction_force\"
of = \"clamp of rood\"
[[output.column]]
name = \"e\"
quantity = \"reaction_force\"
of = \"clamp of root\"
node = \"mid\"
[[output.column]]
name = \"f\"
quantity = \"euler_angles\"
of = \"mid\"
sequence = \"xxz\"
[[output.column]]
name = \"g\"
quantity = \"energy\"
[[output.column]]
name = \"g\"
quantity = \"energy\"
[[output.column]]
name = \"time\"
quantity = \"energy\"
";

fn input(cards: &str) -> Result<Input, String> {
    read_beside(&format!("{MODEL}{cards}"), &[])
}

fn names(columns: &[Column]) -> Vec<&str> {
    columns.iter().map(|column| column.name.as_str()).collect()
}

#[test]
fn without_columns_nodes_that_move_and_energies_are_written() {
    let output = input("").unwrap().output;
    let expected = [
        "mid_x",
        "mid_y",
        "mid_z",
        "the_tip_x",
        "the_tip_y",
        "the_tip_z",
        "kinetic_energy",
        "elastic_energy",
        "gravity_energy",
        "energy",
    ];
    assert_eq!(names(&output.columns), expected);
    assert_eq!(output.every, Every::Steps(1));
    assert!(output.csv && output.netcdf && output.vtu.is_none());
}

#[test]
fn columns_have_names_units_and_parts() {
    let output = input(CHOSEN).unwrap().output;
    assert_eq!(output.every, Every::Time(2e-3));
    assert_eq!(output.restart, Some(Every::Steps(100)));
    assert_eq!(
        (output.vtu, output.csv, output.netcdf),
        (Some(5), true, false)
    );
    let expected = [
        "tip_x",
        "tip_y",
        "tip_z",
        "pitch",
        "root_bending",
        "held_x",
        "held_magnitude",
        "spin",
        "rate",
    ];
    assert_eq!(names(&output.columns), expected);
    let [_, y, _, pitch, bending, _, held, _, rate] = &output.columns[..] else {
        panic!("nine columns");
    };
    assert_eq!((y.unit.as_str(), y.factor), ("mm", 1e-3));
    assert_eq!(y.words, "displacement y of the tip");
    let quantity = NodeQuantity {
        node: 2,
        vector: NodeVector::Euler([2, 0, 2]),
        part: Part::Component(1),
        against: Some(0),
        axes: Axes::Model,
    };
    assert_eq!(pitch.quantity, Quantity::Node(quantity));
    assert_eq!(pitch.unit, "deg");
    assert_eq!((bending.unit.as_str(), bending.factor), ("kN*m", 1e3));
    let quantity = Quantity::Element {
        label: "mast".to_owned(),
        reading: Reading::Section {
            point: 0,
            strain: false,
            component: 4,
        },
    };
    assert_eq!(bending.quantity, quantity);
    assert!(matches!(
        held.quantity,
        Quantity::Element {
            reading: Reading::Reaction {
                node: 0,
                part: Part::Magnitude,
                axes: Axes::Node(2),
                ..
            },
            ..
        }
    ));
    assert!((rate.factor * 60.0 - std::f64::consts::TAU).abs() < 1e-14);
}

#[test]
fn all_that_is_wrong_is_reported_with_the_nearest_name() {
    let reported = input(WRONG).unwrap_err();
    for expected in [
        "a.dynamics.toml:29: \"every\" is 0.005, expected a time above zero with its unit, or a number of steps",
        "a.dynamics.toml:31: \"1st\" is not a column name, expected letters",
        "did you mean \"position\"?",
        "unknown node \"the tib\" in column \"a\"\n  help: did you mean \"the tip\"?",
        "a.dynamics.toml:37: \"component\" ",
        "\"mm\" measures a length, expected",
        "colour",
        "unknown beam \"mest\" in column \"c\"\n  help: did you mean \"mast\"?",
        "\"point\" is 3, expected 1 or 2",
        "unknown joint or spring \"clamp of rood\" in column \"d\"\n  help: did you mean \"clamp of root\"?",
        "\"clamp of root\" does not act on node \"mid\"",
        "\"sequence\" is \"xxz\"",
        "column \"g\" is already defined on line ",
        "\"time\" is the name of the first column",
    ] {
        assert!(reported.contains(expected), "{expected}\n---\n{reported}");
    }
}

/// An arm on a pin at the tip, and columns of both.
fn arm() -> String {
    let column = card;
    [
        "[[node]]\nname = \"arm\"\nposition = [2, 0, 0]\n".to_owned(),
        "[[body]]\nnode = \"arm\"\nmass = 1\ninertia = [1, 1, 1]\n".to_owned(),
        "[[hinge]]\nname = \"pin\"\nnodes = [\"the tip\", \"arm\"]\naxis = [0, 0, 1]\n".to_owned(),
        column("angle", "joint_angle", "pin", "unit = \"rad\""),
        column("turned", "joint_rotation", "pin", "component = \"x\""),
        column(
            "slip",
            "joint_displacement",
            "pin",
            "unit = \"mm\"\ncomponent = \"magnitude\"",
        ),
        column(
            "side",
            "reaction_force",
            "pin",
            "in = \"first\"\ncomponent = \"y\"",
        ),
        column(
            "up",
            "reaction_force",
            "pin",
            "in = \"first\"\ncomponent = \"z\"",
        ),
        column(
            "force",
            "reaction_force",
            "pin",
            "in = \"second\"\ncomponent = \"y\"",
        ),
        column("push", "drive", "= 2*t", "unit = \"kN\""),
    ]
    .concat()
}

// The arm is turned by 0.5 rad about the pin and moved by 3 mm, which the pin sees.
#[test]
fn joints_and_drives_are_found_at_a_state() {
    let input = input(&arm()).unwrap();
    let mut state = input.model.system.rest();
    state.nodes[3].rotation = vector::to_rotation(&Vector3::new(0.0, 0.0, 0.5));
    state.nodes[3].position.y += 3e-3;
    for (k, multiplier) in state.multipliers.iter_mut().enumerate() {
        *multiplier = 1.0 + k as f64;
    }
    let mut conditions = Conditions::at_rest();
    conditions.loading.time = 7.0;
    let accepted = AcceptedStep {
        step: 1,
        time: 7.0,
        length: 1.0,
        iterations: 1,
        state: &state,
        conditions: &conditions,
    };
    let mut out = [0.0; 7];
    ColumnValues::new(&input.model, &input.output).evaluate(&accepted, &mut out);
    let [angle, turned, slip, side, up, force, push] = out;
    assert_relative_eq!(angle, 0.5, epsilon = 1e-14);
    // The axes of the pin: x along its axis, z of the model.
    assert_relative_eq!(turned, 0.5_f64.to_degrees(), epsilon = 1e-12);
    assert_relative_eq!(slip, 3.0, epsilon = 1e-12);
    // The axes of the second end are turned by the angle about x.
    let (sine, cosine) = 0.5_f64.sin_cos();
    assert!(side.hypot(up) > 0.5, "{side} {up}");
    assert_relative_eq!(force, cosine * side + sine * up, epsilon = 1e-12);
    // A drive of plain numbers is in the units of the file: 14 N.
    assert_relative_eq!(push, 14e-3, epsilon = 1e-15);
}

fn card(name: &str, quantity: &str, of: &str, rest: &str) -> String {
    format!(
        "[[output.column]]\nname = \"{name}\"\nquantity = \"{quantity}\"\nof = \"{of}\"\n{rest}\n"
    )
}

/// The values of the columns of `cards` at a state that `change` makes from the state at
/// rest.
fn numbers(cards: &str, change: impl Fn(&mut State)) -> Vec<f64> {
    let input = input(cards).unwrap();
    let mut state = input.model.system.rest();
    change(&mut state);
    let conditions = Conditions::at_rest();
    let accepted = AcceptedStep {
        step: 1,
        time: 0.0,
        length: 1.0,
        iterations: 1,
        state: &state,
        conditions: &conditions,
    };
    let mut out = vec![0.0; input.output.columns.len()];
    ColumnValues::new(&input.model, &input.output).evaluate(&accepted, &mut out);
    out
}

// The outer frame is turned by 90 degrees about z: its x is y of the model, its y is -x.
// The inner one is turned by 90 degrees about x of the outer: its y is z of the outer, and
// of the model; its z is -y of the outer, x of the model.
#[test]
fn vectors_are_written_in_frames_of_the_model() {
    let cards = [
        "[[frame]]\nname = \"outer\"\norientation = [0, 0, \"90 deg\"]\nposition = [3, 0, 0]\n"
            .to_owned(),
        "[[frame]]\nname = \"inner\"\nin = \"outer\"\norientation = [\"90 deg\", 0, 0]\n"
            .to_owned(),
        card("a", "displacement", "the tip", "in = \"outer\""),
        card("b", "displacement", "the tip", "in = \"inner\""),
        card(
            "c",
            "reaction_force",
            "clamp of root",
            "in = \"outer\"\ncomponent = \"x\"",
        ),
        card("d", "reaction_force", "clamp of root", "component = \"y\""),
    ];
    let found = numbers(&cards.concat(), |state| {
        state.nodes[2].position += Vector3::new(1.0, 2.0, 3.0);
        for (k, multiplier) in state.multipliers.iter_mut().enumerate() {
            *multiplier = 1.0 + k as f64;
        }
    });
    let expected = [2.0, -1.0, 3.0, 2.0, 3.0, 1.0];
    for (found, expected) in found.iter().zip(expected) {
        assert_relative_eq!(*found, expected, epsilon = 1e-14);
    }
    assert!(found[6].abs() > 0.5);
    assert_relative_eq!(found[6], found[7], epsilon = 1e-14);
}

// `R(w) = R_a^T R_b R_b0^T R_a0` has components in the axes of a; the vector in space is `R_a w`. 200
// random attitudes of three nodes from a fixed seed; the tolerance is round-off of logarithms of
// rotations below three quarters of a turn.
#[test]
fn relative_rotations_have_components_in_any_axes() {
    let relative = "against = \"root\"\n";
    let cards = ["", "in = \"root\"", "in = \"mid\"", "in = \"model\""];
    let cards: Vec<_> = (cards.iter().enumerate())
        .map(|(k, axes)| {
            card(
                &format!("c{k}"),
                "rotation",
                "the tip",
                &format!("{relative}{axes}"),
            )
        })
        .collect();
    let rest = input("").unwrap().model.system.rest();
    let [a0, b0] = [0, 2].map(|k| rest.nodes[k].rotation);
    // Fractional parts of multiples of the golden ratio and its powers: even over the cube.
    let angle =
        |n: usize, k: usize| 2.6 * ((n as f64 * 0.618_034_f64.powi(k as i32 + 1)) % 1.0) - 1.3;
    for n in 1..=200 {
        let turn = |node: usize| Vector3::from_fn(|i, _| angle(n, 3 * node + i));
        let turns = [0, 1, 2].map(|node| vector::to_rotation(&turn(node)));
        let found = numbers(&cards.concat(), |state| {
            for (node, turn) in state.nodes.iter_mut().zip(&turns) {
                node.rotation = turn * node.rotation;
            }
        });
        let [a, c, b] = [0, 1, 2].map(|k| turns[k] * rest.nodes[k].rotation);
        let w = vector::from_rotation(&(a.transpose() * b * b0.transpose() * a0));
        let expected = [w, w, c.transpose() * (a * w), a * w];
        let expected = expected.iter().flat_map(|vector| vector.iter());
        for (found, expected) in found.iter().zip(expected) {
            assert_relative_eq!(*found, expected.to_degrees(), epsilon = 1e-9);
        }
    }
}

#[test]
fn frames_of_columns_are_looked_for_with_the_nodes() {
    let cards = [
        "[[frame]]\nname = \"ground\"\n".to_owned(),
        card("a", "displacement", "mid", "in = \"grund\""),
        card("b", "displacement", "mid", "in = \"the tib\""),
    ];
    let reported = input(&cards.concat()).unwrap_err();
    for expected in [
        "a.dynamics.toml:34: unknown node or frame \"grund\" in column \"a\"\n  \
         help: did you mean \"ground\"?",
        "a.dynamics.toml:39: unknown node or frame \"the tib\" in column \"b\"\n  \
         help: did you mean \"the tip\"?",
    ] {
        assert!(reported.contains(expected), "{expected}\n---\n{reported}");
    }
}

// A rod of 1 m that is stretched by 0.5 m with 8 kN per unit of strain, and a spring that is
// moved by (1, 2, 3) mm with (1, 10, 100) kN/m and turned by 0.1 rad about z with 50 N m/rad.
#[test]
fn rods_and_springs_report_their_motion_and_what_resists_it() {
    let cards = [
        "[[rod]]\nname = \"stay\"\nnodes = [\"root\", \"mid\"]\n\
         law = { kind = \"linear\", stiffness = 8e3 }\n"
            .to_owned(),
        "[[spring]]\nname = \"mount\"\nnodes = [\"mid\", \"the tip\"]\n\
         law = { kind = \"linear\", stiffness = [1e3, 1e4, 1e5] }\n\
         rotational_law = { kind = \"linear\", stiffness = 50 }\n"
            .to_owned(),
        card("long", "spring_displacement", "stay", "component = \"x\""),
        card(
            "pull",
            "spring_force",
            "stay",
            "unit = \"kN\"\ncomponent = \"x\"",
        ),
        card("moved", "spring_displacement", "mount", "unit = \"mm\""),
        card("resists", "spring_force", "mount", ""),
        card(
            "strength",
            "spring_force",
            "mount",
            "component = \"magnitude\"",
        ),
        card("turned", "spring_rotation", "mount", "component = \"z\""),
        card("moment", "spring_moment", "mount", "component = \"z\""),
    ];
    // The spring is at its last node, and so are both of its ends.
    let found = numbers(&cards.concat(), |state| {
        state.nodes[1].position.x += 0.5;
        state.nodes[2].position += Vector3::new(0.501, 2e-3, 3e-3);
        state.nodes[2].rotation = vector::to_rotation(&Vector3::new(0.0, 0.0, 0.1));
    });
    let strength = 1.0_f64.hypot(20.0).hypot(300.0);
    let degrees = 0.1_f64.to_degrees();
    let expected = [
        0.5, 4.0, 1.0, 2.0, 3.0, 1.0, 20.0, 300.0, strength, degrees, 5.0,
    ];
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        // Round-off of 0.5 m in millimeters, times the stiffness.
        assert_relative_eq!(*found, expected, epsilon = 1e-9);
    }
}
