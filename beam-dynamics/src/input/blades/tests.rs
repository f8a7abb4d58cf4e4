//! Tests of blades: positions, roots, and the problems reported for wrong cards.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

use nalgebra::{Matrix3, Matrix6, Vector2, Vector3, Vector6};
use shared_geom::blade::{self, Blade, BladeDamping, Interpolation, Station};
use shared_geom::line::{Course, LinePoint, ReferenceLine};
use shared_geom::rotation::vector;
use shared_geom::section::Provenance;

use crate::input::Input;
use crate::input::test_files::{STRIP, read_beside};
use crate::model::Conditions;

const MODES: &str = "[modes]\nspeeds = [0]\n";
/// A blade from the file next to the input.
const FILE: &str = "[[blade]]\nname = \"b\"\nfile = \"a.blade.json\"\n";

fn station(arc_length: f64, mass: f64) -> Station {
    let stiffness = Vector6::new(7e6, 2e6, 1e6, 30.0, 40.0, 900.0);
    let inertia = Vector6::new(mass, mass, mass, 0.05, 0.01, 0.04);
    Station {
        arc_length,
        stiffness: Matrix6::from_diagonal(&stiffness),
        mass: Matrix6::from_diagonal(&inertia),
    }
}

fn blade(line: ReferenceLine, stations: Vec<Station>) -> Blade {
    Blade {
        name: "a".to_owned(),
        line,
        reference_point: Vector2::zeros(),
        stations,
        interpolation: Interpolation::Linear,
        damping: None,
        provenance: Provenance::default(),
    }
}

fn straight(length: f64, twist: f64) -> Blade {
    let point = |x: f64| LinePoint {
        position: Vector3::new(x, 0.0, 0.0),
        twist: twist * x / length,
    };
    let line = ReferenceLine::through(vec![point(0.0), point(length)], Course::Polyline);
    blade(line, vec![station(0.0, 2.0), station(length, 1.0)])
}

/// Reads the cards next to the file of `blade`.
fn input(blade: &Blade, cards: &str) -> Result<Input, String> {
    let file = blade::write(blade);
    let text = format!("units = \"SI\"\n{cards}");
    read_beside(&text, &[("a.blade.json", &file)])
}

fn refused(blade: &Blade, cards: &str) -> String {
    match input(blade, cards) {
        Err(shown) => shown,
        Ok(_) => panic!("accepted: {cards}"),
    }
}

#[track_caller]
fn assert_near(found: Vector3<f64>, expected: [f64; 3]) {
    let error = (found - Vector3::from(expected)).amax();
    assert!(error < 1e-12, "{found} {expected:?}");
}

/// Position and axes of the node called `name`.
fn node(input: &Input, name: &str) -> (Vector3<f64>, Matrix3<f64>) {
    let nodes = input.model.system.nodes();
    let found = nodes.iter().find(|node| node.label == name);
    let found = found.unwrap_or_else(|| panic!("no node \"{name}\""));
    (found.position, found.rotation)
}

// An arc of radius 5 in the plane of rotation, 60 degrees forward: the nodes, including the
// middle ones, are at equal angles on the circle about (0, 5, 0), with x along it, and
// nothing is strained. The mass is the integral of the table on the arc, not on the
// polygon.
#[test]
fn a_curved_line_has_its_nodes_on_the_curve() {
    let root = LinePoint {
        position: Vector3::zeros(),
        twist: 0.0,
    };
    let length = 5.0 * FRAC_PI_3;
    let line = ReferenceLine::curved(root, &[(length, Vector3::new(0.0, 0.0, 0.2))]);
    let arc = blade(line, vec![station(0.0, 2.0), station(length, 1.0)]);
    let found = input(&arc, &format!("{FILE}elements = 3\n{MODES}")).unwrap();
    let nodes = found.model.system.nodes();
    assert_eq!(nodes.len(), 7);
    for (k, node) in nodes.iter().enumerate() {
        let (s, c) = (FRAC_PI_3 * k as f64 / 6.0).sin_cos();
        assert_near(node.position, [5.0 * s, 5.0 - 5.0 * c, 0.0]);
        assert_near(node.rotation.column(0).into_owned(), [c, s, 0.0]);
        assert_near(node.rotation.column(2).into_owned(), [0.0, 0.0, 1.0]);
    }
    assert!((found.summary.mass / (1.5 * length) - 1.0).abs() < 1e-13);
    let system = &found.model.system;
    let residual = system.residual(&system.rest(), &Conditions::at_rest());
    let largest = residual.values.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
    assert!(largest < 1e-7, "{largest}");
}

