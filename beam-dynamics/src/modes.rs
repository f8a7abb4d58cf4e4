//! Modes: eigenvalues of the linearized system, the motion of each mode, and the mode at
//! the next speed that continues it.

mod assignment;
mod beside_states;
mod continued;
mod copies;
mod eigen;
mod eigenpair;
mod factors;
mod frequencies;
mod inverse;
mod krylov;
mod motion;
mod multiblade;
mod refined;
mod ritz;
mod round_off;
mod separation;
mod shaft;
mod shift;
mod sorted;
mod tracking;
mod undamped;

pub use assignment::{assign, unlikeness};
pub use copies::is_new;
pub use eigen::{EigenProblem, Lowest};
pub use eigenpair::Eigenpair;
pub use factors::Factors;
pub use frequencies::highest_of_a_node;
pub use motion::{MassMatrix, ModeMotion};
pub use multiblade::Rotor;
pub use separation::{align, separate, separate_by, separate_patterns};
pub use shaft::shaft_whirl;
pub use tracking::{assurances, closeness, follow};
