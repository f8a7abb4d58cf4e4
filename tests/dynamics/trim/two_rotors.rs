//! Two rotors that turn in opposite senses on one fuselage, trimmed in forward flight by six forces.

use super::trimmed;
use crate::effort::is_long;

const SPEED: f64 = 20.0;
const WEIGHT: f64 = 30e3;
/// Distance of the rotors from the middle of the fuselage \[m\].
const ASIDE: f64 = 5.2;

/// A rotor of three blades on flap hinges at a place across; about z, or against it.
fn rotor(name: &str, side: f64) -> String {
    // The mirror image of a rotor turns about -z, and its pitch is nose down about its own axis. The
    // pitch of the left one is less by the difference of both.
    let sign = -side;
    format!(
        "[[rotor]]\nname = \"{name}\"\nhub = \"articulated\"\nnode = \"fuselage\"\n\
         center = [0, {:?}, 1.5]\nblades = 3\nspeed = 30\naxis = [0, 0, {sign:?}]\naft = [1, 0, 0]\n\
         mass = 50\n[[rotor.hinge]]\nkind = \"flap\"\noffset = 0.25\n[rotor.swashplate]\n\
         collective = \"= {sign:?}*collective - difference\"\nsine = \"= {sign:?}*sine - turn\"\n\
         [rotor.blade]\nhub_radius = 0.25\nproperties = \"spar\"\n\
         piece = [{{ length = 4.75, elements = 1 }}]\n[rotor.blade.aerodynamics]\n\
         section = \"quasi_steady\"\nstrips = 2\nstations = [\n\
         {{ at = 0.75, chord = 0.3, airfoil = \"naca0012\" }},\n\
         {{ at = 4.75, chord = 0.3, airfoil = \"naca0012\" }} ]\n",
        side * ASIDE
    )
}

/// The right rotor of [`rotor`] by its sense of rotation.
fn clockwise() -> String {
    let turned = [
        ("axis = [0, 0, -1.0]", "direction = \"clockwise\""),
        (
            "= -1.0*collective - difference",
            "= collective + difference",
        ),
        ("= -1.0*sine - turn", "= sine + turn"),
    ];
    turned.iter().fold(rotor("right", 1.0), |text, (from, to)| {
        assert!(text.contains(from), "{text}");
        text.replace(from, to)
    })
}

/// The rotorcraft with its center of mass off the middle; x is aft, y to the right and z up. The fuselage
/// has a drag polar and a lift by its pitch, times areas [m^2]. The search begins with a pitch and a roll.
fn rotorcraft(off: f64, [pitch, roll]: [f64; 2], stages: &str) -> String {
    let pressure = 0.5 * 1.225 * SPEED * SPEED;
    let mut text = format!(
        "[gravity]\nacceleration = [0, 0, -9.81]\n[air]\ndensity = 1.225\nwind = [{SPEED:?}, 0, 0]\n\
         [properties.spar]\nea = 7e8\ngay = 2e8\ngaz = 2e8\ngj = 3e6\neiy = 2e6\neiz = 4e6\nm = 6\n\
         iy = 1e-3\niz = 1e-2\ndamping = {{ time = 1e-2 }}\n\
         [[node]]\nname = \"stand\"\nposition = [0, 0, 0]\n\
         [[node]]\nname = \"fuselage\"\nposition = [0, 0, 0]\n\
         [[joint]]\nname = \"pitch\"\nkind = \"revolute\"\nnodes = [\"stand\"]\nat = [0, 0, 0]\n\
         axis = [0, 1, 0]\nangle = \"= pitch\"\n\
         [[joint]]\nname = \"roll\"\nkind = \"revolute\"\nnodes = [\"stand\", \"fuselage\"]\n\
         at = [0, 0, 0]\naxis = [1, 0, 0]\nangle = \"= roll\"\n\
         [[body]]\nname = \"fuselage\"\nnode = \"fuselage\"\nmass = {:?}\noffset = [0, {off:?}, 0]\n\
         inertia = [1e4, 1e4, 1e4]\n\
         [[load]]\nname = \"drag\"\nnode = \"fuselage\"\nforce = [1, 0, 0]\n\
         drive = \"= {pressure:?}*(1.2 + 4*pitch^2)\"\n\
         [[load]]\nname = \"lift\"\nnode = \"fuselage\"\nforce = [0, 0, 1]\n\
         drive = \"= {pressure:?}*6*pitch\"\n",
        WEIGHT / 9.81
    );
    text += &(rotor("left", -1.0) + &rotor("right", 1.0));
    for (quantity, size) in [("force", WEIGHT), ("moment", WEIGHT * ASIDE)] {
        for axis in ["x", "y", "z"] {
            text += &format!(
                "[sensors.{quantity}_{axis}]\nquantity = \"reaction_{quantity}\"\nof = \"pitch\"\n\
                 node = \"stand\"\ncomponent = \"{axis}\"\n\
                 [[trim.target]]\nname = \"{quantity} along {axis}\"\n\
                 signal = \"= {quantity}_{axis}\"\nvalue = 0\nscale = {size:?}\n"
            );
        }
    }
    let guesses = [
        ("collective", 0.1),
        ("difference", 0.0),
        ("sine", -0.03),
        ("turn", 0.0),
        ("pitch", pitch),
        ("roll", roll),
    ];
    for (name, guess) in guesses {
        text += &format!(
            "[[trim.control]]\nname = \"{name}\"\nguess = {guess:?}\nscale = 0.1\nstep = 0.1\n"
        );
    }
    text + &format!(
        "[periodic]\nspeed = 30\nsteps = 12\nstages = \"{stages}\"\ntolerance = 1e-8\nsettle = 1\n[trim]\n"
    )
}

