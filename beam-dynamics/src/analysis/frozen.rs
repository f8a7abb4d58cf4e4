//! Scalars that hardly change, as the induced velocities of a frozen wake.
//!
//! The equation of a scalar x that relaxes is `E x' + A x = f`, with the time constant
//!
//! ```text
//! E / A > 1e5 s
//! ```
//!
//! of more than a day for a frozen wake. Such scalars are constants of small motions: the roots of their own, near
//! `-A/E`, would be the least damped ones of all.

use crate::assembly::Sparse;
use crate::model::Numbering;

/// Rate of relaxation below which a scalar is constant \[1/s\].
const SLOWEST: f64 = 1e-5;

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

/// Lets the equations of unknowns `held` be the ones of constants without change.
pub(super) fn hold(held: &[usize], [by_unknowns, by_rates]: [&mut Sparse; 2]) {
    for (matrix, keeps_diagonal) in [(by_unknowns, true), (by_rates, false)] {
        let pattern = std::sync::Arc::clone(matrix.pattern());
        for column in 0..pattern.size() {
            for index in pattern.column(column) {
                let row = pattern.rows()[index] as usize;
                let is_kept = keeps_diagonal && row == column;
                if !is_kept && held.binary_search(&row).is_ok() {
                    matrix.values_mut()[index] = 0.0;
                }
            }
        }
    }
}
