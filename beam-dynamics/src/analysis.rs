//! Analyses: the code of each follows its method, one call per step.
//!
//! # Example
//!
//! ```
//! use beam_dynamics::analysis::transient::transient;
//! use beam_dynamics::input;
//! use beam_dynamics::result::{AcceptedStep, Recorder};
//!
//! /// Height and time of a falling body.
//! struct Heights(Vec<(f64, f64)>);
//!
//! impl Recorder for Heights {
//!     fn record(&mut self, step: &AcceptedStep<'_>) -> bool {
//!         self.0.push((step.time, step.state.nodes[0].position.z));
//!         true
//!     }
//! }
//!
//! let text = r#"
//! units = "SI"
//! [[node]]
//! name = "stone"
//! position = [0, 0, 0]
//! [[body]]
//! name = "stone"
//! node = "stone"
//! mass = 2
//! inertia = [1, 1, 1]
//! [gravity]
//! acceleration = [0, 0, -9.81]
//! [transient]
//! to = 1
//! step = 0.01
//! "#;
//! let input = input::parse(text, "stone.dynamics.toml").expect("a sound file");
//! let settings = input.transient.as_ref().expect("a card [transient]");
//!
//! let mut heights = Heights(Vec::new());
//! let outcome = transient(&input.model, settings, None, &mut heights, &|| 0.0);
//! assert!(outcome.failure.is_none());
//! let (time, height) = heights.0[100];
//! assert!((height + 0.5 * 9.81 * time * time).abs() < 1e-9);
//! ```

mod around_the_axis;
mod averaged;
mod branches;
pub mod buckling;
mod critical;
mod deformation;
mod effects;
mod fewer_modes;
mod first_order;
mod frozen;
mod growing;
pub mod identification;
pub mod linear;
mod linearized;
mod linking;
mod modal_damping;
pub mod modes;
mod multiblade;
mod operation;
pub mod performance;
pub mod periodic;
pub mod stability;
mod stall;
pub mod static_sweep;
pub mod statics;
pub mod steady;
pub mod transient;
pub mod trim;

mod arc;
mod balance;
mod path;
mod settling;

#[cfg(test)]
mod slow_charge_tests;
