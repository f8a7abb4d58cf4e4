//! Internal forces along blades and lines of beams, as tables that `section-analyzer strength` reads:
//! a row for each instant and evaluation point, the rows of the instants with an extreme, and the envelope over
//! all instants.
//!
//! All analyses write them in the same way. A table has columns for the instant (time, or step and
//! factor), the arc position along the undeformed line \[m\], and the internal force \[N, N m\] in
//! section axes about the reference line.

use nalgebra::Vector6;

use super::folder::Results;
use super::rows::{csv_text, number, numbers};
use super::structure::{Member, Structure};
use super::transient::{CsvRows, Heading, RunFileProblem};
use crate::elements::SectionState;
use crate::elements::beams::EVALUATION_POINTS;

mod envelope;

use envelope::{Envelope, LEADS, compared};

/// Endings of the tables, after the analysis and the member.
const FORCES: &str = "forces.csv";
const EXTREMES: &str = "extremes.csv";
const ENVELOPE: &str = "envelope.csv";
/// Columns of the internal force and their units.
const COMPONENTS: [(&str, &str); 6] = [
    ("axial", "N"),
    ("shear_y", "N"),
    ("shear_z", "N"),
    ("torsion", "N m"),
    ("bending_y", "N m"),
    ("bending_z", "N m"),
];

/// Columns that distinguish instants, with their units.
pub(super) type Leads = &'static [(&'static str, &'static str)];

/// The tables of a run.
#[derive(Debug)]
pub(super) struct SpanForces {
    leads: Leads,
    members: Vec<MemberForces>,
    /// Member and point of each evaluation point, in the order of the beams.
    points: Vec<(usize, usize)>,
    row: Vec<f64>,
}

/// The table of a blade or line of beams.
#[derive(Debug)]
struct MemberForces {
    /// Beginning of the endings of its files.
    ending: String,
    rows: CsvRows,
    /// Arc position of each point along the undeformed line \[m\].
    arcs: Vec<f64>,
    /// The internal force at each point at the present instant \[N, N m\].
    forces: Vec<Vector6<f64>>,
    envelope: Envelope,
}

