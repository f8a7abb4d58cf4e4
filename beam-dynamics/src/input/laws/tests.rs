//! Tests of laws in cards, and of the cards with laws.

#![allow(clippy::unwrap_used, reason = "tests")]

use nalgebra::Vector3;

use crate::elements::{Local, Queries};
use crate::input::Input;
use crate::input::test_files::read_beside;
use crate::model::{Conditions, NodeMotion, Scalars};

/// Two nodes at a distance of 2 along x, the first of them clamped, the second a body.
const NODES: &str = "
[[node]]
name = \"root\"
position = [0, 0, 0]
[[node]]
name = \"tip\"
position = [2, 0, 0]
[[clamp]]
node = \"root\"
[[body]]
node = \"tip\"
mass = 1
inertia = [1, 1, 1]
";

/// Holds the second node in all directions.
const HOLD: &str = "
[[spring]]
name = \"hold\"
node = \"tip\"
stiffness = [1, 1, 1]
rotational_stiffness = [1, 1, 1]
";

fn input_in(units: &str, cards: &str) -> Result<Input, String> {
    read_beside(&format!("{units}\n{NODES}{cards}"), &[])
}

fn input(cards: &str) -> Result<Input, String> {
    input_in("units = \"SI\"", cards)
}

/// Force and moment on the tip by the element called `label`, if the tip is moved.
fn on_tip(input: &Input, label: &str, moved: impl Fn(&mut NodeMotion)) -> [Vector3<f64>; 2] {
    let system = &input.model.system;
    let mut state = system.rest();
    moved(&mut state.nodes[1]);
    let element = system.elements().find(|e| e.label() == label).unwrap();
    let nodes: Vec<_> = element.nodes().iter().map(|&n| state.nodes[n]).collect();
    let conditions = Conditions::at_rest();
    let at = Local {
        nodes: &nodes,
        multipliers: &[],
        scalars: Scalars::NONE,
        memory: &[],
        frame: &conditions.frame,
        loading: &conditions.loading,
    };
    let mut out = crate::elements::LocalResidual::new(crate::elements::LocalSize::without_scalars(
        nodes.len(),
        0,
    ));
    element.residual(&at, &mut out);
    let tip = 12 * element.nodes().iter().position(|&n| n == 1).unwrap();
    [6, 9].map(|row| Vector3::from_column_slice(&out.values()[tip + row..tip + row + 3]))
}

fn refused(cards: &str) -> String {
    input(cards).unwrap_err()
}

fn expect(cards: &str, expected: &str) {
    let shown = refused(cards);
    assert!(shown.contains(expected), "{expected} is not in\n{shown}");
}

#[test]
fn rods_pull_along_their_line_in_declared_units() {
    let units = "[units]\nlength = \"mm\"\nforce = \"kN\"\nmass = \"kg\"\n";
    let cards = "[[rod]]\nname = \"rod\"\nnodes = [\"root\", \"tip\"]\n\
        law = { kind = \"linear\", stiffness = 8 }\n";
    let kilo = input_in(units, &format!("{cards}{HOLD}")).unwrap();
    let found = on_tip(&kilo, "rod", |tip| tip.position.x *= 1.25);
    assert!((found[0] + Vector3::new(2000.0, 0.0, 0.0)).norm() < 1e-11);
    let si = input(&format!(
        "{cards}length = 1.6\nmeasure = \"elongation\"\n{HOLD}"
    ))
    .unwrap();
    let found = on_tip(&si, "rod", |tip| tip.position.x = 2.1);
    assert!((found[0].x + 8.0 * 0.5).abs() < 1e-14, "{found:?}");
}

#[test]
fn laws_add_up_and_carry_prestress() {
    let cards = "[[rod]]\nname = \"rod\"\nnodes = [\"root\", \"tip\"]\nlaw = [\n\
        { kind = \"cubic\", stiffness = 2, cubic = 4 },\n\
        { kind = \"viscous\", viscosity = 3, prestress = 10, prestress_drive = \"= 1 + t\" },\n\
        { kind = \"expression\", force = \"= 5*e*e_rate\" },\n\
        { kind = \"table\", points = [[0, 0], [1, 6]], outside = \"hold\" },\n]\n";
    let input = input(&format!("{cards}{HOLD}")).unwrap();
    let found = on_tip(&input, "rod", |tip| {
        tip.position.x = 3.0;
        tip.velocity.x = 0.4;
    });
    let (e, rate) = (0.5, 0.2);
    let expected = 2.0 * e + 4.0 * e * e * e + 3.0 * rate + 10.0 + 5.0 * e * rate + 3.0;
    assert!(
        (found[0].x + expected).abs() < 1e-14,
        "{found:?} {expected}"
    );
}

