//! Constraints between nodes, and between a node and the frame.

mod algebra;
mod clamp;
mod hinge;
mod rigid;

pub use algebra::Attachment;
pub use clamp::Clamp;
pub use hinge::{Hinge, HingeSpring};
pub use rigid::RigidConnection;

#[cfg(test)]
mod tests;
