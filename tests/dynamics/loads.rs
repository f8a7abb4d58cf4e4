//! Distributed loads, imposed motions, weight, and equilibria whose stiffness comes only from
//! tension or motion.

use std::f64::consts::{FRAC_PI_2, PI};

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::analysis::statics::statics;
use beam_dynamics::assembly::System;
use beam_dynamics::case::{Model, ModesSettings};
use beam_dynamics::elements::Element;
use beam_dynamics::elements::loads::{
    ImposedMotion, LoadFactor, NodalForce, NodalLoad, Turning, imposed,
};
use nalgebra::{Vector3, Vector6};

use crate::chain::{DEAD, FREE, up_to};
use crate::record;
use crate::statics::{ROLLED, cantilever, rolled};
use crate::uniform_beam::{Inertia, UniformBeam};

/// A uniform beam held in some components at nodes, with loads.
fn held(
    beam: &UniformBeam,
    holds: &[(usize, ImposedMotion)],
    loads: &[(usize, NodalForce)],
) -> Model {
    let nodes = beam.nodes();
    let mut elements = beam.elements(&nodes);
    for (node, motion) in holds {
        let held = imposed("hold", *node, &nodes[*node], *motion);
        let held: Box<dyn Element> = Box::new(held);
        elements.push(held);
    }
    for (node, load) in loads {
        elements.push(Box::new(NodalLoad::new(
            "load",
            *node,
            &nodes[*node],
            *load,
        )));
    }
    Model::new("held beam", System::new(nodes, elements))
}

/// Free to turn about y.
const HINGE: ImposedMotion = ImposedMotion {
    displacement: [Some(0.0); 3],
    rotation: [Some(0.0), None, Some(0.0)],
    ..FREE
};

/// A cantilever under a small load q per length: the reactions are q L and q L^2 / 2 and,
/// with eight elements, the tip is at q L^4 / 8 EI + q L^2 / 2 GA to order four.
#[test]
fn a_load_along_a_beam() {
    let stiffness = Vector6::new(1e4, 50.0, 50.0, 1.0, 3.0, 3.0);
    for turning in [Turning::Dead, Turning::Follower] {
        let (mut chain, tip) = cantilever(8, 2.0, &stiffness);
        let q = 1e-5;
        chain.load_beams(turning, [Vector3::z() * q, Vector3::zeros()]);
        let last = chain.last();
        let reaction = &last.reactions[0];
        assert!((reaction.force.z / (-2.0 * q) - 1.0).abs() < 1e-8);
        assert!((reaction.moment.y / (2.0 * q) - 1.0).abs() < 1e-8);
        let expected = q * 16.0 / 24.0 + q * 4.0 / 100.0;
        let (found, source) = (last.positions[tip].z, "Timoshenko beam, closed form");
        let error = (found / expected - 1.0).abs();
        let case = format!("cantilever, load along it, {turning:?}");
        record::value(
            source,
            &case,
            "tip deflection",
            [found, expected],
            error,
            1e-4,
        );
        assert!(error < 1e-4, "{found} {expected}");
    }
}

/// The reaction moment of an imposed tip angle, applied as a load, gives the same angle; both
/// solutions agree to round-off.
#[test]
fn imposed_rotation_and_moment_are_each_others_inverse() {
    let (_, angle) = rolled(4, FRAC_PI_2, Turning::Dead);
    let (mut chain, tip) = cantilever(4, 1.0, &ROLLED);
    let motion = ImposedMotion {
        rotation: [Some(0.0), Some(0.0), Some(angle)],
        ..FREE
    };
    chain.impose(tip, motion);
    let last = chain.last();
    let reaction = last.reactions.iter().find(|r| r.node == tip).unwrap();
    let error = (reaction.moment.z / FRAC_PI_2 - 1.0).abs();
    assert!(error < 1e-8, "{}", reaction.moment);
    assert!(reaction.force.norm() < 1e-8);
}

