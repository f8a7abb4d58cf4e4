//! Files of the aerodynamic geometry of blades and propellers, by their content.
#![no_main]

use std::path::Path;

use libfuzzer_sys::fuzz_target;
use rotor_aero::airfoil::files::blade::{BladeOptions, parse_blade};

fuzz_target!(|text: &str| {
    let options = BladeOptions { radius: Some(1.0), ..BladeOptions::default() };
    match parse_blade(text, Path::new("a.dat"), &options) {
        Ok(blade) => assert!(!blade.stations.is_empty()),
        Err(problems) => assert!(!problems.to_string().is_empty()),
    }
});
