//! windIO files: reference data, round trips, bad input.
#![allow(clippy::unwrap_used, reason = "a test that cannot continue fails")]

use std::path::Path;

use nalgebra::{Matrix6, Vector2, Vector3};

use super::*;
use crate::blade::{BladeDamping, Interpolation, Station};
use crate::exchange::plain::stated_course;
use crate::exchange::text::from_upper;
use crate::line::{Course, LinePoint, ReferenceLine};
use crate::rotation::samples::Samples;
use crate::section::Provenance;

/// Version 2: from windIO 2.1.1, see the head of the file.
const V2: &str = include_str!("../../../../tests/reference/exchange/windio2_iea15.yaml");
/// Version 1: the BeamDyn blade of the same turbine, see the head of the file.
const V1: &str = include_str!("../../../../tests/reference/exchange/windio1_iea15.yaml");

fn blade_of(text: &str) -> Reading {
    read(text, Path::new("test.yaml"), &Options::default()).unwrap()
}

fn messages(text: &str) -> String {
    let refused = read(text, Path::new("test.yaml"), &Options::default());
    refused.unwrap_err().to_string()
}

fn assert_says(text: &str, from: &str, to: &str, expected: &str) {
    assert!(text.contains(from), "\"{from}\" is in the file");
    let found = messages(&text.replacen(from, to, 1));
    assert!(
        found.contains(expected),
        "expected {expected:?} in:\n{found}"
    );
}

// Numbers of the file at the root, in our axes (x = z, y = -y, z = x of BeamDyn): axial
// K33, shears K22 and K11, torsion K66, flap (about our y, the chord) K55, edge K44.
#[test]
fn version_2_is_read_in_the_axes_of_beamdyn() {
    let reading = blade_of(V2);
    let blade = &reading.blade;
    let root = blade.stations[0];
    let diagonal: [f64; 6] = std::array::from_fn(|i| root.stiffness[(i, i)]);
    let expected = [
        46051081603.60474,
        6729088765.395921,
        6740375994.200792,
        87489183048.03288,
        149729095916.4146,
        149629012637.96594,
    ];
    assert_eq!(diagonal, expected);
    // K34 = EA Ycm-like of BeamDyn: the axial force bends about x_bd = our z, same sign
    assert_eq!(root.stiffness[(0, 5)], -1092494742.1422234);
    assert_eq!(root.stiffness[(0, 4)], -18829097.30285156);
    assert_eq!(root.mass[(0, 0)], 3127.4021155424143);
    assert_eq!(blade.stations.len(), 26);
    // nose up is positive here, nose down there
    assert!((blade.line.points[0].twist + 15.594553019711718_f64.to_radians()).abs() < 1e-15);
    assert!(blade.problems().is_empty(), "{:?}", blade.problems());
    // Mass of OpenFAST's BeamDyn blade of the same commit: 66 997 kg.
    assert!(
        (blade.mass() / 66_996.9 - 1.0).abs() < 2e-5,
        "{}",
        blade.mass()
    );
    assert!(
        reading
            .remarks
            .iter()
            .any(|remark| remark.contains("cubic spline"))
    );
}

// Both files hold the same blade; version 1 has the six or seven digits of BeamDyn.
#[test]
fn both_versions_agree_on_the_same_blade() {
    let (one, two) = (blade_of(V1).blade, blade_of(V2).blade);
    for station in &one.stations {
        let part = station.arc_length / one.length();
        let same = two.stations.iter().find(|other| {
            let other = other.arc_length / two.length();
            (other - part).abs() < 1e-9
        });
        let other = same.unwrap();
        let off = (station.stiffness - other.stiffness).amax();
        assert!(off < 2e-7 * other.stiffness.amax(), "{off}");
        let off = (station.mass - other.mass).amax();
        assert!(off < 2e-7 * other.mass.amax(), "{off}");
    }
    // every seventh point of the line, and four digits of twist and position
    assert!((one.length() / two.length() - 1.0).abs() < 1e-5);
    for (point, s) in one.line.points.iter().zip(one.line.arc_lengths()) {
        let other = two.line.at(s / one.length() * two.length());
        assert!((point.position - other.position).amax() < 5e-3);
        assert!((point.twist - other.twist).abs() < 1e-4);
    }
}

