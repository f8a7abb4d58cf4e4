//! Section files of any content are read, or told what is wrong with them.
//!
//! The seeds are those of the fuzz target, `fuzz/corpus/section_file`, with the mesh
//! and the table of `fuzz/support`; mutations come from a fixed seed.

use std::path::{Path, PathBuf};

use section_analyzer::input;

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
    let names = ["laminate.section.toml", "steel.section.toml"];
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
            match read(&String::from_utf8_lossy(&changed)) {
                true => good += 1,
                false => bad += 1,
            }
        }
    }
    println!("{good} read, {bad} refused");
    // neither all nor none: most changes break a file, some do not
    assert!(good > 10 && bad > good);
}
