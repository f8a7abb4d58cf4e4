//! Blades for tests.

use std::path::{Path, PathBuf};

use nalgebra::{Matrix6, Vector2, Vector3};

use crate::blade::{Blade, BladeDamping, Interpolation, Station};
use crate::line::{Course, LinePoint, ReferenceLine};
use crate::section::Provenance;
use crate::wrench;

use super::{Format, Options, Reading, read_with, write};

/// A stiffness whose 21 entries all differ, positive definite: a dominant diagonal.
pub fn stiffness(scale: f64) -> Matrix6<f64> {
    let diagonal: [f64; 6] = [9.1e8, 1.7e8, 1.3e8, 2.3e6, 3.7e6, 1.9e7];
    Matrix6::from_fn(|i, j| {
        let (i, j) = (i.min(j), i.max(j));
        let coupling = (0.01 * (3 * i + 7 * j + i * j) as f64).sin() * 0.11;
        let part = if i == j { 1.0 } else { coupling };
        scale * part * f64::sqrt(diagonal[i] * diagonal[j])
    })
}

/// The mass matrix of a rigid slice whose center is off the line.
pub fn mass(m: f64) -> Matrix6<f64> {
    let own = Matrix6::from_diagonal(&[m, m, m, 0.37 * m, 0.07 * m, 0.3 * m].into());
    let mut own = own;
    own[(4, 5)] = 0.013 * m;
    own[(5, 4)] = own[(4, 5)];
    let about = wrench::shift(&own, &Vector3::new(0.0, 0.11, -0.07));
    let mut exact = 0.5 * (about + about.transpose());
    // As in a file: the polar moment is the sum of the two others, to the last bit.
    exact[(3, 3)] = exact[(4, 4)] + exact[(5, 5)];
    exact
}

/// A blade with all properties: full matrices, twist, prebend, sweep, damping.
pub fn blade() -> Blade {
    let point = |x: f64| LinePoint {
        position: Vector3::new(x, -0.004 * x * x, 0.003 * x * x),
        twist: -0.2 + 0.031 * x - 0.0007 * x * x,
    };
    let points = [0.0, 2.0, 4.5, 7.3, 9.0, 11.0].map(point);
    let line = ReferenceLine::through(points.to_vec(), Course::Spline);
    let length = line.length();
    let station = |eta: f64| Station {
        arc_length: eta * length,
        stiffness: stiffness(1.0 - 0.7 * eta),
        mass: mass(12.0 - 7.0 * eta),
    };
    Blade {
        name: "sample".to_owned(),
        line,
        reference_point: Vector2::zeros(),
        stations: [0.0, 0.13, 0.4, 0.77, 1.0].map(station).to_vec(),
        interpolation: Interpolation::Linear,
        damping: Some(BladeDamping::Proportional(1.3e-3)),
        provenance: Provenance {
            program: "test".to_owned(),
            version: String::new(),
            input_hash: "sha256:0123".to_owned(),
            nodes: 0,
            cells: 0,
            history: Vec::new(),
            sections: Vec::new(),
        },
    }
}

/// Writes a blade into `folder`; returns the path of the first file.
pub fn written(blade: &Blade, format: Format, folder: &Path) -> PathBuf {
    let writing = write(blade, format, "sample").expect("the format is written");
    for (name, text) in &writing.files {
        std::fs::write(folder.join(name), text).expect("the folder takes files");
    }
    folder.join(&writing.files[0].0)
}

/// A blade after writing and reading.
pub fn through(blade: &Blade, format: Format) -> Reading {
    let folder = tempfile::tempdir().expect("a folder can be made");
    let first = written(blade, format, folder.path());
    let (_, reading) = read_with(&first, &Options::default()).expect("it is read again");
    reading
}

/// The largest relative difference of two blades: entries of K and M relative to
/// themselves or, if these are round-off, to the diagonal; positions and angles relative
/// to the length and one radian.
pub fn difference(a: &Blade, b: &Blade) -> f64 {
    let length = a.length();
    assert_eq!(a.stations.len(), b.stations.len());
    assert_eq!(a.line.points.len(), b.line.points.len());
    let matrix = |a: &Matrix6<f64>, b: &Matrix6<f64>| {
        let entry = |i: usize, j: usize| {
            let scale = a[(i, j)].abs().max(1e-3 * (a[(i, i)] * a[(j, j)]).sqrt());
            (a[(i, j)] - b[(i, j)]).abs() / scale
        };
        let pairs = (0..6).flat_map(|i| (0..6).map(move |j| (i, j)));
        pairs.map(|(i, j)| entry(i, j)).fold(0.0, f64::max)
    };
    let stations = a.stations.iter().zip(&b.stations).map(|(a, b)| {
        let position = (a.arc_length - b.arc_length).abs() / length;
        let matrices = matrix(&a.stiffness, &b.stiffness).max(matrix(&a.mass, &b.mass));
        position.max(matrices)
    });
    let points = a.line.points.iter().zip(&b.line.points).map(|(a, b)| {
        let position = (a.position - b.position).norm() / length;
        position.max((a.twist - b.twist).abs())
    });
    stations.chain(points).fold(0.0, f64::max)
}
