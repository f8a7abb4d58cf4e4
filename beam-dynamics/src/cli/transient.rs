//! `transient`: runs each model in time, writes results during the run, and reports the
//! effort.

use std::path::{Path, PathBuf};
use std::time::Instant;

use shared_geom::error::{Explain, counted};

use super::arguments::Results;
use super::blade_options::BladeOptions;
use super::progress::Progress;
use super::terminal::Terminal;
use super::{
    BladeAlone, DONE, MissingTable, NOT_REACHED, WRONG_INPUT, files, in_folder, read_with_locations,
};
use crate::analysis::transient::{
    TransientFailure, TransientOutcome, check_drives, difference, transient,
};
use crate::case::TransientSettings;
use crate::input::{Input, is_blade_file, short_number};
use crate::integrator::{Scheme, Stepping};
use crate::output::{
    ResultLocation, RunFileProblem, RunFiles, effort_text, not_drawn_text, read_snapshot,
};
use crate::result::{AcceptedStep, Recorder, Snapshot};

/// The table that defines a run in time.
const TABLE: &str = "transient";
/// Number of changes at the start that are listed.
const MOST_CHANGES: usize = 60;

/// A restart file that does not fit.
#[derive(Debug, thiserror::Error)]
enum RestartProblem {
    /// One restart file for several models.
    #[error("--restart continues one file, but {files} are given")]
    ManyFiles { files: usize },
    /// A state of other nodes or joints.
    #[error("\"{file}\" is the state of another model: {difference}")]
    OtherModel { file: String, difference: String },
    /// The run ends before the state.
    #[error("\"{file}\" is at {at} s, after the end of the run at {to} s")]
    AfterEnd { file: String, at: f64, to: f64 },
}

impl Explain for RestartProblem {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::ManyFiles { .. } => "run them one by one",
            Self::OtherModel { .. } => {
                "nodes, elements, laws, drives, gravity and hub must be the same as in the \
                 run that wrote it; \"to\", \"step\", \"scheme\" and [output] may differ"
            }
            Self::AfterEnd { .. } => {
                "give [transient] a \"to\" that is not before the state: a later one continues the run"
            }
        };
        Some(text.to_owned())
    }
}

/// `transient FILE...`
pub(super) fn transient_of_files(
    paths: &[PathBuf],
    results: &Results,
    restart: Option<&Path>,
    terminal: &mut Terminal<'_>,
) -> u8 {
    if restart.is_some() && paths.len() > 1 {
        let files = paths.len();
        terminal.report(&RestartProblem::ManyFiles { files });
        return WRONG_INPUT;
    }
    let Some((inputs, locations)) =
        read_with_locations(paths, results, &BladeOptions::default(), terminal)
    else {
        return WRONG_INPUT;
    };
    for (path, input) in paths.iter().zip(&inputs) {
        if input.transient.is_none() {
            report_missing_table(path, terminal);
        }
    }
    let requested: Vec<_> = inputs
        .iter()
        .zip(&locations)
        .filter_map(|(input, location)| Some((input, input.transient.as_ref()?, location)))
        .collect();
    if requested.len() < inputs.len() {
        return WRONG_INPUT;
    }
    files::worst_of(
        &requested,
        terminal,
        |(input, settings, location), terminal| {
            let resumed = match restart.map(|path| resumed(path, input, settings, terminal)) {
                Some(None) => return WRONG_INPUT,
                Some(Some(snapshot)) => Some(snapshot),
                None => None,
            };
            in_folder(location, TABLE, terminal, |terminal| {
                run((input, settings), resumed.as_ref(), location, terminal)
            })
        },
    )
}

fn report_missing_table(path: &Path, terminal: &mut Terminal<'_>) {
    let (file, table) = (path.display().to_string(), TABLE);
    if is_blade_file(path) {
        terminal.report(&BladeAlone { file, table })
    } else {
        terminal.report(&MissingTable {
            file,
            table,
            example: "to = 1 and step = \"1 ms\"",
        })
    }
}

