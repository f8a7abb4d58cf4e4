//! `static` and `buckling`, and what can be wrong with loads.

use super::{BLADE, Folder};

/// Half of a flat arch of two bars on pins; its limit load is 24.8 N.
const ARCH: &str = "\
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

#[test]
fn a_limit_point_ends_statics_with_what_was_reached() {
    let folder = Folder::new();
    folder.write("a.dynamics.toml", &format!("{ARCH}[static]\n"));
    let run = folder.run(&["static", "a.dynamics.toml"]);
    assert_eq!(run.code, 1, "{}", run.err);
    let told = "error: a: limit point near the load factor ";
    assert!(run.err.starts_with(told), "{}", run.err);
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
fn critical_loads_are_told_and_written() {
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
fn a_file_without_the_question_is_refused() {
    let folder = Folder::new();
    folder.write("a.dynamics.toml", BLADE);
    for (command, table) in [("static", "[static]"), ("buckling", "[buckling]")] {
        let run = folder.run(&[command, "a.dynamics.toml"]);
        assert_eq!(run.code, 2);
        let told = format!("error: a.dynamics.toml: has no {table}, which says what is asked");
        assert!(run.err.starts_with(&told), "{}", run.err);
    }
}

#[test]
fn buckling_without_loads_ends_with_the_reason() {
    let folder = Folder::new();
    folder.write("a.dynamics.toml", &format!("{BLADE}[buckling]\n"));
    let run = folder.run(&["buckling", "a.dynamics.toml"]);
    assert_eq!(run.code, 1);
    let told = "error: a: no load grows with the load factor";
    assert!(run.err.starts_with(told), "{}", run.err);
}

#[test]
fn wrong_loads_are_told_where_they_stand() {
    let folder = Folder::new();
    for (card, message) in [
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
            "the load has neither \"blade\" nor \"beams\", expected one of them",
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
            "\"at\" falls from 0.5 m to 0.2 m, expected ascending arc lengths",
        ),
        (
            "[[distributed_load]]\nblade = \"blade\"\nat = [0, 0.5]\nforce = [0, 0, 1]\n",
            "\"force\" has 1 rows, expected 2: one for each place of \"at\"",
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
            "\"speed\" has the speed -1 rpm, expected zero or more",
        ),
    ] {
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
        already, expected one card a node\n  help: put all components of the motion into one \
        [[imposed]]";
    folder.refuses(&format!("{BLADE}{}{}", card("x"), card("z")), message);
}
