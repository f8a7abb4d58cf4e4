//! Multibody engine of Helicoid: blades and rotors from section properties to
//! steady rotating equilibrium, modes, frequency tables and plots.
//!
//! Stages, each of which sees only those before it: [`model`], [`elements`],
//! [`assembly`], [`solver`], [`integrator`], [`case`], [`result`], [`modes`]; then `input` and
//! `output`. The analyses see them all.
//!
//! # Example
//!
//! ```
//! use beam_dynamics::analysis::modes::modes;
//! use beam_dynamics::input;
//!
//! // a clamped strip of 2 m, at rest
//!
//! let text = r#"
//! units = "SI"
//! [properties.strip]
//! ea = 2.8e7
//! gay = 9e6
//! gaz = 9e6
//! gj = 300
//! eiy = 240
//! eiz = 3700
//! m = 1.08
//! iy = 1e-6
//! iz = 1e-6
//! [[blade]]
//! name = "blade"
//! properties = "strip"
//! [[blade.piece]]
//! length = 2
//! elements = 8
//! [modes]
//! speeds = 0
//! count = 1
//! "#;
//! let input = input::parse(text, "strip.dynamics.toml").expect("a sound file");
//! let settings = input.modes.as_ref().expect("a card [modes]");
//!
//! let outcome = modes(&input.model, settings);
//! let (branch, first) = outcome.table.at_speed(0)[0];
//! // a slender cantilever: 1.8751^2 sqrt(EI / (m L^4)) / 2 pi
//! let slender = 1.875_104_f64.powi(2) * (240.0_f64 / (1.08 * 16.0)).sqrt() / std::f64::consts::TAU;
//! assert!((first.frequency / slender - 1.0).abs() < 1e-3);
//! assert_eq!(branch.name, "flap 1");
//! ```

pub mod analysis;
pub mod assembly;
pub mod case;
pub mod cli;
#[cfg(test)]
#[path = "../../tests/common/effort.rs"]
mod effort;
pub mod elements;
pub mod input;
pub mod integrator;
pub mod model;
pub mod modes;
pub mod output;
pub mod result;

pub use sparse_solver as solver;
