//! The blade file: parameters, factors, and the table of distributed properties.

use crate::exchange::named::{missing, named, optional};
use crate::exchange::problem::{ExchangeProblem, Problems};
use crate::exchange::text::{Line, lines};

/// Columns that a blade needs.
const NEEDED: [&str; 5] = ["BlFract", "StrcTwst", "BMassDen", "FlpStff", "EdgStff"];
/// Columns of older tables that are read if they have numbers.
const MORE: [&str; 4] = ["EAStff", "GJStff", "FlpIner", "EdgIner"];
/// Columns without an effect on the structure of a blade here.
const NO_EFFECT: [&str; 2] = ["PitchAxis", "AeroCent"];

/// A station.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Row {
    /// Part of the length from the root [-].
    pub part: f64,
    /// Structural twist, nose down [deg].
    pub twist_deg: f64,
    /// Mass per length [kg/m].
    pub mass: f64,
    /// Bending stiffness, flap [N m^2].
    pub flap: f64,
    /// Bending stiffness, edge [N m^2].
    pub edge: f64,
    /// Axial stiffness, if the table has it [N].
    pub axial: Option<f64>,
    /// Torsional stiffness, if the table has it [N m^2].
    pub torsion: Option<f64>,
    /// Moments of inertia per length: flap, edge; zero if the table has none [kg m].
    pub inertia: [f64; 2],
}

/// Content of the file.
#[derive(Debug)]
pub(super) struct Table {
    pub rows: Vec<Row>,
    /// The line of each row.
    pub lines: Vec<usize>,
    /// Whether modes are damped.
    pub has_damping: bool,
    pub remarks: Vec<String>,
}

/// Factors of the columns of a file.
struct Factors {
    mass: f64,
    flap: f64,
    edge: f64,
}

/// Reads the file; notes problems.
pub(super) fn parse(text: &str, problems: &mut Problems) -> Option<Table> {
    let mut remarks = Vec::new();
    let total = total(text, problems);
    let mut factor = |name: &str| optional(text, &[name], 1.0, problems);
    let factors = [factor("AdjBlMs"), factor("AdjFlSt"), factor("AdjEdSt")];
    let has_damping = modal(text, &mut remarks, problems);
    let all = lines(text);
    let head = all
        .iter()
        .position(|line| line.first().eq_ignore_ascii_case(NEEDED[0]));
    let Some(head) = head else {
        problems.push(0, &missing_table());
        return None;
    };
    let columns: Vec<_> = all[head].words().collect();
    let positions = needed(&all[head], &columns, problems);
    // Names are followed by units.
    let body = all.get(head + 2..).unwrap_or_default();
    let found = numbers(body, total?, columns.len(), problems);
    let [Some(mass), Some(flap), Some(edge)] = factors else {
        return None;
    };
    let factors = Factors { mass, flap, edge };
    let (positions, has_damping) = (positions?, has_damping?);
    let more = MORE.map(|name| {
        let at = position(&columns, name)?;
        found.iter().any(|(_, row)| row[at] != 0.0).then_some(at)
    });
    remarks.extend(columns_remark(&columns, &found, more));
    let row = |row: &[f64]| factors.row(positions.map(|at| row[at]), more.map(|at| Some(row[at?])));
    Some(Table {
        rows: found.iter().map(|(_, numbers)| row(numbers)).collect(),
        lines: found.iter().map(|(line, _)| *line).collect(),
        has_damping,
        remarks,
    })
}

impl Factors {
    /// The station of the needed and the further columns of a row.
    fn row(
        &self,
        [part, twist_deg, mass, flap, edge]: [f64; 5],
        [axial, torsion, iy, iz]: [Option<f64>; 4],
    ) -> Row {
        Row {
            part,
            twist_deg,
            mass: mass * self.mass,
            flap: flap * self.flap,
            edge: edge * self.edge,
            axial,
            torsion,
            inertia: [iy.unwrap_or(0.0), iz.unwrap_or(0.0)],
        }
    }
}

/// The number of stations.
fn total(text: &str, problems: &mut Problems) -> Option<usize> {
    let Some(found) = named(text, &["NBlInpSt"]) else {
        problems.push(0, &missing("NBlInpSt"));
        return None;
    };
    let value = found.value.parse().ok().filter(|count| *count >= 2);
    if value.is_none() {
        problems.push(
            found.line,
            &ExchangeProblem::Other {
                what: "NBlInpSt".to_owned(),
                found: format!("\"{}\"", found.value),
                expected: "a whole number, 2 or more".to_owned(),
                help: "write the number of rows of the table".to_owned(),
            },
        );
    }
    value
}

