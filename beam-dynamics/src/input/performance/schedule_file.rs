//! Files of operating points: columns with titles, or HAWC2's operating points (`.opt`).
//!
//! Titles are compared without case, blanks and units, and each column has several usual titles. Columns
//! are between commas, semicolons, tabs or blanks.

use std::f64::consts::PI;
use std::path::Path;

use shared_geom::units::{self, Dimension};

use super::problem::PerformanceProblem;
use crate::case::OperatingSetting;

/// A column that is read.
struct Column {
    /// Its title in messages.
    name: &'static str,
    /// All titles, as [`simplified`] has them.
    titles: &'static [&'static str],
    /// Titles that count only with a unit, since they are used for other quantities or units too.
    with_unit: &'static [&'static str],
    dimension: Dimension,
    /// Number of SI units in its unit if the title has none.
    usual: f64,
}

/// Speed, rotor speed and pitch.
const COLUMNS: [Column; 3] = [
    Column {
        name: "speed",
        titles: &[
            "speed",
            "wind",
            "windspeed",
            "wind_speed",
            "v",
            "u",
            "v_hub",
            "u_hub",
            "v_wind",
            "vwind",
            "wsp",
            "wspd",
            "ws",
            "wind_velocity",
            "velocity",
            "airspeed",
            "flight_speed",
            "wind1velx",
        ],
        with_unit: &[],
        dimension: Dimension::VELOCITY,
        usual: 1.0,
    },
    Column {
        name: "rotor_speed",
        titles: &[
            "rotor_speed",
            "rotorspeed",
            "rpm",
            "rotor_rpm",
            "rot_speed",
            "rotspeed",
            "rotational_speed",
            "rotation_speed",
            "speed_of_rotation",
        ],
        with_unit: &["omega", "speed", "rotor", "rotation"],
        dimension: Dimension::ROTATION_SPEED,
        usual: PI / 30.0,
    },
    Column {
        name: "pitch",
        titles: &[
            "pitch",
            "pitch_angle",
            "blade_pitch",
            "blade_pitch_angle",
            "bldpitch1",
            "blpitch1",
            "collective",
            "collective_pitch",
        ],
        with_unit: &["theta"],
        dimension: Dimension::ANGLE,
        usual: PI / 180.0,
    },
];

/// Index of a column of the file, and the number of SI units in its unit.
type Found = Option<(usize, f64)>;

/// Problems with their lines.
type Problems = Vec<(usize, PerformanceProblem)>;

/// A line that counts, with its number.
type Line<'a> = (usize, &'a str);

/// The points of a file; problems with their lines.
pub(super) fn parsed(path: &Path, text: &str, problems: &mut Problems) -> Vec<OperatingSetting> {
    let lines = (1..).zip(text.lines());
    let lines: Vec<Line<'_>> = lines.filter(|line| !line.1.trim().is_empty()).collect();
    let is_comment = |line: &Line<'_>| line.1.trim_start().starts_with(['#', '%', '!']);
    let rows: Vec<Line<'_>> = lines
        .iter()
        .copied()
        .filter(|line| !is_comment(line))
        .collect();
    let Some(first) = rows.first().copied() else {
        problems.push((1, PerformanceProblem::Empty { key: "file" }));
        return Vec::new();
    };
    let ending = path.extension().and_then(|ending| ending.to_str());
    let (columns, rows) = if ending.is_some_and(|ending| ending.eq_ignore_ascii_case("opt")) {
        // Wind, pitch and rotor speed: the order of HAWC2.
        let [speed, omega, pitch] = COLUMNS.each_ref().map(|column| column.usual);
        let columns = [Some((0, speed)), Some((2, omega)), Some((1, pitch))];
        (columns, without_count(&rows, problems))
    } else if are_numbers(first.1) {
        // The titles may be a comment.
        let mut before = lines.iter().copied().filter(|line| line.0 < first.0);
        let titles = before
            .next_back()
            .map(|(line, text)| (line, text.trim_start().trim_start_matches(['#', '%', '!'])));
        let mut ignored = Vec::new();
        let columns = titles.map(|titles| columns(titles, Some(first), &mut ignored));
        match columns.filter(|_| ignored.is_empty()) {
            Some(columns) => (columns, &rows[..]),
            None => {
                let found = first.1.trim().to_owned();
                problems.push((first.0, PerformanceProblem::NoTitles { found }));
                return Vec::new();
            }
        }
    } else {
        (columns(first, rows.get(1).copied(), problems), &rows[1..])
    };
    if !problems.is_empty() {
        return Vec::new();
    }
    let points: Vec<_> = rows
        .iter()
        .map(|row| point(*row, &columns, problems))
        .collect();
    if points.is_empty() {
        problems.push((first.0, PerformanceProblem::Empty { key: "file" }));
    }
    points
}

