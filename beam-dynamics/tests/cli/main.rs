//! The program as users run it: files in, messages and files out, exit codes.

// A test that cannot continue panics.
#![allow(clippy::unwrap_used)]

mod airfoil;
mod blade_pairs;
mod blades;
mod curvature;
mod electrodes;
mod exchange;
mod figures;
mod help;
mod identify;
mod keys;

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use nalgebra::{Matrix6, Vector2, Vector6};
use shared_geom::section::{
    self, Centers, Change, PrincipalAxes, Provenance, SectionProperties, Step,
};
use tempfile::TempDir;

mod loads;
mod messages;
mod netcdf;
mod performance;
mod prestress;
mod remedies;
mod robust;
mod rotors;
mod schema;
mod several;
mod starts;
mod static_sweep;
mod transient;
mod trim;

/// A blade of a strip with properties from a file.
const BLADE: &str = "\
units = \"SI\"
[properties.strip]
file = \"strip.properties.json\"
[[blade]]
name = \"blade\"
root = [0.06, 0, 0]
properties = \"strip\"
[[blade.piece]]
length = 0.8
elements = 4
[[blade.piece]]
length = 0.15
elements = 2
sweep = 30
[modes]
speeds = [0, 750]
count = 4
";

/// A folder for one test, and the program run in it.
struct Folder(TempDir);

/// Outcome of a run.
struct Run {
    code: i32,
    out: String,
    err: String,
}

impl Folder {
    /// With the strip's property file.
    fn new() -> Self {
        let folder = Self(tempfile::tempdir().unwrap());
        folder.write("strip.properties.json", &section::write(&strip()));
        folder
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn write(&self, name: &str, text: &str) {
        let path = self.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }

    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap()
    }

    fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_beam-dynamics"));
        command.args(arguments).current_dir(self.0.path());
        command
    }

    fn run(&self, arguments: &[&str]) -> Run {
        let output = self.command(arguments).output().unwrap();
        Run {
            code: output.status.code().unwrap(),
            out: String::from_utf8(output.stdout).unwrap(),
            err: String::from_utf8(output.stderr).unwrap(),
        }
    }

    /// Expects `check` to refuse `text` with exactly this message.
    #[track_caller]
    fn refuses(&self, text: &str, message: &str) {
        self.write("a.dynamics.toml", text);
        for command in ["check", "modes"] {
            let run = self.run(&[command, "a.dynamics.toml"]);
            assert_eq!((run.code, run.out.as_str()), (2, ""), "{}", run.err);
            assert_eq!(run.err, format!("{message}\n"));
            assert!(!self.path("results").exists());
        }
    }
}

/// An aluminum strip of 25.4 mm x 1.6 mm, by hand.
fn strip() -> SectionProperties {
    let stiffness = [2.97e6, 9.3e5, 7.6e4, 2.5, 0.634, 159.0];
    let mass = [0.109, 0.109, 0.109, 5.9e-6 + 2.3e-8, 2.3e-8, 5.9e-6];
    SectionProperties {
        name: "strip".to_owned(),
        reference_point: Vector2::zeros(),
        stiffness: Matrix6::from_diagonal(&Vector6::from(stiffness)),
        mass: Matrix6::from_diagonal(&Vector6::from(mass)),
        centers: Centers {
            tension: Vector2::zeros(),
            shear: Vector2::zeros(),
            mass: Vector2::zeros(),
        },
        principal_axes: PrincipalAxes {
            bending_angle: 0.0,
            bending_stiffness: [0.634, 159.0],
            inertia_angle: 0.0,
            inertia: [2.3e-8, 5.9e-6],
        },
        initial_curvature: None,
        piezo: None,
        thermal_force: None,
        imposed: Vec::new(),
        damping: None,
        prestress: None,
        provenance: Provenance {
            program: "by hand".to_owned(),
            version: "1".to_owned(),
            input_hash: String::new(),
            nodes: 0,
            cells: 0,
            history: Vec::new(),
            sections: Vec::new(),
        },
    }
}

