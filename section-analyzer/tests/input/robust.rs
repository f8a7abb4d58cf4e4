//! Section files of any content are read, or their problems reported.
//!
//! The seeds are the corpus of the fuzz target, `fuzz/corpus/section_file`, with the mesh
//! and the table of `fuzz/support`; mutations come from a fixed seed.

use std::path::{Path, PathBuf};

use section_analyzer::input::span_loads::{LoadPositions, read_loads};
use section_analyzer::input::{self, blade, external, layup};

use crate::mutation::{Random, mutated};

const FUZZ: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../fuzz");
const MUTATIONS: usize = 2000;

/// Whether the text is a section that can be read.
fn read(text: &str) -> bool {
    let path: PathBuf = [FUZZ, "support", "a.section.toml"].iter().collect();
    match input::parse(text, &path) {
        Ok(input) => {
            assert_eq!(input.section.cells.len(), input.section.mesh.cells.len());
            true
        }
        Err(problems) => {
            assert!(!problems.to_string().is_empty());
            false
        }
    }
}

fn seeds() -> Vec<String> {
    let folder = Path::new(FUZZ).join("corpus/section_file");
    let names = [
        "laminate.section.toml",
        "piezo.section.toml",
        "steel.section.toml",
    ];
    let seeds = names.map(|name| std::fs::read_to_string(folder.join(name)).unwrap());
    seeds.to_vec()
}

#[test]
fn section_files_cut_anywhere_are_no_cause_for_panic() {
    for text in seeds() {
        assert!(read(&text));
        for end in 0..text.len() {
            read(&text[..end]);
        }
    }
}

#[test]
fn changed_section_files_are_read_or_refused() {
    let (mut good, mut bad) = (0, 0);
    for (number, text) in seeds().into_iter().enumerate() {
        let mut random = Random::new(number as u64);
        for _ in 0..MUTATIONS {
            let changed = mutated(text.as_bytes(), &mut random);
            if read(&String::from_utf8_lossy(&changed)) {
                good += 1
            } else {
                bad += 1
            }
        }
    }
    println!("{good} read, {bad} refused");
    // neither all nor none: most changes make a file invalid, some do not
    assert!(good > 10 && bad > good);
}

/// The files of a section given by its matrices: matrices file, node table, matrix.
const GIVEN: [&str; 3] = ["a.matrices.toml", "nodes.csv", "k.mtx"];

/// Each of the three files of `support`, changed a thousand times with the others
/// unchanged.
#[test]
fn changed_files_of_matrices_are_read_or_refused() {
    let support = Path::new(FUZZ).join("support");
    let folder = tempfile::tempdir().unwrap();
    let position = |name: &str| folder.path().join(name);
    let sound = GIVEN.map(|name| std::fs::read(support.join(name)).unwrap());
    let write = |index: usize, bytes: &[u8]| std::fs::write(position(GIVEN[index]), bytes).unwrap();
    (0..3).for_each(|index| write(index, &sound[index]));
    let read = || match external::read(&position(GIVEN[0])) {
        Ok(input) => {
            assert_eq!(input.section.tags.len(), input.section.nodes.len());
            true
        }
        Err(problems) => {
            assert!(!problems.to_string().is_empty());
            false
        }
    };
    assert!(read());
    for (index, text) in sound.iter().enumerate() {
        let mut random = Random::new(index as u64);
        let (mut good, mut bad) = (0, 0);
        for _ in 0..MUTATIONS / 2 {
            write(index, &mutated(text, &mut random));
            if read() { good += 1 } else { bad += 1 }
        }
        println!("{}: {good} read, {bad} refused", GIVEN[index]);
        assert!(good > 10 && bad > 10);
        write(index, text);
    }
}

/// The text of a seed.
fn seed(target: &str, name: &str) -> String {
    let path: PathBuf = [FUZZ, "corpus", target, name].iter().collect();
    std::fs::read_to_string(path).unwrap()
}

#[test]
fn changed_blade_files_are_meshed_or_refused() {
    let path = Path::new("a.blade.toml");
    let text = seed("blade_mesh_file", "box.blade.toml");
    let (mut good, mut bad) = (0, 0);
    let mut read = |text: &str| match blade::parse(text, path) {
        Ok(input) => {
            assert!(!input.mesh.cells.is_empty() && !input.regions.is_empty());
            good += 1;
        }
        Err(problems) => {
            assert!(!problems.to_string().is_empty());
            bad += 1;
        }
    };
    for end in 0..=text.len() {
        read(&text[..end]);
    }
    let mut random = Random::new(7);
    for _ in 0..MUTATIONS {
        let changed = mutated(text.as_bytes(), &mut random);
        read(&String::from_utf8_lossy(&changed));
    }
    println!("{good} meshed, {bad} refused");
    assert!(good > 10 && bad > good);
}

/// Changes of one layup or table of loads.
const FEW: usize = 500;

/// Reads `text`, cut anywhere and changed, by `read`; returns how many are read and refused.
fn survivors(text: &str, mut read: impl FnMut(&[u8]) -> bool) -> [usize; 2] {
    assert!(read(text.as_bytes()));
    let mut counts = [0; 2];
    let mut count = |bytes: &[u8]| counts[usize::from(!read(bytes))] += 1;
    for end in (0..text.len()).step_by(7) {
        count(&text.as_bytes()[..end]);
    }
    let mut random = Random::new(11);
    for _ in 0..FEW {
        count(&mutated(text.as_bytes(), &mut random));
    }
    counts
}

/// Layup files, turbine files of windIO and sections of PreVABS.
#[test]
fn changed_layups_are_read_or_refused() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["rotor_blade.layup.toml", "tube.windio.yaml", "pipe.xml"] {
        let path = folder.path().join(name);
        let [good, bad] = survivors(&seed("layup_file", name), |bytes| {
            std::fs::write(&path, bytes).unwrap();
            match layup::read(&path).and_then(|layup| layup.section(0.3)) {
                Ok(_) => true,
                Err(problems) => {
                    assert!(!problems.to_string().is_empty());
                    false
                }
            }
        });
        println!("{name}: {good} read, {bad} refused");
        assert!(good > 10 && bad > 10, "{name}: {good} read, {bad} refused");
    }
}

/// Tables with a row for each position and instant, with a row for each time, and of envelopes.
#[test]
fn changed_tables_of_loads_are_read_or_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.csv");
    let named = vec![("root".to_owned(), 0.0), ("tip".to_owned(), 1.0)];
    for (name, named) in [
        ("long.csv", Vec::new()),
        ("envelope.csv", Vec::new()),
        ("wide.csv", named),
    ] {
        let positions = LoadPositions {
            length: 2.0,
            member: None,
            named,
        };
        let [good, bad] = survivors(&seed("load_table", name), |bytes| {
            std::fs::write(&path, bytes).unwrap();
            match read_loads(&path, &positions) {
                Ok(loads) => {
                    let instants = loads.instants;
                    assert!(instants.iter().all(|instant| !instant.points.is_empty()));
                    true
                }
                Err(problems) => {
                    assert!(!problems.to_string().is_empty());
                    false
                }
            }
        });
        println!("{name}: {good} read, {bad} refused");
        assert!(good > 10 && bad > 10, "{name}: {good} read, {bad} refused");
    }
}
