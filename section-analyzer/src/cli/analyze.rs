//! `section-analyzer analyze`: from a section file to its results.

use std::path::{Path, PathBuf};

use shared_geom::error::{Diagnostics, Place};
use shared_geom::files::{write_figure, write_text};

use super::{NOT_REACHED, Stop, Terminal, WRONG_INPUT, list};
use crate::analysis::analyze;
use crate::input::{self, Input};
use crate::output::{
    MeshPlot, OutputFiles, WarpingPlot, failure_report, properties, report, warping_vtu,
};

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
    let Input { section, summary } = &input;

    match analyze(section) {
        Ok(solution) => {
            let properties = properties(section, &solution, &summary.input_hash);
            let text = report(section, summary, &solution);
            let mesh = MeshPlot::new(section, summary, Some(&solution.centers));
            let warping = WarpingPlot::new(section, &solution);
            let written = write_text(&files.report(), &text)
                .and_then(|()| {
                    write_text(
                        &files.properties(),
                        &shared_geom::section::write(&properties),
                    )
                })
                .and_then(|()| write_figure(&files.mesh(), mesh.size(), &mesh))
                .and_then(|()| write_figure(&files.warping(), warping.size(), &warping))
                .and_then(|()| warping_vtu(section, &solution).write(&files.warping_field()));
            write!(terminal.out, "{text}")?;
            list(
                &[
                    files.properties(),
                    files.report(),
                    files.mesh(),
                    files.warping(),
                    files.warping_field(),
                ],
                written,
                terminal,
            )
        }
        Err(failure) => {
            files.remove_results();
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
