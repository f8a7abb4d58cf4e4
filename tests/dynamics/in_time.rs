//! Runs in time of cases, and the tables compared with them.

use std::path::Path;

use beam_dynamics::analysis::transient::{TransientOutcome, transient};
use beam_dynamics::case::{Model, TransientSettings};
use beam_dynamics::elements::Energy;
use beam_dynamics::model::{NodeMotion, State};
use beam_dynamics::result::{AcceptedStep, Recorder};
use nalgebra::Vector3;

use crate::case_files::Case;

/// Steps taken, as far as they are kept.
#[derive(Default)]
struct Kept {
    /// Number of steps between two kept ones.
    every: usize,
    instants: Vec<(f64, State)>,
}

impl Recorder for Kept {
    fn record(&mut self, accepted: &AcceptedStep<'_>) -> bool {
        if accepted.step.is_multiple_of(self.every) {
            self.instants.push((accepted.time, accepted.state.clone()));
        }
        true
    }
}

/// The remark on an unexplained gain of energy.
pub fn gain(outcome: &TransientOutcome) -> Option<String> {
    let failure = outcome.failure.iter().map(ToString::to_string);
    let mut reported = outcome.remarks.iter().cloned().chain(failure);
    reported.find(|text| text.contains("the energy grows by more than the input"))
}

/// A run in time: the start, and steps after it.
pub struct Run {
    pub model: Model,
    pub instants: Vec<(f64, State)>,
    pub outcome: TransientOutcome,
}

impl Run {
    /// The run requested by a file of a case, with a change of the settings; one of several steps
    /// is kept. The run may fail.
    pub fn attempt(
        case: &str,
        file: &str,
        every: usize,
        change: impl FnOnce(&mut TransientSettings),
    ) -> Self {
        Self::of_file(&Case::new(case).path(file), every, change)
    }

    /// The same of any file.
    pub fn of_file(path: &Path, every: usize, change: impl FnOnce(&mut TransientSettings)) -> Self {
        let input =
            beam_dynamics::input::read(path).unwrap_or_else(|problems| panic!("{problems}"));
        let mut settings = input.transient.unwrap();
        change(&mut settings);
        Self::of(input.model, &settings, every)
    }

    /// The run of a model, which must not gain unexplained energy.
    pub fn of(model: Model, settings: &TransientSettings, every: usize) -> Self {
        let run = Self::of_any(model, settings, every);
        assert_eq!(gain(&run.outcome), None);
        run
    }

    /// The run of a model.
    pub fn of_any(model: Model, settings: &TransientSettings, every: usize) -> Self {
        let mut kept = Kept {
            every,
            instants: Vec::new(),
        };
        let outcome = transient(&model, settings, None, &mut kept, &|| 0.0);
        Self {
            model,
            instants: kept.instants,
            outcome,
        }
    }

    /// The run, which must reach its end.
    pub fn new(
        case: &str,
        file: &str,
        every: usize,
        change: impl FnOnce(&mut TransientSettings),
    ) -> Self {
        let run = Self::attempt(case, file, every, change);
        run.check_end();
        run
    }

    /// Checks that the run reached its end.
    pub fn check_end(&self) {
        let failure = self.outcome.failure.as_ref();
        assert!(failure.is_none(), "{}", failure.unwrap());
    }

    /// Index of the node called `name`.
    pub fn node(&self, name: &str) -> usize {
        let nodes = self.model.system.nodes();
        let found = nodes.iter().position(|node| node.label == name);
        found.unwrap_or_else(|| panic!("no node \"{name}\""))
    }

    /// The state at `time`, at which a step must end.
    pub fn at(&self, time: f64) -> &State {
        let mut instants = self.instants.iter();
        let found = instants.find(|(t, _)| (t - time).abs() < 1e-9 * (1.0 + time));
        &found.unwrap_or_else(|| panic!("no step at {time} s")).1
    }

    /// Motion of a node at `time`.
    pub fn motion(&self, name: &str, time: f64) -> &NodeMotion {
        &self.at(time).nodes[self.node(name)]
    }

    /// Force and moment of the joint called `joint` on the node called `name`, in the
    /// model's axes.
    pub fn reaction(&self, joint: &str, name: &str, time: f64) -> [Vector3<f64>; 2] {
        self.reaction_in(self.at(time), time, joint, self.node(name))
    }

    /// The same at a given state.
    pub fn reaction_in(
        &self,
        state: &State,
        time: f64,
        joint: &str,
        node: usize,
    ) -> [Vector3<f64>; 2] {
        let observed = self
            .model
            .system
            .observe(state, &self.model.conditions_at(time));
        let mut reactions = observed.reactions.iter();
        let found = reactions.find(|reaction| reaction.joint == joint && reaction.node == node);
        let found = found.unwrap_or_else(|| panic!("no reaction of \"{joint}\""));
        [found.force, found.moment]
    }

    /// Energy of the whole model at a state.
    pub fn energy(&self, state: &State, time: f64) -> Energy {
        self.model
            .system
            .energy(state, &self.model.conditions_at(time))
    }
}

/// Momentum of all nodes and angular momentum about the origin.
pub fn momenta(state: &State) -> [Vector3<f64>; 2] {
    let momentum = state.nodes.iter().map(|node| node.momentum).sum();
    let about_origin =
        |node: &NodeMotion| node.angular_momentum + node.position.cross(&node.momentum);
    [momentum, state.nodes.iter().map(about_origin).sum()]
}

/// A table of the references, by columns.
pub struct Table {
    header: Vec<String>,
    pub rows: Vec<Vec<f64>>,
}

impl Table {
    /// `tests/reference/dynamics/<file>`.
    pub fn new(file: &str) -> Self {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/reference/dynamics");
        let mut reader = csv::Reader::from_path(folder.join(file)).unwrap();
        let header = reader.headers().unwrap();
        let header = header.iter().map(str::to_owned).collect();
        let rows = reader.records().map(|row| {
            let row = row.unwrap();
            row.iter().map(|cell| cell.parse().unwrap()).collect()
        });
        let rows = rows.collect();
        Self { header, rows }
    }

    /// Index of the column called `name`.
    pub fn column(&self, name: &str) -> usize {
        self.header.iter().position(|word| word == name).unwrap()
    }

    /// The three columns beginning with the given one.
    pub fn vector(&self, row: &[f64], first: &str) -> Vector3<f64> {
        let at = self.column(first);
        Vector3::new(row[at], row[at + 1], row[at + 2])
    }
}

/// A file of the references as JSON.
pub fn json(file: &str) -> serde_json::Value {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/reference/dynamics");
    serde_json::from_str(&std::fs::read_to_string(folder.join(file)).unwrap()).unwrap()
}

/// The numbers of a list in JSON.
pub fn numbers(list: &serde_json::Value) -> Vec<f64> {
    let list = list.as_array().unwrap().iter();
    list.map(|number| number.as_f64().unwrap()).collect()
}