#[test]
fn a_quiet_run_prints_problems_only() {
    let folder = Folder::new();
    folder.write("strip.properties.json", &section::write(&strip()));
    folder.write("a.dynamics.toml", BLADE);
    let run = folder.run(&["modes", "a.dynamics.toml", "--quiet", "--no-figures"]);
    assert_eq!((run.code, run.out.as_str(), run.err.as_str()), (0, "", ""));
    assert!(folder.path("results/a.frequencies.txt").is_file());
    // Remarks are warnings, with and without a report.
    let many = BLADE.replace("count = 4", "count = 900");
    folder.write("c.dynamics.toml", &many);
    let quiet = folder.run(&["modes", "c.dynamics.toml", "-q", "--no-figures"]);
    let told = folder.run(&["modes", "c.dynamics.toml", "--no-figures"]);
    let remarks = told.out.split("\nRemarks\n").nth(1).unwrap();
    let remark = remarks.lines().next().unwrap().trim();
    assert!(remark.contains("of 900 modes were found"), "{remark}");
    assert_eq!((quiet.code, quiet.out.as_str()), (0, ""));
    let expected = format!("warning: c: {remark}\n");
    assert!(quiet.err.starts_with(&expected), "{}", quiet.err);
    assert_eq!(told.err, "");
    let wrong = folder.run(&["modes", "b.dynamics.toml", "-q"]);
    assert_eq!((wrong.code, wrong.out.as_str()), (2, ""));
    assert!(wrong.err.contains("b.dynamics.toml"), "{}", wrong.err);
}

#[test]
fn a_good_run_writes_everything_and_says_where() {
    let folder = Folder::new();
    let measured = "[measured]\nfile = \"a.csv\"\nleave_out = [\"lag\"]\n";
    let points = "speed_rpm,frequency_hz,order\n0,1.4,1\n750,14.8,1\n";
    folder.write("in/a.csv", points);
    folder.write("in/strip.properties.json", &section::write(&strip()));
    folder.write("in/a.dynamics.toml", &format!("{BLADE}{measured}"));
    let run = folder.run(&["modes", "in/a.dynamics.toml"]);
    let files = [
        "frequencies.csv",
        "modes.csv",
        "frequencies.txt",
        "comparison.csv",
        "fan.png",
        "fan.svg",
        "critical_speeds.csv",
        "shapes_at_0_rpm.png",
        "shapes_at_0_rpm.svg",
        "shapes_at_750_rpm.png",
        "shapes_at_750_rpm.svg",
    ];
    let written = files.map(|ending| format!("  in/results/a.{ending}\n"));
    let written = written.concat();
    assert!(
        run.out.ends_with(&format!("\nWritten\n{written}")),
        "{}",
        run.out
    );
    for ending in files {
        assert!(
            folder.path(&format!("in/results/a.{ending}")).is_file(),
            "{ending}"
        );
    }
    let text = folder.read("in/results/a.frequencies.txt");
    assert!(
        run.out.starts_with(&text),
        "printed and written texts differ"
    );
    assert!(
        text.starts_with("a\n\nFrequencies over rotor speed\n"),
        "{text}"
    );
    let table = folder.read("in/results/a.frequencies.csv");
    assert_eq!(table.lines().count(), 1 + 2 * 4, "{table}");
    let comparison = folder.read("in/results/a.comparison.csv");
    assert!(
        comparison
            .lines()
            .nth(1)
            .unwrap()
            .starts_with("0,1,flap 1,1.4,1."),
        "{comparison}"
    );
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let png = fs::read(folder.path("in/results/a.fan.png")).unwrap();
    assert_eq!(&png[..4], b"\x89PNG");
}

