//! Scales of the rows and columns of a matrix: rows and then columns are scaled to a largest
//! entry of one, so that forces of 1e7 N and angles of 1e-3 rad are comparable in the choice of
//! pivots.

use super::number::Number;
use crate::pattern::Pattern;

/// Scales of rows, and of columns.
pub(crate) type Scales = (Vec<f64>, Vec<f64>);

/// Scales for the matrix of the given values; `None` if a row or column is zero.
pub(crate) fn scales<T: Number>(pattern: &Pattern, values: &[T]) -> Option<Scales> {
    let n = pattern.size();
    let mut rows = vec![0.0_f64; n];
    for (&i, value) in pattern.rows().iter().zip(values) {
        let row = &mut rows[i as usize];
        *row = row.max(value.size());
    }
    let mut columns = vec![0.0_f64; n];
    for (j, column) in columns.iter_mut().enumerate() {
        for index in pattern.column(j) {
            let row = rows[pattern.rows()[index] as usize].max(f64::MIN_POSITIVE);
            *column = column.max(values[index].size() / row);
        }
    }
    let inverse = |sizes: Vec<f64>| -> Option<Vec<f64>> {
        let invert = |size: f64| (size > 0.0 && size.is_finite()).then(|| 1.0 / size);
        sizes.into_iter().map(invert).collect()
    };
    Some((inverse(rows)?, inverse(columns)?))
}

/// The values multiplied by the scales of their rows and columns.
pub(crate) fn scaled<T: Number>(pattern: &Pattern, values: &[T], scales: &Scales) -> Vec<T> {
    let (rows, columns) = scales;
    let mut scaled = values.to_vec();
    for (j, scale) in columns.iter().enumerate() {
        for index in pattern.column(j) {
            scaled[index] = scaled[index] * (rows[pattern.rows()[index] as usize] * scale);
        }
    }
    scaled
}
