//! `section-analyzer layup`: describes a layup, and meshes its sections.

use super::arguments::LayupArguments;
use super::{NOT_REACHED, Stop, Terminal};
use crate::input::layup;
use crate::output::layup_report;

/// Describes the stations of a layup.
pub(super) fn describe(
    arguments: &LayupArguments,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let layup = layup::read(&arguments.file).map_err(|problems| terminal.report_all(&problems))?;
    let stations = match arguments.eta.is_empty() {
        true => layup.positions(),
        false => arguments.eta.clone(),
    };
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
