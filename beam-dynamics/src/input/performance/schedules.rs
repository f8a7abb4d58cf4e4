//! Operating points one by one: `[[schedule]]`.

use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Quantities, Text};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::problem::PerformanceProblem;
use super::schedule_file;
use super::sweeps::{LOADS_AT, NAME};
use crate::case::{Abscissa, OperatingSetting, PerformancePart, PerformanceRequest};
use crate::input::csv_rows;

keys! {
    /// Operating points one by one: lists of equal lengths, or a file of columns.
    pub(super) CARD = "[[schedule]]";
    /// A table with titles such as `wind [m/s]`, `rotor speed [rpm]` and perhaps `pitch [deg]`, in any
    /// units, or a file of HAWC2 (`.opt`); other columns are ignored.
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
                    known: &[],
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

/// The points of a file.
fn from_file(table: &Table<'_>, file: &str) -> Option<Vec<OperatingSetting>> {
    let path = table.existing(FILE.name(), file)?;
    let text = shared_geom::document::read_text(&path);
    let text = table.keep_file(FILE.name(), text)?;
    let shown = path.display().to_string();
    let mut problems = Vec::new();
    let rows = schedule_file::parsed(&path, &text, &mut problems);
    if !problems.is_empty() {
        let more = |count| PerformanceProblem::More { count };
        let found = csv_rows::problems(&shown, &problems, more);
        return table.keep_file(FILE.name(), Err(found));
    }
    Some(rows)
}
