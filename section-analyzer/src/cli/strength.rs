//! `section-analyzer strength`: reserve factors of the plies of a blade, and fatigue loads.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::OnceLock;

use nalgebra::Vector6;
use shared_geom::error::{Diagnostics, Explain, SourceLocation};
use shared_geom::files::{make_folder, write_whole};
use shared_geom::wrench::COMPONENTS;

use super::analyze::{Job, Outcome, Status, solve_all};
use super::arguments::StrengthArguments;
use super::restored::Restored;
use super::{NOT_REACHED, Stop, Terminal, WRONG_INPUT, list};
use crate::input;
use crate::input::span_loads::{
    ListedStation, LoadInstant, LoadPositions, read_loads, read_stations,
};
use crate::output::{FatigueRow, ReserveRow, fatigue_csv, strength_csv, strength_text};
use crate::recovery::rainflow::{cycles, equivalent_range};
use crate::recovery::{Recoverer, region_reserves};

/// The ending of tables of stations.
const ENDING: &str = ".span.csv";

/// A reason for which there are no reserve factors.
#[derive(Debug, thiserror::Error)]
enum NoStrength {
    #[error("no material of the sections has limits, expected [material.NAME.strength]")]
    Limits,
    #[error("no station is at the position of a load")]
    Positions,
    #[error("the table has no station beyond the root")]
    Length,
}

impl Explain for NoStrength {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::Limits => "add strengths to the layup, and run \"section-analyzer blade\" again",
            Self::Positions => {
                "a load with one position is valid near it alone: give each instant positions at \
                 the root and at the tip"
            }
            Self::Length => "name the table NAME.span.csv that \"section-analyzer blade\" wrote",
        };
        Some(text.to_owned())
    }
}

/// Finds and writes reserve factors and fatigue loads.
pub(super) fn envelope(
    arguments: &StrengthArguments,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let span = &arguments.span;
    let wrong = |problem: NoStrength| {
        Diagnostics::one(SourceLocation::file(span.display().to_string()), &problem)
    };
    let stations = read_stations(span).map_err(|problems| terminal.report_all(&problems))?;
    let outer = stations.iter().rev().find(|station| station.eta > 0.0);
    let Some(outer) = outer else {
        return Err(terminal.report_all(&wrong(NoStrength::Length)));
    };
    let positions = LoadPositions {
        length: outer.arc_length / outer.eta,
        member: arguments.member.clone(),
        named: arguments.at.clone(),
    };
    let loads = read_loads(&arguments.loads, &positions);
    let loads = loads.map_err(|problems| terminal.report_all(&problems))?;
    let jobs = jobs_of(&stations, span.parent().unwrap_or(Path::new("")));
    let found: Vec<OnceLock<Vec<ReserveRow>>> = jobs.iter().map(|_| OnceLock::new()).collect();
    let work = |number: usize, job: &Job| match reserves(&stations[number], job, &loads) {
        Ok((outcome, rows)) => {
            // each station has one row
            let _ = found[number].set(rows);
            outcome
        }
        Err(problems) => Outcome {
            problems: Some(problems),
            ..Outcome::new(Status::NotReached)
        },
    };
    let ended = solve_all(&jobs, arguments.threads, &work, terminal)?;
    let is_solved = found.iter().any(|rows| rows.get().is_some());
    let rows: Vec<ReserveRow> = found
        .into_iter()
        .filter_map(OnceLock::into_inner)
        .flatten()
        .collect();
    write(
        arguments,
        (&rows, &fatigue(&stations, &loads, arguments)),
        terminal,
    )?;
    if rows.is_empty() && is_solved {
        let is_loaded =
            |station: &ListedStation| loads.iter().any(|load| load.at(station.eta).is_some());
        let problem = if stations.iter().any(is_loaded) {
            NoStrength::Limits
        } else {
            NoStrength::Positions
        };
        return Err(terminal.report_all(&wrong(problem)));
    }
    ended.result()
}

/// The section files of stations, below `folder`.
fn jobs_of(stations: &[ListedStation], folder: &Path) -> Vec<Job> {
    let folder = folder.join("sections");
    let job = |station: &ListedStation| Job {
        file: folder.join(format!("{}.section.toml", station.section)),
        folder: folder.clone(),
        name: station.section.clone(),
        label: format!("eta {}", crate::mesh::short(station.eta)),
    };
    stations.iter().map(job).collect()
}

