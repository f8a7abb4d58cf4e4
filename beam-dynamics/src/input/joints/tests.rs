//! Tests of the card of joints.

use crate::elements::{Element, Level, Queries};
use crate::input::Input;
use crate::input::test_files::read_beside;
use crate::model::Conditions;

const NODES: &str = "
units = \"SI\"
[drives.swing]
kind = \"expression\"
expression = \"20 * sin(3 * t)\"
[[node]]
name = \"crank\"
position = [0.5, 0, 0]
[[node]]
name = \"rod\"
position = [2, 0, 0]
[[body]]
name = \"crank\"
node = \"crank\"
mass = 1
inertia = [0.1, 0.1, 0.1]
[[body]]
name = \"rod\"
node = \"rod\"
mass = 2
inertia = [0.1, 0.2, 0.3]
";

fn input(cards: &str) -> Result<Input, String> {
    read_beside(&format!("{NODES}{cards}"), &[])
}

/// The joint called `name`, given to `check`.
fn with_joint<T>(input: &Input, name: &str, check: impl FnOnce(&dyn Element) -> T) -> T {
    let found = input
        .model
        .system
        .elements()
        .find(|element| element.label() == name && element.multipliers() > 0);
    check(found.unwrap())
}

fn count(input: &Input, name: &str) -> usize {
    with_joint(input, name, |joint| joint.multipliers())
}

/// Kind, keys, and the number of constraints of a joint.
const KINDS: &[(&str, &str, usize)] = &[
    ("clamp", "", 6),
    ("spherical", "at = [1, 0, 0]", 3),
    ("revolute", "at = [1, 0, 0]\naxis = [0, 0, 1]", 5),
    ("revolute", "axis = [0, 0, 1]\nangle = \"swing\"", 6),
    (
        "revolute",
        "axis = [0, 0, 1]\naxis_in = \"node\"\nspeed = \"= 3 * t\"",
        6,
    ),
    ("cylindrical", "axis = [0, 0, 1]", 4),
    (
        "cylindrical",
        "axis = [0, 0, 1]\ndisplacement = \"= 0.1 * sin(t)\"",
        5,
    ),
    ("universal", "axes = [[0, 0, 1], [0, 1, 0]]", 4),
    ("prismatic", "axis = [1, 0, 0]", 5),
    ("prismatic", "axis = [1, 0, 0]\ndisplacement = 0", 6),
    ("in-line", "axis = [1, 0, 0]", 2),
    ("in-plane", "axis = [1, 0, 0]\nfrom = [2, 1, 1]", 1),
    ("plane-rotation", "axis = [1, 0, 0]", 2),
    ("distance", "", 1),
    (
        "distance",
        "length = \"= 1.5 + 0.1 * t\"\nfrom = [0.5, 0, 0]",
        1,
    ),
    ("position", "displacement = { x = \"= t\", y = 0 }", 2),
    (
        "rotation",
        "rotation = [0, 0, 0]\norientation = [0, 0, 30]",
        3,
    ),
    (
        "velocity",
        "velocity = { z = \"= t\" }\nangular_velocity = [0, 0, 1]",
        4,
    ),
    ("spin", "axis = [0, 0, 1]\nspeed = 2", 1),
    ("spin", "axis = [0, 0, 1]\nangle = \"swing\"", 1),
    (
        "total",
        "locked = [\"x\", \"about z\"]\ndisplacement = { y = \"= 0.2 * t\" }",
        3,
    ),
];

// One joint of each kind between the two bodies: the number of its constraints, all fulfilled
// undeformed.
#[test]
fn every_kind_is_read() {
    for (kind, keys, rows) in KINDS {
        let rows = *rows;
        let card = format!(
            "[[clamp]]\nnode = \"crank\"\n[[joint]]\nname = \"J\"\nkind = \"{kind}\"\n\
             nodes = [\"crank\", \"rod\"]\n{keys}\n[transient]\nto = 1\nstep = 0.1\n"
        );
        let found = input(&card).unwrap_or_else(|problems| panic!("{kind}: {problems}"));
        assert_eq!(count(&found, "J"), rows, "{kind} {keys}");
        let system = &found.model.system;
        let residual = system.residual(&system.rest(), &Conditions::at_rest());
        let first = system.numbering().node(2);
        let holds = with_joint(&found, "J", |joint| {
            (0..rows)
                .filter(|&row| joint.level(row) == Level::Position)
                .count()
        });
        let at_rest = &residual.values[first + 6..first + 6 + holds];
        assert!(
            at_rest.iter().all(|value| value.abs() < 1e-14),
            "{kind}: {at_rest:?}"
        );
    }
}

