//! The blade file: damping times, and two 6x6 matrices per station.

use nalgebra::Matrix6;

use crate::blade::{Blade, BladeDamping};
use crate::exchange::frame::Convention;
use crate::exchange::header::Header;
use crate::exchange::problem::{ExchangeProblem, Problems};
use crate::exchange::stations::symmetric;
use crate::exchange::text::{Line, digits, matrix_lines};

use super::Layout;

/// A station: part of the length, stiffness and mass in BeamDyn's axes.
type Row = (f64, Matrix6<f64>, Matrix6<f64>);

/// Content of the file.
#[derive(Debug)]
pub(super) struct BladeFile {
    pub stations: Vec<Row>,
    /// The line of each station.
    pub lines: Vec<usize>,
    /// Damping times in the order of BeamDyn [s]; `None` without this damping.
    pub times: Option<[f64; 6]>,
    /// Whether the file has damping of modes.
    pub has_modal_damping: bool,
    pub remarks: Vec<String>,
}

/// Whether `text` is a BeamDyn blade file.
pub(super) fn recognize(text: &str) -> bool {
    text.lines().any(|line| is_named(line, "station_total"))
}

/// Whether a line states the value of `name`, which follows the value.
pub(super) fn is_named(line: &str, name: &str) -> bool {
    let word = line.split_whitespace().nth(1);
    word.is_some_and(|word| word.eq_ignore_ascii_case(name))
}

/// Whether a line separates two parts of the file.
pub(super) fn is_separator(line: &Line<'_>) -> bool {
    line.text.starts_with("---") || line.text.starts_with("===")
}

