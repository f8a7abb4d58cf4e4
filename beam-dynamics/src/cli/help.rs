//! `beam-dynamics completions` and `manual`: scripts for shells and pages for `man`, from the
//! arguments of the command line.

use std::path::Path;

use clap::CommandFactory;
use shared_geom::command_help::{self, Shell};
use shared_geom::files::make_folder;

use super::arguments::Arguments;
use super::terminal::Terminal;
use super::{DONE, NOT_REACHED, WRONG_INPUT};

/// Prints the completion script of a shell.
pub(super) fn completions(shell: Shell, terminal: &mut Terminal<'_>) -> u8 {
    let script = command_help::completions(Arguments::command(), shell);
    terminal.show(&String::from_utf8_lossy(&script));
    DONE
}

/// Prints all manual pages, or writes each into the folder `out`.
pub(super) fn manual(out: Option<&Path>, terminal: &mut Terminal<'_>) -> u8 {
    let source = concat!(env!("CARGO_PKG_NAME"), " ", env!("CARGO_PKG_VERSION"));
    let pages = match command_help::manual(Arguments::command(), source) {
        Ok(pages) => pages,
        Err(error) => {
            terminal.report_text(&format!("error: the manual cannot be made: {error}"));
            return NOT_REACHED;
        }
    };
    let Some(folder) = out else {
        pages.iter().for_each(|page| terminal.show(&page.text));
        return DONE;
    };
    if let Err(problem) = make_folder(folder) {
        terminal.report(&problem);
        return WRONG_INPUT;
    }
    match command_help::write_manual(&pages, folder) {
        Ok(files) => {
            terminal.show("Written\n");
            for file in files {
                terminal.show(&format!("  {}\n", file.display()));
            }
            DONE
        }
        Err(problem) => {
            terminal.report(&problem);
            NOT_REACHED
        }
    }
}
