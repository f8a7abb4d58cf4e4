//! Tables of runs in time: NetCDF files by their first letters, else text.
#![no_main]

use std::path::Path;

use beam_dynamics::output::TimeTable;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let name = if bytes.starts_with(b"CDF") { "a.nc" } else { "a.csv" };
    match TimeTable::parse(bytes, Path::new(name)) {
        Ok(mut table) => {
            assert!(table.columns.iter().all(|own| own.len() == table.rows()));
            table.between(0.0, 1.0);
        }
        Err(problem) => assert!(!problem.to_string().is_empty()),
    }
});
