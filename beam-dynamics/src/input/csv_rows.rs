//! Rows of CSV files with the lines on which they stand. Empty lines and lines that begin
//! with `#` do not count.

use shared_geom::error::{Diagnostics, Explain, Place};

/// Problems of the rows that are shown one by one.
const ROWS_SHOWN: usize = 10;

/// The rows of a text, the heading among them, each with its line.
pub(super) fn records(text: &str) -> impl Iterator<Item = (usize, csv::StringRecord)> {
    let reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .trim(csv::Trim::All)
        .comment(Some(b'#'))
        .from_reader(text.as_bytes());
    // Reading text from memory and with rows of any length, nothing can fail.
    let records = reader.into_records().filter_map(Result::ok);
    records.map(move |record| (line(text, &record), record))
}

/// The line of a record: the reader tells where it began to look for it, which may be
/// at lines that do not count.
fn line(text: &str, record: &csv::StringRecord) -> usize {
    let begin = record.position().map_or(0, |place| place.byte() as usize);
    let (before, rest) = text.split_at_checked(begin).unwrap_or((text, ""));
    let counts = |line: &&str| !line.trim().is_empty() && !line.starts_with('#');
    let skipped = rest.lines().take_while(|line| !counts(line)).count();
    1 + before.matches('\n').count() + skipped
}

/// What is wrong with rows of `file`, one by one those that a reader will look at; `more`
/// tells how many others there are.
pub(super) fn problems<P: Explain>(
    file: &str,
    wrong: &[(usize, P)],
    more: impl Fn(usize) -> P,
) -> Diagnostics {
    let mut found = Diagnostics::new();
    for (line, problem) in wrong.iter().take(ROWS_SHOWN) {
        found.push(Place::line(file, *line), problem);
    }
    if let Some((line, _)) = wrong.get(ROWS_SHOWN) {
        found.push(Place::line(file, *line), &more(wrong.len() - ROWS_SHOWN));
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_told_with_the_lines_on_which_they_stand() {
        let text = "# one\n\na, b\r\n\n  \n1, 2\n# six\n\n3,4";
        let found: Vec<_> = records(text)
            .map(|(line, row)| (line, row[1].to_owned()))
            .collect();
        let expected = [(3, "b"), (6, "2"), (9, "4")];
        assert_eq!(found, expected.map(|(line, cell)| (line, cell.to_owned())));
    }
}
