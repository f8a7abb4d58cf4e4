//! The files of critical loads.

use shared_geom::files::{OutputProblem, make_folder};
use shared_geom::vtk::Series;

use super::fields::{base, shape_grid};
use super::{BUCKLING_CONVENTION, BucklingPlot, buckling_csv, buckling_text};
use crate::output::Written;
use crate::output::folder::{ResultLocation, Results};
use crate::output::structure::Structure;
use crate::result::BucklingResult;

const TEXT: &str = "buckling.txt";
const TABLE: &str = "buckling.csv";
const PLOT: [&str; 2] = ["buckling.png", "buckling.svg"];
const SERIES: &str = "buckling.pvd";
/// Folder of the field files.
const FIELDS: &str = "buckling";

/// Writes `NAME.buckling.txt`, `NAME.buckling.csv`, if figures are drawn the plot `NAME.buckling`
/// as PNG and SVG, and the field files `NAME.buckling.pvd` with one grid per critical load in the
/// folder `NAME.buckling`, all to `location`. Files of an earlier run that this run does not write are
/// removed.
///
/// # Errors
/// [`OutputProblem`]: the folder or a file cannot be written.
pub fn write_buckling(
    result: &BucklingResult,
    location: &ResultLocation,
) -> Result<Written, OutputProblem> {
    make_folder(&location.folder)?;
    let mut results = Results::new(location);
    results.remove([TEXT, TABLE, SERIES].into_iter().chain(PLOT));
    results.remove_fields(FIELDS);

    let text = format!("{}\n{BUCKLING_CONVENTION}", buckling_text(result));
    results.text(TEXT, &text)?;
    results.text(TABLE, &buckling_csv(result))?;
    results.figures(PLOT, || BucklingPlot::new(result))?;
    if result.modes.is_empty() {
        return Ok(results.written);
    }
    let structure = Structure::new(&result.nodes, &result.beams, &[]);
    let base = base(result);
    let mut series = Series::default();
    for (index, mode) in result.modes.iter().enumerate() {
        let grid = shape_grid(&structure, &base, mode);
        let file = results.field(FIELDS, &format!("mode_{:03}.vtu", index + 1), grid)?;
        series.add((index + 1) as f64, file);
    }
    results.text(SERIES, &series.text())?;
    Ok(results.written)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples::{column, names};

    #[test]
    fn all_files_are_written_and_stale_ones_removed() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        let location = ResultLocation::new(folder, "x");
        let mut result = column();
        let expected = [
            "x.buckling.txt",
            "x.buckling.csv",
            "x.buckling.png",
            "x.buckling.svg",
            "x.buckling.pvd",
        ];
        assert_eq!(
            names(&write_buckling(&result, &location).unwrap()),
            expected
        );
        let series = std::fs::read_to_string(folder.join(expected[4])).unwrap();
        let third = "timestep=\"3\" group=\"\" part=\"0\" file=\"x.buckling/mode_003.vtu\"";
        assert!(series.contains(third), "{series}");
        assert_eq!(folder.join("x.buckling").read_dir().unwrap().count(), 4);

        result.modes.clear();
        assert_eq!(
            names(&write_buckling(&result, &location).unwrap()),
            expected[..2]
        );
        assert_eq!(folder.read_dir().unwrap().count(), 2);
    }
}
