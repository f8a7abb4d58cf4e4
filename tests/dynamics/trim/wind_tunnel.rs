//! Trim of thrust and flapping.

use super::flapping::{Flapping, controls, target};
use super::{numbers, reference, trimmed};
use crate::record;

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
