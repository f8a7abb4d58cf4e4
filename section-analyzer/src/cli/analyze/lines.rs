//! Table with one line per section, and the totals.

use shared_geom::error::counted;

use super::Job;
use super::outcome::{Outcome, Status};
use crate::output::engineering_values_of;

/// Width of a column of numbers: `-1.23456e-10` and two spaces.
const NUMBER: usize = 14;
/// Width of the column of the status.
const STATUS: usize = 11;

/// The table of sections, written line by line.
pub(super) struct Lines {
    /// Width of the first column.
    width: usize,
    /// Outcomes shown so far.
    statuses: Vec<Status>,
}

impl Lines {
    /// The table for `jobs`, whose first column holds their files.
    pub fn new(jobs: &[Job]) -> Self {
        let width = |job: &Job| job.label.chars().count();
        Self {
            width: jobs
                .iter()
                .map(width)
                .max()
                .unwrap_or(0)
                .max("section".len()),
            statuses: Vec::new(),
        }
    }

    /// The heading of the columns.
    pub fn heading(&self) -> String {
        let mut line = format!("{:<1$}  {2:<STATUS$}", "section", self.width, "status");
        line += &format!("{:>9}", "nodes");
        for column in ["EA [N]", "GJ [N m^2]", "mass [kg/m]"] {
            line += &format!("{column:>NUMBER$}");
        }
        line
    }

    /// The line of a section.
    pub fn of(&mut self, job: &Job, outcome: &Outcome) -> String {
        self.statuses.push(outcome.status);
        let mut line = format!(
            "{:<2$}  {:<STATUS$}",
            job.label,
            outcome.status.name(),
            self.width,
        );
        if let Some(nodes) = outcome.nodes {
            line += &format!("{nodes:>9}");
        }
        if let Some(properties) = &outcome.properties
            && let Some([ea, _, _, gj, _, _]) = engineering_values_of(properties)
        {
            for value in [ea.free, gj.free, properties.mass[(0, 0)]] {
                line += &format!("{value:>NUMBER$.5e}");
            }
        }
        match outcome.warnings.len() {
            0 => {}
            1 => line += "  1 remark",
            count => line += &format!("  {count} remarks"),
        }
        if !outcome.removed.is_empty() {
            line += "  results of an earlier run removed";
        }
        line.trim_end().to_owned()
    }

    /// Number of sections per status.
    pub fn sum(&self) -> String {
        let listed = [
            Status::Solved,
            Status::Unchanged,
            Status::Renewed,
            Status::Sound,
            Status::NotReached,
            Status::WrongInput,
        ];
        let parts = listed.into_iter().filter_map(|status| {
            let count = self
                .statuses
                .iter()
                .filter(|found| **found == status)
                .count();
            (count > 0).then(|| format!("{count} {}", status.name()))
        });
        let parts: Vec<_> = parts.collect();
        let sections = counted(self.statuses.len(), "section");
        format!("\n{sections}: {}", parts.join(", "))
    }

    /// The largest exit code.
    pub fn worst(&self) -> u8 {
        let codes = self.statuses.iter().map(|status| status.code());
        codes.max().unwrap_or(0)
    }
}
