//! Completion scripts and manual pages of a program, from the arguments of its command line.

use std::io;
use std::path::{Path, PathBuf};

use clap::Command;
use clap::error::{ContextKind, ContextValue};
pub use clap_complete::Shell;

use crate::error::nearest_name;
use crate::files::{OutputProblem, make_folder, write_text};

/// A manual page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ManualPage {
    /// Name of its file, `PROGRAM-COMMAND.1`.
    pub file: String,
    /// Its text in roff.
    pub text: String,
}

/// The completion script of a shell.
pub fn completions(mut command: Command, shell: Shell) -> Vec<u8> {
    let name = command.get_name().to_owned();
    // Into memory: the generator cannot report a closed pipe.
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut command, name, &mut script);
    script
}

/// The error of an unknown command, of whose tips the near commands are left, the nearest first; other
/// errors as they are.
pub fn with_near_commands(mut error: clap::Error) -> clap::Error {
    let Some(ContextValue::String(found)) = error.get(ContextKind::InvalidSubcommand) else {
        return error;
    };
    let found = found.clone();
    if let Some(ContextValue::Strings(mut names)) = error.remove(ContextKind::SuggestedSubcommand) {
        let mut near = Vec::new();
        while let Some(name) = nearest_name(&found, names.iter().map(String::as_str)) {
            let name = name.to_owned();
            names.retain(|other| *other != name);
            near.push(name);
        }
        if !near.is_empty() {
            error.insert(
                ContextKind::SuggestedSubcommand,
                ContextValue::Strings(near),
            );
        }
    }
    error
}

/// The pages of the program and of all its commands; `source` is its name and version.
///
/// # Errors
/// Errors of the generator.
pub fn manual(command: Command, source: &str) -> io::Result<Vec<ManualPage>> {
    let mut command = command.disable_help_subcommand(true);
    command.build();
    let mut pages = Vec::new();
    collect(&command, source, &mut pages)?;
    Ok(pages)
}

/// The page of a command, then the pages of its own commands.
fn collect(command: &Command, source: &str, pages: &mut Vec<ManualPage>) -> io::Result<()> {
    let page = clap_mangen::Man::new(command.clone()).source(source.to_owned());
    let mut text = Vec::new();
    page.render(&mut text)?;
    pages.push(ManualPage {
        file: page.get_filename(),
        text: String::from_utf8_lossy(&text).into_owned(),
    });
    let mut inner = command.get_subcommands();
    inner.try_for_each(|inner| collect(inner, source, pages))
}

/// Writes each page into `folder`, which is created if it does not exist; returns the files.
///
/// # Errors
/// [`OutputProblem`], for the folder or a file.
pub fn write_manual(pages: &[ManualPage], folder: &Path) -> Result<Vec<PathBuf>, OutputProblem> {
    make_folder(folder)?;
    let write = |page: &ManualPage| {
        let file = folder.join(&page.file);
        write_text(&file, &page.text).map(|()| file)
    };
    pages.iter().map(write).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn program() -> Command {
        let run = Command::new("run").about("Runs it");
        Command::new("engine").about("An engine").subcommand(run)
    }

    #[test]
    fn every_command_has_a_page_and_a_completion() {
        let pages = manual(program(), "engine 1.0").unwrap();
        let files: Vec<_> = pages.iter().map(|page| page.file.as_str()).collect();
        assert_eq!(files, ["engine.1", "engine-run.1"]);
        assert!(pages[1].text.contains("Runs it"));
        let folder = tempfile::tempdir().unwrap();
        let written = write_manual(&pages, &folder.path().join("man1")).unwrap();
        assert!(written.iter().all(|file| file.exists()));
        let script = String::from_utf8(completions(program(), Shell::Bash)).unwrap();
        assert!(script.contains("engine") && script.contains("run"));
    }

    /// The library proposes `manual` for `analyse`, and before `analyze`.
    #[test]
    fn only_near_commands_are_proposed() {
        let tip = |known: &[&'static str], found: &str| {
            let commands = known.iter().map(|name| Command::new(*name));
            let program = Command::new("engine").subcommands(commands);
            let error = program.try_get_matches_from(["engine", found]).unwrap_err();
            let shown = with_near_commands(error).render().to_string();
            let tip = shown
                .lines()
                .find(|line| line.contains("tip:"))
                .unwrap_or_default();
            tip.trim().to_owned()
        };
        let proposed = "tip: a similar subcommand exists: 'analyze'";
        assert_eq!(tip(&["manual", "analyze"], "analyse"), proposed);
        assert_eq!(tip(&["manual", "modes"], "analyse"), "");
    }
}
