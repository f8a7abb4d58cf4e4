//! Columns of tables of loads: components, positions, and those without effect.

use nalgebra::Vector6;
use shared_geom::error::Diagnostics;
use shared_geom::units::{Dimension, parse_as};

use super::super::column_table::Row;
use super::envelope::ENDS;
use super::{COMPONENTS, INSTANTS, LoadTable, SpanLoadProblem};

/// Columns and factors of the six components, of those that are there.
pub(super) type Components = [Option<(usize, f64)>; 6];

/// Columns of positions, and how far beyond the blade they may be, parts of its length: the length of
/// another model of the blade may differ.
const POSITIONS: [(&str, f64); 3] = [("eta", 1e-9), ("arc", 0.01), ("arc_length", 0.01)];
/// Other columns of the tables of equilibria and envelopes.
const RESULTS: [&str; 10] = [
    "factor",
    "beam",
    "xi",
    "x",
    "y",
    "z",
    "node",
    "at_time",
    "at_step",
    "at_factor",
];
const STRAINS: &str = "strain_";
/// Words in names of forces and moments, and names by letters.
const WORDS: [&str; 9] = [
    "axial", "shear", "torsion", "bending", "moment", "force", "torque", "thrust", "tension",
];
const LETTERS: [&str; 8] = ["fx", "fy", "fz", "mx", "my", "mz", "qy", "qz"];

/// The column of positions.
#[derive(Debug, Clone, Copy)]
pub(super) struct Position {
    column: usize,
    /// Parts of the length of the blade in a number.
    factor: f64,
    slack: f64,
}

impl LoadTable {
    /// Columns and factors of the six components whose names begin with `start`; absent ones are
    /// zero, but one must be there.
    pub(super) fn components(&self, start: &str) -> Result<Components, Diagnostics> {
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
        self.refuse_others(start, &names, &absent)?;
        Ok(found)
    }

    /// Refuses forces and moments whose names begin with `start` and are none of `known`, if
    /// components are absent.
    pub(super) fn refuse_others(
        &self,
        start: &str,
        known: &[String],
        absent: &[String],
    ) -> Result<(), Diagnostics> {
        let is_load = |(name, unit): &(&str, Option<String>)| {
            let own = name.strip_prefix(start);
            let own = own.filter(|_| !known.iter().any(|known| known == name));
            own.is_some_and(|own| match unit {
                Some(unit) => [Dimension::FORCE, Dimension::MOMENT]
                    .iter()
                    .any(|dimension| parse_as(unit, *dimension).is_ok()),
                None => WORDS.iter().any(|word| own.contains(word)) || LETTERS.contains(&own),
            })
        };
        match self.0.columns().find(is_load) {
            Some((column, _)) if !absent.is_empty() => {
                let (column, absent) = (column.to_owned(), absent.to_vec());
                let problem = SpanLoadProblem::NoComponent { column, absent };
                Err(self.0.problem(1, &problem))
            }
            _ => Ok(()),
        }
    }

    /// Columns and factors of the six components by their names.
    pub(super) fn columns(&self, names: &[String; 6]) -> Result<Components, Diagnostics> {
        let mut found = [None; 6];
        for ((found, name), (_, dimension)) in found.iter_mut().zip(names).zip(COMPONENTS) {
            if let Some(column) = self.0.find(name)? {
                *found = Some((column, self.0.factor(column, dimension)?));
            }
        }
        Ok(found)
    }

    pub(super) fn force(
        &self,
        row: &Row,
        columns: &Components,
    ) -> Result<Vector6<f64>, Diagnostics> {
        let mut force = Vector6::zeros();
        for (i, column) in columns.iter().enumerate() {
            if let Some((column, factor)) = column {
                force[i] = factor * self.0.number(row, *column)?;
            }
        }
        Ok(force)
    }

    /// The column of positions, on a blade of this length.
    pub(super) fn position(&self, length: f64) -> Result<Position, Diagnostics> {
        let found = POSITIONS.iter().filter(|one| self.0.count(one.0) > 0);
        let found: Vec<_> = found.collect();
        let &(name, slack) = match found[..] {
            [] => {
                let columns = self.0.headings();
                let problem = SpanLoadProblem::NoPosition { columns };
                return Err(self.0.problem(1, &problem));
            }
            [only] => only,
            _ => {
                let columns = found.iter().map(|one| one.0.to_owned()).collect();
                let problem = SpanLoadProblem::Positions { columns };
                return Err(self.0.problem(1, &problem));
            }
        };
        let [column] = self.0.require([name])?;
        let factor = match name {
            "eta" => self.0.factor(column, Dimension::NUMBER)?,
            _ => self.0.factor(column, Dimension::LENGTH)? / length,
        };
        Ok(Position {
            column,
            factor,
            slack,
        })
    }

    /// The position of a row along the span [-].
    pub(super) fn eta(&self, row: &Row, position: &Position) -> Result<f64, Diagnostics> {
        let Position {
            column,
            factor,
            slack,
        } = *position;
        let eta = factor * self.0.number(row, column)?;
        if eta >= -slack && eta <= 1.0 + slack {
            return Ok(eta);
        }
        let problem = SpanLoadProblem::Outside {
            column: self.0.heading(column).to_owned(),
            found: row.cells[column].clone(),
            eta: shared_geom::units::rounded(eta),
        };
        Err(self.0.problem(row.line, &problem))
    }

    /// Headings of the columns without effect, except columns of equilibria;
    /// `starts` are the beginnings of the names of groups, of a table over time.
    pub(super) fn unused(&self, starts: &[String]) -> Vec<String> {
        let is_component = |name: &str| {
            let ends = ENDS.iter().find_map(|end| name.strip_suffix(end.0));
            let name = ends.filter(|_| self.is_envelope()).unwrap_or(name);
            COMPONENTS.iter().any(|component| component.0 == name)
        };
        let is_used = |name: &str| {
            let is_lead = INSTANTS.contains(&name) || name == "member";
            let own = |start: &String| name.strip_prefix(&**start).is_some_and(is_component);
            match starts {
                [] => {
                    is_lead
                        || POSITIONS.iter().any(|one| one.0 == name)
                        || is_component(name)
                        || RESULTS.contains(&name)
                        || name.starts_with(STRAINS)
                }
                _ => is_lead || starts.iter().any(own),
            }
        };
        let names = self.0.columns().zip(self.0.headings());
        let unused = names.filter(|((name, _), _)| !is_used(name));
        unused.map(|(_, heading)| heading).collect()
    }
}
