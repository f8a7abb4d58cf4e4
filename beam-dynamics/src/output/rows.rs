//! Rows of CSV.

use crate::input::short_number;

/// Digits of the numbers in tables for programs: enough to compare two runs.
const DIGITS: usize = 10;

/// The rows as CSV below `heading`; values that contain a comma or a quote are quoted.
pub(super) fn csv_text(heading: &str, rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        // Rows of equal length in memory: writing cannot fail.
        let _ = writer.write_record(&row);
    }
    let rows = writer.into_inner().unwrap_or_default();
    format!("{heading}\n{}", String::from_utf8_lossy(&rows))
}

/// A heading of `names`, of which those with a comma or a quote are quoted.
pub(super) fn heading<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    let names = names.into_iter().map(|name| {
        if name.contains([',', '"', '\n']) {
            format!("\"{}\"", name.replace('"', "\"\""))
        } else {
            name.to_owned()
        }
    });
    names.collect::<Vec<_>>().join(",")
}

/// A number of a table.
pub(super) fn number(value: f64) -> String {
    short_number(value, DIGITS)
}

/// Numbers of a table.
pub(super) fn numbers<'a>(values: impl IntoIterator<Item = &'a f64>) -> Vec<String> {
    values.into_iter().map(|value| number(*value)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_with_commas_are_quoted() {
        let rows = vec![
            vec!["a, b".to_owned(), number(0.5)],
            vec!["say \"c\"".to_owned(), number(-0.0)],
        ];
        assert_eq!(
            csv_text("x,y", rows),
            "x,y\n\"a, b\",0.5\n\"say \"\"c\"\"\",0\n"
        );
    }
}
