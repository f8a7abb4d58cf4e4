//! Joints of turning bodies: transmission, gyroscopic and driving moments, against closed
//! forms.
//!
//! Errors of the integration are of second order; tolerances are about 0.1 (omega h)^2 of the
//! quantity, times the angle of rotation if an error of the angle rotates it. Quantities determined
//! by constraints alone are exact to round-off.

use std::f64::consts::TAU;

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::vector;

use crate::joint_runs::{Mechanism, check, check_order, find, off};

const STEP: f64 = 5e-3;

fn about_z(angle: f64) -> Matrix3<f64> {
    vector::to_rotation(&Vector3::new(0.0, 0.0, angle))
}

/// Errors of a measure of one joint, by steps h and h/2.
fn errors(
    runs: &[Mechanism; 2],
    joint: &str,
    measure: impl Fn(f64, &beam_dynamics::elements::JointState) -> f64,
) -> [f64; 2] {
    [0, 1].map(|i: usize| runs[i].most_of(joint, &measure))
}

fn runs(cards: &str, to: f64) -> [Mechanism; 2] {
    [STEP, STEP / 2.0].map(|step| Mechanism::new(cards, to, step))
}

// A universal joint between shafts at the angle b, the first turned with W, a = W t from the
// position of its arm at right angles to both shafts:
//
//   tan(phi) = cos(b) tan(a)            phi' = W cos(b) / (1 - sin(b)^2 sin(a)^2)
//   phi'' = W^2 cos(b) sin(b)^2 sin(2a) / (1 - sin(b)^2 sin(a)^2)^2
//
// The joint exerts a moment along n, at right angles to both arms; J phi'' is its component along
// the second shaft; the motor exerts J phi'' phi'/W, from the power.
#[test]
fn a_universal_joint_between_shafts() {
    const ANGLE: f64 = 0.6;
    const TURN: f64 = 3.0;
    const INERTIA: f64 = 0.7;
    let (sine, cosine) = ANGLE.sin_cos();
    let cards = format!(
        "[[node]]\nname = \"first\"\nposition = [0, 0, 0]\nangular_velocity = [0, 0, {TURN}]\n\
         [[node]]\nname = \"second\"\nposition = [0, 0, 0]\norientation = [-{ANGLE}, 0, 0]\n\
         [[body]]\nname = \"first\"\nnode = \"first\"\nmass = 1\ninertia = [0.2, 0.2, 0.3]\n\
         [[body]]\nname = \"second\"\nnode = \"second\"\nmass = 1\n\
         inertia = [0.4, 0.4, {INERTIA}]\n\
         [[joint]]\nname = \"motor\"\nkind = \"revolute\"\nnodes = [\"first\"]\naxis = [0, 0, 1]\n\
         angle = \"= {TURN}*t\"\n\
         [[joint]]\nname = \"cross\"\nkind = \"universal\"\nnodes = [\"first\", \"second\"]\n\
         axes = [[1, 0, 0], [0, {cosine:?}, -{sine:?}]]\n\
         [[joint]]\nname = \"bearing\"\nkind = \"plane-rotation\"\nnodes = [\"second\"]\n\
         axis = [0, {sine:?}, {cosine:?}]\n"
    );
    let runs = runs(&cards, 2.5);
    let shaft = Vector3::new(0.0, sine, cosine);
    let below = |t: f64| 1.0 - (sine * (TURN * t).sin()).powi(2);
    let rate = |t: f64| TURN * cosine / below(t);
    let torque = |t: f64| {
        let square = TURN * TURN * cosine * sine * sine;
        INERTIA * square * (2.0 * TURN * t).sin() / below(t).powi(2)
    };
    // The moment of the joint, from the current arms.
    let of_cross = |t: f64| {
        let (s, c) = (TURN * t).sin_cos();
        let angle = (cosine * s).atan2(c);
        let first = Vector3::new(c, s, 0.0);
        let turned = Vector3::new(-angle.sin(), angle.cos() * cosine, -angle.cos() * sine);
        let n = first.cross(&turned);
        torque(t) / n.dot(&shaft) * n
    };
    let case = "universal joint between shafts at 0.6 rad";
    let found = runs[1].most_of("bearing", |t, observed| {
        let expected = (cosine * (TURN * t).sin()).atan2((TURN * t).cos());
        let difference = (observed.angle.unwrap() - expected).rem_euclid(TAU);
        difference.min(TAU - difference)
    });
    check(case, "angle of the second shaft [rad]", found, 1e-10);
    let found = errors(&runs, "bearing", |t, observed| {
        off(observed.angular_velocity, Vector3::new(rate(t), 0.0, 0.0))
    });
    check_order(case, "its angular velocity, of 3.6 [rad/s]", found, 1e-3);
    let found = errors(&runs, "cross", |t, observed| {
        off(observed.moment, of_cross(t))
    });
    check_order(case, "moment of the joint, of 3.5 N m [N m]", found, 5e-3);
    let found = errors(&runs, "motor", |t, observed| {
        (observed.moment.z - torque(t) * rate(t) / TURN).abs()
    });
    check_order(case, "moment of the motor, of 3.5 N m [N m]", found, 5e-3);
    let found = errors(&runs, "bearing", |t, observed| {
        let of_cross = of_cross(t);
        off(observed.moment, shaft * of_cross.dot(&shaft) - of_cross)
    });
    check_order(case, "moment of the bearing [N m]", found, 5e-3);
}

