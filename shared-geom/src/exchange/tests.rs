//! Written blades are read again, in every format that does both.

use nalgebra::{Vector2, Vector3};

use crate::blade::{BladeDamping, Interpolation, Station};
use crate::line::{Course, ReferenceLine};

use super::samples::{blade, difference, stiffness, through, written};
use super::{Format, Options, read_with, recognize, write};

// Numbers are written with 17 digits, hence exact; eta times length and degrees of twist
// are rounded a few times, each 1.1e-16 of the length or of a radian.
const ROUNDINGS: f64 = 1e-15;

#[test]
fn full_blades_come_back_to_round_off() {
    let blade = blade();
    for format in [
        Format::Helicoid,
        Format::BeamDyn,
        Format::BeamDyn4,
        Format::Dymore,
        Format::Csv,
        Format::Vabs,
    ] {
        let reading = through(&blade, format);
        let error = difference(&blade, &reading.blade);
        assert!(error < ROUNDINGS, "{format:?}: {error:e}");
        assert_eq!(reading.blade.line.course, Course::Spline, "{format:?}");
        assert_eq!(reading.blade.damping, blade.damping, "{format:?}");
        assert!(
            reading.remarks.is_empty(),
            "{format:?}: {:?}",
            reading.remarks
        );
    }
}

// The matrices of BeamDyn, DYMORE and tables need no arithmetic: identical to the bit.
#[test]
fn matrices_come_back_bit_by_bit() {
    let blade = blade();
    for format in [
        Format::Helicoid,
        Format::BeamDyn,
        Format::Dymore,
        Format::Csv,
    ] {
        let back = through(&blade, format).blade;
        for (a, b) in blade.stations.iter().zip(&back.stations) {
            assert_eq!(a.stiffness, b.stiffness, "{format:?}");
            assert_eq!(a.mass, b.mass, "{format:?}");
        }
    }
}

#[test]
fn six_damping_times_come_back_where_they_fit() {
    let mut blade = blade();
    let times = [1e-3, 2e-3, 3e-3, 4e-3, 5e-3, 6e-3];
    blade.damping = Some(BladeDamping::Times(times));
    for format in [Format::Helicoid, Format::BeamDyn, Format::Csv, Format::Vabs] {
        let back = through(&blade, format).blade;
        assert_eq!(back.damping, blade.damping, "{format:?}");
    }
    // One time for all: the mean 3.5e-3, from which 1e-3 and 6e-3 are 2.5e-3 away.
    let lost = write(&blade, Format::Dymore, "a").unwrap().lost;
    assert!(
        lost[0].contains("3.500e-3 s: they differ from it by up to 2.50e-3 s"),
        "{lost:?}"
    );
}

// Order of BeamDyn: shear z, shear y, axial, bending z, bending y, torsion.
#[test]
fn damping_times_are_in_the_order_of_beamdyn() {
    let mut blade = blade();
    blade.damping = Some(BladeDamping::Times([1.0, 2.0, 3.0, 4.0, 5.0, 6.0]));
    let files = write(&blade, Format::BeamDyn, "a").unwrap().files;
    let text = &files[1].1;
    let at = text.lines().position(|line| line.contains("(s)")).unwrap();
    let row = text.lines().nth(at + 1).unwrap();
    let times: Vec<f64> = row
        .split_whitespace()
        .map(|word| word.parse().unwrap())
        .collect();
    assert_eq!(times, [3.0, 2.0, 1.0, 6.0, 5.0, 4.0]);
}

// The mass agrees with the blade's: ramps of 1e-8 of the length have at most 1e-8 of it.
#[test]
fn jumps_become_ramps_and_are_reported() {
    let mut blade = blade();
    blade.damping = None;
    let middle = Station {
        stiffness: stiffness(0.3),
        mass: super::samples::mass(2.0),
        ..blade.stations[2]
    };
    blade.stations.insert(3, middle);
    let writing = write(&blade, Format::BeamDyn, "a").unwrap();
    assert!(writing.lost[0].starts_with("1 jumps"), "{:?}", writing.lost);
    let back = through(&blade, Format::BeamDyn).blade;
    assert!((back.mass() / blade.mass() - 1.0).abs() < 1e-8);
    assert!(
        back.stations
            .windows(2)
            .all(|pair| pair[0].arc_length < pair[1].arc_length)
    );
    // Helicoid's table keeps the jump.
    assert_eq!(through(&blade, Format::Csv).blade.jumps(), blade.jumps());
}

