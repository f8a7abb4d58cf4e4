//! Annular momentum: the velocity that a rotor induces in the air, ring by ring.
//!
//! One set of signs for all machines, the propeller form. In a section, `n` is normal to the span
//! in the plane of shaft and span, on the side of the thrust, and `t` is against the motion.
//! `Vx` is the velocity of the air relative to the section along `-n` without induction (positive
//! in climb, zero in hover, negative in descent), `Vy` its velocity along `t` (rotation). The
//! induced velocity `u` adds to `Vx`, the swirl `v` subtracts from `Vy`:
//!
//! ```text
//! Ux = Vx + u,  Uy = Vy - v,  W^2 = Ux^2 + Uy^2,  phi = atan2(Ux, Uy),  alpha = theta - phi
//! cn = cl cos phi - cd sin phi,  ct = cl sin phi + cd cos phi,  sigma = B c / (2 pi r)
//! ```
//!
//! A turbine is the same with its airfoils upside down: `cl -> -cl(-alpha)`; its induction factors
//! are `a = -u / Vx` and `a' = -v / Vy`, and its thrust and torque have the opposite signs.
//!
//! - [`solve`] finds the steady state of a ring by one bracketed unknown, the inflow angle.
//! - [`quasi_steady`] and [`balance`] give the same state as a relation of velocities that is
//!   smooth from windmill to climb: the form for systems of differential equations.

mod annulus;
mod bracket;
mod descent;
mod induction;
mod loss;
mod skew;
mod steady;
mod velocity;

pub(crate) use annulus::END_MARGIN;
pub use annulus::{Annulus, Options, SectionFlow};
pub use bracket::root as bracketed_root;
pub use induction::HighInduction;
pub use loss::{LOSS_FLOOR, hub_loss, loss, tip_loss};
pub use skew::{skew_factor, wake_skew};
pub use steady::{Outcome, Solution, solve};
pub use velocity::{Ambient, balance, induced_flow, mass_flow, mass_flow_by, quasi_steady};
