//! Files of made-up runs: written, read back, killed and continued.

use std::path::Path;

use nalgebra::Vector3;

use super::*;
use crate::assembly::System;
use crate::case::{Column, Every, Model, OutputSettings, Quantity};
use crate::elements::Element;
use crate::elements::bodies::{RigidBody, RigidInertia};
use crate::elements::{Axes, NodeQuantity, NodeVector, Part};
use crate::integrator::Counters;
use crate::model::{Conditions, State};
use crate::output::ResultLocation;
use crate::output::samples::{names, nodes_at};
use crate::result::{AcceptedStep, Recorder, Snapshot};

/// A body that moves as defined by [`run`].
fn model() -> Model {
    let nodes = nodes_at(&[[0.0; 3]]);
    let body: Box<dyn Element> = Box::new(RigidBody::new("body", 0, RigidInertia::zero()));
    Model::new("a body", System::new(nodes, vec![body]))
}

fn column(name: &str, unit: (&str, f64), vector: NodeVector, part: Part) -> Column {
    Column {
        name: name.to_owned(),
        unit: unit.0.to_owned(),
        factor: unit.1,
        words: format!("{name} of the body"),
        quantity: Quantity::Node(NodeQuantity {
            node: 0,
            vector,
            part,
            against: None,
            axes: Axes::Model,
        }),
    }
}

/// Position along x and y in mm, speed, length of the step.
fn settings() -> OutputSettings {
    let mm = ("mm", 1e-3);
    OutputSettings {
        columns: vec![
            column("a_x", mm, NodeVector::Position, Part::Component(0)),
            column("a_y", mm, NodeVector::Position, Part::Component(1)),
            column("speed", ("m/s", 1.0), NodeVector::Velocity, Part::Magnitude),
            Column {
                name: "step".to_owned(),
                unit: "s".to_owned(),
                factor: 1.0,
                words: "length of the step".to_owned(),
                quantity: Quantity::StepLength,
            },
        ],
        ..OutputSettings::default()
    }
}

const STEP: f64 = 0.1;

/// The state after a number of steps: a circle of 1 m.
fn state(model: &Model, step: usize) -> State {
    let mut state = model.system.rest();
    let angle = STEP * step as f64;
    state.nodes[0].position = Vector3::new(angle.cos(), angle.sin(), 0.0);
    state.nodes[0].velocity = Vector3::new(-angle.sin(), angle.cos(), 0.0);
    state
}

/// Passes the steps of `range` to `files`, with the quantities that it requests.
fn run(model: &Model, files: &mut RunFiles<'_>, range: std::ops::RangeInclusive<usize>) -> bool {
    let conditions = Conditions::at_rest();
    for step in range {
        let state = state(model, step);
        let accepted = AcceptedStep {
            step,
            time: STEP * step as f64,
            length: STEP,
            iterations: 2,
            state: &state,
            conditions: &conditions,
        };
        if !files.record(&accepted) {
            return false;
        }
        if files.wants_snapshot(&accepted) && !files.keep(&snapshot(step)) {
            return false;
        }
    }
    true
}

fn snapshot(step: usize) -> Snapshot {
    let progress = serde_json::json!({
        "time": STEP * step as f64,
        "counters": Counters::default(),
        "length": STEP,
        "known": 2,
        "corner": null,
        "lengths": { "from": 0.0, "points": step, "wish": STEP },
    });
    Snapshot {
        model: model().fingerprint(),
        angles: Default::default(),
        nodes: vec!["n0".to_owned()],
        multipliers: 0,
        step,
        progress: serde_json::from_value(progress).unwrap(),
        output_time: 0.25,
        total_time: 1.5,
        states: vec![vec![0.1, 1e-300, -1.0 / 3.0]],
    }
}

/// Runs to the end without interruption.
fn complete(folder: &Path, settings: &OutputSettings, steps: usize) -> Vec<String> {
    let model = model();
    let location = ResultLocation::new(folder, "x");
    let mut files = RunFiles::new(&model, settings, &location, None).unwrap();
    assert!(run(&model, &mut files, 0..=steps));
    names(&files.finish("a body", "text\n").unwrap())
}

