//! The command line.

use std::ffi::OsString;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::Parser;
use shared_geom::command_help::with_near_commands;
use shared_geom::error::{Diagnostics, Explain};
use shared_geom::files::{removed_remarks, removed_text};
use shared_geom::section::{self, SectionProperties};
use shared_geom::stream::Stream;

use crate::input::{self, Input};

mod analyze;
mod arguments;
mod blade;
mod change;
mod check;
mod compare;
mod convert;
mod figures;
mod generate;
mod help;
mod layup;
mod load_arguments;
mod matrices;
mod report;
mod restored;
mod schema;
mod solved;
mod strength;
mod stress;

use arguments::{Arguments, Command};

/// The work is done.
const DONE: u8 = 0;
/// The program ran but did not reach its goal; the available output has been written.
const NOT_REACHED: u8 = 1;
/// The input or the command line is wrong.
const WRONG_INPUT: u8 = 2;

/// Reason for which a command ended early.
#[derive(Debug)]
enum Stop {
    /// All problems have been reported; the exit code.
    Reported(u8),
    /// The terminal accepts no more output, for another reason than a closed pipe.
    Closed(io::Error),
}

impl From<io::Error> for Stop {
    fn from(error: io::Error) -> Self {
        Self::Closed(error)
    }
}

/// The two streams of the program.
struct Terminal<'a> {
    out: &'a mut dyn Write,
    err: &'a mut dyn Write,
    /// Whether no report is printed; the warnings that it contains are then reported as problems
    /// are.
    is_quiet: bool,
}

/// Runs the program with the arguments of a command line, whose first is the name of the
/// program; returns the exit code.
///
/// 0: done. 1: ran but did not reach its goal; the available output has been written. 2:
/// the input or the command line is wrong. A closed pipe is not an error.
pub fn run(
    arguments: impl IntoIterator<Item = OsString>,
    out: &mut dyn Write,
    err: &mut dyn Write,
) -> u8 {
    let (mut out, mut err) = (Stream(out), Stream(err));
    let mut terminal = Terminal {
        out: &mut out,
        err: &mut err,
        is_quiet: false,
    };
    match dispatch(arguments, &mut terminal) {
        Ok(()) => DONE,
        Err(Stop::Reported(code)) => code,
        Err(Stop::Closed(error)) => {
            // If this fails too, no way to report remains.
            let _ = writeln!(terminal.err, "error: the output cannot be written: {error}");
            NOT_REACHED
        }
    }
}

fn dispatch(
    arguments: impl IntoIterator<Item = OsString>,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let arguments = match Arguments::try_parse_from(arguments).map_err(with_near_commands) {
        Ok(arguments) => arguments,
        Err(message) if message.use_stderr() => {
            write!(terminal.err, "{}", message.render())?;
            return Err(Stop::Reported(WRONG_INPUT));
        }
        // the texts of --help and --version
        Err(message) => return Ok(write!(terminal.out, "{}", message.render())?),
    };
    let mut nowhere = io::sink();
    let is_quiet = arguments.is_quiet();
    let terminal = &mut Terminal {
        out: if is_quiet {
            &mut nowhere
        } else {
            &mut *terminal.out
        },
        err: &mut *terminal.err,
        is_quiet,
    };
    match arguments.command {
        Command::Analyze(arguments) => analyze::analyze_files(&arguments, terminal),
        Command::Check(arguments) => check::check_file(&arguments, terminal),
        Command::Stress {
            file,
            load,
            out,
            no_figures,
            ..
        } => stress::recover_file(&file, &load, (out, !no_figures), terminal),
        Command::Matrices { file, out, .. } => matrices::analyze_file(&file, out, terminal),
        Command::Convert(arguments) => convert::convert_model(&arguments, terminal),
        Command::Mesh(shape) => generate::write_mesh(&shape, terminal),
        Command::Layup(arguments) => layup::describe(&arguments, terminal),
        Command::Blade(arguments) => blade::solve_blade(&arguments, terminal),
        Command::Strength(arguments) => strength::envelope(&arguments, terminal),
        Command::Report(arguments) => report::report_files(&arguments, terminal),
        Command::Compare(arguments) => compare::compare_files(&arguments, terminal),
        Command::Shift(arguments) => change::shift_file(&arguments, terminal),
        Command::Rotate(arguments) => change::rotate_file(&arguments, terminal),
        Command::Schema { of, format, out } => {
            schema::write_schema((of, format), out.as_deref(), terminal)
        }
        Command::Completions { shell } => help::write_completions(shell, terminal),
        Command::Manual { out } => help::write_manual(out.as_deref(), terminal),
    }
}

impl Terminal<'_> {
    /// Reports a problem.
    fn report(&mut self, problem: &impl Explain, code: u8) -> Stop {
        self.report_text(&words(problem), code)
    }

    fn report_text(&mut self, text: &str, code: u8) -> Stop {
        match writeln!(self.err, "{text}") {
            Ok(()) => Stop::Reported(code),
            Err(error) => Stop::Closed(error),
        }
    }

    /// Shows warnings about a file.
    fn warn(&mut self, file: &Path, warnings: &[String]) -> io::Result<()> {
        for text in warnings {
            writeln!(self.out, "  remark: {text}")?;
        }
        self.warn_if_quiet(file, warnings)
    }

    /// Reports warnings about a file that no report shows.
    fn warn_if_quiet(&mut self, file: &Path, warnings: &[String]) -> io::Result<()> {
        let mut shown = warnings.iter().filter(|_| self.is_quiet);
        shown.try_for_each(|text| writeln!(self.err, "warning: {}: {text}", file.display()))
    }

    fn read(&mut self, file: &Path) -> Result<Input, Stop> {
        input::read(file).map_err(|problems| self.report_all(&problems))
    }

    /// Reads a property file. Centers and axes that do not follow from its matrices are a
    /// warning.
    fn read_properties(&mut self, file: &Path) -> Result<SectionProperties, Stop> {
        let properties = section::read(file).map_err(|problems| self.report_all(&problems))?;
        for text in properties.disagreements() {
            writeln!(self.err, "warning: {}: {text}", file.display())?;
        }
        Ok(properties)
    }

    fn report_all(&mut self, problems: &Diagnostics) -> Stop {
        self.report_text(&problems.to_string(), WRONG_INPUT)
    }
}

/// The warnings about an input, as text.
fn warnings_of(input: &Input) -> Vec<String> {
    let warnings = input.summary.warnings.iter();
    warnings.map(ToString::to_string).collect()
}

/// Lists `removed` results of an earlier run: on the error stream if nothing else is shown.
fn list_removed(removed: &[PathBuf], terminal: &mut Terminal<'_>) -> io::Result<()> {
    if !terminal.is_quiet {
        return write!(terminal.out, "{}", removed_text(removed));
    }
    removed_remarks(removed).try_for_each(|text| writeln!(terminal.err, "{text}"))
}

/// Text of a reported problem, with its remedy.
fn words(problem: &impl Explain) -> String {
    let help = problem
        .help()
        .map_or_else(String::new, |help| format!("\n  help: {help}"));
    format!("error: {problem}{help}")
}

/// Lists the written files.
fn list(heading: &str, files: &[PathBuf], terminal: &mut Terminal<'_>) -> Result<(), Stop> {
    if files.is_empty() {
        return Ok(());
    }
    writeln!(terminal.out, "\n{heading}")?;
    for file in files {
        writeln!(terminal.out, "  {}", file.display())?;
    }
    Ok(())
}
