//! Tests of repeated and shared cards: parameters, frames, copies, included files, signals;
//! and of the problems reported for wrong ones.

#![allow(
    clippy::unwrap_used,
    reason = "helpers of tests unwrap inputs of the tests"
)]

use nalgebra::Vector3;

use super::Input;
use super::test_files::{STRIP, read_beside, reported};
use crate::elements::Element;
use crate::model::{Conditions, Loading, TurningFrame};

fn input(cards: &str) -> Result<Input, String> {
    read_beside(&format!("units = \"SI\"\n{STRIP}{cards}"), &[])
}

#[track_caller]
fn refused(cards: &str) -> String {
    reported(input(cards))
}

/// Compares positions and axes of the nodes, and the residual at rest under loads, of two
/// inputs.
fn assert_same(found: &Input, expected: &Input) {
    let [found, expected] = [found, expected].map(|input| &input.model.system);
    assert_eq!(found.nodes().len(), expected.nodes().len());
    for (a, b) in found.nodes().iter().zip(expected.nodes()) {
        assert_eq!(a.label, b.label);
        assert!((a.position - b.position).amax() < 1e-12, "{a:?} {b:?}");
        assert!((a.rotation - b.rotation).amax() < 1e-12, "{a:?} {b:?}");
    }
    let labels = |elements: Vec<&dyn Element>| {
        let all = elements.iter().map(|one| one.label().to_owned());
        all.collect::<Vec<_>>()
    };
    assert_eq!(
        labels(found.elements().collect()),
        labels(expected.elements().collect())
    );
    let conditions = conditions(0.3);
    let [a, b] = [found, expected].map(|system| system.residual(&system.rest(), &conditions));
    for (a, b) in a.values.iter().zip(&b.values) {
        // Forces of 50 N, rounded.
        assert!((a - b).abs() < 1e-12 * 50.0, "{a} {b}");
    }
}

fn conditions(time: f64) -> Conditions {
    Conditions {
        frame: TurningFrame::at_rest(),
        loading: Loading {
            gravity: Vector3::zeros(),
            constant: 1.0,
            proportional: 1.0,
            released: 0.0,
            resting: 0.0,
            time,
            turns: 1.0,
            voltages: 1.0,
            air: 1.0,
        },
    }
}