#[test]
fn a_joint_of_one_node_is_with_the_frame() {
    let card = "[[joint]]\nkind = \"revolute\"\nnodes = [\"crank\"]\nat = [0, 0, 0]\n\
        axis = [0, 0, 1]\n[[joint]]\nkind = \"revolute\"\nnodes = [\"crank\", \"rod\"]\n\
        at = [1, 0, 0]\naxis = [0, 0, 1]\n[transient]\nto = 1\nstep = 0.1\n";
    let found = input(card).unwrap();
    assert_eq!(
        with_joint(&found, "joint 1", |joint| joint.nodes().to_vec()),
        [0]
    );
    assert_eq!(
        with_joint(&found, "joint 2", |joint| joint.nodes().to_vec()),
        [0, 1]
    );
    assert_eq!(found.free_hinges, ["joint 1", "joint 2"]);
}

#[test]
fn every_problem_of_joints_is_reported_at_once() {
    let two = "nodes = [\"crank\", \"rod\"]";
    let cards = [
        "kind = \"sperical\"\nnodes = [\"crank\", \"rod\"]".to_owned(),
        two.to_owned(),
        "kind = \"spherical\"\nnodes = [\"crank\", \"rood\"]".to_owned(),
        "kind = \"spherical\"\nnodes = [\"rod\", \"rod\"]".to_owned(),
        "kind = \"spherical\"\nnodes = []".to_owned(),
        format!("kind = \"revolute\"\n{two}"),
        format!("kind = \"revolute\"\n{two}\naxis = [0, 0, 0]"),
        format!("kind = \"revolute\"\n{two}\naxis = [0, 0, 1]\nangle = 1\nspeed = 2"),
        format!("kind = \"universal\"\n{two}\naxes = [[0, 0, 1], [0, 0, -2]]"),
        format!("kind = \"universal\"\n{two}\naxes = [[0, 0, 1]]"),
        format!("kind = \"distance\"\n{two}\nfrom = [2, 0, 0]"),
        format!("kind = \"distance\"\n{two}\nlength = -1"),
        "kind = \"distance\"\nnodes = [\"rod\"]".to_owned(),
        format!("kind = \"total\"\n{two}"),
        format!("kind = \"total\"\n{two}\nlocked = [\"about w\"]"),
        format!("kind = \"total\"\n{two}\nlocked = [\"x\"]\ndisplacement = {{ x = 1 }}"),
        format!("kind = \"spin\"\n{two}\naxis = [0, 0, 1]"),
        format!("kind = \"prismatic\"\n{two}\naxis = [0, 0, 1]\ndisplacement = \"swng\""),
        format!("kind = \"spherical\"\n{two}\nangle = 3"),
    ];
    let cards = cards.map(|card| format!("[[joint]]\n{card}\n")).concat();
    let shown = input(&cards).unwrap_err();
    for expected in [
        "\"sperical\"",
        "did you mean \"spherical\"?",
        "has no \"kind\", expected one of clamp, spherical",
        "unknown node \"rood\" in joint \"joint 3\"",
        "did you mean \"rod\"?",
        "joint \"joint 4\" joins \"rod\" to itself, expected two nodes",
        "\"nodes\" lists 0, expected one or two",
        "has no \"axis\", expected the direction of the axis",
        "\"axis\" has no direction",
        "the joint has \"angle\" and \"speed\", expected one of them",
        "the two axes of the universal joint are parallel",
        "\"axes\" lists 1, expected two",
        "the points of joint \"joint 11\" coincide, expected a distance between them",
        "\"length\" is -1, expected a length greater than zero at all times",
        "has no \"at\", expected the point of the frame from which it is measured",
        "the joint holds nothing, expected at least one component of \"locked\"",
        "\"locked\" is \"about w\", expected one of \"x\", \"y\", \"z\", \"about x\", \"about y\", \"about z\"",
        "\"x\" is locked and driven, expected one of them",
        "the joint has neither \"angle\" nor \"speed\", expected one of them",
        "unknown drive \"swng\"",
        "unknown key \"angle\"",
    ] {
        assert!(shown.contains(expected), "{expected} is not in\n{shown}");
    }
}