/// Pinned beam under half its critical load: `omega^2 = omega_0^2 (1 - P / P_cr)`, from
/// the equation of the beam with an axial force; consistent inertia of eight elements.
#[test]
fn modes_about_a_loaded_equilibrium() {
    let frequency = |load: f64| {
        let mut beam = UniformBeam::slender(8, Inertia::Consistent);
        beam.clamped = false;
        let far = ImposedMotion {
            displacement: [None, Some(0.0), Some(0.0)],
            ..FREE
        };
        let force = -Vector3::x() * load;
        let load = NodalForce { force, ..DEAD };
        let model = held(&beam, &[(0, HINGE), (16, far)], &[(16, load)]);
        let outcome = modes(&model, &ModesSettings::new(vec![0.0], 1));
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        outcome.table.at_speed(0)[0].1.frequency
    };
    let found = frequency(0.5 * PI * PI) / frequency(0.0);
    let expected = 0.5_f64.sqrt();
    let error = (found / expected - 1.0).abs();
    let source = "beam with an axial force, closed form";
    let values = [found, expected];
    record::value(
        source,
        "pinned beam",
        "frequency ratio",
        values,
        error,
        1e-4,
    );
    assert!(error < 1e-4, "{found} {expected}");
}

/// Weight and its moment at the root, m g and m g L / 2; the beam sags by 1e-4 of its
/// length, which shortens the arm by less than 1e-7.
#[test]
fn weight_is_carried_by_the_root() {
    for inertia in [Inertia::Lumped, Inertia::Consistent] {
        for speed in [0.0, 0.3] {
            let mut model = Model::new("beam", UniformBeam::slender(4, inertia).system());
            let g = 1e-3;
            model.gravity = -g * Vector3::z();
            let mut settings = up_to(1.0);
            settings.speed = speed;
            let outcome = statics(&model, &settings);
            assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
            let reaction = &outcome.result.last().unwrap().reactions[0];
            let case = format!("{inertia:?}, {speed} rad/s: {reaction:?}");
            assert!((reaction.force.z / g - 1.0).abs() < 1e-8, "{case}");
            if speed == 0.0 {
                assert!(
                    (reaction.moment.y / (-0.5 * g) - 1.0).abs() < 1e-6,
                    "{case}"
                );
            }
        }
    }
}

/// A stiff blade on a free flap hinge at the axis, which has no stiffness until it is in tension:
/// under gravity along the axis it droops by `sin b = 3 g / (2 Omega^2 L)` (moment balance of a
/// rod). Bending and stretching by Omega^2 m L^3 / EI = 1e-6.
#[test]
fn a_blade_on_a_free_hinge_finds_its_coning() {
    let mut beam = UniformBeam::slender(2, Inertia::Consistent);
    beam.clamped = false;
    beam.stiffness = Vector6::new(1e8, 1e8, 1e8, 1e6, 1e6, 1e6);
    let mut model = held(&beam, &[(0, HINGE)], &[]);
    model.gravity = -0.1 * Vector3::z();
    let mut settings = up_to(1.0);
    settings.speed = 1.0;
    let outcome = statics(&model, &settings);
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let tip = outcome.result.last().unwrap().positions[4];
    let (found, expected) = (-tip.z / tip.norm(), 0.15);
    let error = (found - expected).abs();
    let source = "rod on a hinge, moment balance";
    let values = [found, expected];
    record::value(
        source,
        "free flap hinge",
        "sine of coning",
        values,
        error,
        1e-5,
    );
    assert!(error < 1e-5, "{tip}");
}

/// At rest and without loads the undeformed state is the solution, with or without a hinge; a
/// moment about the hinge is reported with the motion that it drives.
#[test]
fn a_load_that_a_hinge_cannot_carry_is_reported() {
    let mut beam = UniformBeam::slender(2, Inertia::Consistent);
    beam.clamped = false;
    let free = held(&beam, &[(0, HINGE)], &[]);
    let outcome = statics(&free, &up_to(1.0));
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    assert_eq!(outcome.result.steps.len(), 1);
    assert_eq!(outcome.result.steps[0].positions[4], Vector3::x());
    for factor in [LoadFactor::Proportional, LoadFactor::Constant] {
        let moment = NodalForce {
            moment: Vector3::y(),
            factor,
            ..DEAD
        };
        let model = held(&beam, &[(0, HINGE)], &[(2, moment)]);
        let mut settings = up_to(1.0);
        for arc_length in [false, true] {
            settings.arc_length = arc_length;
            let outcome = statics(&model, &settings);
            let reported = outcome.failure.unwrap().to_string();
            assert!(reported.contains("load factor 0"), "{reported}");
            assert!(
                reported.contains("without stiffness, mostly rotation about y"),
                "{reported}"
            );
        }
    }
}
