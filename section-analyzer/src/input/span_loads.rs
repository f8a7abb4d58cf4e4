//! Tables of internal forces along a blade, and the table of its stations.
//!
//! A table of forces comes in two forms: a row for each position and instant, in any order (columns `arc`
//! or `eta`, and all of `case`, `time`, `step` that distinguish the instants), as `beam-dynamics static` writes it; or a row for each time, with columns `NAME_axial`
//! and so on for positions that the command line gives, as `beam-dynamics transient` writes it.
//! Envelopes, `axial_max`, `axial_min` and so on, have the first form.

use std::collections::HashMap;
use std::path::Path;

use nalgebra::Vector6;
use shared_geom::error::{Diagnostics, Explain, nearest_name, quoted};
use shared_geom::units::{Dimension, parse_as};

use super::column_table::{ColumnProblem, ColumnTable, Row, plain};

mod envelope;

/// The six components as columns name them, and their dimensions.
const COMPONENTS: [(&str, Dimension); 6] = [
    ("axial", Dimension::FORCE),
    ("shear_y", Dimension::FORCE),
    ("shear_z", Dimension::FORCE),
    ("torsion", Dimension::MOMENT),
    ("bending_y", Dimension::MOMENT),
    ("bending_z", Dimension::MOMENT),
];
/// Columns that distinguish instants together, with the words for reports.
const INSTANTS: [&str; 3] = ["case", "time", "step"];
/// Distance from its only position at which a load is valid [-].
const NEAR: f64 = 0.005;

/// A problem of the beams in a table of loads.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SpanLoadProblem {
    /// Several beams in one table.
    #[error("the table has the members {}, expected one of them", quoted(.members))]
    Members {
        /// Their names.
        members: Vec<String>,
    },
    /// No loads of the wanted beam.
    #[error("the table has no rows of member \"{wanted}\", expected one of {}", quoted(.members))]
    NoMember {
        /// The beam.
        wanted: String,
        /// The beams of the table.
        members: Vec<String>,
    },
    /// Two rows for one position and instant.
    #[error(
        "the second row for eta {eta} of {instant}, expected one for each position and instant"
    )]
    Rows {
        /// The position [-].
        eta: f64,
        /// The instant.
        instant: String,
    },
    /// A column that an envelope cannot have.
    #[error(
        "column \"{column}\" beside columns of largest and smallest values, expected an envelope"
    )]
    Envelope {
        /// The column.
        column: String,
    },
    /// A largest value that is less than the smallest.
    #[error("the largest value of {component} is less than the smallest")]
    Ends {
        /// The component.
        component: &'static str,
    },
    /// A force or moment that is none of the components, beside absent components.
    #[error("column \"{column}\" is no component of the internal force, expected {}", quoted(.absent))]
    NoComponent {
        /// The column.
        column: String,
        /// The components that have no column.
        absent: Vec<String>,
    },
}

impl Explain for SpanLoadProblem {
    fn help(&self) -> Option<String> {
        Some(match self {
            Self::Members { .. } | Self::NoMember { .. } => "name it with --member".to_owned(),
            Self::Rows { .. } => {
                "number the instants in a column time or step, and name load cases in a column case"
                    .to_owned()
            }
            Self::Envelope { .. } => {
                "an envelope has no times: remove the column, or the columns of the envelope"
                    .to_owned()
            }
            Self::Ends { .. } => "exchange both".to_owned(),
            Self::NoComponent { column, absent } => {
                let near = nearest_name(&plain(column), absent.iter().map(String::as_str));
                match near {
                    Some(near) => format!("did you mean \"{near}\"?"),
                    None => "rename or remove it: absent components are zero".to_owned(),
                }
            }
        })
    }
}

/// Internal forces along the blade at one instant.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadInstant {
    /// Name for reports, as `case gust time 1.25`.
    pub name: String,
    /// The load case, if the table has it.
    pub case: Option<String>,
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

