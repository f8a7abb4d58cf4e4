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
/// Part of a singular vector from which a control has a part in it.
const TAKES_PART: f64 = 0.3;

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

/// Why controls (columns of the response) do not determine targets (rows), as text, given the response
/// and its relative errors; `None` if they do. Names are found without the units of both, unless the response is
/// regular then.
pub(super) fn idle(
    (response, errors): (&DMatrix<f64>, f64),
    controls: &[TrimControl],
    targets: &[TrimTarget],
) -> Option<String> {
    let in_units = reason((response, errors), controls, targets)?;
    let balanced = balanced(response.clone());
    Some(reason((&balanced, errors), controls, targets).unwrap_or(in_units))
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

/// The same, if the response without the units of controls and targets does not determine them either.
pub(super) fn idle_in_any_units(
    (response, errors): (DMatrix<f64>, f64),
    controls: &[TrimControl],
    targets: &[TrimTarget],
) -> Option<String> {
    reason((&response, errors), controls, targets)?;
    reason((&balanced(response), errors), controls, targets)
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