#[test]
fn tables_are_read_back_to_the_last_bit() {
    let folder = tempfile::tempdir().unwrap();
    let written = complete(folder.path(), &settings(), 20);
    let expected = [
        "x.transient.csv",
        "x.transient.nc",
        "x.transient.txt",
        "x.transient.png",
        "x.transient.svg",
    ];
    assert_eq!(written, expected);
    let text = std::fs::read_to_string(folder.path().join("x.transient.csv")).unwrap();
    assert!(
        text.starts_with(
            "time [s],a_x [mm],a_y [mm],speed [m/s],step [s]\n0.0,1000.0,0.0,1.0,0.1\n"
        ),
        "{text}"
    );
    let csv = TimeTable::read(&folder.path().join("x.transient.csv")).unwrap();
    let netcdf = TimeTable::read(&folder.path().join("x.transient.nc")).unwrap();
    assert_eq!(csv.rows(), 21);
    assert_eq!(csv.columns, netcdf.columns);
    for (step, x) in csv.columns[1].iter().enumerate() {
        assert_eq!(*x, (STEP * step as f64).cos() / 1e-3);
    }
    assert_eq!(netcdf.headings[2].unit, "mm");
    assert_eq!(netcdf.headings[2].words, "a_y of the body");
    let units = |table: &TimeTable| -> Vec<String> {
        table.headings.iter().map(|h| h.unit.clone()).collect()
    };
    assert_eq!(units(&csv), units(&netcdf));
}

