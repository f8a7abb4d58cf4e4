//! Modes of wind-turbine blades, clamped and at rest, from their station tables.
//!
//! Source: `tests/reference/rotors/{nrel5mw,iea15}_*.csv`, the axis and the 6x6 matrices
//! of the blades in BeamDyn's axes; `wind_blade_standstill_modes.json`: 300 two-node
//! Timoshenko elements with the full matrices, by an independent script, four digits
//! after the point.

use std::fs;
use std::path::PathBuf;

use beam_dynamics::analysis::modes::modes;
use nalgebra::{Matrix3, Matrix6, Vector2, Vector3};
use shared_geom::blade::{self, Blade, Interpolation, Station};
use shared_geom::line::{Course, LinePoint, ReferenceLine};
use shared_geom::section::Provenance;
use shared_geom::wrench;

use crate::record;

const SOURCE: &str = "300 Timoshenko elements with full 6x6 matrices, independent script";

fn path(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("tests/reference/rotors")
        .join(name)
}

/// Rows of numbers below comments and the heading.
fn rows(name: &str) -> Vec<Vec<f64>> {
    let text = fs::read_to_string(path(name)).unwrap();
    let numbers = |line: &str| line.split(',').map(|x| x.parse().unwrap()).collect();
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    lines.skip(1).map(numbers).collect()
}

/// Our axes (columns) in BeamDyn's (x to the suction side, y to the trailing edge, z to
/// the tip): x is its z, y its -y, z its x.
fn axes() -> Matrix3<f64> {
    Matrix3::new(0.0, 0.0, 1.0, 0.0, -1.0, 0.0, 1.0, 0.0, 0.0)
}

/// A symmetric matrix from its upper triangle by rows, in our axes.
fn matrix(upper: &[f64]) -> Matrix6<f64> {
    let mut found = Matrix6::zeros();
    let mut entries = upper.iter();
    for i in 0..6 {
        for j in i..6 {
            found[(i, j)] = *entries.next().unwrap();
            found[(j, i)] = found[(i, j)];
        }
    }
    wrench::rotate(&found, &axes())
}

/// The blade of a table, in our axes; its twist is about BeamDyn's -z.
pub fn wind_blade(name: &str) -> Blade {
    let point = |row: Vec<f64>| LinePoint {
        position: axes().transpose() * Vector3::new(row[0], row[1], row[2]),
        twist: -row[3].to_radians(),
    };
    let points = rows(&format!("{name}_axis.csv")).into_iter().map(point);
    let line = ReferenceLine::through(points.collect(), Course::Polyline);
    let length = line.length();
    let station = |row: Vec<f64>| Station {
        arc_length: row[0] * length,
        stiffness: matrix(&row[1..22]),
        mass: matrix(&row[22..43]),
    };
    let stations = rows(&format!("{name}_sections_6x6.csv"))
        .into_iter()
        .map(station);
    Blade {
        name: name.to_owned(),
        line,
        reference_point: Vector2::zeros(),
        stations: stations.collect(),
        interpolation: Interpolation::Linear,
        damping: None,
        provenance: Provenance::default(),
    }
}

/// Frequencies \[Hz\] in order, and the mass of the model \[kg\], with further keys of the
/// card.
fn frequencies(blade: &Blade, keys: &str, count: usize) -> (Vec<f64>, f64) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.blade.json"), blade::write(blade)).unwrap();
    let file = folder.path().join("a.dynamics.toml");
    let text = format!(
        "units = \"SI\"\n[[blade]]\nname = \"b\"\nfile = \"a.blade.json\"\n{keys}\n\
         [modes]\nspeeds = [0]\ncount = {count}\n"
    );
    fs::write(&file, text).unwrap();
    let input = beam_dynamics::input::read(&file).unwrap_or_else(|e| panic!("{e}"));
    let outcome = modes(&input.model, &input.modes.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let found = outcome.table.at_speed(0);
    let frequencies = found.iter().map(|mode| mode.1.frequency).collect();
    (frequencies, input.summary.mass)
}

/// 0.1 %: the reference has four digits after the point, 1e-4 of the lowest modes, and its own mesh
/// is converged to that. The default mesh is converged too: 160 equal elements, which do not end at
/// the stations, change no mode by a fifth of this.
///
/// The mass is equal to the mass of the interpolated table to round-off of a thousand sums.
#[test]
fn modes_at_standstill_are_those_of_the_reference() {
    let text = fs::read_to_string(path("wind_blade_standstill_modes.json")).unwrap();
    let reference: serde_json::Value = serde_json::from_str(&text).unwrap();
    for name in ["nrel5mw", "iea15"] {
        let blade = wind_blade(name);
        let mut expected: Vec<_> = reference["Hz"][name].as_object().unwrap().iter().collect();
        expected.sort_by(|a, b| a.1.as_f64().unwrap().total_cmp(&b.1.as_f64().unwrap()));
        let (found, mass) = frequencies(&blade, "", expected.len());
        for ((mode, expected), found) in expected.into_iter().zip(&found) {
            let expected = expected.as_f64().unwrap();
            let error = (found / expected - 1.0).abs();
            record::value(SOURCE, name, mode, [*found, expected], error, 1e-3);
            assert!(error < 1e-3, "{name} {mode}: {found} {expected}");
        }
        let published = reference["blade_mass_kg"][name].as_f64().unwrap();
        assert!((mass / published - 1.0).abs() < 1e-5, "{name}: {mass}");
        let error = (mass / blade.mass() - 1.0).abs();
        assert!(error < 1e-9, "{name}: {mass} {}", blade.mass());
        let (fine, _) = frequencies(&blade, "elements = 160", found.len());
        for (found, fine) in found.iter().zip(fine) {
            let change = (fine / found - 1.0).abs();
            assert!(change < 2e-4, "{name}: {found} {fine}");
        }
    }
}