/// A blade with full matrices, twist, prebend, sweep and damping.
fn full(course: Course) -> Blade {
    let mut samples = Samples::new(77);
    let points = (0..6).map(|i| {
        let x = f64::from(i) * 2.3;
        LinePoint {
            position: Vector3::new(x, -0.004 * x * x, 0.011 * x * x),
            twist: 0.2 - 0.03 * x,
        }
    });
    let line = ReferenceLine::through(points.collect(), course);
    let length = line.length();
    let station = |part: f64| {
        let a = Matrix6::from_fn(|_, _| samples.scalar());
        let (m, c) = (3.0 + samples.scalar(), samples.vector() * 0.1);
        let mut own = Matrix6::from_diagonal(&[m, m, m, 0.9 * m, 0.3 * m, 0.6 * m].into());
        own[(4, 5)] = 0.1 * m;
        own[(5, 4)] = 0.1 * m;
        Station {
            arc_length: part * length,
            stiffness: 1e7 * (a * a.transpose() + Matrix6::identity()),
            mass: crate::wrench::shift(&own, &Vector3::new(0.0, -c.y, -c.z)),
        }
    };
    Blade {
        name: "full".to_owned(),
        line,
        reference_point: Vector2::zeros(),
        stations: [0.0, 0.21, 0.5, 0.83, 1.0].map(station).to_vec(),
        interpolation: Interpolation::Linear,
        damping: Some(BladeDamping::Times([1e-3, 2e-3, 3e-3, 4e-3, 5e-3, 6e-3])),
        provenance: Provenance {
            program: "test".to_owned(),
            version: String::new(),
            input_hash: String::new(),
            nodes: 0,
            cells: 0,
            history: Vec::new(),
            sections: Vec::new(),
        },
    }
}

/// Asserts that `back` is `blade` up to round-off of numbers with 17 digits.
fn assert_same(blade: &Blade, back: &Blade) {
    const DIGITS: f64 = 1e-15;
    assert_eq!(back.line.course, blade.line.course);
    for (found, expected) in back.line.points.iter().zip(&blade.line.points) {
        assert_eq!(found.position, expected.position);
        // a change to degrees and back, and to the axes of BeamDyn and back
        assert!((found.twist - expected.twist).abs() < DIGITS);
    }
    assert_eq!(back.stations.len(), blade.stations.len());
    for (found, expected) in back.stations.iter().zip(&blade.stations) {
        let length = blade.length();
        assert!((found.arc_length - expected.arc_length).abs() < DIGITS * length);
        assert_eq!(found.stiffness, expected.stiffness);
        let off = (found.mass - expected.mass).amax();
        // version 2 divides by the mass and multiplies again
        assert!(off <= DIGITS * expected.mass.amax(), "{off}");
    }
}

#[test]
fn both_versions_bring_a_full_blade_back() {
    for course in [Course::Spline, Course::Polyline] {
        let blade = full(course);
        let one = write_version_1(&blade, "full");
        let back = blade_of(&one.files[0].1);
        assert_same(&blade, &back.blade);
        // only the damping is lost, which is reported
        assert_eq!(one.lost.len(), 1, "{:?}", one.lost);
        assert!(one.lost[0].contains("damping"));
        let two = write_version_2(&blade, "full");
        assert!(two.lost.is_empty(), "{:?}", two.lost);
        let back = blade_of(&two.files[0].1);
        assert_same(&blade, &back.blade);
        assert_eq!(back.blade.damping, blade.damping);
        assert!(is_version_1(&one.files[0].1) && is_version_2(&two.files[0].1));
        assert_eq!(stated_course(&two.files[0].1), Some(course));
    }
}

// The IEA-15 is unchanged by both versions.
#[test]
fn the_reference_blade_comes_back_from_both_versions() {
    let blade = blade_of(V2).blade;
    for writing in [write_version_1(&blade, "a"), write_version_2(&blade, "a")] {
        assert!(writing.lost.is_empty(), "{:?}", writing.lost);
        assert_same(&blade, &blade_of(&writing.files[0].1).blade);
    }
}

#[test]
fn the_head_states_frame_order_and_point() {
    let text = &write_version_2(&full(Course::Spline), "full").files[0].1;
    for words in [
        "# written by Helicoid ",
        "# input: ",
        "# frame: beamdyn",
        "# order: flap shear (x)",
        "# reference point: the reference axis",
        "# course: spline",
    ] {
        assert!(text.contains(words), "{words}");
    }
}

