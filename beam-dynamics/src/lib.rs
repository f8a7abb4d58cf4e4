//! Multibody engine of Helicoid: blades and rotors from section properties to
//! steady rotating equilibrium, modes, frequency tables and plots.
//!
//! Stages, each of which sees only those before it: [`model`], [`elements`],
//! [`assembly`], [`solver`], [`integrator`], [`case`], [`result`], [`modes`]; then `input` and
//! `output`. The analyses see them all.

pub mod analysis;
pub mod assembly;
pub mod case;
pub mod cli;
pub mod elements;
pub mod input;
pub mod integrator;
pub mod model;
pub mod modes;
pub mod output;
pub mod result;
pub mod solver;
