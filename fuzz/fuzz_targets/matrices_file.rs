//! Files of sections given by matrices, with the node table and the matrix of `support`.
#![no_main]

use std::path::Path;

use libfuzzer_sys::fuzz_target;
use section_analyzer::input::external;

/// Folder of the files that the seeds name.
const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/support/a.matrices.toml");

fuzz_target!(|text: &str| {
    // files outside of the folder are not tested here
    if !text.contains('/') && !text.contains("\\u") && !text.contains("..") {
        if let Err(problems) = external::parse(text, Path::new(FILE)) {
            assert!(!problems.to_string().is_empty());
        }
    }
});
