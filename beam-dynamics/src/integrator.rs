//! Integration in time of differential-algebraic systems; independent of nodes and elements.
//!
//! A system `F(y, y', t) = 0` is accessed through [`Dae`]: it keeps its states, so that rotations
//! stay matrices, and passes them to the integration schemes as numbers relative to its latest
//! accepted state. An [`Integrator`] makes accepted steps.

mod advance;
mod corrector;
mod counters;
mod dae;
mod failure;
mod formula;
mod lengths;
mod limits;
mod meter;
mod one_step;
mod prediction;
mod scheme;
mod speeds;

pub use advance::{Integrator, Progress, Stepped};
pub use counters::Counters;
pub use dae::{Corner, Dae, Renewal};
pub use failure::{LocalError, Reason, StepFailure};
pub use formula::{Formula, STAGES};
pub use limits::{Jacobians, StepLimits};
pub use one_step::OneStep;
pub use scheme::{Scheme, StepControl, Stepping};
