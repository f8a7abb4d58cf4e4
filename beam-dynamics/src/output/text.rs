//! Aligned columns of text, and units of tables.

use std::f64::consts::PI;

/// Revolutions per minute in one radian per second.
pub(super) const RPM: f64 = 30.0 / PI;

/// Damping ratios up to this are treated as undamped: the round-off of the eigenvalues of stiff
/// models, far below the damping of any structure [-].
pub(super) const DAMPED: f64 = 1e-4;

/// A share with four decimals, zero without a sign.
pub(super) fn share(value: f64) -> String {
    format!("{:.4}", (1e4 * value).round() / 1e4 + 0.0)
}

/// Frequency over rotor speed [-]; `None` at rest.
pub(super) fn per_rev(frequency: f64, speed: f64) -> Option<f64> {
    (speed > 0.0).then(|| frequency * 2.0 * PI / speed)
}

/// Rows of text in aligned columns: the first to the left, the others to the right,
/// two spaces between them, no spaces at the ends of lines.
pub(super) fn aligned(rows: &[Vec<String>]) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |column: usize| {
        let cells = rows.iter().filter_map(|row| row.get(column));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<_> = (0..columns).map(width).collect();
    let mut text = String::new();
    for row in rows {
        let cells =
            row.iter()
                .zip(&widths)
                .enumerate()
                .map(|(column, (cell, &width))| match column {
                    0 => format!("{cell:width$}"),
                    _ => format!("  {cell:>width$}"),
                });
        text.push_str(cells.collect::<String>().trim_end());
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_aligned_and_lines_have_no_tail() {
        let row = |cells: &[&str]| cells.iter().map(|&cell| cell.to_owned()).collect();
        let rows = [
            row(&["mode", "Hz"]),
            row(&["lag 1", "1.5"]),
            row(&["x", ""]),
        ];
        assert_eq!(aligned(&rows), "mode    Hz\nlag 1  1.5\nx\n");
        assert_eq!(aligned(&[]), "");
    }

    #[test]
    fn round_off_is_zero() {
        assert_eq!(
            [-1e-9, 0.99999, 0.12344].map(share),
            ["0.0000", "1.0000", "0.1234"]
        );
    }

    // 600 rpm are 10 Hz.
    #[test]
    fn per_rev_has_no_value_at_rest() {
        let found = per_rev(25.0, 600.0 / RPM).unwrap();
        assert!((found - 2.5).abs() < 1e-15, "{found}");
        assert_eq!(per_rev(25.0, 0.0), None);
    }
}
