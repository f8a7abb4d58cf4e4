//! Envelopes: the largest and smallest value of each component at each position.
//!
//! The internal force is anywhere in the box of these values. The inverse of a reserve factor is
//! convex in it for all criteria but Hashin with a small strength in shear 23, so that a corner
//! of the box governs; each of up to 64 corners is an instant.

use std::collections::BTreeMap;

use shared_geom::error::Diagnostics;

use super::{COMPONENTS, LoadInstant, LoadPositions, LoadTable, SpanLoadProblem};

/// Endings of the columns, and words for reports.
pub(super) const ENDS: [(&str, &str); 2] = [("_max", "max"), ("_min", "min")];

impl LoadTable {
    /// Whether the table has a column of a largest or smallest value.
    pub(super) fn is_envelope(&self) -> bool {
        let mut names = COMPONENTS.iter().map(|component| component.0);
        names.any(|name| {
            let mut ends = ENDS.iter();
            ends.any(|(end, _)| self.0.index(&format!("{name}{end}")).is_some())
        })
    }

    /// Refuses times, steps and plain components beside an envelope.
    fn refuse_instants(&self) -> Result<(), Diagnostics> {
        let plain = COMPONENTS.map(|component| component.0);
        for column in ["time", "step"].into_iter().chain(plain) {
            if self.0.index(column).is_some() {
                let column = column.to_owned();
                return Err(self.0.problem(1, &SpanLoadProblem::Envelope { column }));
            }
        }
        Ok(())
    }

    /// The corners of the boxes of an envelope; of each `case` if the table has it.
    pub(super) fn corners(
        &self,
        positions: &LoadPositions,
    ) -> Result<Vec<LoadInstant>, Diagnostics> {
        self.refuse_instants()?;
        let position = self.position(positions.length)?;
        let mut columns = [[None; 6]; 2];
        let (mut known, mut absent) = (Vec::new(), Vec::new());
        for (columns, (end, _)) in columns.iter_mut().zip(ENDS) {
            let names = COMPONENTS.map(|(name, _)| format!("{name}{end}"));
            *columns = self.columns(&names)?;
            let pairs = names.iter().zip(&*columns);
            absent.extend(
                pairs
                    .filter(|pair| pair.1.is_none())
                    .map(|pair| pair.0.clone()),
            );
            known.extend(names);
        }
        self.refuse_others("", &known, &absent)?;
        // both ends of a component, or none
        let is_there = |i: usize| columns.iter().any(|end| end[i].is_some());
        let there: Vec<usize> = (0..6).filter(|i| is_there(*i)).collect();
        for &i in &there {
            for (end, _) in ENDS {
                self.0.require([&*format!("{}{end}", COMPONENTS[i].0)])?;
            }
        }
        let case = self.0.find("case")?;
        let mut cases: BTreeMap<Option<&str>, Vec<LoadInstant>> = BTreeMap::new();
        for row in self.of_member(positions.member.as_deref())? {
            let ends = [self.force(row, &columns[0])?, self.force(row, &columns[1])?];
            let eta = self.eta(row, &position)?;
            let name = case.map(|column| row.cells[column].as_str());
            let corners = cases
                .entry(name)
                .or_insert_with(|| all_corners(&there, name));
            let below = there.iter().find(|i| ends[0][**i] < ends[1][**i]);
            if let Some(&i) = below {
                let component = COMPONENTS[i].0;
                return Err(self
                    .0
                    .problem(row.line, &SpanLoadProblem::Ends { component }));
            }
            if let Some(corner) = corners.first() {
                self.is_new(row, eta, (&corner.points, name.unwrap_or("the envelope")))?;
            }
            for (number, corner) in corners.iter_mut().enumerate() {
                let mut force = ends[0];
                for (bit, &i) in there.iter().enumerate() {
                    force[i] = ends[number >> bit & 1][i];
                }
                corner.points.push((eta, force));
            }
        }
        Ok(cases.into_values().flatten().collect())
    }
}

/// Named corners without points: bit k of the number of a corner is set if the k-th of the
/// components `there` has its smallest value.
fn all_corners(there: &[usize], case: Option<&str>) -> Vec<LoadInstant> {
    let corner = |number: usize| {
        let words = there.iter().enumerate();
        let words = words.map(|(bit, &i)| {
            let end = ENDS[number >> bit & 1].1;
            format!("{} {end}", COMPONENTS[i].0)
        });
        let case_word = case.map(|case| format!("case {case}"));
        let words: Vec<String> = case_word.into_iter().chain(words).collect();
        LoadInstant {
            name: words.join(" "),
            case: case.map(str::to_owned),
            time: None,
            points: Vec::new(),
        }
    };
    (0..1 << there.len()).map(corner).collect()
}
