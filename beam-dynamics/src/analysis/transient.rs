//! Motion in time: initialization, then step after step, each passed to a recorder.
//!
//! 1. Positions and velocities are changed to fulfill the constraints, with the smallest
//!    weighted change; momenta, their rates and the multipliers follow.
//! 2. The integrator makes one accepted step after the other, to the last instant.
//! 3. The reason for an early end is reported with the worst equation and the likely cause.

use shared_geom::units::rounded;

use super::operation::Operation;
use super::stall::air_at;
use crate::assembly::Slack;
use crate::assembly::massless;
use crate::assembly::redundancy::Redundant;
use crate::case::{Model, TransientSettings};
use crate::integrator::{Corner, Integrator, Progress, Stepping};
use crate::model::{Conditions, NODE_UNKNOWNS, State};
use crate::result::{AcceptedStep, Effort, Recorder, Snapshot};

mod change;
mod corner;
mod diagnosis;
mod dummy;
mod effort;
mod energy;
mod failure;
mod gravity;
mod multibody;
mod placing;
mod rates;
mod redundant;
mod saddle;
mod scalars;
mod shape;
mod singular;
mod snapshot;
mod start;
mod turning;

#[cfg(test)]
mod tests;

pub use change::{Changed, StartChange};
pub use energy::EnergyBalance;
pub use failure::{StepTrouble, TransientFailure};
pub use snapshot::difference;
pub use turning::LargestTurn;

pub(in crate::analysis) use diagnosis::in_wake;
use diagnosis::trouble;
use effort::effort;
use energy::{EnergyWatch, Finding};
pub(in crate::analysis) use multibody::Multibody;
pub(in crate::analysis) use rates::consistent_rates;
pub(in crate::analysis) use redundant::independent;
pub(in crate::analysis) use scalars::begin_at_rest;
use singular::Passed;
pub(in crate::analysis) use start::{Started, start};
use turning::{Turns, farthest_turn};

/// Outcome of a run in time; its steps are passed to the recorder.
#[derive(Debug)]
pub struct TransientOutcome {
    /// Steps, iterations, and times by phase.
    pub effort: Effort,
    /// Time reached [s].
    pub time: f64,
    /// Every change of the given positions and velocities by initialization.
    pub changes: Vec<StartChange>,
    /// Remarks: doubtful settings, the kind of start.
    pub remarks: Vec<String>,
    /// Energy input, and energy balance.
    pub energy: EnergyBalance,
    /// The largest rotation of a node in the steps of this run; `None` if nothing turned.
    pub turned: Option<LargestTurn>,
    /// Reason if the run ended early.
    pub failure: Option<TransientFailure>,
}

/// A run in progress.
struct Run<'a> {
    model: &'a Model,
    settings: &'a TransientSettings,
    dae: Multibody<'a>,
    integrator: Integrator,
    step: usize,
    /// Length [s] and iterations of the latest step.
    latest: (f64, usize),
    output_time: f64,
    /// Start of the run, as if the earlier parts had been made immediately before this one [s].
    began: f64,
    /// The first node that turned far in a step, as text.
    far_turn: Option<String>,
    /// Singular positions.
    passed: Passed,
    /// Energy input.
    energy: EnergyWatch,
    /// Rotations of the nodes.
    turns: Turns,
    /// Redundant constraints.
    redundant: &'a [Redundant],
}

