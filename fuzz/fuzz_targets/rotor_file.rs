//! Rotor files, without the files that they may name.
#![no_main]

use beam_dynamics::input::parse_rotor;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    // files outside of the folder are not tested here
    let leaves = ["\"/", "'/", "\\u", ".."];
    if !leaves.iter().any(|part| text.contains(part)) {
        if let Err(problems) = parse_rotor(text, "no_folder/a.rotor.toml") {
            let reported = problems.to_string();
            assert!(!reported.is_empty() && !reported.contains("no reason was noted"));
        }
    }
});
