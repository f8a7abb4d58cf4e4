//! Measured frequencies: a CSV file with the columns `speed_rpm,frequency_hz,order`.

use shared_geom::document::schema::ValueKind::{Text, Words};
use shared_geom::keys;
use std::collections::BTreeMap;

use shared_geom::document::{ByHand, DocumentProblem, Table, read_text};
use shared_geom::error::Diagnostics;

use super::csv_rows;
use super::problem::InputProblem;
use super::rotor_speed::RPM;
use crate::case::Words as ModeWords;
use crate::result::{Measured, MeasuredPoint, ModeKind};

/// Kinds of modes that `leave_out` may name.
const KINDS: [&str; ModeKind::PURE.len()] = {
    let mut words = [""; ModeKind::PURE.len()];
    let mut i = 0;
    while i < words.len() {
        words[i] = ModeKind::PURE[i].word();
        i += 1;
    }
    words
};

keys! {
    /// Measured frequencies, drawn in the fan plot and compared with the modes.
    pub(super) CARD = "[measured]";
    /// A CSV file of measured frequencies with the header speed_rpm,frequency_hz,order; a relative
    /// path is relative to the folder of this file.
    FILE: String = "file", [Text], required, "\"experiment.csv\"";
    /// Kinds of modes that were not measured: they do not count in `order`.
    LEAVE_OUT: ByHand = "leave_out", [Words(&KINDS)], or "none", "[\"lag\"]";
}

const HEADING: [&str; 3] = ["speed_rpm", "frequency_hz", "order"];

/// Reads `[measured]` and the file that it names; empty if absent.
pub(super) fn read(root: &Table<'_>) -> Option<Measured> {
    if !root.has("measured") {
        return Some(Measured::default());
    }
    let table = root.table("measured")?;
    let points = points(&table);
    let leave_out = kinds(&table);
    table.finish();
    Some(Measured {
        points: points?,
        leave_out: leave_out?,
    })
}

fn kinds(table: &Table<'_>) -> Option<Vec<ModeKind>> {
    const KEY: &str = "leave_out";
    if !table.has(KEY) {
        return Some(Vec::new());
    }
    let kind = |found: String| {
        let is_it = |kind: &ModeKind| ModeWords::ALL.iter().any(|w| kind.word_in(*w) == found);
        let kind = ModeKind::PURE.into_iter().find(is_it);
        if kind.is_none() {
            let known = ModeKind::PURE.map(|kind| kind.word().to_owned()).to_vec();
            let key = KEY.to_owned();
            let meant = None;
            let problem = DocumentProblem::WrongWord {
                key,
                found,
                known,
                meant,
            };
            table.note(KEY, &problem);
        }
        kind
    };
    // All names are checked, so that each problem is noted.
    let kinds: Vec<_> = table.texts(KEY)?.into_iter().map(kind).collect();
    kinds.into_iter().collect()
}

fn points(table: &Table<'_>) -> Option<Vec<MeasuredPoint>> {
    let written = table.get(&FILE)?;
    let path = table.path("file", &written);
    let file = path.display().to_string();
    if !path.is_file() {
        let reason = if path.exists() {
            "not a file"
        } else {
            "no such file"
        };
        let reason = reason.to_owned();
        table.note("file", &InputProblem::NoMeasurements { file, reason });
        return None;
    }
    let text = table.document().keep(read_text(&path))?;
    table.document().keep(parse(&text, &file))
}

/// The rows of `text`, shown as `file` in messages.
fn parse(text: &str, file: &str) -> Result<Vec<MeasuredPoint>, Diagnostics> {
    let mut rows = csv_rows::records(text);
    let mut problems = Vec::new();
    heading(rows.next(), &mut problems);
    let (mut points, mut lines) = (Vec::new(), BTreeMap::new());
    for (line, row) in rows {
        match point(&row) {
            Ok(point) => {
                let key = point.order.map(|order| (point.speed.to_bits(), order));
                let first = key.and_then(|key| lines.insert(key, line));
                if let (Some(line_of_first), Some(order)) = (first, point.order) {
                    problems.push((
                        line,
                        InputProblem::RowTwice {
                            order,
                            line: line_of_first,
                        },
                    ));
                }
                points.push(point);
            }
            Err(problem) => problems.push((line, problem)),
        }
    }
    if points.is_empty() && problems.is_empty() {
        problems.push((1, InputProblem::NoRows));
    }
    let more = |count| InputProblem::MoreRows { count };
    csv_rows::problems(file, &problems, more).into_result(points)
}

