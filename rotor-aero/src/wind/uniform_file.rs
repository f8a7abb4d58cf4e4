//! Uniform-wind files of InflowWind: one row of numbers per time.
//!
//! Columns: time s, speed m/s, direction deg, vertical speed m/s, horizontal linear shear,
//! exponent of the power law, vertical linear shear, gust m/s, and optionally upflow deg. Lines
//! that begin with `!`, `#` or `%` are comments. Reference height and length are given with the
//! file, in the input of InflowWind.

use shared_geom::error::Diagnostics;
use shared_geom::exchange::problem::{ExchangeProblem, Problems};
use shared_geom::exchange::text::{Line, lines};

use super::profile::{MeanWind, Shear};
use super::table::WindTable;

const COLUMNS: [&str; 9] = [
    "time",
    "wind speed",
    "wind direction",
    "vertical speed",
    "horizontal linear shear",
    "exponent of the power law",
    "vertical linear shear",
    "gust",
    "upflow",
];

/// Reads the text of a uniform-wind file, shown as `file` in messages.
///
/// `reference_height` \[m\] is the height of the speed, `reference_length` \[m\] the length of the
/// linear shears.
///
/// # Errors
/// All rows with another number of columns, with words or infinite numbers, with a time that
/// does not ascend; a file without rows; a height or length that is not positive.
pub fn read_uniform_wind(
    text: &str,
    file: &str,
    reference_height: f64,
    reference_length: f64,
) -> Result<WindTable, Diagnostics> {
    let mut problems = Problems::new(file);
    for (what, value) in [("height", reference_height), ("length", reference_length)] {
        if !(value > 0.0 && value.is_finite()) {
            let what = format!("reference {what} of the uniform wind");
            problems.push(0, &other(&what, value, "a positive number of meters"));
        }
    }
    let mut rows: Vec<(f64, MeanWind)> = Vec::new();
    for line in lines(text).iter().filter(|line| !is_comment(line)) {
        let Some(values) = numbers(line, &mut problems) else {
            continue;
        };
        let before = rows.last().map(|row| row.0);
        if let Some(before) = before.filter(|before| values[0] <= *before) {
            let expected = format!("a time after the one of the previous row, {before} s");
            problems.push(line.number, &other("time", values[0], &expected));
            continue;
        }
        rows.push((values[0], wind(&values, reference_height, reference_length)));
    }
    if rows.is_empty() && problems.is_empty() {
        let help = "give rows of 8 or 9 numbers".to_owned();
        let what = "the first row of the wind".to_owned();
        problems.push(0, &ExchangeProblem::Missing { what, help });
    }
    let table = WindTable::new(rows).ok();
    problems.finish(table)
}

fn is_comment(line: &Line<'_>) -> bool {
    line.text.starts_with(['!', '#', '%'])
}

/// The eight or nine numbers of a row; a text behind a `!` is a comment.
fn numbers(line: &Line<'_>, problems: &mut Problems) -> Option<[f64; 9]> {
    let content = line.text.split('!').next().unwrap_or_default();
    let separated = |c: char| c.is_whitespace() || c == ',';
    let words: Vec<&str> = content
        .split(separated)
        .filter(|word| !word.is_empty())
        .collect();
    if !(8..=9).contains(&words.len()) {
        let what = "columns of the row".to_owned();
        let problem = ExchangeProblem::Other {
            what,
            found: words.len().to_string(),
            expected: "8 numbers, or 9 with the upflow".to_owned(),
            help: format!("the columns are: {}", COLUMNS.join(", ")),
        };
        problems.push(line.number, &problem);
        return None;
    }
    let mut values = [0.0; 9];
    let mut sound = true;
    for ((value, word), what) in values.iter_mut().zip(&words).zip(COLUMNS) {
        match shared_geom::exchange::text::number(word) {
            Some(number) => *value = number,
            None => {
                let problem = shared_geom::exchange::text::not_a_number(what, word);
                problems.push(line.number, &problem);
                sound = false;
            }
        }
    }
    sound.then_some(values)
}

fn other(what: &str, found: f64, expected: &str) -> ExchangeProblem {
    ExchangeProblem::Other {
        what: what.to_owned(),
        found: found.to_string(),
        expected: expected.to_owned(),
        help: "correct the number; times ascend, lengths are in meters".to_owned(),
    }
}

fn wind(values: &[f64; 9], reference_height: f64, reference_length: f64) -> MeanWind {
    MeanWind {
        speed: values[1],
        reference_height,
        shear: Shear::Power {
            exponent: values[5],
        },
        direction: values[2].to_radians(),
        veer: 0.0,
        upflow: values[8].to_radians(),
        horizontal_shear: values[4],
        vertical_shear: values[6],
        reference_length,
        vertical: values[3],
        gust: values[7],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOUND: &str = "! Time Speed Dir Vert HShr PLexp VShr Gust Up\n\
        0.0 12.0 0 0 0 0.2 0 0 0 ! start\n 10.0, 14.0 90 1 .1 0.1 .2 0.5 -8\n";

    #[test]
    fn rows_and_columns() {
        let table = read_uniform_wind(SOUND, "a.wnd", 90.0, 126.0).unwrap();
        let wind = table.at(10.0);
        assert_eq!((wind.speed, wind.vertical, wind.gust), (14.0, 1.0, 0.5));
        assert_eq!((wind.horizontal_shear, wind.vertical_shear), (0.1, 0.2));
        assert_eq!(wind.shear, Shear::Power { exponent: 0.1 });
        assert_eq!(wind.direction, std::f64::consts::FRAC_PI_2);
        assert_eq!(wind.upflow, (-8.0_f64).to_radians());
        assert_eq!(
            (wind.reference_height, wind.reference_length),
            (90.0, 126.0)
        );
        assert_eq!(table.at(5.0).speed, 13.0);
    }

    #[test]
    fn all_problems_are_reported() {
        let text = "0 12 0 0 0 .2 0\n1 12 0 x 0 .2 0 nan\n2 12 0 0 0 .2 0 0\n2 12 0 0 0 .2 0 0\n";
        let problems = read_uniform_wind(text, "a.wnd", 0.0, 1.0).unwrap_err();
        assert_eq!(problems.iter().count(), 5, "{problems:?}");
        assert!(read_uniform_wind("", "a.wnd", 1.0, 1.0).is_err());
        assert!(read_uniform_wind("! only\n", "a.wnd", 1.0, 1.0).is_err());
    }
}
