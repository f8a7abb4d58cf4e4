//! `section-analyzer completions` and `manual`: scripts for shells and pages for `man`,
//! from the arguments of the command line.

use std::path::Path;

use clap::CommandFactory;
use shared_geom::command_help::{self, Shell};
use shared_geom::files::{OutputProblem, make_folder};

use super::arguments::Arguments;
use super::{NOT_REACHED, Stop, Terminal, WRONG_INPUT, list};

/// Prints the completion script of a shell.
pub(super) fn write_completions(shell: Shell, terminal: &mut Terminal<'_>) -> Result<(), Stop> {
    let script = command_help::completions(Arguments::command(), shell);
    Ok(terminal.out.write_all(&script)?)
}

/// Prints all manual pages, or writes each into the folder `out`.
pub(super) fn write_manual(out: Option<&Path>, terminal: &mut Terminal<'_>) -> Result<(), Stop> {
    let source = concat!(env!("CARGO_PKG_NAME"), " ", env!("CARGO_PKG_VERSION"));
    let pages = command_help::manual(Arguments::command(), source)?;
    let Some(folder) = out else {
        for page in pages {
            terminal.out.write_all(page.text.as_bytes())?;
        }
        return Ok(());
    };
    make_folder(folder).map_err(|problem| terminal.report(&problem, WRONG_INPUT))?;
    let written = command_help::write_manual(&pages, folder);
    let files = written.map_err(|problem: OutputProblem| terminal.report(&problem, NOT_REACHED))?;
    list("Written", &files, terminal)
}
