//! Motion in time of small models.

#![allow(clippy::unwrap_used, reason = "tests end when a model cannot be run")]

mod contradicting;
mod corners;
mod jacobian;
pub(super) mod models;
mod sharing;
mod unknowing;
