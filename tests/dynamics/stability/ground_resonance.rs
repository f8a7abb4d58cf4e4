//! Hammond's rotor, from `cases/dynamics/ground_resonance`.
//!
//! Source: C. E. Hammond, An application of Floquet theory to prediction of mechanical instability,
//! Journal of the American Helicopter Society 19(4), 1974: data of the rotor. Boundaries by an
//! independent integration of its equations in minimal coordinates (fourth order, 120 steps), six digits.

use beam_dynamics::analysis::stability::stability;
use beam_dynamics::input;
use beam_dynamics::result::{BoundaryKind, StabilityResult, StableSide};

use super::assert_boundaries;

/// The case with the damper of the last blade times a factor, at these values.
fn case(factor: f64, values: &str) -> StabilityResult {
    let folder = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/cases/dynamics/ground_resonance"
    );
    let path = format!("{folder}/ground_resonance.dynamics.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    let text = text.replace("last = 0 ", &format!("last = {factor:?} "));
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

#[test]
fn one_damper_is_inoperative() {
    let result = case(0.0, "values = [180, 250, 330]");
    assert!(result.failures.is_empty(), "{:?}", result.failures);
    assert_boundaries(
        &result,
        &[
            (210.333, BoundaryKind::Flutter, StableSide::Below),
            (307.150, BoundaryKind::Flutter, StableSide::Above),
        ],
        2e-3,
    );
    // Largest growth at 250 rpm.
    assert!((result.points[1].roots[0].growth() - 0.322_291).abs() < 2e-6);
}

#[test]
fn all_dampers_act() {
    let result = case(1.0, "values = [100, 200, 250, 300, 400]");
    assert!(result.failures.is_empty(), "{:?}", result.failures);
    assert_boundaries(&result, &[], 0.0);
    let growth = [-1.871, -0.992, -0.329, -0.735, -1.315];
    let points = result.points.iter().filter(|point| point.is_requested);
    for (point, expected) in points.zip(growth) {
        let found = point.roots[0].growth();
        assert!(
            (found - expected).abs() < 2e-3,
            "{} {found} {expected}",
            point.at
        );
    }
}
