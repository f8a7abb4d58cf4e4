//! Motion in time against closed forms and the prototype's numbers.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::vector;
use std::f64::consts::{PI, TAU};

use super::{Run, read, reference, text};
use crate::analysis::statics::statics;
use crate::input::rotors::distributor::{Actuators, Links};

/// Speed of the rotors [rad/s]: 300 rpm.
const OMEGA: f64 = 10.0 * PI;

// theta = theta0 + theta1c cos psi + theta1s sin psi + 2/rev + own, nose up, with psi from azimuth zero
// along x. The bearing prescribes it: round-off. Controls that change grow from zero, so that the
// blades are not twisted at first.
#[test]
fn blades_have_the_pitch_of_the_formula() {
    let keys = "speed = 300\nazimuth = 10\n[rotor.swashplate]\ncollective = 8\n\
                cosine = \"= 200*t^2\"\nsine = \"dip\"\n\
                harmonic = [{ order = 2, cosine = \"= 50*t^2\", sine = \"= -20*t^2\" }]\n\
                individual = [0, \"= 100*t^2\", \"= -300*t^2\"]\n";
    let rest = "[drives.dip]\nexpression = \"-400*t^2\"\n[transient]\nto = 0.1\nstep = 2e-3\n\
                newton.tolerance = 1e-12\n";
    let run = Run::new(&text("rigid", keys, rest));
    for k in 0..3_u8 {
        let node = format!("r {}/pitch", k + 1);
        for (time, [hub, blade]) in run.motions(["r/hub", &node]) {
            let psi = (10.0 + 120.0 * f64::from(k)).to_radians();
            let back = vector::to_rotation(&(Vector3::z() * -psi));
            let turn: Matrix3<f64> = hub.rotation.transpose() * blade.rotation * back;
            let found = vector::from_rotation(&turn);
            let azimuth = psi + OMEGA * time;
            let own = [0.0, 100.0, -300.0][usize::from(k)];
            let growing = 200.0 * azimuth.cos() - 400.0 * azimuth.sin()
                + 50.0 * (2.0 * azimuth).cos()
                - 20.0 * (2.0 * azimuth).sin()
                + own;
            let expected = (8.0 + growing * time * time).to_radians();
            let span = Vector3::new(psi.cos(), psi.sin(), 0.0);
            let off = (found - span * expected).amax();
            assert!(off < 1e-9, "blade {k} at {time}: {off:e}");
        }
    }
}

/// The position and the axes of a node in the equilibrium at rest.
fn at_rest(text: &str, names: &[&str]) -> Vec<(Vector3<f64>, Matrix3<f64>)> {
    let input = read(text);
    let outcome = statics(&input.model, &input.statics.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let last = outcome.result.steps.last().unwrap();
    let nodes = input.model.system.nodes();
    let index = |name: &&str| nodes.iter().position(|node| node.label == **name).unwrap();
    let found = names.iter().map(index);
    found
        .map(|index| (last.positions[index], last.rotations[index]))
        .collect()
}

/// Actuators of a plate.
const ACTUATORS: &str = "actuators = { radius = 0.2, base_radius = 0.22, base_below = 0.3 }\n";

/// The links of the prototype, whose horns are ahead of the blades.
fn links() -> Links {
    let (sin, cos) = 75.0_f64.to_radians().sin_cos();
    Links {
        below: 0.15,
        horn: [0.2 * cos, 0.2 * sin],
        precone: 0.0,
        undersling: 0.0,
    }
}

// The pitch of each blade of a model of plates and rigid links is the one of the kinematics of the
// links, which is compared with the prototype where it is defined: exact for constant controls, at
// nine azimuths, and linear for controls that change.
#[test]
fn plates_and_links_give_the_pitch_of_their_kinematics() {
    let links = links();
    let plate = format!(
        "[rotor.swashplate.plate]\nbelow = 0.15\nhorn = {:?}\n",
        links.horn
    );
    let pitch = |hub: &Matrix3<f64>, blade: &Matrix3<f64>, psi: f64| {
        let arm = hub * vector::to_rotation(&(Vector3::z() * psi));
        vector::from_rotation(&(arm.transpose() * blade)).x
    };
    let exact = links
        .exact([8.0_f64, 2.0, -4.0].map(f64::to_radians))
        .unwrap();
    for first in [0.0, 25.0, 50.0_f64] {
        let keys = format!(
            "speed = 300\nazimuth = {first}\n[rotor.swashplate]\ncollective = 8\ncosine = 2\n\
             sine = -4\n{plate}"
        );
        let names = ["r/hub", "r 1/pitch", "r 2/pitch", "r 3/pitch"];
        let found = at_rest(&text("rigid", &keys, "[static]\n"), &names);
        for k in 0..3_u8 {
            let psi = first.to_radians() + TAU * f64::from(k) / 3.0;
            let found = pitch(&found[0].1, &found[usize::from(k) + 1].1, psi);
            let expected = links.pitch(&exact, psi).unwrap();
            assert!((found - expected).abs() < 1e-9, "{psi}: {found} {expected}");
        }
    }
    // Actuators hold a plate with scissors, and the rotating one has the angle of the prescribed plate: without
    // it the pitch would be off by a_x a_y / 2 of the cyclic pitch, 2e-4 rad at the end.
    for (turning, actuators) in [
        ("speed = 300", ""),
        ("speed = 300", ACTUATORS),
        ("angle = \"= 1800*t\"", ACTUATORS),
        (
            "angle = { kind = \"table\", rows = [[0, 0], [1, 1800]] }",
            ACTUATORS,
        ),
    ] {
        let keys = format!(
            "{turning}\n[rotor.swashplate]\ncollective = \"= 800*t^2\"\ncosine = \"= 200*t^2\"\n\
             sine = \"= -400*t^2\"\n{plate}{actuators}"
        );
        let rest = "[transient]\nto = 0.1\nstep = 2e-3\nnewton.tolerance = 1e-12\n";
        let run = Run::new(&text("rigid", &keys, rest));
        for (time, [hub, blade]) in run.motions(["r/hub", "r 2/pitch"]) {
            let controls = [800.0_f64, 200.0, -400.0].map(|rate| (rate * time * time).to_radians());
            let position = links.linear() * Vector3::from(controls);
            let psi = TAU / 3.0;
            let found = pitch(&hub.rotation, &blade.rotation, psi);
            let expected = links.pitch(&position.into(), psi + OMEGA * time).unwrap();
            let off = (found - expected).abs();
            assert!(
                off < 1e-9,
                "{turning} {actuators} {time}: {found} {expected}"
            );
        }
    }
}

// The second construction: three actuators of the lengths for the pitch hold the plate at the height
// and tilt of a prescribed plate; there, the distances from the bases to the rim of the plate are the
// lengths of the prototype, 1e-6 m as accepted.
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
            at_rest(&text("rigid", &keys, "[static]\n"), &["r/plate"])[0]
        });
        for (position, axes) in &found {
            assert!(
                (position.z + 0.15 - exact[0]).abs() < 1e-9,
                "{theta:?} {position}"
            );
            let turn = vector::to_rotation(&Vector3::new(exact[1], exact[2], 0.0));
            let off = (axes.column(2) - turn.column(2)).amax();
            assert!(off < 1e-9, "{theta:?} {off:e}");
        }
        for (azimuth, expected) in [90.0_f64, 210.0, 330.0].into_iter().zip(&exact[3..]) {
            let (sin, cos) = azimuth.to_radians().sin_cos();
            let rim = Vector3::new(0.2 * cos, 0.2 * sin, 0.0);
            let base = rim - Vector3::z() * 0.45;
            let length = (found[0].0 + found[0].1 * rim - base).norm();
            assert!(
                (length - expected).abs() < 1e-6,
                "{theta:?}: {length} {expected}"
            );
        }
    }
}

