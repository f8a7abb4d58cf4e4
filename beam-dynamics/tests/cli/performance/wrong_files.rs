//! Rotor files that are wrong.

use super::{ROTOR, SWEEP};
use crate::Folder;

/// Expects each text to be refused with a message that contains the text after it.
fn refused(cases: &[(String, &str)]) {
    let folder = Folder::new();
    for (text, expected) in cases {
        let text = if text.starts_with("units") {
            text.clone()
        } else {
            format!("units = \"SI\"\n{text}")
        };
        folder.write("a.rotor.toml", &text);
        let run = folder.run(&["performance", "a.rotor.toml"]);
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{text}\n{}", run.err);
        assert!(
            run.err.contains(expected),
            "{expected}\nis not in\n{}",
            run.err
        );
        assert!(!folder.path("results").exists());
    }
}

#[test]
fn wrong_blades_are_refused() {
    let mach = "[rotor]\nblades = 3\nhub_radius = 1\ntip_radius = 10\n";
    refused(&[
        (
            format!("{}{SWEEP}", ROTOR.replace("r = 6,", "r = 1.5,")),
            "a.rotor.toml:8: station 2 is at the radius 1.5 m, expected more than 2 m",
        ),
        (
            format!(
                "{}{SWEEP}",
                ROTOR.replace("tip_radius = 10", "tip_radius = 9")
            ),
            "a.rotor.toml:5: \"tip_radius\" is 9 m, expected 9.5 m or more, the radius of the last \
             station\n  help: correct it",
        ),
        (
            format!(
                "{}{SWEEP}",
                ROTOR.replace("hub_radius = 1", "hub_radius = 3")
            ),
            "a.rotor.toml:4: \"hub_radius\" is 3 m, expected 2 m or less, the radius of the first",
        ),
        (
            format!("{}{SWEEP}", ROTOR.replacen("naca0012", "naca0013", 1)),
            "a.rotor.toml:7: unknown airfoil \"naca0013\" in station 1\n  help: did you mean \
             \"naca0012\"?",
        ),
        (
            format!("{mach}file = \"none.dat\"\n{SWEEP}"),
            "\"none.dat\"",
        ),
        (
            format!("{mach}{SWEEP}"),
            "[rotor] has neither \"stations\" nor \"file\", expected either",
        ),
        (
            format!("{}{SWEEP}", ROTOR.replace("blades = 3\n", "")),
            "[rotor] has no \"blades\", and neither has the file of the blade",
        ),
        (
            format!("{}{SWEEP}", ROTOR.replace("blades", "blade")),
            "did you mean \"blades\"?",
        ),
    ]);
}

#[test]
fn wrong_points_are_refused() {
    refused(&[
        (
            ROTOR.to_owned(),
            "the file has no operating points, expected [[sweep]]",
        ),
        (
            format!("{ROTOR}[[sweep]]\nspeed = []\nrotor_speed = 3\n"),
            "a.rotor.toml:12: \"speed\" is empty, expected at least one value\n  help: give a number",
        ),
        (
            format!("{ROTOR}[[sweep]]\nspeed = 8\nrotor_speed = 1000\n"),
            "tables for Mach numbers up to",
        ),
        (
            format!("{ROTOR}{SWEEP}loads_at = [6]\n"),
            "\"loads_at\" has 6, expected a value of tip speed ratio [-]; the nearest is",
        ),
        (
            format!("{ROTOR}[[power_curve]]\nspeed = [8]\nrotor_speeds = [1, 2]\n"),
            "[[power_curve]] has none of them, expected one of \"tip_speed_ratio\"",
        ),
        (
            format!("{ROTOR}[[schedule]]\nspeed = [1, 2, 3]\nrotor_speed = [1, 2]\n"),
            "\"rotor_speed\" has 2 values, expected 1 or 3, as many as \"speed\"",
        ),
    ]);
}

#[test]
fn all_problems_of_a_file_are_reported() {
    let folder = Folder::new();
    let two = ROTOR
        .replacen("naca0012", "x", 1)
        .replace("tip_radius = 10", "tip_radius = 9");
    folder.write("a.rotor.toml", &format!("{two}[[sweep]]\nspeed = 1\n"));
    let run = folder.run(&["performance", "a.rotor.toml"]);
    assert_eq!(run.err.matches("error: ").count(), 2, "{}", run.err);
    let held = ROTOR.replace("blades = 3", "blades = 3\noutside_mach = \"hold\"");
    folder.write(
        "a.rotor.toml",
        &format!("{held}[[sweep]]\nspeed = 8\nrotor_speed = 1000\n"),
    );
    assert_eq!(
        folder
            .run(&["performance", "a.rotor.toml", "--no-figures"])
            .code,
        0
    );
}

/// Keys that would have no effect, or one that no rotor has.
#[test]
fn rotors_that_cannot_be_are_refused() {
    let with = |keys: &str| {
        format!(
            "{}{SWEEP}",
            ROTOR.replace("hub_radius", &format!("{keys}\nhub_radius"))
        )
    };
    refused(&[
        (
            with("precone = 95"),
            "\"precone\" is 95, expected less than 80 degrees",
        ),
        (
            with("shear = 0.2"),
            "\"shear\" is 0.2, expected \"hub_height\" beside it",
        ),
        (
            with("shear = 0.2\nhub_height = 9"),
            "\"hub_height\" is 9, expected more than the radius of the tip",
        ),
        (
            with("shear = 0.2\nhub_height = 20\nsectors = 1"),
            "\"sectors\" is 1, expected at least 3 azimuths",
        ),
        (
            format!("{ROTOR}[[sweep]]\nspeed = 8\nrotor_speed = [12, -13]\n"),
            "a point has a rotor speed of -13 rpm, expected zero or more",
        ),
    ]);
}
