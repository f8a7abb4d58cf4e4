//! `beam-dynamics schema`: the description of the dynamics file and of the rotor file.

use std::path::Path;

use shared_geom::files::write_text;

use super::arguments::{SchemaFile, SchemaFormat};
use super::terminal::Terminal;
use super::{DONE, WRONG_INPUT};
use crate::input::schema::{json_schema, reference};
use crate::input::{rotor_json_schema, rotor_reference};

/// Prints the description, or writes it into `out`; returns the exit code.
pub(super) fn write_schema(
    (of, format): (SchemaFile, SchemaFormat),
    out: Option<&Path>,
    terminal: &mut Terminal<'_>,
) -> u8 {
    let text = match (of, format) {
        (SchemaFile::Dynamics, SchemaFormat::Json) => format!("{:#}\n", json_schema()),
        (SchemaFile::Dynamics, SchemaFormat::Markdown) => reference(),
        (SchemaFile::Rotor, SchemaFormat::Json) => format!("{:#}\n", rotor_json_schema()),
        (SchemaFile::Rotor, SchemaFormat::Markdown) => rotor_reference(),
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
