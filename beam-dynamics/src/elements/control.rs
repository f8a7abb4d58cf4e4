//! Elements that act by signals alone: filters and control laws.

mod state_space;

pub use state_space::{Matrices, StateSpace};
