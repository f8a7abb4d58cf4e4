//! `trim`: finds the controls of each file, prints them, and writes the results.

use std::path::{Path, PathBuf};

use super::arguments::Results;
use super::periodic::write_period;
use super::progress::Progress;
use super::terminal::Terminal;
use super::{DONE, MissingTable, NOT_REACHED, add_remarks, finish, in_folder, statics};
use crate::analysis::trim::{TrimEnd, TrimProgress, Trimmed, trim_watched};
use crate::case::TrimSettings;
use crate::input::{self, Input};
use crate::output::{self, ResultLocation};
use crate::result::TrimResult;

/// `trim FILE...`, with `json` also as JSON
pub(super) fn trim_of_files(
    paths: &[PathBuf],
    (results, json): (&Results, bool),
    terminal: &mut Terminal<'_>,
) -> u8 {
    let requested = MissingTable {
        file: String::new(),
        table: "trim",
        example: "[[trim.control]] and [[trim.target]]",
    };
    statics::each_again(
        paths,
        results,
        terminal,
        (|input| input.trim.as_ref(), requested),
        |path, input, settings, location, terminal| {
            trim_of(path, (input, settings), (location, json), terminal)
        },
    )
}

fn trim_of(
    path: &Path,
    (input, settings): (&Input, &TrimSettings),
    (location, json): (&ResultLocation, bool),
    terminal: &mut Terminal<'_>,
) -> u8 {
    let read = |given: &[(String, f64)]| input::read_with(path, given)?.repeating();
    let progress = Progress::of_search(terminal.part());
    let sweep = settings.sweep.as_ref().map(|sweep| &*sweep.parameter);
    let outcome = trim_watched(&input.model.name, settings, &read, &mut |at| {
        let [done, all] = at.points;
        progress.note(done as f64 / all.max(1) as f64, &shown(sweep, at));
    });
    progress.finish();
    let mut result = outcome.result;
    let shown = (location.name.as_str(), &mut *terminal);
    add_remarks(&mut result.remarks, (input, None), shown);
    let text = output::trim_text(&result);
    terminal.show(&text);
    let written = output::write_trim(&result, location, json);
    let mut code = finish(None, written, terminal);
    if let Some(end) = outcome.end {
        code = code.max(write_end(end, location, terminal));
    }
    // Last, after the text of the last motion.
    code.max(report_failure(&result, location, terminal))
}

/// The present point and its iteration, as text.
fn shown(sweep: Option<&str>, at: TrimProgress) -> String {
    let [done, all] = at.points;
    let place = match (sweep, at.at) {
        (Some(sweep), Some(at)) => format!(", {sweep} = {}", input::short_number(at, 6)),
        _ => String::new(),
    };
    format!(
        "point {} of {all}{place}: iteration {}, off by {:.1e}",
        done + 1,
        at.passes,
        at.residual
    )
}

/// Reports the reason of a failed point.
fn report_failure(
    result: &TrimResult,
    location: &ResultLocation,
    terminal: &mut Terminal<'_>,
) -> u8 {
    let Some(failure) = output::trim_failure(result) else {
        return DONE;
    };
    terminal.report_text(&format!("error: {}{failure}", location.name));
    NOT_REACHED
}

/// Writes the motion or the equilibrium at the end, also of a failed search.
fn write_end(end: TrimEnd, location: &ResultLocation, terminal: &mut Terminal<'_>) -> u8 {
    let TrimEnd {
        input,
        state,
        found,
    } = end;
    match (found, &input.periodic, state) {
        (Some(Trimmed::Periodic(result)), Some(settings), Some(state)) => {
            in_folder(location, "periodic", terminal, |terminal| {
                terminal.remark(&location.name, &result.remarks);
                let found = (result, Some(&state));
                write_period((&input, settings), found, location, terminal)
            })
        }
        (Some(Trimmed::Static(result)), ..) => {
            in_folder(location, "static", terminal, |terminal| {
                terminal.show(&format!("\n{}", output::static_text(&result)));
                let forces = input.output.span_forces;
                finish(
                    None,
                    output::write_static(&result, location, forces),
                    terminal,
                )
            })
        }
        _ => DONE,
    }
}