impl ListedStation {
    /// The position for reports, with its side of a jump.
    pub fn label(&self) -> String {
        let sides = [("_inner", " inner"), ("_outer", " outer")];
        let side = sides.iter().find(|side| self.section.ends_with(side.0));
        format!(
            "{}{}",
            crate::mesh::short(self.eta),
            side.map_or("", |side| side.1)
        )
    }
}

/// Reads the table of stations that `blade` wrote.
///
/// # Errors
/// A file that cannot be read, a column that is missing, a cell without a number.
pub fn read_stations(path: &Path) -> Result<Vec<ListedStation>, Diagnostics> {
    const REMEDY: &str = "name the table NAME.span.csv that \"section-analyzer blade\" wrote";
    let table = ColumnTable::read(path, REMEDY)?;
    let [section, eta, arc] = table.require(["section", "eta", "arc_length"])?;
    let station = |row: &Row| {
        Ok(ListedStation {
            section: row.cells[section].clone(),
            eta: table.number(row, eta)?,
            arc_length: table.number(row, arc)?,
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
    const REMEDY: &str = "positions of tables over time are given by --at NAME=ETA, for columns \
                          NAME_axial, NAME_shear_y and so on";
    let table = LoadTable(ColumnTable::read(path, REMEDY)?);
    let mut instants = match positions.named.is_empty() {
        true if table.is_envelope() => table.corners(positions)?,
        true => table.long(positions)?,
        false => table.wide(&positions.named)?,
    };
    for instant in &mut instants {
        instant.points.sort_by(|a, b| a.0.total_cmp(&b.0));
    }
    Ok(instants)
}

/// A table of internal forces.
#[derive(Debug)]
struct LoadTable(ColumnTable);

impl LoadTable {
    /// Columns and factors of the six components whose names begin with `start`; absent ones are
    /// zero, but one must be there.
    fn components(&self, start: &str) -> Result<[Option<(usize, f64)>; 6], Diagnostics> {
        let names = COMPONENTS.map(|(name, _)| format!("{start}{name}"));
        let found = self.columns(&names)?;
        if found.iter().all(Option::is_none) {
            self.0.require([&*format!("{start}bending_y")])?;
        }
        let absent = names
            .iter()
            .zip(&found)
            .filter(|(_, column)| column.is_none());
        let absent: Vec<String> = absent.map(|(name, _)| name.clone()).collect();
        let is_load = |unit: &str| {
            [Dimension::FORCE, Dimension::MOMENT]
                .iter()
                .any(|dimension| parse_as(unit, *dimension).is_ok())
        };
        let unknown = self.0.units().find(|(name, unit)| {
            name.starts_with(start) && !names.iter().any(|known| known == name) && is_load(unit)
        });
        match unknown {
            Some((column, _)) if !absent.is_empty() => {
                let column = column.to_owned();
                let problem = SpanLoadProblem::NoComponent { column, absent };
                Err(self.0.problem(1, &problem))
            }
            _ => Ok(found),
        }
    }

    /// Columns and factors of the six components by their names.
    fn columns(&self, names: &[String; 6]) -> Result<[Option<(usize, f64)>; 6], Diagnostics> {
        let mut found = [None; 6];
        for ((found, name), (_, dimension)) in found.iter_mut().zip(names).zip(COMPONENTS) {
            let count = self.0.count(name);
            if count > 1 {
                let column = name.clone();
                return Err(self.0.problem(1, &ColumnProblem::Doubled { column, count }));
            }
            if let Some(column) = self.0.index(name) {
                *found = Some((column, self.0.factor(column, dimension)?));
            }
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
                force[i] = factor * self.0.number(row, *column)?;
            }
        }
        Ok(force)
    }

    /// The column of positions and the factor to parts of the `length` of the blade.
    fn position(&self, length: f64) -> Result<(usize, f64), Diagnostics> {
        Ok(match (self.0.index("eta"), self.0.index("arc")) {
            (Some(eta), _) => (eta, 1.0),
            (None, Some(arc)) => (arc, self.0.factor(arc, Dimension::LENGTH)? / length),
            (None, None) => (self.0.require(["arc_length"])?[0], 1.0 / length),
        })
    }

    /// A row for each position and instant.
    fn long(&self, positions: &LoadPositions) -> Result<Vec<LoadInstant>, Diagnostics> {
        let (position, scale) = self.position(positions.length)?;
        let columns = self.components("")?;
        let instants = INSTANTS.map(|name| self.0.index(name));
        let [case, time, _] = instants;
        let mut found: Vec<LoadInstant> = Vec::new();
        let mut numbers: HashMap<String, usize> = HashMap::new();
        for row in self.of_member(positions.member.as_deref())? {
            let words = INSTANTS.iter().zip(instants);
            let words = words.filter_map(|(word, column)| {
                column.map(|column| format!("{word} {}", row.cells[column]))
            });
            let name = match words.collect::<Vec<_>>().join(" ") {
                none if none.is_empty() => "load".to_owned(),
                name => name,
            };
            let number = *numbers.entry(name.clone()).or_insert(found.len());
            if number == found.len() {
                found.push(LoadInstant {
                    name,
                    case: case.map(|column| row.cells[column].clone()),
                    time: time.map(|column| self.0.number(row, column)).transpose()?,
                    points: Vec::new(),
                });
            }
            let eta = scale * self.0.number(row, position)?;
            let LoadInstant { name, points, .. } = &mut found[number];
            self.is_new(row, eta, (points, name))?;
            points.push((eta, self.force(row, &columns)?));
        }
        Ok(found)
    }

    /// Checks that an instant has no point at `eta`, the position of a row.
    fn is_new(
        &self,
        row: &Row,
        eta: f64,
        (points, instant): (&[(f64, Vector6<f64>)], &str),
    ) -> Result<(), Diagnostics> {
        if points.iter().all(|point| point.0 != eta) {
            return Ok(());
        }
        let instant = instant.to_owned();
        Err(self
            .0
            .problem(row.line, &SpanLoadProblem::Rows { eta, instant }))
    }

    /// The rows of the only member, or of `member`.
    fn of_member(&self, member: Option<&str>) -> Result<Vec<&Row>, Diagnostics> {
        let Some(column) = self.0.index("member") else {
            return Ok(self.0.rows.iter().collect());
        };
        let name = |row: &Row| row.cells[column].clone();
        let mut members: Vec<String> = self.0.rows.iter().map(name).collect();
        members.sort();
        members.dedup();
        let wanted = match (member, &members[..]) {
            (Some(member), _) => member.to_owned(),
            (None, [only]) => only.clone(),
            (None, _) => return Err(self.0.problem(1, &SpanLoadProblem::Members { members })),
        };
        let rows: Vec<&Row> = self
            .0
            .rows
            .iter()
            .filter(|row| name(row) == wanted)
            .collect();
        if rows.is_empty() {
            let problem = SpanLoadProblem::NoMember { wanted, members };
            Err(self.0.problem(1, &problem))
        } else {
            Ok(rows)
        }
    }

    /// A row for each time, with groups of columns for positions.
    fn wide(&self, named: &[(String, f64)]) -> Result<Vec<LoadInstant>, Diagnostics> {
        let [time] = self.0.require(["time"])?;
        let mut groups = Vec::new();
        for (name, eta) in named {
            groups.push((*eta, self.components(&format!("{}_", plain(name)))?));
        }
        let mut found = Vec::new();
        for row in &self.0.rows {
            let at = self.0.number(row, time)?;
            let mut points = Vec::new();
            for (eta, columns) in &groups {
                points.push((*eta, self.force(row, columns)?));
            }
            found.push(LoadInstant {
                name: format!("time {at}"),
                case: None,
                time: Some(at),
                points,
            });
        }
        Ok(found)
    }
}
