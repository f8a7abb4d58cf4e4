//! Airfoils: coefficients over angle of attack, Mach number, Reynolds number and flap deflection.
//!
//! [`AirfoilData`] is the content of a table; [`Airfoil`] is checked and evaluated.

mod blend;
mod builtin;
mod check;
mod cubic;
mod data;
mod evaluated;
pub mod files;
mod formula;
mod naca0012;
mod problem;
mod separation;
mod surface;
mod table;

pub use blend::{Blend, BlendProblem, Section};
pub use builtin::{BUILT_IN, BuiltIn, built_in};
pub use cubic::Interpolation;
pub use data::{AirfoilData, Coefficients, Curve, Flow};
pub use evaluated::{Airfoil, Profile};
pub use formula::{FlatPlate, LinearLift};
pub use naca0012::naca0012;
pub use problem::{AirfoilProblem, AirfoilRemark};
pub use separation::{Kirchhoff, Separation};
