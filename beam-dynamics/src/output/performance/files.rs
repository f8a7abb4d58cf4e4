//! The files of the performance of a rotor.

use shared_geom::files::{OutputProblem, make_folder};

use super::curves::curve_plot;
use super::loads::load_plot;
use super::map::MapPlot;
use super::tables::{performance_csv, span_load_csv};
use super::text::performance_text;
use crate::output::Written;
use crate::output::folder::{ResultLocation, Results};
use crate::result::PerformanceResult;

const TEXT: &str = "performance.txt";
const TABLE: &str = "performance.csv";
const LOADS: &str = "span_loads.csv";
/// Beginnings of the names of figures, before the number of the part.
const FIGURES: [&str; 3] = ["performance_", "map_", "span_loads_"];

/// Writes `NAME.performance.csv`, `NAME.performance.txt`, for chosen points `NAME.span_loads.csv`,
/// and if figures are drawn for each part, by its number, `NAME.performance_1` with the curves or
/// `NAME.map_1` with the maps, and `NAME.span_loads_1`, each as PNG and SVG, all to `location`.
/// Files of an earlier run that this run does not write are removed.
///
/// # Errors
/// [`OutputProblem`]: the folder or a file cannot be written.
pub fn write_performance(
    result: &PerformanceResult,
    location: &ResultLocation,
) -> Result<Written, OutputProblem> {
    make_folder(&location.folder)?;
    let mut results = Results::new(location);
    results.remove([TEXT, TABLE, LOADS]);
    for first in FIGURES {
        results.remove_numbered(first, ".png");
        results.remove_numbered(first, ".svg");
    }
    results.text(TABLE, &performance_csv(result))?;
    results.text(TEXT, &performance_text(result))?;
    if let Some(loads) = span_load_csv(result) {
        results.text(LOADS, &loads)?;
    }
    for (index, table) in result.tables.iter().enumerate() {
        let endings = |first: &str| ["png", "svg"].map(|it| format!("{first}{}.{it}", index + 1));
        let [curves, maps, loads] = FIGURES.map(endings);
        let is_map = results.figures(names(&maps), || MapPlot::new(result, table))?;
        if !is_map {
            results.figures(names(&curves), || curve_plot(result, table))?;
        }
        results.figures(names(&loads), || load_plot(result, table))?;
    }
    Ok(results.written)
}

fn names(endings: &[String; 2]) -> [&str; 2] {
    [&endings[0], &endings[1]]
}
