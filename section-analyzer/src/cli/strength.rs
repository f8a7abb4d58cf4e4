//! `section-analyzer strength`: reserve factors and damage of the plies of a blade, fatigue loads.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use nalgebra::Vector6;
use shared_geom::error::{Diagnostics, Explain, SourceLocation, quoted};
use shared_geom::files::{Earlier, OutputProblem, make_folder, write_whole};
use shared_geom::run_lock::RunLock;

use super::analyze::{Job, Outcome, Status, solve_all};
use super::arguments::StrengthArguments;
use super::restored::Restored;
use super::{NOT_REACHED, Stop, Terminal, WRONG_INPUT, list, list_removed};
use crate::input;
use crate::input::span_loads::{
    ListedStation, LoadInstant, LoadPositions, SpanLoads, blade_name, read_loads, read_stations,
};
use crate::material::MaterialLimits;
use crate::output::{
    DamageRow, FatigueRow, NotAssessed, ReserveRow, damage_csv, damage_text, fatigue_csv,
    not_assessed_text, strength_csv, strength_text,
};
use crate::recovery::fatigue::{RegionDamage, region_damages};
use crate::recovery::{Recoverer, RegionReserve, UnitPoint, region_reserves};

mod coverage;
mod histories;

use histories::Histories;

/// Endings of tables of loads that are not part of their names.
const TABLES: [&str; 4] = [".forces.csv", ".extremes.csv", ".envelope.csv", ".csv"];

/// A reason for which there are no reserve factors.
#[derive(Debug, thiserror::Error)]
enum NoStrength {
    #[error("no material of the sections has limits, expected [material.NAME.strength]")]
    Limits,
    #[error("no station is at the position of a load, the stations are at eta {}", .stations.join(", "))]
    Positions { stations: Vec<String> },
    #[error("the blade has no station beyond the root")]
    Length,
    #[error("sections have changed since the blade was solved: {}", quoted(.sections))]
    Changed { sections: Vec<String> },
}

impl Explain for NoStrength {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::Limits => "add strengths to the layup, and run \"section-analyzer blade\" again",
            Self::Positions { .. } => {
                "a load with one position is valid near it alone: give each instant positions at \
                 the root and at the tip"
            }
            Self::Changed { .. } => {
                "run \"section-analyzer blade\" again, for each layup into a folder of its own by --out"
            }
            Self::Length => "name the table NAME.span.csv that \"section-analyzer blade\" wrote",
        };
        Some(text.to_owned())
    }
}

/// The rows of a station.
struct Rows {
    reserves: Vec<ReserveRow>,
    damages: Vec<DamageRow>,
    /// Plies without limits, and plies without slopes of S-N lines.
    not_assessed: [NotAssessed; 2],
}

/// A problem of the table of stations.
fn wrong(span: &Path, problem: &NoStrength) -> Diagnostics {
    Diagnostics::one(SourceLocation::file(span.display().to_string()), problem)
}

/// Reads the stations and the loads; shows warnings about both.
fn read(
    arguments: &StrengthArguments,
    terminal: &mut Terminal<'_>,
) -> Result<(Vec<ListedStation>, Vec<LoadInstant>), Stop> {
    let span = &*arguments.span;
    let stations = read_stations(span).map_err(|problems| terminal.report_all(&problems))?;
    let outer = stations.iter().rev().find(|station| station.eta > 0.0);
    let Some(outer) = outer else {
        return Err(terminal.report_all(&wrong(span, &NoStrength::Length)));
    };
    check_sections(&stations).map_err(|problem| terminal.report_all(&wrong(span, &problem)))?;
    let positions = LoadPositions {
        length: outer.arc_length / outer.eta,
        member: arguments.member.clone(),
        named: arguments.at.clone(),
    };
    if stations.iter().any(|station| station.fingerprint.is_none()) {
        let text = "the table has no column \"fingerprint\": whether its sections have changed since is \
                    unknown";
        terminal.warn(span, &[text.to_owned()])?;
    }
    let loads = read_tables(&arguments.loads, (&stations, &positions), terminal)?;
    Ok((stations, loads))
}

/// Reads tables of loads, and shows warnings about each; the instants of several tables have the name
/// of their table in their case.
fn read_tables(
    files: &[PathBuf],
    (stations, positions): (&[ListedStation], &LoadPositions),
    terminal: &mut Terminal<'_>,
) -> Result<Vec<LoadInstant>, Stop> {
    let names = table_names(files);
    let mut loads = Vec::new();
    let mut wrong = None;
    for (file, name) in files.iter().zip(&names) {
        match read_loads(file, positions) {
            Ok(found) => {
                let warnings = coverage::warnings(stations, &found);
                let SpanLoads { instants, .. } = found;
                terminal.warn(file, &warnings)?;
                loads.extend(instants.into_iter().map(|instant| match files.len() {
                    1 => instant,
                    _ => instant.of_table(name),
                }));
            }
            Err(problems) => wrong = Some(terminal.report_all(&problems)),
        }
    }
    wrong.map_or(Ok(loads), Err)
}