/// Pseudo-random numbers: splitmix64.
fn random(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut z = *state;
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

// Huge counts where the header has small ones, cuts, bits: all returned data is in the file.
#[test]
fn changed_binary_tables_are_read_or_refused() {
    let folder = tempfile::tempdir().unwrap();
    complete(folder.path(), &settings(), 5);
    let sound = std::fs::read(folder.path().join("x.transient.nc")).unwrap();
    let path = folder.path().join("y.nc");
    let read = |bytes: &[u8]| {
        std::fs::write(&path, bytes).unwrap();
        TimeTable::read(&path)
    };
    let aborted = b"CDF\x02\0\0\0\0\0\0\0\x0a\x39\x60\0\0";
    assert!(
        read(aborted)
            .unwrap_err()
            .to_string()
            .contains("NetCDF-3 file of a run")
    );
    let (mut seed, mut good) = (1, 0);
    for _ in 0..2000 {
        let mut bytes = sound.clone();
        for _ in 0..=random(&mut seed) % 3 {
            let at = random(&mut seed) as usize % bytes.len();
            match random(&mut seed) % 4 {
                0 => bytes[at] ^= 1 << (random(&mut seed) % 8),
                1 => bytes[at] = random(&mut seed) as u8,
                2 => {
                    let counts = [0, 1, 2, 10, 0x3960_0000, i32::MAX as u32, u32::MAX];
                    let count = counts[random(&mut seed) as usize % counts.len()];
                    let at = at / 4 * 4;
                    for (byte, new) in bytes[at..].iter_mut().zip(count.to_be_bytes()) {
                        *byte = new;
                    }
                }
                _ => bytes.truncate(at.max(1)),
            }
        }
        if let Ok(table) = read(&bytes) {
            let numbers: usize = table.columns.iter().map(Vec::len).sum();
            assert!(8 * numbers <= bytes.len());
            good += 1;
        }
        super::netcdf_table::title(&path);
    }
    // Most changes hit texts and numbers; changed counts and cuts are refused.
    assert!((200..1900).contains(&good), "{good}");
}

// A run that is dropped in the middle acts as if killed: nothing is written at its end.
#[test]
fn a_killed_run_keeps_its_rows_and_continues_without_doubling_them() {
    let [whole, parts] = [(); 2].map(|()| tempfile::tempdir().unwrap());
    let settings = OutputSettings {
        every: Every::Time(0.2),
        restart: Some(Every::Steps(10)),
        vtu: Some(2),
        ..settings()
    };
    let listed = complete(whole.path(), &settings, 40);
    assert!(
        listed.iter().any(|name| name == "x.restart.json"),
        "{listed:?}"
    );

    let model = model();
    let location = ResultLocation::new(parts.path(), "x");
    let mut files = RunFiles::new(&model, &settings, &location, None).unwrap();
    assert!(run(&model, &mut files, 0..=27));
    drop(files);
    let csv = parts.path().join("x.transient.csv");
    assert_eq!(TimeTable::read(&csv).unwrap().rows(), 14);
    // The line that was just being written.
    let mut torn = std::fs::read(&csv).unwrap();
    torn.extend(b"2.8,1.0,");
    std::fs::write(&csv, torn).unwrap();
    assert_eq!(TimeTable::read(&csv).unwrap().rows(), 14);

    let kept = read_snapshot(&parts.path().join("x.restart.json")).unwrap();
    assert_eq!(kept, snapshot(20));
    let mut files = RunFiles::new(&model, &settings, &location, Some(&kept)).unwrap();
    // Whether or not the step at which it continues is passed again.
    assert!(run(&model, &mut files, 20..=40));
    files.finish("a body", "text\n").unwrap();
    for file in [
        "x.transient.csv",
        "x.transient.nc",
        "x.transient.pvd",
        "x.restart.json",
        "x.transient/step_0000040.vtu",
    ] {
        let [once, twice] = [&whole, &parts].map(|folder| std::fs::read(folder.path().join(file)));
        assert!(once.unwrap() == twice.unwrap(), "{file}");
    }
    let count = |folder: &Path| folder.join("x.transient").read_dir().unwrap().count();
    assert_eq!(count(whole.path()), 11);
    assert_eq!(count(parts.path()), 11);
}

#[test]
fn a_run_does_not_go_on_in_a_table_of_others() {
    let folder = tempfile::tempdir().unwrap();
    complete(folder.path(), &settings(), 20);
    let model = model();
    let mut other = settings();
    other.columns[0].name = "b_x".to_owned();
    for (csv, netcdf, file) in [(true, false, "csv"), (false, true, "nc")] {
        (other.csv, other.netcdf) = (csv, netcdf);
        let location = ResultLocation::new(folder.path(), "x");
        let problem = RunFiles::new(&model, &other, &location, Some(&snapshot(10))).unwrap_err();
        let reported = problem.to_string();
        assert!(
            reported.contains(&format!("x.transient.{file}\" has other columns")),
            "{reported}"
        );
    }
}

#[test]
fn files_that_are_no_tables_are_reported() {
    use shared_geom::error::Explain;

    let folder = tempfile::tempdir().unwrap();
    let reported = |name: &str, content: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, content).unwrap();
        TimeTable::read(&path).unwrap_err().to_string()
    };
    for (name, content, expected) in [
        ("a.txt", "", "its ending is neither .csv nor .nc"),
        ("a.nc", "no", "it is not a complete NetCDF-3 file"),
        ("a.csv", "time [s],b [m]\n1,2\n3\n", "line 3 has 1 values"),
        (
            "a.csv",
            "time [s],b [m]\n1,x\n",
            "line 2 has \"x\", expected a number",
        ),
    ] {
        let reported = reported(name, content);
        assert!(reported.contains(expected), "{reported}");
    }
    let absent = TimeTable::read(&folder.path().join("b.csv")).unwrap_err();
    assert!(
        absent.to_string().ends_with("there is no such file"),
        "{absent}"
    );
    let reported = read_snapshot(&folder.path().join("a.csv")).unwrap_err();
    assert!(
        reported.to_string().contains("it is not a restart file"),
        "{reported}"
    );
    assert!(reported.help().unwrap().contains("NAME.restart.json"));
}

#[test]
fn files_that_are_no_states_are_reported_with_their_kind() {
    let folder = tempfile::tempdir().unwrap();
    for (name, content, expected) in [
        (
            "b.properties.json",
            "{}",
            "it is a property file of a section, expected a restart file",
        ),
        (
            "c.json",
            "{\n  \"format\": \"helicoid blade\"\n}",
            "it is a blade file, expected a restart file",
        ),
        (
            "d.json",
            "{ \"a\": 1 }",
            "it is not a restart file, but other JSON",
        ),
        (
            "e.restart.json",
            "{ \"time\": 1",
            "the restart file ends early",
        ),
        (
            "f.restart.json",
            "{\n}",
            "the restart file is damaged at line 2, column 1",
        ),
    ] {
        let path = folder.path().join(name);
        std::fs::write(&path, content).unwrap();
        let reported = read_snapshot(&path).unwrap_err().to_string();
        assert!(reported.ends_with(expected), "{reported}");
    }
}
