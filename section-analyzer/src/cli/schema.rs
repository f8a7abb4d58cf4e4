//! `section-analyzer schema`: the descriptions of the input files.

use std::path::Path;

use shared_geom::files::write_text;

use super::arguments::{SchemaFile, SchemaFormat};
use super::{Stop, Terminal, WRONG_INPUT};
use crate::input::schema::{BLADE, LAYUP, MATRICES, SECTION};

/// Prints the description, or writes it into `out`.
pub(super) fn write_schema(
    (of, format): (SchemaFile, SchemaFormat),
    out: Option<&Path>,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let description = match of {
        SchemaFile::Section => SECTION,
        SchemaFile::Blade => BLADE,
        SchemaFile::Layup => LAYUP,
        SchemaFile::Matrices => MATRICES,
    };
    let text = match format {
        SchemaFormat::Json => format!("{:#}\n", description.json_schema()),
        SchemaFormat::Markdown => description.reference(),
    };
    let Some(file) = out else {
        return Ok(terminal.out.write_all(text.as_bytes())?);
    };
    write_text(file, &text).map_err(|problem| terminal.report(&problem, WRONG_INPUT))?;
    Ok(writeln!(terminal.out, "{}", file.display())?)
}
