//! `section-analyzer check`: what is wrong with a section file, without solving it.

use std::path::Path;

use super::{Stop, Terminal};
use crate::output::input_report;

/// Reads and checks a section file.
pub(super) fn check_file(file: &Path, terminal: &mut Terminal<'_>) -> Result<(), Stop> {
    let input = terminal.read(file)?;
    let report = input_report(&input.section, &input.summary);
    Ok(write!(terminal.out, "{report}\nNo problem found\n")?)
}
