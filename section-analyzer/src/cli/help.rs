//! `section-analyzer completions` and `manual`: scripts for shells and pages for `man`,
//! from the arguments of the command line.

use std::path::Path;

use clap::{Command, CommandFactory};
use clap_complete::Shell;
use shared_geom::files::{make_folder, write_text};

use super::arguments::Arguments;
use super::{NOT_REACHED, Stop, Terminal, WRONG_INPUT, list};

/// Prints the completion script of a shell.
pub(super) fn write_completions(shell: Shell, terminal: &mut Terminal<'_>) -> Result<(), Stop> {
    let mut command = Arguments::command();
    let name = command.get_name().to_owned();
    // Into memory first: the generator cannot report a closed pipe.
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut command, name, &mut script);
    Ok(terminal.out.write_all(&script)?)
}

/// Prints all manual pages, or writes each into the folder `out`.
pub(super) fn write_manual(out: Option<&Path>, terminal: &mut Terminal<'_>) -> Result<(), Stop> {
    let mut command = Arguments::command().disable_help_subcommand(true);
    command.build();
    let mut pages = Vec::new();
    collect_pages(&command, &mut pages)?;
    let Some(folder) = out else {
        for (_, page) in pages {
            terminal.out.write_all(page.as_bytes())?;
        }
        return Ok(());
    };
    make_folder(folder).map_err(|problem| terminal.tell(&problem, WRONG_INPUT))?;
    let files: Vec<_> = pages.iter().map(|(file, _)| folder.join(file)).collect();
    let mut pages = files.iter().zip(&pages);
    let written = pages.try_for_each(|(file, (_, page))| write_text(file, page));
    written.map_err(|problem| terminal.tell(&problem, NOT_REACHED))?;
    list("Written", &files, terminal)
}

/// The page of a command, then the pages of its own commands: file name and text.
fn collect_pages(command: &Command, pages: &mut Vec<(String, String)>) -> Result<(), Stop> {
    let source = concat!(env!("CARGO_PKG_NAME"), " ", env!("CARGO_PKG_VERSION"));
    let page = clap_mangen::Man::new(command.clone()).source(source);
    let mut text = Vec::new();
    page.render(&mut text)?;
    let text = String::from_utf8_lossy(&text).into_owned();
    pages.push((page.get_filename(), text));
    for inner in command.get_subcommands() {
        collect_pages(inner, pages)?;
    }
    Ok(())
}
