//! Validation of beam-dynamics against closed forms and published solutions.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

mod articulated;
mod beam_statics;
mod blade_roots;
mod buckling;
mod case_files;
mod chain;
mod damping;
mod equal_blades;
mod formats;
mod integrators;
mod joints;
mod loads;
mod mbdyn_model;
#[path = "../common/record.rs"]
mod record;
mod rotating_beam;
mod rotor;
mod statics;
mod tm4760;
mod uniform_beam;
mod wind_blades;