/// Runs `model` in time as defined by `settings`, from its start or from the snapshot `resumed`,
/// and passes every accepted step to `recorder`; `clock` returns seconds \[s\].
///
/// A continued run does not pass its first state again.
pub fn transient(
    model: &Model,
    settings: &TransientSettings,
    resumed: Option<&Snapshot>,
    recorder: &mut dyn Recorder,
    clock: &dyn Fn() -> f64,
) -> TransientOutcome {
    let began = clock();
    let mut outcome = TransientOutcome {
        effort: Effort::default(),
        time: resumed.map_or(settings.from, |snapshot| snapshot.progress.time),
        changes: Vec::new(),
        remarks: doubts(model, settings),
        energy: EnergyBalance::default(),
        turned: None,
        failure: None,
    };
    let shared = match redundant::independent(model, settings) {
        Ok(shared) => shared,
        Err(failure) => {
            outcome.failure = Some(failure);
            outcome.effort.total_time = clock() - began;
            return outcome;
        }
    };
    let (model, redundant) = match &shared {
        None => (model, &[][..]),
        Some(shared) => {
            outcome.remarks.extend(shared.remarks());
            (&shared.model, &shared.redundant[..])
        }
    };
    let run = match resumed {
        None => begin(model, settings, &mut outcome),
        Some(snapshot) => resume(model, settings, snapshot),
    };
    let mut run = match run {
        Ok(run) => run,
        Err(failure) => {
            outcome.failure = Some(failure);
            outcome.effort.total_time = clock() - began;
            return outcome;
        }
    };
    run.began = began - resumed.map_or(0.0, |snapshot| snapshot.total_time);
    run.redundant = redundant;
    let mut operation = Operation::default();
    run.note_operation(&mut operation);
    outcome.failure = run.go(resumed.is_none(), recorder, clock).err();
    run.note_operation(&mut operation);
    outcome.remarks.extend(operation.lasting());
    let is_reported = matches!(outcome.failure, Some(TransientFailure::Step(_)));
    outcome.remarks.extend(run.remarks(is_reported));
    outcome.energy = run.energy.balance();
    outcome.turned = run.turns.largest(&model.system);
    outcome.time = run.integrator.time();
    outcome.effort = effort(run.integrator.counters(), run.output_time);
    outcome.effort.total_time = clock() - run.began;
    outcome
}

/// Finds jumps of driven positions ahead: no motion can follow them.
///
/// # Errors
/// [`TransientFailure::Jump`].
pub fn check_drives(model: &Model, settings: &TransientSettings) -> Result<(), TransientFailure> {
    corner::check_positions(model, [settings.from, settings.to])
}

/// Doubtful settings of a run.
fn doubts(model: &Model, settings: &TransientSettings) -> Vec<String> {
    let has_multipliers = model.system.numbering().multipliers() > 0;
    let doubt = settings.scheme.warning(has_multipliers);
    doubt.map(str::to_owned).into_iter().collect()
}

/// A run at its first instant.
fn begin<'a>(
    model: &'a Model,
    settings: &'a TransientSettings,
    outcome: &mut TransientOutcome,
) -> Result<Run<'a>, TransientFailure> {
    if let Some(node) = massless::find(&model.system).into_iter().next() {
        return Err(node.into());
    }
    check_drives(model, settings)?;
    let Started {
        state,
        changes,
        remarks,
    } = start(model, settings)?;
    outcome.changes = changes;
    outcome.remarks.extend(remarks);
    run(model, settings, [state.clone(), state])
}

/// A run with its accepted states, the latest first, at the first instant.
fn run<'a>(
    model: &'a Model,
    settings: &'a TransientSettings,
    states: [State; 2],
) -> Result<Run<'a>, TransientFailure> {
    let stages = settings.scheme.formula(1.0).stages;
    let mut dae = Multibody::new(model, states, (stages, settings.simplified_jacobian));
    if matches!(settings.stepping, Stepping::Variable(_)) {
        dae.pace = model.pace([settings.from, settings.to]);
    }
    let TransientSettings {
        scheme,
        stepping,
        newton,
        from,
        ..
    } = *settings;
    let energy = EnergyWatch::new(model, settings, &dae, &model.conditions_at(from));
    let integrator = Integrator::new(&dae, scheme, stepping, newton, from);
    Ok(Run {
        model,
        settings,
        dae,
        integrator,
        step: 0,
        latest: (0.0, 0),
        output_time: 0.0,
        began: 0.0,
        far_turn: None,
        passed: Passed::default(),
        energy,
        turns: Turns::new(model.system.nodes().len()),
        redundant: &[],
    })
}

/// A run at the time of a snapshot.
fn resume<'a>(
    model: &'a Model,
    settings: &'a TransientSettings,
    snapshot: &Snapshot,
) -> Result<Run<'a>, TransientFailure> {
    let states = snapshot::states(model, snapshot)?;
    let mut run = run(model, settings, states)?;
    run.integrator.restore(&snapshot.progress);
    run.dae.begin_step(snapshot.progress.length);
    run.step = snapshot.step;
    run.energy = EnergyWatch::new(model, settings, &run.dae, &run.conditions());
    run.output_time = snapshot.output_time;
    Ok(run)
}