/// Names of tables of loads: of their files without endings, or their paths if some files have the
/// same name.
fn table_names(files: &[PathBuf]) -> Vec<String> {
    let short = |path: &Path| {
        let path = path.display().to_string();
        let ending = TABLES.iter().find_map(|ending| path.strip_suffix(ending));
        ending.unwrap_or(&path).to_owned()
    };
    let name = |path: &PathBuf| short(Path::new(path.file_name().unwrap_or_default()));
    let names: Vec<String> = files.iter().map(name).collect();
    let mut distinct = names.clone();
    distinct.sort();
    distinct.dedup();
    if distinct.len() == names.len() {
        names
    } else {
        files.iter().map(|path| short(path)).collect()
    }
}

/// Finds and writes reserve factors, damage and fatigue loads.
pub(super) fn envelope(
    arguments: &StrengthArguments,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let span = &*arguments.span;
    let (stations, loads) = read(arguments, terminal)?;
    let histories = Histories::new(&loads, arguments.durations.as_deref());
    let histories = histories.map_err(|problems| terminal.report_all(&problems))?;
    let jobs = jobs_of(&stations);
    let target = Target::new(arguments);
    let _lock = target
        .open()
        .map_err(|problem| terminal.report(&problem, WRONG_INPUT))?;
    let found: Vec<OnceLock<Rows>> = jobs.iter().map(|_| OnceLock::new()).collect();
    let work = |number: usize, job: &Job| match rows(&stations[number], job, (&loads, &histories)) {
        Ok((outcome, rows)) => {
            // each station has its rows once
            let _ = found[number].set(rows);
            outcome
        }
        Err(problems) => Outcome {
            problems: Some(problems),
            ..Outcome::new(Status::NotReached)
        },
    };
    let ended = solve_all(&jobs, arguments.threads, &work, terminal)?;
    let rows: Vec<Rows> = found.into_iter().filter_map(OnceLock::into_inner).collect();
    let is_solved = !rows.is_empty();
    let (mut reserves, mut damages) = (Vec::new(), Vec::new());
    let mut not_assessed = [NotAssessed::new(), NotAssessed::new()];
    for station in rows {
        reserves.extend(station.reserves);
        damages.extend(station.damages);
        for (all, own) in not_assessed.iter_mut().zip(station.not_assessed) {
            for (material, plies) in own {
                all.entry(material).or_default().extend(plies);
            }
        }
    }
    let equivalent = histories.equivalent_ranges(&stations, &arguments.exponents, arguments.cycles);
    let tables = Tables {
        reserves: &reserves,
        equivalent: &equivalent,
        damages: &damages,
        not_assessed: &not_assessed,
        duration: histories.duration(),
    };
    tables.write(&target, terminal)?;
    if reserves.is_empty() && damages.is_empty() && is_solved {
        return Err(terminal.report_all(&wrong(span, &nothing(&stations, &loads))));
    }
    ended.result()
}

/// The reason for which solved sections have no reserve factors.
fn nothing(stations: &[ListedStation], loads: &[LoadInstant]) -> NoStrength {
    let is_loaded =
        |station: &ListedStation| loads.iter().any(|load| load.at(station.eta).is_some());
    if stations.iter().any(is_loaded) {
        NoStrength::Limits
    } else {
        let stations = stations.iter().map(ListedStation::label).collect();
        NoStrength::Positions { stations }
    }
}

/// Checks that the sections of stations belong to the table.
fn check_sections(stations: &[ListedStation]) -> Result<(), NoStrength> {
    let changed = stations.iter().filter(|one| one.has_changed());
    let sections: Vec<String> = changed.map(|one| one.section.clone()).collect();
    if sections.is_empty() {
        Ok(())
    } else {
        Err(NoStrength::Changed { sections })
    }
}

/// The section files of stations.
fn jobs_of(stations: &[ListedStation]) -> Vec<Job> {
    let job = |station: &ListedStation| Job {
        file: station.file(),
        folder: station.folder.clone(),
        name: station.section.clone(),
        label: format!("eta {}", station.label()),
    };
    stations.iter().map(job).collect()
}