// A body with its center at (e, 0, c) from the axis of a screw, that turns by 0.8 t^2 and
// rises by 0.05 t^2: in its own axes F = m (-e w^2, e w', s'') and M = (e, 0, c) x F + J w'.
#[test]
fn an_unbalanced_screw() {
    const MASS: f64 = 2.0;
    let arm = Vector3::new(0.3, 0.0, 0.5);
    let cards = format!(
        "[[node]]\nname = \"body\"\nposition = [0, 0, 0]\n\
         [[body]]\nname = \"body\"\nnode = \"body\"\nmass = {MASS}\noffset = [0.3, 0, 0.5]\n\
         inertia = [0.3, 0.3, 0.4]\n\
         [[joint]]\nname = \"screw\"\nkind = \"cylindrical\"\nnodes = [\"body\"]\n\
         axis = [0, 0, 1]\nangle = \"= 0.8*t^2\"\ndisplacement = \"= 0.05*t^2\"\n"
    );
    let runs = runs(&cards, 2.0);
    let own = |t: f64| MASS * Vector3::new(-0.3 * (1.6 * t).powi(2), 0.3 * 1.6, 0.1);
    let turn = |t: f64| about_z(0.8 * t * t);
    let case = "cylindrical joint, unbalanced screw";
    let found = errors(&runs, "screw", |t, observed| {
        off(observed.force, turn(t) * own(t))
    });
    check_order(case, "force, of 6 N [N]", found, 5e-3);
    let found = errors(&runs, "screw", |t, observed| {
        let moment = arm.cross(&own(t)) + Vector3::new(0.0, 0.0, 0.4 * 1.6);
        off(observed.moment, turn(t) * moment)
    });
    check_order(case, "moment, of 4 N m [N m]", found, 5e-3);
    let found = runs[1].most_of("screw", |t, observed| {
        let turned = (observed.angle.unwrap() - 0.8 * t * t).rem_euclid(TAU);
        let risen = (observed.displacement.x - 0.05 * t * t).abs();
        risen.max(turned.min(TAU - turned))
    });
    check(case, "displacement and angle [m, rad]", found, 1e-10);
}

/// A rotor of 0.5 kg m^2 about its axis h, along x at first, on a carrier that turns at 1.5 rad/s
/// about z.
fn gyroscope(joints: &str, start: &str) -> String {
    format!(
        "[[node]]\nname = \"carrier\"\nposition = [0, 0, 0]\n\
         [[node]]\nname = \"rotor\"\nposition = [0, 0, 0]\n{start}\n\
         [[body]]\nname = \"rotor\"\nnode = \"rotor\"\nmass = 2\ninertia = [0.5, 0.3, 0.3]\n\
         [[joint]]\nname = \"table\"\nkind = \"revolute\"\nnodes = [\"carrier\"]\n\
         axis = [0, 0, 1]\nangle = \"= 1.5*t\"\n{joints}"
    )
}

