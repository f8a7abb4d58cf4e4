//! Operating points one by one: `[[schedule]]`.

use std::f64::consts::PI;

use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Quantities, Text};
use shared_geom::keys;
use shared_geom::units::{self, Dimension};

use super::problem::PerformanceProblem;
use super::sweeps::{LOADS_AT, NAME};
use crate::case::{Abscissa, OperatingSetting, PerformancePart, PerformanceRequest};
use crate::input::csv_rows;

keys! {
    /// Operating points one by one: lists of equal lengths, or a file of columns.
    pub(super) CARD = "[[schedule]]";
    /// A table of comma-separated values with the titles `speed [m/s]`, `rotor_speed [rpm]` and
    /// perhaps `pitch [deg]`, in any units; other columns are ignored.
    FILE: Option<String> = "file", [Text], optional, "\"schedule.csv\"";
    /// Speeds of the wind or of flight.
    SPEED: Option<Vec<f64>> = "speed", [Quantities(Dimension::VELOCITY)], optional, "[8, 10, 12]";
    /// Speeds of rotation; one for all points, or one for each.
    ROTOR_SPEED: Option<Vec<f64>> = "rotor_speed", [Quantities(Dimension::ROTATION_SPEED)],
        optional, "[9.2, 11.4, 12.1]";
    /// Pitch; one for all points, or one for each.
    PITCH: Option<Vec<f64>> = "pitch", [Quantities(Dimension::ANGLE)], or "0", "[0, 0, 3.8]";
    with NAME.schema, LOADS_AT.schema;
}

/// Reads a schedule; `usual` is its name if it has none.
pub(super) fn read(table: &Table<'_>, usual: String) -> Option<PerformancePart> {
    let (name, loads_at) = (table.get(&NAME), table.get(&LOADS_AT));
    let file = table.get(&FILE);
    let lists = [&SPEED, &ROTOR_SPEED, &PITCH].map(|key| table.get(key));
    table.finish();
    let settings = match file? {
        Some(file) => {
            let keys = [&SPEED, &ROTOR_SPEED, &PITCH].map(|key| key.name());
            if let Some(key) = keys.into_iter().find(|key| table.has(key)) {
                table.wrong(key, "no such key next to \"file\", which has the points");
                return None;
            }
            from_file(table, &file)?
        }
        None => {
            let [speed, omega, pitch] = lists;
            listed(table, [speed?, omega?, pitch?])?
        }
    };
    let varies = |of: Abscissa| {
        let first = settings.first().map(|it| of.of(it, 1.0));
        settings.iter().any(|it| Some(of.of(it, 1.0)) != first)
    };
    let axes = [Abscissa::Speed, Abscissa::RotorSpeed, Abscissa::Pitch];
    let abscissa = axes.into_iter().find(|axis| varies(*axis));
    Some(PerformancePart {
        name: name?.unwrap_or(usual),
        request: PerformanceRequest::Settings(settings),
        abscissa: abscissa.unwrap_or(Abscissa::Speed),
        curves: vec![String::new()],
        is_map: false,
        loads_at: loads_at?,
    })
}

/// The points of three lists.
fn listed(table: &Table<'_>, lists: [Option<Vec<f64>>; 3]) -> Option<Vec<OperatingSetting>> {
    let keys = [SPEED.name(), ROTOR_SPEED.name(), PITCH.name()];
    let mut sound = true;
    for (key, list) in keys.iter().zip(&lists).take(2) {
        if list.is_none() {
            table.note(
                "",
                &PerformanceProblem::NoColumn {
                    column: key,
                    found: "no such key, and no \"file\"".to_owned(),
                },
            );
            sound = false;
        }
    }
    let lists = lists.map(|list| list.unwrap_or_else(|| vec![0.0]));
    let longest = (0..3)
        .max_by_key(|index| (lists[*index].len(), 3 - index))
        .unwrap_or(0);
    let expected = lists[longest].len();
    for (key, list) in keys.iter().zip(&lists) {
        if list.is_empty() {
            table.note(key, &PerformanceProblem::Empty { key });
            sound = false;
        } else if list.len() != 1 && list.len() != expected {
            let (found, longest) = (list.len(), keys[longest]);
            table.note(
                key,
                &PerformanceProblem::Lengths {
                    key,
                    found,
                    expected,
                    longest,
                },
            );
            sound = false;
        }
    }
    let value = |list: usize, index: usize| {
        let list = &lists[list];
        list.get(index).or(list.first()).copied().unwrap_or(0.0)
    };
    let setting = |index: usize| OperatingSetting {
        speed: value(0, index),
        omega: value(1, index),
        pitch: value(2, index),
    };
    sound.then(|| (0..expected).map(setting).collect())
}

/// A column that is read: its title, dimension, and whether it is required.
const COLUMNS: [(&str, Dimension, bool); 3] = [
    ("speed", Dimension::VELOCITY, true),
    ("rotor_speed", Dimension::ROTATION_SPEED, true),
    ("pitch", Dimension::ANGLE, false),
];

