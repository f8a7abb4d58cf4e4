//! Trim against closed forms and independent solutions.

use beam_dynamics::analysis::trim::{TrimOutcome, trim};
use beam_dynamics::input;
use beam_dynamics::result::TrimPoint;

mod equilibrium;
mod failures;
mod flapping;
mod free_flight;
mod puma;
mod round_off;
mod shaft_torque;
mod stall;
mod turbine;
mod two_rotors;
mod wind_tunnel;

/// The trim of a file in radians and SI units.
fn attempt(cards: &str) -> TrimOutcome {
    let units = "[units]\nangle = \"rad\"\nrotation_speed = \"rad/s\"\n";
    let text = format!("{units}{cards}");
    let parsed = input::parse(&text, "model.dynamics.toml");
    let parsed = parsed.unwrap_or_else(|problems| panic!("{problems}\n{text}"));
    let read = |given: &[(String, f64)]| input::parse_with(&text, "model.dynamics.toml", given);
    trim("model", parsed.trim.as_ref().unwrap(), &read)
}

/// The same of a file whose targets are met, with its points.
fn trimmed(cards: &str) -> Vec<TrimPoint> {
    let outcome = attempt(cards);
    for point in &outcome.result.points {
        assert_eq!(point.failure, None, "{:#?}", outcome.result.points);
    }
    outcome.result.points
}

/// The reason of a trim that fails, and its remedy.
fn reason(cards: &str) -> [String; 2] {
    let outcome = attempt(cards);
    let last = outcome.result.points.last().unwrap();
    last.failure.clone().unwrap()
}

/// A reference of a folder of `tests/reference`.
pub fn reference(name: &str) -> serde_json::Value {
    let path = format!("{}/tests/reference/{name}", env!("CARGO_MANIFEST_DIR"));
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// Numbers of a list.
pub fn numbers(of: &serde_json::Value) -> Vec<f64> {
    let list = of.as_array().unwrap().iter();
    list.map(|number| number.as_f64().unwrap()).collect()
}
