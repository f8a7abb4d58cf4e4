//! Motion in time against closed forms and the prototype's numbers.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::vector;
use std::f64::consts::{PI, TAU};

use super::{Run, read, reference, text};
use crate::input::rotors::distributor::Links;
use crate::model::NodeMotion;

/// Speed of the rotors [rad/s]: 300 rpm.
const OMEGA: f64 = 10.0 * PI;

fn relative(motions: &[NodeMotion; 2]) -> Vector3<f64> {
    let turn: Matrix3<f64> = motions[0].rotation.transpose() * motions[1].rotation;
    vector::from_rotation(&turn)
}

// theta = theta0 + theta1c cos psi + theta1s sin psi + 2/rev + own, nose up, with psi from azimuth zero
// along x. The bearing prescribes it: round-off.
#[test]
fn blades_have_the_pitch_of_the_formula() {
    let keys = "speed = 300\nazimuth = 10\n[rotor.swashplate]\ncollective = 8\ncosine = \"= 2 + t\"\n\
                sine = \"dip\"\nharmonic = [{ order = 2, cosine = 0.5, sine = \"0.2 deg\" }]\n\
                individual = [0, 1, \"= -3*t\"]\n";
    let rest = "[drives.dip]\nkind = \"constant\"\nvalue = -4\n[transient]\nto = 0.1\nstep = 2e-3\n\
                start_accelerations = \"dummy\"\nnewton.tolerance = 1e-12\n";
    let run = Run::new(&text("rigid", keys, rest));
    for k in 0..3 {
        let node = format!("r {}/pitch", k + 1);
        for (time, motions) in run.motions(["r/hub", &node]) {
            let psi = (10.0_f64 + 120.0 * f64::from(k)).to_radians();
            let found = vector::from_rotation(
                &(motions[0].rotation.transpose()
                    * motions[1].rotation
                    * vector::to_rotation(&(Vector3::z() * -psi))),
            );
            let azimuth = psi + OMEGA * time;
            let own = [0.0, 1.0, -3.0 * time][k as usize];
            let expected = 8.0 + (2.0 + time) * azimuth.cos() - 4.0 * azimuth.sin()
                + 0.5 * (2.0 * azimuth).cos()
                + 0.2 * (2.0 * azimuth).sin()
                + own;
            let span = Vector3::new(psi.cos(), psi.sin(), 0.0);
            let off = (found - span * expected.to_radians()).amax();
            assert!(off < 1e-9, "blade {k} at {time}: {off:e}");
        }
    }
}

// The pitch of each blade of a model of plates and rigid links is the one of the kinematics of the
// links, which is compared with the prototype where it is defined.
#[test]
fn plates_and_links_give_the_pitch_of_their_kinematics() {
    let (sin, cos) = 75.0_f64.to_radians().sin_cos();
    let horn = [0.2 * cos, 0.2 * sin];
    let keys = format!(
        "speed = 300\n[rotor.swashplate]\ncollective = 8\ncosine = 2\nsine = -4\n\
         [rotor.swashplate.plate]\nbelow = 0.15\nhorn = {horn:?}\n"
    );
    let rest = "[transient]\nto = 0.1\nstep = 2e-3\nnewton.tolerance = 1e-12\n";
    let run = Run::new(&text("rigid", &keys, rest));
    let links = Links {
        below: 0.15,
        horn,
        precone: 0.0,
        undersling: 0.0,
    };
    let position = links
        .exact([8.0_f64, 2.0, -4.0].map(f64::to_radians))
        .unwrap();
    for k in 0..3_u8 {
        let node = format!("r {}/pitch", k + 1);
        for (time, motions) in run.motions(["r/hub", &node]) {
            let psi = TAU * f64::from(k) / 3.0;
            let turn = vector::to_rotation(&(Vector3::z() * psi));
            let arm = motions[0].rotation * turn;
            let found = vector::from_rotation(&(arm.transpose() * motions[1].rotation)).x;
            let expected = links.pitch(&position, psi + OMEGA * time).unwrap();
            assert!(
                (found - expected).abs() < 1e-9,
                "{time}: {found} {expected}"
            );
        }
    }
}

