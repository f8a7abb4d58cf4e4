//! The structural table of a blade: rows of matrices (`BEAMTYPE` 2) or of engineering
//! properties (0 and 1), its factors and its damping.

use super::engineering::Properties;
use crate::blade::BladeDamping;
use crate::exchange::named::{named, optional};
use crate::exchange::problem::{ExchangeProblem, Problems};
use crate::exchange::text::{Line, lines, number};

/// First word of the names of the columns.
const HEAD: &str = "LENFRACT";
/// Columns of a table of matrices: position, offsets, pitch, two upper triangles.
const MATRICES: usize = 46;
/// Columns of engineering properties, in the order of [`properties`].
const PROPERTIES: [&str; 18] = [
    "LENFRACT", "MASSD", "EIX", "EIY", "EA", "GJ", "GA", "STRPIT", "KSX", "KSY", "RGX", "RGY",
    "XCM", "YCM", "XCE", "YCE", "XCS", "YCS",
];
/// Damping times of the rows.
const DAMPING: &str = "DAMP";
/// Columns of towers and of old tables, without an effect: diameter and drag.
const TOWER: [&str; 2] = ["DIA", "CD"];
/// Columns whose signs are not defined: they must be zero.
const UNDEFINED: [usize; 4] = [7, 13, 15, 17];

/// A row of the table.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Row {
    /// Its line, counted from one.
    pub line: usize,
    /// Its numbers, in the order of the columns.
    pub numbers: Vec<f64>,
    /// Its engineering properties; `None` for matrices.
    pub properties: Option<Properties>,
}

impl Row {
    /// Part of the length from the root [-].
    pub fn part(&self) -> f64 {
        self.numbers.first().copied().unwrap_or_default()
    }
}

/// Content of the file.
#[derive(Debug)]
pub(super) struct Content {
    pub rows: Vec<Row>,
    /// Whether the rows are engineering properties.
    pub is_engineering: bool,
    /// Factors of stiffness and mass [-].
    pub factors: [f64; 2],
    /// Damping of all rows.
    pub damping: Option<BladeDamping>,
    /// Damping time of each row, which replaces it [s].
    pub times: Option<Vec<f64>>,
    /// Remarks for the user.
    pub remarks: Vec<String>,
}

/// Whether `text` has a structural table, of a blade or a tower.
pub(super) fn is_table(text: &str) -> bool {
    text.lines().any(|line| is_head(line.trim()))
}

/// Whether `text` has the structural table of a blade.
pub(super) fn is_blade(text: &str) -> bool {
    let all = lines(text);
    let head = all.iter().find(|line| is_head(line.text));
    head.is_some_and(|head| {
        let names = names(head);
        !TOWER
            .iter()
            .any(|name| names.iter().any(|found| found == name))
    })
}

fn is_head(line: &str) -> bool {
    line.get(..HEAD.len())
        .is_some_and(|begin| begin.eq_ignore_ascii_case(HEAD))
}

/// The names of the columns, upper case, without their units.
fn names(line: &Line<'_>) -> Vec<String> {
    let name = |word: &str| {
        let name = word
            .split(['_', '['])
            .next()
            .unwrap_or_default()
            .to_uppercase();
        if name == "MASS" {
            "MASSD".to_owned()
        } else {
            name
        }
    };
    line.words()
        .map(name)
        .filter(|name| !name.is_empty())
        .collect()
}

/// Reads the table of a file; notes problems.
pub(super) fn read(text: &str, problems: &mut Problems) -> Option<Content> {
    let all = lines(text);
    let mut remarks = Vec::new();
    let rows = match all.iter().position(|line| is_head(line.text)) {
        Some(head) => rows(&all, head, &mut remarks, problems),
        None => {
            let what = "the table of the blade".to_owned();
            let help = format!("its first line begins with {HEAD}; is the file cut short?");
            problems.push(0, &ExchangeProblem::Missing { what, help });
            None
        }
    };
    let mut tuner = |name: &str| optional(text, &[name], 1.0, problems);
    let factors = [tuner("STIFFTUNER"), tuner("MASSTUNER")];
    let damping = damping(text, &mut remarks, problems);
    remarks.extend(unread(text));
    let (rows, times) = rows?;
    if times.is_some() {
        remarks.push("damping is the column of damping times, not RAYLEIGHDMP".to_owned());
    }
    Some(Content {
        is_engineering: rows.iter().any(|row| row.properties.is_some()),
        rows,
        factors: [factors[0]?, factors[1]?],
        damping: damping?,
        times,
        remarks,
    })
}