/// The rows of HAWC2's file, without the first line if it has the number of rows; notes another number.
fn without_count<'a, 'b>(rows: &'a [Line<'b>], problems: &mut Problems) -> &'a [Line<'b>] {
    let Some((line, text)) = rows.first() else {
        return rows;
    };
    let mut words = text.split_whitespace();
    let count = words.next().and_then(|word| word.parse::<usize>().ok());
    let is_row = are_numbers(text) && cells(text).len() > 2;
    match count {
        Some(announced) if !is_row => {
            let found = rows.len() - 1;
            if announced != found {
                problems.push((*line, PerformanceProblem::Announced { announced, found }));
            }
            &rows[1..]
        }
        _ => rows,
    }
}

/// Whether all cells of a line are numbers.
fn are_numbers(line: &str) -> bool {
    cells(line).iter().all(|cell| cell.parse::<f64>().is_ok())
}

/// The cells of a line of numbers.
fn cells(line: &str) -> Vec<&str> {
    let trimmed = |cell: &'_ str| -> bool { !cell.is_empty() };
    match line.find([',', ';']).map(|at| line.as_bytes()[at]) {
        Some(separator) => line.split(char::from(separator)).map(str::trim).collect(),
        None => line
            .split_whitespace()
            .filter(|cell| trimmed(cell))
            .collect(),
    }
}

/// The titles of a line, of which there are `count` if that is known.
fn titles(line: &str, count: Option<usize>) -> Vec<String> {
    let clean = |title: &str| title.trim().trim_matches('"').trim().to_owned();
    if line.contains([',', ';', '\t']) {
        return line.split([',', ';', '\t']).map(clean).collect();
    }
    // Titles may contain single blanks.
    let apart: Vec<_> = line
        .split("  ")
        .map(clean)
        .filter(|title| !title.is_empty())
        .collect();
    if count == Some(apart.len()) {
        return apart;
    }
    let mut found: Vec<String> = Vec::new();
    for word in line.split_whitespace() {
        match found.last_mut() {
            Some(last) if word.starts_with(['[', '(']) => *last = format!("{last} {word}"),
            _ => found.push(word.to_owned()),
        }
    }
    found
}

/// The columns by their titles; `row` is a line of numbers, if there is one.
fn columns((line, text): Line<'_>, row: Option<Line<'_>>, problems: &mut Problems) -> [Found; 3] {
    let titles = titles(text, row.map(|row| cells(row.1).len()));
    let mut found = [None; 3];
    for (index, column) in COLUMNS.iter().enumerate() {
        let own = titles.iter().enumerate();
        let own: Vec<_> = own.filter(|(_, title)| column.is_titled(title)).collect();
        match own[..] {
            [(at, title)] => match column.factor(title) {
                Ok(factor) => found[index] = Some((at, factor)),
                Err(problem) => problems.push((line, problem)),
            },
            [] if column.name == "pitch" => {}
            [] => problems.push((
                line,
                PerformanceProblem::NoColumn {
                    column: column.name,
                    found: titles.join(", "),
                    known: column.titles,
                },
            )),
            [(_, first), (_, second), ..] => problems.push((
                line,
                PerformanceProblem::Doubled {
                    column: column.name,
                    titles: [first.clone(), second.clone()],
                },
            )),
        }
    }
    found
}

