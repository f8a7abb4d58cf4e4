//! Layup files, turbine files of windIO and sections of PreVABS; a section of each layup.
#![no_main]

use libfuzzer_sys::fuzz_target;
use section_analyzer::input::layup;

fuzz_target!(|text: &str| {
    // files outside of the folder are not tested here
    if text.contains("..") || text.contains("\\u") {
        return;
    }
    let ending = match text.trim_start().chars().next() {
        Some('<') => "xml",
        _ if text.contains("components:") => "yaml",
        _ => "layup.toml",
    };
    let name = format!("helicoid-fuzz-{}.{ending}", std::process::id());
    let path = std::env::temp_dir().join(name);
    if std::fs::write(&path, text).is_err() {
        return;
    }
    if let Err(problems) = layup::read(&path).and_then(|layup| layup.section(0.3)) {
        assert!(!problems.to_string().is_empty());
    }
});
