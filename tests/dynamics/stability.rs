//! Boundaries of stability over a parameter against closed forms and independent solutions.

use beam_dynamics::analysis::stability::stability;
use beam_dynamics::input;
use beam_dynamics::result::{BoundaryKind, StabilityResult, StableSide};

mod averaged;
mod closed_forms;
mod flap_lag;
mod follower;
mod ground_resonance;
mod names;
mod problems;
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
