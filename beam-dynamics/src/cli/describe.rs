//! `describe`: what blade files hold.

use std::path::{Path, PathBuf};

use shared_geom::exchange::{self, Options};

use crate::output::blade_text;

use super::{DONE, Terminal, WRONG_INPUT};

/// Describes the files one after the other; those that cannot be read are told.
pub(super) fn describe_files(
    files: &[PathBuf],
    length: Option<f64>,
    terminal: &mut Terminal<'_>,
) -> u8 {
    let codes = files.iter().enumerate().map(|(number, file)| {
        if number > 0 {
            terminal.show("\n\n");
        }
        describe(file, length, terminal)
    });
    // All files are described, whatever is wrong with one.
    codes.collect::<Vec<_>>().into_iter().max().unwrap_or(DONE)
}

fn describe(file: &Path, length: Option<f64>, terminal: &mut Terminal<'_>) -> u8 {
    let alone = length.is_none() && exchange::is_section(file);
    let options = Options {
        length: if alone { Some(1.0) } else { length },
    };
    match exchange::read_with(file, &options) {
        Ok((format, mut reading)) => {
            if alone {
                let note =
                    "one section: a blade of it needs --length METERS; described as 1 m of it";
                reading.remarks.insert(0, note.to_owned());
            }
            terminal.show(&blade_text(&file.display().to_string(), format, &reading));
            DONE
        }
        Err(problems) => {
            terminal.tell_text(&problems.to_string());
            WRONG_INPUT
        }
    }
}
