//! Files of airfoil tables of all formats, by their content.
#![no_main]

use std::path::Path;

use libfuzzer_sys::fuzz_target;
use rotor_aero::airfoil::files::{Options, parse};

fuzz_target!(|text: &str| {
    match parse(text, Path::new("a.dat"), &Options::default()) {
        Ok(reading) => assert!(!reading.airfoils.is_empty()),
        Err(problems) => assert!(!problems.to_string().is_empty()),
    }
});
