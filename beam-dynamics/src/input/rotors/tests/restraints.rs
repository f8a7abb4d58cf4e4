//! Stops, dampers and links against closed forms.

use nalgebra::Vector3;
use shared_geom::expression::{Expression, Jet, Names};
use shared_geom::rotation::vector;

use super::{read, text};
use crate::analysis::statics::statics;
use crate::input::rotors::base::{Stop, Units};
use crate::input::rotors::damper::curve as damper_moment;
use crate::input::rotors::stops::stop_moment;

const UNITS: Units = Units {
    angle: 1.0,
    length: 1.0,
    time: 1.0,
    moment: 1.0,
};

/// Pseudo-random numbers from -1 to 1.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// The value of an expression of `x` and `v`, and its derivative by `x`.
fn value(text: &str, x: f64, v: f64) -> (f64, f64) {
    let names = Names {
        variables: &["x", "v"],
        constants: &[],
    };
    let expression = Expression::parse(text, &names).unwrap();
    let found = expression.at(|index| match index {
        0 => Jet::variable(x),
        _ => Jet::constant(v),
    });
    (found.value, found.first)
}

// Far beyond a stop the moment is k d + c v, far inside it is zero, each up to k w^2 / (4 |d|) and the
// same part of c v; it grows with the angle, and its slope is its difference quotient.
#[test]
fn stops_are_smooth_and_one_sided() {
    let mut random = Random(2);
    for _ in 0..300 {
        let stop = Stop {
            lower: Some(-0.1 + 0.05 * random.next()),
            upper: Some(0.2 + 0.05 * random.next()),
            stiffness: 1000.0 * (1.5 + random.next()),
            damping: 5.0 * (1.0 + random.next()),
            width: 0.002,
        };
        let text = stop_moment(&stop, ["x", "v"], &UNITS);
        let (x, v) = (0.5 * random.next(), random.next());
        let (found, slope) = value(&text, x, v);
        let [lower, upper] = [stop.lower, stop.upper].map(Option::unwrap);
        let depth = (x - upper).max(0.0) - (lower - x).max(0.0);
        let near = (x - upper).abs().min((x - lower).abs()).max(1e-3);
        let contact = if depth == 0.0 { 0.0 } else { 1.0 };
        let expected = stop.stiffness * depth + contact * stop.damping * v;
        let part = (stop.width / near).powi(2) / 2.0;
        let bound =
            part * (stop.stiffness * near + 2.0 * stop.damping) + stop.stiffness * stop.width;
        let far = (x - upper).abs().min((x - lower).abs()) > 0.02;
        let bound = if far {
            part * (stop.stiffness * near + 2.0 * stop.damping)
        } else {
            bound + stop.damping
        };
        assert!(
            (found - expected).abs() <= bound,
            "{found} {expected} {bound}"
        );
        let still = |x: f64| value(&text, x, 0.0).0;
        assert!(value(&text, x, 0.0).1 >= 0.0);
        let h = 1e-6;
        let quotient = (value(&text, x + h, v).0 - value(&text, x - h, v).0) / (2.0 * h);
        assert!(
            (slope - quotient).abs() < 1e-3 * stop.stiffness,
            "{slope} {quotient}"
        );
        assert!(still(x + h) >= still(x));
    }
}

// The curve goes through its points, is linear between them, and continues with its end slopes.
#[test]
fn dampers_follow_their_curve() {
    let mut random = Random(3);
    for _ in 0..300 {
        let mut rate = -2.0;
        let curve: Vec<_> = (0..5)
            .map(|_| {
                rate += 0.5 + 0.4 * random.next();
                [rate, 100.0 * random.next()]
            })
            .collect();
        let text = damper_moment(&curve, "v", 1.0);
        let at = 4.0 * random.next();
        let piece = curve[1..4].iter().filter(|point| point[0] <= at).count();
        let [[a, low], [b, high]] = [curve[piece], curve[piece + 1]];
        let expected = low + (high - low) * (at - a) / (b - a);
        let found = value(&text, 0.0, at).0;
        assert!(
            (found - expected).abs() < 1e-9 * (1.0 + expected.abs()),
            "{found} {expected}"
        );
    }
}

