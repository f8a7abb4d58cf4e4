//! The files of stability over a parameter.

use shared_geom::files::{OutputProblem, make_folder};

use super::plot::StabilityPlot;
use super::table::{boundary_csv, stability_csv};
use super::text::{modes_text, roots_text, stability_text};
use crate::output::Written;
use crate::output::folder::{ResultLocation, Results};
use crate::result::StabilityResult;

const TABLE: &str = "stability.csv";
const BOUNDARIES: &str = "boundaries.csv";
const TEXT: &str = "stability.txt";
const PLOT: [&str; 2] = ["stability.png", "stability.svg"];

/// Writes `NAME.stability.csv`, `NAME.boundaries.csv`, `NAME.stability.txt` and the figure
/// `NAME.stability.png` and `.svg`.
///
/// # Errors
/// [`OutputProblem`]: the folder or a file cannot be made.
pub fn write_stability(
    result: &StabilityResult,
    location: &ResultLocation,
) -> Result<Written, OutputProblem> {
    make_folder(&location.folder)?;
    let mut results = Results::new(location);
    results.remove([TABLE, BOUNDARIES, TEXT].into_iter().chain(PLOT));
    results.text(TABLE, &stability_csv(result))?;
    results.text(BOUNDARIES, &boundary_csv(result))?;
    let text = stability_text(result) + &modes_text(result) + &roots_text(result);
    results.text(TEXT, &text)?;
    results.figures(PLOT, || StabilityPlot::new(result))?;
    Ok(results.written)
}
