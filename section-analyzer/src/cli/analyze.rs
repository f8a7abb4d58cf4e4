//! `section-analyzer analyze`: from a section file to its results.

use std::path::{Path, PathBuf};

use shared_geom::error::{Diagnostics, Place};
use shared_geom::files::{OutputProblem, write_figure, write_text};

use super::stress::Stresses;
use super::{NOT_REACHED, Stop, Terminal, WRONG_INPUT, list};
use crate::analysis::analyze;
use crate::input::{self, Input};
use crate::output::{
    MeshPlot, OutputFiles, WarpingPlot, areas_csv, constants_csv, failure_report, properties,
    report, warping_vtu,
};
use crate::properties::RestrainedWarping;
use crate::solution::SectionSolution;

/// Analyzes one section and writes its results.
pub(super) fn analyze_file(
    file: &Path,
    out: Option<PathBuf>,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let input = terminal.read(file)?;
    let folder = out.unwrap_or_else(|| file.parent().unwrap_or(Path::new("")).join("results"));
    let name = input::name_of(file);
    let files =
        OutputFiles::new(&folder, &name).map_err(|problem| terminal.tell(&problem, WRONG_INPUT))?;
    let Input {
        section, summary, ..
    } = &input;

    match analyze(section) {
        Ok(solution) => {
            let properties = properties(section, &solution, &summary.input_hash);
            let restrained = RestrainedWarping::new(section, &solution.warping, &solution.strain);
            let text = report(section, summary, &solution, &restrained);
            let written = write_text(&files.report(), &text)
                .and_then(|()| {
                    write_text(
                        &files.properties(),
                        &shared_geom::section::write(&properties),
                    )
                })
                .and_then(|()| write_text(&files.areas(), &areas_csv(&summary.areas)))
                .and_then(|()| match &restrained {
                    Ok(constants) => write_text(&files.constants(), &constants_csv(constants)),
                    Err(_) => {
                        files.remove_constants();
                        Ok(())
                    }
                })
                .and_then(|()| write_fields(&input, &solution, &files));
            let stresses = Stresses::write(&input, &solution, &files);
            write!(terminal.out, "{text}")?;
            let mut paths = vec![files.properties(), files.report(), files.areas()];
            paths.extend(restrained.is_ok().then(|| files.constants()));
            paths.extend([files.mesh(), files.warping(), files.warping_field()]);
            stresses.end(file, paths, written, terminal)
        }
        Err(failure) => {
            files.remove_results();
            for load in &input.loads {
                files.remove_stresses(&load.name);
            }
            let text = failure_report(section, summary, &failure);
            let mesh = MeshPlot::new(section, summary, None);
            let written = write_text(&files.report(), &text)
                .and_then(|()| write_figure(&files.mesh(), mesh.size(), &mesh));
            let place = Place::file(file.display().to_string());
            let problem = Diagnostics::one(place, &failure);
            let stop = terminal.tell_text(&problem.to_string(), NOT_REACHED);
            list(&[files.report(), files.mesh()], written, terminal)?;
            Err(stop)
        }
    }
}

/// The figures of the mesh and of the warping, and the warping as a field file.
fn write_fields(
    input: &Input,
    solution: &SectionSolution,
    files: &OutputFiles,
) -> Result<(), OutputProblem> {
    let Input {
        section, summary, ..
    } = input;
    let mesh = MeshPlot::new(section, summary, Some(&solution.centers));
    write_figure(&files.mesh(), mesh.size(), &mesh)?;
    let warping = WarpingPlot::new(section, solution);
    write_figure(&files.warping(), warping.size(), &warping)?;
    warping_vtu(section, solution).write(&files.warping_field())
}