// The second construction: three actuators of the lengths for the pitch hold the plate at the height and
// tilt of a prescribed plate; in both, the distances from the bases to the rim of a plate are the
// lengths of the prototype, 1e-6 m as accepted, up to the spin of the plate in its scissors.
#[test]
fn actuators_hold_the_plate_where_it_is_prescribed() {
    let json: serde_json::Value =
        serde_json::from_str(&reference("theory-rotor/gimbal_swashplate.json")).unwrap();
    let (sin, cos) = 75.0_f64.to_radians().sin_cos();
    for case in json["swashplate"]["cases"].as_array().unwrap() {
        let numbers = |key: &str| -> Vec<f64> {
            let list = case[key].as_array().unwrap().iter();
            list.map(|number| number.as_f64().unwrap()).collect()
        };
        let (theta, exact) = (numbers("theta_deg"), numbers("exact"));
        let plates = [
            "",
            "actuators = { radius = 0.2, base_radius = 0.2, base_below = 0.3 }\n",
        ];
        let found = plates.map(|actuators| {
            let keys = format!(
                "speed = 300\n[rotor.swashplate]\ncollective = {}\ncosine = {}\nsine = {}\n\
                 [rotor.swashplate.plate]\nbelow = 0.15\nhorn = [{:?}, {:?}]\n{actuators}",
                theta[0],
                theta[1],
                theta[2],
                0.2 * cos,
                0.2 * sin
            );
            let rest = "[transient]\nto = 0.01\nstep = 2e-3\nnewton.tolerance = 1e-12\n";
            let run = Run::new(&text("rigid", &keys, rest));
            let motions = run.motions(["r/plate"]);
            motions.last().unwrap().1[0].clone()
        });
        for plate in &found {
            assert!((plate.position.z + 0.15 - exact[0]).abs() < 1e-9);
            let turn = vector::to_rotation(&Vector3::new(exact[1], exact[2], 0.0));
            let off = (plate.rotation.column(2) - turn.column(2)).amax();
            assert!(off < 1e-9, "{theta:?} {off:e}");
        }
        for (azimuth, expected) in [90.0_f64, 210.0, 330.0].into_iter().zip(&exact[3..]) {
            let (sin, cos) = azimuth.to_radians().sin_cos();
            let rim = Vector3::new(0.2 * cos, 0.2 * sin, 0.0);
            let base = rim - Vector3::z() * 0.45;
            let length = (found[0].position + found[0].rotation * rim - base).norm();
            assert!(
                (length - expected).abs() < 1e-6,
                "{theta:?}: {length} {expected}"
            );
        }
    }
}