// Hub radius 1.5 along the coned blade, 10 m long, at azimuth 90 degrees: the tip is at
// (0, 11.5 cos 5, 11.5 sin 5). Pitch and twist add up about the span.
#[test]
fn a_blade_sits_on_the_hub_with_radius_cone_azimuth_and_pitch() {
    let cards = format!(
        "{FILE}hub_radius = 1.5\nprecone = 5\nazimuth = 90\npitch = 8\nelements = 4\n{MODES}"
    );
    let found = input(&straight(10.0, -0.3), &cards).unwrap();
    let (s, c) = 5_f64.to_radians().sin_cos();
    assert_near(node(&found, "b/root").0, [0.0, 1.5 * c, 1.5 * s]);
    let (tip, axes) = node(&found, "b/tip");
    assert_near(tip, [0.0, 11.5 * c, 11.5 * s]);
    let cone = Matrix3::new(0.0, -1.0, 0.0, c, 0.0, -s, s, 0.0, c);
    let turn = vector::to_rotation(&(Vector3::x() * (8_f64.to_radians() - 0.3)));
    assert!((axes - cone * turn).amax() < 1e-14);
    // Modes are named by the plane of rotation, without pitch.
    assert!((found.model.naming[3].blade - cone).amax() < 1e-14);
}

// Four blades: at azimuths 0, 90, 180 and 270 degrees; each is the first one
// turned about the axis, (x, y, z) to (-y, x, z).
#[test]
fn several_blades_are_the_same_blade_turned() {
    let cards = format!("{FILE}hub_radius = 2\ncount = 4\nelements = 2\n{MODES}");
    let found = input(&straight(10.0, 0.2), &cards).unwrap();
    let blades = &found.model.blades;
    let names: Vec<_> = blades.iter().map(|blade| blade.name.as_str()).collect();
    assert_eq!(names, ["b 1", "b 2", "b 3", "b 4"]);
    for (k, blade) in blades.iter().enumerate() {
        assert!((blade.azimuth - FRAC_PI_2 * k as f64).abs() < 1e-15);
        for (first, own) in blades[0].nodes.iter().zip(&blade.nodes) {
            let nodes = found.model.system.nodes();
            let mut expected = nodes[*first].position;
            for _ in 0..k {
                expected = Vector3::new(-expected.y, expected.x, expected.z);
            }
            assert!((nodes[*own].position - expected).amax() < 1e-13);
        }
    }
    let named = format!("{FILE}names = [\"red\", \"blue\"]\nazimuths = [0, 120]\n{MODES}");
    let found = input(&straight(10.0, 0.2), &named).unwrap();
    assert_eq!(found.model.blades[1].name, "blue");
    assert_eq!(node(&found, "red/root").0, Vector3::zeros());
}

// Ends of elements include the doubled station at 3 m and the mass at 4.1 m, and each
// element uses its own side of the jump: 2 kg/m on 3 m, 4 kg/m on 7 m, and 5 kg.
#[test]
fn jumps_and_masses_are_ends_of_elements() {
    let mut jump = straight(10.0, 0.0);
    jump.stations = [(0.0, 2.0), (3.0, 2.0), (3.0, 4.0), (10.0, 4.0)]
        .map(|(position, mass)| station(position, mass))
        .to_vec();
    for elements in ["", "elements = 3\n", "elements = 11\n"] {
        let mass = "[[blade.mass]]\nat = 4.1\nmass = 5\noffset = [0, 0.2, 0]\n";
        let found = input(&jump, &format!("{FILE}{elements}{mass}{MODES}")).unwrap();
        let nodes = &found.model.blades[0].nodes;
        let ends: Vec<_> = nodes.iter().step_by(2).copied().collect();
        for position in [3.0, 4.1] {
            let at = |node: &&usize| found.model.system.nodes()[**node].position.x == position;
            assert_eq!(ends.iter().filter(at).count(), 1, "{elements}: {position}");
        }
        let expected = 3.0 * 2.0 + 7.0 * 4.0 + 5.0;
        assert!((found.summary.mass / expected - 1.0).abs() < 1e-13);
    }
}