/// A title without its unit, in lower case, with single underscores between words; and the unit.
fn simplified(title: &str) -> (String, Option<&str>) {
    let (name, unit) = match title.split_once(['[', '(']) {
        Some((name, unit)) => (
            name,
            Some(unit.trim_end().trim_end_matches([']', ')']).trim()),
        ),
        None => (title, None),
    };
    let words = name.split(|letter: char| !letter.is_ascii_alphanumeric());
    let words: Vec<_> = words
        .filter(|word| !word.is_empty())
        .map(str::to_lowercase)
        .collect();
    // Units at the end of a name.
    let ending = match words.last().map(String::as_str) {
        Some("mps") => Some("m/s"),
        Some("rpm") => Some("rpm"),
        Some("deg") => Some("deg"),
        Some("rad") => Some("rad"),
        _ => None,
    };
    match (unit, ending) {
        (None, Some(ending)) if words.len() > 1 => {
            (words[..words.len() - 1].join("_"), Some(ending))
        }
        _ => (words.join("_"), unit),
    }
}

impl Column {
    /// Whether a title is one of this column.
    fn is_titled(&self, title: &str) -> bool {
        let (name, unit) = simplified(title);
        let known = unit.and_then(|unit| units::parse(unit).ok());
        let is_of = known.as_ref().map(|unit| unit.dimension == self.dimension);
        let has = |list: &[&str]| list.contains(&name.as_str());
        // A speed in rpm is not the one of the wind.
        let is_other = is_of == Some(false)
            && COLUMNS.iter().any(|other| {
                other.with_unit.contains(&name.as_str())
                    && known
                        .as_ref()
                        .is_some_and(|unit| unit.dimension == other.dimension)
            });
        has(self.titles) && !is_other || has(self.with_unit) && is_of == Some(true)
    }

    /// Number of SI units in the unit of a title.
    fn factor(&self, title: &str) -> Result<f64, PerformanceProblem> {
        let Some(unit) = simplified(title).1 else {
            return Ok(self.usual);
        };
        match units::parse(unit) {
            Ok(known) if known.dimension == self.dimension => Ok(known.factor),
            _ => Err(PerformanceProblem::Cell {
                column: title.to_owned(),
                found: unit.to_owned(),
                expected: "a unit of this quantity",
            }),
        }
    }
}

