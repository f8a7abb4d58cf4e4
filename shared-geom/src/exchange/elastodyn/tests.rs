//! Blade files of ElastoDyn, with the numbers of a blade of 20 m.

use std::fs;

use crate::error::Diagnostics;
use crate::exchange::{Format, Options, Reading, read_with};

const BLADE: &str = include_str!("../../../../fuzz/corpus/blade_file/plain_ElastoDyn_blade.dat");
const PRIMARY: &str = include_str!("../../../../fuzz/corpus/blade_file/plain_ElastoDyn.dat");

/// Reads `a.dat` with this text, next to the sample blade file.
fn read(text: &str, length: Option<f64>) -> Result<Reading, Diagnostics> {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("plain_ElastoDyn_blade.dat"), BLADE).unwrap();
    let path = folder.path().join("a.dat");
    fs::write(&path, text).unwrap();
    let (format, reading) = read_with(
        &path,
        &Options {
            length,
            ..Options::default()
        },
    )?;
    assert_eq!(format, Format::ElastoDyn);
    Ok(reading)
}

fn refused(text: &str, length: Option<f64>) -> String {
    read(text, length).unwrap_err().to_string()
}

fn has(reading: &Reading, part: &str) -> bool {
    reading.remarks.iter().any(|remark| remark.contains(part))
}

// Its EA is a substitute of the reader, of any size, and its rotary inertia is zero: no unit is suspect. With
// a stiffness of its own, the same blade of a thousandth of the mass is.
#[test]
fn rigid_substitutes_make_no_unit_suspect() {
    for length in [20.0, 2.0] {
        let mut blade = read(BLADE, Some(length)).unwrap().blade;
        assert_eq!(blade.remarks(), Vec::<String>::new());
        // 1.2 times the substitute: far above 70 GPa over the density of any material.
        blade
            .stations
            .iter_mut()
            .for_each(|at| at.stiffness[(0, 0)] *= 1.2);
        assert!(blade.remarks()[0].contains("lighter than any material"));
    }
}

// Row 2: 0.4, twist 6 deg, 50 kg/m, 4e7, 9e7 N m^2; factors 1.1, 0.9, 1.2. Rigid: 1e6
// times the larger bending stiffness, 1.08e8, over 20^2, and 1e3 times it in torsion.
#[test]
fn rows_become_stations_with_factors_and_rigid_substitutes() {
    let reading = read(BLADE, Some(20.0)).unwrap();
    let blade = &reading.blade;
    assert!(blade.problems().is_empty(), "{:?}", blade.problems());
    assert_eq!(blade.stations.len(), 3);
    let station = blade.stations[1];
    assert!((station.arc_length - 8.0).abs() < 1e-14);
    let k = station.stiffness;
    let expected = [2.7e11, 2.7e11, 2.7e11, 1.08e11, 3.6e7, 1.08e8];
    for (i, expected) in expected.into_iter().enumerate() {
        assert!(
            (k[(i, i)] / expected - 1.0).abs() < 1e-14,
            "{i}: {}",
            k[(i, i)]
        );
    }
    let m = station.mass;
    assert!((m[(0, 0)] - 55.0).abs() < 1e-13 && m[(3, 3)] == 0.0);
    // Nose down in the file, nose up here; linear between the stations.
    let twist = blade.line.at(4.0).twist.to_degrees();
    assert!((twist + 9.0).abs() < 1e-13, "{twist}");
    for part in [
        "axial and shear stiffness is not in the file",
        "torsional stiffness is not in the file",
        "rotary inertia is not in the file",
        "flap 1 0.5 %, flap 2 0.6 %, edge 1 0.7 % of critical",
        "mode shapes of the file are not used",
        "FlStTunr",
    ] {
        assert!(has(&reading, part), "{part}: {:?}", reading.remarks);
    }
    assert!(reading.has_other_damping);
}

// The older table: axial and torsional stiffness and rotary inertia are used, the offset
// is not.
#[test]
fn older_tables_have_more_columns() {
    let text = BLADE
        .replace(
            "EdgStff\n",
            "EdgStff GJStff EAStff FlpIner EdgIner FlpcgOf\n",
        )
        .replace("8.0e7  8.0e7", "8.0e7  8.0e7 1e6 2e8 3 40 0.1")
        .replace("9.0e7", "9.0e7 1e6 2e8 3 40 0.1")
        .replace("1.0e6\n", "1.0e6 1e6 2e8 3 40 0.1\n");
    let reading = read(&text, Some(20.0)).unwrap();
    let station = reading.blade.stations[2];
    let k = station.stiffness;
    assert_eq!([k[(0, 0)], k[(3, 3)]], [2e8, 1e6]);
    let m = station.mass;
    assert_eq!([m[(4, 4)], m[(5, 5)], m[(3, 3)]], [3.0, 40.0, 43.0]);
    assert!(has(
        &reading,
        "columns EAStff, GJStff, FlpIner, EdgIner are read"
    ));
    assert!(has(&reading, "columns FlpcgOf are not read"));
    assert!(!has(&reading, "torsional stiffness is not"));
}

#[test]
fn the_primary_file_has_the_length() {
    let reading = read(PRIMARY, None).unwrap();
    let expected = read(BLADE, Some(20.0)).unwrap();
    assert_eq!(reading.blade.stations, expected.blade.stations);
    assert!(has(
        &reading,
        "length 20 m: TipRad less HubRad; the radius of the hub, 1.5 m"
    ));
    let message = refused(&PRIMARY.replace("21.5", "1.2"), None);
    assert!(
        message.contains("TipRad - HubRad, the length of the blade: found -0.3"),
        "{message}"
    );
    let message = refused(&PRIMARY.replace("_blade.dat", "_blad.dat"), None);
    assert!(
        message.contains("did you mean \"plain_ElastoDyn_blade.dat\"?"),
        "{message}"
    );
}

#[test]
fn wrong_blade_files_are_refused_with_their_line() {
    for (from, to, length, expected) in [
        ("x", "x", None, "give the primary file of ElastoDyn"),
        ("3  NBl", "4  NBl", Some(20.0), "after 3 of 4 rows"),
        (
            "3  NBl",
            "x  NBl",
            Some(20.0),
            "NBlInpSt: found \"x\", expected a whole number",
        ),
        (
            "4.0e7",
            "4.0e7z",
            Some(20.0),
            "station 2: expected a finite number",
        ),
        (
            "FlpStff",
            "Flapp",
            Some(20.0),
            "the column \"FlpStff\" is missing",
        ),
        (
            "BlFract",
            "Fract",
            Some(20.0),
            "the table of distributed properties is missing",
        ),
        ("0.4 ", "0.0 ", Some(20.0), "BlFract of station 2 is 0"),
        (
            "1.0  0.25",
            "0.9  0.25",
            Some(20.0),
            "found 0.9, expected 1",
        ),
        (
            "1.1  Adj",
            "-  Adj",
            Some(20.0),
            "AdjBlMs: expected a finite number, found \"-\"",
        ),
    ] {
        let changed = BLADE.replace(from, to);
        let message = refused(&changed, length);
        assert!(message.contains(expected), "{expected} in {message}");
    }
}
