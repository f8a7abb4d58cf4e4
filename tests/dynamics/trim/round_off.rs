//! Targets that no control changes, where symmetry makes their response zero but for round-off, beside
//! responses that are small by their units only.

use super::flapping::{Flapping, target};
use super::{reason, trimmed};
use crate::periodic::Random;

/// A rotor of equal flapping blades in hover.
fn hover() -> Flapping {
    Flapping {
        blades: 3,
        lock: 8.0,
        sigma_a: 0.5,
        twist: -0.14,
        advance: 0.0,
        inflow: Some(0.05),
        steps: 12,
    }
}

/// Controls of the given names, first guesses and scale.
fn controls(of: &[(&str, f64)], scale: f64) -> String {
    let card = |(name, guess): &(&str, f64)| {
        format!("[[trim.control]]\nname = \"{name}\"\nguess = {guess:?}\nscale = {scale:?}\n")
    };
    of.iter().map(card).collect()
}

// Three equal blades pass only multiples of 3/rev to the fixed system: no control changes the first harmonic of
// their thrust, whether it has its value already or not, in any unit, by shooting and by an auto-pilot.
#[test]
fn a_harmonic_that_symmetry_cancels_is_named() {
    let mut random = Random(3);
    let auto = "method = \"autopilot\"\n";
    for (method, cyclic, value) in [("", 0.0, 0.0), ("", 0.05, 1e-4), (auto, 0.05, 0.0)] {
        let unit = 10.0_f64.powf(8.0 * random.next());
        let cards = hover()
            .cards()
            .replace("t1s*sin", "0*sin")
            .replace("[periodic]\n", "[periodic]\nperiods = 40\n")
            + "[trim]\n"
            + method
            + &controls(&[("t0", 0.2), ("t1c", cyclic)], 0.1)
            + &target("thrust", "ct", [0.01, 0.01])
            + &target("wave", &format!("{unit:?}*ct"), [value * unit, 0.01 * unit])
            + "harmonic = 1\n";
        let [text, remedy] = reason(&cards);
        assert!(
            text.ends_with("no control has an effect on \"wave\""),
            "{method} {unit} {cyclic} {value}: {text}"
        );
        assert!(
            remedy.contains("a target that no control reaches"),
            "{remedy}"
        );
    }
}

// The same rotor with flapping in place of the harmonic, and with all quantities and controls in random units of
// 1e-8 to 1e8, whose scales are kept at one: these responses are no round-off. The controls in radians are the
// same as the ones in the usual units, within the tolerances of both motions.
#[test]
fn small_units_are_no_round_off() {
    let mut random = Random(5);
    let mut trim = |is_small: bool| {
        let mut unit = || {
            if is_small {
                10.0_f64.powf(8.0 * random.next())
            } else {
                1.0
            }
        };
        let units: Vec<f64> = (0..6).map(|_| unit()).collect();
        let mut cards = hover().cards();
        for (name, unit) in ["t0", "t1c", "t1s"].into_iter().zip(&units[3..]) {
            cards = cards
                .replace(&format!("{name}*"), &format!("{name}/{unit:e}*"))
                .replace(&format!("({name} "), &format!("({name}/{unit:e} "));
        }
        let of = |name: &str, signal: &str, value: f64, unit: f64| {
            target(
                name,
                &format!("{unit:e}*{signal}"),
                [value * unit, 0.1 * unit],
            )
        };
        cards += "[trim]\n";
        let guesses = [
            ("t0", 0.3, units[3]),
            ("t1c", 0.0, units[4]),
            ("t1s", 0.0, units[5]),
        ];
        for (name, guess, unit) in guesses {
            cards += &controls(&[(name, guess * unit)], 0.1 * unit);
        }
        cards += &of("thrust", "ct", 0.01, units[0]);
        cards += &(of("forward", "b1", 0.02, units[1]) + "harmonic = 1\n");
        cards += &(of("sideward", "b1", -0.01, units[2]) + "harmonic = 1\npart = \"sine\"\n");
        let found = trimmed(&cards)[0].controls.clone();
        let pairs = found.iter().zip(&units[3..]);
        pairs.map(|(own, unit)| own / unit).collect::<Vec<f64>>()
    };
    let expected = trim(false);
    for _ in 0..3 {
        for (found, expected) in trim(true).iter().zip(&expected) {
            assert!((found - expected).abs() < 1e-7, "{found} {expected}");
        }
    }
}