#[test]
fn springs_act_in_the_axes_of_the_first_node_at_their_position() {
    let cards = "[[spring]]\nname = \"s\"\nnodes = [\"root\", \"tip\"]\nat = [1.5, 0, 0]\n\
        law = { kind = \"linear\", stiffness = [[3, 1, 0], [1, 2, 0], [0, 0, 4]] }\n\
        rotational_law = { kind = \"bilinear\", stiffness = 8, second_stiffness = 1, limit = \"3 deg\" }\n";
    let input = input(cards).unwrap();
    let [force, moment] = on_tip(&input, "s", |tip| {
        tip.position += Vector3::new(0.1, 0.2, 0.3)
    });
    let expected = -Vector3::new(0.5, 0.5, 1.2);
    assert!((force - expected).norm() < 1e-14, "{force}");
    assert!((moment - Vector3::new(-0.5, 0.0, 0.0).cross(&expected)).norm() < 1e-14);
    let about = "[[spring]]\nname = \"s\"\nnode = \"tip\"\n\
        law = { kind = \"linear\", stiffness = 1 }\n\
        rotational_law = { kind = \"viscoelastic\", stiffness = [1, 2, 3], time = 0.5 }\n";
    let input = self::input(about).unwrap();
    let [_, moment] = on_tip(&input, "s", |tip| tip.angular_velocity.z = 2.0);
    assert!((moment + Vector3::new(0.0, 0.0, 3.0)).norm() < 1e-14);
}

#[test]
fn beams_of_a_law_are_those_of_its_stiffness() {
    let cards = "[properties.p]\nea = 7\ngay = 2\ngaz = 1\ngj = 3\neiy = 4\neiz = 9\nm = 2\niy = 1\niz = 1\n\
        [[node]]\nname = \"mid\"\nposition = [1, 0, 0]\n\
        [[beam]]\nname = \"beam\"\nnodes = [\"root\", \"mid\", \"tip\"]\nproperties = \"p\"\n";
    let linear = input(cards).unwrap();
    let moved = |tip: &mut NodeMotion| tip.position += Vector3::new(0.1, 0.2, 0.3);
    let [force, moment] = on_tip(&linear, "beam", moved);
    for law in [
        "{ kind = \"section\" }",
        "{ kind = \"linear\", stiffness = [7, 2, 1, 3, 4, 9] }",
        "[{ kind = \"section\" }, { kind = \"viscous\", viscosity = [1, 1, 1, 1, 1, 1] }]",
    ] {
        let input = input(&format!("{cards}law = {law}\n")).unwrap();
        let found = on_tip(&input, "beam", moved);
        assert!((found[0] - force).norm() < 1e-14 && (found[1] - moment).norm() < 1e-14);
        assert!(input.summary.mass > 4.9, "the properties give the mass");
    }
    let soft = "law = { kind = \"linear\", stiffness = [7, 0, 1, 3, 4, 9] }\n";
    expect(
        &format!("{cards}{soft}"),
        "beam \"beam\": the law has no positive definite stiffness",
    );
    let none = cards.replace("properties = \"p\"", "law = { kind = \"section\" }");
    expect(
        &none,
        "the law \"section\" is the stiffness of a beam's properties",
    );
}

#[test]
fn forces_between_nodes_pull_and_turn() {
    let cards = "[[internal_force]]\nname = \"f\"\nnodes = [\"root\", \"tip\"]\n";
    let with = |keys: &str| input(&format!("{cards}{keys}\n{HOLD}")).unwrap();
    let pull = with("tension = 3\nconstant = true");
    let still = |_: &mut NodeMotion| {};
    // The constant factor is zero at rest without loads.
    assert_eq!(on_tip(&pull, "f", still)[0], Vector3::zeros());
    expect(&format!("{cards}{HOLD}"), "nothing acts between the nodes");
    expect(
        &format!("{cards}tension = 1\nforce = [1, 0, 0]\n{HOLD}"),
        "\"tension\" and \"force\" are the same quantity",
    );
}

