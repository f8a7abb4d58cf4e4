//! The command line.

use std::ffi::OsString;
use std::fmt::Display;
use std::io::Write;
use std::path::PathBuf;

use clap::Parser;
use shared_geom::command_help::with_near_commands;
use shared_geom::error::Explain;

use crate::analysis::modes::modes_watched;
use crate::case::ModesSettings;
use crate::input::{self, Input};
use crate::output::{self, ResultLocation, Written};

mod airfoil;
mod arguments;
mod blade_options;
mod compare;
mod convert;
mod describe;
mod expand;
mod files;
mod help;
mod identify;
mod linearize;
mod linearize_options;
mod performance;
mod periodic;
mod plot;
mod progress;
mod reading_options;
mod result_locations;
mod schema;
mod stability;
mod statics;
mod table_part;
mod terminal;
mod transient;
mod trim;

use arguments::{Arguments, Command, Results};
use blade_options::BladeOptions;
use progress::Progress;
use result_locations::{in_folder, result_locations};
use terminal::Terminal;

/// The work is done.
const DONE: u8 = 0;
/// The program ran but did not reach its goal; the available results have been written.
const NOT_REACHED: u8 = 1;
/// The input or the command line is wrong.
const WRONG_INPUT: u8 = 2;

/// A file without the table of the requested analysis.
#[derive(Debug, thiserror::Error)]
#[error("{file}: has no [{table}] that defines the analysis")]
struct MissingTable {
    file: String,
    table: &'static str,
    example: &'static str,
}

impl Explain for MissingTable {
    fn help(&self) -> Option<String> {
        Some(format!("add [{}] with {}", self.table, self.example))
    }
}

/// A blade file where a dynamics file is expected.
#[derive(Debug, thiserror::Error)]
#[error("{file}: is a blade file, which has no [{table}], expected a dynamics file")]
struct BladeAlone {
    file: String,
    table: &'static str,
}

impl Explain for BladeAlone {
    fn help(&self) -> Option<String> {
        let (file, table) = (&self.file, self.table);
        Some(format!(
            "write a NAME.dynamics.toml with [[blade]] and file = \"{file}\", loads, and [{table}]"
        ))
    }
}

/// Runs the program with the arguments of a command line, of which the first is the
/// name of the program; returns the exit code.
///
/// 0: done. 1: ran but did not reach its goal; available results have been written. 2: the
/// input or the command line is wrong. A closed output pipe is not an error.
pub fn run(
    arguments: impl IntoIterator<Item = OsString>,
    out: &mut dyn Write,
    err: &mut dyn Write,
) -> u8 {
    let mut terminal = Terminal::new(out, err);
    let code = dispatch(arguments, &mut terminal);
    if terminal.finish() {
        code
    } else {
        code.max(NOT_REACHED)
    }
}

fn dispatch(arguments: impl IntoIterator<Item = OsString>, terminal: &mut Terminal<'_>) -> u8 {
    match Arguments::try_parse_from(arguments).map_err(with_near_commands) {
        Ok(arguments) => {
            terminal.set_quiet(arguments.is_quiet());
            run_command(arguments.command, terminal)
        }
        Err(message) if message.use_stderr() => {
            terminal.report_text(message.render().to_string().trim_end());
            WRONG_INPUT
        }
        // The texts of --help and --version.
        Err(message) => {
            terminal.show(&message.render().to_string());
            DONE
        }
    }
}

