//! Constraints between nodes, and between a node and the frame.

mod algebra;
mod clamp;
mod hinge;
mod joint;
mod kinds;
mod relative;
mod rigid;

pub use algebra::Attachment;
pub use clamp::{clamped, partly_clamped};
pub use hinge::{Hinge, HingeSpring};
pub use joint::{ConstraintJoint, JointEnds};
pub use kinds::{Freedom, Placing, Turning, axes_along};
pub use rigid::rigid_connection;

#[cfg(test)]
mod kinds_tests;
#[cfg(test)]
pub(super) mod samples;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod words_tests;
