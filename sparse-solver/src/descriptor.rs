//! The minimal form of a linear descriptor system: its states, and all unknowns by them.
//!
//! ```text
//! E x' + K x + F u = 0                                                             (D-333)
//! ```
//!
//! has equations with rates, algebraic equations and constraints of any index that machines have.
//! With `E P = Q R` of rank r, the unknowns are r that have rates, x1, and the others, x2:
//!
//! ```text
//! x1' = A x1 + N x2 + B u
//! 0   = G x1 + L x2 + H u                                                          (D-334)
//! ```
//!
//! As many x2 as L has rank follow from the second and are eliminated; the equations that remain have
//! none, `G x1 = 0`. They leave some x1 free, z, by which the others are known,
//!
//! ```text
//! x1 = T z ,     x1' = T z'                                                        (D-335)
//! ```
//!
//! and the same is done with the equations of z and the remaining x2, until no x2 is left. The states are the
//! last z. An input in a constraint would act by its derivatives: it is refused.
//!
//! Rows, columns and inputs are scaled by powers of two, and time by a given rate.

mod elimination;
mod free;
mod graded;
mod ranked;
mod scaled;
mod system;

use elimination::Elimination;
use scaled::Scaled;
pub use system::{Descriptor, DescriptorState, Minimal, NotMinimal};

/// The minimal form of a `system` whose highest frequency is of the size of `rate` \[1/s\].
///
/// # Errors
/// [`NotMinimal`].
pub fn minimal(system: &Descriptor, rate: f64) -> Result<Minimal, NotMinimal> {
    let scaled = Scaled::new(system, rate)?;
    let Elimination { a, b, x, y, names } = Elimination::new(&scaled)?;
    let residual = scaled.residual([&x, &y], [&a, &b]);
    let state = |(unknown, is_part): (usize, bool)| DescriptorState { unknown, is_part };
    let states = names.into_iter().map(state).collect();
    Ok(scaled.unscaled(states, [&a, &b], [&x, &y], residual))
}
