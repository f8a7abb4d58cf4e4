//! Tables of internal forces along a blade, and the table of its stations.
//!
//! A table has a line of column names with units in brackets, as `torsion [N m]`, and comes in two
//! forms: a row for each position and instant (columns `arc` or `eta`, and one of `case`, `time`,
//! `step`), as `beam-dynamics static` writes it; or a row for each time, with columns `NAME_axial`
//! and so on for positions that the command line gives, as `beam-dynamics transient` writes it.

use std::path::Path;

use nalgebra::Vector6;
use shared_geom::document::read_text;
use shared_geom::error::{Diagnostics, Explain, SourceLocation, nearest_name, quoted};
use shared_geom::units::{Dimension, parse_as};

/// The six components as columns name them, and their dimensions.
const COMPONENTS: [(&str, Dimension); 6] = [
    ("axial", Dimension::FORCE),
    ("shear_y", Dimension::FORCE),
    ("shear_z", Dimension::FORCE),
    ("torsion", Dimension::MOMENT),
    ("bending_y", Dimension::MOMENT),
    ("bending_z", Dimension::MOMENT),
];
/// Columns that distinguish instants, with the words for reports.
const INSTANTS: [&str; 3] = ["case", "time", "step"];
/// Distance from its only position at which a load is valid [-].
const NEAR: f64 = 0.005;

/// A problem of a table of loads or stations.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SpanLoadProblem {
    /// A column that is missing.
    #[error("the table has no column \"{column}\"")]
    NoColumn {
        /// The column.
        column: String,
        /// The columns of the table.
        known: Vec<String>,
    },
    /// A cell without a number.
    #[error("column \"{column}\": found \"{found}\", expected a number")]
    NoNumber {
        /// The column.
        column: String,
        /// The cell.
        found: String,
    },
    /// A unit that does not fit.
    #[error("column \"{column}\": {reason}")]
    Unit {
        /// The column.
        column: String,
        /// The problem.
        reason: String,
    },
    /// Several beams in one table.
    #[error("the table has the members {}, expected one of them", quoted(.members))]
    Members {
        /// Their names.
        members: Vec<String>,
    },
    /// Nothing to use.
    #[error("the table has no rows{of}")]
    Empty {
        /// Of which member.
        of: String,
    },
}

impl Explain for SpanLoadProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::NoColumn { column, known } => {
                let near = nearest_name(column, known.iter().map(String::as_str));
                Some(match near {
                    Some(near) => format!("did you mean \"{near}\"?"),
                    None => format!(
                        "it has {}; positions of tables over time are given by --at NAME=ETA, \
                         for columns NAME_axial, NAME_shear_y and so on",
                        quoted(known)
                    ),
                })
            }
            Self::Members { .. } => Some("name it with --member".to_owned()),
            _ => None,
        }
    }
}

/// Internal forces along the blade at one instant.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadInstant {
    /// Name for reports, as `time 1.25`.
    pub name: String,
    /// Time, if the table has it \[s\].
    pub time: Option<f64>,
    /// Positions along the span [-] in order, and the internal force there about the reference
    /// line, in section axes \[N, N m\].
    pub points: Vec<(f64, Vector6<f64>)>,
}

impl LoadInstant {
    /// The internal force at a position: linear between the positions and beyond them; with one
    /// position only near it.
    pub fn at(&self, eta: f64) -> Option<Vector6<f64>> {
        if self.points.len() < 2 {
            let (at, force) = self.points.first()?;
            return ((at - eta).abs() < NEAR).then_some(*force);
        }
        let after = self.points.partition_point(|point| point.0 <= eta);
        let after = after.clamp(1, self.points.len() - 1);
        let ((a, f), (b, g)) = (&self.points[after - 1], &self.points[after]);
        match b - a {
            width if width > 0.0 => Some(f + (g - f) * ((eta - a) / width)),
            _ => Some(*g),
        }
    }
}

/// A section of a solved blade.
#[derive(Debug, Clone, PartialEq)]
pub struct ListedStation {
    /// The name of its files.
    pub section: String,
    /// Position along the span [-].
    pub eta: f64,
    /// Arc length from the root \[m\].
    pub arc_length: f64,
}

