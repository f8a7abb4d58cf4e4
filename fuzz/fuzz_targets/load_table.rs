//! Tables of loads along a blade: a row for each position, an envelope, or a row for each time.
#![no_main]

use libfuzzer_sys::fuzz_target;
use section_analyzer::input::span_loads::{LoadPositions, read_loads};

fuzz_target!(|bytes: &[u8]| {
    let name = format!("helicoid-fuzz-{}.csv", std::process::id());
    let path = std::env::temp_dir().join(name);
    if std::fs::write(&path, bytes).is_err() {
        return;
    }
    let columns = vec![("root".to_owned(), 0.0), ("tip".to_owned(), 1.0)];
    for named in [Vec::new(), columns] {
        let positions = LoadPositions {
            length: 2.0,
            member: None,
            named,
        };
        match read_loads(&path, &positions) {
            Ok(loads) => assert!(loads.instants.iter().all(|one| !one.points.is_empty())),
            Err(problems) => assert!(!problems.to_string().is_empty()),
        }
    }
});
