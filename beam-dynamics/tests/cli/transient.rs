//! `transient` and `plot`, with runs that are stopped and continued.

use std::fs;
use std::process::Stdio;
use std::time::{Duration, Instant};

use super::Folder;

/// A beam of two elements that falls from its straight position.
pub const BEAM: &str = "\
units = \"SI\"
[properties.strip]
ea = 7e4
gay = 2e4
gaz = 1e4
gj = 30
eiy = 40
eiz = 900
m = 2
iy = 0.01
iz = 0.04
[[blade]]
name = \"blade\"
root = [0, 0, 0]
properties = \"strip\"
[[blade.piece]]
length = 2
elements = 2
[gravity]
acceleration = [0, 0, -9.81]
";

const OUTPUT: &str = "\
[output]
every = 2
vtu = 5
restart_every = 10
[[output.column]]
name = \"tip\"
quantity = \"displacement\"
of = \"blade/tip\"
unit = \"mm\"
[[output.column]]
name = \"held\"
quantity = \"reaction_moment\"
of = \"clamp of blade/root\"
component = \"y\"
[[output.column]]
name = \"bending\"
quantity = \"internal_force\"
of = \"blade/beam 1\"
component = \"bending_y\"
[[output.column]]
name = \"pull\"
quantity = \"drive\"
of = \"= 2*t\"
unit = \"kN\"
[[output.column]]
name = \"energy\"
quantity = \"energy\"
";

pub fn beam(to: f64) -> String {
    format!("{BEAM}[transient]\nto = {to}\nstep = \"2 ms\"\n{OUTPUT}")
}

/// Numbers of a row, time first.
fn row(table: &str, number: usize) -> Vec<f64> {
    let line = table.lines().nth(number + 1).unwrap();
    line.split(',').map(|cell| cell.parse().unwrap()).collect()
}

