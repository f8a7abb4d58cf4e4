//! The st file: sets of sub-sets of rows.
//!
//! ```text
//! 1 number of sets
//! #1 words              a set
//! $1 20 words           a sub-set of 20 rows, which follow
//! ```
//!
//! A row has 19 columns, or 30 with a fully populated stiffness; further text, or text
//! after a semicolon, is a comment, as is every line outside of the rows.

use crate::error::shortened;
use crate::exchange::problem::{ExchangeProblem, Problems};
use crate::exchange::text::{Line, lines, not_a_number, number};

/// Columns of a classic row.
pub(super) const CLASSIC: [&str; 19] = [
    "r", "m", "x_cg", "y_cg", "ri_x", "ri_y", "x_sh", "y_sh", "E", "G", "I_x", "I_y", "I_p", "k_x",
    "k_y", "A", "pitch", "x_e", "y_e",
];

/// Columns of a fully populated row.
pub(super) const FULL: [&str; 30] = [
    "r", "m", "x_cg", "y_cg", "ri_x", "ri_y", "pitch", "x_e", "y_e", "K_11", "K_12", "K_13",
    "K_14", "K_15", "K_16", "K_22", "K_23", "K_24", "K_25", "K_26", "K_33", "K_34", "K_35", "K_36",
    "K_44", "K_45", "K_46", "K_55", "K_56", "K_66",
];

/// The numbers of a row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Row {
    Classic([f64; 19]),
    Full([f64; 30]),
}

impl Row {
    /// Distance along the line [m].
    pub fn distance(&self) -> f64 {
        match self {
            Self::Classic(row) => row[0],
            Self::Full(row) => row[0],
        }
    }
}

/// A sub-set: its numbers, its line, and the lines of its rows.
#[derive(Debug, Clone)]
pub(super) struct SubSet<'a> {
    pub set: usize,
    pub number: usize,
    pub line: usize,
    announced: usize,
    rows: Vec<Line<'a>>,
}

impl SubSet<'_> {
    /// Its name, for messages.
    pub fn name(&self) -> String {
        format!("set {}, sub-set {}", self.set, self.number)
    }
}

/// Whether `text` looks like an st file.
pub(super) fn recognize(text: &str) -> bool {
    let all = lines(text);
    let set = all.iter().position(|line| mark(line.text, '#').is_some());
    let Some(set) = set else {
        return false;
    };
    let head = all[set..].iter().find(|line| line.text.starts_with('$'));
    head.is_some_and(|line| mark(line.text, '$').is_some_and(|numbers| numbers.len() == 2))
}

/// The one or two whole numbers after a mark; `None` without them.
fn mark(text: &str, letter: char) -> Option<Vec<usize>> {
    let rest = text.strip_prefix(letter)?;
    let words = rest.split(|c: char| c.is_whitespace() || c == ';' || c == ',');
    let words = words.filter(|word| !word.is_empty()).take(2);
    let numbers: Vec<usize> = words.map_while(|word| word.parse().ok()).collect();
    (!numbers.is_empty()).then_some(numbers)
}

/// The sub-sets of all sets; notes marks that cannot be read.
pub(super) fn sub_sets<'a>(text: &'a str, problems: &mut Problems) -> Vec<SubSet<'a>> {
    let mut found: Vec<SubSet<'a>> = Vec::new();
    let mut set = None;
    let mut open = false;
    for line in lines(text) {
        match line.text.chars().next() {
            Some('#') => {
                open = false;
                // A line of text that begins in this way is a comment.
                set = mark(line.text, '#').map(|numbers| numbers[0]).or(set);
            }
            Some('$') => {
                let numbers = mark(line.text, '$');
                open = match (set, numbers.as_deref()) {
                    (Some(set), Some(&[number, announced])) => {
                        found.push(SubSet {
                            set,
                            number,
                            line: line.number,
                            announced,
                            rows: Vec::new(),
                        });
                        true
                    }
                    _ => {
                        problems.push(line.number, &bad_mark(line.text, set.is_some()));
                        false
                    }
                };
            }
            _ if open => {
                if let Some(last) = found
                    .last_mut()
                    .filter(|last| last.rows.len() < last.announced)
                {
                    last.rows.push(line);
                }
            }
            _ => {}
        }
    }
    found
}

