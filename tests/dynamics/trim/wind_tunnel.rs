//! Trim of thrust and flapping.

use std::f64::consts::TAU;

use beam_dynamics::analysis::trim::Trimmed;
use nalgebra::Complex;

use super::flapping::{Flapping, controls, target};
use super::{attempt, numbers, reason, reference, trimmed};
use crate::record;

const SOURCE: &str = "Trim of a flapping rotor by an ODE of its own";

/// The targets of thrust and of flapping in multiblade coordinates.
fn three_targets(values: &[f64], sizes: [f64; 2]) -> String {
    let wave = |name: &str| {
        let term = |k: usize| format!("b{}*{name}(t + {:?})", k + 1, TAU * k as f64 / 3.0);
        format!("2/3*({})", [0, 1, 2].map(term).join(" + "))
    };
    let [thrust, flap] = sizes;
    target("thrust", "ct", [values[0], thrust])
        + &target("tilt forward", &wave("cos"), [values[1], flap])
        + &target("tilt sideward", &wave("sin"), [values[2], flap])
}

fn rotor(advance: f64) -> Flapping {
    Flapping {
        blades: 3,
        lock: 8.0,
        sigma_a: 0.5,
        twist: -0.14,
        advance,
        inflow: None,
        steps: 48,
    }
}

// Three blades with a state of the inflow at three advance ratios, against controls and exponents of
// an ODE in minimal coordinates (`theory-periodic/trim_flap.json`): controls to 1e-8, exponents
// to 1e-7, at most five iterations from a start without cyclic pitch. A sweep over the
// advance ratio would hide a wrong start: each begins anew.
#[test]
fn thrust_and_flapping_of_three_blades() {
    for row in reference("theory-periodic/trim_flap.json")["trim"]
        .as_array()
        .unwrap()
    {
        let advance = row["mu"].as_f64().unwrap();
        let targets = three_targets(&numbers(&row["targets"]), [0.01, 0.1]);
        let cards = rotor(advance).cards()
            + &controls([0.2, 0.0, 0.0])
            + &targets
            + "[periodic.floquet]\ncount = 7\nerror_estimate = false\n";
        let outcome = attempt(&cards);
        let point = &outcome.result.points[0];
        assert_eq!(point.failure, None);
        assert!(point.iterations <= 5, "{point:?}");
        let expected = numbers(&row["controls_ode"]);
        for (i, name) in ["collective", "cosine", "sine"].into_iter().enumerate() {
            let [found, expected] = [point.controls[i], expected[i]];
            let error = (found - expected).abs();
            let case = format!("advance ratio {advance}");
            record::value(SOURCE, &case, name, [found, expected], error, 1e-8);
            assert!(error < 1e-8, "{case}: {name} {found} {expected}");
        }
        let Some(Trimmed::Periodic(motion)) = outcome.end.and_then(|end| end.found) else {
            panic!("no motion");
        };
        for exponent in row["exponents_ode"].as_array().unwrap() {
            let pair = numbers(exponent);
            let expected = (Complex::new(pair[0], pair[1].abs()) * TAU).exp();
            let modes = motion.floquet.as_ref().unwrap().modes.iter();
            let of = |mu: Complex<f64>| (mu / expected).ln().norm() / TAU;
            let off = |mu: Complex<f64>| of(mu).min(of(mu.conj()));
            let least = modes
                .map(|mode| off(mode.multiplier))
                .fold(f64::INFINITY, f64::min);
            assert!(least < 1e-7, "{advance}: {pair:?} {least:e}");
        }
    }
}

// Both cyclic controls act on the cosine of the azimuth, so that the tilt sideward is not reached. The
// response of the targets has the errors of products with the linearized revolution.
#[test]
fn dependent_controls_of_a_rotor_are_named() {
    let row = &reference("theory-periodic/trim_flap.json")["trim"][1];
    let targets = three_targets(&numbers(&row["targets"]), [0.01, 0.1]);
    let cards = rotor(row["mu"].as_f64().unwrap()).cards();
    let cards = cards.replace("t1s*sin", "2*t1s*cos") + &controls([0.2, 0.0, 0.0]) + &targets;
    let [text, remedy] = reason(&cards);
    assert!(
        text.contains("\"t1c\" and \"t1s\" have the same effect on all targets"),
        "{text}"
    );
    assert!(
        remedy.contains("a target that no control reaches"),
        "{remedy}"
    );
}

