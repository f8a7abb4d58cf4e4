//! `section-analyzer blade`: meshes and solves the sections of a blade, and writes the blade.

use std::path::Path;
use std::sync::OnceLock;

use shared_geom::blade::Blade;
use shared_geom::error::{Diagnostics, Explain, SourceLocation};
use shared_geom::exchange;
use shared_geom::file_kind::LAYUP_ENDING;
use shared_geom::files::{Earlier, OutputProblem, make_folder, name_without, write_whole};
use shared_geom::gmsh;
use shared_geom::line::{ReferenceLine, Side};
use shared_geom::section::SectionProperties;

use super::analyze::{Analyzed, Job, Outcome, Run, Status, analyze_one, solve_all};
use super::arguments::WholeBladeArguments;
use super::restored::solution_of;
use super::{NOT_REACHED, Stop, Terminal, WRONG_INPUT, words};
use crate::input::layup::{self, Layup, Selection, SpanStation};
use crate::input::result_tables::read_modes;
use crate::input::span_loads::section_fingerprint;
use crate::output::{
    OutputFiles, ResultWriter, SectionPicture, SolvedSpan, SolvedStation, SpanFiles, layer_rows,
    layup_section,
};
use crate::recovery::Recoverer;

mod check;
mod report;
mod results;

use report::Request;

/// A layup without a line.
#[derive(Debug, thiserror::Error)]
#[error("the layup has no reference line, expected a table [line] with the length of the blade")]
struct NoLine;

impl Explain for NoLine {
    fn help(&self) -> Option<String> {
        let text = "[line] with length = 60, or with span, sweep, prebend and twist, in a layup \
                    file, as \"section-analyzer layup FILE --out NAME.layup.toml\" writes it; or \
                    use \"section-analyzer mesh layup\" for one section";
        Some(text.to_owned())
    }
}

/// Sections that are missing in a blade.
#[derive(Debug, thiserror::Error)]
#[error("{} of {all} sections are missing: {}", .missing.len(), .missing.join(", "))]
struct Missing {
    missing: Vec<String>,
    all: usize,
    is_skipped: bool,
}

impl Explain for Missing {
    fn help(&self) -> Option<String> {
        let text = if self.is_skipped {
            "the blade file is linear between the sections that are there"
        } else {
            "correct the layup there, or leave these stations out with --stations; \
                 --skip-failed writes the blade file without them"
        };
        Some(text.to_owned())
    }
}

/// Solves the sections of a blade, and writes its results.
pub(super) fn solve_blade(
    arguments: &WholeBladeArguments,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let file = &arguments.file;
    let treatment = super::layup::materials(arguments.repair_materials);
    let layup = layup::read_with(file, treatment);
    let layup = layup.map_err(|problems| terminal.report_all(&problems))?;
    super::layup::write_remarks(&layup, terminal)?;
    let missed = layup.missed_layers(&stations_of(&layup, arguments));
    let mut missed: Vec<String> = missed.iter().map(ToString::to_string).collect();
    let stations = stations_of(&layup, arguments);
    let etas: Vec<f64> = stations.iter().map(SpanStation::meshed_at).collect();
    missed.extend(layup.faded_layers(&etas));
    terminal.warn(file, &missed)?;
    let Some(line) = &layup.line else {
        let location = SourceLocation::file(file.display().to_string());
        return Err(terminal.report_all(&Diagnostics::one(location, &NoLine)));
    };
    if arguments.check {
        check::sections(&layup, arguments, terminal)
    } else {
        solve_sections((&layup, line), arguments, terminal)
    }
}

/// Remarks about solved sections: layers that are cut, and a blade file with a single station.
fn remarks(span: &SolvedSpan<'_>, is_written: bool) -> Vec<String> {
    let cut = report::cut_of_layers(span.layers()).into_iter();
    let mut remarks: Vec<String> = cut
        .map(|(text, sections)| format!("{text}: {}", sections.join(", ")))
        .collect();
    if let ([_], true) = (&span.stations[..], is_written) {
        remarks.push(
            "the blade file has one station, and thus equal properties along the whole blade; \
             --stations and --count give more"
                .to_owned(),
        );
    }
    remarks
}