// A motor drives the rotor relative to its carrier at s = 5 + 2 t: L = J s h + J_t W z, so that the
// bearing exerts J s W z x h, the motor J s' h, and the table both.
#[test]
fn a_driven_spin_and_its_gyroscopic_moment() {
    for (word, drive) in [("speed", "5 + 2*t"), ("angle", "5*t + t^2")] {
        let joints = format!(
            "[[joint]]\nname = \"bearing\"\nkind = \"revolute\"\nnodes = [\"carrier\", \"rotor\"]\n\
             axis = [1, 0, 0]\n\
             [[joint]]\nname = \"motor\"\nkind = \"spin\"\nnodes = [\"carrier\", \"rotor\"]\n\
             axis = [1, 0, 0]\n{word} = \"= {drive}\"\n"
        );
        let runs = runs(&gyroscope(&joints, ""), 1.0);
        let spin = |t: f64| 5.0 + 2.0 * t;
        let gyroscopic = |t: f64| 0.5 * spin(t) * 1.5 * (about_z(1.5 * t) * Vector3::y());
        let driving = |t: f64| 0.5 * 2.0 * (about_z(1.5 * t) * Vector3::x());
        let case = format!("rotor on a turning table, driven by its {word}");
        let found = errors(&runs, "bearing", |t, observed| {
            off(observed.moment, gyroscopic(t))
        });
        check_order(
            &case,
            "moment of the bearing, of 5.3 N m [N m]",
            found,
            2e-4,
        );
        let found = errors(&runs, "motor", |t, observed| {
            off(observed.moment, driving(t))
        });
        check_order(&case, "moment of the motor, of 1 N m [N m]", found, 5e-3);
        let found = errors(&runs, "table", |t, observed| {
            off(observed.moment, gyroscopic(t) + driving(t))
        });
        check_order(&case, "moment of the table [N m]", found, 2e-4);
    }
}

// The axis of a free rotor in flight is kept parallel to the axis of the carrier: only the moment J
// s W, no force; and the rotor continues along its line.
#[test]
fn a_plane_rotation_holds_the_axis_of_a_gyroscope() {
    let joints = "[[joint]]\nname = \"axis\"\nkind = \"plane-rotation\"\n\
                  nodes = [\"carrier\", \"rotor\"]\naxis = [1, 0, 0]\n";
    let start = "velocity = [0.2, -0.3, 0.4]\nangular_velocity = [5, 0, 1.5]";
    let runs = runs(&gyroscope(joints, start), 1.0);
    let case = "plane rotation, gyroscope in free flight";
    let found = errors(&runs, "axis", |t, observed| {
        off(
            observed.moment,
            0.5 * 5.0 * 1.5 * (about_z(1.5 * t) * Vector3::y()),
        )
    });
    check_order(case, "moment, of 3.75 N m [N m]", found, 2e-4);
    let found = runs[1].most(|t, observed| {
        let axis = find(observed, "axis");
        let position = t * Vector3::new(0.2, -0.3, 0.4);
        axis.force
            .amax()
            .max(off(axis.axes[0] * axis.displacement, position))
    });
    check(case, "force and position [N, m]", found, 1e-9);
}

