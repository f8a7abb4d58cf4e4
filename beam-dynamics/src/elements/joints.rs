//! Constraints between nodes, and between a node and the frame.

mod clamp;

pub use clamp::Clamp;
