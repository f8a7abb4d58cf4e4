//! The files of blade and tower: parameters, factors, and the table of distributed properties.

use crate::exchange::named::{missing, named, optional};
use crate::exchange::problem::{ExchangeProblem, Problems};
use crate::exchange::text::{Line, lines};

/// The names in a file of a part.
#[derive(Debug)]
pub(super) struct Names {
    /// The part.
    pub part: &'static str,
    /// The number of rows.
    count: &'static str,
    /// Columns that it needs: part of the length, twist of a blade, mass, and bending stiffness along z
    /// and along y.
    needed: &'static [&'static str],
    /// Columns that are read if they have numbers: axial and torsional stiffness, inertia of both bendings.
    more: [&'static str; 4],
    /// Columns without an effect on the structure here.
    no_effect: &'static [&'static str],
    /// Factors of mass and of both bending stiffnesses.
    factors: [&'static str; 3],
    /// Damping of modes, each with the names of newer and older files, and its mode.
    damping: &'static [([&'static str; 2], &'static str)],
    /// Factors of the stiffness of modes.
    tuners: &'static [[&'static str; 2]],
    /// A word of the shapes of modes.
    shape: &'static str,
}

/// A blade.
pub(super) const BLADE: Names = Names {
    part: "blade",
    count: "NBlInpSt",
    needed: &["BlFract", "StrcTwst", "BMassDen", "FlpStff", "EdgStff"],
    more: ["EAStff", "GJStff", "FlpIner", "EdgIner"],
    no_effect: &["PitchAxis", "AeroCent"],
    factors: ["AdjBlMs", "AdjFlSt", "AdjEdSt"],
    damping: &[
        (["BldFlDmp(1)", "BldFlDmp1"], "flap 1"),
        (["BldFlDmp(2)", "BldFlDmp2"], "flap 2"),
        (["BldEdDmp(1)", "BldEdDmp1"], "edge 1"),
    ],
    tuners: &[["FlStTunr(1)", "FlStTunr1"], ["FlStTunr(2)", "FlStTunr2"]],
    shape: "BldFl1Sh",
};

/// A tower: z of its sections is fore-aft, y side-side.
pub(super) const TOWER: Names = Names {
    part: "tower",
    count: "NTwInpSt",
    needed: &["HtFract", "TMassDen", "TwFAStif", "TwSSStif"],
    more: ["TwEAStif", "TwGJStif", "TwFAIner", "TwSSIner"],
    no_effect: &[],
    factors: ["AdjTwMa", "AdjFASt", "AdjSSSt"],
    damping: &[
        (["TwrFADmp(1)", "TwrFADmp1"], "fore-aft 1"),
        (["TwrFADmp(2)", "TwrFADmp2"], "fore-aft 2"),
        (["TwrSSDmp(1)", "TwrSSDmp1"], "side-side 1"),
        (["TwrSSDmp(2)", "TwrSSDmp2"], "side-side 2"),
    ],
    tuners: &[
        ["FAStTunr(1)", "FAStTunr1"],
        ["FAStTunr(2)", "FAStTunr2"],
        ["SSStTunr(1)", "SSStTunr1"],
        ["SSStTunr(2)", "SSStTunr2"],
    ],
    shape: "TwFAM1Sh",
};

/// Columns of numbers without twist.
const WITHOUT_TWIST: usize = 4;

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

