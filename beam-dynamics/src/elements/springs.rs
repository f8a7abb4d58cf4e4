//! Springs and dampers between a node and what carries the model.

mod support;

pub use support::{Stand, SupportLaw, SupportSpring};