/// Remarks on data of modes; whether modes are damped.
fn modal(text: &str, remarks: &mut Vec<String>, problems: &mut Problems) -> Option<bool> {
    let mut value = |names: [&str; 2], default| optional(text, &names, default, problems);
    let damping = [
        value(["BldFlDmp(1)", "BldFlDmp1"], 0.0),
        value(["BldFlDmp(2)", "BldFlDmp2"], 0.0),
        value(["BldEdDmp(1)", "BldEdDmp1"], 0.0),
    ];
    let tuners = [
        value(["FlStTunr(1)", "FlStTunr1"], 1.0),
        value(["FlStTunr(2)", "FlStTunr2"], 1.0),
    ];
    let ([Some(a), Some(b), Some(c)], [Some(one), Some(two)]) = (damping, tuners) else {
        return None;
    };
    let has_damping = [a, b, c].iter().any(|percent| *percent != 0.0);
    if has_damping {
        remarks.push(format!(
            "damping is given for modes (flap 1 {a} %, flap 2 {b} %, edge 1 {c} % of critical) \
             and is not converted: give damping ratios in [modes]"
        ));
    }
    if [one, two] != [1.0, 1.0] {
        remarks.push(format!(
            "FlStTunr, factors {one} and {two} of the stiffness of flap modes, are not used"
        ));
    }
    if text.contains("BldFl1Sh") {
        remarks.push("mode shapes of the file are not used: modes are computed".to_owned());
    }
    Some(has_damping)
}

fn missing_table() -> ExchangeProblem {
    ExchangeProblem::Missing {
        what: "the table of distributed properties".to_owned(),
        help: format!(
            "its first line has the names {}; is the file cut short?",
            NEEDED.join(", ")
        ),
    }
}

/// Index of a column.
fn position(columns: &[&str], name: &str) -> Option<usize> {
    columns
        .iter()
        .position(|column| column.eq_ignore_ascii_case(name))
}

/// Indices of the needed columns; notes missing ones.
fn needed(line: &Line<'_>, columns: &[&str], problems: &mut Problems) -> Option<[usize; 5]> {
    let positions = NEEDED.map(|name| position(columns, name));
    for (name, _) in NEEDED
        .iter()
        .zip(positions)
        .filter(|(_, position)| position.is_none())
    {
        problems.push(
            line.number,
            &ExchangeProblem::Missing {
                what: format!("the column \"{name}\""),
                help: format!("the names of the columns are {}", columns.join(", ")),
            },
        );
    }
    let mut all = [0; 5];
    for (at, position) in all.iter_mut().zip(positions) {
        *at = position?;
    }
    Some(all)
}

/// The rows of the table with their lines.
fn numbers(
    body: &[Line<'_>],
    total: usize,
    columns: usize,
    problems: &mut Problems,
) -> Vec<(usize, Vec<f64>)> {
    let mut rows: Vec<(usize, Vec<f64>)> = Vec::new();
    for count in 1..=total {
        let line = body
            .get(count - 1)
            .filter(|line| !line.text.starts_with("---"));
        let Some(line) = line else {
            let last = body.get(count - 1).or(body.last());
            problems.push(
                last.map_or(0, |line| line.number),
                &ExchangeProblem::CutShort {
                    what: format!(
                        "the table of properties, after {} of {total} rows",
                        count - 1
                    ),
                    expected: format!("rows of {columns} numbers"),
                },
            );
            break;
        };
        let what = format!("station {count}");
        if let Some(row) = line.list(&what, Some(columns), problems) {
            if let Some((_, before)) = rows.last().filter(|(_, before)| before[0] >= row[0]) {
                let (what, found, before) = (format!("BlFract of {what}"), row[0], before[0]);
                problems.push(
                    line.number,
                    &ExchangeProblem::Order {
                        what,
                        found,
                        before,
                    },
                );
            }
            rows.push((line.number, row));
        }
    }
    if let [(line, first), .., (end, last)] = &rows[..] {
        for (line, found, expected) in [(*line, first[0], 0.0), (*end, last[0], 1.0)] {
            if found != expected && rows.len() == total {
                problems.push(
                    line,
                    &ExchangeProblem::Other {
                        what: "BlFract at an end of the table".to_owned(),
                        found: found.to_string(),
                        expected: expected.to_string(),
                        help: "the table leads from the root, 0, to the tip, 1".to_owned(),
                    },
                );
            }
        }
    }
    rows
}

/// Remark on further columns: those that are read, and those that are not.
fn columns_remark(
    columns: &[&str],
    rows: &[(usize, Vec<f64>)],
    more: [Option<usize>; 4],
) -> Vec<String> {
    let known = |name: &str| {
        let lists = NEEDED.iter().chain(&MORE).chain(&NO_EFFECT);
        lists
            .into_iter()
            .any(|known| known.eq_ignore_ascii_case(name))
    };
    let has_numbers = |at: usize| rows.iter().any(|(_, row)| row[at] != 0.0);
    let unread = columns.iter().enumerate();
    let unread = unread.filter(|(at, name)| !known(name) && has_numbers(*at));
    let unread: Vec<_> = unread.map(|(_, name)| *name).collect();
    let read = more.into_iter().flatten().map(|at| columns[at]);
    let read: Vec<_> = read.collect();
    let mut remarks = Vec::new();
    if !read.is_empty() {
        remarks.push(format!(
            "columns {} are read, which ElastoDyn itself does not use",
            read.join(", ")
        ));
    }
    if !unread.is_empty() {
        remarks.push(format!(
            "columns {} are not read: ElastoDyn does not use them",
            unread.join(", ")
        ));
    }
    remarks
}
