//! Controls that do not determine their targets, from the response of the targets to the controls.
//!
//! With the response C, targets of size one by controls of size one, and its singular values
//! `C = U S V^T`, a singular value of zero has the controls in its column of V that have no effect, or
//! the same one, and the targets in its column of U that no control reaches.

use nalgebra::DMatrix;

use crate::case::{TrimControl, TrimTarget};

/// Relative errors of a response of a factorized matrix: singular values up to this part of the largest
/// one are zero.
pub(super) const EXACT: f64 = 1e-7;
/// The same of a response by products with a linearized period, which is solved to a residual of 1e-8.
pub(super) const BY_PRODUCTS: f64 = 1e-5;
/// Size of the largest response below which the one of a factorized matrix is zero \[-\].
const LEAST: f64 = 1e-9;
/// Mean response relative to momentary ones below which it is round-off: products are solved to 1e-8, and a
/// motion that is not converged has blades that differ a little \[-\].
const ROUND_OFF: f64 = 1e-6;
/// Part of a singular vector from which a control has a part in it.
const TAKES_PART: f64 = 0.3;

/// Sizes by which the response of the mean of a target over a period is round-off, in any unit of the target.
/// Motions are the largest changes relative to the sizes of the model by each control, so that units of controls
/// have no effect either.
pub(super) struct Noise<'a> {
    /// Mean of the size of the target's quantity.
    pub travel: f64,
    /// Means of the sizes of its momentary changes by the controls.
    pub changes: Vec<f64>,
    /// Changes of the motion by the controls.
    pub motions: &'a [f64],
}

impl Noise<'_> {
    /// Whether responses of a target to all controls are round-off of its quantity for changes of the motion
    /// of size one.
    pub fn hides<'b>(&self, responses: impl Iterator<Item = &'b f64>) -> bool {
        let pairs = || self.changes.iter().zip(self.motions);
        let moving = pairs().filter(|(_, motion)| **motion > 0.0);
        let by_motion = moving.map(|(change, motion)| change / motion);
        let size = by_motion.fold(self.travel, f64::max);
        responses
            .zip(pairs())
            .all(|(own, (change, motion))| own.abs() <= ROUND_OFF * change.max(motion * size))
    }
}

/// A response with rows and columns of largest entry one, where there are others than zeros: without the
/// units of controls and targets.
fn balanced(mut response: DMatrix<f64>) -> DMatrix<f64> {
    for mut row in response.row_iter_mut() {
        let largest = row.amax();
        if largest > 0.0 {
            row /= largest;
        }
    }
    for mut column in response.column_iter_mut() {
        let largest = column.amax();
        if largest > 0.0 {
            column /= largest;
        }
    }
    response
}

/// Why controls (columns of the response) do not determine targets (rows), in whatever units both are, as text,
/// given the response and its relative errors; `None` if they do.
pub(super) fn idle(
    (response, errors): (&DMatrix<f64>, f64),
    controls: &[TrimControl],
    targets: &[TrimTarget],
) -> Option<String> {
    reason((response, errors), controls, targets)?;
    reason((&balanced(response.clone()), errors), controls, targets)
}

