//! Seeds of the fuzz targets, `fuzz/corpus`, with changes from a fixed seed: each is read, or
//! refused with a message.

use std::path::Path;

use beam_dynamics::analysis::transient::{difference, transient};
use beam_dynamics::input;
use beam_dynamics::output::{TimeTable, parse_snapshot};
use beam_dynamics::result::{AcceptedStep, Recorder, Snapshot};
use shared_geom::expression::{Expression, Jet, Names};

const FUZZ: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../fuzz");

/// Pseudo-random numbers: splitmix64.
struct Random(u64);

impl Random {
    /// A number below `end`.
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        (z >> 33) as usize % end.max(1)
    }

    /// `bytes` with one to three letters replaced, removed or doubled, or cut.
    fn change(&mut self, bytes: &[u8]) -> Vec<u8> {
        let mut bytes = bytes.to_vec();
        for _ in 0..=self.below(3) {
            let at = self.below(bytes.len());
            match (bytes.is_empty(), self.below(8)) {
                (true, _) => {}
                (_, 0) => bytes.truncate(at),
                (_, 1) => {
                    bytes.remove(at);
                }
                (_, 2) => bytes.insert(at, bytes[at]),
                (_, 3) => bytes[at] = self.below(256) as u8,
                _ => bytes[at] = b"0123456789-+.eE\"[]{}=,#t \n"[self.below(26)],
            }
        }
        bytes
    }
}

/// Calls `check` with every seed of a target and `changes` changes of each.
fn each(target: &str, changes: usize, check: impl Fn(&[u8])) {
    let mut random = Random(7);
    let mut seeds: Vec<_> = std::fs::read_dir(format!("{FUZZ}/corpus/{target}"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    seeds.sort();
    assert!(!seeds.is_empty());
    for seed in seeds {
        let bytes = std::fs::read(seed).unwrap();
        check(&bytes);
        for _ in 0..changes {
            check(&random.change(&bytes));
        }
    }
}

#[test]
fn dynamics_files_of_any_content_are_read_or_refused() {
    let path = Path::new("no_folder/a.dynamics.toml");
    each("dynamics_file", 150, |bytes| {
        let text = String::from_utf8_lossy(bytes);
        match input::parse(&text, path) {
            Ok(input) => assert!(!input.model.system.nodes().is_empty()),
            Err(problems) => {
                let reported = problems.to_string();
                assert!(!reported.is_empty() && !reported.contains("no reason was noted"));
            }
        }
    });
    // The seeds themselves are right.
    for seed in ["strip", "rotor", "mechanism"] {
        let file = format!("{FUZZ}/corpus/dynamics_file/{seed}.dynamics.toml");
        let read = input::read(Path::new(&file));
        let reported = read.err().map(|problems| problems.to_string());
        assert_eq!(reported, None);
    }
}

#[test]
fn rotor_files_of_any_content_are_read_or_refused() {
    each("rotor_file", 300, |bytes| {
        let text = String::from_utf8_lossy(bytes);
        if let Err(problems) = input::parse_rotor(&text, "no_folder/a.rotor.toml") {
            let reported = problems.to_string();
            assert!(!reported.is_empty() && !reported.contains("no reason was noted"));
        }
    });
    for seed in ["turbine", "propeller"] {
        let file = format!("{FUZZ}/corpus/rotor_file/{seed}.rotor.toml");
        let read = input::read_rotor(Path::new(&file));
        let reported = read.err().map(|problems| problems.to_string());
        assert_eq!(reported, None);
    }
}

#[test]
fn expressions_of_any_content_are_read_or_refused() {
    let constants = [("p".to_owned(), 2.0)];
    let names = Names {
        variables: &["t", "x"],
        constants: &constants,
    };
    each("expression", 2000, |bytes| {
        match Expression::parse(&String::from_utf8_lossy(bytes), &names) {
            Ok(expression) => {
                for value in [-1.0, 0.0, 0.5, 1e300] {
                    let _ = expression.at(|_| Jet {
                        value,
                        first: 1.0,
                        second: 0.0,
                    });
                }
            }
            Err(problem) => assert!(!problem.to_string().is_empty()),
        }
    });
}

/// Ends a run after three steps.
struct Few(usize);

impl Recorder for Few {
    fn record(&mut self, _: &AcceptedStep<'_>) -> bool {
        self.0 += 1;
        self.0 < 3
    }
}

#[test]
fn restart_files_of_any_content_are_continued_or_refused() {
    let file = format!("{FUZZ}/support/strip.dynamics.toml");
    let input = input::read(Path::new(&file)).unwrap();
    let settings = input.transient.unwrap();
    let go = |snapshot: &Snapshot| {
        let fits = difference(&input.model, snapshot).is_none();
        if fits && snapshot.progress.time < settings.to {
            let _ = transient(
                &input.model,
                &settings,
                Some(snapshot),
                &mut Few(0),
                &|| 0.0,
            );
        }
        fits
    };
    let path = Path::new("a.restart.json");
    each("restart_file", 300, |bytes| {
        match parse_snapshot(bytes, path) {
            Ok(snapshot) => {
                go(&snapshot);
            }
            Err(problem) => assert!(!problem.to_string().is_empty()),
        }
    });
    let seed = std::fs::read(format!("{FUZZ}/corpus/restart_file/strip.restart.json"));
    assert!(go(&parse_snapshot(&seed.unwrap(), path).unwrap()));
}

#[test]
fn tables_of_any_content_are_read_or_refused() {
    each("time_table", 2000, |bytes| {
        let name = if bytes.starts_with(b"CDF") {
            "a.nc"
        } else {
            "a.csv"
        };
        match TimeTable::parse(bytes, Path::new(name)) {
            Ok(mut table) => {
                assert!(table.columns.iter().all(|own| own.len() == table.rows()));
                table.between(0.0, 1.0);
            }
            Err(problem) => assert!(!problem.to_string().is_empty()),
        }
    });
}
