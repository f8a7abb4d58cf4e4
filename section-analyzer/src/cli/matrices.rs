//! `section-analyzer matrices`: the analysis of sections given by their matrices.

use std::path::{Path, PathBuf};

use shared_geom::error::{Diagnostics, Explain, Place};
use shared_geom::files::OutputProblem;
use shared_geom::section;

use super::solved::open_end_effects;
use super::{NOT_REACHED, Stop, Terminal, WRONG_INPUT, list};
use crate::analysis::OutsideAnalysis;
use crate::failure::Failure;
use crate::input::outside::{self, OutsideInput};
use crate::output::{
    OutputFiles, ResultWriter, checks, end_effects, outside_properties, outside_warping_csv,
    outside_warping_vtu, property_report,
};
use crate::section::OutsideSection;
use crate::solution::{EndEffects, SectionSolution};

/// Reads a matrices file, solves, and writes the available results.
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
    // results of an earlier run are removed
    files.remove_results();
    let solved = solve(&input.section).map_err(|failure| {
        let code = match failure {
            Failure::OutOfMemory { .. } => NOT_REACHED,
            // all other failures are due to the matrices
            _ => WRONG_INPUT,
        };
        terminal.tell_text(&told(file, &failure), code)
    })?;
    let mut results = ResultWriter::new(files);
    let report = report(file, &input, &solved);
    write!(terminal.out, "{report}")?;
    let written = write_results(&input, solved.analysis.solution(), &report, &mut results);
    let told = written.map_err(|problem| terminal.tell(&problem, NOT_REACHED));
    list("Written", &results.abandon(), terminal)?;
    told?;
    match solved.open_problem(file) {
        Some(problem) => Err(terminal.tell_text(&problem, NOT_REACHED)),
        None => Ok(()),
    }
}

/// The solution, and the further results that the file requests.
struct Solved {
    analysis: OutsideAnalysis,
    end_effects: Option<EndEffects>,
}

fn solve(section: &OutsideSection) -> Result<Solved, Failure> {
    let analysis = OutsideAnalysis::new(section)?;
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
        Some(told(file, &failure))
    }
}

fn told(file: &Path, failure: &Failure) -> String {
    let place = Place::file(file.display().to_string());
    Diagnostics::one(place, failure).to_string()
}

fn report(file: &Path, input: &OutsideInput, solved: &Solved) -> String {
    let solution = solved.analysis.solution();
    let properties = outside_properties(&input.section, solution, &input.input_hash);
    let text = property_report(&file.display().to_string(), &properties);
    let warnings = solved.analysis.warnings().iter().map(|warning| {
        let help = warning.help().unwrap_or_default();
        format!("  warning: {warning}; {help}\n")
    });
    let warnings: String = warnings.collect();
    let ends = solved.end_effects.as_ref().map(end_effects);
    let heading = if warnings.is_empty() {
        ""
    } else {
        "\nWarnings\n"
    };
    let ends = ends.map_or_else(String::new, |ends| format!("\n{ends}"));
    format!(
        "{text}{heading}{warnings}{ends}\n{}",
        checks(&solution.checks)
    )
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
    results.text(files.warping_table(), &warping)?;
    let field = outside_warping_vtu(&input.section, solution);
    results.add(files.warping_field(), |file| field.write(file))
}
