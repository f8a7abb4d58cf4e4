//! Rows of CSV files with their lines. Empty lines and lines that begin with `#` are
//! ignored.

use shared_geom::error::{Diagnostics, Explain, SourceLocation};

/// Number of problems of rows that are listed.
const ROWS_SHOWN: usize = 10;

/// The rows of a text, including the heading, each with its line.
pub(super) fn records(text: &str) -> impl Iterator<Item = (usize, csv::StringRecord)> {
    let reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .trim(csv::Trim::All)
        .comment(Some(b'#'))
        .from_reader(text.as_bytes());
    // Reading from memory, with rows of any length, cannot fail.
    let records = reader.into_records().filter_map(Result::ok);
    let is_empty = |record: &csv::StringRecord| record.len() == 1 && record[0].is_empty();
    let records = records.filter(move |record| !is_empty(record));
    records.map(move |record| (line(text, &record), record))
}

/// The line of a record: the reader reports the position where it began to look for the
/// record, which may be at ignored lines.
fn line(text: &str, record: &csv::StringRecord) -> usize {
    let begin = record.position().map_or(0, |index| index.byte() as usize);
    let (before, rest) = text.split_at_checked(begin).unwrap_or((text, ""));
    let counts = |line: &&str| !line.trim().is_empty() && !line.starts_with('#');
    let skipped = rest.lines().take_while(|line| !counts(line)).count();
    1 + before.matches('\n').count() + skipped
}

/// Problems of rows of `file`: the first ones are listed; `more` gives the number of the
/// others.
pub(super) fn problems<P: Explain>(
    file: &str,
    wrong: &[(usize, P)],
    more: impl Fn(usize) -> P,
) -> Diagnostics {
    let mut found = Diagnostics::new();
    for (line, problem) in wrong.iter().take(ROWS_SHOWN) {
        found.push(SourceLocation::line(file, *line), problem);
    }
    if let Some((line, _)) = wrong.get(ROWS_SHOWN) {
        found.push(
            SourceLocation::line(file, *line),
            &more(wrong.len() - ROWS_SHOWN),
        );
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_reported_with_the_lines_on_which_they_are() {
        let text = "# one\n\na, b\r\n\n  \n1, 2\n# six\n\n3,4";
        let found: Vec<_> = records(text)
            .map(|(line, row)| (line, row[1].to_owned()))
            .collect();
        let expected = [(3, "b"), (6, "2"), (9, "4")];
        assert_eq!(found, expected.map(|(line, cell)| (line, cell.to_owned())));
    }
}