/// The reserve factors and damages of the plies of a section, which is solved only if its results
/// are not there; its outcome is unchanged if they are.
fn rows(
    station: &ListedStation,
    job: &Job,
    (loads, histories): (&[LoadInstant], &Histories<'_>),
) -> Result<(Outcome, Rows), String> {
    let input = input::read(&job.file).map_err(|problems| problems.to_string())?;
    let fingerprint = station.present_fingerprint().unwrap_or_default();
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
    let points = recoverer.unit_points().map_err(failed)?;
    let reserves = region_reserves(section, &input.limits, &points, &forces);
    let row = |found: RegionReserve| ReserveRow {
        station: station.clone(),
        fingerprint: fingerprint.clone(),
        ply: section.mesh.groups[found.group].clone(),
        material: section.materials[found.material].name.clone(),
        instant: names[found.force].to_owned(),
        force: forces[found.force],
        found,
    };
    let reserves = reserves.into_iter().map(row).collect();
    let damages = damages(station, &input, &points, (histories, !forces.is_empty()));
    let status = match restored.known {
        Some(_) => Status::Unchanged,
        None => Status::Solved,
    };
    let outcome = Outcome {
        nodes: Some(section.mesh.nodes.len()),
        properties: restored.known,
        ..Outcome::new(status)
    };
    let plies = |is_left: fn(&MaterialLimits) -> bool| not_assessed(&input, is_left);
    let rows = Rows {
        reserves,
        damages,
        not_assessed: [
            plies(|limits| limits.strength.is_none() && limits.strain.is_none()),
            plies(|limits| limits.fatigue.stress.is_none() && limits.fatigue.strain.is_none()),
        ],
    };
    Ok((outcome, rows))
}

/// The damages of the plies of a section, which has loads or not.
fn damages(
    station: &ListedStation,
    input: &input::Input,
    points: &[UnitPoint],
    (histories, is_loaded): (&Histories<'_>, bool),
) -> Vec<DamageRow> {
    let section = &input.section;
    let histories = if is_loaded {
        histories.at(station)
    } else {
        Vec::new()
    };
    if histories.is_empty() {
        return Vec::new();
    }
    let row = |found: RegionDamage| DamageRow {
        station: station.clone(),
        ply: section.mesh.groups[found.group].clone(),
        material: section.materials[found.material].name.clone(),
        found,
    };
    let damages = region_damages(section, &input.limits, points, &histories);
    damages.into_iter().map(row).collect()
}

/// The plies of a section whose material is left out.
fn not_assessed(input: &input::Input, is_left: fn(&MaterialLimits) -> bool) -> NotAssessed {
    let section = &input.section;
    let mut found = NotAssessed::new();
    for (cell, shape) in section.cells.iter().zip(&section.mesh.cells) {
        if is_left(&input.limits[cell.material]) {
            let material = section.materials[cell.material].name.clone();
            let plies = found.entry(material).or_default();
            plies.insert(section.mesh.groups[shape.group].clone());
        }
    }
    found
}

/// The folder of the tables, and the beginning of their names.
struct Target {
    folder: PathBuf,
    name: String,
}

impl Target {
    fn new(arguments: &StrengthArguments) -> Self {
        let span = &*arguments.span;
        let beside = || span.parent().unwrap_or(Path::new("")).to_owned();
        Self {
            folder: arguments.out.clone().unwrap_or_else(beside),
            name: blade_name(span),
        }
    }

    /// The table with this ending.
    fn path(&self, ending: &str) -> PathBuf {
        self.folder.join(format!("{}.{ending}", self.name))
    }

    /// Makes the folder, and keeps other runs from the tables.
    fn open(&self) -> Result<RunLock, OutputProblem> {
        make_folder(&self.folder)?;
        RunLock::new(&self.path("strength.lock"))
    }
}

/// The tables of a run.
struct Tables<'a> {
    reserves: &'a [ReserveRow],
    equivalent: &'a [FatigueRow],
    damages: &'a [DamageRow],
    /// Plies without limits, and plies without slopes of S-N lines.
    not_assessed: &'a [NotAssessed; 2],
    /// Time of all histories \[s\].
    duration: f64,
}

impl Tables<'_> {
    /// Whether there is nothing to write; tables of an earlier run then remain.
    fn is_empty(&self) -> bool {
        self.reserves.is_empty() && self.equivalent.is_empty() && self.damages.is_empty()
    }

    fn write(&self, target: &Target, terminal: &mut Terminal<'_>) -> Result<(), Stop> {
        if !self.reserves.is_empty() {
            let text = not_assessed_text(&self.not_assessed[0], "[material.NAME.strength]");
            write!(terminal.out, "\n{}{text}", strength_text(self.reserves))?;
        }
        if !self.damages.is_empty() {
            let text = not_assessed_text(&self.not_assessed[1], "\"m\" beside the strengths");
            let damages = damage_text(self.damages, self.duration);
            write!(terminal.out, "\n{damages}{text}")?;
        }
        let earlier = Earlier::new(&target.folder, &target.name);
        let mut written = Vec::new();
        for (ending, rows, text) in [
            (
                "strength.csv",
                self.reserves.len(),
                strength_csv(self.reserves),
            ),
            (
                "fatigue.csv",
                self.equivalent.len(),
                fatigue_csv(self.equivalent),
            ),
            (
                "damage.csv",
                self.damages.len(),
                damage_csv(self.damages, self.duration),
            ),
        ] {
            let file = target.path(ending);
            if rows > 0 {
                write_whole(&file, &text)
                    .map_err(|problem| terminal.report(&problem, NOT_REACHED))?;
                written.push(file);
            } else if !self.is_empty() {
                // a missing file is ignored
                drop(std::fs::remove_file(&file));
            }
        }
        list("Written", &written, terminal)?;
        Ok(list_removed(&earlier.removed(), terminal)?)
    }
}
