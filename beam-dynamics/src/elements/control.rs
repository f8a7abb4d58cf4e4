//! Elements that act by signals alone: filters and control laws.

mod inputs;
mod sampled;
mod state_space;

pub use sampled::{Limits, Sampled, Sampling};
pub use state_space::{Matrices, StateSpace};