// Small controls, of which thrust and flapping of the linear ODE are known: the trim finds the controls
// again. The closed form (rotor theory of a rigid blade) without inflow's second harmonic is exact in
// hover. Nonlinear terms are 1e-8 of the controls.
#[test]
fn small_controls_by_the_linear_response() {
    let it = &reference("theory-periodic/trim_flap.json")["small_angle"];
    let scale = it["scale"].as_f64().unwrap();
    let expected = numbers(&it["controls_per_unit"]);
    for row in it["rows"].as_array().unwrap() {
        let response: Vec<_> = numbers(&row["ode"])
            .iter()
            .map(|value| value * scale)
            .collect();
        let small = Flapping {
            twist: it["twist"].as_f64().unwrap() * scale,
            inflow: Some(it["inflow"].as_f64().unwrap() * scale),
            ..rotor(row["mu"].as_f64().unwrap())
        };
        let targets = three_targets(&response, [0.1 * scale, scale]);
        let settings = "[trim]\n";
        let cards = small.cards() + settings + &controls([0.0; 3]) + &targets;
        let cards = cards.replace("steps = 48", "steps = 48\ntolerance = 1e-11");
        let point = &trimmed(&cards)[0];
        for (found, expected) in point.controls.iter().zip(&expected) {
            assert!(
                (found / scale - expected).abs() < 2e-6,
                "{row:?}: {found} {expected}"
            );
        }
    }
}

/// A single blade in a uniform flow, with all inputs small, so that it is the linear blade of
/// `theory-rotor/flap_closed_form.json`, whose flapping is in degrees.
const SMALL: f64 = 1e-4;

fn single(advance: f64, inflow: f64, sigma_a: f64) -> Flapping {
    Flapping {
        blades: 1,
        lock: 8.0,
        sigma_a,
        twist: SMALL * (-8.0_f64).to_radians(),
        advance,
        inflow: Some(SMALL * inflow),
        steps: 72,
    }
}

/// Controls in degrees for a thrust coefficient and the flapping in degrees, by harmonics of the blade.
fn trim_of_one(blade: &Flapping, thrust: f64, flapping: [f64; 2]) -> Vec<f64> {
    let size = SMALL * 0.1;
    let [cosine, sine] = flapping.map(|angle| SMALL * angle.to_radians());
    let cards = blade
        .cards()
        .replace("steps = 72", "steps = 72\ntolerance = 1e-9")
        + &controls([0.0; 3])
        + &target("thrust", "ct", [SMALL * thrust, SMALL * 0.01])
        + &target("forward", "b1", [cosine, size])
        + "harmonic = 1\n"
        + &target("sideward", "b1", [sine, size])
        + "harmonic = 1\npart = \"sine\"\n";
    let point = &trimmed(&cards)[0];
    point
        .controls
        .iter()
        .map(|own| (own / SMALL).to_degrees())
        .collect()
}

// The listed periodic responses, of four decimals of a degree, lead back to the pitch of 10, 1.5 and -4
// degrees: within 1e-3 deg, the tolerance of the list, plus three times the last digit of thrust.
#[test]
fn flapping_of_a_blade_leads_back_to_its_pitch() {
    let it = reference("theory-rotor/flap_closed_form.json");
    for row in it["rows"].as_array().unwrap() {
        let row = numbers(row);
        let found = trim_of_one(&single(row[0], 0.02, 1.0), row[8], [row[5], row[6]]);
        // One unit of the last digit of CT/(sigma a) is 6e-6 rad of collective.
        for (found, (expected, within)) in
            found.iter().zip([(10.0, 2e-3), (1.5, 1e-3), (-4.0, 2e-3)])
        {
            assert!(
                (found - expected).abs() < within,
                "{row:?}: {found} {expected}"
            );
        }
    }
}

// Controls for a thrust without flapping, by the list: 1e-4 deg in hover, 1e-3 deg in forward flight,
// where the inflow, which is Glauert's, is computed here.
#[test]
fn controls_without_flapping() {
    let it = &reference("theory-rotor/flap_closed_form.json")["trim"];
    let of = |name: &str| it["inputs"][name].as_f64().unwrap();
    let (thrust, sigma_a) = (of("CT"), of("sigma") * of("a"));
    for row in it["rows"].as_array().unwrap() {
        let row = numbers(row);
        let advance = row[0];
        let axial = advance * (5.0 * advance / 0.3).to_radians().tan();
        let mut inflow = (0.5 * thrust).sqrt();
        for _ in 0..200 {
            let total = advance.hypot(axial + inflow);
            inflow += 0.5 * (0.5 * thrust / total - inflow);
        }
        let total = axial + inflow;
        assert!((total - row[8]).abs() < 1e-5, "{row:?}: {total}");
        let found = trim_of_one(&single(advance, total, sigma_a), thrust, [0.0; 2]);
        let within = if advance == 0.0 { 1e-4 } else { 1e-3 };
        for (name, (found, expected)) in ["collective", "cosine", "sine"]
            .into_iter()
            .zip(found.iter().zip(&row[1..4]))
        {
            let error = (found - expected).abs();
            let case = format!("wind tunnel, advance ratio {advance}");
            let pair = [*found, *expected];
            record::value(
                "Rigid flapping blade",
                &case,
                &format!("{name} [deg]"),
                pair,
                error,
                within,
            );
            assert!(error < within, "{row:?}: {found} {expected}");
        }
    }
}