#[test]
fn animated_shapes_are_written_when_requested() {
    let folder = Folder::new();
    folder.write("a.dynamics.toml", BLADE);
    let run = folder.run(&["modes", "a.dynamics.toml", "--vtu"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert!(run.out.contains("results/a.modes\n"), "{}", run.out);
    for file in ["flap_1_at_0_rpm.pvd", "flap_1_at_750_rpm_23.vtu"] {
        assert!(folder.path(&format!("results/a.modes/{file}")).is_file());
    }
    let chosen = BLADE.replace("[modes]", "[modes]\nshapes = true\nshape_speeds = [750]");
    folder.write("a.dynamics.toml", &chosen);
    assert_eq!(folder.run(&["modes", "a.dynamics.toml"]).code, 0);
    assert!(!folder.path("results/a.modes/flap_1_at_0_rpm.pvd").exists());
    assert!(
        folder
            .path("results/a.modes/flap_1_at_750_rpm.pvd")
            .is_file()
    );
    assert!(!folder.path("results/a.shapes_at_0_rpm.png").exists());
}

#[test]
fn results_of_several_files_go_to_one_folder() {
    let folder = Folder::new();
    folder.write("a.dynamics.toml", BLADE);
    folder.write("b.dynamics.toml", &BLADE.replace("[0, 750]", "[300]"));
    let run = folder.run(&[
        "modes",
        "a.dynamics.toml",
        "b.dynamics.toml",
        "--out",
        "x/y",
    ]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert!(folder.path("x/y/a.fan.svg").is_file());
    assert!(folder.path("x/y/b.frequencies.csv").is_file());
    assert!(!folder.path("x/y/b.fan.svg").exists());
    assert!(
        run.out
            .ends_with("  (no fan plot: a single rotor speed makes no lines)\n")
    );
}

#[test]
fn a_check_says_what_was_read() {
    let folder = Folder::new();
    folder.write("a.dynamics.toml", BLADE);
    let run = folder.run(&["check", "a.dynamics.toml"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let expected = "a.dynamics.toml: 13 nodes, 6 beams, 1 clamp, mass 0.1035 kg; 4 modes at 2 \
        speeds, 0 to 750 rpm\n\nNo problem found\n";
    assert_eq!(run.out, expected);
}

#[test]
fn an_unknown_key_is_reported() {
    let message = "\
error: a.dynamics.toml:14: unknown key \"swep\" in [[blade.piece]] number 2
  help: did you mean \"sweep\"?";
    Folder::new().refuses(&BLADE.replace("sweep", "swep"), message);
}

#[test]
fn a_wrong_unit_is_reported() {
    let folder = Folder::new();
    let message = "\
error: a.dynamics.toml:12: \"length\": \"kg\" measures a mass, expected a length
  help: units of it: m, mm, cm, km, um, in, ft";
    folder.refuses(
        &BLADE.replace("length = 0.15", "length = \"0.15 kg\""),
        message,
    );
    let message = "\
error: a.dynamics.toml:12: \"length\": unknown unit \"mmm\"
  help: did you mean \"mm\"?";
    folder.refuses(
        &BLADE.replace("length = 0.15", "length = \"6 mmm\""),
        message,
    );
}

#[test]
fn missing_files_are_reported() {
    let folder = Folder::new();
    let message = "\
error: a.dynamics.toml:3: properties \"strip\": no property file at \"stripe.properties.json\"
  help: did you mean \"strip.properties.json\"?";
    folder.refuses(&BLADE.replace("strip.prop", "stripe.prop"), message);
    let run = folder.run(&["check", "b.dynamics.toml"]);
    assert_eq!(run.code, 2);
    assert_eq!(
        run.err,
        "error: b.dynamics.toml: cannot be read: no such file\n  help: did you mean \
         \"a.dynamics.toml\"?\n"
    );
}

#[test]
fn a_newer_property_file_is_reported() {
    let folder = Folder::new();
    let text = section::write(&strip()).replace("\"version\": 1,", "\"version\": 7,");
    folder.write("strip.properties.json", &text);
    let message = "\
error: strip.properties.json:3: written in version 7 of the property-file format, expected at most 3 \
(named by \"file\" of properties \"strip\", a.dynamics.toml:3)
  help: use a newer version of this program";
    folder.refuses(BLADE, message);
}

/// The history records the origin of the matrices; it is not applied to them again.
#[test]
fn a_property_file_with_a_history_is_read() {
    let folder = Folder::new();
    let frequencies = |properties: &SectionProperties| {
        folder.write("strip.properties.json", &section::write(properties));
        folder.write("a.dynamics.toml", BLADE);
        let run = folder.run(&["modes", "a.dynamics.toml"]);
        assert_eq!((run.code, run.err.as_str()), (0, ""));
        std::fs::read_to_string(folder.path("results/a.frequencies.csv")).unwrap()
    };
    let plain = strip();
    let mut moved = plain.clone();
    moved.provenance.history.push(Step {
        change: Change::Shift(Vector2::new(1.0, 1.0)),
        program: "by hand".to_owned(),
        version: "1".to_owned(),
    });
    assert!(section::write(&moved).contains("\"version\": 2,"));
    assert_eq!(frequencies(&moved), frequencies(&plain));
}

#[test]
fn a_free_mechanism_is_reported_by_node_and_direction() {
    let folder = Folder::new();
    folder.write(
        "a.dynamics.toml",
        &BLADE.replace("root =", "clamp_root = false\nroot ="),
    );
    let run = folder.run(&["modes", "a.dynamics.toml"]);
    assert_eq!((run.code, run.out.as_str()), (2, ""));
    let expected = "error: a.dynamics.toml:5: free mechanism: node \"blade/";
    assert!(run.err.starts_with(expected), "{}", run.err);
    for motion in ["translation along x", "rotation about z"] {
        assert!(run.err.contains(motion), "{motion} is not in {}", run.err);
    }
}

#[test]
fn several_errors_come_at_once() {
    let text = BLADE
        .replace("sweep", "swep")
        .replace("length = 0.8", "length = \"800 mmm\"")
        .replace("properties = \"strip\"", "properties = \"stripp\"")
        .replace("[0, 750]", "[0, -750]")
        .replace("count = 4", "count = -4");
    let message = "\
error: a.dynamics.toml:7: unknown properties \"stripp\" in blade \"blade\"
  help: did you mean \"strip\"?
error: a.dynamics.toml:9: \"length\": unknown unit \"mmm\"
  help: did you mean \"mm\"?
error: a.dynamics.toml:14: unknown key \"swep\" in [[blade.piece]] number 2
  help: did you mean \"sweep\"?
error: a.dynamics.toml:16: \"speeds\" has the speed -750 rpm, expected zero or more
error: a.dynamics.toml:17: \"count\" is -4, expected a whole number of at least 1";
    Folder::new().refuses(&text, message);
}

#[test]
fn one_wrong_file_stops_all() {
    let folder = Folder::new();
    folder.write("a.dynamics.toml", BLADE);
    folder.write("b.dynamics.toml", &BLADE.replace("units", "unit"));
    let run = folder.run(&["modes", "a.dynamics.toml", "b.dynamics.toml"]);
    assert_eq!((run.code, run.out.as_str()), (2, ""));
    assert!(
        run.err.contains("b.dynamics.toml:1: unknown key \"unit\""),
        "{}",
        run.err
    );
    assert!(!folder.path("results").exists());
}

#[test]
fn results_are_not_written_over_each_other() {
    let folder = Folder::new();
    let arguments = [
        "modes",
        "a/x.dynamics.toml",
        "b/x.dynamics.toml",
        "--out",
        "c",
    ];
    let run = folder.run(&arguments);
    assert_eq!(run.code, 2);
    assert_eq!(
        run.err,
        "error: results of \"a/x.dynamics.toml\" and \"b/x.dynamics.toml\" would both be \"c/x.*\"\n  \
         help: give the files different names, or run them one by one\n"
    );
}

#[test]
fn a_folder_that_cannot_be_made_is_reported() {
    let folder = Folder::new();
    folder.write("a.dynamics.toml", BLADE);
    folder.write("results", "");
    let run = folder.run(&["modes", "a.dynamics.toml"]);
    assert_eq!((run.code, run.out.as_str()), (2, ""));
    assert_eq!(
        run.err,
        "error: folder \"results\" cannot be made: a file of this name exists\n  \
         help: name another folder with --out\n"
    );
}

#[test]
fn usage_is_reported_with_code_two_and_help_with_zero() {
    let folder = Folder::new();
    for arguments in [
        &["modes"][..],
        &["mods", "a.dynamics.toml"],
        &[],
        &["check", "--out", "x"],
    ] {
        let run = folder.run(arguments);
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{arguments:?}");
        assert!(run.err.contains("Usage: beam-dynamics"), "{}", run.err);
    }
    for arguments in [
        &["--help"][..],
        &["modes", "--help"],
        &["check", "-h"],
        &["--version"],
    ] {
        let run = folder.run(arguments);
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{arguments:?}");
        assert!(run.out.contains("beam-dynamics"), "{}", run.out);
    }
}

#[test]
fn the_example_of_the_help_runs() {
    let folder = Folder::new();
    let help = folder.run(&["--help"]).out;
    let (_, behind) = help.split_once("<<'END'\n").unwrap();
    let (example, _) = behind.split_once("  END\n").unwrap();
    folder.write("blade.dynamics.toml", example);
    let run = folder.run(&["modes", "blade.dynamics.toml"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert!(run.out.contains("results/blade.fan.png"), "{}", run.out);
}

// A swept and twisted strip has no equilibrium at ten million revolutions a minute.
#[test]
fn what_was_reached_is_kept() {
    let folder = Folder::new();
    let twisted = BLADE.replace("sweep = 30", "sweep = 60\ntwist = 40");
    folder.write(
        "a.dynamics.toml",
        &twisted.replace("[0, 750]", "[0, 10, 1e7]"),
    );
    let run = folder.run(&["modes", "a.dynamics.toml"]);
    assert_eq!(run.code, 1);
    assert!(
        run.err.starts_with("error: a: no steady equilibrium at "),
        "{}",
        run.err
    );
    assert!(
        run.err
            .ends_with("2 of 3 rotor speeds were reached, and their results written\n")
    );
    assert!(
        run.out.contains("stopped early: no steady equilibrium"),
        "{}",
        run.out
    );
    assert_eq!(
        folder.read("results/a.frequencies.csv").lines().count(),
        1 + 2 * 4
    );
    assert!(folder.path("results/a.fan.png").is_file());
}

// The reading end of the pipe is closed before anything is written.
#[test]
fn a_closed_pipe_is_no_error() {
    let folder = Folder::new();
    folder.write("a.dynamics.toml", BLADE);
    for command in ["modes", "check"] {
        let mut child = folder
            .command(&[command, "a.dynamics.toml"])
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(0), "{command}");
        assert_eq!(String::from_utf8(output.stderr).unwrap(), "");
    }
    assert!(folder.path("results/a.fan.png").is_file());
}
