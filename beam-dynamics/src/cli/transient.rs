//! `transient`: runs each model in time, writes results during the run, and reports the
//! effort.

use std::path::{Path, PathBuf};
use std::time::Instant;

use shared_geom::error::Explain;

use super::arguments::Results;
use super::blade_options::BladeOptions;
use super::progress::Progress;
use super::terminal::Terminal;
use super::{BladeAlone, DONE, NOT_REACHED, NotAsked, WRONG_INPUT, files, read_with_places};
use crate::analysis::transient::{
    TransientFailure, TransientOutcome, difference, driven_places, transient,
};
use crate::case::TransientQuestion;
use crate::input::{Input, is_blade_file, short_number};
use crate::integrator::{Scheme, Stepping};
use crate::output::{
    ResultPlace, RunFileProblem, RunFiles, effort_text, not_drawn_text, read_snapshot,
};
use crate::result::{Moment, Recorder, Snapshot};

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
        terminal.tell(&RestartProblem::ManyFiles { files });
        return WRONG_INPUT;
    }
    let Some((inputs, places)) =
        read_with_places(paths, results, &BladeOptions::default(), terminal)
    else {
        return WRONG_INPUT;
    };
    for (path, input) in paths.iter().zip(&inputs) {
        if input.transient.is_none() {
            tell_not_asked(path, terminal);
        }
    }
    let asked: Vec<_> = inputs
        .iter()
        .zip(&places)
        .filter_map(|(input, place)| Some((input, input.transient.as_ref()?, place)))
        .collect();
    if asked.len() < inputs.len() {
        return WRONG_INPUT;
    }
    files::worst_of(&asked, terminal, |(input, question, place), terminal| {
        let resumed = match restart.map(|path| resumed(path, input, question, terminal)) {
            Some(None) => return WRONG_INPUT,
            Some(Some(snapshot)) => Some(snapshot),
            None => None,
        };
        run((input, question), resumed.as_ref(), place, terminal)
    })
}

fn tell_not_asked(path: &Path, terminal: &mut Terminal<'_>) {
    let (file, table) = (path.display().to_string(), TABLE);
    match is_blade_file(path) {
        true => terminal.tell(&BladeAlone { file, table }),
        false => terminal.tell(&NotAsked {
            file,
            table,
            example: "to = 1 and step = \"1 ms\"",
        }),
    }
}

/// The state at `path` from which the run continues; reports a state that does not fit.
fn resumed(
    path: &Path,
    input: &Input,
    question: &TransientQuestion,
    terminal: &mut Terminal<'_>,
) -> Option<Snapshot> {
    let snapshot = match read_snapshot(path) {
        Ok(snapshot) => snapshot,
        Err(problem) => {
            terminal.tell(&problem);
            return None;
        }
    };
    let file = path.display().to_string();
    let problem = match other_model(&snapshot, input) {
        Some(difference) => RestartProblem::OtherModel { file, difference },
        None if snapshot.progress.time > question.to => RestartProblem::AfterEnd {
            file,
            at: snapshot.progress.time,
            to: question.to,
        },
        None => return Some(snapshot),
    };
    terminal.tell(&problem);
    None
}

/// Difference between a state and the model. Another law of the same joints changes only
/// the fingerprint; a model whose redundant constraints were removed has other constraints.
fn other_model(snapshot: &Snapshot, input: &Input) -> Option<String> {
    if snapshot.model == input.model.fingerprint() {
        return None;
    }
    let told = difference(&input.model, snapshot);
    Some(told.unwrap_or_else(|| {
        "its nodes have the same names, but some element, law, drive, gravity or the hub \
         differs"
            .to_owned()
    }))
}