// A prescribed plate, and one on three actuators, while the controls change, in time and with all links: the
// lengths from the bases to the rim, the height and the normal are the ones by the kinematics of the links, to
// 1e-9 of 1e-6 m as accepted. The tilt grows to 4 deg.
#[test]
fn a_plate_has_its_lengths_while_controls_change() {
    let links = links();
    let actuators = Actuators {
        radius: 0.2,
        base_radius: 0.22,
        base_below: 0.3,
        azimuths: Vec::new(),
    };
    for kind in [
        "",
        "actuators = { radius = 0.2, base_radius = 0.22, base_below = 0.3 }\n",
    ] {
        let keys = format!(
            "speed = 300\n[rotor.swashplate]\ncollective = \"= 800*t^2\"\n\
             cosine = \"= 200*t^2\"\nsine = \"= -400*t^2\"\n\
             [rotor.swashplate.plate]\nbelow = 0.15\nhorn = {:?}\n{kind}",
            links.horn
        );
        let rest = "[transient]\nto = 0.1\nstep = 2e-3\nnewton.tolerance = 1e-12\n";
        let run = Run::new(&text("rigid", &keys, rest));
        for (time, [plate]) in run.motions(["r/plate"]) {
            let controls = [800.0_f64, 200.0, -400.0].map(|rate| (rate * time * time).to_radians());
            let position = links.linear() * Vector3::from(controls);
            let turn = vector::to_rotation(&Vector3::new(position.y, position.z, 0.0));
            let height = plate.position.z + 0.15 - position.x;
            let normal = plate.rotation.column(2) - turn.column(2);
            assert!(height.abs() < 1e-9, "{kind} {time}: {height:e}");
            assert!(normal.amax() < 1e-9, "{kind} {time}: {normal}");
            for azimuth in [90.0_f64, 210.0, 330.0] {
                let [rim, base] = actuators.ends(azimuth.to_radians());
                // The prescribed plate has the rotation vector of the tilt, the other one scissors.
                let expected = match kind {
                    "" => (Vector3::z() * position.x + turn * rim - base).norm(),
                    _ => actuators.length(azimuth.to_radians(), position.into()),
                };
                let arm = plate.position + Vector3::z() * 0.15;
                let found = (arm + plate.rotation * rim - base).norm();
                let off = (found - expected).abs();
                assert!(off < 1e-9, "{kind} {time} {azimuth}: {off:e}");
            }
        }
    }
}

// A torque on a free shaft, omega' = M / J, after the first step, whose force is of first order.
#[test]
fn a_torque_accelerates_the_shaft() {
    let keys = "torque = \"6 N*m\"\nspeed = 60\n";
    let rest = "[transient]\nto = 0.4\nstep = 5e-3\n";
    let run = Run::new(&text("rigid", keys, rest));
    let inertia = 3.0 * 2.0 * (1.2_f64.powi(3) - 0.2_f64.powi(3)) / 3.0;
    let motions = run.motions(["r/hub"]);
    let [(early, [first]), (late, [last])] = [&motions[40], &motions[80]];
    let found = (last.angular_velocity.z - first.angular_velocity.z) / (late - early);
    assert!((first.angular_velocity.z - TAU).abs() < 1.0);
    assert!((found * inertia / 6.0 - 1.0).abs() < 2e-3, "{found}");
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
