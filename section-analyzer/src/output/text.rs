//! Numbers and columns of a text report.

use nalgebra::Matrix6;
use shared_geom::table::column_names;
use shared_geom::wrench::COMPONENTS;

/// Entries of a matrix below this fraction of `sqrt(Aii Ajj)` are shown as zero:
/// round-off of the solution.
pub(super) const ZERO: f64 = 1e-12;

/// A number with six digits, as `1.23456e7`; zero as `0`.
pub(super) fn number(value: f64) -> String {
    if value == 0.0 {
        "0".to_owned()
    } else {
        format!("{value:.5e}")
    }
}

/// A coordinate with at most six digits, in plain notation if that is short. Coordinates
/// that are round-off compared with `scale`, the size of the section, are shown as zero.
pub(super) fn coordinate(value: f64, scale: f64) -> String {
    shared_geom::figure::tick_label(
        if value.abs() < ZERO * scale {
            0.0
        } else {
            value
        },
        0.0,
    )
}

/// The value to two digits, for approximate values.
pub(super) fn rounded(value: f64) -> f64 {
    format!("{value:.1e}").parse().unwrap_or(value)
}

/// The matrix in aligned columns under the names of the components.
pub(super) fn matrix(a: &Matrix6<f64>) -> String {
    let mut rows = vec![
        std::iter::once("")
            .chain(COMPONENTS)
            .map(str::to_owned)
            .collect(),
    ];
    for i in 0..6 {
        let mut row = vec![COMPONENTS[i].to_owned()];
        for j in 0..6 {
            let scale = (a[(i, i)] * a[(j, j)]).abs().sqrt();
            let shown = if a[(i, j)].abs() <= ZERO * scale {
                0.0
            } else {
                a[(i, j)]
            };
            row.push(number(shown));
        }
        rows.push(row);
    }
    table(&rows, "lr")
}

/// The matrix row by row.
pub(super) fn rows(a: &Matrix6<f64>) -> [[f64; 6]; 6] {
    std::array::from_fn(|i| std::array::from_fn(|j| a[(i, j)]))
}

/// Rows as CSV, the first with the names of the columns, which get the style of all tables; cells with
/// commas or quotes are quoted.
pub(super) fn csv(rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let mut writer = csv::WriterBuilder::new()
        .flexible(true)
        .from_writer(Vec::new());
    for (number, mut row) in rows.into_iter().enumerate() {
        if number == 0 {
            row = row.iter().map(|name| column_names(name)).collect();
        }
        // writing to memory cannot fail
        let _ = writer.write_record(&row);
    }
    let bytes = writer.into_inner().unwrap_or_default();
    String::from_utf8(bytes).unwrap_or_default()
}

/// Rows in columns two spaces apart, each line indented by two. `sides` has a
/// letter for each column: `l` flush left, `r` flush right; the last letter
/// applies to all further columns.
pub(super) fn table(rows: &[Vec<String>], sides: &str) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |column: usize| {
        let cells = rows.iter().filter_map(|row| row.get(column));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<_> = (0..columns).map(width).collect();
    let side = |column: usize| sides.chars().nth(column).or(sides.chars().last());
    let mut text = String::new();
    for row in rows {
        let mut line = String::new();
        for (column, (cell, width)) in row.iter().zip(&widths).enumerate() {
            line += "  ";
            line += &match side(column) {
                Some('l') => format!("{cell:<width$}"),
                _ => format!("{cell:>width$}"),
            };
        }
        text += line.trim_end();
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_aligned_and_lines_have_no_trailing_spaces() {
        let rows = [["a", "1"], ["long", "23"], ["b", ""]];
        let rows = rows.map(|row| row.map(str::to_owned).to_vec());
        assert_eq!(table(&rows, "lr"), "  a      1\n  long  23\n  b\n");
    }

    #[test]
    fn round_off_is_shown_as_zero() {
        let mut a = Matrix6::from_diagonal_element(4.0);
        a[(0, 1)] = 3e-12;
        a[(0, 2)] = -5e-12;
        let text = matrix(&a);
        let first: Vec<_> = text.lines().nth(1).unwrap().split_whitespace().collect();
        assert_eq!(
            first,
            ["axial", "4.00000e0", "0", "-5.00000e-12", "0", "0", "0"]
        );
        assert_eq!(coordinate(-1e-14, 1.0), "0");
        assert_eq!(coordinate(-0.37484, 1.0), "-0.37484");
    }
}