#[test]
fn springs_between_nodes_hold_them_together_in_their_directions() {
    let spring = |keys: &str| {
        format!("[[spring]]\nname = \"s\"\nnodes = [\"root\", \"tip\"]\n{keys}\n[static]\n")
    };
    let held = "stiffness = [1, 1, 1]\nrotational_stiffness = [1, 2, 3]";
    assert!(input(&spring(held)).is_ok());
    let free = "stiffness = [1, 0, 1]\nrotational_stiffness = [1, 2, 3]";
    expect(
        &spring(free),
        "node \"tip\" can move without resistance: translation along y",
    );
    let rod = "[[rod]]\nnodes = [\"root\", \"tip\"]\nlaw = { kind = \"linear\", stiffness = 1 }\n[static]\n";
    let shown = refused(rod);
    assert!(!shown.contains("translation along x") && shown.contains("translation along y"));
}

/// A relaxed length that reaches zero in the run is reported before it, with time and
/// value; a length that is below zero only after the run is not.
#[test]
fn a_relaxed_length_through_zero_is_reported_before_the_run() {
    let rod = |length: &str, to: f64| {
        format!(
            "{HOLD}[[rod]]\nname = \"rod\"\nnodes = [\"root\", \"tip\"]\nlength = {length}\n\
             law = {{ kind = \"linear\", stiffness = 1e3 }}\n\
             [transient]\nto = {to}\nstep = 0.01\n"
        )
    };
    for (length, found) in [
        ("\"= 1 - 2*t\"", "\"length\" is 0 m at 0.5 s"),
        (
            "{ kind = \"ramp\", from = 1, to = -1, start = 0, end = 1 }",
            "\"length\" is 0 m at 0.5 s",
        ),
        (
            "{ kind = \"step\", from = 1, to = -0.5, time = 0.3 }",
            "\"length\" is -0.5 m at 0.3 s",
        ),
    ] {
        let shown = refused(&rod(length, 1.0));
        assert!(shown.contains(found), "{shown}");
        let rest = "expected a length greater than zero at all times of the run, from 0 s to 1 s";
        assert!(shown.contains(rest), "{shown}");
        assert!(
            shown.contains("help: let the drive stay at a length above zero"),
            "{shown}"
        );
        assert!(input(&rod(length, 0.25)).is_ok());
    }
    let joint = "[[joint]]\nkind = \"distance\"\nnodes = [\"root\", \"tip\"]\n\
        length = \"= 2 - 4*t\"\n[transient]\nto = 1\nstep = 0.01\n";
    expect(joint, "\"length\" is 0 m at 0.5 s");
}

/// Laws of a rod, and the expected problems.
const WRONG_OF_RODS: &[(&str, &str)] = &[
    (
        "{ kind = \"liner\", stiffness = 1 }",
        "did you mean \"linear\"?",
    ),
    ("{ kind = \"linear\" }", "has no \"stiffness\""),
    (
        "{ kind = \"linear\", stifness = 1 }",
        "unknown key \"stifness\"",
    ),
    (
        "{ kind = \"linear\", stiffness = -1 }",
        "expected numbers, zero or more",
    ),
    ("{ kind = \"linear\", stiffness = [1, 2] }", "\"stiffness\""),
    (
        "{ kind = \"viscoelastic\", stiffness = 1 }",
        "needs a \"viscosity\" or a \"time\"",
    ),
    (
        "{ kind = \"cubic\" }",
        "has no \"stiffness\", \"quadratic\" or \"cubic\"",
    ),
    (
        "{ kind = \"bilinear\", stiffness = 1, limit = 1 }",
        "has no \"second_stiffness\"",
    ),
    (
        "{ kind = \"table\", points = [[0, 0], [0, 1]] }",
        "expected increasing strains",
    ),
    ("{ kind = \"table\", points = [[0, 0]] }", "at least two"),
    (
        "{ kind = \"expression\", force = \"2*ee\" }",
        "did you mean \"e\"?",
    ),
    (
        "{ kind = \"section\" }",
        "is the stiffness of a beam's properties",
    ),
    (
        "{ kind = \"linear\", stiffness = 1, prestress_drive = 2 }",
        "which is not given",
    ),
    ("[]", "the list of laws is empty"),
];

