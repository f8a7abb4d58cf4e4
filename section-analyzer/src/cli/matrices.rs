//! `section-analyzer matrices`: the analysis of sections given by their matrices.

use std::path::{Path, PathBuf};

use shared_geom::error::{Diagnostics, Explain, SourceLocation};
use shared_geom::files::OutputProblem;
use shared_geom::section;

use super::solved::open_end_effects;
use super::{NOT_REACHED, Stop, Terminal, WRONG_INPUT, list, list_removed};
use crate::analysis::ExternalAnalysis;
use crate::failure::Failure;
use crate::input::external::{self, ExternalInput};
use crate::output::{
    OutputFiles, ResultWriter, checks, end_effects, external_properties, external_warping_csv,
    external_warping_vtu, property_report,
};
use crate::section::ExternalSection;
use crate::solution::{EndEffects, SectionSolution};

/// Reads a matrices file, solves, and writes the available results.
pub(super) fn analyze_file(
    file: &Path,
    out: Option<PathBuf>,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let input = external::read(file).map_err(|problems| terminal.report_all(&problems))?;
    let beside = || file.parent().unwrap_or(Path::new("")).join("results");
    let folder = out.unwrap_or_else(beside);
    let files = OutputFiles::new(&folder, &external::name_of(file))
        .map_err(|problem| terminal.report(&problem, WRONG_INPUT))?;
    let earlier = files.earlier();
    // results of an earlier run are removed
    files.remove_results();
    let solved = solve(&input.section).map_err(|failure| {
        let code = match failure {
            Failure::OutOfMemory { .. } => NOT_REACHED,
            // all other failures are due to the matrices
            _ => WRONG_INPUT,
        };
        terminal.report_text(&reported(file, &failure), code)
    })?;
    let mut results = ResultWriter::new(files);
    let warnings = warnings(&solved);
    let report = report(file, &input, &solved, &warnings);
    write!(terminal.out, "{report}")?;
    terminal.warn_if_quiet(file, &warnings)?;
    let written = write_results(&input, solved.analysis.solution(), &report, &mut results);
    let reported = written.map_err(|problem| terminal.report(&problem, NOT_REACHED));
    list("Written", &results.abandon(), terminal)?;
    list_removed(&earlier.removed(), terminal)?;
    reported?;
    match solved.open_problem(file) {
        Some(problem) => Err(terminal.report_text(&problem, NOT_REACHED)),
        None => Ok(()),
    }
}

/// The solution, and the further results that the file requests.
struct Solved {
    analysis: ExternalAnalysis,
    end_effects: Option<EndEffects>,
}

fn solve(section: &ExternalSection) -> Result<Solved, Failure> {
    let analysis = ExternalAnalysis::new(section)?;
    let found = section
        .end_effects
        .map(|wanted| analysis.end_effects(wanted));
    let end_effects = found.transpose()?;
    Ok(Solved {
        analysis,
        end_effects,
    })
}

impl Solved {
    /// Searches that did not converge, as text.
    fn open_problem(&self, file: &Path) -> Option<String> {
        let failure = open_end_effects(self.end_effects.as_ref()?)?;
        Some(reported(file, &failure))
    }
}

fn reported(file: &Path, failure: &Failure) -> String {
    let location = SourceLocation::file(file.display().to_string());
    Diagnostics::one(location, failure).to_string()
}

fn warnings(solved: &Solved) -> Vec<String> {
    let warnings = solved.analysis.warnings().iter();
    let shown = warnings.map(|warning| {
        let help = warning.help().unwrap_or_default();
        format!("{warning}; {help}")
    });
    shown.collect()
}

fn report(file: &Path, input: &ExternalInput, solved: &Solved, warnings: &[String]) -> String {
    let solution = solved.analysis.solution();
    let properties = external_properties(&input.section, solution, &input.input_hash);
    let text = property_report(&file.display().to_string(), &properties);
    let warnings = warnings
        .iter()
        .map(|warning| format!("  remark: {warning}\n"));
    let warnings: String = warnings.collect();
    let ends = solved.end_effects.as_ref().map(end_effects);
    let heading = if warnings.is_empty() {
        ""
    } else {
        "\nRemarks\n"
    };
    let ends = ends.map_or_else(String::new, |ends| format!("\n{ends}"));
    format!(
        "{text}{heading}{warnings}{ends}\n{}",
        checks(&solution.checks)
    )
}

fn write_results(
    input: &ExternalInput,
    solution: &SectionSolution,
    report: &str,
    results: &mut ResultWriter,
) -> Result<(), OutputProblem> {
    let files = results.files().clone();
    let properties = external_properties(&input.section, solution, &input.input_hash);
    results.text(files.properties(), &section::write(&properties))?;
    results.text(files.report(), report)?;
    let warping = external_warping_csv(&input.section, solution);
    results.text(files.warping_table(), &warping)?;
    let field = external_warping_vtu(&input.section, solution);
    results.add(files.warping_field(), |file| field.write(file))
}