/// A joint that tilts the yoke about a direction that does not turn, smoothly to 12 degrees.
const TILT: &str = "
[[node]]
name = \"tilter\"
position = [0, 0, 0]
[[joint]]
kind = \"total\"
nodes = [\"tilter\"]
locked = [\"x\", \"y\", \"z\", \"about y\", \"about z\"]
rotation = { x = { kind = \"ramp\", to = 12, end = 0.1, shape = \"smooth\" } }
[[joint]]
kind = \"plane-rotation\"
nodes = [\"tilter\", \"r/yoke\"]
axis = [0, 0, 1]
";

// Two universal joints in phase whose link slides: the yoke turns about its own axis with the speed
// of the mast at every tilt, where one joint would vary it by 2 %. Accepted: 1e-6 at 12 degrees.
// The intermediate link varies by cos(6 deg), 0.55 %.
#[test]
fn a_gimballed_hub_turns_at_the_speed_of_its_mast() {
    let rest = format!("{TILT}[transient]\nto = 0.4\nstep = 5e-4\nnewton.tolerance = 1e-12\n");
    let run = Run::new(&text("gimballed", "speed = 300\nlink = 0.1\n", &rest));
    let mut largest = [0.0_f64; 2];
    let mut tilts = [f64::INFINITY, 0.0_f64];
    let motions = run.motions(["r/hub", "r/yoke", "r/lower link"]);
    for (_, [hub, yoke, link]) in motions.iter().filter(|one| one.0 > 0.2) {
        let speed = |node: &NodeMotion| node.rotation.column(2).dot(&node.angular_velocity);
        let tilt = hub
            .rotation
            .column(2)
            .dot(&yoke.rotation.column(2))
            .acos()
            .to_degrees();
        tilts = [tilts[0].min(tilt), tilts[1].max(tilt)];
        largest[0] = largest[0].max((speed(yoke) / speed(hub) - 1.0).abs());
        largest[1] = largest[1].max((speed(link) / speed(hub) - 1.0).abs());
    }
    assert!(
        (tilts[0] - 12.0).abs() < 1e-6 && (tilts[1] - 12.0).abs() < 1e-6,
        "{tilts:?}"
    );
    assert!(largest[0] < 1e-6, "{largest:?}");
    let cosine = 6.0_f64.to_radians().cos();
    assert!(
        (largest[1] - (1.0 / cosine - 1.0)).abs() < 1e-4,
        "{largest:?}"
    );
}

// A torque on a free shaft: omega = omega0 + M t / J.
#[test]
fn a_torque_accelerates_the_shaft() {
    let keys = "torque = \"6 N*m\"\nspeed = 60\n";
    let rest = "[transient]\nto = 0.5\nstep = 5e-3\n";
    let run = Run::new(&text("rigid", keys, rest));
    let inertia = 3.0 * 2.0 * (1.2_f64.powi(3) - 0.2_f64.powi(3)) / 3.0;
    let motions = run.motions(["r/hub"]);
    let (time, [hub]) = motions.last().unwrap();
    let expected = TAU + 6.0 * time / inertia;
    assert!(
        (hub.angular_velocity.z / expected - 1.0).abs() < 1e-4,
        "{}",
        hub.angular_velocity.z
    );
}

// Two rotors, one on a node, each about its own shaft: hubs turn with their speeds, tips stay on
// circles about their shafts, up to the stretch of the blades, 1e-6 of the radius.
#[test]
fn several_rotors_turn_about_their_own_shafts() {
    let second = "[[rotor]]\nname = \"tail\"\nhub = \"teetering\"\nblades = 2\nspeed = 900\n\
                  node = \"boom\"\ncenter = [6, 0.2, 1]\naxis = [0, 1, 0]\naft = [1, 0, 0]\n\
                  [rotor.blade]\nhub_radius = 0.1\nproperties = \"strip\"\n\
                  piece = [{ length = 0.5, elements = 1 }]\n[[node]]\nname = \"boom\"\n\
                  position = [6, 0, 1]\n[[clamp]]\nnode = \"boom\"\n\
                  [transient]\nto = 0.1\nstep = 5e-4\n";
    let run = Run::new(&text("rigid", "speed = 300\ncenter = [0, 0, 1]\n", second));
    assert_eq!(run.model.blades.len(), 5);
    for (hub, tip, axis, speed, radius) in [
        ("r/hub", "r 2/tip", Vector3::z(), OMEGA, 1.2),
        ("tail/hub", "tail 1/tip", Vector3::y(), 3.0 * OMEGA, 0.6),
    ] {
        for (time, [hub, tip]) in run.motions([hub, tip]) {
            let turn = vector::to_rotation(&(axis * (speed * time)));
            let start = run.model.system.nodes()[run.index("r/hub")].rotation;
            if axis == Vector3::z() {
                assert!((hub.rotation - turn * start).amax() < 1e-9);
            }
            assert!(
                (hub.angular_velocity - axis * speed).amax() < 1e-3 * speed,
                "{time}"
            );
            let arm = tip.position - hub.position;
            assert!((arm.norm() / radius - 1.0).abs() < 1e-5, "{}", arm.norm());
            assert!(arm.dot(&axis).abs() < 1e-6);
        }
    }
}

#[test]
fn blades_begin_with_the_speed_of_the_rotor() {
    let rest = "[transient]\nto = 0.1\nstep = 1e-3\n";
    let input = read(&text(
        "rigid",
        "speed = 300\naxis = [0, 1, 1]\ncenter = [1, 0, 0]\n",
        rest,
    ));
    let axis = Vector3::new(0.0, 1.0, 1.0).normalize() * OMEGA;
    let nodes = input.model.system.nodes().iter().zip(&input.model.initial);
    for (node, initial) in nodes {
        let velocity = axis.cross(&(node.position - Vector3::x()));
        let found = initial.velocity.unwrap();
        assert!(
            (found - velocity).amax() < 1e-12 * OMEGA,
            "{}: {found}",
            node.label
        );
        assert!((initial.angular_velocity.unwrap() - axis).amax() < 1e-12 * OMEGA);
    }
}
