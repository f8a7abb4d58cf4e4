//! Rods, springs and dampers between nodes, or between a node and the frame of the model.

pub(in crate::elements) mod line;
mod rod;
mod spring;
mod spring_law;
mod spring_state;
mod support;

#[cfg(test)]
mod tests;

pub use line::End;
pub use rod::{Measure, Rod};
pub use spring::Spring;
pub use spring_law::SpringLaw;
pub use support::{SupportFrame, SupportLaw, SupportSpring};
