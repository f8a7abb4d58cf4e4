//! `static` and `buckling`, and problems of loads.

use super::{BLADE, Folder};

/// Half of a flat arch of two bars on pins; its limit load is 24.8 N.
pub const ARCH: &str = "\
units = \"SI\"
[properties.bar]
ea = 1e4
gay = 1e6
gaz = 1e6
gj = 1e3
eiy = 1e3
eiz = 1e3
m = 1
iy = 1e-3
iz = 1e-3
[[node]]
name = \"foot\"
position = [0, 0, 0]
orientation = [0, -11.30993247402, 0]
[[node]]
name = \"middle\"
position = [0.5, 0, 0.1]
orientation = [0, -11.30993247402, 0]
[[node]]
name = \"apex\"
position = [1, 0, 0.2]
orientation = [0, -11.30993247402, 0]
[[beam]]
nodes = [\"foot\", \"middle\", \"apex\"]
properties = \"bar\"
[[imposed]]
node = \"foot\"
displacement = [0, 0, 0]
rotation = { x = 0, z = 0 }
[[imposed]]
node = \"apex\"
displacement = { x = 0, y = 0 }
rotation = { x = 0, z = 0 }
[[load]]
node = \"apex\"
force = [0, 0, -40]
";

/// A straight strip along x.
pub const STRIP: &str = "\
units = \"SI\"
[properties.strip]
ea = 3e6
gay = 9.5e5
gaz = 9.5e5
gj = 2.8
eiy = 0.64
eiz = 160
m = 0.11
iy = 2.4e-8
iz = 5.9e-6
[[blade]]
name = \"blade\"
root = [0.06, 0, 0]
properties = \"strip\"
[[blade.piece]]
length = 0.95
elements = 6
";

#[test]
fn a_limit_point_ends_statics_with_what_was_reached() {
    let folder = Folder::new();
    folder.write("a.dynamics.toml", &format!("{ARCH}[static]\n"));
    let run = folder.run(&["static", "a.dynamics.toml"]);
    assert_eq!(run.code, 1, "{}", run.err);
    let reported = "error: a: limit point near the load factor ";
    assert!(run.err.starts_with(reported), "{}", run.err);
    for part in ["worst equation there: ", "arc_length = true", "are written"] {
        assert!(run.err.contains(part), "{part}: {}", run.err);
    }
    assert!(folder.path("results/a.displacements.csv").is_file());
    assert!(
        run.out.contains("stopped early: limit point"),
        "{}",
        run.out
    );

    let text = format!("{ARCH}[static]\narc_length = true\n");
    folder.write("a.dynamics.toml", &text);
    let run = folder.run(&["static", "a.dynamics.toml"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let passed = "a limit point was passed near the load factor";
    assert_eq!(run.out.matches(passed).count(), 2, "{}", run.out);
}

#[test]
fn critical_loads_are_reported_and_written() {
    let folder = Folder::new();
    folder.write("a.dynamics.toml", &format!("{ARCH}[buckling]\ncount = 2\n"));
    let run = folder.run(&["buckling", "a.dynamics.toml"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert!(run.out.contains("Critical loads"), "{}", run.out);
    let written = run.out.split("\nWritten\n").nth(1).unwrap();
    assert!(written.lines().count() >= 2, "{written}");
    for file in written.lines() {
        assert!(folder.path(file.trim()).is_file(), "{file}");
    }
}

#[test]
fn a_file_without_the_settings_is_refused() {
    let folder = Folder::new();
    folder.write("a.dynamics.toml", BLADE);
    for (command, table) in [("static", "[static]"), ("buckling", "[buckling]")] {
        let run = folder.run(&[command, "a.dynamics.toml"]);
        assert_eq!(run.code, 2);
        let reported = format!("error: a.dynamics.toml: has no {table} that defines the analysis");
        assert!(run.err.starts_with(&reported), "{}", run.err);
    }
}

#[test]
fn buckling_without_loads_ends_with_the_reason() {
    let folder = Folder::new();
    folder.write("a.dynamics.toml", &format!("{BLADE}[buckling]\n"));
    let run = folder.run(&["buckling", "a.dynamics.toml"]);
    assert_eq!(run.code, 1);
    let reported = "error: a: no load grows with the load factor";
    assert!(run.err.starts_with(reported), "{}", run.err);
}

// A column of EI = 0.64 and 160 N m^2, clamped, 0.95 m: buckles under
// pi^2 EI / (4 L^2) = 1.74976 N.
#[test]
fn buckling_beyond_the_critical_load_is_remarked() {
    let folder = Folder::new();
    let load = |force: f64, keys: &str| {
        format!("[[load]]\nnode = \"blade/tip\"\nforce = [{force:e}, 0, 0]\n{keys}")
    };
    for (constant, is_reported) in [(-1.7, false), (-3.5, true)] {
        let loads = load(constant, "constant = true\n") + &load(-1.0, "");
        folder.write("a.dynamics.toml", &format!("{STRIP}{loads}[buckling]\n"));
        let run = folder.run(&["buckling", "a.dynamics.toml"]);
        assert_eq!(run.code, 0, "{}", run.err);
        let reported = run.out.contains("under about 0.4999 of the constant loads");
        assert_eq!(reported, is_reported, "{}", run.out);
    }
    // Absurd loads give a small factor; numbers above 1e100 are no data.
    for (force, code) in [(-1e99, 0), (-1e300, 2)] {
        let cards = format!("{STRIP}{}[buckling]\n", load(force, ""));
        folder.write("a.dynamics.toml", &cards);
        let run = folder.run(&["buckling", "a.dynamics.toml"]);
        assert_eq!(run.code, code, "{}{}", run.out, run.err);
        assert!(!run.out.contains("NaN"), "{}", run.out);
    }
}

// The critical load of the strip again: the straight path continues past it. A load across
// the strip has no critical point, however far it bends.
#[test]
fn statics_reports_where_another_path_branches_off() {
    let folder = Folder::new();
    let reported = "a critical point was passed near the load factor 0.";
    for (force, is_reported) in [
        ("-3.5, 0, 0", true),
        ("-1.7, 0, 0", false),
        ("0, 0, 9", false),
    ] {
        let load = format!("[[load]]\nnode = \"blade/tip\"\nforce = [{force}]\n");
        folder.write("a.dynamics.toml", &format!("{STRIP}{load}[static]\n"));
        let run = folder.run(&["static", "a.dynamics.toml"]);
        assert_eq!(run.code, 0, "{}", run.err);
        assert_eq!(run.out.contains(reported), is_reported, "{}", run.out);
        assert_eq!(
            run.out.contains(&format!("{reported}4999")),
            is_reported,
            "{}",
            run.out
        );
    }
}

// Only the spring acts on the blade; it turns the blade up until it is relaxed.
#[test]
fn a_hinge_goes_where_its_spring_is_relaxed() {
    let folder = Folder::new();
    let card = "name = \"blade\"\nhinges = [{ kind = \"flap\", stiffness = 5, angle = 30 }]";
    let blade = STRIP.replace("name = \"blade\"", card);
    folder.write("a.dynamics.toml", &format!("{blade}[static]\n"));
    let run = folder.run(&["static", "a.dynamics.toml"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let tip = run
        .out
        .lines()
        .find(|line| line.starts_with("blade/tip"))
        .unwrap();
    let words: Vec<_> = tip.split_whitespace().collect();
    let values: Vec<f64> = words[1..]
        .iter()
        .map(|word| word.parse().unwrap())
        .collect();
    let expected = [0.95 * (0.75_f64.sqrt() - 1.0), 0.0, 0.475, 0.0, -30.0, 0.0];
    for (found, expected) in values.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-4, "{tip}");
    }
    let card = card.replace("30", "340");
    let blade = STRIP.replace("name = \"blade\"", &card);
    folder.write("a.dynamics.toml", &format!("{blade}[static]\n"));
    let run = folder.run(&["static", "a.dynamics.toml"]);
    assert_eq!(run.code, 2, "{}", run.out);
    assert!(
        run.err.contains("is 340 deg, expected at most 330 deg"),
        "{}",
        run.err
    );
}

/// Wrong cards, and the expected problems.
const WRONG_LOADS: &[(&str, &str)] = &[
    (
        "[[load]]\nnode = \"blade/top\"\nforce = [0, 0, 1]\n",
        "unknown node \"blade/top\" in \"load 1\"",
    ),
    (
        "[[load]]\nnode = \"blade/tip\"\n",
        "the load has neither \"force\" nor \"moment\", expected one of them or both",
    ),
    (
        "[[distributed_load]]\nforce = [0, 0, 1]\n",
        "the card has neither \"blade\" nor \"beams\", expected one of them",
    ),
    (
        "[[distributed_load]]\nblade = \"blad\"\nforce = [0, 0, 1]\n",
        "unknown blade \"blad\" in \"distributed load 1\"",
    ),
    (
        "[[distributed_load]]\nblade = \"blade\"\nat = [0, 2]\nforce = [[0, 0, 1], [0, 0, 2]]\n",
        "\"at\" has 2 m, expected 0 to 0.95 m, the length of the line",
    ),
    (
        "[[distributed_load]]\nblade = \"blade\"\nat = [0, 0.5, 0.2]\nforce = [0, 0, 1]\n",
        "\"at\" decreases from 0.5 m to 0.2 m, expected increasing arc lengths",
    ),
    (
        "[[distributed_load]]\nblade = \"blade\"\nat = [0.5, 0.5]\nforce = [[0, 0, 1], [0, 0, 1]]\n",
        "\"at\" has only the position 0.5 m, expected an interval",
    ),
    (
        "[[distributed_load]]\nbeams = []\nforce = [0, 0, 1]\n",
        "\"beams\" is empty, expected the names of beams",
    ),
    (
        "[[distributed_load]]\nblade = \"blade\"\nat = [0, 0.5]\nforce = [0, 0, 1]\n",
        "\"force\" has 1 rows, expected 2: one for each position of \"at\"",
    ),
    (
        "[[imposed]]\nnode = \"blade/root\"\ndisplacement = { x = 0 }\n",
        "node \"blade/root\" is clamped, expected a node that can be moved",
    ),
    (
        "[[imposed]]\nnode = \"blade/tip\"\n",
        "nothing is imposed, expected \"displacement\", \"rotation\" or both",
    ),
    (
        "[gravity]\nacceleration = [0, 3, -4]\n",
        "gravity has 3 m/s^2 across the axis of rotation, and the model turns at 750 rpm",
    ),
    (
        "[static]\nspeed = -1\n",
        "\"speed\" is -1, expected a rotation speed, zero or more",
    ),
];

#[test]
fn wrong_loads_are_reported_where_they_are() {
    let folder = Folder::new();
    for (card, message) in WRONG_LOADS {
        folder.write("a.dynamics.toml", &format!("{BLADE}{card}"));
        let run = folder.run(&["check", "a.dynamics.toml"]);
        assert_eq!(run.code, 2, "{card}");
        assert!(run.err.contains(message), "{card}: {}", run.err);
        assert!(
            run.err.starts_with("error: a.dynamics.toml:"),
            "{}",
            run.err
        );
    }
}

/// Resultants by hand, with L = 0.95 m: a polynomial L (0.1 + 0.2 / 2), a table with a jump
/// 0.2 (0.1 + 0.3), in section axes whose z is the model's; a force 0.01. The root carries
/// their sum to the last digits, however far the blade bends.
#[test]
fn the_root_carries_the_sum_of_the_loads() {
    let folder = Folder::new();
    let loads = "\
[[distributed_load]]
blade = \"blade\"
force = [[0, 0, 0.1], [0, 0, 0.2]]
[[distributed_load]]
name = \"patch\"
blade = \"blade\"
axes = \"section\"
at = [0.1, 0.3, 0.3, 0.5]
force = [[0, 0, 0.1], [0, 0, 0.1], [0, 0, 0.3], [0, 0, 0.3]]
constant = true
[[load]]
node = \"blade/tip\"
force = [0, 0, 0.01]
[static]
steps = 2
";
    folder.write("a.dynamics.toml", &format!("{BLADE}{loads}"));
    let run = folder.run(&["static", "a.dynamics.toml"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let table = folder.read("results/a.reactions.csv");
    let sums = [0.08, 0.08 + 0.5 * 0.2, 0.08 + 0.2];
    assert_eq!(table.lines().count(), 1 + sums.len(), "{table}");
    for (line, sum) in table.lines().skip(1).zip(sums) {
        let cells: Vec<_> = line.split(',').collect();
        let force: f64 = cells[6].parse().unwrap();
        assert!((force + sum).abs() < 1e-8, "{line}");
    }
}

#[test]
fn a_node_is_moved_by_one_card() {
    let folder = Folder::new();
    let card = |axis: &str| {
        format!("[[imposed]]\nnode = \"blade/tip\"\ndisplacement = {{ {axis} = 0 }}\n")
    };
    let message = "error: a.dynamics.toml:22: node \"blade/tip\" has an imposed motion on line 18 \
        already, expected one card per node\n  help: put all components of the motion into one \
        [[imposed]]";
    folder.refuses(&format!("{BLADE}{}{}", card("x"), card("z")), message);
}
