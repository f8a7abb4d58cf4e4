//! Statics of the variational beam: the list of the reference, row by row.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use beam_dynamics::analysis::statics::statics;
use beam_dynamics::elements::loads::NodalForce;
use nalgebra::{Matrix3, Rotation3, Vector3, Vector6};

use super::spectra::Line;
use super::{numbers, row, stiffness, vector};
use crate::chain::{Chain, DEAD, up_to};
use crate::record;
use crate::statics::{ROLLED, cantilever};
use beam_dynamics::elements::loads::Turning;

const SOURCE: &str = "independent program, acceptance.json";

/// Records and checks a number relative to a listed one.
fn close(case: &str, quantity: &str, [found, listed]: [f64; 2], tolerance: f64) {
    let error = (found / listed - 1.0).abs();
    record::value(SOURCE, case, quantity, [found, listed], error, tolerance);
    assert!(
        error < tolerance,
        "{case}, {quantity}: {found:e} {listed:e}"
    );
}

/// Bent into circles by a dead tip moment; the largest distance of a node from its circle, and the
/// distance of the tip.
fn rolled(elements: usize, turns: f64) -> [f64; 2] {
    let (mut chain, tip) = cantilever(elements, 1.0, &ROLLED);
    let curvature = 2.0 * PI * turns;
    chain.load(
        tip,
        NodalForce {
            moment: Vector3::z() * curvature,
            ..DEAD
        },
    );
    let last = chain.last();
    let error = |i: usize| {
        let angle = curvature * i as f64 / tip as f64;
        let exact = Vector3::new(angle.sin(), 1.0 - angle.cos(), 0.0) / curvature;
        (last.positions[i] - exact).norm()
    };
    [(0..=tip).map(error).fold(0.0, f64::max), error(tip)]
}

/// The chord of an arc is short by alpha^4/270 in a parabola; the polygon still closes. The
/// convergence error of the iteration is 1e-9 of the length at the tip; the list has 1e-11, from a
/// run to round-off.
#[test]
fn one_and_two_turns_close() {
    let largest = numbers(&row("roll-up 1 turn", "max nodal error")["value"]);
    for (elements, listed) in [2, 4, 8].into_iter().zip(largest) {
        let [node, tip] = rolled(elements, 1.0);
        let case = format!("roll-up, one turn, {elements} elements");
        record::largest(SOURCE, &case, "tip gap / L", tip, 1e-9);
        assert!(tip < 1e-9, "{case}: {tip:e}");
        close(&case, "largest nodal error / L", [node, listed], 1e-3);
    }
    for elements in [4, 8] {
        let [_, tip] = rolled(elements, 2.0);
        let case = format!("roll-up, two turns, {elements} elements");
        record::largest(SOURCE, &case, "tip gap / L", tip, 1e-9);
        assert!(tip < 1e-9, "{case}: {tip:e}");
    }
}

#[test]
fn a_quarter_turn() {
    let listed = numbers(&row("roll-up quarter", "tip error")["value"]);
    for (elements, listed) in [1, 2, 4, 8].into_iter().zip(listed) {
        let (mut chain, tip) = cantilever(elements, 1.0, &ROLLED);
        chain.load(
            tip,
            NodalForce {
                moment: Vector3::z() * FRAC_PI_2,
                ..DEAD
            },
        );
        let found = chain.last().positions[tip] - Vector3::new(1.0, 1.0, 0.0) / FRAC_PI_2;
        let case = format!("quarter roll-up, {elements} elements");
        close(&case, "tip error / L", [found.norm(), listed], 1e-3);
    }
}

