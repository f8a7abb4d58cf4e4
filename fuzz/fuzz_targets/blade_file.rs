//! Blade files, those of people and those of programs. What is accepted can be written,
//! and read again.
#![no_main]

use libfuzzer_sys::fuzz_target;
use shared_geom::blade;

fuzz_target!(|text: &str| {
    match blade::parse(text, "a.blade.toml") {
        Ok(reading) => assert!(blade::parse(&blade::write(&reading.blade), "again").is_ok()),
        Err(problems) => assert!(!problems.to_string().is_empty()),
    }
});
