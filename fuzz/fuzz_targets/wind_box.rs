//! Turbulence boxes: files of Bladed by their identification, else of TurbSim. The planes of a
//! box that is read are read too.
#![no_main]

use std::path::PathBuf;
use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;
use rotor_aero::wind::{BladedInput, read_bladed, read_bts};

/// The two first bytes of files of Bladed.
const BLADED: [u8; 2] = (-99_i16).to_le_bytes();

/// A file of this process.
static FILE: LazyLock<PathBuf> = LazyLock::new(|| {
    std::env::temp_dir().join(format!("helicoid-box-{}", std::process::id()))
});

fuzz_target!(|bytes: &[u8]| {
    std::fs::write(&*FILE, bytes).expect("a writable folder");
    let read = if bytes.starts_with(&BLADED) { read_bladed(&FILE, &BladedInput::default()) } else { read_bts(&FILE, None) };
    match read {
        Ok(turbulence) => {
            let _ = turbulence.velocity(&[0.0, 0.0, 10.0], 0.0);
            let _ = turbulence.plane(turbulence.grid().planes - 1);
        }
        Err(problems) => assert!(!problems.to_string().is_empty()),
    }
});