#[test]
fn a_run_writes_its_tables_figures_and_effort() {
    let folder = Folder::new();
    folder.write("a.dynamics.toml", &beam(0.1));
    let run = folder.run(&["transient", "a.dynamics.toml"]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    for expected in [
        "a: from 0 s to 0.1 s\ntwo steps, asymptotic radius 0.6; steps of 0.002 s\n",
        "reached 0.1 s of 0.1 s",
        "steps             50  of 0.002 s",
        "factorization",
        "whole run",
        "  results/a.transient.csv\n  results/a.transient.nc\n  results/a.transient.txt\n",
        "  results/a.restart.json\n",
    ] {
        assert!(run.out.contains(expected), "{expected}\n{}", run.out);
    }
    // No terminal, no progress.
    assert_eq!(run.err, "");
    let table = folder.read("results/a.transient.csv");
    assert_eq!(
        table.lines().next().unwrap(),
        "time [s],tip_x [mm],tip_y [mm],tip_z [mm],held [N m],bending [N m],pull [kN],energy [J]"
    );
    assert_eq!(table.lines().count(), 27);
    let last = row(&table, 25);
    assert!((last[0] - 0.1).abs() < 1e-12);
    // The tip falls nearly as freely as g t^2 / 2 = 49 mm; the energy, zero at the start, is
    // dissipated a little by the scheme, compared with some 2 J of converted energy.
    assert!(last[3] < -40.0 && last[3] > -60.0, "{last:?}");
    assert!(last[7] < 1e-9 && last[7] > -0.02, "{last:?}");
    assert!((last[6] - 2e-3 * last[0]).abs() < 1e-15);
    let figure = folder.read("results/a.transient.svg");
    for expected in ["tip_z", "[mm]", "[kN]", "[J]", "time [s]"] {
        let mut lines = figure.lines();
        assert!(lines.any(|line| line.ends_with(expected)), "{expected}");
    }
    let series = folder.read("results/a.transient.pvd");
    assert_eq!(series.matches("DataSet").count(), 6);
}

#[test]
fn a_killed_run_continues_to_the_last_bit() {
    let folder = Folder::new();
    folder.write("a.dynamics.toml", &beam(1000.0));
    let arguments = ["transient", "a.dynamics.toml", "--out", "parts"];
    let mut endless = folder.command(&arguments);
    let mut endless = endless.stdout(Stdio::null()).spawn().unwrap();
    let state = folder.path("parts/a.restart.json");
    let table = folder.path("parts/a.transient.csv");
    // More rows than before the first saved state.
    let rows = || fs::read_to_string(&table).map_or(0, |text| text.lines().count());
    let patience = Instant::now();
    while !(state.exists() && rows() > 20) && patience.elapsed() < Duration::from_secs(300) {
        std::thread::sleep(Duration::from_millis(5));
    }
    endless.kill().unwrap();
    endless.wait().unwrap();
    let kept = fs::read_to_string(&state).unwrap();
    let step = kept.split("\"step\":").nth(1).unwrap();
    let step = step.split(',').next().unwrap();
    let end = 0.002 * (step.parse::<f64>().unwrap() + 30.0);

    folder.write("a.dynamics.toml", &beam(end));
    let whole = folder.run(&["transient", "a.dynamics.toml", "--out", "whole"]);
    assert_eq!(whole.code, 0, "{}", whole.err);
    let restart = ["--restart", "parts/a.restart.json"];
    let rest = folder.run(&[&arguments[..], &restart[..]].concat());
    assert_eq!(rest.code, 0, "{}", rest.err);
    assert!(
        rest.out.contains(&format!("(step {step}) to")),
        "{}",
        rest.out
    );
    for file in ["a.transient.csv", "a.transient.nc", "a.transient.pvd"] {
        let [once, twice] = ["whole", "parts"]
            .map(|position| fs::read(folder.path(&format!("{position}/{file}"))).unwrap());
        assert!(once == twice, "{file}");
    }
}

// Killed after the last state and before the figure: the tables are complete.
#[test]
fn a_complete_run_without_figures_and_report_gets_them_by_a_restart() {
    let folder = Folder::new();
    folder.write("a.dynamics.toml", &beam(0.1));
    let arguments = ["transient", "a.dynamics.toml", "--out", "parts"];
    assert_eq!(folder.run(&arguments).code, 0);
    let later = ["png", "svg", "txt"].map(|end| folder.path(&format!("parts/a.transient.{end}")));
    let table = folder.path("parts/a.transient.csv");
    let before = fs::read(&table).unwrap();
    let figure = fs::read(&later[1]).unwrap();
    for file in &later {
        fs::remove_file(file).unwrap();
    }
    let restart = ["--restart", "parts/a.restart.json"];
    let again = folder.run(&[&arguments[..], &restart[..]].concat());
    assert_eq!(again.code, 0, "{}", again.err);
    assert!(again.out.contains("is complete (step 50)"), "{}", again.out);
    assert!(later.iter().all(|file| file.exists()));
    assert!(fs::read(&table).unwrap() == before);
    assert!(fs::read(&later[1]).unwrap() == figure);
    assert!(!folder.path("parts/a.transient.lock").exists());
}

#[test]
fn a_state_that_does_not_fit_is_refused() {
    let folder = Folder::new();
    folder.write("a.dynamics.toml", &beam(0.1));
    let arguments = ["transient", "a.dynamics.toml", "--out", "parts"];
    let restart = ["--restart", "parts/a.restart.json"];
    assert_eq!(folder.run(&arguments).code, 0);
    folder.write("a.dynamics.toml", &beam(0.05));
    let again = folder.run(&[&arguments[..], &restart[..]].concat());
    assert_eq!(again.code, 2);
    assert_eq!(
        again.err,
        "error: \"parts/a.restart.json\" is at 0.1 s, after the end of the run at 0.05 s\n  \
         help: give [transient] a \"to\" that is not before the state: a later one continues \
         the run\n"
    );
    folder.write(
        "a.dynamics.toml",
        &beam(0.2).replace("elements = 2", "elements = 3"),
    );
    let other = folder.run(&[&arguments[..], &restart[..]].concat());
    assert_eq!(other.code, 2);
    assert!(
        other
            .err
            .contains("is the state of another model: it has 5 nodes, the model 7"),
        "{}",
        other.err
    );
}

// The requested output and names in the file may differ; the model may not.
#[test]
fn a_state_continues_with_other_settings_but_not_with_another_model() {
    let folder = Folder::new();
    folder.write("a.dynamics.toml", &beam(0.1));
    let restart = ["--restart", "parts/a.restart.json"];
    let first = ["transient", "a.dynamics.toml", "--out", "parts"];
    assert_eq!(folder.run(&first).code, 0);
    let again = ["transient", "a.dynamics.toml", "--out", "other"];
    let again = [&again[..], &restart[..]].concat();
    for (from, to) in [
        ("eiy = 40", "eiy = 41"),
        ("-9.81]", "-9.82]"),
        ("m = 2\n", "m = 2.5\n"),
    ] {
        folder.write("a.dynamics.toml", &beam(0.2).replace(from, to));
        let refused = folder.run(&again);
        assert_eq!(refused.code, 2, "{to}");
        for expected in [
            "is the state of another model: its nodes have the same names, but some element, law",
            "\"to\", \"step\", \"scheme\" and [output] may differ",
        ] {
            assert!(refused.err.contains(expected), "{}", refused.err);
        }
    }
    let changed = beam(0.2)
        .replace("step = \"2 ms\"", "step = \"5 ms\"\nscheme = \"bdf2\"")
        .replace("every = 2\n", "every = 1\n")
        .replace("[properties.strip]\n", "# A remark.\n[properties.strip]\n");
    folder.write("a.dynamics.toml", &changed);
    let taken = folder.run(&again);
    assert_eq!(taken.code, 0, "{}", taken.err);
    let table = folder.read("other/a.transient.csv");
    // A step of 4 ms, which is twice the last; the grid of 5 ms begins where the run continues.
    let times: Vec<_> = (0..4).map(|number| row(&table, number)[0]).collect();
    for (time, expected) in times.iter().zip([0.1025, 0.105, 0.11, 0.115]) {
        assert!((time - expected).abs() < 1e-9, "{times:?}");
    }
    let last = table.lines().count() - 2;
    assert!((row(&table, last)[0] - 0.2).abs() < 1e-12);
}

/// A wheel that a drive turns by 10 rad/s up to a time after which it has no value.
fn wheel(to: f64) -> String {
    format!(
        "units = \"SI\"
[[node]]
name = \"wheel\"
position = [0, 0, 0]
[[body]]
node = \"wheel\"
mass = 1
inertia = [1, 1, 1]
[[joint]]
name = \"axle\"
kind = \"revolute\"
nodes = [\"wheel\"]
axis = [0, 0, 1]
angle = \"= 180/pi*10*t + 0*sqrt(1.25 - t)\"
[transient]
to = {to}
step = \"20 ms\"
[output]
every = 7
[[output.column]]
name = \"angle\"
quantity = \"joint_angle\"
of = \"axle\"
unit = \"rad\"
"
    )
}

// A row every 0.14 s, 1.4 rad apart. The run stops where its drive ends, at 1.25 s, or a
// little before, between two rows.
#[test]
fn a_run_that_fails_keeps_its_last_state_and_angles_their_turns() {
    let folder = Folder::new();
    folder.write("a.dynamics.toml", &wheel(2.0));
    let arguments = ["transient", "a.dynamics.toml"];
    let failed = folder.run(&arguments);
    assert_eq!(failed.code, 1, "{}{}", failed.out, failed.err);
    assert!(failed.err.contains("not a finite number"), "{}", failed.err);
    assert!(
        failed.out.contains("  results/a.restart.json\n"),
        "{}",
        failed.out
    );
    let table = folder.read("results/a.transient.csv");
    let last = row(&table, table.lines().count() - 2);
    assert!(last[0] > 1.2 && last[0] <= 1.25, "{last:?}");
    for number in 0..table.lines().count() - 1 {
        let found = row(&table, number);
        assert!((found[1] - 10.0 * found[0]).abs() < 1e-6, "{found:?}");
    }
    let state = folder.read("results/a.restart.json");
    assert!(state.contains("\"angles\":{\"axle\":12."), "{state}");
    assert!(folder.path("results/a.transient.svg").exists());

    // A continued run keeps the turn that the wheel has made.
    let end = 1.2;
    folder.write("a.dynamics.toml", &wheel(1.0));
    let parts = [&arguments[..], &["--out", "parts"]].concat();
    assert_eq!(folder.run(&parts).code, 0);
    folder.write("a.dynamics.toml", &wheel(end));
    let restart = ["--restart", "parts/a.restart.json", "--out", "rest"];
    let rest = folder.run(&[&arguments[..], &restart[..]].concat());
    assert_eq!(rest.code, 0, "{}", rest.err);
    let table = folder.read("rest/a.transient.csv");
    let found = row(&table, table.lines().count() - 2);
    assert!((found[0] - end).abs() < 1e-12 && (found[1] - 10.0 * end).abs() < 1e-6);
}

#[test]
fn columns_are_drawn_and_wrong_names_are_reported() {
    let folder = Folder::new();
    folder.write("a.dynamics.toml", &beam(0.02));
    folder.run(&["transient", "a.dynamics.toml"]);
    let csv = "results/a.transient.csv";
    let run = folder.run(&["plot", csv, "--columns", "tip_*,held"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert_eq!(
        run.out,
        "Written\n  results/a.plot.png\n  results/a.plot.svg\n"
    );
    let figure = folder.read("results/a.plot.svg");
    assert!(figure.contains("\ntip_x\n") && !figure.contains("\nenergy\n"));
    let netcdf = "results/a.transient.nc";
    let run = folder.run(&[
        "plot",
        csv,
        netcdf,
        "--x",
        "tip_x",
        "--columns",
        "tip_z",
        "--out",
        "b/path.svg",
    ]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let figure = folder.read("b/path.svg");
    for text in ["a.transient.csv", "a.transient.nc", "tip_z", "tip_x [mm]"] {
        assert!(figure.contains(&format!("\n{text}\n")), "{text}");
    }
    assert!(!figure.contains("results"));
    let run = folder.run(&["plot", csv, "--from", "0.011", "--to", "0.013"]);
    assert_eq!(run.code, 2);
    assert!(run.err.contains("has 1 row") && run.err.contains("--from"));

    let run = folder.run(&["plot", csv, "--columns", "tip_w,hold"]);
    assert_eq!((run.code, run.out.as_str()), (2, ""));
    assert!(
        run.err.contains("unknown column \"tip_w\" of"),
        "{}",
        run.err
    );
    assert!(
        run.err.contains("unknown column \"hold\" of"),
        "{}",
        run.err
    );
    assert!(run.err.contains("did you mean \"held\"?"), "{}", run.err);
    let run = folder.run(&["plot", "a.dynamics.toml"]);
    assert_eq!(run.code, 2);
    assert!(
        run.err.contains("its ending is neither .csv nor .nc"),
        "{}",
        run.err
    );
}

#[test]
fn a_file_without_a_run_is_reported() {
    let folder = Folder::new();
    folder.write("a.dynamics.toml", BEAM);
    let run = folder.run(&["transient", "a.dynamics.toml"]);
    assert_eq!(run.code, 2);
    assert_eq!(
        run.err,
        "error: a.dynamics.toml: has no [transient] that defines the analysis\n  \
         help: add [transient] with to = 1 and step = \"1 ms\"\n"
    );
    let run = folder.run(&[
        "transient",
        "a.dynamics.toml",
        "b.dynamics.toml",
        "--restart",
        "c",
    ]);
    assert_eq!(run.code, 2);
    assert!(
        run.err
            .contains("--restart continues one file, but 2 are given"),
        "{}",
        run.err
    );
}
