//! Numbers of laws: one per component, or matrices.

use nalgebra::{Matrix6, SMatrix, SVector};
use shared_geom::document::Table;
use shared_geom::section::least_eigenvalue;
use shared_geom::units::Dimension;

use super::Components;
use super::problem::LawProblem;
use crate::input::too_stiff;

/// Part of the largest entry below which a difference is a rounding of the input.
const ROUNDING: f64 = 1e-9;

/// `force / strain^power`, per radian if the strain is an angle, times `time`.
pub(super) fn slope(force: Dimension, strain: Dimension, power: i8, time: i8) -> Dimension {
    let bare = Dimension { angle: 0, ..strain };
    force.times(bare, -power).times(Dimension::TIME, time)
}

/// One quantity per component, in SI units: a list, or for a law of one component a number.
/// In a law of six components, numbers in declared units.
pub(super) fn vector<const N: usize>(
    table: &Table<'_>,
    key: &str,
    dimensions: &[Dimension; N],
) -> Option<SVector<f64, N>> {
    let is_alike = dimensions.iter().all(|other| *other == dimensions[0]);
    let factors = dimensions.map(|dimension| {
        if is_alike {
            1.0
        } else {
            table.document().factor(dimension)
        }
    });
    let dimension = if is_alike {
        dimensions[0]
    } else {
        Dimension::NUMBER
    };
    let numbers = table.quantities(key, dimension)?;
    if numbers.len() != N {
        let each = if is_alike {
            dimension.to_string()
        } else {
            "a number".to_owned()
        };
        let expected = match N {
            1 => each,
            _ => format!("an array of {N}, each {each}"),
        };
        table.wrong(key, &expected);
        return None;
    }
    Some(SVector::from_fn(|i, _| numbers[i] * factors[i]))
}

/// One quantity per component, like [`vector`]; a single number applies to all, if they
/// have the same dimension. Zeros if absent.
pub(super) fn each<const N: usize>(
    table: &Table<'_>,
    key: &str,
    dimensions: &[Dimension; N],
) -> Option<SVector<f64, N>> {
    if !table.has(key) {
        return Some(SVector::zeros());
    }
    let is_alike = dimensions.iter().all(|other| *other == dimensions[0]);
    if is_alike && !table.is_list(key) {
        table.quantity(key, dimensions[0]).map(SVector::repeat)
    } else {
        vector(table, key, dimensions)
    }
}

/// Like [`each`], with no number below zero.
pub(super) fn each_positive<const N: usize>(
    table: &Table<'_>,
    key: &str,
    dimensions: &[Dimension; N],
) -> Option<SVector<f64, N>> {
    let found = each(table, key, dimensions)?;
    if found.min() < 0.0 {
        table.wrong(key, "numbers, zero or more");
        return None;
    }
    Some(found)
}

/// A symmetric matrix without a negative eigenvalue: a number (the same for all
/// components), a list (one per component) or rows, whose numbers are in declared units.
/// `time` is the power of time in its dimension.
pub(super) fn matrix<const N: usize>(
    table: &Table<'_>,
    key: &'static str,
    of: &Components<N>,
    time: i8,
) -> Option<SMatrix<f64, N, N>> {
    let dimension = |i: usize, j: usize| slope(of.force[i], of.strain[j], 1, time);
    if !table.is_nested(key) {
        let diagonal: [Dimension; N] = std::array::from_fn(|i| dimension(i, i));
        if !table.has(key) {
            let _ = table.require_quantity(key, diagonal[0]);
            return None;
        }
        let diagonal = each_positive(table, key, &diagonal)?;
        if !too_stiff::is_resolved(table, key, diagonal.iter().copied()) {
            return None;
        }
        return Some(SMatrix::from_diagonal(&diagonal));
    }
    let rows = table.rows(key, N, N)?;
    let factor = |i: usize, j: usize| table.document().factor(dimension(i, j));
    let matrix = SMatrix::<f64, N, N>::from_fn(|i, j| rows[i][j] * factor(i, j));
    let off = (matrix - matrix.transpose()).abs();
    let worst = off.iamax_full();
    if off[worst] > ROUNDING * matrix.amax() {
        let (row, column) = worst;
        let problem = LawProblem::Unsymmetric {
            key,
            entry: [row + 1, column + 1],
            found: [rows[row][column], rows[column][row]],
        };
        table.note(key, &problem);
        return None;
    }
    if !too_stiff::is_resolved(table, key, matrix.iter().copied()) {
        return None;
    }
    let least = least(&matrix);
    if least.is_nan() || least < -ROUNDING {
        table.note(key, &LawProblem::Indefinite { key, least });
        return None;
    }
    Some(matrix)
}

/// The least eigenvalue of a matrix scaled to a unit diagonal, or zero if that is less.
fn least<const N: usize>(matrix: &SMatrix<f64, N, N>) -> f64 {
    let mut padded = Matrix6::zeros();
    for i in 0..N {
        for j in 0..N {
            padded[(i, j)] = matrix[(i, j)];
        }
    }
    least_eigenvalue(&padded)
}