/// Three masses on springs in the directions of a star, each pulled outward by a force `all` and the first one by a
/// force `one` too.
fn star(targets: &str) -> String {
    let mut text = String::new();
    for k in 0..3 {
        let angle = std::f64::consts::TAU * f64::from(k) / 3.0 + 0.3;
        let (sin, cos) = angle.sin_cos();
        text += &format!(
            "[[node]]\nname = \"n{k}\"\nposition = [{cos:?}, {sin:?}, 0]\n\
             [[body]]\nname = \"n{k}\"\nnode = \"n{k}\"\nmass = 2\ninertia = [1, 1, 1]\n\
             [[spring]]\nname = \"s{k}\"\nnode = \"n{k}\"\nstiffness = [50, 50, 50]\n\
             rotational_stiffness = [1, 1, 1]\n\
             [sensors.x{k}]\nquantity = \"position\"\nof = \"n{k}\"\ncomponent = \"x\"\nunit = \"m\"\n\
             [[load]]\nname = \"f{k}\"\nnode = \"n{k}\"\nforce = [{cos:?}, {sin:?}, 0]\n\
             drive = \"= all{}\"\n",
            if k == 0 { " + one" } else { "" }
        );
    }
    text + "[trim]\nmethod = \"equilibrium\"\n" + targets
}

// The sum of the displacements of the star by equal forces is zero, and round-off in any units of force and sum.
#[test]
fn a_sum_that_symmetry_cancels_is_named_in_an_equilibrium() {
    let mut random = Random(7);
    for index in 0..6 {
        let (unit, force) = (
            10.0_f64.powf(8.0 * random.next()),
            10.0_f64.powf(8.0 * random.next()),
        );
        let value = if index % 2 == 0 { 0.0 } else { unit };
        let cards = star(
            &(controls(&[("all", 1.0)], force)
                + &target("sum", &format!("{unit:e}*(x0 + x1 + x2)"), [value, unit])),
        )
        .replace("+ one", "")
        .replace("= all", &format!("= all/{force:e}"));
        let [text, _] = reason(&cards);
        assert!(
            text.ends_with("no control has an effect on \"sum\""),
            "{text}"
        );
    }
}

// With the second force the same sum has a closed form, `F_1 cos(a) / k` in the first direction a = 0.3, and
// so has the first displacement, `(F + F_1) cos(a) / k`.
#[test]
fn small_units_in_an_equilibrium() {
    let mut random = Random(11);
    for _ in 0..6 {
        let mut unit = || 10.0_f64.powf(8.0 * random.next());
        let (units, force) = ([unit(), unit()], unit());
        let cards = star(
            &(controls(&[("all", force), ("one", 0.0)], force)
                + &target(
                    "sum",
                    &format!("{:e}*(x0 + x1 + x2)", units[0]),
                    [0.02 * units[0], units[0]],
                )
                + &target(
                    "x",
                    &format!("{:e}*x0", units[1]),
                    [1.1 * units[1], units[1]],
                )),
        )
        .replace("= all", &format!("= all/{force:e}"))
        .replace("+ one", &format!("+ one/{force:e}"));
        let found = trimmed(&cards)[0].controls.clone();
        let sum = 0.02 * 50.0 / 0.3_f64.cos();
        let all = 50.0 * (1.1 / 0.3_f64.cos() - 1.0) - sum;
        assert!((found[1] / force - sum).abs() < 1e-8, "{found:?} {sum}");
        assert!((found[0] / force - all).abs() < 1e-8, "{found:?} {all}");
    }
}
