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
