//! Files of any content: each is read, or refused with a message. The seeds are the corpus of
//! the fuzz targets; changes come from a fixed seed.

// A failed unwrap fails the test, with its line.
#![allow(clippy::unwrap_used)]

use std::path::{Path, PathBuf};

use rotor_aero::airfoil::files::blade::{BladeOptions, parse_blade};
use rotor_aero::airfoil::files::{Options, parse};
use rotor_aero::wind::{BladedInput, TurbulenceBox, read_bladed, read_bts};
use shared_geom::error::Diagnostics;

#[path = "../../shared-geom/tests/robust/mutation.rs"]
mod mutation;

use mutation::{Random, mutated};

/// Calls `read` with each seed of a target, which must be right, and with `changes` changes of
/// each, of which some must be right and some wrong; the messages of wrong ones are checked.
fn each(target: &str, changes: usize, read: impl Fn(&Path, &[u8]) -> Result<(), Diagnostics>) {
    let folder = format!("{}/../fuzz/corpus/{target}", env!("CARGO_MANIFEST_DIR"));
    let entries = std::fs::read_dir(folder).unwrap();
    let mut seeds: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    seeds.sort();
    let mut random = Random::new(11);
    let mut counts = [0; 2];
    for seed in &seeds {
        let bytes = std::fs::read(seed).unwrap();
        let reported = read(seed, &bytes)
            .err()
            .map(|problems| problems.to_string());
        assert_eq!(reported, None, "{}", seed.display());
        for _ in 0..changes {
            match read(seed, &mutated(&bytes, &mut random)) {
                Ok(()) => counts[0] += 1,
                Err(problems) => {
                    let reported = problems.to_string();
                    assert!(!reported.is_empty() && !reported.contains("no reason was noted"));
                    counts[1] += 1;
                }
            }
        }
    }
    assert!(
        counts.iter().all(|count| *count > changes / 20),
        "{counts:?}"
    );
}

#[test]
fn airfoil_files_of_any_content_are_read_or_refused() {
    each("airfoil_file", 400, |path, bytes| {
        let text = String::from_utf8_lossy(bytes);
        let reading = parse(&text, path, &Options::default())?;
        assert!(!reading.airfoils.is_empty());
        Ok(())
    });
}

#[test]
fn aerodynamic_blades_of_any_content_are_read_or_refused() {
    let options = BladeOptions {
        radius: Some(1.0),
        ..BladeOptions::default()
    };
    each("aero_blade_file", 400, |path, bytes| {
        let text = String::from_utf8_lossy(bytes);
        let blade = parse_blade(&text, path, &options)?;
        assert!(!blade.stations.is_empty());
        Ok(())
    });
}

/// Reads some velocities and the last plane of a box.
fn look(turbulence: &TurbulenceBox) {
    for time in [0.0, 1.0] {
        let _ = turbulence.velocity(&[0.0, 0.0, 10.0], time);
    }
    let _ = turbulence.plane(turbulence.grid().planes - 1);
}

#[test]
fn wind_boxes_of_any_content_are_read_or_refused() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("box");
    each("wind_box", 600, |path, bytes| {
        std::fs::write(&file, bytes).unwrap();
        let turbulence = match path.extension() {
            Some(ending) if ending == "wnd" => read_bladed(&file, &BladedInput::default())?,
            _ => read_bts(&file, None)?,
        };
        look(&turbulence);
        Ok(())
    });
}