/// A spring along a line or about an axis belongs to other cards.
#[test]
fn one_number_of_a_spring_reports_rods_and_hinges() {
    for ends in ["node = \"tip\"", "nodes = [\"root\", \"tip\"]"] {
        for (key, card) in [
            ("stiffness", "[[rod]]"),
            ("damping", "[[rod]]"),
            ("rotational_stiffness", "[[hinge]]"),
        ] {
            let cards = format!("{HOLD}[[spring]]\nname = \"soft\"\n{ends}\n{key} = 100\n");
            let reported = input(&cards).unwrap_err();
            assert!(
                reported.contains(&format!("\"{key}\" is not a list")),
                "{reported}"
            );
            assert!(reported.contains(card), "{reported}");
        }
    }
}

/// Laws of a spring, and the expected problems.
const WRONG_OF_SPRINGS: &[(&str, &str)] = &[
    (
        "{ kind = \"linear\", stiffness = [[1, 2, 0], [1, 3, 0], [0, 0, 1]] }",
        "is not symmetric: 1 in row 2 and column 1, 2 across the diagonal",
    ),
    (
        "{ kind = \"linear\", stiffness = [[1, 2, 0], [2, 1, 0], [0, 0, 1]] }",
        "has a negative eigenvalue (-1 of the matrix",
    ),
    (
        "{ kind = \"linear\", stiffness = [[1, 0], [0, 1]] }",
        "expected a row of 3 numbers",
    ),
    (
        "{ kind = \"linear\", stiffness = [1, 2] }",
        "expected an array of 3",
    ),
    (
        "{ kind = \"table\", points = {} }",
        "names no component, expected at least one of x, y, z",
    ),
    (
        "{ kind = \"expression\", force = { w = \"x\" } }",
        "unknown key \"w\"",
    ),
];

#[test]
fn wrong_laws_are_reported_with_their_remedy() {
    let rod =
        |law: &str| format!("[[rod]]\nname = \"r\"\nnodes = [\"root\", \"tip\"]\nlaw = {law}\n");
    for (law, expected) in WRONG_OF_RODS {
        expect(&rod(law), expected);
    }
    let spring = |law: &str| format!("[[spring]]\nnodes = [\"root\", \"tip\"]\nlaw = {law}\n");
    for (law, expected) in WRONG_OF_SPRINGS {
        expect(&spring(law), expected);
    }
    expect(
        "[[spring]]\nnodes = [\"root\", \"tip\"]\n",
        "has no law and no stiffness",
    );
    expect(
        "[[spring]]\nnodes = [\"root\", \"tp\"]\n",
        "did you mean \"tip\"?",
    );
    let twice = "[[spring]]\nnode = \"tip\"\nstiffness = [1, 1, 1]\nlaw = { kind = \"linear\", stiffness = 1 }\n";
    expect(twice, "\"law\" and \"stiffness\" are the same quantity");
    let linear = "law = { kind = \"linear\", stiffness = 1 }\n";
    expect(
        &format!("[[rod]]\nnodes = [\"tip\"]\n{linear}"),
        "has one node and no \"at\"",
    );
    let none = format!(
        "[[rod]]\nname = \"r\"\nnodes = [\"root\", \"tip\"]\noffsets = [[2, 0, 0], [0, 0, 0]]\n{linear}"
    );
    expect(&none, "rod \"r\" has no length");
}

/// Like [`input`], with a CSV file in its folder.
fn input_beside(csv: &str, cards: &str) -> Result<Input, String> {
    let text = format!("units = \"SI\"\n{NODES}{cards}");
    read_beside(&text, &[("curve.csv", csv)])
}

