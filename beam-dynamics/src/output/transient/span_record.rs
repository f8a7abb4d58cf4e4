//! The internal forces along blades and lines of beams at the rows of a run in time.

use super::RunFileProblem;
use crate::case::Model;
use crate::elements::Observations;
use crate::output::folder::Results;
use crate::output::span_forces::{Leads, SpanForces};
use crate::output::structure::Structure;
use crate::result::AcceptedStep;

/// The column that distinguishes instants.
const LEADS: Leads = &[("time", "s")];

/// Tables of forces of a run.
#[derive(Debug)]
pub(super) struct SpanRecord<'a> {
    model: &'a Model,
    tables: SpanForces,
    /// Elements with sections; `None` before the first instant.
    beams: Option<Vec<usize>>,
    observed: Observations,
}

impl<'a> SpanRecord<'a> {
    /// Begins the tables of an analysis, or continues the tables of a run from `time` \[s\].
    pub fn new(
        model: &'a Model,
        files: (&Results<'_>, &str),
        time: Option<f64>,
    ) -> Result<Self, RunFileProblem> {
        let structure = Structure::new(model.system.nodes(), &model.beams, &model.blades);
        Ok(Self {
            model,
            tables: SpanForces::new(&structure, files, LEADS, time)?,
            beams: None,
            observed: Observations::default(),
        })
    }

    /// Writes the forces of a row. Only beams are evaluated.
    pub fn add(&mut self, accepted: &AcceptedStep<'_>) -> Result<(), RunFileProblem> {
        let system = &self.model.system;
        let (state, conditions) = (accepted.state, accepted.conditions);
        if self.beams.is_none() {
            let mut observed = Observations::default();
            let mut has_sections = |index: &usize| {
                observed.sections.clear();
                system.observe_element(*index, state, conditions, &mut observed);
                !observed.sections.is_empty()
            };
            let elements = 0..system.elements().count();
            self.beams = Some(elements.filter(&mut has_sections).collect());
        }
        self.observed.sections.clear();
        for &beam in self.beams.iter().flatten() {
            system.observe_element(beam, state, conditions, &mut self.observed);
        }
        self.tables.add(&[accepted.time], &self.observed.sections)
    }

    /// Writes the envelopes, and lists all tables.
    pub fn write(&self, results: &mut Results<'_>) -> Result<(), RunFileProblem> {
        self.tables.finish(results)
    }
}
