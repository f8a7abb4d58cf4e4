//! `expand`: prints a dynamics file with the cards to which its rotors expand.

use std::path::Path;

use shared_geom::error::Explain;
use shared_geom::files::write_text;

use super::terminal::Terminal;
use super::{DONE, WRONG_INPUT};
use crate::input;

/// An output in another folder, where the names of files have another meaning.
#[derive(Debug, thiserror::Error)]
#[error("\"{out}\" is in another folder than \"{file}\"")]
struct OtherFolder {
    file: String,
    out: String,
}

impl Explain for OtherFolder {
    fn help(&self) -> Option<String> {
        let text = "the names of files in it are relative to its folder: write it beside the input";
        Some(text.to_owned())
    }
}

/// Prints the expanded file, or writes it into `out`; returns the exit code.
pub(super) fn expand(file: &Path, out: Option<&Path>, terminal: &mut Terminal<'_>) -> u8 {
    let text = match input::expanded(file) {
        Ok(text) => text,
        Err(problems) => {
            terminal.report_text(&problems.to_string());
            return WRONG_INPUT;
        }
    };
    let Some(out) = out else {
        terminal.show(&text);
        return DONE;
    };
    let folder = |path: &Path| {
        let parent = path
            .parent()
            .filter(|parent| !parent.as_os_str().is_empty());
        parent.unwrap_or(Path::new(".")).canonicalize().ok()
    };
    if folder(file) != folder(out) {
        let [file, out] = [file, out].map(|path| path.display().to_string());
        terminal.report(&OtherFolder { file, out });
        return WRONG_INPUT;
    }
    match write_text(out, &text) {
        Ok(()) => {
            terminal.show(&format!("{}\n", out.display()));
            DONE
        }
        Err(problem) => {
            terminal.report(&problem);
            WRONG_INPUT
        }
    }
}