impl Run<'_> {
    /// Steps to the last instant; the first state is passed to the recorder if `report_start`.
    fn go(
        &mut self,
        report_start: bool,
        recorder: &mut dyn Recorder,
        clock: &dyn Fn() -> f64,
    ) -> Result<(), TransientFailure> {
        if report_start {
            self.report(&self.conditions(), recorder, clock)?;
        }
        let mut before = self.integrator.progress();
        while self.integrator.time() < self.settings.to {
            self.integrator.progress_into(&mut before);
            let began = self.integrator.corner();
            let to = self.settings.to;
            let stepped = match self.integrator.step(&mut self.dae, to, clock) {
                Ok(stepped) => stepped,
                Err(failure) => {
                    self.keep_last(before, recorder, clock);
                    self.end_energy();
                    return Err(self.trouble(failure));
                }
            };
            self.step += 1;
            self.latest = (stepped.length, stepped.iterations);
            let conditions = self.conditions();
            let reached = [stepped.time, stepped.length];
            self.energy.step(&self.dae, (began, &conditions), reached);
            if let Some(corner) = self.integrator.corner()
                && let Err(failure) = self.check_corner(&corner)
            {
                // The state just before it is valid.
                self.report(&conditions, recorder, clock)?;
                return Err(failure);
            }
            self.check_attitudes(&conditions)?;
            self.check_springs(before.time, &conditions)?;
            self.watch_turns(stepped.length);
            let at = (stepped.time, stepped.length);
            self.turns.add(self.dae.states(), at);
            let system = &self.model.system;
            self.passed
                .watch(system, self.dae.states(), &mut self.integrator);
            self.check_redundant()?;
            self.report(&conditions, recorder, clock)?;
        }
        self.end_energy();
        Ok(())
    }

    /// Adds the latest state to the operating points.
    fn note_operation(&self, operation: &mut Operation) {
        let air = air_at(&self.model.system, self.dae.state(), &self.conditions());
        let at = format!("t = {} s", rounded(self.integrator.time()));
        operation.add(&at, &air, self.model.words);
    }

    /// Checks the energy of the latest state.
    fn end_energy(&mut self) {
        let (conditions, time) = (self.conditions(), self.integrator.time());
        self.energy.end(&self.dae, &conditions, time);
    }

    /// Unexplained gain of energy, if there is any.
    fn gained(&self) -> Option<Finding> {
        let turns_far = self.far_turn.is_some();
        self.energy.finding(self.model, self.settings, turns_far)
    }

    /// Remarks on the run; the gain of energy only if the failure does not contain it.
    fn remarks(&mut self, is_reported: bool) -> Vec<String> {
        let gained = self.gained().filter(|_| !is_reported);
        let mut remarks: Vec<_> = self.dae.impulses.remarks().collect();
        remarks.extend(self.far_turn.take());
        remarks.extend(gained.map(|gained| gained.to_string()));
        remarks.extend(self.passed.remarks());
        remarks
    }

    /// Checks that no driven position jumps at a corner, and that no drives contradict each other
    /// just after it.
    fn check_corner(&self, corner: &Corner) -> Result<(), TransientFailure> {
        corner::check_corner(self.model, self.dae.state(), corner)?;
        if corner.after >= self.settings.to {
            return Ok(());
        }
        let after = self.model.conditions_at(corner.after);
        match self.contradicting(&after) {
            None => Ok(()),
            Some(constraints) => Err(TransientFailure::Contradicting {
                constraints,
                time: corner.after,
            }),
        }
    }

    /// Constraints, as text, whose drives contradict other drives at the latest state.
    fn contradicting(&self, conditions: &Conditions) -> Option<String> {
        let at = (self.dae.state(), conditions);
        redundant::contradicting(&self.model.system, self.redundant, at)
    }

    /// Conditions at the latest accepted state; at a corner the conditions before it, since the
    /// whole state belongs to the motion before it.
    fn conditions(&self) -> Conditions {
        let corner = self.integrator.corner().map(|corner| corner.before);
        let time = self.integrator.time();
        self.model
            .conditions_at(corner.map_or(time, |before| before.min(time)))
    }

    /// Checks that no driven rotation settled half a turn away from its prescribed value.
    fn check_attitudes(&self, conditions: &Conditions) -> Result<(), TransientFailure> {
        let system = &self.model.system;
        match system.turned_over(self.dae.state(), conditions) {
            None => Ok(()),
            Some(element) => Err(TransientFailure::TurnedOver {
                constraint: format!("\"{}\"", element.label()),
                time: self.integrator.time(),
            }),
        }
    }

    /// Checks that no spring has turned by half a turn since the time `before` \[s\].
    fn check_springs(&self, before: f64, now: &Conditions) -> Result<(), TransientFailure> {
        let states = self.dae.states();
        let then = self.model.conditions_at(before);
        let system = &self.model.system;
        match system.wound((&states[1], &then), (&states[0], now)) {
            None => Ok(()),
            Some(element) => Err(TransientFailure::Wound {
                spring: element.label().to_owned(),
                time: self.integrator.time(),
            }),
        }
    }

    /// Notes the first node that turns far in a step of `length` \[s\].
    fn watch_turns(&mut self, length: f64) {
        if self.far_turn.is_some() {
            return;
        }
        let turns = self.dae.turns().map(|speed| length * speed);
        let farthest = farthest_turn(&self.settings.scheme);
        let far = turns.enumerate().find(|(_, turn)| *turn > farthest);
        let time = self.integrator.time();
        self.far_turn = far.map(|(node, turn)| {
            let label = &self.model.system.nodes()[node].label;
            let time = rounded(time);
            format!(
                "node \"{label}\" turns by {turn:.2} rad in a step at t = {time} s: take steps of \
                 {farthest:.2} rad at most, the error of rotations grows with the square"
            )
        });
    }

    /// Checks that redundant constraints are still redundant.
    fn check_redundant(&self) -> Result<(), TransientFailure> {
        let broken = (self.dae.slack()).filter(|slack| redundant::is_broken(slack));
        let Some(&Slack {
            constraint, value, ..
        }) = broken
        else {
            return Ok(());
        };
        let time = self.integrator.time();
        if let Some(constraints) = self.contradicting(&self.conditions()) {
            return Err(TransientFailure::Contradicting { constraints, time });
        }
        let system = &self.model.system;
        let first = NODE_UNKNOWNS * system.nodes().len();
        let of_it = |one: &&Redundant| one.group().contains(&constraint);
        let found = self.redundant.iter().find(of_it);
        let found = found.or(self.redundant.first());
        Err(TransientFailure::Broken {
            constraint: found.map_or_else(String::new, ToString::to_string),
            time,
            value,
            unit: system.equation(first + constraint).unit.into_owned(),
        })
    }

    /// Passes the latest accepted state to the recorder, with the `progress` of the integrator: the
    /// step after it failed.
    fn keep_last(&self, progress: Progress, recorder: &mut dyn Recorder, clock: &dyn Fn() -> f64) {
        let conditions = self.model.conditions_at(progress.time);
        let accepted_step = self.accepted_step(&conditions);
        let times = [self.output_time, clock() - self.began];
        let steps = (self.step, progress);
        let snapshot = snapshot::take(self.model, self.dae.states(), steps, times);
        // Failures of writing are reported with the files.
        let _ = recorder.stopped(&accepted_step, &snapshot);
    }

    /// The latest accepted state.
    fn accepted_step<'a>(&'a self, conditions: &'a Conditions) -> AcceptedStep<'a> {
        let (length, iterations) = self.latest;
        AcceptedStep {
            step: self.step,
            time: self.integrator.time(),
            length,
            iterations,
            state: self.dae.state(),
            conditions,
        }
    }

    /// Passes the latest state to the recorder.
    fn report(
        &mut self,
        conditions: &Conditions,
        recorder: &mut dyn Recorder,
        clock: &dyn Fn() -> f64,
    ) -> Result<(), TransientFailure> {
        let began = clock();
        let time = self.integrator.time();
        let accepted_step = self.accepted_step(conditions);
        let mut goes_on = recorder.record(&accepted_step);
        let is_wanted = goes_on && recorder.wants_snapshot(&accepted_step);
        if is_wanted {
            let steps = (self.step, self.integrator.snapshot());
            let now = clock();
            let times = [self.output_time + now - began, now - self.began];
            let snapshot = snapshot::take(self.model, self.dae.states(), steps, times);
            goes_on = recorder.keep(&snapshot);
        }
        self.output_time += clock() - began;
        if goes_on {
            Ok(())
        } else {
            Err(TransientFailure::Recorder { time })
        }
    }

    fn trouble(&self, failure: crate::integrator::StepFailure) -> TransientFailure {
        let requested = (self.model, self.settings);
        let trouble = trouble(failure, requested, (&self.dae, self.gained()));
        TransientFailure::Step(Box::new(trouble))
    }
}