fn bad_mark(text: &str, in_set: bool) -> ExchangeProblem {
    ExchangeProblem::Other {
        what: "the head of a sub-set".to_owned(),
        found: format!("\"{}\"", shortened(text)),
        expected: if in_set {
            "$, its number and the number of its rows".to_owned()
        } else {
            "a set (#1) before it".to_owned()
        },
        help: "write #1 for the set, and below it $1 20 for a sub-set of 20 rows".to_owned(),
    }
}

/// The rows of a sub-set; notes problems. `is_full` is the statement of the htc file.
pub(super) fn rows(
    sub_set: &SubSet<'_>,
    is_full: Option<bool>,
    problems: &mut Problems,
) -> Option<Vec<Row>> {
    let found = sub_set.rows.len();
    if found < sub_set.announced {
        let last = sub_set.rows.last().map_or(sub_set.line, |line| line.number);
        let problem = ExchangeProblem::CutShort {
            what: format!("{}, after {found} rows", sub_set.name()),
            expected: format!("{} rows, as its head announces", sub_set.announced),
        };
        problems.push(last, &problem);
    }
    let first = sub_set.rows.first()?;
    let columns = columns(first, is_full, problems)?;
    let mut before: Option<f64> = None;
    let mut row = |line: &Line<'_>| {
        let row = row(line, columns, problems)?;
        let distance = row.distance();
        if let Some(before) = before.filter(|&before| distance < before) {
            let what = format!("the distance r of a row of {}", sub_set.name());
            let problem = ExchangeProblem::Order {
                what,
                found: distance,
                before,
            };
            problems.push(line.number, &problem);
        }
        before = Some(distance);
        Some(row)
    };
    // All are read, so that all problems are reported.
    let rows: Vec<_> = sub_set.rows.iter().map(&mut row).collect();
    let rows: Vec<_> = rows.into_iter().collect::<Option<_>>()?;
    (found == sub_set.announced).then_some(rows)
}

/// Words of a row before its comment.
fn words<'a>(line: &Line<'a>) -> Vec<&'a str> {
    let text = line.text.split(';').next().unwrap_or_default();
    text.split_whitespace().collect()
}

/// Number of columns of the rows, from the first row and the htc file.
fn columns(
    first: &Line<'_>,
    is_full: Option<bool>,
    problems: &mut Problems,
) -> Option<&'static [&'static str]> {
    let words = words(first);
    let numbers = words
        .iter()
        .take_while(|word| number(word).is_some())
        .count();
    let reported: &[&str] = match words.len() {
        count if count >= FULL.len() => &FULL,
        _ if numbers <= CLASSIC.len() => &CLASSIC,
        _ => {
            problems.push(
                first.number,
                &ExchangeProblem::Other {
                    what: "a row of the st file".to_owned(),
                    found: format!("{numbers} numbers"),
                    expected: "19 (classic) or 30 (fully populated)".to_owned(),
                    help: "the line may be cut, or two numbers may have run together".to_owned(),
                },
            );
            return None;
        }
    };
    match is_full {
        Some(full) if full != (reported.len() == FULL.len()) => {
            let (stated, expected) = if full {
                ("FPM 1", FULL.len())
            } else {
                ("no FPM 1", CLASSIC.len())
            };
            problems.push(
                first.number,
                &ExchangeProblem::Other {
                    what: "a row of the st file".to_owned(),
                    found: format!("{numbers} numbers"),
                    expected: format!("{expected}, since the htc file has {stated}"),
                    help:
                        "put the line \"FPM 1 ;\" into timoschenko_input for rows of 30 columns, \
                           and none for rows of 19"
                            .to_owned(),
                },
            );
            None
        }
        _ => Some(reported),
    }
}

fn row(line: &Line<'_>, columns: &[&str], problems: &mut Problems) -> Option<Row> {
    let words = words(line);
    let mut values = Vec::with_capacity(columns.len());
    for (word, column) in words.iter().zip(columns) {
        match number(word) {
            Some(value) => values.push(value),
            None => problems.push(
                line.number,
                &not_a_number(&format!("column {column}"), word),
            ),
        }
    }
    if words.len() < columns.len() {
        let problem = ExchangeProblem::Count {
            what: "a row of the st file".to_owned(),
            expected: columns.len(),
            found: words.len(),
            separator: "blanks",
        };
        problems.push(line.number, &problem);
    }
    match columns.len() {
        30 => values.try_into().ok().map(Row::Full),
        _ => values.try_into().ok().map(Row::Classic),
    }
}
