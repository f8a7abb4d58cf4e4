//! Section-property files.

use shared_geom::section;

use crate::mutation::{Random, mutated};
use crate::{alone, seeds, within_memory};

const MUTATIONS: usize = 2000;

fn read(bytes: &[u8]) -> bool {
    let text = String::from_utf8_lossy(bytes);
    match section::parse(&text, "a.properties.json") {
        Ok(properties) => {
            // accepted files can be written and read again
            section::parse(&section::write(&properties), "again").unwrap();
            true
        }
        Err(problems) => {
            assert!(!problems.to_string().is_empty());
            false
        }
    }
}

#[test]
fn seeds_are_read_and_refused_when_cut() {
    let _alone = alone();
    for (name, bytes) in seeds("property_file") {
        assert!(within_memory(&name, &bytes, read), "{name}");
        for end in 0..bytes.trim_ascii_end().len() {
            let what = format!("{name} cut at byte {end}");
            assert!(!within_memory(&what, &bytes[..end], read), "{what}");
        }
    }
}

#[test]
fn changed_files_are_read_or_refused() {
    let _alone = alone();
    for (number, (name, bytes)) in seeds("property_file").into_iter().enumerate() {
        let mut random = Random::new(number as u64);
        for mutation in 0..MUTATIONS {
            let changed = mutated(&bytes, &mut random);
            within_memory(&format!("{name}, mutation {mutation}"), &changed, read);
        }
    }
}
