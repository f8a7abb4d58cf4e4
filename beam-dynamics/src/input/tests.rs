//! Tests of the whole input: the models of valid files, and the problems reported for
//! others.

use std::path::Path;

use approx::assert_relative_eq;
use nalgebra::Vector3;

use super::test_files::{STRIP, read_beside, reported};
use super::{Input, name_of};
use crate::model::{Conditions, NamingAxes};
use crate::result::ModeKind;

const BLADE: &str = "
[[blade]]
name = \"b\"
root = [2, 0, 0]
properties = \"strip\"
[[blade.piece]]
length = 6
elements = 2
[[blade.piece]]
length = 4
elements = 1
sweep = 30
twist = [5, 25]
";

const BEAM: &str = "
[[node]]
name = \"root\"
position = [0, 0, 0]
[[node]]
name = \"mid\"
position = [1, 0, 0]
[[node]]
name = \"tip\"
position = [2, 0, 0]
[[beam]]
name = \"inner\"
nodes = [\"root\", \"mid\", \"tip\"]
properties = \"strip\"
[[clamp]]
node = \"root\"
";

const MODES: &str = "
[modes]
speeds = [0, 300]
count = 4
";

/// Reads the cards after `units = "SI"` and the strip, with a file of measurements and a
/// broken file of properties in the folder.
fn input(cards: &str) -> Result<Input, String> {
    let files = [
        ("a.csv", "speed_rpm,frequency_hz,order\n0,1.4,1\n300,6,\n"),
        ("bad.csv", "speed_rpm,frequency_hz\n"),
        ("strip.properties.json", "{}"),
    ];
    read_beside(&format!("units = \"SI\"\n{STRIP}{cards}"), &files)
}

/// The problems reported for the cards.
#[track_caller]
fn refused(cards: &str) -> String {
    reported(input(cards))
}

/// Expects a part of the message when `old` in `cards` is replaced by `new`.
#[track_caller]
fn expect(cards: &str, old: &str, new: &str, expected: &str) {
    assert!(cards.contains(old), "\"{old}\" is not in {cards}");
    let shown = refused(&cards.replacen(old, new, 1));
    assert!(
        shown.contains(expected),
        "{old} -> {new}: expected\n{expected}\nin\n{shown}"
    );
}

#[test]
fn names_of_outputs_come_from_the_file() {
    assert_eq!(name_of(Path::new("x/strip.dynamics.toml")), "strip");
    assert_eq!(name_of(Path::new("strip.v2.toml")), "strip.v2");
    assert_eq!(name_of(Path::new("strip")), "strip");
}

// Mass: 2 kg/m on 10 m. Nodes: three beams make seven; names as documented.
#[test]
fn a_blade_becomes_nodes_beams_and_a_clamp() {
    let found =
        input(&format!("name = \"x\"\n{BLADE}{MODES}").replace("name = \"x\"\n", "")).unwrap();
    let summary = &found.summary;
    assert_eq!((summary.nodes, summary.beams, summary.clamps), (7, 3, 1));
    assert_relative_eq!(summary.mass, 20.0, max_relative = 1e-12);
    assert_eq!(
        summary.to_string(),
        "7 nodes, 3 beams, 1 clamp, mass 20 kg; 4 modes at 2 speeds, 0 to 300 rpm"
    );
    let case = found.modes.as_ref().unwrap();
    let model = &found.model;
    assert_eq!((model.name.as_str(), case.count), ("a", 4));
    assert_relative_eq!(
        case.speeds[1],
        10.0 * std::f64::consts::PI,
        max_relative = 1e-15
    );
    let labels: Vec<_> = model
        .system
        .nodes()
        .iter()
        .map(|node| node.label.as_str())
        .collect();
    assert_eq!(
        labels,
        ["b/root", "b/1", "b/2", "b/3", "b/4", "b/5", "b/tip"]
    );
    let tip = model.system.nodes()[6].position;
    let expected = Vector3::new(8.0 + 4.0 * 30_f64.to_radians().cos(), -2.0, 0.0);
    assert_relative_eq!(tip, expected, epsilon = 1e-14);
    assert_eq!(model.naming[3], NamingAxes::default());
}

// A model at rest without loads has no residual: kinks, twists and offsets
// belong to the undeformed state. Round-off of strains of 1e-16 times EA = 7e6.
#[test]
fn the_undeformed_state_is_free_of_internal_force() {
    let beam = BEAM.replace(
        "properties",
        "offsets = [[0, 0.1, 0], [0, 0.1, 0], [0, 0.1, 0.2]]\nproperties",
    );
    for cards in [BLADE, &beam] {
        let system = input(&format!("{cards}{MODES}")).unwrap().model.system;
        let residual = system.residual(&system.rest(), &Conditions::at_rest());
        let largest = residual.values.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        assert!(largest < 1e-7, "{largest}");
    }
}

// A blade at azimuth 90 degrees is the same blade turned about the axis: nodes and
// naming axes go from (x, y, z) to (-y, x, z).
#[test]
fn azimuth_turns_the_whole_blade() {
    let turned = BLADE.replace("root =", "azimuth = 90\nprecone = 10\nroot =");
    let straight = BLADE.replace("root =", "precone = 10\nroot =");
    let [turned, straight] =
        [turned, straight].map(|cards| input(&format!("{cards}{MODES}")).unwrap().model);
    let turn = |v: Vector3<f64>| Vector3::new(-v.y, v.x, v.z);
    let pairs = turned.system.nodes().iter().zip(straight.system.nodes());
    for (i, (a, b)) in pairs.enumerate() {
        assert_relative_eq!(a.position, turn(b.position), epsilon = 1e-14);
        for column in 0..3 {
            let axis = |model: &super::Model| model.naming[i].blade.column(column).into_owned();
            assert_relative_eq!(axis(&turned), turn(axis(&straight)), epsilon = 1e-15);
        }
    }
    // Precone lifts: the end of the first piece is 6 sin 10 degrees up.
    let z = straight.system.nodes()[4].position.z;
    assert_relative_eq!(z, 6.0 * 10_f64.to_radians().sin(), max_relative = 1e-14);
}

#[test]
fn explicit_beams_bodies_and_measurements_are_read() {
    let cards = format!(
        "{BEAM}inertia = 1\n{MODES}[measured]\nfile = \"a.csv\"\nleave_out = [\"lag\"]\n\
         [[body]]\nnode = \"tip\"\nmass = \"500 g\"\noffset = [0, 0, 0.1]\ninertia = [1, 1, 0]\n"
    );
    let found = input(&cards.replace("inertia = 1\n", "")).unwrap();
    assert_relative_eq!(found.summary.mass, 4.5, max_relative = 1e-12);
    assert_eq!(found.measured.leave_out, [ModeKind::Lag]);
    assert_eq!(found.measured.points.len(), 2);
    let shown = found.summary.to_string();
    assert!(
        shown.starts_with("3 nodes, 1 beam, 1 body, 1 clamp, mass 4.5 kg"),
        "{shown}"
    );
    assert!(shown.ends_with("; 2 measured points"), "{shown}");
}

// A beam along y at a hub about z: span along y, lag toward -x, flap up.
#[test]
fn explicit_beams_are_named_from_their_root() {
    let along_y = BEAM
        .replace("[1, 0, 0]", "[0, 1, 0]\norientation = [0, 0, 90]")
        .replace("[2, 0, 0]", "[0, 2, 0]\norientation = [0, 0, 90]")
        .replace("[0, 0, 0]", "[0, 0, 0]\norientation = [0, 0, 90]");
    let naming = input(&format!("{along_y}{MODES}")).unwrap().model.naming;
    for axes in naming {
        assert_relative_eq!(
            axes.blade.column(0).into_owned(),
            Vector3::y(),
            epsilon = 1e-15
        );
        assert_relative_eq!(
            axes.blade.column(1).into_owned(),
            -Vector3::x(),
            epsilon = 1e-15
        );
        assert_relative_eq!(axes.section, axes.blade, epsilon = 1e-15);
    }
}

#[test]
fn names_that_nothing_has_are_reported_with_the_nearest() {
    let cards = format!("{BEAM}{MODES}");
    let node =
        "a.dynamics.toml:25: unknown node \"mdi\" in beam \"inner\"\n  help: did you mean \"mid\"?";
    expect(&cards, "\"mid\", \"tip\"]", "\"mdi\", \"tip\"]", node);
    let strip = "unknown properties \"stripe\" in beam \"inner\"\n  help: did you mean \"strip\"?";
    expect(&cards, "\"strip\"", "\"stripe\"", strip);
    expect(
        &cards,
        "node = \"root\"",
        "node = \"rot\"",
        "unknown node \"rot\" in clamp 1",
    );
    let blade = format!("{BLADE}{MODES}[[clamp]]\nnode = \"b/9\"\n");
    let known = "help: node: \"b/0\", \"b/1\", \"b/2\", \"b/3\", \"b/4\", \"b/5\", \"b/6\"";
    assert!(refused(&blade).contains("unknown node \"b/9\" in clamp 1"));
    assert!(
        !refused(&blade).contains(known),
        "near names are suggested instead"
    );
}

#[test]
fn broken_cards_do_not_make_their_names_unknown() {
    let cards = format!("{BEAM}{MODES}").replace("position = [1, 0, 0]", "position = [1, 0]");
    let shown = refused(&cards);
    assert_eq!(shown.matches("error:").count(), 1, "{shown}");
    let cards =
        format!("{BLADE}{MODES}[[clamp]]\nnode = \"b/tip\"\n").replace("length = 4", "length = 0");
    let shown = refused(&cards);
    assert_eq!(shown.matches("error:").count(), 1, "{shown}");
}

/// Strips that cannot be read are no reason to refuse columns of strips and of rotors in the air.
#[test]
fn a_broken_air_brings_no_errors_of_columns() {
    let hover = include_str!("../../../cases/dynamics/hover_rotor/hover_rotor.dynamics.toml");
    let columns = "[[output.column]]\nname = \"a\"\nquantity = \"angle_of_attack\"\n\
                   of = \"blade 1\"\nat = 0.7\n[[output.column]]\nname = \"T\"\n\
                   quantity = \"thrust\"\n";
    for (from, to) in [
        ("density = 1.225", "density = -1"),
        ("at = 0.5, chord = 0.4", "at = 0.5, chord = -4"),
        ("inflow = \"rotor\"", "inflow = \"motor\""),
        ("[[inflow]]", "[[inflow]]\nkind = \"moment\""),
        ("\nproperties = \"blade\"", "\nproperties = \"blad\""),
    ] {
        assert!(hover.contains(from));
        let text = format!("{hover}{columns}").replace(from, to);
        let shown = reported(read_beside(&text, &[]));
        assert_eq!(shown.matches("error:").count(), 1, "{to}: {shown}");
    }
    let text = format!("{hover}{columns}").replace("at = 0.7", "at = 0.01");
    assert!(reported(read_beside(&text, &[])).contains("0.01"));
}

// Meters, feet, and others that are no unit of the file.
#[test]
fn gravity_in_another_unit_is_remarked() {
    for (size, is_remarked) in [
        ("9.81", false),
        ("1.62", false),
        ("32.174", false),
        ("9810", true),
        ("386.09", true),
        ("0.00981", true),
    ] {
        let cards = format!("{BLADE}{MODES}[gravity]\nacceleration = [0, 0, -{size}]\n");
        let remarks = input(&cards).unwrap().remarks;
        let found = remarks
            .iter()
            .any(|remark| remark.starts_with("[gravity] is "));
        assert_eq!(found, is_remarked, "{remarks:?}");
    }
}

#[test]
fn an_expression_without_its_sign_is_no_name() {
    let load = "[[load]]\nnode = \"b/tip\"\nforce = [1, 0, 0]\ndrive = \"sin(t)\"\n";
    let shown = refused(&format!("{BLADE}{MODES}{load}"));
    let expected = "help: an expression begins with =, as in \"= sin(t)\"";
    assert!(shown.ends_with(expected), "{shown}");
}

#[test]
fn doubled_names_are_reported_with_the_first_line() {
    let cards = format!("{BEAM}{MODES}");
    let doubled = "node \"root\" is already defined on line 15, expected one of this name";
    expect(&cards, "name = \"mid\"", "name = \"root\"", doubled);
    let second = format!("{BEAM}[[clamp]]\nnode = \"root\"\n{MODES}");
    assert!(refused(&second).contains("node \"root\" is held on line 28 already"));
    let blades = format!("{BLADE}{BLADE}{MODES}");
    let shown = refused(&blades);
    assert_eq!(shown.matches("error:").count(), 1, "{shown}");
    assert!(
        shown.contains("blade \"b\" is already defined on line 15"),
        "{shown}"
    );
}

#[test]
fn impossible_beams_are_explained() {
    let cards = format!("{BEAM}{MODES}");
    let tip = "position = [2, 0, 0]";
    expect(
        &cards,
        tip,
        "position = [0, 0, 0]",
        "\"root\" and \"tip\" are at the same position",
    );
    expect(
        &cards,
        tip,
        "position = [0.5, 0, 0]",
        "\"mid\" is not between \"root\" and \"tip\"",
    );
    expect(
        &cards,
        tip,
        "position = [2.3, 0, 0]",
        "\"mid\" is at 43.5 % of the way",
    );
    expect(
        &cards,
        tip,
        "position = [0, 2, 0]",
        "\"mid\" is at 0.0 % of the way",
    );
    let across = "the section axis x at \"tip\" is 60.0 deg off the line of the beam";
    expect(
        &cards,
        tip,
        &format!("{tip}\norientation = [0, 60, 0]"),
        across,
    );
    let wrung = "turns by 100.0 deg between \"tip\" and the middle, expected less than 90 deg";
    expect(
        &cards,
        tip,
        &format!("{tip}\norientation = [100, 0, 0]"),
        wrung,
    );
}

#[test]
fn beams_need_three_nodes_in_order() {
    let cards = format!("{BEAM}{MODES}");
    let nodes = "[\"root\", \"mid\", \"tip\"]";
    let reversed = "is 180.0 deg off the line of the beam, expected at most 45 deg";
    expect(&cards, nodes, "[\"tip\", \"mid\", \"root\"]", reversed);
    expect(
        &cards,
        nodes,
        "[\"root\", \"mid\"]",
        "\"nodes\" lists 2, expected three",
    );
    expect(
        &cards,
        nodes,
        "[\"root\", \"mid\", \"mid\"]",
        "has node \"mid\" twice",
    );
    expect(
        &cards,
        nodes,
        "\"root\"",
        "\"nodes\" lists 1, expected three",
    );
    expect(
        &cards,
        nodes,
        "[\"root\", 3, \"tip\"]",
        "\"nodes\" is 3, expected a text in quotes",
    );
    // For a beam without valid nodes no node is reported as unused.
    for wrong in ["[\"root\", \"mid\"]", "[\"root\", \"root\", \"tip\"]"] {
        let shown = refused(&cards.replacen(nodes, wrong, 1));
        assert!(!shown.contains("nothing is attached"), "{shown}");
    }
    let multiline = "[\"root\", \"\"\"mid\"\"\", 'tip'] # \"nodes\"";
    let found = input(&cards.replacen(nodes, multiline, 1)).unwrap();
    assert_eq!(found.model.system.nodes().len(), 3);
}

#[test]
fn impossible_blades_are_explained() {
    let cards = format!("{BLADE}{MODES}");
    expect(
        &cards,
        "length = 6",
        "length = -6",
        "\"length\" is -6, expected a length greater than zero",
    );
    expect(
        &cards,
        "elements = 2",
        "elements = 0",
        "\"elements\" is 0, expected a whole number",
    );
    expect(
        &cards,
        "elements = 2",
        "elements = 100000",
        "is 100000, expected at most 1000",
    );
    expect(
        &cards,
        "sweep = 30",
        "sweep = 95",
        "\"sweep\" is 95 deg, expected less than 90 deg",
    );
    expect(
        &cards,
        "twist = [5, 25]",
        "twist = [1, 2, 3]",
        "\"twist\" is an array of 3, expected one angle",
    );
    expect(
        &cards,
        "twist = [5, 25]",
        "twist = [0, 300]",
        "blade \"b\", piece 2: the section turns by 150.0 deg",
    );
    expect(
        &cards,
        "properties = \"strip\"\n[[",
        "[[",
        "blade \"b\", piece 1 has no \"properties\"",
    );
    let along = format!("{cards}[hub]\naxis = [2, 0, 0]\n");
    assert!(refused(&along).contains("the axis of the hub points along x"));
    let taken = format!("{cards}[[node]]\nname = \"b/2\"\nposition = [0, 0, 0]\n");
    let shown = refused(&taken);
    assert_eq!(shown.matches("error:").count(), 1, "{shown}");
    assert!(shown.contains("node \"b/2\" is already defined"), "{shown}");
    let empty = format!("[[blade]]\nname = \"b\"\nproperties = \"strip\"\n{MODES}");
    assert!(
        refused(&empty).contains("blade \"b\" has no [[blade.piece]]"),
        "{}",
        refused(&empty)
    );
}

#[test]
fn a_list_of_no_blades_is_an_empty_model() {
    let shown = reported(read_beside(
        &format!("blade = []\nunits = \"SI\"\n{MODES}"),
        &[],
    ));
    assert!(shown.contains("the model is empty"), "{shown}");
    assert_eq!(shown.lines().count(), 1, "{shown}");
}

#[test]
fn the_model_as_a_whole_is_checked() {
    assert!(
        refused(MODES).contains(
            "the model is empty, expected [[blade]], or [[node]] with [[beam]] or [[body]]"
        )
    );
    let free = "[[node]]\nname = \"n\"\nposition = [0, 0, 0]\n[[body]]\nnode = \"n\"\nmass = 1\n\
                inertia = [1, 1, 1]\n";
    let shown = refused(&format!("{MODES}{free}"));
    assert!(shown.contains("nothing holds the bodies"), "{shown}");
    let massless = format!(
        "{BLADE}{MODES}[properties.light]\nea = 1\ngay = 1\ngaz = 1\ngj = 1\n\
        eiy = 1\neiz = 1\nm = 0\niy = 0\niz = 0\n"
    );
    let no_mass = "the model has no mass that can move";
    expect(&massless, "\"strip\"", "\"light\"", no_mass);
    let held = format!("{massless}[[body]]\nnode = \"b/root\"\nmass = 1\n");
    expect(&held, "\"strip\"", "\"light\"", no_mass);
    let single = BLADE.replace("[[blade]]", "[blade]");
    let shown = refused(&format!("{single}{MODES}"));
    assert!(shown.contains("expected tables [[blade]]"), "{shown}");
    assert_eq!(shown.lines().count(), 1, "{shown}");
    let lonely = format!("{BEAM}{MODES}[[node]]\nname = \"far\"\nposition = [9, 0, 0]\n");
    let shown = refused(&lonely);
    assert!(
        shown.contains("a.dynamics.toml:34: nothing is attached to node \"far\""),
        "{shown}"
    );
    // A model without an analysis is valid; a misspelled analysis is not.
    assert!(input(BEAM).unwrap().modes.is_none());
    let shown = refused(&format!("{BEAM}{MODES}").replace("[modes]", "[mode]"));
    assert!(shown.contains("unknown key \"mode\""), "{shown}");
}

#[test]
fn free_mechanisms_name_node_and_direction() {
    let shown = refused(&format!("{BEAM}{MODES}").replace("[[clamp]]\nnode = \"root\"\n", ""));
    assert!(shown.contains(": free mechanism: node"), "{shown}");
    assert!(shown.contains("rotation about z"), "{shown}");
    let free = format!("{BLADE}{MODES}").replace("root = [2", "clamp_root = false\nroot = [2");
    assert!(refused(&free).contains("free mechanism"));
}

// Free modes accept the models of runs in time; equilibria under loads do not.
#[test]
fn free_models_have_modes_on_request() {
    let held = format!("{BEAM}{MODES}").replace("[0, 300]", "0");
    let free = held.replace("[[clamp]]\nnode = \"root\"\n", "");
    assert!(refused(&free).contains("free mechanism"));
    let remarks = |text: &str| {
        let input = input(&format!("{text}free = true\n"));
        input
            .unwrap_or_else(|problems| panic!("{problems}"))
            .remarks
            .join("\n")
    };
    let found = remarks(&free);
    assert!(
        found.contains("rotation about z: each a mode of frequency zero"),
        "{found}"
    );
    let found = remarks(&held);
    assert!(
        found.contains("\"free\" of [modes] has no effect: all parts are held"),
        "{found}"
    );
    let under_loads = format!("{free}free = true\n[static]\n");
    assert!(refused(&under_loads).contains("free mechanism"));
    let loose = "[[node]]\nname = \"loose\"\nposition = [0, 9, 0]\n[[spring]]\nname = \"s\"\n\
                 nodes = [\"tip\", \"loose\"]\nstiffness = [1e3, 1e3, 1e3]\n";
    let massless = free.replace("[modes]", &format!("{loose}[modes]")) + "free = true\n";
    let shown = refused(&massless);
    let expected = "node \"loose\" has no inertia, and nothing holds it";
    assert!(shown.contains(expected), "{shown}");
    let turning = free.replace("speeds = 0", "speeds = [0, 60]") + "free = true\n";
    let shown = refused(&turning);
    assert!(
        shown.contains("\"free\" is true at the rotor speed 60 rpm"),
        "{shown}"
    );
}

#[test]
fn files_beside_the_input_are_checked() {
    let cards = format!("{BLADE}{MODES}[properties.filed]\nfile = \"strip.property.json\"\n");
    let missing = "a.dynamics.toml:31: properties \"filed\": no property file at \"strip.property.json\"\n  \
        help: did you mean \"strip.properties.json\"?";
    assert!(refused(&cards).contains(missing), "{}", refused(&cards));
    let malformed = "error: strip.properties.json:1: not a property file";
    expect(
        &cards,
        "strip.property.json",
        "strip.properties.json",
        malformed,
    );
    let both =
        "properties \"filed\" has \"file\" and \"ea\", expected a file or numbers in the card";
    expect(
        &cards,
        "[properties.filed]",
        "[properties.filed]\nea = 1",
        both,
    );

    let cards = format!("{BLADE}{MODES}[measured]\nfile = \"a.csv\"\n");
    expect(
        &cards,
        "a.csv",
        "b.csv",
        "no table of measurements at \"b.csv\": no such file",
    );
    expect(
        &cards,
        "a.csv",
        "bad.csv",
        "bad.csv:1: the columns are \"speed_rpm,frequency_hz\"",
    );
    let kind = "leave_out = [\"lagg\"]";
    expect(
        &cards,
        "[measured]",
        &format!("[measured]\n{kind}"),
        "did you mean \"lag\"?",
    );
}

#[test]
fn bodies_have_possible_inertias() {
    let cards = format!("{BEAM}{MODES}[[body]]\nnode = \"tip\"\nmass = 1\ninertia = [1, 1, 3]\n");
    let shown = refused(&cards);
    assert!(shown.contains("body \"body 1\" has the inertia [1.0, 1.0, 3.0] kg m^2"));
    assert!(
        shown.contains("help: the moments are about the center"),
        "{shown}"
    );
    // The remedy of a moment about the shaft alone is a sound body.
    let about_the_shaft = cards.replace("[1, 1, 3]", "[0, 0, 3.257e5]");
    assert!(refused(&about_the_shaft).contains("write [J / 2, J / 2, J]"));
    input(&cards.replace("[1, 1, 3]", "[1.6285e5, 1.6285e5, 3.257e5]")).unwrap();
    expect(
        &cards,
        "mass = 1",
        "mass = 0",
        "\"mass\" is 0, expected a mass greater than zero",
    );
    expect(&cards, "mass = 1", "offset = 3", "expected an array of 3");
}

#[test]
fn unknown_keys_and_wrong_units_are_reported_together() {
    let cards = format!("{BLADE}{MODES}")
        .replace("sweep =", "swep =")
        .replace("length = 4", "length = \"4 kg\"")
        .replace("count = 4", "count = 4\nspeed = 3");
    let shown = refused(&cards);
    for expected in [
        "unknown key \"swep\"",
        "did you mean \"sweep\"?",
        "\"kg\" measures a mass, expected a length",
        "unknown key \"speed\" in [modes]",
    ] {
        assert!(shown.contains(expected), "{expected} is not in\n{shown}");
    }
    assert_eq!(shown.matches("error:").count(), 3, "{shown}");
}
