//! `static` and `buckling`: analyzes each file, writes its results and prints them.

use std::fmt::Display;
use std::path::{Path, PathBuf};

use super::arguments::Results;
use super::blade_options::BladeOptions;
use super::progress::Progress;
use super::terminal::Terminal;
use super::{
    BladeAlone, MissingTable, WRONG_INPUT, add_remarks, files, finish, in_folder,
    read_with_locations,
};
use crate::analysis::buckling::buckling;
use crate::analysis::static_sweep::static_sweep;
use crate::analysis::statics::statics;
use crate::case::{BucklingSettings, StaticSettings, Sweep};
use crate::input::{self, Input, is_blade_file, short_number};
use crate::output::{self, ResultLocation};

/// `static FILE...`
pub(super) fn static_of_files(
    files: &[PathBuf],
    results: &Results,
    terminal: &mut Terminal<'_>,
) -> u8 {
    let requested = MissingTable {
        file: String::new(),
        table: "static",
        example: "speed = 0 and to = 1, or without keys for the loads as given",
    };
    each_again(
        files,
        results,
        terminal,
        (|input| input.statics.as_ref(), requested),
        |path, input, settings: &StaticSettings, location, terminal| match &settings.sweep {
            Some(sweep) => sweep_of(path, (input, sweep), location, terminal),
            None => static_of(input, settings, location, terminal),
        },
    )
}

/// `buckling FILE...`
pub(super) fn buckling_of_files(
    files: &[PathBuf],
    results: &Results,
    terminal: &mut Terminal<'_>,
) -> u8 {
    let requested = MissingTable {
        file: String::new(),
        table: "buckling",
        example: "count = 4",
    };
    each(
        files,
        results,
        terminal,
        (|input| input.buckling.as_ref(), requested),
        buckling_of,
    )
}

