//! Integration in time of differential-algebraic systems; knows nothing of nodes and
//! elements.
//!
//! A system `F(y, y', t) = 0` is seen through [`Dae`]: it keeps its states, so that
//! rotations stay matrices, and hands them to the formulas as numbers relative to its
//! latest accepted state.

mod dae;
mod scheme;

pub use dae::Dae;
pub use scheme::{Scheme, StepControl, Stepping};
