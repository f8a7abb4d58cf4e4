//! Motion in time of small models.

#![allow(clippy::unwrap_used, reason = "tests end when a model cannot be run")]

mod beside;
mod bipendulum;
mod contradicting;
mod corners;
mod failing;
mod flexible;
mod following;
mod gravity;
mod jacobian;
mod linkages;
pub(super) mod models;
mod rigid;
mod sampled;
mod scalars;
mod speeds;
mod stalling;
mod starting;
mod unknowing;
mod variable;
mod winding;
