//! Stops of hubs that tilt and of flap hinges, in equilibrium.

use beam_dynamics::analysis::statics::statics;
use nalgebra::Vector3;
use shared_geom::rotation::vector;

use super::{MASS, ROOT, TIP, parsed, rotor};

/// Force across a tip \[N\].
const FORCE: f64 = 100.0;
/// Stiffness of the stop \[N m\].
const CONTACT: f64 = 5000.0;
/// Width of the contact \[deg\].
const WIDTH: f64 = 0.3;

/// Rotation vector of the yoke at rest under a force across the tip of the first blade \[rad\].
fn tilt(kind: &str, (blades, azimuth): (usize, f64), stop: &str, force: f64) -> Vector3<f64> {
    let link = if kind == "teetering" {
        ""
    } else {
        "link = 0.1\n"
    };
    let keys = format!(
        "speed = 0\nazimuth = {azimuth:?}\n{link}[rotor.tilt]\nstiffness = 2\n\
         stop = {{ {stop}, stiffness = {CONTACT:?}, width = {WIDTH:?} }}\n"
    );
    let cards =
        format!("[[load]]\nnode = \"r 1/tip\"\nforce = [0, 0, {force:?}]\n[static]\nsteps = 10\n");
    let input = parsed(&rotor(kind, blades, &keys, &cards));
    let outcome = statics(&input.model, &input.statics.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let nodes = input.model.system.nodes();
    let index = nodes
        .iter()
        .position(|node| node.label == "r/yoke")
        .unwrap();
    let last = outcome.result.steps.last().unwrap();
    vector::from_rotation(&(last.rotations[index] * nodes[index].rotation.transpose()))
}

/// Moment of a stop at a depth \[rad\].
fn contact(depth: f64) -> f64 {
    0.5 * CONTACT * (depth + depth.hypot(WIDTH.to_radians()))
}

/// Moment of a stop \[deg\] and of the spring of 2 N m at an angle beyond it.
fn moment(angle: f64, stop: f64) -> f64 {
    contact(angle - stop.to_radians()) + 2.0 * angle
}

// The moment of the force about the hinge, at the tilted tip, is the one of the contact and of a soft spring: k/2 (d +
// sqrt(d^2 + w^2)) beyond the stop by d, less the one of the other stop, 1e-3 of it. The blade bends by 1e-5 of
// the tilt.
#[test]
fn a_teetering_hub_rests_on_its_stops() {
    for (force, sign, [stop, other]) in [(FORCE, 1.0, [6.0, 4.0]), (-FORCE, -1.0, [4.0, 6.0])] {
        let turn = tilt("teetering", (2, 0.0), "lower = -4, upper = 6", force);
        // Positive up for the first blade, along x.
        let angle = -sign * turn.y;
        let expected = FORCE * TIP * angle.cos();
        let found = moment(angle, stop) - contact(-angle - f64::to_radians(other));
        assert!(angle > f64::to_radians(stop), "{turn}");
        assert!(
            (found / expected - 1.0).abs() < 1e-4,
            "{found} {expected} {turn}"
        );
        assert!(turn.x.hypot(turn.z) < 1e-9, "{turn}");
    }
}

// The stop of a gimbal is at its upper angle in every direction: the tilt is toward the loaded blade, with the same
// depth at every azimuth. The link turns the yoke about its axis by no more than the third order of the tilt.
#[test]
fn a_gimballed_hub_rests_on_its_stop_in_every_direction() {
    for azimuth in [0.0, 40.0, 90.0, 200.0_f64] {
        let turn = tilt("gimballed", (3, azimuth), "upper = 6", FORCE);
        let angle = turn.norm();
        let expected = FORCE * TIP * angle.cos();
        let found = moment(angle, 6.0);
        assert!(angle > 6.0_f64.to_radians(), "{azimuth}: {turn}");
        assert!(
            (found / expected - 1.0).abs() < 1e-3,
            "{azimuth}: {found} {expected}"
        );
        let (sin, cos) = azimuth.to_radians().sin_cos();
        let across = turn.x * cos + turn.y * sin;
        assert!(
            across.abs() + turn.z.abs() < 1e-3 * angle,
            "{azimuth}: {turn}"
        );
    }
}

// A blade at rest falls onto its droop stop, which has no stiffness before the contact: the moment of its weight about
// the hinge, m g L^2/2 cos x, is k/2 (d + sqrt(d^2 + w^2)) at the depth d, to round-off of the rigid blade. The upper
// stop has 1e-4 of it.
#[test]
fn a_blade_falls_onto_its_stop() {
    for stiffness in [50.0, 500.0, 5000.0_f64] {
        let keys = format!(
            "speed = 0\n[[rotor.hinge]]\nkind = \"flap\"\n\
             stop = {{ lower = -4, upper = 25, stiffness = {stiffness:?} }}\n"
        );
        let cards = "[gravity]\nacceleration = [0, 0, -9.81]\n[static]\n";
        let input = parsed(&rotor("articulated", 3, &keys, cards));
        let outcome = statics(&input.model, &input.statics.unwrap());
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        let nodes = input.model.system.nodes();
        let last = outcome.result.steps.last().unwrap();
        let tips = nodes.iter().zip(&last.positions);
        let tips = tips.filter(|(node, _)| node.label.ends_with("/tip"));
        let drops: Vec<f64> = tips.map(|(_, at)| -at.z / (TIP - ROOT)).collect();
        assert_eq!(drops.len(), 3);
        for angle in drops.into_iter().map(f64::asin) {
            let depth = angle - f64::to_radians(4.0);
            let width = f64::to_radians(0.1);
            let found = 0.5 * stiffness * (depth + depth.hypot(width));
            let expected = 0.5 * MASS * 9.81 * (TIP - ROOT).powi(2) * angle.cos();
            let error = (found / expected - 1.0).abs();
            assert!(error < 1e-3, "{stiffness}: {found} {expected}");
        }
    }
}
