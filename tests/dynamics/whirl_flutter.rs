//! Whirl flutter: the input files of the case `tiltrotor` against closed forms, against an independent
//! program in minimal coordinates, and against published figures.

use std::path::Path;

use beam_dynamics::input::{self, Input};

mod proprotor;
mod reed_bland;

/// A file of the case with other values of parameters, and with a change of its text.
fn edited(file: &str, parameters: &[(&str, f64)], change: impl Fn(String) -> String) -> Input {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let path = root.join("cases/dynamics/tiltrotor").join(file);
    let text = change(std::fs::read_to_string(&path).unwrap());
    let given = parameters.iter();
    let given: Vec<_> = given
        .map(|(name, value)| ((*name).to_owned(), *value))
        .collect();
    input::parse_with(&text, &path, &given).unwrap_or_else(|problems| panic!("{problems}"))
}

/// A file of the reference data.
fn reference(name: &str) -> serde_json::Value {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/reference/theory-rotor");
    serde_json::from_str(&std::fs::read_to_string(root.join(name)).unwrap()).unwrap()
}

/// The zero of a function near two numbers, by the secant method, to a relative step of 1e-5.
fn zero(mut function: impl FnMut(f64) -> f64, [mut a, mut b]: [f64; 2]) -> f64 {
    let [mut at_a, mut at_b] = [function(a), function(b)];
    for _ in 0..20 {
        let next = b - at_b * (b - a) / (at_b - at_a);
        (a, at_a) = (b, at_b);
        (b, at_b) = (next, function(next));
        if (b / a - 1.0).abs() < 1e-5 {
            return b;
        }
    }
    panic!("no zero near {b}: {at_b}");
}

// A limit of the Mach number that the factor of Prandtl and Glauert cannot have.
#[test]
fn the_limit_of_compressible_linear_lift_is_checked() {
    let path =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/dynamics/tiltrotor/hover.dynamics.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    let wrong = text.replace("compressible_to = 0.85", "compressible_to = 1");
    let Err(problems) = input::parse(&wrong, &path) else {
        panic!("accepted");
    };
    let shown = problems.to_string();
    assert!(
        shown.contains("limit of the Mach number 1, expected"),
        "{shown}"
    );
    assert!(shown.contains("0.95 or less"), "{shown}");
}
