//! Trims far from their solution, beyond stall, and with controls that do not determine their targets.

use super::attempt;
use crate::effort::is_long;

/// Three flapping blades in a wind along x across the shaft, of one element and two strips each.
fn rotor(swashplate: &str, controls: &str, targets: &str) -> String {
    format!(
        "[properties.spar]\nea = 7e8\ngay = 2e8\ngaz = 2e8\ngj = 3e6\neiy = 2e6\neiz = 4e6\nm = 6\n\
         iy = 1e-3\niz = 1e-2\ndamping = {{ time = 1e-3 }}\n\
         [air]\ndensity = 1.225\nwind = [15, 0, 0]\n\
         [[rotor]]\nname = \"r\"\nhub = \"articulated\"\nblades = 3\nspeed = 30\n\
         [[rotor.hinge]]\nkind = \"flap\"\noffset = 0.2\nstiffness = 1e4\n\
         [rotor.inflow]\nkind = \"uniform\"\n[rotor.swashplate]\n{swashplate}\
         [rotor.blade]\nhub_radius = 0.2\nproperties = \"spar\"\n\
         piece = [{{ length = 4.8, elements = 1 }}]\n\
         [rotor.blade.aerodynamics]\nsection = \"quasi_steady\"\nstrips = 2\nstations = [\n\
         {{ at = 0.6, chord = 0.3, airfoil = \"naca0012\" }},\n\
         {{ at = 4.8, chord = 0.3, airfoil = \"naca0012\" }} ]\n\
         [sensors.lift]\nquantity = \"thrust\"\n\
         [sensors.flap]\nquantity = \"joint_angle\"\nof = \"r 1/flap\"\n\
         [periodic]\nspeed = 30\nsteps = 12\nstages = \"two\"\n[trim]\n{controls}{targets}"
    )
}

const ALL: &str = "collective = \"c\"\ncosine = \"f\"\nsine = \"s\"\n";

fn control(name: &str, guess: f64) -> String {
    format!("[[trim.control]]\nname = \"{name}\"\nguess = {guess:?}\n")
}

fn targets(thrust: f64) -> String {
    let flap = |name: &str, part: &str| {
        format!(
            "[[trim.target]]\nname = \"{name}\"\nsignal = \"flap\"\nharmonic = 1\n\
             part = \"{part}\"\nvalue = 0\nscale = 0.1\n"
        )
    };
    format!(
        "[[trim.target]]\nname = \"thrust\"\nsignal = \"lift\"\nvalue = {thrust:?}\n\
         scale = {thrust:?}\n{}{}",
        flap("forward", "cosine"),
        flap("sideward", "sine")
    )
}

fn controls(guess: [f64; 3]) -> String {
    let all = ["c", "f", "s"].into_iter().zip(guess);
    all.map(|(name, guess)| control(name, guess)).collect()
}

// Guesses of 0.2 rad of collective and 0.1 of cyclic, near stall, lead to the controls that begin near the
// solution: to 1e-5 rad, the tolerance of both motions. Guesses of zero too.
#[test]
fn far_guesses_lead_to_the_same_controls() {
    let from = |guess: [f64; 3]| {
        let outcome = attempt(&rotor(ALL, &controls(guess), &targets(6000.0)));
        assert_eq!(outcome.result.points[0].failure, None, "{guess:?}");
        assert_eq!(outcome.result.remarks, Vec::<String>::new(), "{guess:?}");
        outcome.result.points[0].controls.clone()
    };
    let near = from([0.08, 0.0, -0.02]);
    assert!(near.iter().all(|own| own.abs() < 0.15), "{near:?}");
    for guess in [[0.0; 3], [0.2, 0.1, -0.1], [0.2, -0.1, 0.1]] {
        let found = from(guess);
        for (found, near) in found.iter().zip(&near) {
            assert!((found - near).abs() < 1e-5, "{guess:?}: {found} {near}");
        }
    }
}