/// The whole number of the line that states `name`, and the index of the line.
pub(super) fn count(
    lines: &[Line<'_>],
    name: &str,
    problems: &mut Problems,
) -> Option<(usize, usize)> {
    let Some(at) = lines.iter().position(|line| is_named(line.text, name)) else {
        problems.push(0, &missing(name));
        return None;
    };
    let word = lines[at].first();
    let value = word.parse().ok();
    if value.is_none() {
        let problem = ExchangeProblem::Other {
            what: name.to_owned(),
            found: format!("\"{word}\""),
            expected: "a whole number".to_owned(),
            help: format!("write the number of lines that follow before the word {name}"),
        };
        problems.push(lines[at].number, &problem);
    }
    value.map(|value| (value, at))
}

fn missing(name: &str) -> ExchangeProblem {
    ExchangeProblem::Missing {
        what: format!("the line of \"{name}\""),
        help: format!("it has a value and after it the word {name}; is the file cut short?"),
    }
}

fn missing_stations() -> ExchangeProblem {
    ExchangeProblem::Missing {
        what: "every station (station_total is 0)".to_owned(),
        help: "give at least two, at eta = 0 and 1".to_owned(),
    }
}

/// Reads the lines of the file; notes problems.
pub(super) fn parse(lines: &[Line<'_>], problems: &mut Problems) -> Option<BladeFile> {
    let total = count(lines, "station_total", problems);
    let damping = count(lines, "damp_type", problems);
    let (total, _) = total?;
    let (kind, at) = damping?;
    let mut remarks = Vec::new();
    let times = times(&lines[at + 1..], kind, &mut remarks, problems);
    let Some(begin) = lines.iter().rposition(is_separator) else {
        problems.push(0, &missing("DISTRIBUTED PROPERTIES"));
        return None;
    };
    let body = &lines[begin + 1..];
    let (stations, lines) = stations(body, total, problems);
    if total == 0 {
        problems.push(0, &missing_stations());
    }
    let used = total.saturating_mul(13);
    if let Some(line) = body.get(used) {
        remarks.push(format!(
            "line {} and the lines below follow the {total} stations that station_total \
             announces, and are not read",
            line.number
        ));
    }
    Some(BladeFile {
        stations,
        lines,
        times,
        has_modal_damping: kind > 1,
        remarks,
    })
}

/// The six damping times, if they are used.
fn times(
    lines: &[Line<'_>],
    kind: usize,
    remarks: &mut Vec<String>,
    problems: &mut Problems,
) -> Option<[f64; 6]> {
    match kind {
        0 => return None,
        1 => {}
        _ => {
            remarks.push(format!(
                "damping of damp_type {kind} is by modes, not by sections: it is not taken over; \
                 give damping ratios in the table [modes]"
            ));
            return None;
        }
    }
    let names = lines
        .iter()
        .position(|line| line.first().eq_ignore_ascii_case("mu1"));
    let values = names.and_then(|at| {
        let behind = lines[at + 1..]
            .iter()
            .take_while(|line| !is_separator(line));
        behind.into_iter().find(|line| !line.text.starts_with('('))
    });
    match values {
        Some(line) => line.numbers("damping times mu1 to mu6", problems),
        None => {
            problems.push(0, &missing("mu1"));
            None
        }
    }
}

/// The stations of the body, in order: each a line of one number and the lines up to the
/// next such line, so that a missing line is reported once; and the lines of their
/// positions.
fn stations(body: &[Line<'_>], total: usize, problems: &mut Problems) -> (Vec<Row>, Vec<usize>) {
    let (mut rows, mut lines): (Vec<Row>, Vec<usize>) = Default::default();
    let mut rest = body;
    for number in 1..=total {
        let Some((head, tail)) = rest.split_first() else {
            let last = body.last().map_or(0, |line| line.number);
            problems.push(
                last,
                &ExchangeProblem::CutShort {
                    what: format!("the table of stations, after {} of {total}", number - 1),
                    expected: "a line with the position eta, six lines of stiffness, six of mass"
                        .to_owned(),
                },
            );
            break;
        };
        let next = tail.iter().position(|line| line.words().count() == 1);
        let (block, behind) = tail.split_at(next.unwrap_or(tail.len().min(12)));
        rest = behind;
        let eta = head.numbers::<1>(&format!("position eta of station {number}"), problems);
        let matrices = matrices(block, head, number, next.is_none(), problems);
        if let (Some([eta]), Some((stiffness, mass))) = (eta, matrices) {
            check_position(eta, head.number, number, rows.last(), problems);
            rows.push((eta, stiffness, mass));
            lines.push(head.number);
        }
    }
    (rows, lines)
}

/// The two matrices of a station, which may be the `last` of the file.
fn matrices(
    block: &[Line<'_>],
    head: &Line<'_>,
    number: usize,
    last: bool,
    problems: &mut Problems,
) -> Option<(Matrix6<f64>, Matrix6<f64>)> {
    if block.len() != 12 && !last {
        let problem = ExchangeProblem::Other {
            what: format!("station {number}"),
            found: format!("{} lines below its position", block.len()),
            expected: "12: six of stiffness, six of mass".to_owned(),
            help: "a row of a matrix may be missing, or there may be one too many".to_owned(),
        };
        problems.push(head.number, &problem);
        return None;
    }
    let (upper, lower) = block.split_at(block.len().min(6));
    let stiffness = matrix(
        upper,
        &format!("stiffness of station {number}"),
        head,
        problems,
    );
    if upper.len() < 6 {
        return None;
    }
    let mass = matrix(lower, &format!("mass of station {number}"), head, problems);
    stiffness.zip(mass)
}

/// Notes a position before the previous one or off the blade.
fn check_position(
    eta: f64,
    line: usize,
    number: usize,
    last: Option<&Row>,
    problems: &mut Problems,
) {
    let what = format!("position eta of station {number}");
    if !(0.0..=1.0).contains(&eta) {
        let problem = ExchangeProblem::Other {
            what: what.clone(),
            found: eta.to_string(),
            expected: "0 (root) to 1 (tip)".to_owned(),
            help: "eta is the part of the length of the reference line, not a length".to_owned(),
        };
        problems.push(line, &problem);
    }
    if let Some(&(before, ..)) = last.filter(|last| last.0 > eta) {
        let found = eta;
        let problem = ExchangeProblem::Order {
            what,
            found,
            before,
        };
        problems.push(line, &problem);
    }
}

/// Six rows of six numbers; all rows are read.
fn matrix(
    lines: &[Line<'_>],
    what: &str,
    head: &Line<'_>,
    problems: &mut Problems,
) -> Option<Matrix6<f64>> {
    let mut rows = Vec::with_capacity(6);
    for row in 0..6 {
        match lines.get(row) {
            Some(line) => {
                let numbers = line.numbers::<6>(&format!("{what}, row {}", row + 1), problems);
                rows.push(numbers);
            }
            None => {
                let problem = ExchangeProblem::CutShort {
                    what: format!("the {what}, after {row} of 6 rows"),
                    expected: "rows of six numbers".to_owned(),
                };
                problems.push(lines.last().unwrap_or(head).number, &problem);
                return None;
            }
        }
    }
    let rows: Vec<[f64; 6]> = rows.into_iter().collect::<Option<_>>()?;
    let matrix = Matrix6::from_fn(|i, j| rows[i][j]);
    Some(symmetric(&matrix, what, lines[0].number, problems))
}

/// The file of `rows` and of the damping of `blade`.
pub(super) fn write(blade: &Blade, rows: &[Row], layout: Layout) -> String {
    let header = Header::new(blade, Convention::BeamDyn, "reference line (key points)");
    let kinds = match layout {
        Layout::Four => "Damping type (switch) {0: none, 1: stiffness-proportional}",
        Layout::Five => "Damping type (switch) {0: none, 1: stiffness-proportional, 2: modal}",
    };
    let (kind, times) = match &blade.damping {
        Some(BladeDamping::Proportional(time)) => (1, [*time; 6]),
        Some(BladeDamping::Times(times)) => (1, Convention::BeamDyn.values_from_ours(times)),
        // Matrices were converted to times earlier.
        None | Some(BladeDamping::Viscous(_)) => (0, [0.0; 6]),
    };
    let times = times.map(digits).join(" ");
    let mut text = format!(
        "------- BEAMDYN INDIVIDUAL BLADE INPUT FILE --------------------------\n{}\n\
         ---------------------- BLADE PARAMETERS --------------------------------------\n\
         {:<22} station_total    - Number of blade input stations (-)\n\
         {kind:<22} damp_type        - {kinds}\n\
         ---------------------- STIFFNESS-PROPORTIONAL DAMPING [damp_type=1] ----------\n\
         \x20  mu1        mu2        mu3        mu4        mu5        mu6\n\
         \x20  (s)        (s)        (s)        (s)        (s)        (s)\n{times}\n",
        header.one_line(),
        rows.len(),
    );
    if layout == Layout::Five {
        text.push_str(
            "---------------------- MODAL DAMPING [damp_type=2] ---------------------------\n\
             0                      n_modes          - Number of modal damping coefficients (-)\n\
             0.0                    zeta             - Damping ratios of mode 1 to n_modes (-)\n",
        );
    }
    text.push_str(
        "---------------------- DISTRIBUTED PROPERTIES --------------------------------\n",
    );
    for (eta, stiffness, mass) in rows {
        text.push_str(&digits(*eta));
        text.push('\n');
        text.push_str(&matrix_lines(stiffness));
        text.push('\n');
        text.push_str(&matrix_lines(mass));
        text.push('\n');
    }
    text
}
