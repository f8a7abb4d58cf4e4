//! C81 tables: fixed fields of seven columns.
//!
//! Columns 1-30 of the first line are the title, then six counts of two digits: Mach numbers and
//! angles of lift, drag and moment. Each of the three blocks has its own grid: a record of the
//! Mach numbers (seven blanks, then fields of seven columns, nine per line), then a record per
//! angle. Fields touch, so lines are never split at blanks.

use super::super::data::Curve;
use super::grid::{Grid, Row, Unit};
use super::notes::Notes;
use super::reading::{Options, ReadAirfoil};

mod write;

pub(super) use write::write;

/// Columns of the title.
const TITLE: usize = 30;
/// Columns of a field.
const WIDTH: usize = 7;
/// Values per line.
const PER_LINE: usize = 9;

/// Whether `text` begins with the title and counts of a table.
pub(super) fn recognize(text: &str) -> bool {
    let mut lines = text.lines().filter(|line| !line.trim().is_empty());
    let (Some(head), Some(second)) = (lines.next(), lines.next()) else {
        return false;
    };
    let begins_blank = second.len() > WIDTH && second.chars().take(WIDTH).all(|c| c == ' ');
    counts(head).is_some_and(|counts| counts[0] > 0 && counts[1] > 0) && begins_blank
}

/// The six counts of a first line.
fn counts(head: &str) -> Option<[usize; 6]> {
    let letters: Vec<char> = head.chars().skip(TITLE).take(13).collect();
    // A digit after the counts: one of them had three.
    if letters.get(12).is_some_and(char::is_ascii_digit) {
        return None;
    }
    let mut counts = [0; 6];
    for (i, count) in counts.iter_mut().enumerate() {
        let pair: String = letters.iter().skip(2 * i).take(2).collect();
        *count = match pair.trim() {
            "" if i >= 4 => 0,
            digits => digits.parse().ok()?,
        };
    }
    Some(counts)
}

/// The lines of a file, taken one by one.
struct Cards<'t> {
    lines: Vec<&'t str>,
    next: usize,
}

impl<'t> Cards<'t> {
    /// The next line and its number from one.
    fn take(&mut self) -> Option<(usize, &'t str)> {
        let line = self.lines.get(self.next)?;
        self.next += 1;
        Some((self.next, line))
    }

    /// The next line that is not blank.
    fn take_filled(&mut self) -> Option<(usize, &'t str)> {
        loop {
            let (number, line) = self.take()?;
            if !line.trim().is_empty() {
                return Some((number, line));
            }
        }
    }
}

/// Reads all tables of a file.
pub(super) fn read(text: &str, _: &Options, notes: &mut Notes) -> Option<Vec<ReadAirfoil>> {
    let mut cards = Cards {
        lines: text.lines().collect(),
        next: 0,
    };
    let mut airfoils = Vec::new();
    while let Some((number, head)) = cards.take_filled() {
        airfoils.push(table(number, head, &mut cards, notes)?);
    }
    Some(airfoils)
}

/// Reads the table with the first line `head`.
fn table(
    number: usize,
    head: &str,
    cards: &mut Cards<'_>,
    notes: &mut Notes,
) -> Option<ReadAirfoil> {
    let Some(counts) = counts(head) else {
        let found: String = head.chars().skip(TITLE).collect();
        let found = format!("\"{}\"", found.trim_end());
        let expected = "six counts of two digits in columns 31 to 42";
        let help = "a block has at most 99 Mach numbers and 99 angles; tabs count as one column";
        notes.wrong(
            number,
            ["first line of a C81 table", &found, expected, help],
        );
        return None;
    };
    let title: String = head.chars().take(TITLE).collect();
    let mut airfoil = ReadAirfoil::default();
    airfoil.data.name = title.trim().to_owned();
    airfoil.data.lift = block("lift", [counts[0], counts[1]], cards, notes)?;
    airfoil.data.drag = block("drag", [counts[2], counts[3]], cards, notes)?;
    airfoil.data.moment = block("moment", [counts[4], counts[5]], cards, notes)?;
    Some(airfoil)
}