/// The rotation of a node in the equilibrium, about -y and about x \[rad\].
fn turned(text: &str, node: &str) -> [f64; 2] {
    let input = read(text);
    let outcome = statics(&input.model, &input.statics.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let nodes = input.model.system.nodes();
    let index = nodes.iter().position(|own| own.label == node).unwrap();
    let last = outcome.result.steps.last().unwrap();
    let turn = last.rotations[index] * nodes[index].rotation.transpose();
    let turn = vector::from_rotation(&turn);
    [-turn.y, turn.x]
}

// A blade rests on its droop stop by its weight: k/2 (d + sqrt(d^2 + w^2)) = m g cos(beta), with
// the mass of 2 kg at 0.6 m from the hinge.
#[test]
fn a_blade_rests_on_its_droop_stop() {
    let keys = "speed = 0\n[[rotor.hinge]]\nkind = \"flap\"\noffset = 0.1\nstiffness = 1\n\
                stop = { lower = -3, stiffness = 2000 }\n";
    let rest = "[gravity]\nacceleration = [0, 0, -9.81]\n[static]\n";
    let [flap, _] = turned(&text("articulated", keys, rest), "r 1/flap");
    let depth = (-3.0_f64).to_radians() - flap;
    let width = 0.1_f64.to_radians();
    let found = 1000.0 * (depth + depth.hypot(width)) - flap;
    let expected = 2.0 * 9.81 * 0.6 * flap.cos();
    assert!(
        (found / expected - 1.0).abs() < 1e-3,
        "{found} {expected}, {flap}"
    );
}

/// Angles of flap, lag and pitch hinges in the equilibrium under a force at the tip and a couple \[rad\].
fn coupled_angles(delta_3: f64, damping: &str) -> [f64; 3] {
    let keys = format!(
        "speed = 0\n[[rotor.hinge]]\nkind = \"flap\"\noffset = 0.1\nstiffness = 2000\n\
         [[rotor.hinge]]\nkind = \"lag\"\nstiffness = 900\n[rotor.swashplate]\ncollective = 3\n\
         [rotor.pitch_link]\nstiffness = 3e3\n{damping}delta_3 = {delta_3:?}\n"
    );
    let rest = "[[load]]\nnode = \"r 1/tip\"\nforce = [0, 70, 130]\nmoment = [90, 0, 0]\n[static]\nsteps = 4\n";
    let input = read(&text("articulated", &keys, rest));
    let outcome = statics(&input.model, &input.statics.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let nodes = input.model.system.nodes();
    let last = outcome.result.steps.last().unwrap();
    let [flap, lag, blade] = ["r 1/flap", "r 1/lag", "r 1/pitch"].map(|node| {
        let index = nodes.iter().position(|own| own.label == node).unwrap();
        last.rotations[index] * nodes[index].rotation.transpose()
    });
    let angle = |of| vector::from_rotation(&of);
    [
        -angle(flap).y,
        angle(flap.transpose() * lag).z,
        angle(lag.transpose() * blade).x,
    ]
}

// At flap and lag angles of several degrees a coupling of nearly zero changes nothing, to the size of the tangent.
#[test]
fn a_coupling_of_nearly_zero_is_none() {
    let none = coupled_angles(0.0, "");
    assert!(none[0] > 0.05 && none[1] > 0.05, "{none:?}");
    for damping in ["", "damping = 3\n"] {
        for delta_3 in [1e-9, -1e-9] {
            let found = coupled_angles(delta_3, damping);
            for (found, none) in found.iter().zip(&none) {
                assert!((found - none).abs() < 1e-9, "{found} {none}");
            }
        }
    }
}

// The coupling is a potential: at 25 degrees the equilibrium is the one of k_b/2 beta^2 + k_z/2 zeta^2 + k/2 (p + K
// beta)^2 less the work of the force at the tip, 1.1 m from both hinges, and of the couple about x. The blade bends by
// 1e-4.
#[test]
fn the_moment_of_a_coupling_acts_on_flapping() {
    let [beta, zeta, p] = coupled_angles(25.0, "");
    let ratio = 25.0_f64.to_radians().tan();
    let moment = 3e3 * (p + ratio * beta);
    let along = Vector3::new(beta.cos() * zeta.cos(), zeta.sin(), beta.sin() * zeta.cos());
    let by_beta = Vector3::new(-beta.sin() * zeta.cos(), 0.0, beta.cos() * zeta.cos());
    let by_zeta = Vector3::new(
        -beta.cos() * zeta.sin(),
        zeta.cos(),
        -beta.sin() * zeta.sin(),
    );
    let force = Vector3::new(0.0, 1.1 * 70.0, 1.1 * 130.0);
    for (found, expected) in [
        (moment, 90.0 * along.x),
        (2000.0 * beta + ratio * moment, force.dot(&by_beta)),
        (900.0 * zeta, force.dot(&by_zeta) - 90.0 * beta.sin()),
    ] {
        assert!((found / expected - 1.0).abs() < 1e-3, "{found} {expected}");
    }
}

// With a stiff link the pitch is -tan(delta_3) times the flap angle, and the link has no moment, so that
// the flap angle is M / k. Second order in the angles, 0.02 and 0.005 rad.
#[test]
fn pitch_falls_with_flapping_for_positive_delta_3() {
    for delta_3 in [-15.0_f64, 20.0] {
        let keys = format!(
            "speed = 0\n[[rotor.hinge]]\nkind = \"flap\"\noffset = 0.1\nstiffness = 5000\n\
             [rotor.swashplate]\ncollective = 0\n[rotor.pitch_link]\nstiffness = 3e4\n\
             delta_3 = {delta_3}\n"
        );
        let rest = "[[load]]\nnode = \"r 1/tip\"\nforce = [0, 0, 100]\n[static]\n";
        let [flap, pitch] = turned(&text("articulated", &keys, rest), "r 1/pitch");
        let expected = 100.0 * 1.1 / 5000.0;
        assert!((flap / expected - 1.0).abs() < 2e-3, "{flap} {expected}");
        let coupled = -delta_3.to_radians().tan() * flap;
        assert!((pitch / coupled - 1.0).abs() < 1e-2, "{pitch} {coupled}");
    }
}