// A mass matrix other than a rigid slice's: version 2 reports the difference.
#[test]
fn what_seven_numbers_leave_out_is_reported_with_its_size() {
    let mut blade = full(Course::Spline);
    let polar = blade.stations[2].mass[(3, 3)];
    blade.stations[2].mass[(3, 4)] = 0.25 * polar;
    blade.stations[2].mass[(4, 3)] = 0.25 * polar;
    let lost = write_version_2(&blade, "full").lost.join("\n");
    assert!(lost.contains("up to 2.5e-1 of the greatest"), "{lost}");
    assert!(lost.contains("at 0.500 of the length"), "{lost}");
    assert!(write_version_1(&blade, "full").lost.len() == 1);
}

// Two pieces of constant properties: a ramp replaces the jump between them, and the mass
// changes by half its width at most.
#[test]
fn jumps_become_ramps_and_are_reported() {
    let mut blade = full(Course::Spline);
    blade.interpolation = Interpolation::Constant;
    let writing = write_version_1(&blade, "full");
    assert!(
        writing.lost[0].contains("jumps of the properties: 3"),
        "{:?}",
        writing.lost
    );
    let back = blade_of(&writing.files[0].1).blade;
    assert_eq!(back.stations.len(), 8);
    assert!((back.mass() / blade.mass() - 1.0).abs() < 2e-9);
}

// A jump at the root has no inner side, a single station applies everywhere, and a line
// of points that is shorter than its arcs still ends at the last station.
#[test]
fn all_stations_lie_on_the_written_line() {
    let plain = full(Course::Spline);
    let first = plain.stations[0];
    let mut at_root = plain.clone();
    at_root.stations.insert(0, first);
    let mut one = plain.clone();
    one.stations.truncate(1);
    one.stations[0].arc_length = 0.5 * plain.length();
    let mut arcs = plain.clone();
    let bent = [(plain.length(), Vector3::new(0.0, 0.02, 0.05))];
    arcs.line = ReferenceLine::curved(plain.line.points[0], &bent);
    for blade in [at_root, one, arcs] {
        for writing in [write_version_1(&blade, "a"), write_version_2(&blade, "a")] {
            let back = blade_of(&writing.files[0].1).blade;
            assert!((back.mass() / blade.mass() - 1.0).abs() < 1e-7);
            assert!(back.stations.len() >= 2);
        }
    }
}

#[test]
fn arcs_become_points_and_are_reported() {
    let mut blade = full(Course::Spline);
    let root = blade.line.points[0];
    let arcs = [
        (5.0, Vector3::new(0.01, 0.03, -0.02)),
        (7.0, Vector3::zeros()),
    ];
    blade.line = ReferenceLine::curved(root, &arcs);
    for station in &mut blade.stations {
        station.arc_length *= 12.0 / full(Course::Spline).length();
    }
    let writing = write_version_2(&blade, "full");
    assert!(
        writing.lost[0].contains("constant curvature"),
        "{:?}",
        writing.lost
    );
    let back = blade_of(&writing.files[0].1).blade;
    // A natural spline is straight at its ends, where the arc is not, and smooth where
    // the curvature jumps: off by 0.1 k h^2 there, 6e-4 m for k = 0.037 and h = 0.4 m.
    assert!((back.length() - 12.0).abs() < 1e-4);
    for s in [0.7, 3.2, 4.9, 8.0, 12.0] {
        let (found, expected) = (back.line.at(s), blade.line.at(s));
        assert!((found.position - expected.position).norm() < 6e-4, "{s}");
        assert!((found.axes - expected.axes).amax() < 6e-3, "{s}");
    }
}

// The grids of stiffness and inertia may differ: linear between the positions of both.
#[test]
fn stations_are_at_the_positions_of_both_grids() {
    let half = V1.rfind("inertia_matrix").unwrap();
    let (stiff, inertia) = V1.split_at(half);
    let grid = inertia.lines().nth(1).unwrap();
    assert!(grid.contains("[0.0, 0.1, 0.4, 0.7, 1.0]"), "{grid}");
    let inertia = inertia.replace("[0.0, 0.1, 0.4, 0.7, 1.0]", "[0.0, 0.1, 0.3, 0.7, 1.0]");
    let reading = blade_of(&format!("{stiff}{inertia}"));
    let parts: Vec<_> = reading
        .blade
        .stations
        .iter()
        .map(|s| s.arc_length)
        .collect();
    assert_eq!(parts.len(), 6);
    assert!(
        reading
            .remarks
            .iter()
            .any(|remark| remark.contains("grids"))
    );
    let k = |text: &str| {
        blade_of(text)
            .blade
            .stations
            .iter()
            .map(|s| s.stiffness)
            .collect::<Vec<_>>()
    };
    let mean = k(V1)[1] * (1.0 / 3.0) + k(V1)[2] * (2.0 / 3.0);
    assert!((k(&format!("{stiff}{inertia}"))[2] - mean).amax() < 1e-14 * mean.amax());
}

