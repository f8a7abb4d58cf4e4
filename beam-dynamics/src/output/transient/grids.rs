//! The moving model as field files: one grid per time, and their series.

use std::path::Path;

use shared_geom::files::{OutputProblem, write_text};
use shared_geom::vtk::Series;

use crate::case::Model;
use crate::output::folder::Results;
use crate::output::grid::add_vectors;
use crate::output::structure::Structure;
use crate::result::AcceptedStep;

/// The series.
pub(super) const SERIES: &str = "transient.pvd";
/// Folder of the grids.
pub(super) const FIELDS: &str = "transient";

/// Grids of a run. The series is written anew with each, so that it is complete if the run is
/// killed.
#[derive(Debug)]
pub(super) struct Grids<'a> {
    model: &'a Model,
    structure: Structure,
    series: Series,
}

impl<'a> Grids<'a> {
    /// No grid yet.
    pub fn new(model: &'a Model) -> Self {
        Self {
            model,
            structure: Structure::new(model.system.nodes(), &model.beams, &model.blades),
            series: Series::default(),
        }
    }

    /// Adds the grids of an earlier part of the run up to `time` \[s\] to the series, and removes
    /// the others.
    pub fn resume(&mut self, results: &Results<'_>, time: f64) {
        let path = results.path(SERIES);
        let text = std::fs::read_to_string(&path).unwrap_or_default();
        let folder = path.parent().unwrap_or(Path::new(""));
        for (at, file) in text.lines().filter_map(entry) {
            if at <= time {
                self.series.add(at, file)
            } else {
                // A missing file is not an error.
                drop(std::fs::remove_file(folder.join(file)))
            }
        }
    }

    /// Writes the grid of a moment, and the series.
    pub fn write(
        &mut self,
        results: &mut Results<'_>,
        accepted: &AcceptedStep<'_>,
    ) -> Result<(), OutputProblem> {
        let nodes = &accepted.state.nodes;
        let positions: Vec<_> = nodes.iter().map(|node| node.position).collect();
        let rotations: Vec<_> = nodes.iter().map(|node| node.rotation).collect();
        let system = &self.model.system;
        let sections = system.observe(accepted.state, accepted.conditions).sections;
        let mut grid = self
            .structure
            .moved_grid(system.nodes(), &positions, &rotations, &sections);
        let velocities: Vec<_> = nodes.iter().map(|node| node.velocity).collect();
        add_vectors(&mut grid, "velocity", &velocities);
        let turning: Vec<_> = nodes.iter().map(|node| node.angular_velocity).collect();
        add_vectors(&mut grid, "angular_velocity", &turning);
        let file = format!("step_{:07}.vtu", accepted.step);
        let file = results.field(FIELDS, &file, grid)?;
        self.series.add(accepted.time, file);
        // Replaced when it is complete, so that the file is whole if the run is killed.
        let path = results.path(SERIES);
        let new = path.with_extension("pvd.new");
        write_text(&new, &self.series.text())?;
        std::fs::rename(&new, &path).map_err(|error| OutputProblem::File {
            file: path.display().to_string(),
            reason: error.to_string(),
        })
    }
}

/// Value and file of a line of a series.
fn entry(line: &str) -> Option<(f64, &str)> {
    let attribute = |name: &str| {
        let (_, rest) = line.split_once(&format!("{name}=\""))?;
        rest.split_once('"').map(|parts| parts.0)
    };
    Some((attribute("timestep")?.parse().ok()?, attribute("file")?))
}
