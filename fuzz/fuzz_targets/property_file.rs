//! Section-property files. Accepted files can be written, and read again.
#![no_main]

use libfuzzer_sys::fuzz_target;
use shared_geom::section;

fuzz_target!(|text: &str| {
    match section::parse(text, "a.properties.json") {
        Ok(properties) => assert!(section::parse(&section::write(&properties), "again").is_ok()),
        Err(problems) => assert!(!problems.to_string().is_empty()),
    }
});