// The blades have a lift of 20.7 kN at a lift coefficient of one, by the integral of `rho c W^2 r^2 / 2`
// over three blades, and the section has 1.2 at most: 80 kN are impossible. The failure has the largest
// thrust that was reached, with angles of attack near stall, which is at 14 deg or beyond.
#[test]
fn an_impossible_thrust_has_the_largest_one_and_stall() {
    let text = rotor("collective = \"c\"\n", &control("c", 0.1), "")
        + "[[trim.target]]\nname = \"thrust\"\nsignal = \"lift\"\nvalue = 80e3\nscale = 8e4\n";
    let outcome = attempt(&text);
    let point = &outcome.result.points[0];
    let [reason, remedy] = point.failure.clone().unwrap();
    let (_, after) = reason.split_once("are met up to \"thrust\" = ").unwrap();
    let reached: f64 = after.split(' ').next().unwrap().parse().unwrap();
    assert!((1.2e4..3e4).contains(&reached), "{reason}");
    let (_, after) = reason.split_once("at angles of attack up to ").unwrap();
    let angle: f64 = after.split(' ').next().unwrap().parse().unwrap();
    assert!((10.0..25.0).contains(&angle), "{reason}");
    assert!(remedy.contains("stall limits thrust"), "{remedy}");
    assert!(point.controls[0].abs() < 0.7, "{point:?}");
}

// With two cyclic controls and the flapping as targets too, the thrust is the one that is named, and the others
// are met.
#[test]
fn the_target_out_of_reach_is_named() {
    let outcome = attempt(&rotor(ALL, &controls([0.1, 0.0, -0.02]), &targets(80e3)));
    let point = &outcome.result.points[0];
    let [reason, _] = point.failure.clone().unwrap();
    let begin = "\"thrust\" is out of reach while all other targets are met: ";
    assert!(reason.starts_with(begin), "{reason}");
    assert!(reason.contains("are met up to \"thrust\" = "), "{reason}");
    // Of scale one, to the part of it from which a target counts as not met.
    for [found, required] in &point.targets[1..] {
        assert!((found - required).abs() < 1e-3, "{point:?}");
    }
    assert!(point.targets[0][0] < 4e4, "{point:?}");
}

// The controls keep their first guesses: the equations are singular before the first step.
#[test]
fn controls_without_effect_do_not_change() {
    let same = "collective = \"c\"\ncosine = \"= f + s\"\nsine = 0\n";
    for (plate, expected) in [
        (
            "collective = \"c\"\ncosine = \"f\"\nsine = \"= 0*s\"\n",
            "\"s\" has no effect",
        ),
        (same, "\"f\" and \"s\" have the same effect"),
    ] {
        let outcome = attempt(&rotor(
            plate,
            &controls([0.08, 0.01, 0.0]),
            &targets(6000.0),
        ));
        let point = &outcome.result.points[0];
        let [reason, _] = point.failure.clone().unwrap();
        assert!(reason.contains(expected), "{reason}");
        assert_eq!(point.controls, [0.08, 0.01, 0.0]);
    }
}

// The auto-pilot of a rotor whose blades have little damping in the plane of rotation ends at the controls
// of shooting, in less than 100 periods. Its controls also follow the harmonics of the momentary targets
// within each revolution, in proportion to its gain: with half of the gain they are nearer.
#[test]
fn an_auto_pilot_ends_at_the_controls_of_shooting() {
    let text = rotor(ALL, &controls([0.08, 0.0, 0.0]), &targets(6000.0));
    let shot = attempt(&text).result.points[0].clone();
    let off = [0.3, 0.15].map(|gain| {
        let pilot = format!("[trim]\nmethod = \"autopilot\"\ngain = {gain}\n");
        let piloted = attempt(&text.replace("[trim]\n", &pilot)).result.points[0].clone();
        assert_eq!((&shot.failure, &piloted.failure), (&None, &None));
        assert!(piloted.iterations < 100, "{piloted:?}");
        let pairs = piloted.controls.iter().zip(&shot.controls);
        let off = pairs.map(|(found, expected)| (found - expected).abs());
        off.fold(0.0, f64::max)
    });
    println!("{off:?}");
    assert!(off[0] < 1e-3 && off[1] < 0.6 * off[0], "{off:?}");
}

