//! `section-analyzer layup`: describes a layup, and meshes its sections; or writes it as a layup
//! file.

use std::io;
use std::path::Path;

use shared_geom::files::write_text;

use super::arguments::LayupArguments;
use super::{NOT_REACHED, Stop, Terminal, WRONG_INPUT};
use crate::input::layup::{self, Layup, Materials};
use crate::output::{layup_file, layup_report};

/// Describes the stations of a layup, or writes its file.
pub(super) fn describe(
    arguments: &LayupArguments,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let layup = layup::read_with(&arguments.file, materials(arguments.repair_materials))
        .map_err(|problems| terminal.report_all(&problems))?;
    if let Some(out) = &arguments.out {
        return write(&layup, &arguments.file, out, terminal);
    }
    write_remarks(&layup, terminal)?;
    let stations = if arguments.eta.is_empty() {
        layup.positions()
    } else {
        arguments.eta.clone()
    };
    for text in layup.faded_layers(&stations) {
        writeln!(terminal.out, "  remark: {text}")?;
    }
    let mut is_complete = true;
    for eta in stations {
        match layup.mesh(eta) {
            Ok(meshed) => writeln!(terminal.out, "{}", layup_report(&layup, eta, &meshed))?,
            Err(problems) => {
                is_complete = false;
                terminal.report_all(&problems);
            }
        }
    }
    if is_complete {
        Ok(())
    } else {
        Err(Stop::Reported(NOT_REACHED))
    }
}

/// The treatment of impossible materials.
pub(super) fn materials(is_repaired: bool) -> Materials {
    if is_repaired {
        Materials::Repaired
    } else {
        Materials::AsGiven
    }
}

/// Lists the choices of the reader.
pub(super) fn write_remarks(layup: &Layup, terminal: &mut Terminal<'_>) -> io::Result<()> {
    for remark in &layup.remarks {
        writeln!(terminal.out, "  remark: {remark}")?;
    }
    for (layer, line) in layup.absent_layers() {
        let text = format!("line {line}: layer \"{layer}\" is absent at all stations");
        writeln!(terminal.out, "  remark: {text}")?;
    }
    Ok(())
}

/// Writes the layup file of a layup.
fn write(
    layup: &Layup,
    source: &Path,
    out: &Path,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    if out.exists() {
        let text = format!(
            "error: \"{}\" exists already, expected the name of a new layup file\n  help: \
             give another name, or remove the file",
            out.display()
        );
        return Err(terminal.report_text(&text, WRONG_INPUT));
    }
    let name = source.file_name().unwrap_or_default().to_string_lossy();
    write_text(out, &layup_file(layup, &name))
        .map_err(|problem| terminal.report(&problem, WRONG_INPUT))?;
    writeln!(
        terminal.out,
        "{}: {} layers and {} webs",
        out.display(),
        layup.layers.len(),
        layup.webs.len()
    )?;
    Ok(write_remarks(layup, terminal)?)
}
