//! Airfoils: coefficients over angle of attack, Mach number, Reynolds number and flap deflection.

mod data;

pub use data::{AirfoilData, Coefficients, Curve, Flow};