/// Reads the table of stations that `blade` wrote.
///
/// # Errors
/// A file that cannot be read, a column that is missing, a cell without a number.
pub fn read_stations(path: &Path) -> Result<Vec<ListedStation>, Diagnostics> {
    let table = Table::read(path)?;
    let section = table.require("section")?;
    let (eta, arc) = (table.require("eta")?, table.require("arc_length")?);
    let station = |row: &Row| {
        Ok(ListedStation {
            section: row.cells.get(section).cloned().unwrap_or_default(),
            eta: table.number(row, eta, 1.0)?,
            arc_length: table.number(row, arc, 1.0)?,
        })
    };
    table.rows.iter().map(station).collect()
}

/// Source of the positions of a table of loads.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadPositions {
    /// Length of the blade, for columns `arc` \[m\].
    pub length: f64,
    /// The beam or blade, of a table with several.
    pub member: Option<String>,
    /// Names of groups of columns and their positions [-], for tables over time.
    pub named: Vec<(String, f64)>,
}

/// Reads a table of loads.
///
/// # Errors
/// All problems of its columns, and the first cell without a number.
pub fn read_loads(path: &Path, positions: &LoadPositions) -> Result<Vec<LoadInstant>, Diagnostics> {
    let table = Table::read(path)?;
    let mut instants = match positions.named.is_empty() {
        true => table.long(positions)?,
        false => table.wide(&positions.named)?,
    };
    for instant in &mut instants {
        instant.points.sort_by(|a, b| a.0.total_cmp(&b.0));
    }
    match instants.is_empty() {
        true => Err(table.problem(1, &SpanLoadProblem::Empty { of: String::new() })),
        false => Ok(instants),
    }
}

#[derive(Debug)]
struct Row {
    line: usize,
    cells: Vec<String>,
}

/// A table with its column names, without and with units.
#[derive(Debug)]
struct Table {
    file: String,
    names: Vec<String>,
    units: Vec<String>,
    rows: Vec<Row>,
}

impl Table {
    fn read(path: &Path) -> Result<Self, Diagnostics> {
        let text = read_text(path)?;
        let file = path.display().to_string();
        let lines = text.trim_start_matches('\u{feff}').lines().zip(1..);
        let mut lines = lines.filter(|(line, _)| !line.trim().is_empty() && !line.starts_with('#'));
        let cells = |line: &str| -> Vec<String> {
            line.split(',')
                .map(|cell| cell.trim().trim_matches('"').to_owned())
                .collect()
        };
        let Some((head, _)) = lines.next() else {
            let location = SourceLocation::file(file);
            return Err(Diagnostics::one(
                location,
                &SpanLoadProblem::Empty { of: String::new() },
            ));
        };
        let split = |cell: String| match cell.split_once('[') {
            Some((name, unit)) => (plain(name), unit.trim_end_matches(']').trim().to_owned()),
            None => (plain(&cell), String::new()),
        };
        let (names, units) = cells(head).into_iter().map(split).unzip();
        let rows = lines.map(|(line, number)| Row {
            line: number,
            cells: cells(line),
        });
        Ok(Self {
            file,
            names,
            units,
            rows: rows.collect(),
        })
    }

    fn problem(&self, line: usize, problem: &SpanLoadProblem) -> Diagnostics {
        Diagnostics::one(SourceLocation::line(&self.file, line), problem)
    }

    fn index(&self, name: &str) -> Option<usize> {
        self.names.iter().position(|known| known == name)
    }

    fn require(&self, name: &str) -> Result<usize, Diagnostics> {
        self.index(name).ok_or_else(|| {
            let (column, known) = (name.to_owned(), self.names.clone());
            self.problem(1, &SpanLoadProblem::NoColumn { column, known })
        })
    }

    /// A number of a row, times `factor`.
    fn number(&self, row: &Row, column: usize, factor: f64) -> Result<f64, Diagnostics> {
        let found = row.cells.get(column).cloned().unwrap_or_default();
        let number = found
            .parse::<f64>()
            .ok()
            .filter(|number| number.is_finite());
        number.map(|number| number * factor).ok_or_else(|| {
            let column = self.names[column].clone();
            self.problem(row.line, &SpanLoadProblem::NoNumber { column, found })
        })
    }

    /// SI units in a number of a column; plain numbers are in SI units.
    fn factor(&self, column: usize, dimension: Dimension) -> Result<f64, Diagnostics> {
        // as in "N m"
        let unit = self.units[column].replace(' ', "*");
        if unit.is_empty() || unit == "-" {
            return Ok(1.0);
        }
        parse_as(&unit, dimension)
            .map(|unit| unit.factor)
            .map_err(|problem| {
                let problem = SpanLoadProblem::Unit {
                    column: self.names[column].clone(),
                    reason: problem.to_string(),
                };
                self.problem(1, &problem)
            })
    }