// A piece of 2 kg/m over 0.4 L, then 5 kg/m: the same mass in formats that are linear.
#[test]
fn constant_pieces_become_doubled_stations() {
    let mut blade = blade();
    blade.interpolation = Interpolation::Constant;
    for format in [Format::Dymore, Format::Vabs, Format::BeamDyn] {
        let back = through(&blade, format).blade;
        assert_eq!(back.interpolation, Interpolation::Linear);
        let error = back.mass() / blade.mass() - 1.0;
        assert!(error.abs() < 1e-7, "{format:?}: {error:e}");
    }
    let back = through(&blade, Format::Csv).blade;
    assert_eq!(back.interpolation, Interpolation::Constant);
    assert!(difference(&blade, &back) < ROUNDINGS);
}

// The last of constant pieces extends to the tip, and the outer stations apply beyond
// them: 17 digits of eta and the ramps of BeamDyn change 1e-7.
#[test]
fn pieces_at_both_ends_are_written() {
    for interpolation in [Interpolation::Constant, Interpolation::Linear] {
        let mut blade = blade();
        blade.interpolation = interpolation;
        blade.stations.pop();
        blade.stations.remove(0);
        for format in [Format::Dymore, Format::Vabs, Format::BeamDyn] {
            let back = through(&blade, format).blade;
            let error = back.mass() / blade.mass() - 1.0;
            assert!(
                error.abs() < 1e-7,
                "{format:?}, {interpolation:?}: {error:e}"
            );
            let positions = back.positions();
            let last = positions[positions.len() - 1] / blade.length();
            assert!(
                positions[0] == 0.0 && (last - 1.0).abs() < 1e-12,
                "{format:?}"
            );
        }
    }
}

// Moved reference point: the written matrices are about the line, as in the blade.
#[test]
fn a_reference_point_off_the_line_is_moved_to_it() {
    let blade = blade();
    let moved = blade.shift(Vector2::new(0.2, -0.05));
    for format in [Format::BeamDyn, Format::Dymore, Format::Csv] {
        let back = through(&moved, format).blade;
        // Both ways are two congruences of entries that cancel in part.
        assert!(difference(&blade, &back) < 1e-11, "{format:?}");
    }
}

// Two arcs of 4 m, curved 0.05 1/m in the plane and twisted: the splines through the
// points agree to 1e-5 m, and the files state the difference.
#[test]
fn a_line_of_arcs_becomes_points_and_its_error_is_reported() {
    let mut blade = blade();
    let arc = (4.0, Vector3::new(0.02, 0.0, 0.05));
    blade.line = ReferenceLine::curved(blade.line.points[0], &[arc, arc]);
    for station in &mut blade.stations {
        station.arc_length *= 8.0 / 11.1;
    }
    let writing = write(&blade, Format::Csv, "a").unwrap();
    assert!(writing.lost[0].contains("17 points"), "{:?}", writing.lost);
    let back = through(&blade, Format::Csv).blade;
    for part in [0.1, 0.37, 0.8, 1.0] {
        let a = blade.line.at(part * blade.length()).position;
        let b = back.line.at(part * back.length()).position;
        assert!((a - b).norm() < 1e-3, "{part}: {}", (a - b).norm());
    }
}

