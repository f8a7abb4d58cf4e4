//! `section-analyzer check`: what is wrong with a section file, without solving it.

use std::path::{Path, PathBuf};

use shared_geom::files::write_figure;

use super::{Stop, Terminal, WRONG_INPUT, list};
use crate::input::{self, Input};
use crate::output::{FiberPlot, MeshPlot, OutputFiles, input_report};

/// Reads and checks a section file; draws the section into the folder `out`.
pub(super) fn check_file(
    file: &Path,
    out: Option<PathBuf>,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let input = terminal.read(file)?;
    let report = input_report(&input.section, &input.summary);
    write!(terminal.out, "{report}\nNo problem found\n")?;
    match out {
        Some(folder) => draw(file, &folder, &input, terminal),
        None => Ok(()),
    }
}

/// Draws mesh and fibers.
fn draw(
    file: &Path,
    folder: &Path,
    input: &Input,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let files = OutputFiles::new(folder, &input::name_of(file))
        .map_err(|problem| terminal.tell(&problem, WRONG_INPUT))?;
    let Input { section, summary } = input;
    let mesh = MeshPlot::new(section, summary, None);
    let mut paths = vec![files.mesh()];
    let mut written = write_figure(&files.mesh(), mesh.size(), &mesh);
    match FiberPlot::new(section, summary) {
        Some(fibers) => {
            paths.push(files.fibers());
            written = written.and_then(|()| write_figure(&files.fibers(), fibers.size(), &fibers));
        }
        None => files.remove_fibers(),
    }
    list(&paths, written, terminal)
}
