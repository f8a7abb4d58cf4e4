//! Elements that act only through signals: filters, control laws and actuators.

mod actuator;
mod balanced;
mod inputs;
mod kept;
mod sampled;
mod state_space;

pub use actuator::{Actuator, Servo};
pub use balanced::Balanced;
pub use kept::{Kept, Wave};
pub use sampled::{Limits, Sampled, Sampling};
pub use state_space::{Matrices, StateSpace};