/// One element follows a moment up to 0.95 of a full turn; beyond, the run ends and names the
/// element and the remedy.
#[test]
fn one_element_bends_through_nearly_a_turn() {
    for degrees in [180.0_f64, 270.0, 335.0] {
        let (mut chain, tip) = cantilever(1, 1.0, &ROLLED);
        let moment = Vector3::z() * degrees.to_radians();
        chain.load(tip, NodalForce { moment, ..DEAD });
        let axes = chain.last().rotations[tip];
        let turned = axes[(1, 0)].atan2(axes[(0, 0)]).rem_euclid(2.0 * PI);
        assert!(
            (turned - degrees.to_radians()).abs() < 1e-9,
            "{degrees}: {turned}"
        );
    }
    let (mut chain, tip) = cantilever(1, 1.0, &ROLLED);
    chain.load(
        tip,
        NodalForce {
            moment: Vector3::z() * 400_f64.to_radians(),
            ..DEAD
        },
    );
    let outcome = statics(&chain.model(), &up_to(1.0));
    let failure = outcome.failure.unwrap();
    let words = format!("{failure} {}", failure.remedy());
    assert!(words.contains("more elements"), "{words}");
    assert!(!words.contains("limit point"), "{words}");
    let last = outcome.result.last().unwrap().factor * 400.0;
    assert!((300.0..=342.0).contains(&last), "{last}");
}

/// The 45-degree bend of Bathe and Bolourchi, with the torsion constant 1/6.
#[test]
fn the_bend_of_45_degrees_order_by_order() {
    let stiffness = Vector6::new(1e7, 5e6, 5e6, 5e6 / 6.0, 1e7 / 12.0, 1e7 / 12.0);
    for force in [300.0, 600.0] {
        let listed = row(&format!("bend45 {force}"), "tip error");
        let exact = vector(&listed["note"]["exact"]);
        for (elements, listed) in [1, 2, 4, 8].into_iter().zip(numbers(&listed["value"])) {
            let mut chain = Chain::new();
            let on = chain.line(None, elements, &stiffness, |part| {
                let angle = FRAC_PI_4 * part;
                let position = 100.0 * Vector3::new(angle.sin(), 1.0 - angle.cos(), 0.0);
                let axes = Rotation3::from_axis_angle(&Vector3::z_axis(), angle);
                (position, axes.into_inner())
            });
            let tip = on[2 * elements];
            chain.clamp(0);
            chain.load(
                tip,
                NodalForce {
                    force: Vector3::z() * force,
                    ..DEAD
                },
            );
            let error = (chain.last().positions[tip] - exact).norm() / 100.0;
            let case = format!("45-degree bend, {force} lb, {elements} elements");
            close(&case, "tip error / R", [error, listed], 2e-3);
        }
    }
}

/// A dead force across the tip, from mild to very large.
#[test]
fn dead_tip_forces() {
    let stiffness = Vector6::new(1e6, 1e6, 1e6, 1.0, 1.0, 1.0);
    for load in [1.0, 10.0, 1000.0] {
        let listed = row(&format!("tip dead load PL2/EI={load}"), "tip error");
        let exact = vector(&listed["note"]["exact"]);
        for (elements, listed) in [1, 2, 4, 8, 16].into_iter().zip(numbers(&listed["value"])) {
            let (mut chain, tip) = cantilever(elements, 1.0, &stiffness);
            chain.load(
                tip,
                NodalForce {
                    force: Vector3::z() * load,
                    ..DEAD
                },
            );
            let error = (chain.last().positions[tip] - exact).norm();
            let case = format!("tip force PL^2/EI = {load}, {elements} elements");
            // The error of the iteration, 1e-10, relative to the smallest errors.
            close(
                &case,
                "tip error / L",
                [error, listed],
                2e-3 + 2e-10 / listed,
            );
        }
    }
}