// y = sin-like points on straight pieces: BeamDyn's splines differ between them.
#[test]
fn straight_pieces_that_become_splines_are_reported() {
    let mut blade = blade();
    blade.line.course = Course::Polyline;
    let lost = write(&blade, Format::BeamDyn, "a").unwrap().lost;
    assert!(lost[0].contains("splines through them"), "{lost:?}");
    // A straight line of two points needs a third and loses nothing.
    blade.line = ReferenceLine::straight(blade.stations[4].arc_length);
    let writing = write(&blade, Format::BeamDyn, "a").unwrap();
    assert!(writing.lost.is_empty(), "{:?}", writing.lost);
    assert_eq!(through(&blade, Format::BeamDyn).blade.line.points.len(), 3);
}

#[test]
fn every_export_states_program_input_frame_order_and_point() {
    let blade = blade();
    for format in [
        Format::BeamDyn,
        Format::BeamDyn4,
        Format::Dymore,
        Format::Csv,
        Format::Vabs,
    ] {
        for (name, text) in write(&blade, format, "a").unwrap().files {
            let head: String = text.lines().take(8).collect();
            for part in [
                concat!("Helicoid ", env!("CARGO_PKG_VERSION")),
                "sha256:0123",
                "frame: ",
                "order: ",
                "reference point: ",
            ] {
                assert!(head.contains(part), "{name:?}: {part} in {head}");
            }
        }
    }
}

#[test]
fn files_are_recognized_by_their_content() {
    let blade = blade();
    for (format, seen) in [
        (Format::Helicoid, Format::Helicoid),
        (Format::BeamDyn, Format::BeamDyn),
        (Format::BeamDyn4, Format::BeamDyn),
        (Format::Dymore, Format::Dymore),
        (Format::Csv, Format::Csv),
    ] {
        for (name, text) in write(&blade, format, "a").unwrap().files {
            let expected = if name.to_string_lossy().ends_with(".line.csv") {
                Format::Csv
            } else {
                seen
            };
            assert_eq!(recognize(&text), Some(expected), "{name:?}");
        }
    }
    assert_eq!(recognize("nothing of the kind"), None);
    assert_eq!(recognize(""), None);
}

// A table in BeamDyn's axes has the content of a BeamDyn file.
#[test]
fn a_table_may_be_in_the_axes_of_another_tool() {
    let blade = blade();
    let text = &write(&blade, Format::Csv, "a").unwrap().files[0].1;
    let beamdyn = super::frame::Convention::BeamDyn;
    let mut foreign = blade.clone();
    for station in &mut foreign.stations {
        station.stiffness = beamdyn.from_ours(&station.stiffness);
        station.mass = beamdyn.from_ours(&station.mass);
    }
    let foreign = &write(&foreign, Format::Csv, "a").unwrap().files[0].1;
    let head = |text: &str, key: &str| {
        let line = text.lines().find(|line| line.starts_with(key)).unwrap();
        line.to_owned()
    };
    let foreign = foreign
        .replace(&head(text, "# frame"), "# frame: beamdyn")
        .replace(
            &head(text, "# order"),
            &format!("# order: {}", beamdyn.order().join(", ")),
        );
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.csv");
    std::fs::write(&path, foreign).unwrap();
    let (_, reading) = read_with(&path, &Options::default()).unwrap();
    assert!(difference(&blade, &reading.blade) < ROUNDINGS);
}

#[test]
fn sections_without_a_line_need_a_length() {
    let blade = blade();
    let folder = tempfile::tempdir().unwrap();
    written(&blade, Format::Vabs, folder.path());
    written(&blade, Format::BeamDyn, folder.path());
    let options = Options {
        length: Some(7.0),
        ..Options::default()
    };
    for (name, stations) in [("sample.002.K", 2), ("sample_blade.dat", 5)] {
        let path = folder.path().join(name);
        let refused = read_with(&path, &Options::default())
            .unwrap_err()
            .to_string();
        assert!(refused.contains("--length METERS"), "{refused}");
        let (_, reading) = read_with(&path, &options).unwrap();
        assert_eq!(reading.blade.stations.len(), stations);
        assert!((reading.blade.length() - 7.0).abs() < 1e-15);
        assert!(
            reading
                .remarks
                .iter()
                .any(|remark| remark.contains("straight"))
        );
    }
}
