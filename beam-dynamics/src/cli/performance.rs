//! `performance`: powers and loads of rigid rotors at their operating points.

use std::path::PathBuf;

use super::arguments::Results;
use super::terminal::Terminal;
use super::{WRONG_INPUT, files, finish, in_folder, result_locations};
use crate::analysis::performance::performance;
use crate::case::PerformanceCase;
use crate::input;
use crate::output::{self, ResultLocation};
use crate::result::{PerformanceResult, PointStatus};

/// `performance FILE...`
pub(super) fn performance_of_files(
    paths: &[PathBuf],
    results: &Results,
    terminal: &mut Terminal<'_>,
) -> u8 {
    let locations = match result_locations(paths, results) {
        Ok(locations) => locations,
        Err(problem) => {
            terminal.report(&problem);
            return WRONG_INPUT;
        }
    };
    let read = files::each(paths, terminal, |file, terminal| {
        let case = input::read_rotor(file);
        case.map_err(|problems| terminal.report_text(&problems.to_string()))
            .ok()
    });
    let Some(cases) = read.into_iter().collect::<Option<Vec<_>>>() else {
        return WRONG_INPUT;
    };
    let jobs: Vec<_> = cases.iter().zip(&locations).collect();
    files::worst_of(&jobs, terminal, |(case, location), terminal| {
        in_folder(location, "performance", terminal, |terminal| {
            performance_of(case, location, terminal)
        })
    })
}

/// Computes all points of one rotor, writes the results, and prints them.
fn performance_of(
    case: &PerformanceCase,
    location: &ResultLocation,
    terminal: &mut Terminal<'_>,
) -> u8 {
    let result = performance(case);
    let written = output::write_performance(&result, location);
    terminal.remark(&location.name, &result.remarks);
    terminal.show(&output::performance_text(&result));
    finish(failure(&result), written, terminal)
}

/// The report of points at which rated power is not reached.
fn failure(result: &PerformanceResult) -> Option<String> {
    let points = result.tables.iter().flat_map(|table| &table.points);
    let mut failed = points.filter(|point| point.status == PointStatus::NoPitch);
    let first = failed.next()?.setting().speed;
    let others = match failed.count() {
        0 => String::new(),
        count => format!(" and {count} more speeds"),
    };
    Some(format!(
        "error: {}: no pitch between \"pitch\" and \"largest_pitch\" gives rated power at {first} \
         m/s{others}\n  help: check rated_power and largest_pitch of [[power_curve]]; these points \
         are at the pitch below rated power",
        result.name
    ))
}
