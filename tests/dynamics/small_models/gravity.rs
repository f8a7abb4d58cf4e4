//! Rotating starts with gravity across the axis.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::vector;

use super::models::run;
use super::strip::driven_beam;
use beam_dynamics::case::{Model, Start, TransientSettings};
use beam_dynamics::integrator::Scheme;
use beam_dynamics::model::{Drive, Ramp, State};

fn ramp(from: f64, to: f64, end: f64) -> Drive {
    Drive::Ramp(Ramp {
        from,
        to,
        start: 0.0,
        end,
        smooth: false,
    })
}

/// Model K, turned about z at `speed` \[rad/s\], with gravity along -y.
fn wheel(speed: f64, gravity: f64) -> Model {
    let mut model = driven_beam(ramp(0.0, 100.0 * speed, 100.0));
    model.gravity = -gravity * Vector3::y();
    model
}

fn settings(speed: f64, to: f64, step: f64) -> TransientSettings {
    TransientSettings {
        start: Start::Rotating { speed },
        scheme: Scheme::Cubic { radius: 1.0 },
        ..TransientSettings::new(to, step)
    }
}

/// Deflection of the tip in the plane of rotation, in the axes of the root \[m\].
fn deflection(state: &State, angle: f64) -> f64 {
    let turned: Matrix3<f64> = vector::to_rotation(&(angle * Vector3::z()));
    let tip = state.nodes.last().map(|node| node.position);
    turned
        .transpose()
        .row(1)
        .dot(&tip.unwrap_or_default().transpose())
}

// Slow rotation: the deflection m g L^4/(8 EI), and the amplification (W/w)^2 = 8e-4 of a
// frequency of 3.52 rad/s, with shear flexibility of 1e-7 and a mesh error below 1e-5.
#[test]
fn a_slow_rotor_starts_with_its_static_deflection() {
    let (speed, gravity) = (0.1, 1e-3);
    let (kept, outcome) = run(&wheel(speed, gravity), &settings(speed, 0.1, 0.05));
    assert!(outcome.failure.is_none(), "{}", outcome.failure.unwrap());
    let expected = -gravity / 8.0;
    let found = deflection(&kept.states[0], 0.0);
    assert!((found / expected - 1.0).abs() < 2e-3, "{found} {expected}");
    let is_said = |remark: &String| remark.contains("across the axis of rotation");
    assert_eq!(outcome.remarks.iter().filter(|one| is_said(one)).count(), 1);
}

// At 6 rad/s, above the frequency in the plane of about 4.4 rad/s, the deflection over a turn is a
// cosine and a half turn later its negative: errors are of second order in the deflection of
// 1e-4, times the ratio 1e7 of axial to bending stiffness, and of fourth order in steps of 0.02 rad. Without the response the deflection at the
// start is zero and the run contains the free vibration with the full amplitude.
#[test]
fn the_response_to_gravity_is_periodic_from_the_start() {
    let (speed, gravity) = (6.0, 1e-3);
    let turn = std::f64::consts::TAU / speed;
    let model = wheel(speed, gravity);
    let (kept, outcome) = run(&model, &settings(speed, turn, turn / 320.0));
    assert!(outcome.failure.is_none(), "{}", outcome.failure.unwrap());
    assert_eq!(outcome.changes, []);
    let of = |i: usize| deflection(&kept.states[i], speed * kept.times[i]);
    let amplitude = of(0);
    assert!(amplitude.abs() > 1e-5, "{amplitude}");
    // About W^2 > w^2: the tip moves against gravity.
    assert!(amplitude > 0.0);
    for (i, time) in kept.times.iter().enumerate() {
        let expected = amplitude * (speed * time).cos();
        let off = (of(i) - expected).abs() / amplitude;
        assert!(off < 5e-3, "{off:e} at {time}");
    }
}

// Gravity that is zero at the start: the steady rotation, and a remark.
#[test]
fn gravity_that_grows_starts_without_response() {
    let speed = 6.0;
    let mut model = wheel(speed, 0.1);
    model.gravity_drive = ramp(0.0, 1.0, 10.0);
    let (kept, outcome) = run(&model, &settings(speed, 0.02, 0.01));
    assert!(outcome.failure.is_none(), "{}", outcome.failure.unwrap());
    assert!(deflection(&kept.states[0], 0.0).abs() < 1e-12);
    let is_said = |remark: &String| remark.contains("its growth causes a transient");
    assert!(outcome.remarks.iter().any(is_said), "{:?}", outcome.remarks);
}
