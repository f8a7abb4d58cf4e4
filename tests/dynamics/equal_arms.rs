//! Models without blades: arms of nodes and beams have the names and patterns of the same blades.

use std::collections::BTreeMap;

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::case::Arms;
use beam_dynamics::input;
use beam_dynamics::result::{FixedTable, FrequencyTable};
use nalgebra::Vector3;

const SECTION: &str = "units = \"SI\"\n[properties.p]\nea = 2.8e7\ngay = 8.974e6\ngaz = 8.974e6\n\
    gj = 302.4\neiy = 233.3\neiz = 3733\nm = 1.08\niy = 9e-6\niz = 1.44e-4\n";
const MODES: &str = "[modes]\nspeeds = [0, 100, 200]\ncount = 9\n";

fn read(text: &str) -> input::Input {
    input::parse(text, "arms.dynamics.toml").unwrap()
}

fn table(text: &str) -> FrequencyTable {
    let input = read(text);
    let outcome = modes(&input.model, &input.modes.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    outcome.table
}

fn node(name: &str, position: Vector3<f64>, azimuth: f64) -> String {
    let [x, y, z] = position.into();
    format!(
        "[[node]]\nname = \"{name}\"\nposition = [{x}, {y}, {z}]\norientation = [0, 0, {azimuth}]\n"
    )
}

/// The point at a radius and an azimuth in degrees.
fn at(radius: f64, azimuth: f64) -> Vector3<f64> {
    let (s, c) = azimuth.to_radians().sin_cos();
    Vector3::new(radius * c, radius * s, 0.0)
}

/// `count` arms of 2 m, with beams of 1 m, about an axis through `center`; `root` are the cards that
/// hold the node `r` and the number.
fn arms_about(center: Vector3<f64>, count: usize, root: impl Fn(usize) -> String) -> String {
    let mut text = String::new();
    for k in 0..count {
        let azimuth = 360.0 * k as f64 / count as f64;
        for (name, radius) in [("r", 0.0), ("m", 0.5), ("t", 1.0), ("u", 1.5), ("v", 2.0)] {
            text += &node(&format!("{name}{k}"), center + at(radius, azimuth), azimuth);
        }
        for nodes in [["r", "m", "t"], ["t", "u", "v"]] {
            let nodes = nodes.map(|name| format!("\"{name}{k}\"")).join(", ");
            text += &format!("[[beam]]\nnodes = [{nodes}]\nproperties = \"p\"\n");
        }
        text += &root(k);
    }
    text
}

fn arms(count: usize, root: impl Fn(usize) -> String) -> String {
    arms_about(Vector3::zeros(), count, root)
}

fn blades(count: usize) -> String {
    format!(
        "[[blade]]\nname = \"b\"\ncount = {count}\nroot = [0, 0, 0]\nproperties = \"p\"\n\
         [[blade.piece]]\nlength = 2\nelements = 2\n"
    )
}

/// Frequencies of all modes by name and speed, in the turning axes and in the fixed system, and the
/// critical speeds by name, multiple and number.
fn results(table: &FrequencyTable) -> BTreeMap<(String, String, usize), f64> {
    let mut found = BTreeMap::new();
    let mut add = |key, value| assert_eq!(found.insert(key, value), None);
    for branch in &table.branches {
        for (k, point) in branch.points.iter().enumerate() {
            if let Some(point) = point {
                add(
                    (branch.name.clone(), "turning".to_owned(), k),
                    point.frequency,
                );
            }
        }
    }
    let fixed = FixedTable::new(table, &table.harmonics()).unwrap();
    for line in &fixed.lines {
        for (k, point) in line.points.iter().enumerate() {
            if let Some(point) = point {
                add((line.name.clone(), "fixed".to_owned(), k), point.signed);
            }
        }
    }
    let mut numbers = BTreeMap::new();
    for one in &fixed.critical {
        let number = numbers.entry((one.name.clone(), one.order)).or_insert(0);
        add(
            (one.name.clone(), format!("{}P", one.order), *number),
            one.speed,
        );
        *number += 1;
    }
    found
}

/// Cards of the node of a hub.
fn hub() -> String {
    node("hub0", Vector3::zeros(), 0.0)
}

fn rigid(k: usize) -> String {
    format!("[[rigid]]\nnodes = [\"hub0\", \"r{k}\"]\n")
}

fn clamp(k: usize) -> String {
    format!("[[clamp]]\nnode = \"r{k}\"\n")
}

/// The same beams as blades and as arms, clamped on the axis or held by a clamped node through rigid
/// connections; about z, and about another axis.
#[test]
fn arms_have_the_names_and_frequencies_of_the_same_blades() {
    let held = format!("{}[[clamp]]\nnode = \"hub0\"\n{}", hub(), arms(3, rigid));
    // About the opposite of z through another point.
    let hub_card = "[hub]\naxis = [0, 0, -1]\ncenter = [1, 2, 0]\n";
    let elsewhere = (
        hub_card.to_owned() + &arms_about(Vector3::new(1.0, 2.0, 0.0), 3, clamp),
        hub_card.to_owned() + &blades(3).replace("[0, 0, 0]", "[1, 2, 0]"),
    );
    let clamped = (2..=4).map(|count| (arms(count, clamp), blades(count)));
    let pairs = clamped.chain([(held, blades(3)), elsewhere]);
    for (arms, blades) in pairs {
        let [arms, blades] = [arms, blades].map(|cards| {
            let table = table(&format!("{SECTION}{cards}{MODES}"));
            assert_eq!(table.remarks, Vec::<String>::new());
            results(&table)
        });
        let names = |found: &BTreeMap<_, f64>| found.keys().cloned().collect::<Vec<_>>();
        assert_eq!(names(&arms), names(&blades));
        for (key, expected) in &blades {
            // Signed frequencies pass through zero.
            let error = (arms[key] - expected).abs() / expected.abs().max(1.0);
            assert!(error < 1e-8, "{key:?}: {} {expected}", arms[key]);
        }
    }
}

/// The same on a hub that moves, which couples the blades: all frequencies in both frames, the signs
/// included. Names are compared above; the hub of a card `[hub]` counts with its blades.
#[test]
fn arms_on_a_moving_hub_have_the_frequencies_of_blades_on_it() {
    let sprung = format!(
        "{}[[body]]\nnode = \"hub0\"\nmass = 5\ninertia = [0.2, 0.2, 0.3]\n\
         [[spring]]\nnode = \"hub0\"\nstiffness = [1e4, 1e4, 3e4]\n\
         rotational_stiffness = [2e3, 2e3, 4e3]\nfixed_to = \"world\"\n{}",
        hub(),
        arms(3, rigid)
    );
    let support = "[hub]\nmass = 5\ninertia = [0.2, 0.2, 0.3]\n\
         support = { in_plane = 1e4, axial = 3e4, tilt = 2e3, torsion = 4e3 }\n";
    let blades = format!("{support}{}", blades(3));
    let [arms, blades] = [sprung, blades].map(|cards| {
        let table = table(&format!("{SECTION}{cards}{MODES}"));
        let fixed = FixedTable::new(&table, &[]).unwrap();
        let turning = table
            .branches
            .iter()
            .flat_map(|branch| branch.points.iter().flatten());
        let seen = fixed
            .lines
            .iter()
            .flat_map(|line| line.points.iter().flatten());
        let mut found = [
            turning.map(|point| point.frequency).collect::<Vec<_>>(),
            seen.map(|point| point.signed).collect(),
        ];
        found
            .iter_mut()
            .for_each(|values| values.sort_by(f64::total_cmp));
        found
    });
    for (arms, blades) in arms.iter().zip(&blades) {
        assert_eq!(arms.len(), blades.len());
        for (found, expected) in arms.iter().zip(blades) {
            let error = (found - expected).abs() / expected.abs().max(1.0);
            assert!(error < 1e-8, "{found} {expected}");
        }
    }
}

/// Arms on flapping hinges on the axis: the arm stays straight, since the centrifugal stiffness and the
/// inertia of the motion w = r are in balance at every point, and flaps as a rigid body at
/// `omega^2 = Omega^2 (I_z - I_x) / I_y`, with e = 3 iy / (m L^2) for the strip
/// `omega = Omega sqrt((1 - e) / (1 + e))`. In the fixed system the collective flap has this frequency,
/// the progressive one 1P more, and the regressive one 1P less: a tilted disk, nearly at rest.
#[test]
fn arms_on_hinges_flap_once_per_revolution() {
    let hinge = |k: usize| {
        format!("[[hinge]]\nnodes = [\"hub0\", \"r{k}\"]\naxis = [0, 1, 0]\naxis_in = \"node\"\n")
    };
    let table = table(&format!(
        "{SECTION}{}[[clamp]]\nnode = \"hub0\"\n{}[modes]\nspeeds = [100, 200]\ncount = 6\n",
        hub(),
        arms(3, hinge)
    ));
    let fixed = FixedTable::new(&table, &[]).unwrap();
    let e: f64 = 3.0 * 9e-6 / (1.08 * 4.0);
    let flap = ((1.0 - e) / (1.0 + e)).sqrt();
    for (k, turns) in [100.0 / 60.0, 200.0 / 60.0].into_iter().enumerate() {
        for (name, shift) in [
            ("collective", 0.0),
            ("progressive", 1.0),
            ("regressive", -1.0),
        ] {
            let name = format!("flap 1 {name}");
            let line = fixed.lines.iter().find(|line| line.name == name).unwrap();
            let found = line.points[k].unwrap().signed / turns;
            assert!(
                (found.abs() - (flap + shift).abs()).abs() < 1e-8,
                "{name}: {found}"
            );
        }
    }
}

/// A mass at the tip of one of three arms: no equal arms, which a remark explains, and each arm has
/// still its own axes. Two of the arms keep their flap frequency.
#[test]
fn unequal_arms_are_reported_and_named_by_their_own_axes() {
    let body = "[[body]]\nnode = \"v1\"\nmass = 0.1\ninertia = [0, 0, 0]\n";
    let text = format!("{SECTION}{}{body}{MODES}", arms(3, clamp));
    let table = table(&text);
    assert_eq!(FixedTable::new(&table, &[1]), None);
    let expected = "the Campbell diagram leaves out the modes of the arms, which have no pattern around \
        the axis: the 3 arms are not equal: stiffness, mass, damping or joints at node \"v0\" differ \
        from those 120 deg on around the axis";
    assert_eq!(table.remarks, [expected]);
    let names: Vec<_> = table
        .branches
        .iter()
        .map(|branch| branch.name.as_str())
        .collect();
    let expected = [
        "flap 1", "flap 2", "flap 3", "lag 1", "lag 2", "lag 3", "flap 4", "flap 5", "flap 6",
    ];
    assert_eq!(names, expected);
    let moved = text.replace("position = [-0.99", "position = [-0.98");
    assert_ne!(moved, text);
    match read(&moved).model.arms {
        Arms::Unequal(why) => assert!(
            why.contains("node \"v0\" would be") && why.ends_with("nearest is 0.01 m away"),
            "{why}"
        ),
        other => panic!("{other:?}"),
    }
}

/// A beam whose section axes are turned by `turn` from the axes of its nodes.
fn beam_card(names: &[&str; 3], turn: &str) -> String {
    let nodes = names.map(|name| format!("\"{name}\"")).join(", ");
    format!(
        "[[beam]]\nnodes = [{nodes}]\nproperties = \"p\"\nsection_axes = [{turn}, {turn}, {turn}]\n"
    )
}

/// Direction of the span by which a node is named.
fn span(input: &input::Input, name: &str) -> Option<Vector3<f64>> {
    let nodes = input.model.system.nodes();
    let index = nodes.iter().position(|node| node.label == name).unwrap();
    let axes = &input.model.naming[index];
    (!axes.is_central).then(|| axes.blade.column(0).into_owned())
}

/// A mast along the axis z with a crossbar of two arms at its top, a boom along x with a crossbar at
/// its end, and a body at the tip of one arm.
#[test]
fn masts_are_central_and_branches_have_their_own_span() {
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
    let mut text = SECTION.to_owned();
    // The middle node is between the ends; turns of the section axes in degrees.
    let mut beam = |names: [&str; 3], [from, to]: [Vector3<f64>; 2], turn: &str| {
        for (name, position) in [(names[1], 0.5 * (from + to)), (names[2], to)] {
            text += &node(name, position, 0.0);
        }
        text += &beam_card(&names, turn);
    };
    beam(["foot", "mast", "top"], [-2.0 * z, 0.0 * z], "[0, -90, 0]");
    beam(["top", "right", "tip"], [0.0 * y, y], "[0, 0, 90]");
    beam(["top", "left", "left tip"], [0.0 * y, -y], "[0, 0, -90]");
    beam(["top", "boom", "tail"], [0.0 * x, 3.0 * x], "[0, 0, 0]");
    beam(
        ["tail", "fin", "fin tip"],
        [3.0 * x, 3.0 * x + y],
        "[0, 0, 90]",
    );
    beam(
        ["tail", "wing", "wing tip"],
        [3.0 * x, 3.0 * x - y],
        "[0, 0, -90]",
    );
    text += &node("foot", -2.0 * z, 0.0);
    text += "[[clamp]]\nnode = \"foot\"\n";
    text += &node("ball", y + 0.1 * z, 0.0);
    text += "[[body]]\nnode = \"ball\"\nmass = 1\ninertia = [0, 0, 0]\n\
             [[rigid]]\nnodes = [\"tip\", \"ball\"]\n[modes]\nspeeds = 0\n";
    let input = read(&text);
    for (name, expected) in [
        ("foot", None),
        ("mast", None),
        ("top", None),
        ("right", Some(y)),
        ("ball", Some(y)),
        ("left tip", Some(-y)),
        ("boom", Some(x)),
        ("tail", Some(x)),
        ("fin", Some(y)),
        ("wing tip", Some(-y)),
    ] {
        let off = match (span(&input, name), expected) {
            (Some(found), Some(expected)) => (found - expected).norm(),
            (found, expected) => f64::from(u8::from(found.is_some() != expected.is_some())),
        };
        assert!(off < 1e-12, "{name}: {:?}", span(&input, name));
    }
}

/// Three arms whose roots, off the axis, are plates on one clamped plate: each has its own span, its
/// root included, although they are connected beside the axis. A hinge within an arm does not part it.
#[test]
fn arms_on_plates_have_their_own_span() {
    let mut text = SECTION.to_owned();
    for k in 0..3 {
        let azimuth = 120.0 * k as f64;
        let points = [
            ("r", 0.2),
            ("m", 0.4),
            ("t", 0.6),
            ("h", 0.6),
            ("u", 1.1),
            ("v", 1.6),
        ];
        for (name, radius) in points {
            text += &node(&format!("{name}{k}"), at(radius, azimuth), azimuth);
        }
        for names in [["r", "m", "t"], ["h", "u", "v"]] {
            let names = names.map(|name| format!("{name}{k}"));
            text += &beam_card(&[&names[0], &names[1], &names[2]], "[0, 0, 0]");
        }
        text += &format!(
            "[[hinge]]\nnodes = [\"t{k}\", \"h{k}\"]\naxis = [0, 1, 0]\naxis_in = \"node\"\n\
             stiffness = 100\n"
        );
    }
    text += "[[clamp]]\nnode = \"r0\"\n[[rigid]]\nnodes = [\"r0\", \"r1\"]\n\
             [[rigid]]\nnodes = [\"r0\", \"r2\"]\n";
    let input = read(&format!("{text}[modes]\nspeeds = [0, 100]\ncount = 3\n"));
    for k in 0..3 {
        for name in ["r", "m", "t", "h", "u", "v"] {
            let found = span(&input, &format!("{name}{k}")).unwrap();
            assert!(
                (found - at(1.0, 120.0 * k as f64)).norm() < 1e-12,
                "{name}{k}: {found}"
            );
        }
    }
    let outcome = modes(&input.model, input.modes.as_ref().unwrap());
    let names: Vec<_> = outcome
        .table
        .branches
        .iter()
        .map(|branch| &branch.name)
        .collect();
    assert_eq!(names, ["flap 1", "flap 2", "flap 3"]);
}

/// A wheel of four spokes, whose rim is of four straight beams: equal quarters although they are
/// connected, each node with the axes of the first quarter, turned.
#[test]
fn a_wheel_has_equal_quarters() {
    let mut text = format!(
        "{SECTION}{}[[clamp]]\nnode = \"hub0\"\n",
        node("hub0", at(0.0, 0.0), 0.0)
    );
    for k in 0..4 {
        let azimuth = 90.0 * k as f64;
        let [spoke, end, rim] = ["s", "e", "c"].map(|name| format!("{name}{k}"));
        let next = format!("e{}", (k + 1) % 4);
        text += &node(&spoke, at(0.5, azimuth), 0.0);
        text += &node(&end, at(1.0, azimuth), 0.0);
        text += &node(&rim, at(0.5_f64.sqrt(), azimuth + 45.0), 0.0);
        text += &beam_card(&["hub0", &spoke, &end], &format!("[0, 0, {azimuth}]"));
        text += &beam_card(
            &[&end, &rim, &next],
            &format!("[0, 0, {}]", azimuth + 135.0),
        );
    }
    let input = read(&format!("{text}[modes]\nspeeds = [0, 100]\ncount = 8\n"));
    match &input.model.arms {
        Arms::Equal(arms) => {
            let sizes: Vec<_> = arms.iter().map(|arm| arm.nodes.len()).collect();
            assert_eq!(sizes, [3; 4]);
        }
        other => panic!("{other:?}"),
    }
    assert_eq!(span(&input, "hub0"), None);
    for k in 0..4 {
        let azimuth = 90.0 * k as f64;
        let found = span(&input, &format!("s{k}")).unwrap();
        assert!((found - at(1.0, azimuth)).norm() < 1e-12, "{found}");
        let along = span(&input, &format!("c{k}"))
            .unwrap()
            .dot(&at(1.0, azimuth + 135.0));
        assert!(along.abs() > 1.0 - 1e-12, "{along}");
    }
    let outcome = modes(&input.model, input.modes.as_ref().unwrap());
    let fixed = FixedTable::new(&outcome.table, &[1, 4]).unwrap();
    assert_eq!(fixed.lines.len(), outcome.table.branches.len());
}

/// A turning shaft that is stiffer in one direction than in the other: three of four modes whirl both
/// ways, which a remark states.
#[test]
fn modes_of_an_unsymmetric_shaft_are_reported_as_left_out() {
    let shaft = "[hub]\naxis = [1, 0, 0]\n[[node]]\nname = \"a\"\nposition = [0, 0, 0]\n\
        [[node]]\nname = \"b\"\nposition = [1, 0, 0]\n[[node]]\nname = \"c\"\nposition = [2, 0, 0]\n\
        [[clamp]]\nnode = \"a\"\n[[beam]]\nnodes = [\"a\", \"b\", \"c\"]\nproperties = \"p\"\n\
        [modes]\nspeeds = [0, 200]\ncount = 4\n";
    let table = table(
        &format!("{SECTION}{shaft}").replace("eiy = 233.3\neiz = 3733", "eiy = 2330\neiz = 37330"),
    );
    let fixed = FixedTable::new(&table, &[1]).unwrap();
    assert_eq!(fixed.lines.len(), 1);
    let start =
        "the Campbell diagram leaves out 3 of 4 modes: 3 modes have several patterns around";
    assert_eq!(table.remarks.len(), 1);
    assert!(table.remarks[0].starts_with(start), "{:?}", table.remarks);
}
