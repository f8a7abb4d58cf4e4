//! Rows of CSV.

use shared_geom::table::column_names;

use crate::input::short_number;

/// Digits of the numbers in tables for programs: enough to compare two runs.
const DIGITS: usize = 10;

/// The rows as CSV below `heading`, whose names get the style of all tables; values that contain a
/// comma or a quote are quoted.
pub(super) fn csv_text(heading: &str, rows: impl IntoIterator<Item = Vec<String>>) -> String {
    csv_as_named(&column_names(heading), rows)
}

/// The rows as CSV below `heading`, the names of variables as other files of the result have them.
pub(super) fn csv_as_named(heading: &str, rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let mut writer = csv::WriterBuilder::new()
        .flexible(true)
        .from_writer(Vec::new());
    for row in rows {
        // In memory: writing cannot fail.
        let _ = writer.write_record(&row);
    }
    let rows = writer.into_inner().unwrap_or_default();
    let rows = String::from_utf8_lossy(&rows);
    format!("{heading}\n{rows}")
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
            csv_text("x,y at tip [m]", rows),
            "x,y_at_tip [m]\n\"a, b\",0.5\n\"say \"\"c\"\"\",0\n"
        );
    }
}
