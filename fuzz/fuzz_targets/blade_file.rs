//! Blade files of all formats, recognized from their content. A blade that is read
//! without a problem can be written in all formats.
#![no_main]

use std::path::Path;

use libfuzzer_sys::fuzz_target;
use shared_geom::exchange::{Format, Options, parse, write};

fuzz_target!(|text: &str| {
    let options = Options { length: Some(3.0), ..Options::default() };
    match parse(text, Path::new("no_folder/a"), &options) {
        Ok((_, reading)) if reading.blade.problems().is_empty() => {
            for format in Format::ALL.into_iter().filter(|format| format.is_written()) {
                assert!(write(&reading.blade, format, "again").is_ok());
            }
        }
        Ok(_) => {}
        Err(problems) => {
            let reported = problems.to_string();
            assert!(!reported.is_empty() && !reported.contains("no reason was noted"));
        }
    }
});
