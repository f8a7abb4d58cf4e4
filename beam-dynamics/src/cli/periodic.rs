//! `periodic`: finds the periodic motion of each file and its stability, and writes the results.

use std::fmt::Display;
use std::path::PathBuf;

use super::arguments::Results;
use super::terminal::Terminal;
use super::{DONE, MissingTable, NOT_REACHED, WRONG_INPUT, add_remarks, statics};
use crate::analysis::periodic::{periodic_from, record};
use crate::case::PeriodicSettings;
use crate::input::Input;
use crate::model::State;
use crate::output::{self, PeriodicFiles, ResultLocation, RunFileProblem, not_drawn_text};
use crate::result::PeriodicResult;

/// `periodic FILE...`
pub(super) fn periodic_of_files(
    files: &[PathBuf],
    results: &Results,
    terminal: &mut Terminal<'_>,
) -> u8 {
    let requested = MissingTable {
        file: String::new(),
        table: "periodic",
        example: "period = \"0.2 s\", or speed = \"300 rpm\"",
    };
    statics::each(
        files,
        results,
        terminal,
        (|input| input.periodic.as_ref(), requested),
        periodic_of,
    )
}

fn periodic_of(
    input: &Input,
    settings: &PeriodicSettings,
    location: &ResultLocation,
    terminal: &mut Terminal<'_>,
) -> u8 {
    let outcome = periodic_from(&input.model, settings, None);
    let mut result = outcome.result;
    let failure = outcome.failure.as_ref();
    let reason = failure.map(|failure| failure as &dyn Display);
    let shown = (location.name.as_str(), &mut *terminal);
    add_remarks(&mut result.remarks, (input, reason), shown);
    let mut code = DONE;
    if let Some(failure) = failure {
        let (name, remedy) = (&location.name, failure.remedy());
        terminal.report_text(&format!("error: {name}: {failure}\n  help: {remedy}"));
        code = NOT_REACHED;
    }
    let state = outcome.state.filter(|_| failure.is_none());
    code.max(write_period(
        (input, settings),
        (result, state.as_ref()),
        location,
        terminal,
    ))
}

/// Writes a period of the motion that begins at a state, if there is one, and its report, and prints
/// this; returns the exit code.
pub(super) fn write_period(
    (input, settings): (&Input, &PeriodicSettings),
    (result, state): (PeriodicResult, Option<&State>),
    location: &ResultLocation,
    terminal: &mut Terminal<'_>,
) -> u8 {
    let mut files = match PeriodicFiles::new(&input.model, &input.output, location) {
        Ok(files) => files,
        Err(problem) => {
            terminal.report(&problem);
            return match problem {
                RunFileProblem::Output(_) => NOT_REACHED,
                _ => WRONG_INPUT,
            };
        }
    };
    let mut code = DONE;
    let recorded = state.map(|state| record(&input.model, settings, state, &mut files));
    if let (Some(Err(failure)), None) = (recorded, files.problem()) {
        // The reason of a search that failed is reported by its caller.
        if result.is_periodic {
            let (name, remedy) = (&location.name, failure.remedy());
            terminal.report_text(&format!("error: {name}: {failure}\n  help: {remedy}"));
        }
        code = NOT_REACHED;
    }
    // Of a motion that does not repeat they would be numbers without a meaning.
    let found = if result.is_periodic {
        files.harmonics(settings.harmonics)
    } else {
        Vec::new()
    };
    let blades = input.model.blades_of_rotors();
    let of_rotor = match settings.revolutions() {
        Some(revolutions) if !blades.is_empty() && result.is_periodic => {
            output::rotor_harmonics_text(&input.output.columns, &found, (&blades, revolutions))
        }
        _ => String::new(),
    };
    let text = output::periodic_text(&result) + &of_rotor;
    let whole = format!("{text}\n{}", output::PERIODIC_CONVENTION);
    terminal.show(&whole);
    match files.finish(&result, (&whole, &found)) {
        Ok(written) => {
            terminal.show("\nWritten\n");
            for file in &written.files {
                terminal.show(&format!("  {}\n", file.display()));
            }
            terminal.show(&not_drawn_text(&written.not_drawn));
        }
        Err(problem) => {
            terminal.report(&problem);
            code = NOT_REACHED;
        }
    }
    code
}