fn run_command(command: Command, terminal: &mut Terminal<'_>) -> u8 {
    match command {
        Command::Modes {
            files,
            results,
            vtu,
            blade,
        } => modes_of_files(&files, &results, (&blade, vtu), terminal),
        Command::Static { files, results } => statics::static_of_files(&files, &results, terminal),
        Command::Buckling { files, results } => {
            statics::buckling_of_files(&files, &results, terminal)
        }
        Command::Transient {
            files,
            results,
            restart,
        } => transient::transient_of_files(&files, &results, restart.as_deref(), terminal),
        Command::Periodic { files, results } => {
            periodic::periodic_of_files(&files, &results, terminal)
        }
        Command::Trim {
            files,
            results,
            json,
        } => trim::trim_of_files(&files, (&results, json), terminal),
        Command::Stability { files, results } => {
            stability::stability_of_files(&files, &results, terminal)
        }
        Command::Linearize { options, results } => {
            linearize::linearize_files(&options, &results, terminal)
        }
        Command::Performance { files, results } => {
            performance::performance_of_files(&files, &results, terminal)
        }
        Command::Plot { results, options } => plot::plot_files(&results, &options, terminal),
        Command::Identify { results, options } => {
            identify::identify_files(&results, &options, terminal)
        }
        Command::Check { files } => check_files(&files, terminal),
        Command::Expand { file, out } => expand::expand(&file, out.as_deref(), terminal),
        Command::Completions { shell } => help::completions(shell, terminal),
        Command::Manual { out } => help::manual(out.as_deref(), terminal),
        Command::Schema { of, format, out } => {
            schema::write_schema((of, format), out.as_deref(), terminal)
        }
        Command::Compare(arguments) => compare::compare_files(&arguments, terminal),
        Command::Describe { files, reading } => describe::describe_files(&files, reading, terminal),
        Command::Convert(arguments) => convert::convert(&arguments, terminal),
        Command::Airfoil(arguments) => airfoil::airfoil(&arguments, terminal),
    }
}

/// Reads all files, blade files with the settings of the options; reports all wrong files
/// and then returns none.
fn read(
    files: &[PathBuf],
    options: &BladeOptions,
    terminal: &mut Terminal<'_>,
) -> Option<Vec<Input>> {
    let settings = options.settings();
    let read = files::each(files, terminal, |file, terminal| {
        let input = if input::is_blade_file(file) {
            input::read_blade(file, &settings)
        } else {
            input::read(file)
        };
        input
            .map_err(|problems| terminal.report_text(&problems.to_string()))
            .ok()
    });
    read.into_iter().collect()
}

fn check_files(files: &[PathBuf], terminal: &mut Terminal<'_>) -> u8 {
    let Some(inputs) = read(files, &BladeOptions::default(), terminal) else {
        return WRONG_INPUT;
    };
    let unrepeated = inputs.iter().map(|input| &input.unrepeated);
    let wrong: Vec<_> = unrepeated.filter(|problems| !problems.is_empty()).collect();
    if !wrong.is_empty() {
        wrong
            .iter()
            .for_each(|problems| terminal.report_text(&problems.to_string()));
        return WRONG_INPUT;
    }
    for (file, input) in files.iter().zip(&inputs) {
        terminal.show(&format!("{}: {}\n", file.display(), input.summary));
        for remark in &input.remarks {
            terminal.show(&format!("  remark: {remark}\n"));
        }
    }
    terminal.show("\nNo problem found\n");
    DONE
}

/// Options for blade files given with a dynamics file.
#[derive(Debug, thiserror::Error)]
#[error("\"{file}\" is a dynamics file, for which {option} is not an option")]
struct NotABlade {
    file: String,
    option: &'static str,
}

impl Explain for NotABlade {
    fn help(&self) -> Option<String> {
        let text = "options for blade files mount a blade from a blade file; a dynamics \
                    file states this in [[blade]] and [modes]";
        Some(text.to_owned())
    }
}

/// Folders of the results, all different, and the inputs; reports problems.
fn read_with_locations(
    files: &[PathBuf],
    results: &Results,
    options: &BladeOptions,
    terminal: &mut Terminal<'_>,
) -> Option<(Vec<Input>, Vec<ResultLocation>)> {
    let locations = result_locations(files, results).map_err(|problem| terminal.report(&problem));
    let locations = locations.ok()?;
    Some((read(files, options, terminal)?, locations))
}