/// The rows of the table, and their damping times if it has some.
fn rows(
    all: &[Line<'_>],
    head: usize,
    remarks: &mut Vec<String>,
    problems: &mut Problems,
) -> Option<(Vec<Row>, Option<Vec<f64>>)> {
    let names = names(&all[head]);
    let has_matrices = names.iter().any(|name| name == "K11");
    let is_euler = is_euler(all, has_matrices, problems)?;
    let columns = if has_matrices {
        None
    } else {
        Some(columns(&all[head], &names, problems)?)
    };
    let width = if has_matrices { MATRICES } else { names.len() };
    let mut rows = numbers(&all[head + 1..], width, problems);
    if rows.is_empty() && problems.is_empty() {
        problems.push(
            all[head].number,
            &ExchangeProblem::CutShort {
                what: "the table of the blade".to_owned(),
                expected: format!("rows of {width} numbers"),
            },
        );
    }
    let Some(columns) = columns else {
        for (count, row) in rows.iter().enumerate() {
            check_matrices(count, row, problems);
        }
        return Some((rows, None));
    };
    let values = |row: &Row| columns.map(|at| row.numbers[at]);
    let has_shear = |row: &Row| {
        let row = values(row);
        [row[6] * row[8], row[6] * row[9]]
            .iter()
            .all(|shear| *shear > 0.0)
    };
    let is_euler = is_euler.unwrap_or_else(|| !rows.iter().all(has_shear));
    for (count, row) in rows.iter_mut().enumerate() {
        let values = values(row);
        check_properties(count, row.line, &values, problems);
        row.properties = Some(properties(&values, is_euler));
    }
    if is_euler {
        remarks.push(
            "the beam has no shear strain: rigid in shear, by 1e6 max(EIx, EIy) / L^2".to_owned(),
        );
    }
    let times = names.iter().position(|name| name == DAMPING);
    let times = times.map(|at| rows.iter().map(|row| row.numbers[at]).collect::<Vec<_>>());
    let times = times.filter(|times| times.iter().any(|time| *time != 0.0));
    Some((rows, times))
}

/// Whether the beam has no shear strain; `Some(None)` if the file does not state it. Notes a
/// type of beam that the columns do not have.
fn is_euler(all: &[Line<'_>], has_matrices: bool, problems: &mut Problems) -> Option<Option<bool>> {
    let stated = all.iter().find(|line| {
        let name = line.words().nth(1).unwrap_or_default();
        name.eq_ignore_ascii_case("BEAMTYPE")
    });
    let Some(line) = stated else {
        return Some(None);
    };
    match (line.first(), has_matrices) {
        ("0", false) => Some(Some(true)),
        ("1" | "2", _) if has_matrices == (line.first() == "2") => Some(Some(false)),
        (found, _) => {
            let (expected, of) = if has_matrices {
                ("2", "matrices: K11 to K66")
            } else {
                ("0 or 1", "engineering properties: EIx, EIy")
            };
            let problem = ExchangeProblem::Other {
                what: "BEAMTYPE".to_owned(),
                found: format!("\"{found}\""),
                expected: format!("{expected}, since the columns are {of}"),
                help: "correct BEAMTYPE, or the table".to_owned(),
            };
            problems.push(line.number, &problem);
            None
        }
    }
}

/// Indices of the columns of engineering properties; notes missing and unknown ones.
fn columns(line: &Line<'_>, names: &[String], problems: &mut Problems) -> Option<[usize; 18]> {
    let mut found = [0; 18];
    let mut is_sound = true;
    for (at, name) in found.iter_mut().zip(PROPERTIES) {
        match names.iter().position(|own| own == name) {
            Some(index) => *at = index,
            None => {
                let problem = ExchangeProblem::Missing {
                    what: format!("the column \"{name}\""),
                    help: format!("the names of the columns are {}", names.join(", ")),
                };
                problems.push(line.number, &problem);
                is_sound = false;
            }
        }
    }
    let known = |name: &String| {
        let mut all = PROPERTIES.iter().chain([&DAMPING]).chain(&TOWER);
        all.any(|known| known == name)
    };
    if let Some(other) = names.iter().find(|name| !known(name)) {
        let problem = ExchangeProblem::Other {
            what: "a column of the table".to_owned(),
            found: format!("\"{other}\""),
            expected: format!(
                "{}, and {DAMPING} if rows have their own damping",
                PROPERTIES.join(", ")
            ),
            help: "remove the column, or correct its name".to_owned(),
        };
        problems.push(line.number, &problem);
        is_sound = false;
    }
    is_sound.then_some(found)
}

/// The rows of `width` numbers below the names of the columns, in order.
fn numbers(body: &[Line<'_>], width: usize, problems: &mut Problems) -> Vec<Row> {
    let body = body
        .iter()
        .take_while(|line| number(line.first()).is_some());
    let mut rows: Vec<Row> = Vec::new();
    for (count, line) in body.enumerate() {
        let what = format!("station {}", count + 1);
        let Some(numbers) = line.list(&what, Some(width), problems) else {
            continue;
        };
        let row = Row {
            line: line.number,
            numbers,
            properties: None,
        };
        if let Some(before) = rows.last().filter(|before| before.part() > row.part()) {
            let problem = ExchangeProblem::Order {
                what: format!("position of {what}"),
                found: row.part(),
                before: before.part(),
            };
            problems.push(line.number, &problem);
        }
        rows.push(row);
    }
    rows
}

/// Notes matrices about another point or in other axes.
fn check_matrices(count: usize, row: &Row, problems: &mut Problems) {
    let [x, y, pitch] = [1, 2, 3].map(|at| row.numbers[at]);
    if [x, y, pitch] == [0.0; 3] {
        return;
    }
    let problem = ExchangeProblem::Other {
        what: format!("XCB, YCB and PITCH of station {}", count + 1),
        found: format!("{x}, {y}, {pitch}"),
        expected: "zeros: matrices about the line, in its axes".to_owned(),
        help: "QBlade's public description does not define their signs: transform the matrices \
               to the line first"
            .to_owned(),
    };
    problems.push(row.line, &problem);
}

/// Notes numbers whose sign is not defined.
fn check_properties(count: usize, line: usize, row: &[f64; 18], problems: &mut Problems) {
    let wrong = UNDEFINED.into_iter().filter(|at| row[*at] != 0.0);
    let wrong: Vec<_> = wrong.collect();
    if wrong.is_empty() {
        return;
    }
    let names: Vec<_> = wrong.iter().map(|at| PROPERTIES[*at]).collect();
    let found: Vec<_> = wrong.iter().map(|at| row[*at].to_string()).collect();
    let problem = ExchangeProblem::Other {
        what: format!("{} of station {}", names.join(", "), count + 1),
        found: found.join(", "),
        expected: "zero: sections with centers on the chord and principal axes along it".to_owned(),
        help: "QBlade's public description does not define the sign of Y and of STRPIT: write \
               the properties into a NAME.blade.toml, in axes that you know"
            .to_owned(),
    };
    problems.push(line, &problem);
}

/// The properties of the columns of a row.
fn properties(row: &[f64; 18], is_euler: bool) -> Properties {
    Properties {
        mass: row[1],
        bending: [row[2], row[3]],
        axial: row[4],
        torsion: row[5],
        shear: (!is_euler).then_some([row[6] * row[8], row[6] * row[9]]),
        radii: [row[10], row[11]],
        centers: [row[12], row[14], row[16]],
    }
}

/// Damping by times; `None` if a number is wrong.
fn damping(
    text: &str,
    remarks: &mut Vec<String>,
    problems: &mut Problems,
) -> Option<Option<BladeDamping>> {
    let keyword = "RAYLEIGHDMP_ANISO";
    let all = lines(text);
    let line = all.iter().find(|line| {
        let mut words = line.words();
        number(line.first()).is_some() && words.any(|word| word.eq_ignore_ascii_case(keyword))
    });
    let Some(line) = line else {
        let time = optional(text, &["RAYLEIGHDMP"], 0.0, problems)?;
        return Some((time != 0.0).then_some(BladeDamping::Proportional(time)));
    };
    let values: Vec<_> = line.words().map_while(number).collect();
    let (&[flap, edge, torsion, axial], rest) = values.split_first_chunk().or_else(|| {
        let problem = ExchangeProblem::Count {
            what: keyword.to_owned(),
            expected: 4,
            found: values.len(),
            separator: "blanks",
        };
        problems.push(line.number, &problem);
        None
    })?;
    if let Some(factor) = rest.first().filter(|factor| **factor != 0.0) {
        remarks.push(format!(
            "the factor of the mass in {keyword} ({factor} 1/s) is not read"
        ));
    }
    let times = [axial, edge, flap, torsion, flap, edge];
    let has_some = times.iter().any(|time| *time != 0.0);
    Some(has_some.then_some(BladeDamping::Times(times)))
}

/// Remarks on data that are not read.
fn unread(text: &str) -> Vec<String> {
    let mass = |line: &str| {
        let mut words = line.split_whitespace();
        let is_mass = words.next().is_some_and(|word| word.starts_with("ADDMASS"));
        is_mass && words.map_while(number).any(|mass| mass != 0.0)
    };
    let count = text.lines().filter(|line| mass(line.trim())).count();
    let masses = (count > 0)
        .then(|| format!("{count} point masses (ADDMASS) are not read: add them to the model"));
    let curved = named(text, &["INTPTYPE"]).filter(|found| found.value != "0");
    let curved = curved.map(|found| {
        format!(
            "INTPTYPE {}: QBlade interpolates along curves; here the properties are linear \
             between the rows",
            found.value
        )
    });
    masses.into_iter().chain(curved).collect()
}