/// Reads the file of a part; notes problems.
pub(super) fn parse(text: &str, names: &Names, problems: &mut Problems) -> Option<Table> {
    let mut remarks = Vec::new();
    let total = total(text, names.count, problems);
    let factors = names
        .factors
        .map(|name| optional(text, &[name], 1.0, problems));
    let has_damping = modal(text, names, &mut remarks, problems);
    let all = lines(text);
    let first = names.needed.first().copied().unwrap_or_default();
    let head = all
        .iter()
        .position(|line| line.first().eq_ignore_ascii_case(first));
    let Some(head) = head else {
        problems.push(0, &missing_table(names));
        return None;
    };
    let columns: Vec<_> = all[head].words().collect();
    let positions = needed(&all[head], &columns, names, problems);
    // Names are followed by units.
    let body = all.get(head + 2..).unwrap_or_default();
    let found = numbers(body, (first, total?), columns.len(), problems);
    let [Some(mass), Some(flap), Some(edge)] = factors else {
        return None;
    };
    let factors = Factors { mass, flap, edge };
    let (positions, has_damping) = (positions?, has_damping?);
    let more = names.more.map(|name| {
        let at = position(&columns, name)?;
        found.iter().any(|(_, row)| row[at] != 0.0).then_some(at)
    });
    remarks.extend(columns_remark(&columns, &found, (names, more)));
    let row = |row: &[f64]| {
        let needed = positions.iter().map(|at| row[*at]);
        factors.row(needed, more.map(|at| Some(row[at?])))
    };
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
        needed: impl ExactSizeIterator<Item = f64>,
        [axial, torsion, iy, iz]: [Option<f64>; 4],
    ) -> Row {
        let has_twist = needed.len() > WITHOUT_TWIST;
        let mut needed = needed;
        let mut next = || needed.next().unwrap_or(0.0);
        let part = next();
        let twist_deg = if has_twist { next() } else { 0.0 };
        let [mass, flap, edge] = [next(), next(), next()];
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
fn total(text: &str, name: &str, problems: &mut Problems) -> Option<usize> {
    let Some(found) = named(text, &[name]) else {
        problems.push(0, &missing(name));
        return None;
    };
    let value = found.value.parse().ok().filter(|count| *count >= 2);
    if value.is_none() {
        problems.push(
            found.line,
            &ExchangeProblem::Other {
                what: name.to_owned(),
                found: format!("\"{}\"", found.value),
                expected: "a whole number, 2 or more".to_owned(),
                help: "write the number of rows of the table".to_owned(),
            },
        );
    }
    value
}

/// Remarks on data of modes; whether modes are damped.
fn modal(
    text: &str,
    names: &Names,
    remarks: &mut Vec<String>,
    problems: &mut Problems,
) -> Option<bool> {
    let mut value = |names: &[&str; 2], default| optional(text, names, default, problems);
    let damping = names.damping.iter().map(|one| value(&one.0, 0.0));
    let damping: Vec<_> = damping.collect();
    let tuners = names.tuners.iter().map(|one| value(one, 1.0));
    let tuners: Vec<_> = tuners.collect();
    let damping = damping.into_iter().collect::<Option<Vec<_>>>()?;
    let tuners = tuners.into_iter().collect::<Option<Vec<_>>>()?;
    let has_damping = damping.iter().any(|percent| *percent != 0.0);
    if has_damping {
        let each = names.damping.iter().zip(&damping);
        let each = each.map(|((_, mode), percent)| format!("{mode} {percent} %"));
        remarks.push(format!(
            "damping is given for modes ({} of critical) and is not converted: give damping \
             ratios in [modes]",
            each.collect::<Vec<_>>().join(", ")
        ));
    }
    if tuners.iter().any(|factor| *factor != 1.0) {
        let name = names.tuners.first().map_or("", |both| both[0]);
        let each: Vec<_> = tuners.iter().map(f64::to_string).collect();
        remarks.push(format!(
            "{}, factors {} of the stiffness of modes, are not used",
            name.trim_end_matches("(1)"),
            each.join(" and ")
        ));
    }
    if text.contains(names.shape) {
        remarks.push("mode shapes of the file are not used: modes are computed".to_owned());
    }
    Some(has_damping)
}

fn missing_table(names: &Names) -> ExchangeProblem {
    ExchangeProblem::Missing {
        what: "the table of distributed properties".to_owned(),
        help: format!(
            "its first line has the names {}; is the file cut short?",
            names.needed.join(", ")
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
fn needed(
    line: &Line<'_>,
    columns: &[&str],
    names: &Names,
    problems: &mut Problems,
) -> Option<Vec<usize>> {
    let positions = names.needed.iter().map(|name| position(columns, name));
    let positions: Vec<_> = positions.collect();
    for (name, _) in names
        .needed
        .iter()
        .zip(&positions)
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
    positions.into_iter().collect()
}

/// The rows of the table with their lines.
fn numbers(
    body: &[Line<'_>],
    (first_name, total): (&str, usize),
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
                let (what, found, before) = (format!("{first_name} of {what}"), row[0], before[0]);
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
                        what: format!("{first_name} at an end of the table"),
                        found: found.to_string(),
                        expected: expected.to_string(),
                        help: "the table leads from the lower or inner end, 0, to the other, 1"
                            .to_owned(),
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
    (names, more): (&Names, [Option<usize>; 4]),
) -> Vec<String> {
    let known = |name: &str| {
        let lists = names.needed.iter().chain(&names.more);
        let lists = lists.chain(names.no_effect);
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