/// An arm from the hub's radius 1 to 3 along x, loaded at its tip.
const ARMS: &str = "
[[repeat]]
name = \"arm\"
count = 3
center = [0.5, 0, 0]
[[repeat.node]]
name = \"root\"
position = [1.5, 0, 0]
[[repeat.node]]
name = \"mid\"
position = [2.5, 0, 0]
[[repeat.node]]
name = \"tip\"
position = [3.5, 0, 0]
orientation = [0, 10, 0]
[[repeat.beam]]
name = \"beam\"
nodes = [\"root\", \"mid\", \"tip\"]
properties = \"strip\"
section_axes = [[0, 0, 0], [0, 0, 0], [0, -10, 0]]
[[repeat.clamp]]
node = \"root\"
[[repeat.load]]
name = \"pull\"
node = \"tip\"
force = [10, 20, 5]
drive = \"= cos(2*t)\"
[modes]
speeds = 0
count = 4
";

// The same arms as explicit cards: rotated by 120 and 240 degrees about z through
// (0.5, 0, 0), with the orientation of the tip as a rotation vector in the model's axes.
#[test]
fn polar_copies_are_what_one_would_write_by_hand() {
    let mut cards = String::new();
    for (name, shape) in [("root", 1.0), ("mid", 2.0), ("tip", 3.0)] {
        for copy in 0..3 {
            let (sin, cos) = (120.0 * f64::from(copy)).to_radians().sin_cos();
            let position = [0.5 + shape * cos, shape * sin, 0.0];
            let turn = Vector3::new(0.0, 0.0, 120.0_f64.to_radians() * f64::from(copy));
            let mut axes = shared_geom::rotation::vector::to_rotation(&turn);
            if name == "tip" {
                let own = Vector3::new(0.0, 10.0_f64.to_radians(), 0.0);
                axes *= shared_geom::rotation::vector::to_rotation(&own);
            }
            let phi = shared_geom::rotation::vector::from_rotation(&axes).map(f64::to_degrees);
            let at = 1 + copy;
            cards += &format!("[[node]]\nname = \"{name} {at}\"\nposition = {position:?}\n");
            cards += &format!("orientation = {:?}\n", [phi.x, phi.y, phi.z]);
        }
    }
    // Copies come arm by arm, and so do the nodes.
    let mut blocks: Vec<_> = cards.split("[[node]]\n").skip(1).collect();
    blocks.sort_by_key(|block| {
        block.find(" ").map(|_| {
            block.split('"').nth(1).unwrap()[..]
                .rsplit(' ')
                .next()
                .unwrap()
                .to_owned()
        })
    });
    let mut cards: String = blocks
        .iter()
        .map(|block| format!("[[node]]\n{block}"))
        .collect();
    for copy in 1..=3 {
        let (sin, cos) = (120.0 * f64::from(copy - 1)).to_radians().sin_cos();
        let force = [10.0 * cos - 20.0 * sin, 10.0 * sin + 20.0 * cos, 5.0];
        cards += &format!(
            "[[beam]]\nname = \"beam {copy}\"\nproperties = \"strip\"\n\
             nodes = [\"root {copy}\", \"mid {copy}\", \"tip {copy}\"]\n\
             section_axes = [[0, 0, 0], [0, 0, 0], [0, -10, 0]]\n\
             [[clamp]]\nnode = \"root {copy}\"\n\
             [[load]]\nname = \"pull {copy}\"\nnode = \"tip {copy}\"\nforce = {force:?}\n\
             drive = \"= cos(2*t)\"\n"
        );
    }
    let by_hand = input(&format!("{cards}[modes]\nspeeds = 0\ncount = 4\n")).unwrap();
    assert_same(&input(ARMS).unwrap(), &by_hand);
}

#[test]
fn frames_lie_in_frames() {
    // A quarter turn about z at (1, 0, 0), and a frame in it at (0, 2, 0) turned about x.
    let cards = "
[[frame]]
name = \"outer\"
position = [1, 0, 0]
orientation = [0, 0, 90]
[[frame]]
name = \"inner\"
in = \"outer\"
position = [0, 2, 0]
orientation = [90, 0, 0]
[[node]]
name = \"a\"
in = \"inner\"
position = [0, 0, 3]
velocity = [0, 0, 4]
[[body]]
node = \"a\"
mass = 2
inertia = [1, 1, 1]
[[load]]
node = \"a\"
in = \"inner\"
force = [0, 0, 5]
[transient]
to = 1
step = 0.1
";
    let found = input(cards).unwrap();
    let node = &found.model.system.nodes()[0];
    // In outer: (0, 2, 0) + 3 (0, -1, 0) = (0, -1, 0); in the model: (1, 0, 0) + (1, 0, 0).
    let expected = Vector3::new(2.0, 0.0, 0.0);
    assert!((node.position - expected).amax() < 1e-14, "{node:?}");
    let velocity = found.model.initial[0].velocity.unwrap();
    assert!((velocity - Vector3::new(4.0, 0.0, 0.0)).amax() < 1e-14);
    let system = &found.model.system;
    let residual = system.residual(&system.rest(), &conditions(0.0));
    let force = Vector3::from_column_slice(&residual.values[6..9]);
    assert!(
        (force - Vector3::new(5.0, 0.0, 0.0)).amax() < 1e-14,
        "{force}"
    );
    let cycle = refused(&cards.replacen("position = [1, 0, 0]", "in = \"inner\"", 1));
    assert!(
        cycle.contains("the frame \"inner\" is in itself: inner in outer in inner"),
        "{cycle}"
    );
    let unknown = refused(&cards.replacen("in = \"outer\"", "in = \"oter\"", 1));
    assert!(
        unknown.contains("unknown frame \"oter\"\n  help: did you mean \"outer\"?"),
        "{unknown}"
    );
}

// Copies of a hinged body with a joint, a spring and a force between nodes, by half a
// turn: points (x, y) -> (-x, -y).
#[test]
fn joints_springs_and_forces_turn_with_their_copy() {
    let cards = |kind: &str, name: &str, sign: f64, axes: &str| {
        let x = |value: f64| sign * value;
        format!(
            "[[{kind}node]]\nname = \"in{name}\"\nposition = [{}, 0, 0]\n{axes}\
             [[{kind}node]]\nname = \"out{name}\"\nposition = [{}, {}, 0]\n{axes}\
             [[{kind}body]]\nname = \"mass{name}\"\nnode = \"out{name}\"\nmass = 2\ninertia = [1, 1, 1]\n\
             [[{kind}clamp]]\nnode = \"in{name}\"\n\
             [[{kind}joint]]\nname = \"pin{name}\"\nkind = \"revolute\"\n\
             nodes = [\"in{name}\", \"out{name}\"]\nat = [{}, {}, 0]\naxis = [{}, {}, 1]\n\
             [[{kind}spring]]\nname = \"spring{name}\"\nnode = \"out{name}\"\nstiffness = [1, 2, 3]\n\
             orientation = [0, 0, {}]\n\
             [[{kind}internal_force]]\nname = \"pull{name}\"\nnodes = [\"in{name}\", \"out{name}\"]\n\
             force = [{}, {}, 3]\n",
            x(1.0),
            x(2.0),
            x(0.5),
            x(1.5),
            x(0.25),
            x(0.1),
            x(0.2),
            if sign > 0.0 { 20.0 } else { 200.0 },
            x(1.0),
            x(2.0),
        )
    };
    let end = "[transient]\nto = 1\nstep = 0.1\n";
    let half = "orientation = [0, 0, 180]\n";
    let by_hand = [cards("", " 1", 1.0, ""), cards("", " 2", -1.0, half)].concat();
    let copies = format!(
        "[[repeat]]\nname = \"side\"\ncount = 2\n{}",
        cards("repeat.", "", 1.0, "")
    );
    let [found, expected] = [copies, by_hand].map(|cards| input(&format!("{cards}{end}")).unwrap());
    let [a, b] = [&found, &expected].map(|input| {
        let system = &input.model.system;
        let mut state = system.rest();
        for (i, node) in state.nodes.iter_mut().enumerate() {
            node.position += Vector3::new(0.1, 0.2, -0.1) * (i as f64 + 1.0);
        }
        // Multipliers of a joint turn with axes that are not perpendicular to its own.
        let values = system.residual(&state, &conditions(0.0)).values;
        values[..12 * system.nodes().len()].to_vec()
    });
    for (a, b) in a.iter().zip(&b) {
        assert!((a - b).abs() < 1e-12, "{a} {b}");
    }
    assert_eq!(
        found.model.system.numbering(),
        expected.model.system.numbering()
    );
}

#[test]
fn equilibria_request_tables_for_the_time_zero() {
    let late = ARMS.replace(
        "\"= cos(2*t)\"",
        "{ kind = \"table\", rows = [[1, 0], [2, 1]] }",
    );
    let shown = refused(&late);
    assert!(
        shown.contains("\"drive\" has values from 1 s to 2 s, and the run goes from 0 s to 0 s"),
        "{shown}"
    );
}

#[test]
fn parameters_are_in_any_number() {
    let written = ARMS
        .replace("count = 3", "count = \"= arms\"")
        .replace("[1.5, 0, 0]", "[\"= radius + 0.5\", 0, 0]")
        .replace(
            "[10, 20, 5]",
            "[\"= pull\", \"= 2*pull\", \"= pull/arms + 5 - pull/3\"]",
        );
    let parameters =
        "[parameters]\npull = \"= 5*load\"\narms = 3\nradius = \"1000 mm\"\nload = 2\n";
    let found = input(&format!("{written}{parameters}")).unwrap();
    assert_same(&found, &input(ARMS).unwrap());
}

#[test]
fn included_files_count_from_their_own_folder_and_report_their_own_lines() {
    let main = "units = \"SI\"\ninclude = [\"parts/arms.toml\"]\n[properties.other]\nea = 1\n";
    let rest = main.replace("[properties.other]\nea = 1\n", "[modes]\nspeeds = 0\n");
    let arms =
        format!("include = \"strip.toml\"\n{ARMS}").replace("[modes]\nspeeds = 0\ncount = 4\n", "");
    let files = [
        ("parts/arms.toml", arms.as_str()),
        ("parts/strip.toml", STRIP),
    ];
    let found = read_beside(&rest, &files).unwrap();
    assert_same(&found, &input(ARMS).unwrap());
    // An error in an included file.
    let wrong = arms.replacen("name = \"mid\"\n", "name = \"root\"\n", 1);
    let files = [
        ("parts/arms.toml", wrong.as_str()),
        ("parts/strip.toml", STRIP),
    ];
    let shown = read_beside(&rest, &files).unwrap_err();
    let expected = "parts/arms.toml:11: node \"root 1\" is already defined on line 8 of";
    assert!(shown.contains(expected), "{shown}");
    let refused = |main: &str, other: &str| {
        read_beside(
            main,
            &[("b.toml", other), ("c.toml", "include = \"b.toml\"\n")],
        )
        .unwrap_err()
    };
    let to_b = "units = \"SI\"\ninclude = \"b.toml\"\n";
    assert_eq!(
        refused(to_b, "\ninclude = \"c.toml\"\n"),
        "error: c.toml:1: \"include\": the file \"b.toml\" includes itself"
    );
    assert_eq!(
        refused(
            "units = \"SI\"\ninclude = [\"b.toml\", \"b.toml\"]\n",
            "[modes]\n"
        ),
        "error: a.dynamics.toml:2: \"include\": the file \"b.toml\" is included already"
    );
    assert_eq!(
        refused(to_b, "units = \"SI\"\n"),
        "error: b.toml:1: an included file has \"units\", expected none\n  \
         help: its numbers count in the units of the file that includes it"
    );
    assert!(
        refused("units = \"SI\"\ninclude = \"bb.toml\"\n", "").contains(
            "a.dynamics.toml:2: \"include\": no file \"bb.toml\"\n  help: did you mean \"b.toml\"?"
        )
    );
    assert_eq!(
        refused(
            "units = \"SI\"\ninclude = \"b.toml\"\nname = \"x\"\n",
            "name = \"y\"\n"
        ),
        "error: b.toml:1: \"name\" is given in a.dynamics.toml:3 already, expected it once"
    );
    assert!(refused(to_b, "x = = 1\n").contains("b.toml:1: not valid TOML"));
}

const SPRUNG: &str = "
[[node]]
name = \"a\"
position = [1, 0, 0]
[[body]]
node = \"a\"
mass = 2
inertia = [1, 1, 1]
[[load]]
node = \"a\"
force = [0, 0, 1]
drive = \"= -k*(height - 2) - 3*fall\"
[gravity]
acceleration = [0, 0, -10]
drive = { kind = \"ramp\", to = 1, end = 2 }
[sensors.height]
quantity = \"position\"
of = \"a\"
component = \"z\"
[sensors.fall]
quantity = \"velocity\"
of = \"a\"
component = \"z\"
unit = \"mm/s\"
[parameters]
k = 100
[transient]
to = 1
step = 0.1
";

// F = -100 (z - 2) - 3 v, with v in mm/s, at z = 0.5 and v = 0.02 m/s: 150 - 60.
#[test]
fn loads_sense_nodes() {
    let found = input(SPRUNG).unwrap();
    let system = &found.model.system;
    let mut state = system.rest();
    state.nodes[0].position.z = 0.5;
    state.nodes[0].velocity.z = 0.02;
    // The equations of the sensors: s - q = 0.
    let first = system.numbering().first_scalar();
    let sensed = system.residual(&state, &conditions(0.0)).values;
    state.scalars = sensed[first..].iter().map(|off| -off).collect();
    assert_eq!(state.scalars, [0.5, 0.02]);
    let residual = system.residual(&state, &conditions(0.0));
    assert!((residual.values[8] - 90.0).abs() < 1e-12, "{residual:?}");
    assert_eq!(found.model.gravity_at(1.0).z, -5.0);
    assert_eq!(found.model.conditions_at(0.5).loading.gravity.z, -2.5);
    assert_eq!(found.model.next_corner(0.5), 2.0);
    // Statics are at time zero.
    assert_eq!(found.model.conditions(0.0, 1.0, 1.0).loading.gravity.z, 0.0);
    let gravity = refused(&SPRUNG.replace("{ kind = \"ramp\", to = 1, end = 2 }", "\"= height\""));
    assert!(
        gravity.contains("\"drive\" senses \"height\", expected a function of time only"),
        "{gravity}"
    );
    let sensor = refused(
        &SPRUNG
            .replace("sensors.fall", "sensors.sin")
            .replace("3*fall", "3"),
    );
    assert!(
        sensor.contains("\"sin\" is not a name of a signal"),
        "{sensor}"
    );
}

#[test]
fn ten_mistakes_are_reported_at_once() {
    let cards = SPRUNG
        .replace("k = 100", "k = \"= 2*q\"\nq = \"= k\"\n2x = 1")
        .replace(
            "kind = \"ramp\", to = 1, end = 2",
            "kind = \"ramp\", too = 1, end = -2",
        )
        .replace(
            "quantity = \"position\"\nof = \"a\"",
            "quantity = \"positon\"\nof = \"a\"",
        )
        .replace(
            "quantity = \"velocity\"\nof = \"a\"",
            "quantity = \"velocity\"\nof = \"b\"",
        )
        .replace("unit = \"mm/s\"", "unit = \"mm\"")
        .replace(
            "position = [1, 0, 0]",
            "position = [\"= 1 +\", \"= sqr(2)\", \"2 kg\"]",
        )
        .replace("node = \"a\"\nmass", "node = \"a\"\nin = \"here\"\nmass");
    let shown = refused(&cards);
    for expected in [
        "\"position\": letter 5 of \"1 +\" is the end, expected a number, a name or \"(\"",
        "\"position\": unknown function \"sqr\" at letter 2 of \"sqr(2)\"\n  help: did you mean \"sqrt\"?",
        "\"position\": \"kg\" measures a mass, expected a length",
        "unknown key \"in\" in [[body]] number 1",
        "\"quantity\" is \"positon\"",
        "unknown node \"b\" in sensor \"fall\"",
        "\"unit\": \"mm\" measures a length",
        "has no \"to\", expected",
        "unknown key \"too\"",
        "the parameter \"k\" depends on itself: k -> q -> k",
        "\"2x\" is no name of a parameter",
    ] {
        assert!(shown.contains(expected), "{expected}\nis not in\n{shown}");
    }
    assert!(
        shown
            .lines()
            .filter(|line| line.starts_with("error: a.dynamics.toml:"))
            .count()
            >= 10
    );
}

/// A system of states between the sensors of [`SPRUNG`] and its load.
const SYSTEM: &str = "\
[[state_space]]
name = \"law\"
inputs = [\"height\", \"= 2*fall + t\", 3]
outputs = [\"push\", \"second\"]
a = [[-1, 0], [0, -2]]
b = [[1, 0, 0], [0, 1, 0]]
c = [[1, 1], [0, 1]]
";

#[test]
fn systems_of_states_are_between_sensors_and_loads() {
    let text = SPRUNG.replace("= -k*(height - 2) - 3*fall", "= push - second") + SYSTEM;
    let found = input(&text).unwrap();
    let system = &found.model.system;
    let names: Vec<_> = system.scalars().iter().collect();
    let names = names
        .iter()
        .map(|own| format!("{} {}", own.owner, own.unknown.name));
    assert_eq!(
        names.collect::<Vec<_>>(),
        [
            "height position",
            "fall velocity",
            "law state 1",
            "law state 2",
            "law push",
            "law second",
        ]
    );
    // One input needs no list, and no delay is a delay.
    let short = text.replace("[\"height\", \"= 2*fall + t\", 3]", "\"height\"");
    let short = short.replace(
        "b = [[1, 0, 0], [0, 1, 0]]",
        "b = [[1], [0]]\nsample_time = 1\ndelay = 0",
    );
    assert_eq!(
        input(&short).unwrap().model.system.numbering().memory(),
        1 + 2 + 2
    );
    let taken = refused(&format!(
        "{text}[drives.push]\nkind = \"ramp\"\nto = 1\nend = 2\n"
    ));
    assert!(
        taken.contains("\"push\" is the name of a drive already"),
        "{taken}"
    );
    // The same as a sampled system, which stores two states and three pairs of outputs.
    let keys = "sample_time = 0.01\ndelay = 2\nlimits = [-1, 1]\nrate_limits = [5, 6]\n";
    let sampled = input(&format!("{text}{keys}")).unwrap();
    assert_eq!(sampled.model.system.numbering().memory(), 1 + 2 + 6);
    assert_eq!(sampled.model.next_corner(0.013), 0.02);
    let at_rest = format!("{text}{keys}[[clamp]]\nnode = \"a\"\n[static]\n");
    let remarks = input(&at_rest).unwrap().remarks;
    assert!(
        remarks
            .iter()
            .any(|text| text.contains("\"law\", which samples")),
        "{remarks:?}"
    );
}

#[test]
fn what_is_wrong_with_systems_of_states_is_reported() {
    let load = SPRUNG.replace("= -k*(height - 2) - 3*fall", "= push - second");
    for (from, to, reported) in [
        (
            "outputs = [\"push\", \"second\"]",
            "outputs = [\"push\", \"height\"]",
            "\"height\" is the name of a sensor, an output or a control already",
        ),
        (
            "b = [[1, 0, 0], [0, 1, 0]]",
            "b = [[1, 0], [0, 1]]",
            "expected a row of 3 numbers",
        ),
        (
            "c = [[1, 1], [0, 1]]",
            "start = [1]",
            "\"start\" has 1 numbers, and the system 2 states",
        ),
        ("c = [[1, 1], [0, 1]]", "start = \"settle\"", "settled"),
        (
            "c = [[1, 1], [0, 1]]",
            "delay = 1",
            "\"delay\" applies to systems that sample",
        ),
        (
            "c = [[1, 1], [0, 1]]",
            "numerator = [1]",
            "given by \"a\" to \"d\" and \"numerator\"",
        ),
        ("c = [[1, 1], [0, 1]]", "sample_time = 0", "sample_time"),
        (
            "c = [[1, 1], [0, 1]]",
            "sample_time = 0.1\nlimits = [1, -1]",
            "the least value before the largest",
        ),
        (
            "c = [[1, 1], [0, 1]]",
            "sample_time = 0.1\nrate_limits = [0, 1]",
            "rates greater than zero",
        ),
        (
            "inputs = [\"height\", \"= 2*fall + t\", 3]",
            "inputs = [\"heigt\", \"= 2*fal\", 3]",
            "heigt",
        ),
        ("inputs = [\"height\", \"= 2*fall + t\", 3]", "", "inputs"),
    ] {
        let text = format!("{load}{SYSTEM}");
        assert!(text.contains(from), "{from}");
        let found = refused(&text.replace(from, to));
        assert!(found.contains(reported), "{reported}\n{found}");
    }
}

#[test]
fn what_is_wrong_with_transfer_functions_is_reported() {
    let single = "[[state_space]]\nname = \"law\"\ninputs = [\"height\"]\noutputs = [\"push\"]\n";
    let single_load = SPRUNG.replace("= -k*(height - 2) - 3*fall", "= push");
    for (keys, reported) in [
        (
            "numerator = 1\ndenominator = [1, 1]",
            "expected a list of coefficients",
        ),
        ("transfer = []", "given by nothing"),
        (
            "d = [[1]]\nsample_time = 0.01\ndelay = 1e7",
            "a whole number of samples, 0 to 100000",
        ),
        (
            "d = [[1]]\nsample_time = 0.01\ndelay = 0.5",
            "a whole number of samples, 0 to 100000",
        ),
        (
            "d = [[1]]\nsample_time = 0.01\noffset = 1e16",
            "less than 1e9 sample times",
        ),
        (
            "d = [[1]]\nsample_time = 1e-300",
            "\"sample_time\" gives 1.0e300 samples in the run",
        ),
        ("d = [[1]]\nstart = 1", "a list of numbers, or \"settled\""),
        ("", "the system is given by nothing, expected one way"),
        (
            "numerator = [1, 0]\ndenominator = [1]",
            "\"numerator\" has 2 coefficients",
        ),
        ("numerator = [1]", "denominator"),
        ("file = \"no.toml\"", "no.toml"),
        (
            "[[state_space.transfer]]\noutput = \"pull\"\ninput = 2\nnumerator = [1]\ndenominator = [1, 1]",
            "the index of an input, 1 to 1",
        ),
    ] {
        let found = refused(&format!("{single_load}{single}{keys}\n"));
        assert!(found.contains(reported), "{reported}\n{found}");
    }
}