    /// Columns and factors of the six components whose names begin with `start`; absent ones are
    /// zero, but one must be there.
    fn components(&self, start: &str) -> Result<[Option<(usize, f64)>; 6], Diagnostics> {
        let mut found = [None; 6];
        for (found, (name, dimension)) in found.iter_mut().zip(COMPONENTS) {
            if let Some(column) = self.index(&format!("{start}{name}")) {
                *found = Some((column, self.factor(column, dimension)?));
            }
        }
        if found.iter().all(Option::is_none) {
            self.require(&format!("{start}bending_y"))?;
        }
        Ok(found)
    }

    fn force(
        &self,
        row: &Row,
        columns: &[Option<(usize, f64)>; 6],
    ) -> Result<Vector6<f64>, Diagnostics> {
        let mut force = Vector6::zeros();
        for (i, column) in columns.iter().enumerate() {
            if let Some((column, factor)) = column {
                force[i] = self.number(row, *column, *factor)?;
            }
        }
        Ok(force)
    }

    /// A row for each position and instant.
    fn long(&self, positions: &LoadPositions) -> Result<Vec<LoadInstant>, Diagnostics> {
        let (position, scale) = match (self.index("eta"), self.index("arc")) {
            (Some(eta), _) => (eta, 1.0),
            (None, Some(arc)) => (arc, self.factor(arc, Dimension::LENGTH)? / positions.length),
            (None, None) => (self.require("arc_length")?, 1.0 / positions.length),
        };
        let columns = self.components("")?;
        let instant = INSTANTS
            .iter()
            .find_map(|name| Some((*name, self.index(name)?)));
        let mut found: Vec<LoadInstant> = Vec::new();
        for row in self.of_member(positions.member.as_deref())? {
            let (name, time) = match instant {
                None => ("load".to_owned(), None),
                Some((word, column)) => {
                    let cell = row.cells.get(column).cloned().unwrap_or_default();
                    let time = match word {
                        "time" => Some(self.number(row, column, 1.0)?),
                        _ => None,
                    };
                    (format!("{word} {cell}"), time)
                }
            };
            let point = (
                self.number(row, position, scale)?,
                self.force(row, &columns)?,
            );
            match found.last_mut().filter(|last| last.name == name) {
                Some(last) => last.points.push(point),
                None => found.push(LoadInstant {
                    name,
                    time,
                    points: vec![point],
                }),
            }
        }
        Ok(found)
    }

    /// The rows of the only member, or of `member`.
    fn of_member(&self, member: Option<&str>) -> Result<Vec<&Row>, Diagnostics> {
        let Some(column) = self.index("member") else {
            return Ok(self.rows.iter().collect());
        };
        let name = |row: &Row| row.cells.get(column).cloned().unwrap_or_default();
        let mut members: Vec<String> = self.rows.iter().map(name).collect();
        members.sort();
        members.dedup();
        let wanted = match (member, &members[..]) {
            (Some(member), _) => member.to_owned(),
            (None, [only]) => only.clone(),
            (None, _) => return Err(self.problem(1, &SpanLoadProblem::Members { members })),
        };
        let rows: Vec<&Row> = self.rows.iter().filter(|row| name(row) == wanted).collect();
        match rows.is_empty() {
            true => {
                let of = format!(
                    " of member \"{wanted}\", expected one of {}",
                    quoted(&members)
                );
                Err(self.problem(1, &SpanLoadProblem::Empty { of }))
            }
            false => Ok(rows),
        }
    }

    /// A row for each time, with groups of columns for positions.
    fn wide(&self, named: &[(String, f64)]) -> Result<Vec<LoadInstant>, Diagnostics> {
        let time = self.require("time")?;
        let mut groups = Vec::new();
        for (name, eta) in named {
            groups.push((*eta, self.components(&format!("{}_", plain(name)))?));
        }
        let mut found = Vec::new();
        for row in &self.rows {
            let at = self.number(row, time, 1.0)?;
            let mut points = Vec::new();
            for (eta, columns) in &groups {
                points.push((*eta, self.force(row, columns)?));
            }
            found.push(LoadInstant {
                name: format!("time {at}"),
                time: Some(at),
                points,
            });
        }
        Ok(found)
    }
}

/// A name of a column as it is compared.
fn plain(name: &str) -> String {
    name.trim().to_lowercase().replace(' ', "_")
}
