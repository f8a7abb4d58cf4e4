//! Unsteady sections: forces of an airfoil section on its flow and on states that follow it.
//!
//! A [`SectionModel`] gives the forces per length of span at the quarter chord, and one row
//! `g(x, x', flow) = 0` per state. The rows belong to an implicit scheme for
//! differential-algebraic equations: a momentum of the air is a state with an algebraic row, and
//! its rate is the force of the added mass, so that no acceleration enters.
//!
//! Axes of a section: x from the quarter chord toward the leading edge, y up (toward the suction
//! side at positive lift), z along the span with x cross y = z; moments are nose up positive.

mod added_mass;
mod constants;
mod dynamic_stall;
mod flap;
mod hgm;
mod lagged;
mod lags;
mod local;
mod model;
mod oye;
mod polar;
mod quasi_steady;
mod section;
mod separated;
mod separation_lag;
#[cfg(test)]
pub(crate) mod tests;

pub use constants::StallConstants;
pub use dynamic_stall::DynamicStall;
pub use flap::Flap;
pub use hgm::Hgm;
pub use lagged::Lagged;
pub use lags::Lags;
pub(crate) use local::smooth_step;
pub use model::SectionModel;
pub(crate) use model::{OF_FORMULA, OF_SPLIT};
pub use oye::Oye;
pub use polar::Polar;
pub use quasi_steady::QuasiSteady;
pub(crate) use section::state;
pub use section::{Model, SectionFlow, SectionForce, StateName, Strip};
pub use separation_lag::SeparationLag;
