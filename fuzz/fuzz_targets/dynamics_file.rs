//! Dynamics files, without the files that they may name.
#![no_main]

use std::path::Path;

use beam_dynamics::input;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    // files outside of the folder are not tested here
    let leaves = ["\"/", "'/", "\\u", ".."];
    if !leaves.iter().any(|part| text.contains(part)) {
        match input::parse(text, Path::new("no_folder/a.dynamics.toml")) {
            Ok(input) => assert!(!input.model.system.nodes().is_empty()),
            Err(problems) => {
                let reported = problems.to_string();
                assert!(!reported.is_empty() && !reported.contains("no reason was noted"));
            }
        }
    }
});