/// A slender half ring, against the limit of the finest meshes of the list.
#[test]
fn a_half_ring() {
    let listed = row("half ring t/R=1e-4", "relative tip error");
    let axial = 12.0 / 1e-8;
    let shear = axial * (5.0 / 6.0) / 2.6;
    let stiffness = Vector6::new(axial, shear, shear, 1.0 / 1.3, 1.0, 1.0);
    let tip = |elements: usize| {
        let mut chain = Chain::new();
        let on = chain.line(None, elements, &stiffness, |part| {
            let angle = PI * part;
            let position = Vector3::new(angle.sin(), 1.0 - angle.cos(), 0.0);
            let axes = Rotation3::from_axis_angle(&Vector3::z_axis(), angle);
            (position, axes.into_inner())
        });
        let end = on[2 * elements];
        chain.clamp(0);
        let force = 1e-4 * Vector3::new(0.3, 1.0, 0.7);
        chain.load(end, NodalForce { force, ..DEAD });
        chain.last().positions[end] - Vector3::new(0.0, 2.0, 0.0)
    };
    // Order 4: the limit of 32 and 64 elements.
    let (coarse, fine) = (tip(32), tip(64));
    let exact = fine + (fine - coarse) / 15.0;
    for (elements, listed) in [1, 2, 4, 8].into_iter().zip(numbers(&listed["value"])) {
        let error = (tip(elements) - exact).norm() / exact.norm();
        let case = format!("half ring, {elements} elements");
        close(&case, "relative tip error", [error, listed], 1e-2);
    }
}

/// A strip twisted by 90 degrees with all couplings under a large tip force.
#[test]
fn a_pretwisted_coupled_strip() {
    let listed = row("pretwisted 90 deg, coupled K, large", "relative tip error");
    let section = stiffness(&listed["note"]["stiffness"]);
    let exact = vector(&listed["note"]["exact_tip"]);
    let force = vector(&listed["note"]["tip_force"]);
    for (elements, listed) in [1, 2, 4, 8].into_iter().zip(numbers(&listed["value"])) {
        let mut line = Line::straight(elements, 1.0, section, nalgebra::Matrix6::identity());
        let last = line.nodes.len() - 1;
        for (i, node) in line.nodes.iter_mut().enumerate() {
            let angle = FRAC_PI_2 * i as f64 / last as f64;
            node.rotation = *Rotation3::from_axis_angle(&Vector3::x_axis(), angle).matrix();
        }
        let mut chain = Chain::new();
        chain.nodes = line.nodes.clone();
        chain.elements = line.parts();
        chain.clamp(0);
        chain.load(last, NodalForce { force, ..DEAD });
        let found = chain.last().positions[last];
        let error = (found - exact).norm() / (exact - Vector3::x()).norm();
        let case = format!("pretwisted strip, {elements} elements");
        close(&case, "relative tip error", [error, listed], 1e-2);
    }
}

/// Work-equivalent loads: a uniform force across the beam, a uniform moment about it, small
/// enough to stay linear: exact at the nodes and at the evaluation points on any mesh.
#[test]
fn uniform_loads_are_exact_on_any_mesh() {
    let (ei, ga, q, length) = (3.0, 50.0, 1e-6, 2.0_f64);
    let stiffness = Vector6::new(1e3, ga, ga, 2.0, ei, ei);
    for elements in [1, 2, 5] {
        let (mut chain, tip) = cantilever(elements, length, &stiffness);
        let m = 1e-6;
        chain.load_beams(Turning::Dead, [Vector3::z() * q, Vector3::x() * m]);
        let last = chain.last();
        let case = format!("uniform load, {elements} elements");
        let w = q * length.powi(4) / (8.0 * ei) + q * length.powi(2) / (2.0 * ga);
        close(&case, "tip deflection", [last.positions[tip].z, w], 1e-9);
        let axes: Matrix3<f64> = last.rotations[tip];
        let twist = m * length.powi(2) / (2.0 * 2.0);
        close(&case, "tip twist", [axes[(2, 1)], twist], 1e-9);
        for section in &last.sections {
            let rest = length - section.position.x;
            let force = section.internal_force;
            close(&case, "shear force", [force[2], q * rest], 1e-9);
            close(&case, "moment", [force[4], -0.5 * q * rest * rest], 1e-9);
            close(&case, "torque", [force[3], m * rest], 1e-9);
        }
    }
}
