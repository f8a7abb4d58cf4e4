//! `beam-dynamics schema`: the description of the dynamics file.

use std::path::Path;

use shared_geom::files::write_text;

use super::arguments::SchemaFormat;
use super::terminal::Terminal;
use super::{DONE, WRONG_INPUT};
use crate::input::schema::{json_schema, reference};

/// Prints the description, or writes it into `out`; returns the exit code.
pub(super) fn write_schema(
    format: SchemaFormat,
    out: Option<&Path>,
    terminal: &mut Terminal<'_>,
) -> u8 {
    let text = match format {
        SchemaFormat::Json => format!("{:#}\n", json_schema()),
        SchemaFormat::Markdown => reference(),
    };
    let Some(file) = out else {
        terminal.show(&text);
        return DONE;
    };
    match write_text(file, &text) {
        Ok(()) => {
            terminal.show(&format!("{}\n", file.display()));
            DONE
        }
        Err(problem) => {
            terminal.report(&problem);
            WRONG_INPUT
        }
    }
}
