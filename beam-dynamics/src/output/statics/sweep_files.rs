//! The files of equilibria over a parameter.

use shared_geom::files::make_folder;

use super::files::write_static;
use super::names::{SWEEP_FOLDER, SWEEP_PLOT, SWEEP_TABLE, SWEEP_TEXT, remove_all};
use super::sweep::{sweep_csv, sweep_plot, sweep_text};
use crate::input::short_number;
use crate::output::Written;
use crate::output::folder::{ResultLocation, Results};
use crate::output::transient::RunFileProblem;
use crate::result::StaticSweep;

/// Digits of a value in the names of files.
const DIGITS: usize = 9;

/// Writes `NAME.sweep.csv`, `NAME.sweep.txt`, of two equilibria or more the figure `NAME.sweep.png` and
/// `.svg`, and the files of [`write_static`] of each value to the folder `NAME.sweep`, with names that
/// begin with the parameter and its value. Files of an earlier run are removed.
///
/// # Errors
/// [`RunFileProblem::Output`]: a folder or a file cannot be made.
pub fn write_sweep(
    sweep: &StaticSweep,
    location: &ResultLocation,
    span_forces: bool,
) -> Result<Written, RunFileProblem> {
    make_folder(&location.folder)?;
    let mut results = Results::new(location);
    remove_all(&results);
    results.text(SWEEP_TABLE, &sweep_csv(sweep))?;
    results.text(SWEEP_TEXT, &sweep_text(sweep))?;
    results.figures(SWEEP_PLOT, || sweep_plot(sweep))?;
    let folder = results.path(SWEEP_FOLDER);
    for point in &sweep.points {
        let Some(path) = &point.path else { continue };
        let at = short_number(point.at, DIGITS);
        let own = ResultLocation {
            folder: folder.clone(),
            name: format!("{}_{at}", sweep.parameter),
            figures: location.figures,
        };
        write_static(path, &own, span_forces)?;
    }
    results.list_fields(SWEEP_FOLDER);
    Ok(results.written)
}