/// The state at `path` from which the run continues; reports a state that does not fit.
fn resumed(
    path: &Path,
    input: &Input,
    settings: &TransientSettings,
    terminal: &mut Terminal<'_>,
) -> Option<Snapshot> {
    let snapshot = match read_snapshot(path) {
        Ok(snapshot) => snapshot,
        Err(problem) => {
            terminal.report(&problem);
            return None;
        }
    };
    let file = path.display().to_string();
    let problem = match other_model(&snapshot, input) {
        Some(difference) => RestartProblem::OtherModel { file, difference },
        None if snapshot.progress.time > settings.to => RestartProblem::AfterEnd {
            file,
            at: snapshot.progress.time,
            to: settings.to,
        },
        None => return Some(snapshot),
    };
    terminal.report(&problem);
    None
}

/// Difference between a state and the model. Another law of the same joints changes only
/// the fingerprint; a model whose redundant constraints were removed has other constraints.
fn other_model(snapshot: &Snapshot, input: &Input) -> Option<String> {
    if snapshot.model == input.model.fingerprint() {
        return None;
    }
    let reported = difference(&input.model, snapshot);
    Some(reported.unwrap_or_else(|| {
        "its nodes have the same names, but some element, law, drive, gravity or the hub \
         differs"
            .to_owned()
    }))
}

/// Runs one model, writes its results and prints the report.
fn run(
    (input, settings): (&Input, &TransientSettings),
    resumed: Option<&Snapshot>,
    location @ ResultLocation { name, .. }: &ResultLocation,
    terminal: &mut Terminal<'_>,
) -> u8 {
    // Before anything is written: the input is wrong.
    if let Err(failure) = check_drives(&input.model, settings) {
        report(input, (name, &failure), "", terminal);
        return WRONG_INPUT;
    }
    let files = match RunFiles::new(&input.model, &input.output, location, resumed) {
        Ok(files) => files.until(settings.to),
        Err(problem) => {
            terminal.report(&problem);
            return match problem {
                RunFileProblem::Output(_) => NOT_REACHED,
                _ => WRONG_INPUT,
            };
        }
    };
    let head = heading(input, settings, resumed);
    terminal.show(&head);
    terminal.flush();
    let mut watched = Watched {
        files,
        progress: Progress::new(terminal.part()),
        from: settings.from,
        to: settings.to,
    };
    if let Some(snapshot) = resumed {
        watched.show(snapshot.progress.time);
        watched.progress.begin();
    }
    let start = Instant::now();
    let clock = || start.elapsed().as_secs_f64();
    let outcome = transient(&input.model, settings, resumed, &mut watched, &clock);
    watched.progress.finish();
    let text = outcome_text(input, settings, &outcome);
    terminal.remark(name, &[&input.remarks[..], &outcome.remarks].concat());
    terminal.show(&text);
    let (mut code, title) = (DONE, &input.model.name);
    if let (Some(failure), None) = (&outcome.failure, watched.files.problem()) {
        let written = watched.files.has_rows().then(|| {
            let end = short_number(outcome.time, 9);
            format!("; all up to {end} s is written")
        });
        let written = written.unwrap_or_default();
        report(input, (name, failure), &written, terminal);
        code = NOT_REACHED;
    }
    code.max(finish(watched.files, (title, &(head + &text)), terminal))
}

/// Reports a failure with the cards that it concerns, the remedy, and the part that is written.
fn report(
    input: &Input,
    (name, failure): (&str, &TransientFailure),
    written: &str,
    terminal: &mut Terminal<'_>,
) {
    terminal.report_text(&format!(
        "error: {name}: {failure}{}\n  help: {}{written}",
        cards_of(input, failure),
        failure.remedy()
    ));
}

/// Locations of the joints that a failure concerns.
fn cards_of(input: &Input, failure: &TransientFailure) -> String {
    let joints = failure.joints().into_iter();
    let locations = joints.filter_map(|joint| Some((input.joint_locations.get(joint)?, joint)));
    let lines = locations.map(|(location, joint)| format!("\n  {location}: \"{joint}\""));
    lines.collect()
}

/// Ends the files of a run and lists them.
fn finish(files: RunFiles<'_>, (title, text): (&str, &str), terminal: &mut Terminal<'_>) -> u8 {
    match files.finish(title, text) {
        Ok(written) => {
            terminal.show("\nWritten\n");
            for file in &written.files {
                terminal.show(&format!("  {}\n", file.display()));
            }
            terminal.show(&not_drawn_text(&written.not_drawn));
            DONE
        }
        Err(problem) => {
            terminal.report(&problem);
            NOT_REACHED
        }
    }
}