fn heading(row: Option<(usize, csv::StringRecord)>, problems: &mut Vec<(usize, InputProblem)>) {
    let (line, found) = match row {
        Some((_, row)) if row.iter().eq(HEADING) => return,
        Some((line, row)) => (line, format!("\"{}\"", joined(&row))),
        None => (1, "missing".to_owned()),
    };
    problems.push((line, InputProblem::Heading { found }));
}

fn joined(row: &csv::StringRecord) -> String {
    row.iter().collect::<Vec<_>>().join(",")
}

fn point(row: &csv::StringRecord) -> Result<MeasuredPoint, InputProblem> {
    let wrong = |expected| InputProblem::Row {
        found: joined(row),
        expected,
    };
    let fields: Vec<_> = row.iter().collect();
    let (speed, frequency, order) = match fields[..] {
        [speed, frequency, order] => (speed, frequency, order),
        _ => return Err(wrong("three columns: speed, frequency and order")),
    };
    let number = |text: &str| text.parse::<f64>().ok().filter(|number| number.is_finite());
    let speed = number(speed)
        .filter(|speed| *speed >= 0.0)
        .ok_or_else(|| wrong("a speed in rpm of zero or more in the first column"))?;
    let frequency = number(frequency)
        .filter(|frequency| *frequency > 0.0)
        .ok_or_else(|| wrong("a frequency in Hz of more than zero in the second column"))?;
    let order = match order {
        "" => None,
        text => Some(
            text.parse()
                .ok()
                .filter(|order| *order > 0)
                .ok_or_else(|| {
                    wrong("a whole number of at least 1, or an empty cell, in the third column")
                })?,
        ),
    };
    Ok(MeasuredPoint {
        speed: speed * RPM,
        frequency,
        order,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_with_and_without_order_are_read() {
        let text = "# Epps and Chandra\nspeed_rpm, frequency_hz, order\n0,1.4,1\n\n750,36.1,\n";
        let points = parse(text, "a.csv").unwrap();
        assert_eq!(points.len(), 2);
        assert_eq!(
            (points[0].speed, points[0].frequency, points[0].order),
            (0.0, 1.4, Some(1))
        );
        assert_eq!((points[1].speed, points[1].order), (750.0 * RPM, None));
    }

    // The empty line and the remark before the last row are counted as lines.
    #[test]
    fn every_wrong_row_is_reported_with_its_line() {
        let text = "speed_rpm,frequency_hz,order\n0,1.4\n-1,2,1\n0,0,1\n0,x,1\n0,1,0\n0,1,2\n\n# a remark\n0,3,2\n";
        let shown = parse(text, "a.csv").unwrap_err().to_string();
        let expected = "\
error: a.csv:2: row \"0,1.4\" cannot be read, expected three columns: speed, frequency and order
error: a.csv:3: row \"-1,2,1\" cannot be read, expected a speed in rpm of zero or more in the first column
error: a.csv:4: row \"0,0,1\" cannot be read, expected a frequency in Hz of more than zero in the second column
error: a.csv:5: row \"0,x,1\" cannot be read, expected a frequency in Hz of more than zero in the second column
error: a.csv:6: row \"0,1,0\" cannot be read, expected a whole number of at least 1, or an empty cell, in the third column
error: a.csv:10: order 2 at this speed is already measured on line 7, expected one row";
        assert_eq!(shown, expected);
    }

    #[test]
    fn heading_and_content_are_required() {
        let shown = |text: &str| parse(text, "a.csv").unwrap_err().to_string();
        assert!(shown("").contains("a.csv:1: the columns are missing, expected \"speed_rpm,"));
        assert!(shown("rpm,hz\n").contains("a.csv:1: the columns are \"rpm,hz\""));
        let many = format!("speed_rpm,frequency_hz,order\n{}", "x\n".repeat(30));
        assert_eq!(shown(&many).lines().count(), 11);
        assert!(shown(&many).ends_with("a.csv:12: 20 more rows have problems"));
        let empty = shown("speed_rpm,frequency_hz,order\n");
        assert!(
            empty.contains("expected at least one measured frequency"),
            "{empty}"
        );
    }
}
