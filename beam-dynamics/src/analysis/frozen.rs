//! Scalars that hardly change, as the induced velocities of a frozen wake.
//!
//! The equation of a scalar x that relaxes is `E x' + A x = f`, with the time constant
//!
//! ```text
//! E / A > 1e4 s
//! ```
//!
//! 1e4 s are three hours; E of a frozen wake is ten days, and A is up to some tens where the induced velocity of
//! lightly loaded blades opposes itself by their lift. Such scalars are constants of small motions: the roots of their own, near
//! `-A/E`, would be the least damped ones of all.

use crate::assembly::Sparse;
use crate::model::Numbering;

/// Rate of relaxation below which a scalar is constant \[1/s\].
const SLOWEST: f64 = 1e-4;
/// Rate below which a root is zero \[1/s\].
const ZERO: f64 = 1e-7;

/// Indices of the unknowns of such scalars, by the derivatives of the equations by unknowns and by rates.
pub(super) fn frozen(by_unknowns: &Sparse, by_rates: &Sparse, numbering: &Numbering) -> Vec<usize> {
    let first = numbering.first_scalar();
    let is_frozen = |i: &usize| {
        let [a, e] = [by_unknowns, by_rates].map(|own| own.entry(*i, *i));
        a / e > 0.0 && a / e < SLOWEST
    };
    (first..first + numbering.scalars())
        .filter(is_frozen)
        .collect()
}

/// Whether a growth is the one of such a scalar alone \[1/s\]: a root that passes zero is nearer to it.
pub(super) fn is_frozen(growth: f64) -> bool {
    -growth < SLOWEST && -growth > ZERO
}