/// Attitude of the first guess [rad].
const GUESS: [f64; 2] = [-0.03, 0.0];

/// Controls that meet the six targets, from an attitude.
fn controls(off: f64, start: [f64; 2], stages: &str) -> Vec<f64> {
    let point = &trimmed(&rotorcraft(off, start, stages))[0];
    assert!(point.iterations <= 6, "{point:?}");
    let sizes = [WEIGHT; 3].into_iter().chain([WEIGHT * ASIDE; 3]);
    for ([found, required], size) in point.targets.iter().zip(sizes) {
        assert!((found - required).abs() < 1e-7 * size, "{point:?}");
    }
    point.controls.clone()
}

// Rotors that turn in opposite senses are mirror images: with the center of mass in the middle the
// difference of the pitch, the cyclic pitch against yaw and the roll vanish, where two rotors of one sense
// would roll and yaw. In the long form the center is to the right and to the left: these three controls
// change their sign, and the right rotor lifts more if the mass is to the right.
#[test]
fn six_forces_of_two_rotors_in_opposite_senses() {
    let middle = controls(0.0, GUESS, "two");
    println!("{middle:?}");
    for odd in [1, 3, 5] {
        assert!(middle[odd].abs() < 1e-7, "{middle:?}");
    }
    // Thrust and rotors tilt forward against the drag.
    assert!(
        middle[0] > 0.05 && middle[2] < -0.01 && middle[4] < -1e-3,
        "{middle:?}"
    );
    if is_long() {
        let [right, left] = [0.1, -0.1].map(|off| controls(off, GUESS, "two"));
        assert!(right[1] > 1e-3, "{right:?}");
        for (i, (right, left)) in right.iter().zip(&left).enumerate() {
            let image = if i % 2 == 1 { -left } else { *left };
            assert!((right - image).abs() < 1e-7, "{i}: {right} {left}");
        }
    }
}

// The solution is of the motion alone: from attitudes up to 0.13 rad apart the same controls, to the tolerance
// of Newton's method, 1e-8, times 10 for the sizes of the controls. In axes of the attitude of the start the
// controls differ by up to 3e-3 rad with two stages and by 4e-6 rad with three.
#[test]
fn the_attitude_of_the_start_does_not_change_the_trim() {
    for stages in ["two", "three"] {
        let first = controls(0.1, GUESS, stages);
        for start in [[0.03, 0.03], [-0.1, -0.03]] {
            let other = controls(0.1, start, stages);
            for (first, other) in first.iter().zip(&other) {
                let off = (first - other).abs();
                assert!(off < 1e-7, "{stages} {start:?}: {first} {other}");
            }
        }
    }
}

// The right rotor as the mirror image of the left one, with pitch and thrust of the same sign, has the controls of
// the rotor that is written upside down.
#[test]
fn the_sense_of_rotation_mirrors_a_rotor() {
    let text = rotorcraft(0.1, GUESS, "two");
    let keyed = text.replace(&rotor("right", 1.0), &clockwise());
    assert!(keyed.contains("direction = "));
    let [written, keyed] = [text, keyed].map(|text| trimmed(&text)[0].controls.clone());
    for (written, keyed) in written.iter().zip(&keyed) {
        assert!((written - keyed).abs() < 1e-8, "{written} {keyed}");
    }
}