/// Solves the sections of a layup along a line, and writes the results.
fn solve_sections(
    (layup, line): (&Layup, &ReferenceLine),
    arguments: &WholeBladeArguments,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let file = &arguments.file;
    let other = arguments.compare.as_deref().map(published).transpose();
    let other = other.map_err(|problems| terminal.report_all(&problems))?;
    let modes = arguments.modes.as_deref().map(read_modes).transpose();
    let modes = modes.map_err(|problems| terminal.report_all(&problems))?;
    let name = name_of(file);
    let beside = || file.parent().unwrap_or(Path::new("")).join("results");
    let folder = arguments.out.clone().unwrap_or_else(beside);
    let files = SpanFiles::new(&folder, &name);
    let lock = make_folder(&files.sections()).and_then(|()| files.lock());
    let _lock = lock.map_err(|problem| terminal.report(&problem, WRONG_INPUT))?;
    let plan = Plan::new(layup, &files, arguments);
    let solve = |number: usize, job: &Job| plan.solve(number, job);
    let ended = solve_all(&plan.jobs, arguments.threads, &solve, terminal)?;
    let missing = plan.missing();
    let span = SolvedSpan {
        name: layup.name.as_deref().unwrap_or(&name),
        line,
        stations: plan
            .solved
            .into_iter()
            .filter_map(OnceLock::into_inner)
            .collect(),
    };
    let is_written = missing.is_empty() || arguments.skip_failed;
    let request = Request::new(modes, other.clone(), &missing);
    let page = (arguments.report.then(|| request.page(layup, &span, &files))).flatten();
    let results = results::Results {
        span: &span,
        page,
        is_written,
        other,
    };
    let written = results::write(&results, &files, arguments, terminal);
    terminal.warn(file, &remarks(&span, is_written))?;
    if !missing.is_empty() {
        let missing = Missing {
            missing,
            all: plan.jobs.len(),
            is_skipped: arguments.skip_failed,
        };
        terminal.report(&missing, NOT_REACHED);
        written?;
        return Err(Stop::Reported(NOT_REACHED));
    }
    written?;
    match ended.worst {
        0 => ended.result(),
        _ => Err(Stop::Reported(NOT_REACHED)),
    }
}

/// The blade of a file for a comparison. Its shear stiffness is not compared, and may be absent.
fn published(path: &Path) -> Result<Blade, Diagnostics> {
    let options = exchange::Options {
        rigid_shear: true,
        ..exchange::Options::default()
    };
    exchange::read_with(path, &options).map(|(_, reading)| reading.blade)
}

/// The name of a blade: of its file, without its ending.
fn name_of(file: &Path) -> String {
    match file.extension() == Some("toml".as_ref()) {
        true => name_without(file, LAYUP_ENDING),
        // turbine files of windIO
        false => file
            .file_stem()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned(),
    }
}

/// The stations of a run.
fn stations_of(layup: &Layup, arguments: &WholeBladeArguments) -> Vec<SpanStation> {
    let selection = match (arguments.count, &arguments.stations[..]) {
        (Some(count), _) => Selection::Equal(count),
        (None, []) => Selection::Chosen,
        (None, given) => Selection::Given(given.to_vec()),
    };
    layup.span_stations(&selection)
}

/// The sections of stations, with their files in `folder`.
fn jobs_of(stations: &[SpanStation], folder: &Path) -> Vec<Job> {
    let names = SpanStation::names(stations);
    let job = |(name, station): (String, &SpanStation)| Job {
        file: folder.join(format!("{name}.section.toml")),
        folder: folder.to_owned(),
        label: label(station),
        name,
    };
    names.into_iter().zip(stations).map(job).collect()
}

/// The sections to solve, and the solved ones.
struct Plan<'a> {
    layup: &'a Layup,
    stations: Vec<SpanStation>,
    jobs: Vec<Job>,
    run: Run,
    /// Whether the sections are drawn in a report.
    are_drawn: bool,
    /// Parallel to `jobs`.
    solved: Vec<OnceLock<SolvedStation>>,
}

