//! Dynamic wake: induced velocities follow the loads with the lag of the wake.
//!
//! ```text
//! y' = ((1 - k) w_qs - y) / tau1,  w' = (y + k w_qs - w) / tau2,  k = .6
//! ```
//!
//! Two stages per strip or ring, for `u` and for `v` (Oye 1990; Snel and Schepers, ECN-C-94-107).
//! The quasi-steady velocity `w_qs` has two schools, [`Forcing`]: they have the same steady state
//! and different speeds.

mod forcing;
mod oye;

pub use forcing::{Forcing, disk_mean, forcing};
pub use oye::{FilterState, SHARE, TimeScale, rates, step_response};