fn modes_of_files(
    files: &[PathBuf],
    results: &Results,
    (options, animate): (&BladeOptions, bool),
    terminal: &mut Terminal<'_>,
) -> u8 {
    let dynamics = files.iter().find(|file| !input::is_blade_file(file));
    if let (Some(file), Some(option)) = (dynamics, options.given()) {
        let file = file.display().to_string();
        terminal.report(&NotABlade { file, option });
        return WRONG_INPUT;
    }
    let Some((inputs, locations)) = read_with_locations(files, results, options, terminal) else {
        return WRONG_INPUT;
    };
    let mut all_settings = Vec::with_capacity(inputs.len());
    for (file, input) in files.iter().zip(&inputs) {
        if input.trim.is_some() && input.modes.is_some() {
            let file = file.display().to_string();
            terminal.report(&stability::ModesOfTrim { file });
            continue;
        }
        match &input.modes {
            Some(settings) => {
                let mut settings = settings.clone();
                settings.animate |= animate;
                if settings.shapes.is_empty() {
                    settings.shapes = settings.ends();
                }
                all_settings.push((input, settings));
            }
            None => terminal.report(&MissingTable {
                file: file.display().to_string(),
                table: "modes",
                example: "speeds = [0, 300] and count = 8",
            }),
        }
    }
    if all_settings.len() < inputs.len() {
        return WRONG_INPUT;
    }
    let jobs: Vec<_> = all_settings.into_iter().zip(&locations).collect();
    files::worst_of(
        &jobs,
        terminal,
        |((input, settings), location), terminal| {
            in_folder(location, "modes", terminal, |terminal| {
                modes_of(input, settings, location, terminal)
            })
        },
    )
}

/// Analyzes one model, writes its results, and prints them.
fn modes_of(
    input: &Input,
    settings: &ModesSettings,
    location: &ResultLocation,
    terminal: &mut Terminal<'_>,
) -> u8 {
    let progress = Progress::of_search(terminal.part());
    let outcome = modes_watched(&input.model, settings, &|at| {
        let (done, all) = (at.equilibria + at.solved, 2 * at.all.max(1));
        let place = match at.solved {
            0 => format!("equilibrium {} of {}", at.equilibria, at.all),
            solved => format!("modes {solved} of {}", at.all),
        };
        progress.note(done as f64 / all as f64, &place);
    });
    progress.finish();
    let mut table = outcome.table;
    let failure = outcome
        .failure
        .as_ref()
        .map(|failure| failure as &dyn Display);
    let shown = (location.name.as_str(), &mut *terminal);
    add_remarks(&mut table.remarks, (input, failure), shown);
    let written = output::write(&table, &input.measured, location).and_then(|mut written| {
        let shapes = output::write_shapes(&input.model, &table, settings.animate, location)?;
        written.files.extend(shapes.files);
        Ok(written)
    });
    terminal.show(&output::result_text(&table, &input.measured));
    let failure = outcome.failure.map(|failure| {
        let (reached, requested) = (table.speeds.len(), settings.speeds.len());
        let name = &location.name;
        format!(
            "error: {name}: {failure}\n  help: {reached} of {requested} rotor speeds were reached, \
             and their results written"
        )
    });
    finish(failure, written, terminal)
}

/// Completes the remarks on the result called `name`, those on the input first, and shows them. The
/// reason of an early end comes last, and is shown by its own error.
fn add_remarks(
    remarks: &mut Vec<String>,
    (input, failure): (&Input, Option<&dyn Display>),
    (name, terminal): (&str, &mut Terminal<'_>),
) {
    remarks.splice(0..0, input.remarks.iter().cloned());
    terminal.remark(name, remarks);
    remarks.extend(failure.map(|failure| format!("stopped early: {failure}")));
}

/// Reports the failure and the written files; returns the exit code.
fn finish(
    failure: Option<String>,
    written: Result<Written, impl Explain>,
    terminal: &mut Terminal<'_>,
) -> u8 {
    let mut code = DONE;
    if let Some(failure) = failure {
        terminal.report_text(&failure);
        code = NOT_REACHED;
    }
    match written {
        Ok(written) => {
            terminal.show("\nWritten\n");
            for file in &written.files {
                terminal.show(&format!("  {}\n", file.display()));
            }
            if let Some(reason) = written.no_plot {
                terminal.show(&format!("  (no fan plot: {reason})\n"));
            }
        }
        Err(problem) => {
            terminal.report(&problem);
            code = NOT_REACHED;
        }
    }
    code
}