/// The points of a file.
fn from_file(table: &Table<'_>, file: &str) -> Option<Vec<OperatingSetting>> {
    let path = table.existing(FILE.name(), file)?;
    let text = shared_geom::document::read_text(&path);
    let text = table.keep_file(FILE.name(), text)?;
    let shown = path.display().to_string();
    let mut problems = Vec::new();
    let rows = parsed(&text, &mut problems);
    if !problems.is_empty() {
        let more = |count| PerformanceProblem::More { count };
        let found = csv_rows::problems(&shown, &problems, more);
        return table.keep_file(FILE.name(), Err(found));
    }
    Some(rows)
}

/// The points of a text; problems with their lines.
fn parsed(text: &str, problems: &mut Vec<(usize, PerformanceProblem)>) -> Vec<OperatingSetting> {
    let mut records = csv_rows::records(text);
    let Some((line, titles)) = records.next() else {
        problems.push((1, PerformanceProblem::Empty { key: "file" }));
        return Vec::new();
    };
    let columns = COLUMNS.map(|column| found(&titles, column, (line, problems)));
    if !problems.is_empty() {
        return Vec::new();
    }
    let mut rows = Vec::new();
    for (line, record) in records {
        let mut value = |column: usize| -> f64 {
            let Some((index, factor)) = columns[column] else {
                return 0.0;
            };
            let cell = record.get(index).unwrap_or_default();
            let number: Option<f64> = cell.parse().ok().filter(|it: &f64| it.is_finite());
            if number.is_none() {
                let (column, found) = (COLUMNS[column].0.to_owned(), cell.to_owned());
                let expected = "a number";
                problems.push((
                    line,
                    PerformanceProblem::Cell {
                        column,
                        found,
                        expected,
                    },
                ));
            }
            number.unwrap_or(0.0) * factor
        };
        rows.push(OperatingSetting {
            speed: value(0),
            omega: value(1),
            pitch: value(2),
        });
    }
    if rows.is_empty() && problems.is_empty() {
        problems.push((line, PerformanceProblem::Empty { key: "file" }));
    }
    rows
}

/// Index of a column, and the number of SI units in its unit; without a unit in m/s, rpm and
/// degrees.
fn found(
    titles: &csv::StringRecord,
    (name, dimension, required): (&'static str, Dimension, bool),
    (line, problems): (usize, &mut Vec<(usize, PerformanceProblem)>),
) -> Option<(usize, f64)> {
    let named = |title: &str| title.split('[').next().unwrap_or_default().trim() == name;
    let Some(index) = titles.iter().position(named) else {
        if required {
            let found = titles.iter().collect::<Vec<_>>().join(", ");
            problems.push((
                line,
                PerformanceProblem::NoColumn {
                    column: name,
                    found,
                },
            ));
        }
        return None;
    };
    let title = titles.get(index).unwrap_or_default();
    let Some((_, unit)) = title.split_once('[') else {
        let usual = match dimension {
            Dimension::ROTATION_SPEED => PI / 30.0,
            Dimension::ANGLE => PI / 180.0,
            _ => 1.0,
        };
        return Some((index, usual));
    };
    let unit = unit.trim_end().trim_end_matches(']');
    match units::parse(unit) {
        Ok(known) if known.dimension == dimension => Some((index, known.factor)),
        _ => {
            problems.push((
                line,
                PerformanceProblem::Cell {
                    column: title.to_owned(),
                    found: unit.to_owned(),
                    expected: "a unit of this quantity",
                },
            ));
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_found_by_their_titles_in_any_unit() {
        let text = "# source\npitch [rad],x,speed [km/h],rotor_speed\n0.1,z,36,30\n0,z,72,60\n";
        let mut problems = Vec::new();
        let rows = parsed(text, &mut problems);
        assert!(problems.is_empty(), "{problems:?}");
        assert_eq!(rows.len(), 2);
        assert!((rows[0].speed - 10.0).abs() < 1e-12 && (rows[0].pitch - 0.1).abs() < 1e-15);
        assert!((rows[1].omega - 2.0 * PI).abs() < 1e-12);
    }

    #[test]
    fn every_wrong_cell_is_reported_with_its_line() {
        let mut problems = Vec::new();
        parsed("speed,rotor_speed\n1,a\n,2\n", &mut problems);
        let shown: Vec<_> = problems
            .iter()
            .map(|(line, it)| format!("{line}: {it}"))
            .collect();
        assert_eq!(
            shown,
            [
                "2: column \"rotor_speed\": \"a\" is not a number",
                "3: column \"speed\": \"\" is not a number"
            ]
        );
        problems.clear();
        parsed("speed [kg],v\n1,2\n", &mut problems);
        let shown: Vec<_> = problems
            .iter()
            .map(|(line, it)| format!("{line}: {it}"))
            .collect();
        assert_eq!(
            shown,
            [
                "1: column \"speed [kg]\": \"kg\" is not a unit of this quantity",
                "1: the schedule has no column \"rotor_speed\", found speed [kg], v"
            ]
        );
    }
}