// Three elements on 1 m: nodes at each sixth. A mass at 0.5 m is on the middle node of the
// second; one at 0.6 m is nearest to the element end at 2/3 m, and reported with its arm.
#[test]
fn masses_on_pieces_are_on_the_nodes_there_or_reported() {
    let cards = |at: f64| {
        format!(
            "{STRIP}[[blade]]\nname = \"b\"\nproperties = \"strip\"\n[[blade.piece]]\nlength = 1\n\
             elements = 3\n[[blade.mass]]\nat = {at}\nmass = 5\n{MODES}"
        )
    };
    for (at, node, reported) in [
        (0.5, "b/3", None),
        (1.0, "b/tip", None),
        (
            0.6,
            "b/4",
            Some(
                "mass 1 of blade \"b\" is at 0.6 m, the nearest node is at 0.666667 m: the mass is \
                  carried by a rigid arm of 0.0666667 m",
            ),
        ),
    ] {
        let found = input(&straight(1.0, 0.0), &cards(at)).unwrap();
        let system = &found.model.system;
        let mut bodies = system
            .elements()
            .filter(|element| element.label() == "b/mass 1");
        let body = bodies.next().unwrap();
        assert_eq!(system.nodes()[body.nodes()[0]].label, node);
        let remark = found
            .remarks
            .iter()
            .find(|remark| remark.contains("mass 1"));
        match reported {
            None => assert_eq!(remark, None),
            Some(reported) => assert!(remark.unwrap().starts_with(reported), "{remark:?}"),
        }
    }
}

// Hinges at 0.3, 0.3 and 0.5 m, root at 1 m on a coned blade: nodes at these offsets, on
// the span, and one for each interval between hinges, at the inner one.
#[test]
fn hinges_lie_on_the_span_in_their_order() {
    let hinges = "hinges = [{ kind = \"lag\", offset = 0.3, stiffness = 5 }, { kind = \"flap\" },\n\
        { kind = \"pitch\", offset = 0.5, stiffness = 100, damping = 2 }]\n";
    let cards = format!("{FILE}hub_radius = 1\nprecone = 10\npitch = 12\n{hinges}{MODES}");
    let found = input(&straight(10.0, 0.0), &cards).unwrap();
    let (s, c) = 10_f64.to_radians().sin_cos();
    assert_near(node(&found, "b/hub").0, [0.3 * c, 0.0, 0.3 * s]);
    assert_near(node(&found, "b/hinge 1").0, [0.3 * c, 0.0, 0.3 * s]);
    assert_near(node(&found, "b/hinge 2").0, [0.3 * c, 0.0, 0.3 * s]);
    assert_near(node(&found, "b/root").0, [c, 0.0, s]);
    // The pitch is the angle of the last hinge: nodes before it are not turned by it.
    assert_near(
        node(&found, "b/hinge 2").1.column(1).into_owned(),
        [0.0, 1.0, 0.0],
    );
    assert_eq!(found.free_hinges, ["b/flap hinge"]);
    let system = &found.model.system;
    let residual = system.residual(&system.rest(), &Conditions::at_rest());
    assert!(residual.values.iter().all(|value| value.abs() < 1e-7));
}

/// Keys of a card, and the problem reported.
const WRONG_CARDS: &[(&str, &str)] = &[
    (
        "elements = 0\n",
        "\"elements\" is 0, expected a whole number",
    ),
    (
        "elements = 99999\n",
        "\"elements\" is 99999, expected at most 10000",
    ),
    (
        "elements = 1\n[[blade.mass]]\nat = 4\nmass = 1\n",
        "\"elements\" is 1, expected at least 2",
    ),
    (
        "root = [1, 0, 0]\nhub_radius = 1\n",
        "has \"root\" and \"hub_radius\", expected one",
    ),
    (
        "hub_radius = -1\n",
        "\"hub_radius\" is -1, expected a length, zero or more",
    ),
    (
        "count = 3\nazimuths = [0, 9]\n",
        "has \"azimuths\" and \"count\", expected one",
    ),
    ("azimuths = [0, 360]\n", "\"azimuths\" has 360 deg twice"),
    (
        "count = 3\nnames = [\"a\", \"b\"]\n",
        "\"names\" lists 2, expected 3",
    ),
    ("count = 1000\n", "\"count\" is 1000, expected at most 100"),
    (
        "part = true\naerodynamics = { stations = [] }\n",
        "has \"part\" and \"aerodynamics\", expected one of them",
    ),
    (
        "properties = \"strip\"\n",
        "has \"file\" and \"properties\", expected a blade file or",
    ),
    (
        "precone = 95\n",
        "\"precone\" is 95 deg, expected less than 90 deg",
    ),
    (
        "hub_radius = 1\nhinges = [{ kind = \"flop\" }]\n",
        "did you mean \"flap\"?",
    ),
    (
        "hinges = [{ offset = 0 }]\n",
        "has no \"kind\", expected \"flap\", \"lag\" or \"pitch\"",
    ),
    (
        "hinges = [{ kind = \"flap\", stiffness = -1 }]\n",
        "\"stiffness\" is -1, expected a moment, zero or more",
    ),
    (
        "hinges = [{ kind = \"lag\" }]\nclamp_root = true\n",
        "has \"hinges\" and \"clamp_root\"",
    ),
    (
        "hinges = [{ kind = \"lag\" }]\nmirror = true\n",
        "has \"mirror\" and \"hinges\", expected one of them",
    ),
    (
        "hinges = [{ kind = \"lag\", offset = 2 }]\n",
        "is at 2 m from the center of rotation, outboard",
    ),
    (
        "hub_radius = 1\nhinges = [{ kind = \"lag\" }, { kind = \"lag\" }]\n",
        "hinge 2 (lag) turns about the axis of a previous hinge, and neither has a stiffness",
    ),
    (
        "[[blade.mass]]\nat = 12\nmass = 1\n",
        "\"at\" is 12 m, expected a position on the line, from 0 to 10",
    ),
    ("[[blade.mass]]\nat = \"end\"\nmass = 1\n", "\"at\""),
    ("[[blade.mass]]\nat = \"tip\"\n", "has no \"mass\""),
    (
        "[[blade.mass]]\nat = \"tip\"\nmass = 1\noffest = [0, 0, 1]\n",
        "did you mean \"offset\"?",
    ),
];

