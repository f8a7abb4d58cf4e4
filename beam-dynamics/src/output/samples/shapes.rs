//! Made-up shapes of modes.

use nalgebra::{Complex, Matrix3};

use super::{branch, nodes_at, point};
use crate::assembly::System;
use crate::case::{BladeNodes, Model};
use crate::model::Node;
use crate::result::{EquilibriumReport, FrequencyTable, ModeKind, ModeShape};

/// A blade of 10 m along x on five nodes, whose tip moves by (0, -1, 2) and turns by 1
/// about x; the motion grows with the square of the span.
pub fn tip_motion() -> (Vec<Node>, Vec<[usize; 3]>, ModeShape) {
    let positions: Vec<_> = (0..5).map(|k| [2.5 * f64::from(k), 0.0, 0.0]).collect();
    let real = |v: [f64; 3], k: usize| v.map(|x| Complex::from(x * (k * k) as f64 / 16.0));
    let shape = ModeShape {
        displacements: (0..5).map(|k| real([0.0, -1.0, 2.0], k)).collect(),
        rotations: (0..5).map(|k| real([1.0, 0.0, 0.0], k)).collect(),
    };
    (nodes_at(&positions), vec![[0, 1, 2], [2, 3, 4]], shape)
}

/// That blade with two modes at rest: the first of that shape, the second damped with
/// flap a quarter of a period after lag; and without shapes at 60 rpm.
pub fn shaped() -> (Model, FrequencyTable) {
    let (nodes, beams, first) = tip_motion();
    let mut second = first.clone();
    for k in 0..5 {
        let bent = ((k * k) as f64 / 16.0 - 0.5 * k as f64 / 4.0) * 2.0;
        second.displacements[k] = [
            Complex::new(0.0, 0.0),
            Complex::new(bent, 0.0),
            Complex::new(0.0, -0.4 * bent),
        ];
        second.rotations[k] = [Complex::new(0.0, 0.0); 3];
    }
    let report = EquilibriumReport {
        iterations: 1,
        residual: 0.0,
        positions: nodes.iter().map(|node| node.position.into()).collect(),
        rotations: vec![Matrix3::identity(); nodes.len()],
    };
    let mode = |name: &str, kind, frequency, damping_ratio, shape: ModeShape| {
        let mut at_rest = point(frequency, [0.5, 0.5, 0.0, 0.0], None);
        if let Some(point) = &mut at_rest {
            point.damping_ratio = damping_ratio;
            point.growth = -damping_ratio * frequency;
            point.shape = Some(shape);
        }
        let turning = point(frequency + 1.0, [0.5, 0.5, 0.0, 0.0], Some(1.0));
        branch(name, kind, vec![at_rest, turning])
    };
    let mut model = Model::new("shaped blade", System::new(nodes, Vec::new()));
    model.beams = beams;
    model.blades = vec![BladeNodes {
        name: "blade".to_owned(),
        azimuth: 0.0,
        nodes: (0..5).collect(),
        axes: Matrix3::identity(),
        file: None,
    }];
    let table = FrequencyTable {
        name: "shaped blade".to_owned(),
        speeds: vec![0.0, 2.0 * std::f64::consts::PI],
        branches: vec![
            mode("flap 1", ModeKind::Flap, 1.4, 0.0, first),
            mode("lag 1", ModeKind::Lag, 22.25, 0.02, second),
        ],
        equilibria: vec![report.clone(), report],
        decaying: Vec::new(),
        remarks: Vec::new(),
        style: Default::default(),
        is_single_blade: false,
        blade_files: Vec::new(),
    };
    (model, table)
}
