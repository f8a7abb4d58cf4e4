//! The figures of a section that need no solution.

use shared_geom::files::OutputProblem;

use crate::input::Input;
use crate::output::{FiberPlot, MeshPlot, ResultWriter};
use crate::properties::Centers;

/// Draws the mesh, with the centers if known, and the fibers if a material has
/// directions.
pub(super) fn draw_section(
    input: &Input,
    centers: Option<&Centers>,
    results: &mut ResultWriter,
) -> Result<(), OutputProblem> {
    let Input {
        section, summary, ..
    } = input;
    let files = results.files().clone();
    results.figure(files.mesh(), || MeshPlot::new(section, summary, centers))?;
    results.figure_where(files.fibers(), || FiberPlot::new(section, summary))
}
