//! The figures of a section that need no solution.

use std::cell::LazyCell;

use shared_geom::files::OutputProblem;

use crate::input::Input;
use crate::output::{FiberPlot, MeshPlot, Outline, ResultWriter};
use crate::properties::Centers;

/// Draws the mesh, with the centers if known, and the fibers if a material has
/// directions.
pub(super) fn draw_section(
    input: &Input,
    outline: &LazyCell<Outline, impl FnOnce() -> Outline>,
    centers: Option<&Centers>,
    results: &mut ResultWriter,
) -> Result<(), OutputProblem> {
    let Input {
        section, summary, ..
    } = input;
    let files = results.files().clone();
    results.figure(files.mesh(), || {
        MeshPlot::new(section, outline, summary, centers)
    })?;
    results.figure_where(files.fibers(), || FiberPlot::new(section, outline, summary))
}