impl SpanForces {
    /// Begins the tables `NAME.ANALYSIS.MEMBER.forces.csv` of the members of `structure`; the tables of
    /// a run that continues from `time` \[s\], their first column, are kept up to there.
    ///
    /// # Errors
    /// A table that cannot be written, or has other columns.
    pub fn new(
        structure: &Structure,
        (results, analysis): (&Results<'_>, &str),
        leads: Leads,
        time: Option<f64>,
    ) -> Result<Self, RunFileProblem> {
        let mut points = vec![(0, 0); 2 * structure.beams.len()];
        let mut members = Vec::new();
        let endings = endings(&structure.members);
        for (number, (member, ending)) in structure.members.iter().zip(endings).enumerate() {
            let mut arcs = Vec::new();
            for (index, &beam) in member.beams.iter().enumerate() {
                for (k, xi) in EVALUATION_POINTS.into_iter().enumerate() {
                    points[2 * beam + k] = (number, arcs.len());
                    arcs.push(structure.arc_position(member, index, xi));
                }
            }
            let path = results.path(&format!("{analysis}.{ending}.{FORCES}"));
            let headings = headings(leads);
            let mut envelope = Envelope::new(arcs.len());
            let rows = match time {
                None => CsvRows::create(&path, &headings)?,
                Some(time) => {
                    let rows = CsvRows::resume(&path, &headings, time)?;
                    envelope.add_table(&rows.content()?, leads.len());
                    rows
                }
            };
            members.push(MemberForces {
                ending: format!("{analysis}.{ending}"),
                rows,
                forces: vec![Vector6::zeros(); arcs.len()],
                arcs,
                envelope,
            });
        }
        Ok(Self {
            leads,
            members,
            points,
            row: Vec::with_capacity(leads.len() + 1 + COMPONENTS.len()),
        })
    }

    /// Removes the tables of earlier runs.
    pub fn remove_files(results: &Results<'_>, analysis: &str) {
        for ending in [FORCES, EXTREMES, ENVELOPE] {
            let (first, last) = (format!("{analysis}."), format!(".{ending}"));
            // names of members have no dot
            results.remove_between(&first, &last, |member| !member.contains('.'));
        }
    }

    /// Writes an instant, given by the numbers of `lead`: the sections of all beams in their order.
    /// Allocates nothing after the first instant.
    ///
    /// # Errors
    /// A table that cannot be written.
    pub fn add(&mut self, lead: &[f64], sections: &[SectionState]) -> Result<(), RunFileProblem> {
        for (section, (member, point)) in sections.iter().zip(&self.points) {
            self.members[*member].forces[*point] = section.internal_force;
        }
        for member in &mut self.members {
            for (point, (force, arc)) in member.forces.iter().zip(&member.arcs).enumerate() {
                self.row.clear();
                self.row.extend_from_slice(lead);
                self.row.push(*arc);
                self.row.extend(force.iter());
                member.rows.add(&self.row);
                member.envelope.add(point, lead, force);
            }
            member.rows.write_added()?;
        }
        Ok(())
    }

    /// Writes the envelopes and the instants of their extremes, and lists all tables.
    ///
    /// # Errors
    /// A table that cannot be written.
    pub fn finish(&self, results: &mut Results<'_>) -> Result<(), RunFileProblem> {
        let columns = COMPONENTS.map(|(name, unit)| format!("{name} [{unit}]"));
        let leads = self
            .leads
            .iter()
            .map(|(name, unit)| format!("at_{name} [{unit}]"));
        let leads: Vec<_> = leads.collect();
        let heading = format!("case,arc [m],{},{}", columns.join(","), leads.join(","));
        for member in &self.members {
            results.written.files.push(member.rows.file().to_owned());
            let rows = member.envelope.rows().map(|row| {
                let mut cells = vec![row.case, number(member.arcs[row.point])];
                cells.extend(numbers(row.force));
                cells.extend(numbers(&row.lead[..self.leads.len()]));
                cells
            });
            let envelope = csv_text(&heading, rows);
            let extremes = member.extremes(self.leads.len())?;
            results.text(&format!("{}.{EXTREMES}", member.ending), &extremes)?;
            results.text(&format!("{}.{ENVELOPE}", member.ending), &envelope)?;
        }
        Ok(())
    }
}

impl MemberForces {
    /// The table of forces without the instants that have no extreme.
    fn extremes(&self, leads: usize) -> Result<String, RunFileProblem> {
        let instants = self.envelope.instants();
        let (mut text, mut before, mut is_extreme) = (String::new(), String::new(), true);
        self.rows.each_line(&mut |line| {
            let end = line.match_indices(',').nth(leads - 1).map(|found| found.0);
            let of_line = &line[..end.unwrap_or(line.len())];
            // The points of an instant follow each other.
            if of_line != before {
                before.clear();
                before.push_str(of_line);
                let numbers = of_line.split(',').map(str::parse::<f64>);
                let numbers: Result<Vec<_>, _> = numbers.collect();
                // The heading has no numbers.
                is_extreme = numbers.map_or(true, |numbers| {
                    let mut lead = [0.0; LEADS];
                    lead.iter_mut()
                        .zip(numbers)
                        .for_each(|(own, number)| *own = number);
                    instants
                        .binary_search_by(|known| compared(known, &lead))
                        .is_ok()
                });
            }
            if is_extreme {
                text.push_str(line);
                text.push('\n');
            }
        })?;
        Ok(text)
    }
}

/// Headings of a table of forces.
fn headings(leads: Leads) -> Vec<Heading> {
    let arc = [("arc", "m")];
    let columns = leads.iter().chain(&arc).chain(&COMPONENTS);
    let heading = |(name, unit): &(&str, &str)| Heading {
        name: (*name).to_owned(),
        unit: (*unit).to_owned(),
        words: String::new(),
    };
    columns.map(heading).collect()
}

/// Names of members as parts of names of files: letters, digits, `_` and `-`, each once.
fn endings(members: &[Member]) -> Vec<String> {
    let mut endings: Vec<String> = Vec::new();
    for member in members {
        let letter = |c: char| match c {
            '-' => '-',
            c if c.is_alphanumeric() => c,
            _ => '_',
        };
        let name: String = member.name.chars().map(letter).collect();
        let mut ending = name.clone();
        let mut count = 1;
        while endings.contains(&ending) {
            count += 1;
            ending = format!("{name}_{count}");
        }
        endings.push(ending);
    }
    endings
}
