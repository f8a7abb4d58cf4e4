//! Files of blade sections to be meshed, without the airfoil files that they may name.
#![no_main]

use std::path::Path;

use libfuzzer_sys::fuzz_target;
use section_analyzer::input::blade;

fuzz_target!(|text: &str| {
    // files outside of the folder are not tested here
    if !text.contains('/') && !text.contains("\\u") && !text.contains("..") {
        match blade::parse(text, Path::new("no_folder/a.blade.toml")) {
            Ok(input) => assert!(!input.mesh.cells.is_empty()),
            Err(problems) => assert!(!problems.to_string().is_empty()),
        }
    }
});
