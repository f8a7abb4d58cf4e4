//! Momentum balance of nodes, and rigid bodies.

mod balance;
mod body;

pub use balance::NodeBalance;
pub use body::{RigidBody, RigidInertia};
