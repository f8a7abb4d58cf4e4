//! `section-analyzer report`: shows property files as text and tables.

use std::path::PathBuf;

use super::arguments::ReportArguments;
use super::{Stop, Terminal};
use crate::input::span_loads::{is_blade, read_stations};
use crate::output::property_report;

/// The ending of property files.
const PROPERTIES: &str = ".properties.json";

/// Shows every file that can be read, of blades the ones of their stations, and reports the problems of
/// the others.
pub(super) fn report_files(
    arguments: &ReportArguments,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let mut wrong = None;
    let mut files: Vec<PathBuf> = Vec::new();
    for file in &arguments.files {
        if !is_blade(file) {
            files.push(file.clone());
            continue;
        }
        match read_stations(file) {
            Ok(stations) => files.extend(stations.iter().map(|station| {
                let name = format!("{}{PROPERTIES}", station.section);
                station.folder.join(name)
            })),
            Err(problems) => wrong = Some(terminal.report_all(&problems)),
        }
    }
    let mut shown = 0;
    for file in &files {
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