/// Summary printed before the run.
fn heading(input: &Input, settings: &TransientSettings, resumed: Option<&Snapshot>) -> String {
    let system = &input.model.system;
    let seconds = |time: f64| format!("{} s", short_number(time, 9));
    let start = match resumed {
        Some(snapshot) if snapshot.progress.time >= settings.to => format!(
            "is complete (step {}), writes its report and figures; from {}",
            snapshot.step,
            seconds(settings.from)
        ),
        Some(snapshot) => format!(
            "continues at {} (step {})",
            seconds(snapshot.progress.time),
            snapshot.step
        ),
        None => format!("from {}", seconds(settings.from)),
    };
    let steps = match settings.stepping {
        Stepping::Constant { step } => format!("steps of {}", seconds(step)),
        Stepping::Variable(control) => format!(
            "steps of {} to {}, tolerance {}",
            seconds(control.least),
            seconds(control.most),
            short_number(control.tolerance, 4)
        ),
    };
    format!(
        "{}: {start} to {}\n{}; {steps}\n{}, {}, {} of them multipliers\n",
        input.model.name,
        seconds(settings.to),
        scheme_words(settings.scheme),
        counted(system.nodes().len(), "node"),
        counted(system.numbering().unknowns(), "unknown"),
        system.numbering().multipliers()
    )
}

fn scheme_words(scheme: Scheme) -> String {
    match scheme {
        Scheme::ImplicitEuler => "implicit Euler".to_owned(),
        Scheme::CrankNicolson => "Crank-Nicolson".to_owned(),
        Scheme::Bdf2 => "backward differences of second order".to_owned(),
        Scheme::TwoStep { radius } => {
            format!("two steps, asymptotic radius {}", short_number(radius, 4))
        }
        Scheme::Cubic { radius } => format!(
            "two stages, cubic, asymptotic radius {}",
            short_number(radius, 4)
        ),
        Scheme::CubicGauss => "two stages, cubic, Gauss points".to_owned(),
        Scheme::Parabolic { zeta } => {
            format!("two stages, parabolic, zeta {}", short_number(zeta, 6))
        }
    }
}

/// Remarks, time reached, and effort.
fn outcome_text(input: &Input, settings: &TransientSettings, outcome: &TransientOutcome) -> String {
    let mut text = String::new();
    for remark in input.remarks.iter().chain(&outcome.remarks) {
        text.push_str(&format!("  remark: {remark}\n"));
    }
    if !outcome.changes.is_empty() {
        text.push_str("\nChanged at the start to fulfill the joints\n");
    }
    for change in outcome.changes.iter().take(MOST_CHANGES) {
        text.push_str(&format!("  {change}\n"));
    }
    if outcome.changes.len() > MOST_CHANGES {
        let more = outcome.changes.len() - MOST_CHANGES;
        text.push_str(&format!("  and {more} more\n"));
    }
    if let Some(failure) = &outcome.failure {
        text.push_str(&format!("  stopped early: {failure}\n"));
    }
    let reached = short_number(outcome.time, 9);
    let to = short_number(settings.to, 9);
    let turned = outcome.turned.as_ref().map(|turned| format!("{turned}\n"));
    text + &format!(
        "\nreached {reached} s of {to} s\n{}\n{}",
        turned.unwrap_or_default(),
        effort_text(&outcome.effort)
    )
}

/// Files of a run with its progress on the terminal.
struct Watched<'a> {
    files: RunFiles<'a>,
    progress: Progress<'a>,
    from: f64,
    to: f64,
}

impl Watched<'_> {
    fn show(&self, time: f64) {
        let part = (time - self.from) / (self.to - self.from);
        self.progress.show(part, time);
    }
}

impl Recorder for Watched<'_> {
    fn record(&mut self, accepted: &AcceptedStep<'_>) -> bool {
        self.show(accepted.time);
        self.files.record(accepted)
    }

    fn wants_snapshot(&self, accepted: &AcceptedStep<'_>) -> bool {
        self.files.wants_snapshot(accepted)
    }

    fn keep(&mut self, snapshot: &Snapshot) -> bool {
        self.files.keep(snapshot)
    }

    fn stopped(&mut self, accepted: &AcceptedStep<'_>, snapshot: &Snapshot) -> bool {
        self.files.stopped(accepted, snapshot)
    }
}