#[test]
fn bad_fields_of_version_2_are_reported() {
    let v2 = |from, to, expected| assert_says(V2, from, to, expected);
    v2(
        "K11: [6740375994.200792,",
        "K11: [many,",
        "test.yaml:34: stiffness_matrix.K11: expected a finite number, found \"many\"",
    );
    v2("K11: [6740375994.200792,", "K11: [.nan,", "found \".nan\"");
    v2(
        "K11: [6740375994.200792,",
        "K11: [",
        "test.yaml:34: stiffness_matrix.K11: found 25 values, expected 26",
    );
    v2(
        "K22:",
        "K2:",
        "test.yaml:33: key of stiffness_matrix: found \"K2\"",
    );
    v2("K22:", "K2:", "key \"K22\" of stiffness_matrix is missing");
    v2("cm_x:", "cmx:", "did you mean \"cm_x\"?");
    v2(
        "stiffness_matrix:",
        "stiff_matrix:",
        "help: did you mean \"stiff_matrix\" to be \"stiffness_matrix\"?",
    );
    v2(
        "        reference_axis:",
        "        axis:",
        "key \"reference_axis\" of components.blade is missing",
    );
    v2(
        "mu: [0.0,",
        "mu: [",
        "structural_damping.mu: expected 6 numbers, found 5",
    );
    v2(
        "grid: [0.0, 0.01, 0.02",
        "grid: [0.0, 0.02, 0.01",
        "grid of inertia_matrix: found 0.01 after 0.02, expected increasing positions",
    );
    v2(
        "grid: [0.0, 1.0]",
        "grid: [0.0, 1.5]",
        "grid of reference_axis.y: found 1.5, expected positions from 0 to 1",
    );
}

#[test]
fn bad_fields_of_version_1_are_reported() {
    let v1 = |from, to, expected| assert_says(V1, from, to, expected);
    v1(
        "- [6740376000.0, ",
        "- [",
        "a station of stiff_matrix, an upper triangle: expected 21 numbers, found 20",
    );
    v1(
        "six_x_six",
        "six",
        "did you mean \"six\" to be \"six_x_six\"?",
    );
    v1(
        "    twist:",
        "    twist_rad:",
        "key \"twist\" of six_x_six is missing",
    );
    // a scalar instead of a list
    let grid = V1.lines().find(|line| line.contains("grid")).unwrap();
    let (head, _) = grid.split_once('[').unwrap();
    v1(
        grid,
        &format!("{head} 3"),
        "found \"3\", expected a list of numbers",
    );
}

// Off-diagonal entries have a default in the schema, zero; diagonal ones are needed.
#[test]
fn entries_that_are_not_given_are_zero_and_reported() {
    let line = V2.lines().find(|line| line.contains("K12:")).unwrap();
    let reading = blade_of(&V2.replace(&format!("{line}\n"), ""));
    assert!(
        reading
            .remarks
            .iter()
            .any(|remark| remark.contains("K12 not given"))
    );
    assert_eq!(reading.blade.stations[3].stiffness[(1, 2)], 0.0);
}

#[test]
fn a_file_that_is_cut_off_is_refused() {
    let whole = V1.trim_end().len();
    // the last station ends with a bracket; after it nothing is missing
    for end in (0..whole - 1).step_by(7) {
        let refused = read(&V1[..end], Path::new("t.yaml"), &Options::default());
        assert!(refused.is_err(), "cut at byte {end}");
    }
}

// No changed byte causes a panic; the files are thinned to keep the test short.
#[test]
fn no_changed_byte_makes_the_reader_panic() {
    let mut samples = Samples::new(5);
    for text in [V1, &write_version_2(&full(Course::Spline), "a").files[0].1] {
        for _ in 0..600 {
            let mut bytes = text.as_bytes().to_vec();
            let at = (samples.scalar().abs() * bytes.len() as f64) as usize % bytes.len();
            bytes[at] = b"0-9[]{}:&*#\"' \n\t!e."[at % 19];
            if let Ok(text) = std::str::from_utf8(&bytes) {
                let _ = read(text, Path::new("t.yaml"), &Options::default());
            }
        }
    }
}

#[test]
fn other_texts_are_not_taken_for_windio() {
    assert!(recognize(V1) && recognize(V2));
    assert!(!recognize("[line]\nx = 1\n") && !recognize("{\"components\": 1}"));
    assert!(from_upper(&[0.0; 21]).amax() == 0.0);
}
