//! Remedies of mistakes that are easily made.

use super::Folder;
use super::messages::SWEPT;

#[test]
fn remedies_name_the_right_form() {
    let folder = Folder::new();
    for (old, new, expected) in [
        (
            "acceleration = [0, 0, -9.81]",
            "acceleration = 9.81",
            "\"acceleration\" is 9.81, expected an array of 3, each an acceleration, as in [0, 0, -9.81]",
        ),
        (
            "[gravity]",
            "[[clamp]]\nnode = \"b/root\"\n[gravity]",
            "expected one [[clamp]] or root of a blade\n  help: remove one of the two cards",
        ),
        (
            "[gravity]",
            "[parameters]\na = \"= b\"\nb = \"= a\"\nc = \"= xyz\"\n[gravity]",
            "a -> b -> a\n  help: give one of them a number, for example \"a\"\n",
        ),
        (
            "[gravity]",
            "[modes]\nspeeds = \"0-8\"\n[gravity]",
            "\"speeds\" is \"0-8\", expected a list of rotation speeds, or a table\n  help: write speeds = \
             { from = 0, to = 8, steps = 5 }\n",
        ),
        (
            "units = \"SI\"",
            "units = \"SI\"\nrotation_speed = 300",
            "unknown key \"rotation_speed\" in the file\n  help: did you mean \"speeds\" in [modes], or",
        ),
        (
            "gay = 1e5",
            "gay = \"100,000 N\"",
            "  help: write \"100000 N\", or with a decimal point \"100.000 N\"\n",
        ),
    ] {
        let changed = SWEPT.replacen(old, new, 1);
        assert_ne!(changed, SWEPT);
        folder.write("a.dynamics.toml", &changed);
        let run = folder.run(&["check", "a.dynamics.toml"]);
        assert_eq!(run.code, 2, "{}", run.err);
        assert!(
            run.err.contains(expected),
            "{expected} is not in\n{}",
            run.err
        );
    }
}

/// A turbine file of windIO has more than a blade.
#[test]
fn conversions_to_windio_name_what_the_schema_also_requires() {
    let folder = Folder::new();
    let blade = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../cases/dynamics/nrel5mw/nrel5mw.blade.toml"
    );
    let run = folder.run(&["convert", blade, "a.yaml"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let remark = "  a blade only: the schema of windIO also requires assembly, airfoils, ";
    assert!(run.out.contains(remark), "{}", run.out);
}

/// A rotor with a steady wake in a wind that rises, until an annulus loses its state as its section stalls.
const STALLED: &str = "\
units = \"SI\"
[hub]
support = { torsion = 0 }
[[joint]]
name = \"shaft\"
kind = \"spin\"
nodes = [\"hub\"]
axis = [0, 0, 1]
speed = \"60 rpm\"
[properties.p]
ea = 7e8
gay = 9e7
gaz = 9e7
gj = 2e5
eiy = 4e5
eiz = 2e6
m = 8
iy = 0.02
iz = 0.1
[air]
density = 1.225
[air.wind]
speed = \"= 8 + 8*t\"
direction = [0, 0, 1]
up = [1, 0, 0]
[[inflow]]
name = \"rotor\"
[[blade]]
name = \"b\"
count = 3
hub_radius = 1
properties = \"p\"
piece = [{ length = 4, elements = 4 }]
[blade.aerodynamics]
inflow = \"rotor\"
section = \"quasi_steady\"
strips = 2
stations = [
  { at = 0, chord = 0.5, twist = -18, airfoil = \"naca0012\" },
  { at = 1, chord = 0.45, twist = -10, airfoil = \"naca0012\" },
  { at = 4, chord = 0.3, twist = -2, airfoil = \"naca0012\" },
]
[transient]
speed = \"60 rpm\"
start = \"rotating\"
to = 0.2
step = 0.005
";

/// The run ends, names stall, and keeps its output; each remedy that it names lets it pass.
#[test]
fn stall_of_an_annulus_in_time_is_named_with_its_remedies() {
    let folder = Folder::new();
    let run = |text: &str| {
        folder.write("a.dynamics.toml", text);
        folder.run(&["transient", "a.dynamics.toml", "--no-figures"])
    };
    let stalled = run(STALLED);
    assert_eq!(stalled.code, 1, "{}", stalled.err);
    for words in [
        "likely cause: the induced velocity at \"b ",
        "has no value near the last one: where a section stalls",
        "wake = \"dynamic\"",
        "\"separation_lag\" or \"oye\"",
    ] {
        assert!(stalled.err.contains(words), "{words}: {}", stalled.err);
    }
    assert!(folder.read("results/a.transient.csv").lines().count() > 5);
    let (cards, _) = STALLED.split_once("[transient]").unwrap();
    let period = "[periodic]\nspeed = \"60 rpm\"\nsteps = 200\nstages = \"two\"\n";
    let cards = cards.replace("8 + 8*t", "20 - 12*cos(2*pi*t)");
    folder.write("a.dynamics.toml", &format!("{cards}{period}"));
    let stalled = folder.run(&["periodic", "a.dynamics.toml", "--no-figures"]);
    assert_eq!(stalled.code, 1, "{}", stalled.err);
    let remedy = "help: give the inflow wake = \"dynamic\", whose velocities cannot jump";
    assert!(stalled.err.contains(remedy), "{}", stalled.err);
    let section = |word: &str| STALLED.replace("quasi_steady", word);
    for text in [
        STALLED.replace("[[inflow]]", "[[inflow]]\nwake = \"dynamic\""),
        section("separation_lag"),
        section("oye"),
    ] {
        let run = run(&text);
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{}", run.out);
    }
}
