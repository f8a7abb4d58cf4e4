//! `blade --check`: the sections of a blade are meshed and checked, and not solved.

use std::path::Path;
use std::sync::OnceLock;

use super::report::cut_of_layers;
use super::{jobs_of, stations_of};
use crate::cli::analyze::{Job, Outcome, Status, solve_all};
use crate::cli::arguments::WholeBladeArguments;
use crate::cli::{Stop, Terminal};
use crate::input::layup::Layup;
use crate::output::{LayerRow, layer_rows};

/// Meshes all sections, and reports those that cannot be meshed and layers that are cut.
pub(super) fn sections(
    layup: &Layup,
    arguments: &WholeBladeArguments,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let stations = stations_of(layup, arguments);
    let jobs = jobs_of(&stations, Path::new(""));
    let layers: Vec<OnceLock<Vec<LayerRow>>> = jobs.iter().map(|_| OnceLock::new()).collect();
    let check = |number: usize, _: &Job| match layup.mesh(stations[number].meshed_at()) {
        Ok(meshed) => {
            // each section is meshed once
            let _ = layers[number].set(layer_rows(layup, &meshed));
            Outcome {
                nodes: Some(meshed.mesh.nodes.len()),
                warnings: layup.material_remarks(&meshed),
                ..Outcome::new(Status::Sound)
            }
        }
        Err(problems) => Outcome {
            problems: Some(problems.to_string()),
            ..Outcome::new(Status::NotReached)
        },
    };
    let ended = solve_all(&jobs, arguments.threads, &check, terminal)?;
    let meshed = jobs.iter().zip(&layers);
    let meshed =
        meshed.filter_map(|(job, rows)| Some((job.label.as_str(), rows.get()?.as_slice())));
    for (text, sections) in cut_of_layers(meshed) {
        writeln!(terminal.out, "{text}: {}", sections.join(", "))?;
    }
    ended.result()
}
