//! Boundaries of stability over a parameter against closed forms and independent solutions.

use beam_dynamics::analysis::stability::stability;
use beam_dynamics::input;
use beam_dynamics::result::{BoundaryKind, StabilityResult, StableSide};
use nalgebra::{Matrix2, Matrix4};

mod averaged;
mod closed_forms;
mod flap_lag;
mod follower;
mod ground_resonance;
mod names;
mod problems;
mod resolution;
mod rotor;
mod section_flutter;
mod trimmed;

/// The stability of a file in radians and SI units.
fn attempt(cards: &str) -> StabilityResult {
    let units = "[units]\nangle = \"rad\"\nrotation_speed = \"rad/s\"\n";
    let text = format!("{units}{cards}");
    let parsed = input::parse(&text, "model.dynamics.toml");
    let parsed = parsed.unwrap_or_else(|problems| panic!("{problems}\n{text}"));
    let read = |given: &[(String, f64)]| input::parse_with(&text, "model.dynamics.toml", given);
    let settings = parsed.stability.as_ref().unwrap();
    stability("model", settings, parsed.trim.as_ref(), &read)
}

/// The same of a file all whose values succeed.
fn analyzed(cards: &str) -> StabilityResult {
    let result = attempt(cards);
    assert!(result.failures.is_empty(), "{:#?}", result.failures);
    result
}

/// The largest growth of the four roots of `M q'' + C q' + K q = 0` \[1/s\].
fn largest_growth([m, c, k]: [Matrix2<f64>; 3]) -> f64 {
    let inverse = m.try_inverse().unwrap();
    let mut first = Matrix4::zeros();
    first
        .fixed_view_mut::<2, 2>(2, 0)
        .copy_from(&(-inverse * k));
    first
        .fixed_view_mut::<2, 2>(0, 2)
        .copy_from(&Matrix2::identity());
    first
        .fixed_view_mut::<2, 2>(2, 2)
        .copy_from(&(-inverse * c));
    let growths = first.complex_eigenvalues();
    let growths = growths.iter().map(|root| root.re);
    growths.fold(f64::NEG_INFINITY, f64::max)
}

/// Asserts values, types and stable sides of all boundaries.
fn assert_boundaries(
    result: &StabilityResult,
    expected: &[(f64, BoundaryKind, StableSide)],
    within: f64,
) {
    let found = &result.boundaries;
    assert_eq!(found.len(), expected.len(), "{found:#?}");
    for (own, (at, kind, side)) in found.iter().zip(expected) {
        assert!((own.at - at).abs() < within, "{own:?} {at}");
        assert_eq!((own.kind, own.stable), (*kind, *side), "{own:?}");
    }
}