#[test]
fn wrong_cards_of_blades_are_explained() {
    let hinge = "hinges = [{ kind = \"flap\", offset = 0.5 }, { kind = \"lag\", offset = 0.3 }]\n";
    for (keys, expected) in WRONG_CARDS {
        let shown = refused(&straight(10.0, 0.0), &format!("{FILE}{keys}{MODES}"));
        assert!(
            shown.contains(expected),
            "{keys}: {expected} is not in\n{shown}"
        );
    }
    let cards = format!("{FILE}hub_radius = 1\n{hinge}{MODES}");
    let shown = refused(&straight(10.0, 0.0), &cards);
    assert!(shown.contains("hinge 2 (lag) is at 0.3 m"), "{shown}");
    assert!(
        shown.contains("list the hinges from the hub outward"),
        "{shown}"
    );
    let missing = FILE.replace("a.blade", "b.blade");
    let shown = refused(&straight(10.0, 0.0), &format!("{missing}{MODES}"));
    assert!(shown.contains("b.blade.json"), "{shown}");
}

// A viscosity cannot be used as a stiffness: the values of stations are checked by their
// file, and at the evaluation points again, because a table may be interpolated in other
// ways.
#[test]
fn a_blade_file_that_is_wrong_is_reported_with_its_own_lines() {
    let mut wrong = straight(10.0, 0.0);
    wrong.stations[1].stiffness[(3, 3)] = -1.0;
    let shown = refused(&wrong, &format!("{FILE}{MODES}"));
    assert!(shown.contains("error: a.blade.json:"), "{shown}");
    assert!(shown.contains("10 m"), "{shown}");
}

// The damping of a card replaces the damping of the file.
#[test]
fn a_card_damps_the_blade_of_a_file() {
    let rates = |damping: Option<BladeDamping>, key: &str| {
        let blade = Blade {
            damping,
            ..straight(10.0, 0.3)
        };
        let found = input(&blade, &format!("{FILE}{key}{MODES}")).unwrap();
        let system = &found.model.system;
        let tangent = system.tangent(&system.rest(), &Conditions::at_rest());
        tangent.by_rates.triplets().collect::<Vec<_>>()
    };
    let key = "damping = { time = 1e-3 }\n";
    let of_file = rates(Some(BladeDamping::Proportional(1e-3)), "");
    assert_eq!(rates(Some(BladeDamping::Proportional(7.0)), key), of_file);
    assert_eq!(rates(None, key), of_file);
    assert_ne!(rates(None, ""), of_file);
}

// A stiff pitch hinge that follows a drive: 4 deg/s after half a second, the blade at rest.
#[test]
fn the_relaxed_angle_of_a_hinge_is_a_drive() {
    let hinge = "hinges = [{ kind = \"pitch\", stiffness = 100, angle = \"= 4*t\" }]\n";
    let cards = format!("{FILE}{hinge}[transient]\nto = 1\nstep = 0.1\n");
    let found = input(&straight(10.0, 0.0), &cards).unwrap();
    let system = &found.model.system;
    let mut conditions = Conditions::at_rest();
    conditions.loading.time = 0.5;
    let observed = system.observe(&system.rest(), &conditions);
    let hinge = observed
        .joints
        .iter()
        .find(|joint| joint.joint == "b/pitch hinge");
    let moment = hinge.unwrap().moment;
    assert_near(moment, [100.0 * 2.0_f64.to_radians(), 0.0, 0.0]);
    let far = cards.replace("= 4*t", "340 deg");
    let shown = refused(&straight(10.0, 0.0), &far);
    assert!(shown.contains("\"angle\""), "{shown}");
}
