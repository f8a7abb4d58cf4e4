//! Beams in time: starts from equilibrium, the swinging cantilever.

use nalgebra::Vector3;

use super::models::{run, states};
use super::strip::{driven_beam, swinging_cantilever};
use beam_dynamics::analysis::transient::TransientFailure;
use beam_dynamics::case::{Start, TransientSettings};
use beam_dynamics::model::{Drive, Ramp};

/// A turning angle of the rate `speed`, from the start.
fn turning(speed: f64) -> Drive {
    Drive::Ramp(Ramp {
        from: 0.0,
        to: 100.0 * speed,
        start: 0.0,
        end: 100.0,
        smooth: false,
    })
}

// A state of equilibrium fulfills the equations of motion; round-off of forces of 1e5 times strains
// of 1e-16 move masses of 0.015 kg by less than 1e-9 m in 0.1 s.
#[test]
fn an_equilibrium_stays_at_rest() {
    let settings = TransientSettings {
        start: Start::Equilibrium,
        ..TransientSettings::new(0.1, 0.005)
    };
    let found = states(&swinging_cantilever(3), &settings);
    let tip = |i: usize| found[i].nodes.last().unwrap().position;
    assert!((tip(0) - Vector3::x()).norm() > 0.1);
    let moved = (0..found.len()).map(|i| (tip(i) - tip(0)).norm());
    let moved = moved.fold(0.0, f64::max);
    assert!(moved < 1e-8, "{moved:e}");
}

// Model K at eta = 6: the radius of the tip is constant, 1 + eta^2/(3 EA) from the elongation of a
// bar under its own centrifugal force. A fifth of a turn, 50 steps.
#[test]
fn a_rotating_beam_keeps_its_radius() {
    let speed = 6.0;
    let settings = TransientSettings {
        start: Start::Rotating { speed },
        ..TransientSettings::new(0.25, 0.005)
    };
    let (kept, outcome) = run(&driven_beam(turning(speed)), &settings);
    assert!(outcome.failure.is_none(), "{}", outcome.failure.unwrap());
    assert_eq!(outcome.changes, []);
    let radii = kept
        .states
        .iter()
        .map(|s| s.nodes.last().unwrap().position.norm());
    let radii: Vec<f64> = radii.collect();
    let expected = 1.0 + speed * speed / 3e7;
    let off = radii
        .iter()
        .map(|r| (r - expected).abs())
        .fold(0.0, f64::max);
    assert!(off < 1e-6, "{off:e}");
    let tip = kept.states.last().unwrap().nodes.last().unwrap().position;
    let angle = tip.y.atan2(tip.x);
    // The damping of the scheme, of third order in the angle of a step (0.03), makes the beam lag:
    // 2 * 0.03^3 * eta^2 over the square of its frequency in the plane, 18.
    assert!((angle - 0.25 * speed).abs() < 2e-4, "{angle}");
    // A root at rest is reported.
    let held = run(&driven_beam(Drive::Constant(0.0)), &settings).1.failure;
    assert!(
        matches!(held, Some(TransientFailure::Held { .. })),
        "{held:?}"
    );
}

// models.md M, 20 elements, h = 1 ms, at t = 0.2: two other programs give (0.83934, 0.41302,
// -0.26656) at the same step; converged in h, same mesh: (0.839336, 0.412995, -0.266578).
#[test]
fn the_tip_of_a_swinging_cantilever() {
    let (kept, outcome) = run(
        &swinging_cantilever(20),
        &TransientSettings::new(0.2, 0.001),
    );
    assert!(outcome.failure.is_none(), "{}", outcome.failure.unwrap());
    let tip = kept.states.last().unwrap().nodes.last().unwrap().position;
    let expected = Vector3::new(0.8393357874, 0.4129954412, -0.2665784252);
    assert!((tip - expected).norm() < 1e-4, "{tip}");
}
