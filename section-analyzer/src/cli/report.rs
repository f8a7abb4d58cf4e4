//! `section-analyzer report`: shows property files as text and tables.

use super::arguments::ReportArguments;
use super::{Stop, Terminal};
use crate::output::property_report;

/// Shows every file that can be read, and reports the problems of the others.
pub(super) fn report_files(
    arguments: &ReportArguments,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let mut wrong = None;
    let mut shown = 0;
    for file in &arguments.files {
        match terminal.read_properties(file) {
            Ok(properties) => {
                let space = if shown > 0 { "\n" } else { "" };
                let text = property_report(&file.display().to_string(), &properties);
                write!(terminal.out, "{space}{text}")?;
                shown += 1;
            }
            Err(stop) => wrong = Some(stop),
        }
    }
    wrong.map_or(Ok(()), Err)
}
