//! Blades through the files of other tools and back: the modes stay what they were.

use std::fs;
use std::path::Path;

use nalgebra::Vector2;
use shared_geom::blade::{self, Blade};
use shared_geom::exchange::{self, Format};

use crate::case_files::{Case, table};
use crate::record;

const SOURCE: &str = "The blade before it was written";
/// The wind-turbine blades in `cases/dynamics`.
const BLADES: [&str; 2] = ["nrel5mw", "iea15"];
const COUNT: usize = 8;

/// The blade of a case.
pub fn blade_of(case: &str) -> Blade {
    let case_files = Case::new(case);
    let path = case_files.path(&format!("{case}.blade.toml"));
    exchange::read(&path)
        .unwrap_or_else(|e| panic!("{e}"))
        .blade
}

/// The lowest frequencies of a blade, clamped and at rest \[Hz\], with further keys of
/// the card.
pub fn frequencies(blade: &Blade, keys: &str) -> Vec<f64> {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.blade.json"), blade::write(blade)).unwrap();
    let file = folder.path().join("a.dynamics.toml");
    let text = format!(
        "units = \"SI\"\n[[blade]]\nname = \"b\"\nfile = \"a.blade.json\"\n{keys}\n\
         [modes]\nspeeds = [0]\ncount = {COUNT}\n"
    );
    fs::write(&file, text).unwrap();
    let modes = table(&file);
    let found = modes.at_speed(0);
    let found: Vec<_> = found.iter().map(|mode| mode.1.frequency).collect();
    assert_eq!(found.len(), COUNT);
    found
}

/// Largest relative difference of two sets of frequencies.
fn difference(found: &[f64], expected: &[f64]) -> f64 {
    let pairs = found.iter().zip(expected);
    pairs.map(|(a, b)| (a / b - 1.0).abs()).fold(0.0, f64::max)
}

/// Writes a blade, reads it back, and gives what its format could not carry too.
fn there_and_back(blade: &Blade, format: Format) -> (Blade, Vec<String>) {
    let folder = tempfile::tempdir().unwrap();
    let writing = exchange::write(blade, format, "blade").unwrap();
    for (name, text) in &writing.files {
        fs::write(folder.path().join(name), text).unwrap();
    }
    let reading = exchange::read(&folder.path().join(first(&writing.files)));
    let reading = reading.unwrap_or_else(|e| panic!("{}: {e}", format.name()));
    (reading.blade, writing.lost)
}

fn first(files: &[(std::path::PathBuf, String)]) -> &Path {
    &files[0].0
}

#[test]
fn formats_debug() {
    for name in BLADES {
        let blade = blade_of(name);
        let expected = frequencies(&blade, "");
        println!("{name} {expected:?}");
        for format in Format::ALL {
            if !format.is_written() || !format.is_read() {
                println!("{} not", format.name());
                continue;
            }
            let folder = tempfile::tempdir().unwrap();
            let writing = exchange::write(&blade, format, "blade").unwrap();
            for (name, text) in &writing.files {
                fs::write(folder.path().join(name), text).unwrap();
            }
            let names: Vec<_> = writing
                .files
                .iter()
                .map(|f| f.0.display().to_string())
                .collect();
            println!("{}: {names:?} lost {:?}", format.name(), writing.lost);
            match exchange::read(&folder.path().join(first(&writing.files))) {
                Err(e) => println!("   {e}"),
                Ok(reading) => {
                    let found = frequencies(&reading.blade, "");
                    println!(
                        "   {:e} {:?}",
                        difference(&found, &expected),
                        reading.remarks
                    );
                }
            }
        }
        let writing = exchange::write(&blade, Format::MbDyn, "blade").unwrap();
        let found = crate::mbdyn_model::frequencies(&writing.files[0].1, COUNT);
        println!(
            "mbdyn {:e} {:?} {found:?}",
            difference(&found, &expected),
            writing.lost
        );
        for by in [Vector2::new(0.3, -0.2), Vector2::new(-1.0, 0.5)] {
            println!(
                "shift {:e}",
                difference(&frequencies(&blade.shift(by), ""), &expected)
            );
        }
        for angle in [0.2, -1.5] {
            println!(
                "rotate {:e}",
                difference(&frequencies(&blade.rotate(angle), ""), &expected)
            );
        }
        let lumped = frequencies(&blade, "inertia = \"lumped\"");
        println!("lumped {:e} {lumped:?}", difference(&lumped, &expected));
    }
}