/// Reads a block; absent if the file ends in it.
fn block(
    what: &str,
    [machs, angles]: [usize; 2],
    cards: &mut Cards<'_>,
    notes: &mut Notes,
) -> Option<Vec<Curve>> {
    if machs == 0 && angles == 0 {
        return Some(Vec::new());
    }
    let start = cards.next + 1;
    if machs == 0 || angles == 0 {
        let found = format!("{machs} Mach numbers and {angles} angles");
        let help = "correct the counts of the first line";
        notes.wrong(start, [what, &found, "at least one of both, or none", help]);
        return None;
    }
    let (_, first, mach) = record(machs, &format!("Mach numbers of {what}"), cards, notes)?;
    if !first.trim().is_empty() {
        let found = format!("\"{first}\"");
        let help = "the count of angles of the block before may be wrong";
        notes.wrong(
            start,
            [what, &found, "seven blanks before the Mach numbers", help],
        );
    }
    check_mach(start, what, &mach, notes);
    let rows = rows(what, machs, angles, cards, notes)?;
    let grid = Grid::of(&rows, Unit::Degrees, (what, start), notes)?;
    // A single column at Mach zero does not depend on the Mach number.
    let at = |mach: f64| (machs > 1 || mach > 0.0).then_some(mach);
    let curves = mach.iter().enumerate();
    curves
        .map(|(i, &mach)| grid.curve(i, [at(mach), None, None]))
        .collect()
}

fn check_mach(line: usize, what: &str, mach: &[f64], notes: &mut Notes) {
    let is_ascending = mach.windows(2).all(|two| two[0] < two[1]);
    if !is_ascending || mach.first().is_some_and(|&first| first < 0.0) {
        let found = format!("{mach:?}");
        let help = "put the columns in the order of the Mach number";
        notes.wrong(
            line,
            [
                &format!("Mach numbers of {what}"),
                &found,
                "ascending numbers from 0",
                help,
            ],
        );
    }
}

/// Reads the records of the angles.
fn rows(
    what: &str,
    machs: usize,
    angles: usize,
    cards: &mut Cards<'_>,
    notes: &mut Notes,
) -> Option<Vec<Row>> {
    let mut rows = Vec::with_capacity(angles);
    for i in 1..=angles {
        let name = format!("{what}, angle {i} of {angles}");
        let (line, first, values) = record(machs, &name, cards, notes)?;
        let alpha = notes.number(line, &name, first.trim());
        if let Some(alpha) = alpha.filter(|_| values.len() == machs) {
            rows.push(Row {
                line,
                alpha,
                values,
            });
        }
    }
    Some(rows)
}

/// Reads a first field and `count` values, on as many lines as they need; absent if the file
/// ends there.
fn record(
    count: usize,
    what: &str,
    cards: &mut Cards<'_>,
    notes: &mut Notes,
) -> Option<(usize, String, Vec<f64>)> {
    let mut first = String::new();
    let mut start = 0;
    let mut values = Vec::with_capacity(count);
    for done in (0..count).step_by(PER_LINE) {
        let Some((line, text)) = cards.take() else {
            notes.cut(cards.next, what, "a line of numbers");
            return None;
        };
        let here = PER_LINE.min(count - done);
        let letters: Vec<char> = text.trim_end().chars().collect();
        let head: String = letters.iter().take(WIDTH).collect();
        if done == 0 {
            (start, first) = (line, head);
        } else if !head.trim().is_empty() {
            let help = "a line has nine values; the next ones follow after seven blanks";
            notes.wrong(
                line,
                [
                    what,
                    &format!("\"{head}\""),
                    "seven blanks before further values",
                    help,
                ],
            );
        }
        values.extend(fields(line, &letters, here, what, notes));
    }
    Some((start, first, values))
}

/// The values of one line; notes those that are missing or no numbers.
fn fields(line: usize, letters: &[char], count: usize, what: &str, notes: &mut Notes) -> Vec<f64> {
    let mut values = Vec::with_capacity(count);
    let end = WIDTH * (count + 1);
    for field in 1..=count {
        let word: String = letters.iter().skip(WIDTH * field).take(WIDTH).collect();
        match word.trim() {
            "" if letters.len() <= WIDTH * field => {
                notes.cut(line, what, &format!("{count} values on the line"));
                break;
            }
            "" => {
                notes.remark(line, &format!("{what}: a blank field is read as 0"));
                values.push(0.0);
            }
            word => values.extend(notes.number(line, what, word)),
        }
    }
    let rest: String = letters.iter().skip(end).collect();
    if !rest.trim().is_empty() {
        let help = "the counts of the first line may be wrong, or the fields are not of 7 columns";
        notes.wrong(
            line,
            [
                what,
                &format!("\"{}\"", rest.trim()),
                "the end of the line",
                help,
            ],
        );
    }
    values
}
