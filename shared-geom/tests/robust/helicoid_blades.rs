//! Blade files: written by people, in TOML, and by programs, in JSON.

use shared_geom::blade;

use crate::mutation::{Random, mutated};
use crate::{alone, seeds};

const MUTATIONS: usize = 1000;

/// The seeds of Helicoid's formats.
fn own_seeds() -> impl Iterator<Item = (String, Vec<u8>)> {
    let is_own = |name: &str| name.ends_with(".blade.toml") || name.ends_with(".blade.json");
    let seeds = seeds("blade_file").into_iter();
    seeds.filter(move |(name, _)| is_own(name))
}

fn read(bytes: &[u8]) -> bool {
    let text = String::from_utf8_lossy(bytes);
    match blade::parse(&text, "a.blade.toml") {
        Ok(reading) => {
            // accepted files can be written and read again
            let again = blade::parse(&blade::write(&reading.blade), "again").unwrap();
            assert_eq!(again.blade, reading.blade);
            true
        }
        Err(problems) => {
            assert!(!problems.to_string().is_empty());
            false
        }
    }
}

// A text in TOML that is cut within its last number is still TOML.
#[test]
fn seeds_are_read_and_those_of_programs_refused_when_cut() {
    let _alone = alone();
    for (name, bytes) in own_seeds() {
        assert!(read(&bytes), "{name}");
        for end in 0..bytes.trim_ascii_end().len() {
            let is_read = read(&bytes[..end]);
            assert!(!is_read || name.ends_with(".toml"), "{name} cut at {end}");
        }
    }
}

#[test]
fn changed_files_are_read_or_refused() {
    let _alone = alone();
    for (number, (_, bytes)) in own_seeds().enumerate() {
        let mut random = Random::new(number as u64);
        for _ in 0..MUTATIONS {
            read(&mutated(&bytes, &mut random));
        }
    }
}