/// The same of a response as it is given.
fn reason(
    (response, errors): (&DMatrix<f64>, f64),
    controls: &[TrimControl],
    targets: &[TrimTarget],
) -> Option<String> {
    if response.is_empty() {
        return None;
    }
    let largest = response.amax();
    let found = response.clone().svd(true, true);
    let (least, value) = found.singular_values.argmin();
    if value > errors * largest.max(LEAST) {
        return None;
    }
    let (u, v_t) = (found.u?, found.v_t?);
    let direction = v_t.row(least).transpose();
    let (target, control) = (u.column(least).iamax(), direction.iamax());
    let sharing = (0..controls.len()).filter(|i| direction[*i].abs() > TAKES_PART);
    let sharing: Vec<_> = sharing
        .map(|i| format!("\"{}\"", controls[i].name))
        .collect();
    let small = |norm: f64| norm <= errors * largest.max(LEAST);
    let why = match sharing.as_slice() {
        _ if small(response.row(target).norm()) => {
            format!(
                "no control has an effect on \"{}\"",
                targets.get(target)?.name
            )
        }
        [one] => format!("{one} has no effect on any target"),
        several => {
            let alike = (0..targets.len()).filter(|i| u[(*i, least)].abs() > TAKES_PART);
            let alike: Vec<_> = alike.map(|i| format!("\"{}\"", targets[i].name)).collect();
            let alike = match alike.len() {
                0 | 1 => String::new(),
                _ => format!(", or {} respond alike to all controls", alike.join(" and ")),
            };
            format!(
                "{} have the same effect on all targets{alike}",
                several.join(" and ")
            )
        }
    };
    Some(format!(
        "the controls do not determine the targets: \"{}\" acts least, and \"{}\" is reached least; {why}",
        controls.get(control)?.name,
        targets.get(target)?.name
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(rows: &[f64]) -> Option<String> {
        within(rows, EXACT)
    }

    fn within(rows: &[f64], errors: f64) -> Option<String> {
        let controls = ["a", "b"].map(|name| TrimControl {
            name: name.to_owned(),
            label: name.to_owned(),
            scale: 1.0,
            bounds: [f64::NEG_INFINITY, f64::INFINITY],
            step: f64::INFINITY,
        });
        let targets = ["p", "q"].map(|name| TrimTarget {
            name: name.to_owned(),
            label: name.to_owned(),
            value: 0.0,
            scale: 1.0,
        });
        let response = DMatrix::from_row_slice(2, 2, rows);
        reason((&response, errors), &controls, &targets)
    }

    // A force in N and a coefficient by an angle in degrees: regular, but not in these units.
    #[test]
    fn balanced_responses_have_no_units() {
        let rows = [1e4, 2e4, 1e-3, -1e-3];
        let response = balanced(DMatrix::from_row_slice(2, 2, &rows));
        assert!(response.amax() == 1.0 && text(response.transpose().as_slice()).is_none());
        let same = balanced(DMatrix::from_row_slice(2, 2, &[1e4, 2e4, 1e-3, 2e-3]));
        assert!(text(same.transpose().as_slice()).is_some());
        assert_eq!(balanced(DMatrix::zeros(2, 2)), DMatrix::zeros(2, 2));
    }

    // Two controls in radians, of which the first one turns blades by 2 rad: round-off of 1e-8 of a thrust in any
    // unit is hidden, also of a thrust that is zero itself and changes by the other control, and a response of 1e-3
    // is not, nor the one of a control that acts without a motion.
    #[test]
    fn round_off_is_relative_to_the_quantity() {
        for unit in [1e-9, 1.0, 1e9] {
            let hides = |responses: [f64; 2], travel: f64, changes: [f64; 2], motions: [f64; 2]| {
                let noise = Noise {
                    travel: travel * unit,
                    changes: changes.map(|change| change * unit).to_vec(),
                    motions: &motions,
                };
                noise.hides(responses.map(|own| own * unit).iter())
            };
            assert!(hides([1e-8, -1e-8], 1.0, [1e-8, 1e-8], [2.0, 1.0]));
            assert!(hides([1e-8, -1e-8], 0.0, [1e-8, 3.0], [2.0, 1.0]));
            assert!(!hides([1e-3, 1e-8], 1.0, [1e-3, 1e-8], [2.0, 1.0]));
            assert!(!hides([0.0, 1e-8], 1.0, [0.0, 1e-8], [2.0, 0.0]));
            assert!(hides([0.0, 0.0], 1.0, [0.0, 0.0], [0.0, 0.0]));
        }
    }

    // Columns of zeros and columns in proportion; a regular response of small numbers is none of these.
    #[test]
    fn the_reason_is_named() {
        let none = text(&[1.0, 0.0, 2.0, 0.0]).unwrap();
        assert!(none.contains("\"b\" has no effect"), "{none}");
        let same = text(&[1.0, 2.0, 3.0, 6.0]).unwrap();
        assert!(
            same.contains("\"a\" and \"b\" have the same effect"),
            "{same}"
        );
        assert!(
            same.ends_with("or \"p\" and \"q\" respond alike to all controls"),
            "{same}"
        );
        let unreached = text(&[1.0, 2.0, 0.0, 0.0]).unwrap();
        assert!(unreached.contains("\"q\" is reached least"), "{unreached}");
        assert!(
            unreached.ends_with("no control has an effect on \"q\""),
            "{unreached}"
        );
        assert_eq!(text(&[1e-5, 2e-5, 2e-5, 1e-5]), None);
        // Errors of an iteration hide the proportion.
        let noisy = [1.0, 2.0, 3.0, 6.0 + 1e-5];
        assert_eq!(text(&noisy), None);
        let same = within(&noisy, BY_PRODUCTS).unwrap();
        assert!(
            same.contains("\"a\" and \"b\" have the same effect"),
            "{same}"
        );
    }
}
