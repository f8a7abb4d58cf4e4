//! Energy in time: free flight of a curved, twisted beam with offsets, and long runs of
//! cantilevers whose high modes grew with finite volumes.

use beam_dynamics::assembly::System;
use beam_dynamics::case::{Model, TransientSettings};
use beam_dynamics::elements::joints::clamped;
use beam_dynamics::integrator::Scheme;
use nalgebra::{Matrix3, Matrix6, Rotation3, Vector3, Vector6};

use super::mass;
use super::spectra::{Line, Random};
use crate::effort::is_long;
use crate::in_time::{Run, momenta};
use crate::record;

/// Two elements in a twisted bow, stiff enough to stay a beam and soft enough to bend by tens of
/// degrees in flight.
fn bow(consistent: bool) -> Model {
    let inertia = Matrix3::from_diagonal(&Vector3::new(0.03, 0.01, 0.02));
    let section = mass(1.0, &Vector3::new(0.0, 0.02, -0.01), &inertia);
    let diagonal = Vector6::new(400.0, 150.0, 180.0, 8.0, 6.0, 10.0);
    let mut stiffness = Matrix6::from_diagonal(&diagonal);
    (stiffness[(3, 4)], stiffness[(4, 3)]) = (2.0, 2.0);
    let mut line = Line::straight(2, 1.0, stiffness, section);
    line.consistent = consistent;
    for node in &mut line.nodes {
        let x = node.position.x;
        node.position.y = 0.2 * x * x;
        node.rotation = Rotation3::new(Vector3::new(0.5 * x, 0.0, 0.4 * x)).into_inner();
    }
    for geometry in &mut line.geometries {
        for node in &mut geometry.nodes {
            node.offset = Vector3::new(0.0, 0.03, 0.02);
        }
    }
    let mut model = Model::new("bow", System::new(line.nodes.clone(), line.parts()));
    let mut random = Random(5);
    for (initial, node) in model.initial.iter_mut().zip(&line.nodes) {
        let mut any = |size: f64| size * Vector3::from_fn(|_, _| random.number());
        let omega = Vector3::new(0.5, -1.0, 2.0);
        initial.velocity = Some(omega.cross(&node.position) + any(0.3));
        initial.angular_velocity = Some(omega + any(0.3));
    }
    model
}

/// The momentum is conserved by the scheme itself; the angular momentum, whose part of the moving
/// momenta is quadratic in the unknowns, and the energy at the fourth order of a scheme without
/// damping: the drift of the energy over two seconds falls by 16 with half the step below 2 ms,
/// without a limit: 5e-8 and 1e-10, as required by the reference.
#[test]
fn energy_and_momenta_of_a_free_flight() {
    for consistent in [false, true] {
        let case = format!("free flight of a bow, consistent {consistent}");
        let drifts = [4e-3, 2e-3, 5e-4].map(|step| {
            let mut settings = TransientSettings::new(2.0, step);
            settings.scheme = Scheme::Cubic { radius: 1.0 };
            // The error of the momenta is the error of the balance.
            settings.newton.correction = 1e-12;
            settings.newton.residual = 1e-13;
            let run = Run::of(bow(consistent), &settings, 1);
            run.check_end();
            let (_, start) = &run.instants[0];
            let energy = |index: usize| run.energy(&run.instants[index].1, 0.0).total();
            let kinetic = run.energy(start, 0.0).total();
            let drift = (0..run.instants.len()).map(|i| (energy(i) / kinetic - 1.0).abs());
            let [before, after] = [start, &run.instants[run.instants.len() - 1].1].map(momenta);
            let change = |k: usize| (after[k] - before[k]).norm() / before[k].norm();
            assert!(change(0) < 1e-10, "momentum: {:e}", change(0));
            println!("{case}, step {step}: angular momentum {:e}", change(1));
            let allowed = if step < 1e-3 { 1e-10 } else { 1e-7 };
            assert!(change(1) < allowed, "angular momentum: {:e}", change(1));
            drift.fold(0.0, f64::max)
        });
        let order = 0.5 * (drifts[1] / drifts[2]).log2();
        println!("{case}: {drifts:?}");
        assert!(order > 3.5, "{case}: {drifts:?}");
        record::largest("conservation", &case, "energy, relative", drifts[2], 5e-8);
        assert!(drifts[2] < 5e-8, "{case}: {drifts:?}");
    }
}

/// The soft cantilever of the spectra, with random velocities over its whole length: neither the default
/// scheme, which damps, nor Crank-Nicolson, which does not, may gain energy over 10 000 steps that
/// resolve the growing modes (with finite volumes, from 0.1 J to 1378 J within 0.2 s).
/// Crank-Nicolson keeps a shadow energy that differs by (h omega)^2 of the energy in each mode.
#[test]
fn resolved_high_modes_gain_no_energy() {
    for elements in if is_long() { 3..5 } else { 4..5 } {
        for (scheme, allowed) in [
            (Scheme::TwoStep { radius: 0.6 }, 1e-9),
            (Scheme::TwoStep { radius: 0.9 }, 1e-9),
            (Scheme::CrankNicolson, 2e-3),
        ] {
            let diagonal = Vector6::new(1e6, 1e5, 1.2e5, 10.0, 11.0, 30.0);
            let inertia = Matrix3::from_diagonal(&Vector3::new(3e-3, 1e-3, 2e-3));
            let section = mass(1.1, &Vector3::zeros(), &inertia);
            let stiffness = Matrix6::from_diagonal(&diagonal);
            let line = Line::straight(elements, 0.8, stiffness, section);
            let mut parts = line.parts();
            parts.push(Box::new(clamped("clamp", 0, &line.nodes[0])));
            let mut model = Model::new("strip", System::new(line.nodes.clone(), parts));
            let mut random = Random(9);
            for initial in &mut model.initial[1..] {
                initial.velocity = Some(0.3 * Vector3::from_fn(|_, _| random.number()));
            }
            let mut settings = TransientSettings::new(0.2, 2e-5);
            settings.scheme = scheme;
            let run = Run::of(model, &settings, 50);
            run.check_end();
            let energy = |(time, state): &(f64, _)| run.energy(state, *time).total();
            let start = energy(&run.instants[0]);
            let largest = run.instants.iter().map(energy).fold(0.0, f64::max);
            let gained = largest / start - 1.0;
            let case = format!("strip of {elements} elements, {scheme:?}");
            println!("{case}: {start} J, gained {gained:e}");
            record::largest("conservation", &case, "energy gained", gained, allowed);
            assert!(gained < allowed, "{case}: {gained:e}");
        }
    }
}