/// The point of a row; notes cells that are not numbers.
fn point(
    (line, text): Line<'_>,
    columns: &[Found; 3],
    problems: &mut Problems,
) -> OperatingSetting {
    let cells = cells(text);
    let mut value = |index: usize| -> f64 {
        let Some((at, factor)) = columns[index] else {
            return 0.0;
        };
        let cell = cells.get(at).copied().unwrap_or_default();
        let number = cell.parse::<f64>().ok().filter(|number| number.is_finite());
        if number.is_none() {
            let (column, found) = (COLUMNS[index].name.to_owned(), cell.to_owned());
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
    OperatingSetting {
        speed: value(0),
        omega: value(1),
        pitch: value(2),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Speed [m/s], rotor speed [rpm] and pitch [deg] of each point, or the messages.
    fn read(name: &str, text: &str) -> Result<Vec<[f64; 3]>, Vec<String>> {
        let mut problems = Vec::new();
        let points = parsed(Path::new(name), text, &mut problems);
        let shown = problems.iter().map(|(line, it)| format!("{line}: {it}"));
        let shown: Vec<_> = shown.collect();
        let point = |of: &OperatingSetting| {
            let rounded = |value: f64| (1e9 * value).round() / 1e9;
            [of.speed, of.omega * 30.0 / PI, of.pitch.to_degrees()].map(rounded)
        };
        if shown.is_empty() {
            Ok(points.iter().map(point).collect())
        } else {
            Err(shown)
        }
    }

    /// The same two points in files as people have them.
    #[test]
    fn titles_units_and_separators_are_the_usual_ones() {
        let expected = Ok(vec![[8.0, 5.5, 0.0], [15.0, 7.5, 9.2]]);
        for text in [
            "speed [m/s],rotor_speed [rpm],pitch [deg]\n8,5.5,0\n15,7.5,9.2\n",
            "wind [m/s],pitch [deg],speed [rpm],power [kW]\n8,0,5.5,1\n15,9.2,7.5,x\n",
            "# source\nWind Speed (m/s); Rotor speed (rpm); Pitch\n8;5.5;0\n15;7.5;9.2\n",
            "V_mps,pitch_deg,rpm\n8,0,5.5\n15,9.2,7.5\n",
            "\"Wind [m/s]\",\"Rotor Speed [rpm]\",\"Blade pitch [deg]\"\n8,5.5,0\n15,7.5,9.2\n",
            "wind_speed  rotor speed [rpm]  pitch [deg]\n 8 5.5 0\n 15 7.5 9.2\n",
            "wind\trpm\tpitch\n8\t5.5\t0\n15\t7.5\t9.2\n",
            "Wind [km/h] RotSpeed [deg/s] BldPitch1 [deg]\n28.8 33 0\n54 45 9.2\n",
            "# wind [m/s], rotor speed [rpm], pitch [deg]\n8,5.5,0\n15,7.5,9.2\n",
        ] {
            assert_eq!(read("a.csv", text), expected, "{text}");
        }
        let omega = "U [m/s],omega [rad/s]\n8,1\n";
        assert_eq!(read("a.csv", omega), Ok(vec![[8.0, 9.549296586, 0.0]]));
    }

    /// HAWC2's file: wind, pitch, rotor speed, with or without the line that has the number of rows.
    #[test]
    fn operating_points_of_hawc2() {
        let rows = " 8.0e0 0.1 5.5 1e3 2e2\n15 9.2 7.5 2e3 3e2\n";
        let expected = Ok(vec![[8.0, 5.5, 0.1], [15.0, 7.5, 9.2]]);
        let title = "2 wind speed [m/s] pitch [deg] rot. speed [rpm]\n";
        for text in [
            rows.to_owned(),
            format!("{title}{rows}"),
            format!(" 2\n{rows}"),
        ] {
            assert_eq!(read("turbine.OPT", &text), expected, "{text}");
        }
        let found = read("a.opt", &format!("3{}{rows}", &title[1..])).unwrap_err();
        assert_eq!(found, ["1: the first line announces 3 rows, found 2"]);
    }

    #[test]
    fn problems_have_their_lines() {
        for (text, expected) in [
            (
                "speed,rotor_speed\n1,a\n,2\n",
                &[
                    "2: column \"rotor_speed\": \"a\" is not a number",
                    "3: column \"speed\": \"\" is not a number",
                ][..],
            ),
            (
                "speed [kg],rotr\n1,2\n",
                &[
                    "1: column \"speed [kg]\": \"kg\" is not a unit of this quantity",
                    "1: the schedule has no column \"rotor_speed\", found speed [kg], rotr",
                ],
            ),
            // Radians per second or revolutions per minute.
            (
                "wind,omega\n1,2\n",
                &["1: the schedule has no column \"rotor_speed\", found wind, omega"],
            ),
            (
                "wind,v,rpm\n1,2,3\n",
                &["1: the columns \"wind\" and \"v\" are both \"speed\""],
            ),
            (
                "8,5.5,0\n",
                &["1: the first line has no titles, found 8,5.5,0"],
            ),
        ] {
            assert_eq!(read("a.csv", text).unwrap_err(), expected, "{text}");
        }
    }
}
