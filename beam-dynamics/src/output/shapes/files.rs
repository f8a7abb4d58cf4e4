//! The files of shapes of modes.

use shared_geom::files::{OutputProblem, make_folder};
use shared_geom::vtk::Series;

use super::fields::{PHASES, Still};
use super::{ShapePlot, shaped, structure};
use crate::case::Model;
use crate::input::short_number;
use crate::output::Written;
use crate::output::folder::{ResultLocation, Results};
use crate::output::text::RPM;
use crate::result::FrequencyTable;

/// Folder of the field files.
const FIELDS: &str = "modes";
/// Beginning of the names of plots.
const PLOT: &str = "shapes_at_";
const ENDINGS: [&str; 2] = ["_rpm.png", "_rpm.svg"];

/// Writes plots of the shapes of the lowest modes, `NAME.shapes_at_RPM_rpm` as PNG and SVG, for
/// each speed at which `table` has shapes, if figures are drawn, and with `animate` the folder
/// `NAME.modes` with a series `MODE_at_RPM_rpm.pvd` of field files for each mode, all to `location`.
/// Files of an earlier run that this run does not write are removed.
///
/// # Errors
/// [`OutputProblem`]: the folder or a file cannot be written.
pub fn write_shapes(
    model: &Model,
    table: &FrequencyTable,
    animate: bool,
    location: &ResultLocation,
) -> Result<Written, OutputProblem> {
    make_folder(&location.folder)?;
    let mut results = Results::new(location);
    for ending in ENDINGS {
        results.remove_numbered(PLOT, ending);
    }
    results.remove_fields(FIELDS);
    let structure = structure(model);
    let nodes = model.system.nodes().iter();
    let undeformed: Vec<_> = nodes.map(|node| node.rotation).collect();
    for (speed, report) in table.equilibria.iter().enumerate() {
        let at = format!("{}_rpm", short_number(table.speeds[speed] * RPM, 6));
        let endings = ["png", "svg"].map(|ending| format!("shapes_at_{at}.{ending}"));
        let plot = || ShapePlot::new(model, table, speed);
        results.figures([&endings[0], &endings[1]], plot)?;
        if !animate {
            continue;
        }
        let still = Still::new(&structure, report, &undeformed, &model.naming);
        for mode in shaped(table, speed) {
            let file = format!("{}_at_{at}", file_name(mode.name));
            let mut series = Series::default();
            for phase in 0..PHASES {
                let part = phase as f64 / PHASES as f64;
                let grid = format!("{file}_{phase:02}.vtu");
                results.field(FIELDS, &grid, still.grid(mode.shape, part))?;
                series.add(part, grid);
            }
            results.series(FIELDS, &format!("{file}.pvd"), &series.text())?;
        }
    }
    results.list_fields(FIELDS);
    Ok(results.written)
}

/// A name of letters and digits only, other characters as `_`.
fn file_name(name: &str) -> String {
    let letter = |c: char| if c.is_alphanumeric() { c } else { '_' };
    name.chars().map(letter).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples::{names, shaped};

    #[test]
    fn plots_and_series_are_written_and_stale_ones_removed() {
        let (model, mut table) = shaped();
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        let location = ResultLocation::new(folder, "x");
        let write = |table: &FrequencyTable, animate| {
            names(&write_shapes(&model, table, animate, &location).unwrap())
        };
        let plots = ["x.shapes_at_0_rpm.png", "x.shapes_at_0_rpm.svg"];
        assert_eq!(write(&table, true), [plots[0], plots[1], "x.modes"]);
        let fields = folder.join("x.modes");
        assert_eq!(fields.read_dir().unwrap().count(), 2 * (PHASES + 1));
        let series = std::fs::read_to_string(fields.join("flap_1_at_0_rpm.pvd")).unwrap();
        let half = "timestep=\"0.5\" group=\"\" part=\"0\" file=\"flap_1_at_0_rpm_12.vtu\"";
        assert!(series.contains(half), "{series}");

        assert_eq!(write(&table, false), plots);
        assert!(!fields.exists());
        for branch in &mut table.branches {
            branch.points.truncate(0);
        }
        assert_eq!(write(&table, true), [""; 0]);
        assert_eq!(folder.read_dir().unwrap().count(), 0);
    }
}
