//! Blades of a structural table and a geometry.

use std::fs;

use nalgebra::Vector3;

use crate::blade::BladeDamping;
use crate::error::Diagnostics;
use crate::exchange::{Format, Options, Reading, read_with};
use crate::section::Centers;

const TABLE: &str = include_str!("../../../../fuzz/corpus/blade_file/beam.str");
const GEOMETRY: &str = include_str!("../../../../fuzz/corpus/blade_file/beam.bld");
const MATRICES: &str = include_str!("../../../../fuzz/corpus/blade_file/plain_blade.str");
const MAIN: &str = "3 NUMBLD - Number of blades\nbeam.str BLDFILE_1 - the blade\n";
const TURBINE: &str = "beam.bld BLADEFILE - geometry\n0 ROTATIONALDIR - direction\n\
                       main.str STRUCTURALFILE - structure\n";

/// Length of the line: 4 m along the axis, then 4 m with offsets of 0.3 and 0.4 m.
fn length() -> f64 {
    4.0 + 16.25_f64.sqrt()
}

/// Reads the first of some files.
fn read(files: &[(&str, &str)]) -> Result<Reading, Diagnostics> {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        fs::write(folder.path().join(name), text).unwrap();
    }
    let path = folder.path().join(files[0].0);
    let (format, reading) = read_with(&path, &Options::default())?;
    assert_eq!(format, Format::QBlade);
    Ok(reading)
}

fn pair() -> Reading {
    read(&[("beam.str", TABLE), ("beam.bld", GEOMETRY)]).unwrap_or_else(|all| panic!("{all}"))
}

fn near(found: f64, expected: f64) {
    let error = (found - expected).abs();
    assert!(
        error < 1e-12 * expected.abs().max(1.0),
        "{found} {expected}"
    );
}

// Chord 2 m at the root: centers 0.2, 0.3 and 0.1 m to the trailing edge, which is our -y; radii
// of gyration 0.2 and 0.6 m about the elastic center. STIFFTUNER 2.
#[test]
fn centers_and_radii_are_parts_of_the_chord() {
    let reading = pair();
    let blade = &reading.blade;
    assert!(blade.problems().is_empty(), "{:?}", blade.problems());
    let root = blade.stations[0];
    let (k, m) = (root.stiffness / 2.0, root.mass);
    let centers = Centers::of(&k, &m).unwrap();
    for (center, y) in [
        (centers.tension, -0.3),
        (centers.shear, -0.1),
        (centers.mass, -0.2),
    ] {
        near(center.x, y);
        near(center.y, 0.0);
    }
    for (i, expected) in [
        (0, 1.0e9),
        (1, 0.5 * 4.0e8),
        (2, 0.25 * 4.0e8),
        (3, 1.0e6 + 0.25 * 4.0e8 * 0.01),
        (4, 3.0e6),
        (5, 5.0e7 + 1.0e9 * 0.09),
    ] {
        near(k[(i, i)], expected);
    }
    // About the mass center 20 (0.6^2 - 0.1^2), to which the line adds 20 times 0.2^2.
    near(m[(4, 4)], 20.0 * 0.04);
    near(m[(5, 5)], 20.0 * (0.36 - 0.01 + 0.04));
    assert_eq!(blade.damping, Some(BladeDamping::Proportional(0.002)));
}

#[test]
fn the_chord_is_linear_between_the_sections() {
    let blade = pair().blade;
    let middle = blade.stations[1];
    near(middle.arc_length, 0.5 * length());
    // Beyond the second section, whose chord is 4 m.
    let chord = 4.0 - 3.0 * (0.5 * length() - 4.0) / 16.25_f64.sqrt();
    near(middle.mass[(4, 4)], 10.0 * (0.1 * chord).powi(2));
    near(blade.stations[2].mass[(4, 4)], 5.0 * 0.01);
}

// BeamDyn's axes in ours: x upper side, y trailing edge (our -y), z to the tip (our x); the twist
// is nose down. Between straight pieces the tangent is the mean, which turns BeamDyn's axes by
// the product of two small angles.
#[test]
fn the_line_has_offsets_and_twist() {
    let reading = pair();
    let line = &reading.blade.line;
    let tip = line.points[2].position;
    assert!((tip - Vector3::new(8.0, -0.3, 0.4)).norm() < 1e-14, "{tip}");
    near(line.length(), length());
    let twists: Vec<_> = line
        .points
        .iter()
        .map(|point| point.twist.to_degrees())
        .collect();
    near(twists[0], -10.0);
    assert!((twists[1] + 5.0).abs() < 0.5, "{twists:?}");
    let hub = "its first section is at 1.5 m";
    assert!(reading.remarks.iter().any(|remark| remark.contains(hub)));
}