// From guesses near stall, and from zero, the auto-pilot ends at the controls of shooting, which are within
// its own harmonics of the ones of the test before: 1e-3 rad.
#[test]
fn an_auto_pilot_ends_there_from_far_guesses() {
    let piloted = |guess: [f64; 3]| {
        let text = rotor(ALL, &controls(guess), &targets(6000.0));
        let text = text.replace("[trim]\n", "[trim]\nmethod = \"autopilot\"\n");
        let outcome = attempt(&text);
        assert_eq!(outcome.result.points[0].failure, None, "{guess:?}");
        outcome.result.points[0].controls.clone()
    };
    let near = attempt(&rotor(ALL, &controls([0.08, 0.0, 0.0]), &targets(6000.0)));
    let guesses = [[0.2, 0.1, -0.1], [0.0; 3], [0.25, 0.1, -0.1]];
    let count = if is_long() { guesses.len() } else { 1 };
    for guess in guesses.into_iter().take(count) {
        let found = piloted(guess);
        println!("{guess:?}: {found:?}");
        for (found, near) in found.iter().zip(&near.result.points[0].controls) {
            assert!((found - near).abs() < 1e-3, "{guess:?}: {found} {near}");
        }
    }
}

// A failure of the auto-pilot has the largest thrust and the stall there, and so has the one of shooting.
#[test]
fn an_auto_pilot_reports_stall() {
    let text = rotor("collective = \"c\"\n", &control("c", 0.1), "")
        + "[[trim.target]]\nname = \"thrust\"\nsignal = \"lift\"\nvalue = 80e3\nscale = 8e4\n";
    let text = text.replace("[trim]\n", "[trim]\nmethod = \"autopilot\"\n");
    let [reason, _] = attempt(&text).result.points[0].failure.clone().unwrap();
    for part in [
        "are met up to \"thrust\" = ",
        "beyond stall",
        "at angles of attack up to 1",
    ] {
        assert!(reason.contains(part), "{reason}");
    }
}

// Blades in air at rest without induced velocity have their pitch as angle of attack, up to their
// deformation: 20 deg are beyond the stall of the section, 4 deg are not. The target is the pitch itself.
#[test]
fn an_equilibrium_of_turning_blades_reports_stall() {
    let remarks = |pitch: f64| {
        let text = format!(
            "[properties.spar]\nea = 7e8\ngay = 2e8\ngaz = 2e8\ngj = 3e6\neiy = 2e6\neiz = 4e6\n\
             m = 6\niy = 1e-3\niz = 1e-2\n[parameters]\npitch = {pitch:?}\n\
             [air]\ndensity = 1.225\nwind = [0, 0, 0]\n\
             [[blade]]\nname = \"b\"\ncount = 3\nhub_radius = 0.5\npitch = \"= pitch\"\n\
             properties = \"spar\"\npiece = [{{ length = 4.5, elements = 2 }}]\n\
             [blade.aerodynamics]\nsection = \"quasi_steady\"\nstations = [\n\
             {{ at = 0, chord = 0.3, airfoil = \"naca0012\" }},\n\
             {{ at = 4.5, chord = 0.3, airfoil = \"naca0012\" }} ]\n\
             [sensors.lift]\nquantity = \"thrust\"\n\
             [trim]\nmethod = \"equilibrium\"\nspeed = 30\n\
             [[trim.control]]\nname = \"pitch\"\n\
             [[trim.target]]\nname = \"pitch\"\nsignal = \"= 0*lift + pitch\"\nvalue = {pitch:?}\n"
        );
        let outcome = attempt(&text);
        assert_eq!(outcome.result.points[0].failure, None);
        outcome.result.remarks
    };
    assert_eq!(remarks(0.07), Vec::<String>::new());
    let stalled = remarks(0.35);
    let expected = "of the strips of the blades are beyond stall";
    assert!(
        stalled.len() == 1
            && stalled[0].contains(expected)
            && stalled[0].contains("in the equilibrium"),
        "{stalled:?}"
    );
}
