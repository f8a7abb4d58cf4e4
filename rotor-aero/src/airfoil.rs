//! Airfoils: coefficients over angle of attack, Mach number, Reynolds number and flap deflection.
//!
//! [`AirfoilData`] is the content of a table; [`Airfoil`] is checked and evaluated.

mod blend;
mod builtin;
mod characteristics;
mod check;
mod compressibility;
mod constants;
mod cubic;
mod data;
mod evaluated;
pub mod files;
mod formula;
mod merged;
mod mirror;
mod naca0012;
mod plain_flap;
mod problem;
mod rotor_delay;
mod separation;
mod stall_delay;
mod surface;
mod table;
mod viterna;

pub use blend::{Blend, BlendProblem, Section};
pub use builtin::{BUILT_IN, BuiltIn, built_in};
pub use characteristics::{Characteristics, Extreme};
pub use constants::UnsteadyConstants;
pub use cubic::Interpolation;
pub use data::{AirfoilData, Coefficients, Curve, Flow};
pub(crate) use evaluated::FlowNumber;
pub use evaluated::{Airfoil, Profile};
pub use formula::{FlatPlate, LinearLift};
pub use naca0012::naca0012;
pub use plain_flap::PlainFlap;
pub use problem::{AirfoilProblem, AirfoilRemark, RADIANS};
pub use rotor_delay::{RotorDelayLaw, RotorPlace, RotorStallDelay};
pub use separation::{Kirchhoff, Separation};
pub use stall_delay::{StallDelay, StallDelayLaw};
pub use viterna::Viterna;
