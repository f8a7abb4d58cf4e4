//! The files of a load path.

use shared_geom::files::{OutputProblem, make_folder};
use shared_geom::vtk::Series;

use super::fields::step_grid;
use super::names::{
    AIR, AIR_PLOT, ALONG, DEFORMED, DISPLACEMENTS, ELECTRODES, FIELDS, FORCES, PATH, REACTIONS,
    SERIES, TEXT, remove_all,
};
use super::{
    DeformedPlot, ForcePlot, PathPlot, STATIC_CONVENTION, displacement_csv, electrode_csv,
    force_csv, reaction_csv, static_air_csv, static_text,
};
use crate::output::Written;
use crate::output::air::span_plot;
use crate::output::folder::{ResultLocation, Results};
use crate::output::span_forces::{Leads, SpanForces};
use crate::output::structure::Structure;
use crate::output::transient::RunFileProblem;
use crate::result::StaticResult;

/// Columns that distinguish equilibria in tables of forces.
const LEADS: Leads = &[("step", "-"), ("factor", "-")];

/// Writes `NAME.static.txt`, `NAME.displacements.csv`, `NAME.forces.csv`, `NAME.reactions.csv`,
/// with electrodes `NAME.electrodes.csv`, with blades in the air `NAME.air.csv`, if figures are
/// drawn the plots `NAME.deformed`, `NAME.forces`, `NAME.air` and, for three equilibria or more,
/// `NAME.path`, each as PNG and SVG, and the field files `NAME.static.pvd` with one grid per step in
/// the folder `NAME.static`, all to `location`; with `span_forces` also the internal forces of each
/// blade and line of beams, `NAME.static.MEMBER.forces.csv`, and their envelope.
/// Files of an earlier run that this run does not write are removed.
///
/// # Errors
/// [`RunFileProblem::Output`]: the folder or a file cannot be written.
pub fn write_static(
    result: &StaticResult,
    location: &ResultLocation,
    span_forces: bool,
) -> Result<Written, RunFileProblem> {
    make_folder(&location.folder)?;
    let mut results = Results::new(location);
    remove_all(&results);

    let text = format!("{}\n{STATIC_CONVENTION}", static_text(result));
    results.text(TEXT, &text)?;
    results.text(DISPLACEMENTS, &displacement_csv(result))?;
    results.text(FORCES, &force_csv(result))?;
    if span_forces {
        write_span_forces(result, &mut results)?;
    }
    results.text(REACTIONS, &reaction_csv(result))?;
    if result.steps.iter().any(|step| !step.electrodes.is_empty()) {
        results.text(ELECTRODES, &electrode_csv(result))?;
    }
    if result.steps.iter().any(|step| !step.air.is_empty()) {
        results.text(AIR, &static_air_csv(result))?;
    }
    results.figures(DEFORMED, || DeformedPlot::new(result))?;
    results.figures(ALONG, || ForcePlot::new(result))?;
    results.figures(AIR_PLOT, || span_plot(&result.name, &result.last()?.air))?;
    results.figures(PATH, || PathPlot::new(result))?;
    if !result.steps.is_empty() {
        write_fields(result, &mut results)?;
    }
    Ok(results.written)
}

/// The internal forces of all steps along each blade and line of beams, and their envelopes.
fn write_span_forces(
    result: &StaticResult,
    results: &mut Results<'_>,
) -> Result<(), RunFileProblem> {
    let structure = Structure::new(&result.nodes, &result.beams, &result.blades);
    let mut tables = SpanForces::new(&structure, (results, FIELDS), LEADS, None)?;
    for (number, step) in result.steps.iter().enumerate() {
        tables.add(&[number as f64, step.factor], &step.sections)?;
    }
    tables.finish(results)
}

/// One grid per step; the values of the series are the factors if they ascend, else the numbers of
/// the steps.
fn write_fields(result: &StaticResult, results: &mut Results<'_>) -> Result<(), OutputProblem> {
    let structure = Structure::new(&result.nodes, &result.beams, &result.blades);
    let rises = result
        .steps
        .windows(2)
        .all(|pair| pair[0].factor < pair[1].factor);
    let mut series = Series::default();
    for (index, step) in result.steps.iter().enumerate() {
        let value = if rises { step.factor } else { index as f64 };
        let grid = step_grid(result, &structure, step);
        let file = results.field(FIELDS, &format!("step_{index:04}.vtu"), grid)?;
        series.add(value, file);
    }
    results.text(SERIES, &series.text())
}

#[cfg(test)]
mod tests {
    use super::*;

    use crate::output::samples::{self, names};

    #[test]
    fn all_files_are_written_and_stale_ones_removed() {
        let folder = tempfile::tempdir().unwrap();
        let results = folder.path().join("results");
        let location = ResultLocation::new(&results, "x");
        let written = write_static(&samples::bent(&[0.0, 0.5, 1.0]), &location, false).unwrap();
        let expected = [
            "x.static.txt",
            "x.displacements.csv",
            "x.forces.csv",
            "x.reactions.csv",
            "x.deformed.png",
            "x.deformed.svg",
            "x.forces.png",
            "x.forces.svg",
            "x.path.png",
            "x.path.svg",
            "x.static.pvd",
        ];
        assert_eq!(names(&written), expected);
        assert!(written.files.iter().all(|path| path.is_file()));
        assert_eq!(results.join("x.static").read_dir().unwrap().count(), 3);
        let series = std::fs::read_to_string(results.join("x.static.pvd")).unwrap();
        assert!(series.contains("timestep=\"0.5\""), "{series}");
        assert!(
            series.contains("file=\"x.static/step_0001.vtu\""),
            "{series}"
        );

        // A path past a limit point, shorter than the one before.
        write_static(&samples::bent(&[0.5, 0.4]), &location, false).unwrap();
        assert!(!results.join("x.path.png").exists());
        assert_eq!(results.join("x.static").read_dir().unwrap().count(), 2);
        let series = std::fs::read_to_string(results.join("x.static.pvd")).unwrap();
        assert!(series.contains("timestep=\"1\""), "{series}");

        let written = write_static(&samples::bent(&[]), &location, false).unwrap();
        assert_eq!(names(&written), expected[..4]);
        assert_eq!(results.read_dir().unwrap().count(), 4);
    }
}
