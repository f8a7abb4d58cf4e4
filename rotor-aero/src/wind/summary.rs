//! The `.sum` file beside a Bladed `.wnd` file: the numbers that the binary file does not contain.
//!
//! Lines are recognized by words in capitals or not: `CLOCKWISE` (T, F, yes or no at the begin),
//! `HUB HEIGHT` or `ZHUB` (m, at the begin), `UBAR = ` (m/s) and after it three lines with
//! ` = ` intensity in per cent, `HEIGHT OFFSET = ` (m, optional), `PERIODIC` (optional). Other
//! lines are comments. These are the words that InflowWind reads (OpenFAST documentation).

use shared_geom::error::Diagnostics;
use shared_geom::exchange::problem::{ExchangeProblem, Problems};
use shared_geom::exchange::text::{Line, lines, not_a_number, number};

/// The numbers of a `.sum` file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BladedSummary {
    /// Whether the order of y is reversed.
    pub clockwise: bool,
    /// Height of the hub \[m\].
    pub hub_height: f64,
    /// Mean speed \[m/s\].
    pub speed: f64,
    /// Turbulence intensities of u, v, w, in per cent \[-\].
    pub intensities: [f64; 3],
    /// Height of the hub above the middle of the grid \[m\].
    pub height_offset: f64,
    /// Whether the box is periodic.
    pub periodic: bool,
}

/// Reads the text of a `.sum` file, shown as `file` in messages.
///
/// # Errors
/// All missing lines and words instead of numbers.
pub fn read_summary(text: &str, file: &str) -> Result<BladedSummary, Diagnostics> {
    let mut problems = Problems::new(file);
    let lines = lines(text);
    let find = |words: &[&str]| {
        let has = |line: &&Line<'_>| {
            let upper = line.text.to_uppercase();
            words.iter().any(|word| upper.contains(word))
        };
        lines.iter().find(has)
    };
    let clockwise = require(find(&["CLOCKWISE"]), "CLOCKWISE", &mut problems)
        .and_then(|line| yes_or_no(line, &mut problems));
    let hub_height = require(find(&["HUB HEIGHT", "ZHUB"]), "HUB HEIGHT", &mut problems)
        .and_then(|line| value(line, line.first(), "hub height", &mut problems));
    let mean = require(find(&["UBAR"]), "UBAR", &mut problems);
    let speed = mean.and_then(|line| after_sign(line, "mean speed", &mut problems));
    let intensities = mean.and_then(|mean| {
        let next = lines.iter().skip_while(|line| line.number <= mean.number);
        let next: Vec<_> = next.take(3).collect();
        three(&next, &mut problems)
    });
    let offset = find(&["HEIGHT OFFSET"]);
    let offset = offset.map(|line| after_sign(line, "height offset", &mut problems));
    let summary = (|| {
        Some(BladedSummary {
            clockwise: clockwise?,
            hub_height: hub_height?,
            speed: speed?,
            intensities: intensities?,
            height_offset: offset.unwrap_or(Some(0.0))?,
            periodic: find(&["PERIODIC"]).is_some(),
        })
    })();
    problems.finish(summary)
}

fn require<'a>(
    line: Option<&'a Line<'a>>,
    word: &str,
    problems: &mut Problems,
) -> Option<&'a Line<'a>> {
    if line.is_none() {
        let what = format!("the line with the word {word}");
        let help = "give the .sum file that was made with the .wnd file".to_owned();
        problems.push(0, &ExchangeProblem::Missing { what, help });
    }
    line
}

fn yes_or_no(line: &Line<'_>, problems: &mut Problems) -> Option<bool> {
    let first = line.first().trim_start_matches('.').to_uppercase();
    match first.chars().next() {
        Some('T' | 'Y') => Some(true),
        Some('F' | 'N') => Some(false),
        _ => {
            let problem = ExchangeProblem::Other {
                what: "sense of rotation (CLOCKWISE)".to_owned(),
                found: line.first().to_owned(),
                expected: "T, F, yes or no at the begin of the line".to_owned(),
                help: "correct the line".to_owned(),
            };
            problems.push(line.number, &problem);
            None
        }
    }
}

/// The three intensities.
fn three(lines: &[&Line<'_>], problems: &mut Problems) -> Option<[f64; 3]> {
    let mut values = [0.0; 3];
    if lines.len() < 3 {
        let what = "the three lines of turbulence intensities after UBAR".to_owned();
        let help = "give the whole .sum file".to_owned();
        problems.push(0, &ExchangeProblem::Missing { what, help });
        return None;
    }
    let mut sound = true;
    for (value, line) in values.iter_mut().zip(lines) {
        match after_sign(line, "turbulence intensity", problems) {
            Some(number) => *value = number,
            None => sound = false,
        }
    }
    sound.then_some(values)
}

/// The number behind `=`, up to a blank or `%`.
fn after_sign(line: &Line<'_>, what: &str, problems: &mut Problems) -> Option<f64> {
    let behind = line.text.split_once('=').map_or(line.text, |pair| pair.1);
    let word = behind.split(['%', ',']).next().unwrap_or_default();
    let word = word.split_whitespace().next().unwrap_or_default();
    value(line, word, what, problems)
}

fn value(line: &Line<'_>, word: &str, what: &str, problems: &mut Problems) -> Option<f64> {
    let value = number(word.trim_end_matches(','));
    if value.is_none() {
        problems.push(line.number, &not_a_number(what, word));
    }
    value
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "This summary was made by hand\n\nT  Clockwise rotation when looking downwind?\n\
        90.00  Hub Height (m)\n\nUBAR = 12.5 m/s, TI(u) next\n TI(u) = 15.0 %\n TI(v) = 12%\n\
        TI(w) = 8 %\n\nHeight Offset = 2.5 m\nCreating a PERIODIC output file.\n";

    #[test]
    fn all_numbers_are_read() {
        let summary = read_summary(TEXT, "a.sum").unwrap();
        let expected = BladedSummary {
            clockwise: true,
            hub_height: 90.0,
            speed: 12.5,
            intensities: [15.0, 12.0, 8.0],
            height_offset: 2.5,
            periodic: true,
        };
        assert_eq!(summary, expected);
    }

    #[test]
    fn optional_lines_may_be_missing() {
        let text = TEXT.split("Height").next().unwrap().replace("T  C", "N  C");
        let text = text.replace("90.00  Hub", "90.00 ZHub") + TEXT.split("90.00").nth(1).unwrap();
        let text: String = text
            .lines()
            .filter(|line| !line.contains("Offset") && !line.contains("PERIODIC"))
            .map(|line| line.to_owned() + "\n")
            .collect();
        let text = text.replace("  Hub Height", "90 Hub Height");
        let summary = read_summary(&text, "a.sum").unwrap();
        assert_eq!((summary.clockwise, summary.periodic), (false, false));
        assert_eq!(summary.height_offset, 0.0);
    }

    #[test]
    fn all_problems_are_reported() {
        let problems = read_summary("maybe clockwise\nUBAR = x\n TI = 3%\n", "a.sum").unwrap_err();
        // sense of rotation, hub height, speed, intensities
        assert_eq!(problems.iter().count(), 4, "{problems:?}");
        assert_eq!(read_summary("", "a.sum").unwrap_err().iter().count(), 3);
    }
}