/// Analyzes every file; returns the largest exit code.
pub(super) fn each<Q: Sync>(
    paths: &[PathBuf],
    results: &Results,
    terminal: &mut Terminal<'_>,
    (settings, requested): (impl Fn(&Input) -> Option<&Q>, MissingTable),
    answer: fn(&Input, &Q, &ResultLocation, &mut Terminal<'_>) -> u8,
) -> u8 {
    let analysis =
        |_: &Path,
         input: &Input,
         settings: &Q,
         location: &ResultLocation,
         terminal: &mut Terminal<'_>| { answer(input, settings, location, terminal) };
    each_again(paths, results, terminal, (settings, requested), analysis)
}

/// Analyzes every file, which the analysis may read again; returns the largest exit code.
pub(super) fn each_again<Q: Sync>(
    paths: &[PathBuf],
    results: &Results,
    terminal: &mut Terminal<'_>,
    (settings, requested): (impl Fn(&Input) -> Option<&Q>, MissingTable),
    answer: impl Fn(&Path, &Input, &Q, &ResultLocation, &mut Terminal<'_>) -> u8 + Sync,
) -> u8 {
    let Some((inputs, locations)) =
        read_with_locations(paths, results, &BladeOptions::default(), terminal)
    else {
        return WRONG_INPUT;
    };
    let mut complete = true;
    for (path, input) in paths.iter().zip(&inputs) {
        if settings(input).is_some() {
            if has_period(input, requested.table) && !input.unrepeated.is_empty() {
                complete = false;
                terminal.report_text(&input.unrepeated.to_string());
            }
            continue;
        }
        complete = false;
        let (file, table) = (path.display().to_string(), requested.table);
        if is_blade_file(path) {
            terminal.report(&BladeAlone { file, table })
        } else {
            terminal.report(&MissingTable { file, ..requested })
        }
    }
    if !complete {
        return WRONG_INPUT;
    }
    let given = paths.iter().zip(&inputs).zip(&locations);
    let jobs: Vec<_> = given
        .filter_map(|((path, input), location)| Some((path, input, settings(input)?, location)))
        .collect();
    files::worst_of(
        &jobs,
        terminal,
        |(path, input, settings, location), terminal| {
            in_folder(location, requested.table, terminal, |terminal| {
                answer(path, input, settings, location, terminal)
            })
        },
    )
}

/// Whether the analysis of a table is of a periodic motion.
fn has_period(input: &Input, table: &str) -> bool {
    let stability = input.stability.as_ref();
    match table {
        "periodic" | "trim" => true,
        "stability" => stability.is_some_and(|own| own.method.has_period()),
        _ => false,
    }
}

/// Equilibria over a parameter.
fn sweep_of(
    path: &Path,
    (input, sweep): (&Input, &Sweep),
    location: &ResultLocation,
    terminal: &mut Terminal<'_>,
) -> u8 {
    let read = |given: &[(String, f64)]| input::read_with(path, given);
    let progress = Progress::of_search(terminal.part());
    let count = sweep.values.len();
    let mut result = static_sweep(&input.model.name, sweep, &read, &mut |index| {
        let at = short_number(sweep.values[index], 6);
        let text = format!("point {} of {count}, {} = {at}", index + 1, sweep.parameter);
        progress.note(index as f64 / count as f64, &text);
    });
    progress.finish();
    let shown = (location.name.as_str(), &mut *terminal);
    add_remarks(&mut result.remarks, (input, None), shown);
    terminal.show(&output::sweep_text(&result));
    let failures = result.points.iter().filter_map(|point| {
        let [reason, remedy] = point.failure.as_ref()?;
        let (name, at) = (&location.name, short_number(point.at, 6));
        Some(format!(
            "error: {name} at {} = {at}: {reason}\n  help: {remedy}",
            result.parameter
        ))
    });
    let failures: Vec<_> = failures.collect();
    let failure = (!failures.is_empty()).then(|| failures.join("\n"));
    let written = output::write_sweep(&result, location, input.output.span_forces);
    finish(failure, written, terminal)
}

fn static_of(
    input: &Input,
    settings: &StaticSettings,
    location: &ResultLocation,
    terminal: &mut Terminal<'_>,
) -> u8 {
    let outcome = statics(&input.model, settings);
    let mut result = outcome.result;
    let failure = outcome
        .failure
        .as_ref()
        .map(|failure| failure as &dyn Display);
    let shown = (location.name.as_str(), &mut *terminal);
    add_remarks(&mut result.remarks, (input, failure), shown);
    let written = output::write_static(&result, location, input.output.span_forces);
    let text = format!(
        "{}\n{}",
        output::static_text(&result),
        output::STATIC_CONVENTION
    );
    terminal.show(&text);
    let failure = outcome.failure.map(|failure| {
        let last = result.last().map_or_else(
            || "no load step converged".to_owned(),
            |step| {
                let kept = match result.steps.len() {
                    1 => ("1 equilibrium".to_owned(), "is"),
                    kept => (format!("{kept} equilibria"), "are"),
                };
                let factor = short_number(step.factor, 6);
                format!(
                    "{} up to the load factor {factor} {} written",
                    kept.0, kept.1
                )
            },
        );
        format!(
            "error: {}: {failure}\n  help: {}; {last}",
            location.name,
            failure.remedy()
        )
    });
    finish(failure, written, terminal)
}

fn buckling_of(
    input: &Input,
    settings: &BucklingSettings,
    location: &ResultLocation,
    terminal: &mut Terminal<'_>,
) -> u8 {
    let outcome = buckling(&input.model, settings);
    let mut result = outcome.result;
    let failure = outcome
        .failure
        .as_ref()
        .map(|failure| failure as &dyn Display);
    let shown = (location.name.as_str(), &mut *terminal);
    add_remarks(&mut result.remarks, (input, failure), shown);
    let written = output::write_buckling(&result, location);
    let text = format!(
        "{}\n{}",
        output::buckling_text(&result),
        output::BUCKLING_CONVENTION
    );
    terminal.show(&text);
    let failure = outcome.failure.map(|failure| {
        let (name, remedy) = (&location.name, failure.remedy());
        format!("error: {name}: {failure}\n  help: {remedy}")
    });
    finish(failure, written, terminal)
}
