//! `section-analyzer schema`: the description of the section file.

use std::path::Path;

use shared_geom::files::write_text;

use super::arguments::SchemaFormat;
use super::{Stop, Terminal, WRONG_INPUT};
use crate::input::schema::{json_schema, reference};

/// Prints the description, or writes it into `out`.
pub(super) fn write_schema(
    format: SchemaFormat,
    out: Option<&Path>,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let text = match format {
        SchemaFormat::Json => format!("{:#}\n", json_schema()),
        SchemaFormat::Markdown => reference(),
    };
    let Some(file) = out else {
        return Ok(terminal.out.write_all(text.as_bytes())?);
    };
    write_text(file, &text).map_err(|problem| terminal.report(&problem, WRONG_INPUT))?;
    Ok(writeln!(terminal.out, "{}", file.display())?)
}
