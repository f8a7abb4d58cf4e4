//! A start far from the periodic motion.

use super::analyzed;

/// A rotor on a stand whose joint has an angle, with which its blades are not built: at the first instant
/// their roots turn by this angle, and the tips do not.
const TILTED: &str = "[properties.spar]\nea = 7e8\ngay = 2e8\ngaz = 2e8\ngj = 3e6\neiy = 2e6\neiz = 4e6\n\
    m = 6\niy = 1e-3\niz = 1e-2\n\
    [[node]]\nname = \"stand\"\nposition = [0, 0, 0]\n\
    [[body]]\nname = \"stand\"\nnode = \"stand\"\nmass = 3000\ninertia = [1e4, 1e4, 1e4]\n\
    [[joint]]\nname = \"pitch\"\nkind = \"revolute\"\nnodes = [\"stand\"]\nat = [0, 0, 0]\naxis = [0, 1, 0]\n\
    angle = -0.03\n\
    [[rotor]]\nname = \"r\"\nhub = \"articulated\"\nnode = \"stand\"\ncenter = [0, 5.2, 1.5]\nblades = 3\n\
    speed = 30\nmass = 50\n\
    [[rotor.hinge]]\nkind = \"flap\"\noffset = 0.25\ndamping = 3000\n\
    [rotor.blade]\nhub_radius = 0.25\nproperties = \"spar\"\npiece = [{ length = 4.75, elements = 1 }]\n\
    [periodic]\nspeed = 30\nsteps = 24\ntolerance = 1e-8\n";

// The blades turn in the plane of the tilted hub, whose center is at R (0, 5.2, 1.5) with the axis R z, and
// a tip is farther from it than 5 m by the integral of m w^2 (5^2 - r^2)/2 EA from 0.25 to 5 m: 2.97e-4 m.
// A period of 24 steps has no solution from the start; one of more steps has.
#[test]
fn a_period_that_fails_is_marched_with_shorter_steps() {
    let (outcome, kept) = analyzed(TILTED);
    assert!(outcome.result.is_periodic);
    let nodes = beam_dynamics::input::parse(
        &format!("[units]\nangle = \"rad\"\nrotation_speed = \"rad/s\"\n{TILTED}"),
        "model.dynamics.toml",
    );
    let nodes = nodes.unwrap().model.system.nodes().to_vec();
    let tip = nodes.iter().position(|node| node.label == "r 1/tip");
    let (sin, cos) = (-0.03_f64).sin_cos();
    let axis = nalgebra::Vector3::new(sin, 0.0, cos);
    let center = axis * 1.5 + nalgebra::Vector3::y() * 5.2;
    for (time, state) in &kept.0 {
        let arm = state.nodes[tip.unwrap()].position - center;
        let (above, stretch) = (arm.dot(&axis), arm.norm() - 5.0);
        assert!(above.abs() < 1e-4, "{time}: {above}");
        assert!((stretch - 2.97e-4).abs() < 3e-5, "{time}: {stretch}");
    }
}
