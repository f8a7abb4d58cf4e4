//! Schemes of integration in time on plain systems of equations.

use std::path::Path;

use beam_dynamics::integrator::{Integrator, Scheme, StepLimits, Stepping};
use serde_json::Value;

use self::system::{Equations, System};

pub mod orders;
mod stability;
mod stepping;
mod system;
pub mod tables;

/// A data file of `tests/reference/dynamics`.
fn reference(name: &str) -> Value {
    serde_json::from_str(&reference_text(name)).unwrap()
}

fn reference_text(name: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(root.join("tests/reference/dynamics").join(name)).unwrap()
}

/// A stopped clock.
fn no_clock() -> f64 {
    0.0
}

/// Iteration to round-off: the measured error is the error of the scheme.
fn tight() -> StepLimits {
    StepLimits {
        correction: 1e-13,
        residual: 1e-14,
        ..StepLimits::default()
    }
}

fn integrator<E: Equations>(system: &System<E>, scheme: Scheme, step: f64) -> Integrator {
    Integrator::new(system, scheme, Stepping::Constant { step }, tight(), 0.0)
}

/// Integrates from time zero by constant steps; the unknowns at `until`.
fn run<E: Equations>(mut system: System<E>, scheme: Scheme, step: f64, until: f64) -> Vec<f64> {
    let mut integrator = integrator(&system, scheme, step);
    while integrator.time() < until {
        integrator.step(&mut system, until, &no_clock).unwrap();
    }
    system.latest.y
}
