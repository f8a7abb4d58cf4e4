//! `section-analyzer matrices`: the analysis of sections given by their matrices.

use std::path::{Path, PathBuf};

use shared_geom::error::{Diagnostics, Place};
use shared_geom::files::OutputProblem;
use shared_geom::section;

use super::{NOT_REACHED, Stop, Terminal, WRONG_INPUT, list};
use crate::analysis::analyze_matrices;
use crate::failure::Failure;
use crate::input::outside::{self, OutsideInput};
use crate::output::{
    OutputFiles, ResultWriter, checks, outside_properties, outside_warping_csv, property_report,
};
use crate::solution::SectionSolution;

/// Reads a matrices file, solves, and writes what there is.
pub(super) fn analyze_file(
    file: &Path,
    out: Option<PathBuf>,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let input = outside::read(file).map_err(|problems| terminal.tell_all(&problems))?;
    let beside = || file.parent().unwrap_or(Path::new("")).join("results");
    let folder = out.unwrap_or_else(beside);
    let files = OutputFiles::new(&folder, &outside::name_of(file))
        .map_err(|problem| terminal.tell(&problem, WRONG_INPUT))?;
    // results of an earlier run do not outlive this one
    files.remove_results();
    let solution = match analyze_matrices(&input.section) {
        Ok(solution) => solution,
        Err(failure) => {
            let code = match failure {
                Failure::Matrices { .. } => WRONG_INPUT,
                _ => NOT_REACHED,
            };
            let place = Place::file(file.display().to_string());
            let problems = Diagnostics::one(place, &failure).to_string();
            return Err(terminal.tell_text(&problems, code));
        }
    };
    let mut results = ResultWriter::new(files);
    let report = report(file, &input, &solution);
    write!(terminal.out, "{report}")?;
    let written = write_results(&input, &solution, &report, &mut results);
    let told = written.map_err(|problem| terminal.tell(&problem, NOT_REACHED));
    list("Written", &results.abandon(), terminal)?;
    told
}

fn report(file: &Path, input: &OutsideInput, solution: &SectionSolution) -> String {
    let properties = outside_properties(&input.section, solution, &input.input_hash);
    let text = property_report(&file.display().to_string(), &properties);
    format!("{text}\n{}", checks(&solution.checks))
}

fn write_results(
    input: &OutsideInput,
    solution: &SectionSolution,
    report: &str,
    results: &mut ResultWriter,
) -> Result<(), OutputProblem> {
    let files = results.files().clone();
    let properties = outside_properties(&input.section, solution, &input.input_hash);
    results.text(files.properties(), &section::write(&properties))?;
    results.text(files.report(), report)?;
    let warping = outside_warping_csv(&input.section, solution);
    results.text(files.warping_table(), &warping)
}
