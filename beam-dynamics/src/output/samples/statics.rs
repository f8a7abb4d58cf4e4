//! Made-up load paths and critical loads.

use nalgebra::{Matrix3, Vector3, Vector6};
use shared_geom::rotation::vector;

use super::nodes_at;
use crate::case::BladeNodes;
use crate::elements::{Reaction, SectionState};
use crate::model::Node;
use crate::result::{BucklingMode, BucklingResult, StaticResult, StaticStep};

/// Length of the sample \[m\].
const LENGTH: f64 = 10.0;

/// Nodes `n0` to `n8` along x, and one off the line.
fn nodes() -> Vec<Node> {
    let line = (0..9).map(|k| [LENGTH * f64::from(k) / 8.0, 0.0, 0.0]);
    let positions: Vec<_> = line.chain([[0.0, -2.0, 0.0]]).collect();
    nodes_at(&positions)
}

const BEAMS: [[usize; 3]; 4] = [[0, 1, 2], [2, 3, 4], [4, 5, 6], [6, 7, 8]];

/// A straight blade of 10 m, bent up and rolled to an arc of 60 degrees times `factor`,
/// with `(x^2 + LENGTH x)` times 2 as made-up displacement toward y in millimeters.
fn step(factor: f64) -> StaticStep {
    let angle = factor * std::f64::consts::FRAC_PI_3;
    let point = |s: f64| {
        let turned = angle * s / LENGTH;
        let side = 0.002 * factor * (s * s + LENGTH * s);
        if angle.abs() < 1e-12 {
            Vector3::new(s, side, 0.0)
        } else {
            let radius = LENGTH / angle;
            let up = radius * (1.0 - turned.cos());
            Vector3::new(radius * turned.sin(), side, up)
        }
    };
    let attitude = |s: f64| vector::to_rotation(&Vector3::new(0.0, -angle * s / LENGTH, 0.0));
    let along = |k: u32| LENGTH * f64::from(k) / 8.0;
    let mut positions: Vec<_> = (0..9).map(|k| point(along(k))).collect();
    let mut rotations: Vec<_> = (0..9).map(|k| attitude(along(k))).collect();
    positions.push(Vector3::new(0.0, -2.0, 0.0));
    rotations.push(Matrix3::identity());
    let mut sections = Vec::new();
    for beam in 0..4 {
        for xi in [-0.5, 0.5] {
            let s = LENGTH / 8.0 * (f64::from(2 * beam + 1) + xi);
            let arm = LENGTH - s;
            let force = Vector6::new(80.0, -5.0, 1000.0, 20.0, -1000.0 * arm, 5.0 * arm);
            sections.push(SectionState {
                beam: format!("blade/{}", beam + 1).into(),
                xi,
                position: point(s),
                axes: attitude(s),
                strain: 1e-6 * factor * force,
                internal_force: factor * force,
                change_of_stiffness: None,
                turn: 0.0,
            });
        }
    }
    StaticStep {
        factor,
        positions,
        rotations,
        iterations: 4,
        residual: 2e-13,
        sections,
        electrodes: Vec::new(),
        air: Vec::new(),
        reactions: vec![Reaction {
            joint: "clamp of n0".to_owned(),
            node: 0,
            force: factor * Vector3::new(-80.0, 5.0, -1000.0),
            moment: factor * Vector3::new(-20.0, 10_000.0, -50.0),
        }],
    }
}

/// Equilibria of a blade at these factors.
pub fn bent(factors: &[f64]) -> StaticResult {
    StaticResult {
        name: "bent blade".to_owned(),
        speed: 0.0,
        nodes: nodes(),
        beams: BEAMS.to_vec(),
        blades: vec![BladeNodes {
            name: "blade".to_owned(),
            azimuth: 0.0,
            nodes: (0..9).collect(),
            axes: Matrix3::identity(),
            file: None,
        }],
        steps: factors.iter().map(|factor| step(*factor)).collect(),
        remarks: vec!["made up".to_owned()],
    }
}

/// A critical load of the same factor in which sections turn about x without displacement: the
/// magnitudes of the displacements are used as rotations.
#[cfg(test)]
pub fn torsion(of: &BucklingMode) -> BucklingMode {
    let turn = |moved: &Vector3<f64>| Vector3::x() * moved.norm();
    BucklingMode {
        rotations: of.displacements.iter().map(turn).collect(),
        displacements: vec![Vector3::zeros(); of.displacements.len()],
        ..*of
    }
}

/// The first four critical loads of a clamped column of 10 m along x, in turns toward y
/// and z, with made-up factors.
pub fn column() -> BucklingResult {
    let mode = |number: usize, factor: f64| {
        let wave = (number / 2) as f64 + 0.5;
        let along = |k: u32| f64::from(k) / 8.0 * std::f64::consts::PI * wave;
        let toward = [Vector3::z(), Vector3::y()][number % 2];
        let largest = (0..9).map(|k| 1.0 - along(k).cos()).fold(0.0, f64::max);
        let mut displacements: Vec<_> = (0..9)
            .map(|k| (1.0 - along(k).cos()) / largest * toward)
            .collect();
        displacements.push(Vector3::zeros());
        BucklingMode {
            factor,
            rotations: vec![Vector3::zeros(); displacements.len()],
            displacements,
            residual: 1e-12,
        }
    };
    BucklingResult {
        name: "column".to_owned(),
        speed: 0.0,
        nodes: nodes(),
        beams: BEAMS.to_vec(),
        base: Some(step(0.0)),
        modes: [2.4674, -9.8696, 22.2066, 39.4784]
            .into_iter()
            .enumerate()
            .map(|(number, factor)| mode(number, factor))
            .collect(),
        remarks: Vec::new(),
    }
}