#[test]
fn euler_beams_are_rigid_in_shear_and_rows_may_have_their_damping() {
    let text = TABLE.replace("1 BEAMTYPE", "0 BEAMTYPE");
    let reading = read(&[("beam.str", &text), ("beam.bld", GEOMETRY)]).unwrap();
    let k = reading.blade.stations[0].stiffness / 2.0;
    near(k[(1, 1)], 1e6 * 5.0e7 / length().powi(2));
    assert!(
        reading
            .remarks
            .iter()
            .any(|remark| remark.contains("rigid in shear"))
    );
    // Without the type, the shear stiffness decides.
    let open = TABLE.replace("1 BEAMTYPE", "1 BEAM");
    let reading = read(&[("beam.str", &open), ("beam.bld", GEOMETRY)]).unwrap();
    near(reading.blade.stations[0].stiffness[(1, 1)], 4.0e8);
    let damped = TABLE
        .replace("YCS_[-]", "YCS_[-] DAMP_[-]")
        .replace("0.05 0\n", "0.05 0 0.003\n");
    let blade = read(&[("beam.str", &damped), ("beam.bld", GEOMETRY)])
        .unwrap()
        .blade;
    let expected = blade
        .stations
        .iter()
        .map(|station| station.stiffness * 0.003)
        .collect();
    assert_eq!(blade.damping, Some(BladeDamping::Viscous(expected)));
}

#[test]
fn every_file_leads_to_the_same_blade() {
    let expected = pair().blade;
    let files = [
        ("beam.str", TABLE),
        ("beam.bld", GEOMETRY),
        ("main.str", MAIN),
    ];
    let tower = TABLE.replace("YCS_[-]", "YCS_[-] DIA_[m] CD_[-]");
    let ways: [&[(&str, &str)]; 4] = [
        &[files[1], files[0], files[2]],
        &[("turbine.trb", TURBINE), files[0], files[1], files[2]],
        &[files[2], files[0], files[1]],
        // Other names, each the only one of its kind: a tower is no blade.
        &[("other.bld", GEOMETRY), files[0], ("tower.str", &tower)],
    ];
    for way in ways {
        let blade = read(way).unwrap_or_else(|all| panic!("{all}")).blade;
        assert_eq!(blade.stations, expected.stations, "{}", way[0].0);
        assert_eq!(blade.line, expected.line);
    }
    // Matrices take the line of a geometry.
    let blade = read(&[("a.str", MATRICES), ("a.bld", GEOMETRY)])
        .unwrap()
        .blade;
    assert_eq!(blade.line, expected.line);
}

#[test]
fn wrong_pairs_are_refused() {
    let twice: &[(&str, &str)] = &[
        ("beam.str", TABLE),
        ("a.bld", GEOMETRY),
        ("b.bld", GEOMETRY),
    ];
    for (files, expected) in [
        (
            &[("beam.str", TABLE)][..],
            "found no .bld file next to this file",
        ),
        (twice, "found several .bld files: \"a.bld\", \"b.bld\""),
        (&[("beam.bld", GEOMETRY)], "found no .str file with a blade"),
        (&[("t.trb", TURBINE)], "BLADEFILE: no file \"beam.bld\""),
    ] {
        let message = read(files).unwrap_err().to_string();
        assert!(message.contains(expected), "{expected} in {message}");
    }
    let reversed = TURBINE.replace("0 ROTATIONALDIR", "1 ROTATIONALDIR");
    let message = read(&[("t.trb", &reversed)]).unwrap_err().to_string();
    assert!(message.contains("ROTATIONALDIR: found \"1\""), "{message}");
}

#[test]
fn wrong_tables_are_refused_with_all_errors() {
    let replaced = |from: &str, to: &str| {
        let both = [TABLE, GEOMETRY].map(|text| text.replace(from, to));
        assert!(both != [TABLE, GEOMETRY], "{from}");
        read(&[("beam.str", &both[0]), ("beam.bld", &both[1])])
            .unwrap_err()
            .to_string()
    };
    for (from, to, expected) in [
        (
            "0.05 0\n1.0",
            "0.05 0.1\n1.0",
            "YCS of station 2: found 0.1, expected zero",
        ),
        ("4.0e8 0 0.5", "4.0e8 3 0.5", "STRPIT of station 1: found 3"),
        ("RGX_[-]", "R_[-]", "the column \"RGX\" is missing"),
        ("YCS_[-]", "YCS_[-] EXTRA", "found \"EXTRA\""),
        ("POS [m]", "HEIGHT [m]", "a blade of a vertical-axis rotor"),
        ("OFFSET_Y [m]", "", "the column \"OFFSET_Y\" is missing"),
        (
            "5.5       4.0",
            "5.5       0",
            "CHORD of section 2: found 0, expected more than zero",
        ),
        (
            "9.5 ",
            "5.5 ",
            "POS of section 3: found 5.5, expected more than the position",
        ),
        (
            "9.5       1.0",
            "9.5       x",
            "CHORD of section 3: expected a finite number",
        ),
        (
            "0.0           0.3",
            "z             0.3",
            "TWIST of section 3",
        ),
    ] {
        let message = replaced(from, to);
        assert!(message.contains(expected), "{expected} in {message}");
    }
    // The errors of both files.
    let table = TABLE.replace("4.0e8 0 0.5", "4.0e8 3 0.5");
    let geometry = GEOMETRY.replace("5.5       4.0", "5.5       0");
    let message = read(&[("beam.str", &table), ("beam.bld", &geometry)]).unwrap_err();
    let message = message.to_string();
    assert!(
        message.contains("STRPIT") && message.contains("CHORD"),
        "{message}"
    );
}
