//! Structural files of QBlade.

use std::fs;

use crate::blade::BladeDamping;
use crate::error::Diagnostics;
use crate::exchange::{Format, Options, Reading, read_with};

const BLADE: &str = include_str!("../../../../fuzz/corpus/blade_file/plain_blade.str");

fn read(name: &str, text: &str, length: Option<f64>) -> Result<Reading, Diagnostics> {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("plain_blade.str"), BLADE).unwrap();
    let path = folder.path().join(name);
    fs::write(&path, text).unwrap();
    let (format, reading) = read_with(
        &path,
        &Options {
            length,
            ..Options::default()
        },
    )?;
    assert_eq!(format, Format::QBlade);
    Ok(reading)
}

// STIFFTUNER 0.5, MASSTUNER 2. The file's x is our z, its y our -y: edge bending 1.9e7 is
// our 6th, flap 3.7e6 our 5th; the mass center 0.11 to the trailing edge, 0.03 up.
#[test]
fn matrices_are_in_the_axes_of_beamdyn() {
    let reading = read("a.str", BLADE, Some(8.0)).unwrap();
    let blade = &reading.blade;
    assert!(blade.problems().is_empty(), "{:?}", blade.problems());
    let root = blade.stations[0];
    let diagonal: Vec<_> = (0..6).map(|i| 2.0 * root.stiffness[(i, i)]).collect();
    assert_eq!(diagonal, [9.1e8, 1.7e8, 1.3e8, 2.3e6, 3.7e6, 1.9e7]);
    let m = root.mass / 20.0;
    for (entry, expected) in [((0, 4), 0.03), ((0, 5), 0.11), ((4, 4), 0.1), ((5, 5), 0.5)] {
        assert!(
            (m[entry] - expected).abs() < 1e-15,
            "{entry:?}: {}",
            m[entry]
        );
    }
    // Axial, edge shear, flap shear, torsion, flap, edge.
    let times = [0.0001, 0.003, 0.004, 0.0003, 0.004, 0.003];
    assert_eq!(blade.damping, Some(BladeDamping::Times(times)));
    assert_eq!(blade.stations[1].arc_length, 4.0);
    assert!(
        reading
            .remarks
            .iter()
            .any(|remark| remark.starts_with("1 point masses"))
    );
}

#[test]
fn a_main_file_leads_to_the_blade_and_one_time_is_proportional() {
    let main = "3 NUMBLD - Number of blades\nplain_blade.str BLDFILE_1 - the blade\n";
    let blade = read("main.str", main, Some(8.0)).unwrap().blade;
    assert_eq!(
        blade.stations,
        read("a.str", BLADE, Some(8.0)).unwrap().blade.stations
    );
    let text = BLADE.replace(
        "0.004 0.003 0.0003 0.0001 0.0 RAYLEIGHDMP_ANISO",
        "0.002 RAYLEIGHDMP",
    );
    let damping = read("a.str", &text, Some(8.0)).unwrap().blade.damping;
    assert_eq!(damping, Some(BladeDamping::Proportional(0.002)));
}

#[test]
fn wrong_files_are_refused() {
    for (from, to, length, expected) in [
        ("x", "x", None, "give --length METERS"),
        (
            "K11",
            "EIx",
            Some(8.0),
            "BEAMTYPE: found \"2\", expected 0 or 1",
        ),
        (
            "5.0000e-01 0 0 0",
            "5.0000e-01 0 0.1 0",
            Some(8.0),
            "XCB, YCB and PITCH of station 2",
        ),
        (
            "5.0000e-01 0 0 0",
            "5.0000e-01 0 0",
            Some(8.0),
            "station 2: expected 46 numbers, found 45",
        ),
        (
            "5.0000e-01",
            "-1.0",
            Some(8.0),
            "position of station 2 is -1",
        ),
        (
            "2.0\tMASS",
            "heavy\tMASS",
            Some(8.0),
            "MASSTUNER: expected a finite number",
        ),
        (
            "0.003 0.0003 0.0001 0.0 RAY",
            "0.003 RAY",
            Some(8.0),
            "RAYLEIGHDMP_ANISO: expected 4 numbers, found 2",
        ),
    ] {
        let message = read("a.str", &BLADE.replace(from, to), length)
            .unwrap_err()
            .to_string();
        assert!(message.contains(expected), "{expected} in {message}");
    }
}