impl<'a> Plan<'a> {
    fn new(layup: &'a Layup, files: &SpanFiles, arguments: &WholeBladeArguments) -> Self {
        let stations = stations_of(layup, arguments);
        Self {
            layup,
            jobs: jobs_of(&stations, &files.sections()),
            run: Run::plain(arguments.force),
            are_drawn: arguments.report,
            solved: stations.iter().map(|_| OnceLock::new()).collect(),
            stations,
        }
    }

    /// Meshes a section, writes its files, and solves it unless they are as before.
    fn solve(&self, number: usize, job: &Job) -> Outcome {
        let station = match self.write_section(number, job) {
            Ok(station) => station,
            Err(problems) => {
                // results of an earlier run
                let files = OutputFiles::new(&job.folder, &job.name).ok();
                let earlier = files.as_ref().map(OutputFiles::earlier);
                files.map(|files| ResultWriter::new(files).abandon());
                return Outcome {
                    removed: earlier.map_or_else(Vec::new, Earlier::removed),
                    problems: Some(problems),
                    ..Outcome::new(Status::NotReached)
                };
            }
        };
        let (outcome, analyzed) = analyze_one(job, &self.run);
        if let Some(properties) = outcome.properties.clone() {
            let drawn = analyzed.filter(|_| self.are_drawn);
            let station = SolvedStation {
                picture: drawn.map(|analyzed| picture(analyzed, job, &properties)),
                ..station(properties)
            };
            // each section is solved once
            let _ = self.solved[number].set(station);
        }
        outcome
    }

    /// Writes the section file and the mesh of a section; returns the station for its properties.
    fn write_section(
        &self,
        number: usize,
        job: &Job,
    ) -> Result<impl FnOnce(SectionProperties) -> SolvedStation, String> {
        let at = self.stations[number];
        let eta = at.meshed_at();
        let meshed = self
            .layup
            .mesh(eta)
            .map_err(|problems| problems.to_string())?;
        let mesh = format!("{}.msh", job.name);
        let section = layup_section(self.layup, &meshed, &mesh);
        let written = gmsh::write(&meshed.mesh);
        renew(&job.folder.join(&mesh), &written)
            .and_then(|()| renew(&job.file, &section))
            .map_err(|problem| words(&problem))?;
        let (chord, layers) = (
            self.layup.shape.chord.at(eta),
            layer_rows(self.layup, &meshed),
        );
        let fingerprint = section_fingerprint(section.as_bytes(), written.as_bytes());
        Ok(move |properties| SolvedStation {
            eta: at.eta,
            fingerprint,
            chord,
            properties,
            layers,
            picture: None,
        })
    }

    /// The sections without a result.
    fn missing(&self) -> Vec<String> {
        let all = self.jobs.iter().zip(&self.solved);
        let missing = all.filter(|(_, solved)| solved.get().is_none());
        missing.map(|(job, _)| job.label.clone()).collect()
    }
}

/// The picture of an analyzed section, with its stresses.
fn picture(analyzed: Analyzed, job: &Job, properties: &SectionProperties) -> SectionPicture {
    let (input, solution) = solution_of(analyzed, job, properties);
    let stress = match &solution {
        Ok(solution) => Ok(Recoverer::new(&input.section, solution).unit_cell_stresses()),
        Err(failure) => Err(failure.to_string()),
    };
    SectionPicture::new(&input, &stress)
}

/// A station as tables show it.
fn label(station: &SpanStation) -> String {
    let side = match station.side {
        None => "",
        Some(Side::Inner) => " inner",
        Some(Side::Outer) => " outer",
    };
    format!("eta {}{side}", crate::mesh::short(station.eta))
}

/// Writes a file unless it has this content.
fn renew(file: &Path, text: &str) -> Result<(), OutputProblem> {
    match std::fs::read_to_string(file) {
        Ok(known) if known == text => Ok(()),
        _ => write_whole(file, text),
    }
}