/// Runs one model, writes its results and prints the report.
fn run(
    (input, question): (&Input, &TransientQuestion),
    resumed: Option<&Snapshot>,
    place @ ResultPlace { name, .. }: &ResultPlace,
    terminal: &mut Terminal<'_>,
) -> u8 {
    // Before anything is written: the input is wrong.
    if let Err(failure) = driven_places(&input.model, question) {
        terminal.tell_text(&format!(
            "error: {name}: {failure}{}\n  help: {}",
            cards_of(input, &failure),
            failure.remedy()
        ));
        return WRONG_INPUT;
    }
    let files = match RunFiles::new(&input.model, &input.output, place, resumed) {
        Ok(files) => files.until(question.to),
        Err(problem) => {
            terminal.tell(&problem);
            return match problem {
                RunFileProblem::Output(_) => NOT_REACHED,
                _ => WRONG_INPUT,
            };
        }
    };
    let head = heading(input, question, resumed);
    terminal.show(&head);
    terminal.flush();
    let mut watched = Watched {
        files,
        progress: Progress::new(terminal.part()),
        from: question.from,
        to: question.to,
    };
    if let Some(snapshot) = resumed {
        watched.show(snapshot.progress.time);
        watched.progress.begin();
    }
    let start = Instant::now();
    let clock = || start.elapsed().as_secs_f64();
    let outcome = transient(&input.model, question, resumed, &mut watched, &clock);
    watched.progress.finish();
    let text = outcome_text(input, question, &outcome);
    terminal.show(&text);
    let mut code = DONE;
    if let (Some(failure), None) = (&outcome.failure, watched.files.problem()) {
        let written = match watched.files.has_rows() {
            true => format!("; all up to {} s is written", short_number(outcome.time, 9)),
            false => String::new(),
        };
        terminal.tell_text(&format!(
            "error: {name}: {failure}{}\n  help: {}{written}",
            cards_of(input, failure),
            failure.remedy()
        ));
        code = NOT_REACHED;
    }
    let title = &input.model.name;
    code.max(finish(watched.files, (title, &(head + &text)), terminal))
}

/// Locations of the joints that a failure concerns.
fn cards_of(input: &Input, failure: &TransientFailure) -> String {
    let joints = failure.joints().into_iter();
    let places = joints.filter_map(|joint| Some((input.joint_places.get(joint)?, joint)));
    let lines = places.map(|(place, joint)| format!("\n  {place}: \"{joint}\""));
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
            terminal.tell(&problem);
            NOT_REACHED
        }
    }
}

/// Summary printed before the run.
fn heading(input: &Input, question: &TransientQuestion, resumed: Option<&Snapshot>) -> String {
    let system = &input.model.system;
    let seconds = |time: f64| format!("{} s", short_number(time, 9));
    let start = match resumed {
        Some(snapshot) if snapshot.progress.time >= question.to => format!(
            "is complete (step {}), writes its report and figures; from {}",
            snapshot.step,
            seconds(question.from)
        ),
        Some(snapshot) => format!(
            "continues at {} (step {})",
            seconds(snapshot.progress.time),
            snapshot.step
        ),
        None => format!("from {}", seconds(question.from)),
    };
    let steps = match question.stepping {
        Stepping::Constant { step } => format!("steps of {}", seconds(step)),
        Stepping::Variable(control) => format!(
            "steps of {} to {}, tolerance {}",
            seconds(control.least),
            seconds(control.most),
            short_number(control.tolerance, 4)
        ),
    };
    format!(
        "{}: {start} to {}\n{}; {steps}\n{} nodes, {} unknowns, {} of them multipliers\n",
        input.model.name,
        seconds(question.to),
        scheme_words(question.scheme),
        system.nodes().len(),
        system.numbering().unknowns(),
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
fn outcome_text(input: &Input, question: &TransientQuestion, outcome: &TransientOutcome) -> String {
    let mut text = String::new();
    for remark in input.remarks.iter().chain(&outcome.remarks) {
        text.push_str(&format!("  note: {remark}\n"));
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
    let to = short_number(question.to, 9);
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
    fn record(&mut self, moment: &Moment<'_>) -> bool {
        self.show(moment.time);
        self.files.record(moment)
    }

    fn wants_snapshot(&self, moment: &Moment<'_>) -> bool {
        self.files.wants_snapshot(moment)
    }

    fn keep(&mut self, snapshot: &Snapshot) -> bool {
        self.files.keep(snapshot)
    }

    fn stopped(&mut self, moment: &Moment<'_>, snapshot: &Snapshot) -> bool {
        self.files.stopped(moment, snapshot)
    }
}
