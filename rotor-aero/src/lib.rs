//! Aerodynamics of rotors: airfoil tables and their files, unsteady sections, annular momentum,
//! dynamic wakes, inflow and wind.
//!
//! Everything here is a function of velocities, angles and states, without nodes or elements:
//! `beam-dynamics` evaluates it in its elements. Kernels are generic over [`Real`], so that their
//! derivatives are exact.

pub mod airfoil;
pub mod inflow;
pub mod momentum;
pub mod real;
pub mod rotor;
pub mod strip;
pub mod unsteady;
pub mod wake;
pub mod wind;

pub use real::Real;
