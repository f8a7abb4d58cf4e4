//! Analyses: each reads as its method, one call a step.

pub mod modes;
pub mod steady;