fn rod(points: &str, rest: &str) -> String {
    format!(
        "{HOLD}[[rod]]\nname = \"rod\"\nnodes = [\"root\", \"tip\"]\nmeasure = \"elongation\"\n\
         law = {{ kind = \"table\", points = {points}{rest} }}\n"
    )
}

// 6 N/m up to 1 m, 1 N/m up to 2 m.
#[test]
fn tables_of_laws_come_from_files() {
    let csv = "# Measured.\nload,u,f\n9,-1,-6\n9,0,0\n9,1,6\n9,2,7\n";
    let file = "{ file = \"curve.csv\", columns = [\"u\", \"f\"] }";
    let found = input_beside(csv, &rod(file, ", outside = \"error\"")).unwrap();
    let pull = |elongation: f64| on_tip(&found, "rod", |tip| tip.position.x += elongation)[0].x;
    for (elongation, expected) in [(0.5, -3.0), (1.5, -6.5), (-0.25, 1.5), (2.0, -7.0)] {
        let force = pull(elongation);
        assert!((force - expected).abs() < 1e-12, "{elongation} {force}");
    }
    assert!(pull(2.1).is_nan() && pull(-1.1).is_nan());
    // In the card or from a file, the law is the same.
    let rows = "[[-1, -6], [0, 0], [1, 6], [2, 7]]";
    let other = input(&rod(rows, ", outside = \"error\"")).unwrap();
    assert_eq!(found.model.fingerprint(), other.model.fingerprint());
    // For one component of three.
    let spring = "[[spring]]\nname = \"mount\"\nnodes = [\"root\", \"tip\"]\n\
                  law = { kind = \"table\", points = { y = { file = \"curve.csv\" } } }\n";
    let found = input_beside("u,f\n0,0\n1,6\n", &format!("{HOLD}{spring}")).unwrap();
    let [force, _] = on_tip(&found, "mount", |tip| tip.position.y += 0.5);
    assert!(
        (force + Vector3::new(0.0, 3.0, 0.0)).amax() < 1e-12,
        "{force}"
    );
}

#[test]
fn what_is_wrong_with_tables_of_laws_is_reported_at_its_location() {
    let file = "{ file = \"curve.csv\", columns = [\"u\", \"f\"] }";
    for (csv, points, rest, expected) in [
        ("u,g\n0,0\n1,1\n", file, "", "curve.csv:1: no column \"f\""),
        (
            "u,f\n0,0\n2,1\n1,1\n",
            file,
            "",
            "curve.csv:4: the strain 1 follows 2, expected increasing strains",
        ),
        (
            "u,f\n0,0\n",
            file,
            "",
            "curve.csv:2: the table has 1 rows, expected at least two",
        ),
        (
            "u,f\n0,zero\n1,1\n",
            file,
            "",
            "curve.csv:2: \"zero\" in column \"f\" is not a number",
        ),
        (
            "",
            "{ file = \"curves.csv\" }",
            "",
            "no file \"curves.csv\"\n  help: did you mean \"curve.csv\"?",
        ),
        (
            "",
            "[[1, 1], [2, 2]]",
            ", outside = \"error\"",
            "the points do not reach zero strain",
        ),
    ] {
        let reported = input_beside(csv, &rod(points, rest)).unwrap_err();
        assert!(reported.contains(expected), "{expected}\n---\n{reported}");
        assert_eq!(reported.matches("error: ").count(), 1, "{reported}");
    }
}

#[test]
fn drives_of_laws_must_have_values_during_the_run() {
    let cards = "[drives.short]\nkind = \"table\"\nrows = [[0, 1], [0.5, 1]]\n\
                 [[rod]]\nnodes = [\"root\", \"tip\"]\n\
                 law = { kind = \"linear\", stiffness = 1, prestress = 2, \
                 prestress_drive = \"short\", prestrain = 0.1, prestrain_drive = \"short\" }\n\
                 [transient]\nto = 1\nstep = 0.1\n";
    let reported = input(&format!("{HOLD}{cards}")).unwrap_err();
    for key in ["prestress_drive", "prestrain_drive"] {
        let expected =
            format!("\"{key}\" has values from 0 s to 0.5 s, and the run goes from 0 s to 1 s");
        assert!(reported.contains(&expected), "{reported}");
    }
}
