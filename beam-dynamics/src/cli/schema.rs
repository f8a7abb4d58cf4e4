//! `beam-dynamics schema`: the descriptions of the input files.

use std::path::Path;

use shared_geom::blade::BLADE_FILE;
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
        (SchemaFile::Blade, SchemaFormat::Json) => format!("{:#}\n", BLADE_FILE.json_schema()),
        (SchemaFile::Blade, SchemaFormat::Markdown) => BLADE_FILE.reference(),
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
