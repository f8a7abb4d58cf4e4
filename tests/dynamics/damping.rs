//! Internal damping of beams against closed forms.

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::assembly::System;
use beam_dynamics::case::{Model, ModesSettings};
use beam_dynamics::elements::Element;
use beam_dynamics::elements::beams::{Beam, BeamGeometry, BeamInertia, BeamNode, MassAlong};
use beam_dynamics::elements::joints::clamped;
use beam_dynamics::elements::laws::{Law, LawKind};
use beam_dynamics::model::Node;
use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};

use crate::record;

/// A clamped beam of length one in four elements, with offset mass and some shear, with
/// the viscosity `damping`; modes are damped as (name, angular frequency, ratio).
fn damped_modes(stiffness: &Matrix6<f64>, damping: &Matrix6<f64>) -> Vec<(String, f64, f64)> {
    const BEAMS: usize = 4;
    let count = 2 * BEAMS + 1;
    let node = |i: usize| Node {
        label: format!("n{i}"),
        position: Vector3::new(i as f64 / (count - 1) as f64, 0.0, 0.0),
        rotation: Matrix3::identity(),
    };
    let nodes: Vec<_> = (0..count).map(node).collect();
    let geometry = BeamGeometry::new([BeamNode::aligned(); 3]);
    let mass = Matrix6::from_diagonal(&Vector6::new(1.0, 1.0, 1.0, 3e-3, 1e-3, 2e-3));
    let mut elements: Vec<Box<dyn Element>> = vec![Box::new(clamped("root", 0, &nodes[0]))];
    for e in 0..BEAMS {
        let on = [2 * e, 2 * e + 1, 2 * e + 2];
        let ends = on.map(|i| &nodes[i]);
        let law: Law<6> = LawKind::Viscoelastic {
            stiffness: *stiffness,
            viscosity: *damping,
        }
        .into();
        let beam = Beam::new("beam", on, geometry, ends, [law.clone(), law]);
        elements.push(Box::new(beam));
        let along = |_| mass;
        let mass = MassAlong::smooth(&along);
        let inertia = BeamInertia::new("beam", on, geometry, ends, &mass);
        elements.push(Box::new(inertia));
    }
    let model = Model::new("damped beam", System::new(nodes, elements));
    let settings = ModesSettings::new(vec![0.0], 12);
    let outcome = modes(&model, &settings);
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let points = outcome.table.at_speed(0).into_iter();
    points
        .map(|(branch, point)| {
            let omega = 2.0 * std::f64::consts::PI * point.frequency;
            let size = omega / (1.0 - point.damping_ratio.powi(2)).sqrt();
            (branch.name.clone(), size, point.damping_ratio)
        })
        .collect()
}

fn diagonal() -> Matrix6<f64> {
    Matrix6::from_diagonal(&Vector6::new(4e3, 2e3, 1.5e3, 0.8, 1.0, 2.7))
}

// D = tau K makes the modal equation q'' + tau omega^2 q' + omega^2 q = 0: the ratio is tau omega /
// 2 in every mode, of the discrete beam too, and |s| is omega. The relative error of the
// eigenvalues is 1e-8 at stiffnesses that span four decades.
#[test]
fn a_viscosity_proportional_to_stiffness_damps_in_proportion_to_frequency() {
    const TIME: f64 = 1e-4;
    let mut stiffness = diagonal();
    (stiffness[(3, 4)], stiffness[(4, 3)]) = (0.2, 0.2);
    let found = damped_modes(&stiffness, &(TIME * stiffness));
    assert_eq!(found.len(), 12);
    for (i, (_, omega, ratio)) in found.iter().enumerate() {
        let expected = 0.5 * TIME * omega;
        let error = (ratio / expected - 1.0).abs();
        let quantity = format!("damping ratio of mode {} [-]", i + 1);
        let numbers = [*ratio, expected];
        record::value("closed form", "D = tau K", &quantity, numbers, error, 1e-8);
        assert!(error < 1e-8, "mode {}: {ratio} against {expected}", i + 1);
    }
}

// Sections without coupling: a viscosity of torsion alone, d = tau GJ, damps torsion by
// tau omega / 2 and bending not at all.
#[test]
fn a_viscosity_of_torsion_damps_torsion_only() {
    const TIME: f64 = 1e-4;
    let stiffness = diagonal();
    let mut damping = Matrix6::zeros();
    damping[(3, 3)] = TIME * stiffness[(3, 3)];
    let found = damped_modes(&stiffness, &damping);
    let (torsion, rest): (Vec<_>, Vec<_>) = found
        .into_iter()
        .partition(|(name, ..)| name.starts_with("torsion"));
    assert!(torsion.len() >= 2 && rest.len() >= 6);
    for (name, omega, ratio) in torsion {
        let error = (ratio / (0.5 * TIME * omega) - 1.0).abs();
        assert!(error < 1e-8, "{name}: {ratio}");
    }
    for (name, _, ratio) in rest {
        assert!(ratio.abs() < 1e-10, "{name}: {ratio}");
    }
}
