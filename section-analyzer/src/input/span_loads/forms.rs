//! The two forms of tables of internal forces, and the beams in them.

use std::collections::BTreeMap;

use nalgebra::Vector6;
use shared_geom::error::Diagnostics;

use super::super::column_table::Row;
use super::instants::Instants;
use super::{LoadInstant, LoadPositions, LoadTable, SpanLoadProblem, start_of};

impl LoadTable {
    /// A row for each position and instant.
    pub(super) fn long(&self, positions: &LoadPositions) -> Result<Vec<LoadInstant>, Diagnostics> {
        let position = self.position(positions.length)?;
        let columns = self.components("")?;
        let mut instants = Instants::new(self)?;
        for row in self.of_member(positions.member.as_deref())? {
            let eta = self.eta(row, &position)?;
            let (LoadInstant { name, points, .. }, _) = instants.of(row)?;
            self.is_new(row, eta, (points, name))?;
            points.push((eta, self.force(row, &columns)?));
        }
        Ok(instants.found)
    }

    /// A row for each time, with groups of columns for positions.
    pub(super) fn wide(&self, positions: &LoadPositions) -> Result<Vec<LoadInstant>, Diagnostics> {
        self.0.require(["time"])?;
        let mut groups: Vec<(&str, f64, _)> = Vec::new();
        for (name, eta) in &positions.named {
            if let Some((first, ..)) = groups.iter().find(|group| group.1 == *eta) {
                let (first, second, eta) = ((*first).to_owned(), name.clone(), *eta);
                let problem = SpanLoadProblem::Places { first, second, eta };
                return Err(self.0.problem(1, &problem));
            }
            groups.push((name, *eta, self.components(&start_of(name))?));
        }
        let mut instants = Instants::new(self)?;
        for row in self.of_member(positions.member.as_deref())? {
            let (instant, is_first) = instants.of(row)?;
            if !is_first {
                let instant = instant.name.clone();
                return Err(self
                    .0
                    .problem(row.line, &SpanLoadProblem::Times { instant }));
            }
            for (_, eta, columns) in &groups {
                instant.points.push((*eta, self.force(row, columns)?));
            }
        }
        Ok(instants.found)
    }

    /// Whether rows of one case are of different instants, by the columns of the envelopes of runs.
    pub(super) fn is_mixed(&self) -> Result<bool, Diagnostics> {
        let Some(case) = self.0.find("case")? else {
            return Ok(false);
        };
        let instant = match self.0.find("at_time")? {
            Some(column) => Some(column),
            None => self.0.find("at_step")?,
        };
        let mut known: BTreeMap<&str, &str> = BTreeMap::new();
        let mut rows = instant.into_iter().flat_map(|instant| {
            let cells = self.0.rows.iter().map(|row| &row.cells);
            cells.map(move |cells| (cells[case].as_str(), cells[instant].as_str()))
        });
        Ok(rows.any(|(case, instant)| *known.entry(case).or_insert(instant) != instant))
    }

    /// Checks that an instant has no point at `eta`, the position of a row.
    pub(super) fn is_new(
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
    pub(super) fn of_member(&self, member: Option<&str>) -> Result<Vec<&Row>, Diagnostics> {
        let column = self.0.find("member")?;
        let column = match (column, member) {
            (Some(column), _) => column,
            (None, None) => return Ok(self.0.rows.iter().collect()),
            (None, Some(wanted)) => {
                let wanted = wanted.to_owned();
                let problem = SpanLoadProblem::NoMemberColumn { wanted };
                return Err(self.0.problem(1, &problem));
            }
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
}