// A body on a spherical joint in steady conical motion, inclined by b, without spin: W^2 (J_t + m
// l^2 - J_a) cos(b) = m g l, and the joint exerts m g and -m W^2 l sin(b) inward.
#[test]
fn a_conical_pendulum() {
    const TILT: f64 = 0.6;
    let (mass, length, [across, along]) = (2.0, 0.8, [0.3, 0.1]);
    let gravity = 9.81;
    let inertia = across + mass * length * length - along;
    let turn = (mass * gravity * length / (inertia * TILT.cos())).sqrt();
    let cards = format!(
        "[gravity]\nacceleration = [0, 0, -{gravity}]\n\
         [[node]]\nname = \"bob\"\nposition = [0, 0, 0]\norientation = [0, -{TILT}, 0]\n\
         angular_velocity = [0, 0, {turn:?}]\n\
         [[body]]\nname = \"bob\"\nnode = \"bob\"\nmass = {mass}\noffset = [0, 0, -{length}]\n\
         inertia = [{across}, {across}, {along}]\n\
         [[joint]]\nname = \"pivot\"\nkind = \"spherical\"\nnodes = [\"bob\"]\n"
    );
    let runs = runs(&cards, 1.0);
    let inward = mass * turn * turn * length * TILT.sin();
    let case = "spherical joint, conical pendulum";
    let found = errors(&runs, "pivot", |t, observed| {
        let force = about_z(turn * t) * Vector3::new(-inward, 0.0, 0.0);
        off(observed.force, force + mass * gravity * Vector3::z())
    });
    check_order(case, "force, of 22 N [N]", found, 2e-2);
    let found = runs[1].most_of("pivot", |_, observed| observed.moment.amax());
    check(case, "moment [N m]", found, 1e-12);
}

// Rotations of a rotation joint: J times the angular acceleration, about a fixed axis.
#[test]
fn an_imposed_rotation() {
    let cards = "[[node]]\nname = \"body\"\nposition = [0, 0, 0]\n\
                 [[body]]\nname = \"body\"\nnode = \"body\"\nmass = 1\ninertia = [1, 2, 3]\n\
                 [[joint]]\nname = \"turn\"\nkind = \"rotation\"\nnodes = [\"body\"]\n\
                 rotation = { x = 0, y = 0, z = \"= sin(2*t)\" }\n";
    let runs = runs(cards, 1.0);
    let found = errors(&runs, "turn", |t, observed| {
        off(
            observed.moment,
            Vector3::new(0.0, 0.0, -12.0 * (2.0 * t).sin()),
        )
    });
    check_order("rotation joint", "moment, of 12 N m [N m]", found, 5e-3);
}

// A flap on a hinge whose spring is relaxed at A sin(w t), from rest:
// phi = A k / (k - J w^2) (sin(w t) - w/w_0 sin(w_0 t)).
#[test]
fn a_hinge_whose_relaxed_angle_is_driven() {
    let (inertia, stiffness, frequency) = (0.5_f64, 50.0_f64, 3.0);
    let cards = format!(
        "[[node]]\nname = \"mast\"\nposition = [0, 0, 0]\n[[clamp]]\nnode = \"mast\"\n\
         [[node]]\nname = \"flap\"\nposition = [0, 0, 0]\n\
         [[body]]\nname = \"flap\"\nnode = \"flap\"\nmass = 1\ninertia = [1, 1, {inertia}]\n\
         [[hinge]]\nname = \"hinge\"\nnodes = [\"mast\", \"flap\"]\naxis = [0, 0, 1]\n\
         stiffness = {stiffness}\nangle = \"= 0.4*sin({frequency}*t)\"\n"
    );
    let runs = runs(&cards, 2.0);
    let own = (stiffness / inertia).sqrt();
    let size = 0.4 * stiffness / (stiffness - inertia * frequency * frequency);
    let angle = |t: f64| size * ((frequency * t).sin() - frequency / own * (own * t).sin());
    let case = "hinge with a driven relaxed angle";
    let found = errors(&runs, "hinge", |t, observed| {
        (observed.angle.unwrap() - angle(t)).abs()
    });
    check_order(case, "angle [rad]", found, 2e-3);
    let found = errors(&runs, "hinge", |t, observed| {
        let relaxed = 0.4 * (frequency * t).sin();
        let moment = -stiffness * (angle(t) - relaxed);
        off(observed.moment, Vector3::new(0.0, 0.0, moment))
    });
    check_order(case, "moment, of 9 N m [N m]", found, 0.1);
}
