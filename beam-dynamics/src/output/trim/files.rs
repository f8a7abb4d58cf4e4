//! The files of a trim, and the figure of a sweep.

use shared_geom::files::{OutputProblem, make_folder};

use super::table::trim_csv;
use super::text::trim_text;
use crate::output::Written;
use crate::output::folder::{ResultLocation, Results};
use crate::result::{TrimPoint, TrimResult};
use shared_geom::figure::{Panel, PanelPlot};

const TABLE: &str = "trim.csv";
const TEXT: &str = "trim.txt";
const PLOT: [&str; 2] = ["trim.png", "trim.svg"];

/// Writes `NAME.trim.csv`, `NAME.trim.txt` and, of a sweep, the figure `NAME.trim.png` and `.svg`.
///
/// # Errors
/// [`OutputProblem`]: the folder or a file cannot be made.
pub fn write_trim(
    result: &TrimResult,
    location: &ResultLocation,
) -> Result<Written, OutputProblem> {
    make_folder(&location.folder)?;
    let mut results = Results::new(location);
    results.remove([TABLE, TEXT].into_iter().chain(PLOT));
    results.text(TABLE, &trim_csv(result))?;
    results.text(TEXT, &trim_text(result))?;
    results.figures(PLOT, || plot(result))?;
    Ok(results.written)
}

/// Controls and targets over the sweep; `None` for less than two points.
fn plot(result: &TrimResult) -> Option<PanelPlot> {
    let sweep = result.sweep.as_ref()?;
    if result.met().count() < 2 {
        return None;
    }
    let curve = |value: &dyn Fn(&TrimPoint) -> f64| {
        let points = result.met();
        points
            .map(|point| [point.at.unwrap_or(f64::NAN), value(point)])
            .collect::<Vec<_>>()
    };
    let panel = |title: &String, points| Panel {
        title: title.clone(),
        curves: vec![points],
    };
    let controls = result.controls.iter().enumerate();
    let controls = controls.map(|(i, name)| panel(name, curve(&|point| point.controls[i])));
    let targets = result.targets.iter().enumerate();
    let targets = targets.map(|(i, name)| panel(name, curve(&|point| point.targets[i][0])));
    Some(PanelPlot {
        title: format!("{}: trim", result.name),
        across: sweep.clone(),
        names: Vec::new(),
        panels: controls.chain(targets).collect(),
    })
}
