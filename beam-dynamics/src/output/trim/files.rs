//! The files of a trim, and the figure of a sweep.

use shared_geom::files::{OutputProblem, make_folder};

use super::json::trim_json;
use super::table::trim_csv;
use super::text::{trim_failure, trim_text};
use crate::output::Written;
use crate::output::folder::{ResultLocation, Results};
use crate::result::TrimResult;
use shared_geom::figure::{Panel, PanelPlot};

const TABLE: &str = "trim.csv";
const TEXT: &str = "trim.txt";
const JSON: &str = "trim.json";
const PLOT: [&str; 2] = ["trim.png", "trim.svg"];

/// Writes `NAME.trim.csv`, `NAME.trim.txt`, with `json` `NAME.trim.json`, and, of a sweep, the
/// figure `NAME.trim.png` and `.svg`.
///
/// # Errors
/// [`OutputProblem`]: the folder or a file cannot be made.
pub fn write_trim(
    result: &TrimResult,
    location: &ResultLocation,
    json: bool,
) -> Result<Written, OutputProblem> {
    make_folder(&location.folder)?;
    let mut results = Results::new(location);
    results.remove([TABLE, TEXT, JSON].into_iter().chain(PLOT));
    results.text(TABLE, &trim_csv(result))?;
    let failure = trim_failure(result).map(|text| format!("error{text}\n"));
    results.text(TEXT, &(trim_text(result) + &failure.unwrap_or_default()))?;
    if json {
        results.text(JSON, &trim_json(result))?;
    }
    results.figures(PLOT, || plot(result))?;
    Ok(results.written)
}

/// Controls over the sweep; `None` for less than two points. The targets have their values at all
/// points that are met.
fn plot(result: &TrimResult) -> Option<PanelPlot> {
    let sweep = result.sweep.as_ref()?;
    if result.met().count() < 2 {
        return None;
    }
    let controls = result.controls.iter().enumerate();
    let panel = |(i, name): (usize, &String)| Panel {
        title: name.clone(),
        curves: vec![
            result
                .met()
                .map(|point| [point.at.unwrap_or(f64::NAN), point.controls[i]])
                .collect(),
        ],
    };
    Some(PanelPlot {
        title: format!("{}: trim", result.name),
        across: sweep.clone(),
        names: Vec::new(),
        panels: controls.map(panel).collect(),
    })
}
