//! Files as written by other tools: `tests/reference/exchange`, sources in the README.

use std::path::{Path, PathBuf};

use nalgebra::{Matrix3, Vector3};

use crate::blade::{Blade, BladeDamping, Interpolation};
use crate::rotation::vector::to_rotation;

use super::text::from_upper;
use super::{Format, Options, Reading, read_with};

fn fixture(name: &str) -> PathBuf {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reference/exchange");
    Path::new(folder).join(name)
}

fn read(name: &str, length: Option<f64>, format: Format) -> Reading {
    let (seen, reading) = read_with(
        &fixture(name),
        &Options {
            length,
            ..Options::default()
        },
    )
    .unwrap();
    assert_eq!(seen, format, "{name}");
    assert!(
        reading.blade.problems().is_empty(),
        "{name}: {:?}",
        reading.blade.problems()
    );
    reading
}

/// Mass of a blade whose mass per length is linear between two ends.
fn mass(blade: &Blade, root: f64, tip: f64) -> f64 {
    0.5 * (root + tip) * blade.length()
}

// The file was written by openfast_io 5.0.0, the package of OpenFAST itself. Its first
// matrix, entry by entry: x of BeamDyn is our z, y our -y, z our x.
#[test]
fn beamdyn_files_of_openfast_io() {
    let blade = read("plain_BeamDyn.dat", None, Format::BeamDyn).blade;
    let expected = from_upper(&[
        9.0e8, -6.6e6, -2.2e6, 1.4e6, -1.3e6, 1.2e6, //
        3.0e8, -1.1e6, -9.9e5, -8.8e5, -7.7e5, //
        2.0e8, -5.5e5, -4.4e5, 3.3e5, //
        8.0e6, -1.7e5, -1.6e5, //
        2.0e7, -1.5e5, //
        5.0e7,
    ]);
    let root = blade.stations[0];
    assert_eq!(root.stiffness, expected);
    // m = 20, Xcm = 0.03 up, Ycm = -0.05 to the trailing edge: 0.05 ahead; edge 3, flap
    // 0.5, cross 0.02 with the sign of y turned.
    let m = root.mass;
    assert_eq!([m[(0, 0)], m[(0, 4)], m[(0, 5)]], [20.0, 0.6, -1.0]);
    assert_eq!([m[(1, 3)], m[(2, 3)]], [-0.6, 1.0]);
    assert_eq!(
        [m[(4, 4)], m[(5, 5)], m[(3, 3)], m[(4, 5)]],
        [0.5, 3.0, 3.5, 0.02]
    );
    assert_eq!(
        blade.damping,
        Some(BladeDamping::Times([
            0.003, 0.002, 0.001, 0.006, 0.005, 0.004
        ]))
    );
    assert_eq!(blade.interpolation, Interpolation::Linear);
    let positions: Vec<_> = blade
        .stations
        .iter()
        .map(|station| station.arc_length)
        .collect();
    assert_eq!(positions, [0.0, 0.4 * blade.length(), blade.length()]);
    let tip = blade.line.points[3].position;
    assert_eq!(tip, Vector3::new(12.0, 0.15, 0.2));
}

// The axes at the key points as BeamDyn defines them (OpenFAST 3 and later): x before
// twist has no component along root y, then a turn about the tangent by minus the initial
// twist. A few roundings of order one.
#[test]
fn beamdyn_axes_at_the_key_points() {
    let blade = read("plain_BeamDyn.dat", None, Format::BeamDyn).blade;
    let curve = blade.line.curve();
    let to_beamdyn = super::Convention::BeamDyn.axes().transpose();
    for (s, twist_deg) in curve.arc_lengths().iter().zip([10.0_f64, 7.5, 3.0, -1.25]) {
        let placed = curve.at(*s);
        let z = to_beamdyn * placed.tangent;
        let x = Vector3::new(z.z, 0.0, -z.x).normalize();
        let before = Matrix3::from_columns(&[x, z.cross(&x), z]);
        let axes = to_rotation(&(-twist_deg.to_radians() * z)) * before;
        // The columns of ours are x, y, z along BeamDyn's z, -y, x.
        let ours = to_beamdyn * placed.axes;
        let column = |i: usize| axes.column(i).into_owned();
        let theirs = [column(2), -column(1), column(0)];
        for (i, column) in theirs.iter().enumerate() {
            assert!((ours.column(i) - column).norm() < 1e-14, "axis {i} at {s}");
        }
    }
}

#[test]
fn beamdyn_blade_file_in_the_layout_of_older_versions() {
    let reading = read("old_Blade.dat", Some(8.0), Format::BeamDyn);
    let blade = &reading.blade;
    assert_eq!(blade.damping, Some(BladeDamping::Proportional(1e-3)));
    let diagonal: Vec<f64> = blade.stations[1]
        .stiffness
        .diagonal()
        .iter()
        .copied()
        .collect();
    assert_eq!(diagonal, [4.5e8, 1.5e8, 1.0e8, 4.0e6, 1.0e7, 2.5e7]);
    assert!((blade.mass() - mass(blade, 20.0, 10.0)).abs() < 1e-12);
}

// Written by hand after the output routine of VABS. The blocks "at the Mass Center",
// "Classical" and "Flexibility" have other values.
#[test]
fn vabs_output() {
    let blade = read("strip.K", Some(2.0), Format::Vabs).blade;
    let station = blade.stations[0];
    assert_eq!(station.stiffness[(0, 0)], 7e7);
    assert_eq!(station.stiffness[(3, 5)], 42.0);
    assert_eq!(station.mass[(3, 3)], 0.055);
    let centers = crate::section::Centers::of(&station.stiffness, &station.mass).unwrap();
    assert!((centers.mass.x - 0.03).abs() < 1e-16 && (centers.mass.y - 0.01).abs() < 1e-16);
}

// The section of the VABS file at the root, half of it at the tip.
#[test]
fn dymore_table() {
    let vabs = read("strip.K", Some(2.0), Format::Vabs).blade.stations[0];
    let blade = read("strip.dat", Some(2.0), Format::Dymore).blade;
    assert_eq!(blade.stations[0].stiffness, vabs.stiffness);
    assert_eq!(blade.stations[0].mass, vabs.mass);
    assert_eq!(blade.stations[1].stiffness, 0.5 * vabs.stiffness);
    assert_eq!(blade.stations[1].arc_length, 2.0);
    assert_eq!(blade.damping, Some(BladeDamping::Proportional(1e-3)));
}