/// The reserve factors of the plies of a section, which is solved only if its results are not
/// there; its outcome is unchanged if they are.
fn reserves(
    station: &ListedStation,
    job: &Job,
    loads: &[LoadInstant],
) -> Result<(Outcome, Vec<ReserveRow>), String> {
    let input = input::read(&job.file).map_err(|problems| problems.to_string())?;
    let failed = |failure: crate::failure::Failure| {
        let location = SourceLocation::file(job.file.display().to_string());
        Diagnostics::one(location, &failure).to_string()
    };
    let (names, forces): (Vec<&str>, Vec<Vector6<f64>>) = loads
        .iter()
        .filter_map(|load| Some((load.name.as_str(), load.at(station.eta)?)))
        .unzip();
    let restored = Restored::new(&input, job).map_err(failed)?;
    let section = &input.section;
    let recoverer = Recoverer::new(section, &restored.solution);
    let found = region_reserves(section, &input.limits, &recoverer, &forces).map_err(failed)?;
    let row = |found: crate::recovery::RegionReserve| ReserveRow {
        eta: station.eta,
        section: station.section.clone(),
        ply: section.mesh.groups[found.group].clone(),
        material: section.materials[found.material].name.clone(),
        worst: found.worst,
        instant: names[found.force].to_owned(),
        position: found.position,
        force: forces[found.force],
    };
    let status = if restored.is_known {
        Status::Unchanged
    } else {
        Status::Solved
    };
    let outcome = Outcome {
        nodes: Some(section.mesh.nodes.len()),
        ..Outcome::new(status)
    };
    Ok((outcome, found.into_iter().map(row).collect()))
}

/// The instants of each case with times, in their order.
fn histories(loads: &[LoadInstant]) -> Vec<Vec<(f64, &LoadInstant)>> {
    let mut cases: BTreeMap<Option<&str>, Vec<(f64, &LoadInstant)>> = BTreeMap::new();
    for load in loads {
        if let Some(time) = load.time {
            cases
                .entry(load.case.as_deref())
                .or_default()
                .push((time, load));
        }
    }
    let mut histories: Vec<_> = cases.into_values().collect();
    for history in &mut histories {
        history.sort_by(|a, b| a.0.total_cmp(&b.0));
    }
    histories
}

/// Damage-equivalent ranges of each component at each station, by the cycles of all cases together; none
/// without times.
fn fatigue(
    stations: &[ListedStation],
    loads: &[LoadInstant],
    arguments: &StrengthArguments,
) -> Vec<FatigueRow> {
    let histories = histories(loads);
    if histories.is_empty() {
        return Vec::new();
    }
    let length = |history: &Vec<(f64, &LoadInstant)>| match (&history[..], history.last()) {
        ([first, ..], Some(last)) => last.0 - first.0,
        _ => 0.0,
    };
    let equal = arguments
        .cycles
        .unwrap_or_else(|| histories.iter().map(length).sum());
    let mut rows = Vec::new();
    for station in stations {
        for (i, component) in COMPONENTS.iter().enumerate() {
            let of_history = |history: &Vec<(f64, &LoadInstant)>| {
                cycles(
                    history
                        .iter()
                        .filter_map(|(_, load)| Some(load.at(station.eta)?[i])),
                )
            };
            let counted: Vec<_> = histories.iter().flat_map(of_history).collect();
            let largest = counted
                .iter()
                .fold(0.0, |most: f64, one| most.max(one.range));
            let unit = if i < 3 { "N" } else { "N m" };
            rows.extend(arguments.exponents.iter().map(|&exponent| FatigueRow {
                eta: station.eta,
                section: station.section.clone(),
                component: format!("{component} [{unit}]"),
                // a sum of nothing is -0
                cycles: counted.iter().fold(0.0, |sum, one| sum + one.count),
                largest,
                exponent,
                equivalent: equivalent_range(&counted, exponent, equal),
            }));
        }
    }
    rows
}

fn write(
    arguments: &StrengthArguments,
    (reserves, fatigue): (&[ReserveRow], &[FatigueRow]),
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let span = &arguments.span;
    let beside = || span.parent().unwrap_or(Path::new("")).to_owned();
    let folder = arguments.out.clone().unwrap_or_else(beside);
    if !folder.as_os_str().is_empty() {
        make_folder(&folder).map_err(|problem| terminal.report(&problem, WRONG_INPUT))?;
    }
    let whole = span.file_name().unwrap_or_default().to_string_lossy();
    let name = whole.strip_suffix(ENDING).unwrap_or(&whole);
    if !reserves.is_empty() {
        write!(terminal.out, "\n{}", strength_text(reserves))?;
    }
    let mut written = Vec::new();
    for (ending, text, is_there) in [
        ("strength.csv", strength_csv(reserves), !reserves.is_empty()),
        ("fatigue.csv", fatigue_csv(fatigue), !fatigue.is_empty()),
    ] {
        let file = folder.join(format!("{name}.{ending}"));
        if is_there {
            write_whole(&file, &text).map_err(|problem| terminal.report(&problem, NOT_REACHED))?;
            written.push(file);
        } else {
            // of an earlier run; a missing file is ignored
            let _ = std::fs::remove_file(file);
        }
    }
    list("Written", &written, terminal)
}
