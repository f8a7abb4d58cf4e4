//! Hammond's rotor, from `cases/dynamics/ground_resonance`.
//!
//! Source: C. E. Hammond, An application of Floquet theory to prediction of mechanical instability,
//! Journal of the American Helicopter Society 19(4), 1974: data of the rotor. Boundaries and growth by an
//! independent program (equations in minimal coordinates, Floquet multipliers), of five and three digits.

use beam_dynamics::analysis::stability::stability;
use beam_dynamics::input;
use beam_dynamics::result::{BoundaryKind, StabilityResult, StableSide};

use super::assert_boundaries;
use crate::effort::is_long;

/// The case with the damper of the last blade times a factor, at these values.
fn case(factor: f64, values: &str) -> StabilityResult {
    let folder = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/cases/dynamics/ground_resonance"
    );
    let path = format!("{folder}/ground_resonance.dynamics.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    let mut text = text.replace("last = 0 ", &format!("last = {factor:?} "));
    if !is_long() {
        text = text.replace("steps = 48", "steps = 24");
    }
    let start = text.find("from = 100").unwrap();
    let end = start
        + text[start..]
            .find("boundaries")
            .map_or(text.len() - start, |at| at);
    let text = format!("{}{values}\n{}", &text[..start], &text[end..]);
    let read = |given: &[(String, f64)]| input::parse_with(&text, &path, given);
    let parsed = read(&[]).unwrap_or_else(|problems| panic!("{problems}"));
    stability("rotor", parsed.stability.as_ref().unwrap(), None, &read)
}

// Boundaries of the case within the rounding of the list, found in the long form; and the largest
// growth, at 250 rpm.
#[test]
fn one_damper_is_inoperative() {
    let all = [
        (210.37, BoundaryKind::Flutter, StableSide::Below),
        (307.08, BoundaryKind::Flutter, StableSide::Above),
    ];
    if is_long() {
        let result = case(0.0, "values = [180, 250, 330]");
        assert!(result.failures.is_empty(), "{:?}", result.failures);
        assert_boundaries(&result, &all, 6e-3);
    }
    // The first boundary is between these values.
    let result = case(0.0, "values = [210.36, 210.38]\nboundaries = false");
    let unstable: Vec<_> = result.points.iter().map(|own| own.unstable()).collect();
    assert_eq!(unstable, [0, 2]);
    let largest = case(0.0, "values = [250, 260]").points[0].roots[0].growth();
    assert!((largest - 0.322).abs() < 6e-4, "{largest}");
}

#[test]
fn all_dampers_act() {
    let all = [
        (250.0, -0.330),
        (100.0, -1.871),
        (200.0, -0.992),
        (300.0, -0.735),
        (400.0, -1.315),
    ];
    let count = if is_long() { all.len() } else { 1 };
    for (rpm, expected) in &all[..count] {
        let result = case(1.0, &format!("values = [{rpm}, {}]", rpm + 5.0));
        assert_boundaries(&result, &[], 0.0);
        let found = result.points[0].roots[0].growth();
        // The list has three digits.
        assert!(
            (found - expected).abs() < 1.5e-3,
            "{rpm} {found} {expected}"
        );
    }
}
