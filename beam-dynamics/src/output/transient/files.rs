//! The files of a run, written while it runs: all recorders as one.

use std::path::{Path, PathBuf};

use shared_geom::files::make_folder;

use super::csv_rows::CsvRows;
use super::grids::{FIELDS, Grids, SERIES};
use super::netcdf_rows::NetcdfRows;
use super::restart::write_snapshot;
use super::span_record::SpanRecord;
use super::writer::RowWriter;
use super::{Heading, RunFileProblem, TimePlot, TimeTable};
use crate::case::{Every, Model, OutputSettings};
use crate::output::Written;
use crate::output::air::AirRecord;
use crate::output::folder::{ResultLocation, Results};
use crate::output::span_forces::SpanForces;
use crate::result::{AcceptedStep, ColumnValues, Recorder, Snapshot};

/// Endings of the files of a run.
#[derive(Debug)]
struct Names {
    /// The analysis, in names of tables of forces.
    analysis: &'static str,
    csv: &'static str,
    netcdf: &'static str,
    text: &'static str,
    plot: [&'static str; 2],
}

const TRANSIENT: Names = Names {
    analysis: "transient",
    csv: "transient.csv",
    netcdf: "transient.nc",
    text: "transient.txt",
    plot: ["transient.png", "transient.svg"],
};
const PERIODIC: Names = Names {
    analysis: "periodic",
    csv: "periodic.csv",
    netcdf: "periodic.nc",
    text: "periodic.txt",
    plot: ["periodic.png", "periodic.svg"],
};
const RESTART: &str = "restart.json";
/// Numbers of a table up to which a figure is drawn without a request.
const MOST_NUMBERS: usize = 20_000_000;

/// Writes `NAME.transient.csv` and `NAME.transient.nc` (a row every `every`), field files in
/// `NAME.transient` with their series `NAME.transient.pvd`, `NAME.restart.json`, and at the end
/// `NAME.transient.txt` and, if figures are drawn, a figure of all columns; with blades in the air
/// and on request `NAME.transient_air.csv` with maps of the disk of each rotor, `NAME.disk_1`; on
/// request the internal forces along each blade and line of beams,
/// `NAME.transient.MEMBER.forces.csv` and their envelope `NAME.transient.MEMBER.envelope.csv`.
#[derive(Debug)]
pub struct RunFiles<'a> {
    names: &'static Names,
    values: ColumnValues<'a>,
    results: Results<'a>,
    tables: Vec<Box<dyn RowWriter>>,
    grids: Option<(Grids<'a>, usize)>,
    air: Option<AirRecord<'a>>,
    forces: Option<SpanRecord<'a>>,
    rows: Schedule,
    restarts: Option<Schedule>,
    kept: Option<PathBuf>,
    /// The last instant of the run, which is always written and kept \[s\].
    end: f64,
    /// Steps up to this one are already written.
    resumed: Option<usize>,
    row: Vec<f64>,
    /// Step of the latest row.
    written: Option<usize>,
    /// Identification of the model.
    fingerprint: String,
    problem: Option<RunFileProblem>,
}

impl<'a> RunFiles<'a> {
    /// The files of `model` at `location`. Files of an earlier run are removed; a run that continues
    /// from `resumed` keeps them up to its time.
    ///
    /// # Errors
    /// [`RunFileProblem`]: the folder or a file cannot be made, or has other columns.
    pub fn new(
        model: &'a Model,
        settings: &'a OutputSettings,
        location: &'a ResultLocation,
        resumed: Option<&Snapshot>,
    ) -> Result<Self, RunFileProblem> {
        let mut files = Self::without_tables(model, settings, (location, &TRANSIENT), resumed)?;
        match resumed {
            None => {
                files.results.remove([SERIES, RESTART]);
                files.results.remove_fields(FIELDS);
            }
            Some(snapshot) => {
                files.values.go_on(&snapshot.angles);
                if let Some((grids, _)) = &mut files.grids {
                    grids.resume(&files.results, snapshot.progress.time);
                }
            }
        }
        let time = resumed.map(|snapshot| snapshot.progress.time);
        files.open_tables(model, settings, time)?;
        Ok(files)
    }

    /// The files of a period of `model` at `location`, `NAME.periodic.*`, without field files.
    ///
    /// # Errors
    /// As [`RunFiles::new`].
    pub fn of_period(
        model: &'a Model,
        settings: &'a OutputSettings,
        location: &'a ResultLocation,
    ) -> Result<Self, RunFileProblem> {
        let mut files = Self::without_tables(model, settings, (location, &PERIODIC), None)?;
        (files.grids, files.restarts) = (None, None);
        files.open_tables(model, settings, None)?;
        Ok(files)
    }

    /// The files without tables; files of an earlier run are removed.
    fn without_tables(
        model: &'a Model,
        settings: &'a OutputSettings,
        (location, names): (&'a ResultLocation, &'static Names),
        resumed: Option<&Snapshot>,
    ) -> Result<Self, RunFileProblem> {
        make_folder(&location.folder)?;
        let results = Results::new(location);
        let files = Self {
            names,
            values: ColumnValues::new(model, settings),
            tables: Vec::new(),
            grids: settings.vtu.map(|each| (Grids::new(model), each)),
            air: settings.air.map(|count| AirRecord::new(model, count)),
            forces: None,
            rows: Schedule::new(settings.every, resumed),
            restarts: settings.restart.map(|every| Schedule::new(every, resumed)),
            kept: None,
            end: f64::INFINITY,
            resumed: resumed.map(|snapshot| snapshot.step),
            row: vec![0.0; 1 + settings.columns.len()],
            written: None,
            fingerprint: model.fingerprint(),
            problem: None,
            results,
        };
        files.results.remove(names.plot);
        files.results.remove([names.text]);
        AirRecord::remove_files(&files.results);
        if resumed.is_none() {
            files.results.remove([names.csv, names.netcdf]);
            SpanForces::remove_files(&files.results, names.analysis);
        }
        Ok(files)
    }

    fn open_tables(
        &mut self,
        model: &'a Model,
        settings: &OutputSettings,
        time: Option<f64>,
    ) -> Result<(), RunFileProblem> {
        if settings.span_forces {
            let files = (&self.results, self.names.analysis);
            self.forces = Some(SpanRecord::new(model, files, time)?);
        }
        let of_columns = settings.columns.iter().map(Heading::of);
        let headings: Vec<_> = std::iter::once(Heading::time()).chain(of_columns).collect();
        if settings.csv {
            let path = self.results.path(self.names.csv);
            self.tables.push(match time {
                None => Box::new(CsvRows::create(&path, &headings)?),
                Some(time) => Box::new(CsvRows::resume(&path, &headings, time)?),
            });
        }
        if settings.netcdf {
            let (path, title) = (self.results.path(self.names.netcdf), &model.name);
            self.tables.push(match time {
                None => Box::new(NetcdfRows::create(&path, title, &headings)?),
                Some(time) => Box::new(NetcdfRows::resume(&path, title, &headings, time)?),
            });
        }
        Ok(())
    }

    /// Always writes and keeps the state at `end` \[s\].
    pub fn until(mut self, end: f64) -> Self {
        self.end = end;
        self
    }

    /// Whether any row is written, by this part of the run or by the previous one.
    pub fn has_rows(&self) -> bool {
        self.written.is_some() || self.resumed.is_some()
    }

    /// The problem that ended the run, if it was output.
    pub fn problem(&self) -> Option<&RunFileProblem> {
        self.problem.as_ref()
    }

    /// Writes the figure and `text`, and lists all files.
    ///
    /// # Errors
    /// [`RunFileProblem`]: the one that ended the run, or a file that cannot be written.
    pub fn finish(mut self, title: &str, text: &str) -> Result<Written, RunFileProblem> {
        if let Some(problem) = self.problem {
            return Err(problem);
        }
        let paths = self.tables.iter().map(|table| table.path().to_owned());
        let paths: Vec<_> = paths.collect();
        self.results.written.files.extend(paths.iter().cloned());
        let drawn = paths.last().filter(|_| self.results.draws());
        let mut plot = drawn.and_then(|path| default_plot(title, path));
        let not_drawn = plot.as_mut().map(TimePlot::shorten).unwrap_or_default();
        self.results.text(
            self.names.text,
            &(text.to_owned() + &not_drawn_text(&not_drawn)),
        )?;
        self.results.written.not_drawn = not_drawn;
        self.results.figures(self.names.plot, || plot)?;
        if let Some(air) = &self.air {
            air.write(&mut self.results)?;
        }
        if let Some(forces) = &self.forces {
            forces.write(&mut self.results)?;
        }
        if self.grids.is_some() && self.results.path(SERIES).exists() {
            let series = self.results.path(SERIES);
            self.results.written.files.push(series);
            self.results.list_fields(FIELDS);
        }
        self.results.written.files.extend(self.kept);
        Ok(self.results.written)
    }

    fn write(&mut self, accepted: &AcceptedStep<'_>) -> Result<(), RunFileProblem> {
        self.values.follow(accepted);
        let before = self.rows.last;
        if !self.rows.is_due(accepted) && accepted.time < self.end {
            return Ok(());
        }
        self.write_row(accepted)?;
        if let Some((grids, each)) = &mut self.grids {
            let number = |row: u64| row / *each as u64;
            let is_due = before.map(number) != self.rows.last.map(number);
            if is_due {
                grids.write(&mut self.results, accepted)?;
            }
        }
        Ok(())
    }

    fn write_row(&mut self, accepted: &AcceptedStep<'_>) -> Result<(), RunFileProblem> {
        self.row[0] = accepted.time;
        self.values.evaluate(accepted, &mut self.row[1..]);
        for table in &mut self.tables {
            table.write(&self.row)?;
        }
        if let Some(air) = &mut self.air {
            air.add(accepted);
        }
        if let Some(forces) = &mut self.forces {
            forces.add(accepted)?;
        }
        self.written = Some(accepted.step);
        Ok(())
    }
}

impl Recorder for RunFiles<'_> {
    fn record(&mut self, accepted: &AcceptedStep<'_>) -> bool {
        if self.resumed.is_some_and(|step| accepted.step <= step) {
            return true;
        }
        match self.write(accepted) {
            Ok(()) => true,
            Err(problem) => {
                self.problem = Some(problem);
                false
            }
        }
    }

    fn wants_snapshot(&self, accepted: &AcceptedStep<'_>) -> bool {
        let is_due = |schedule: &Schedule| schedule.would_be_due(accepted);
        accepted.time >= self.end || self.restarts.as_ref().is_some_and(is_due)
    }

    fn keep(&mut self, snapshot: &Snapshot) -> bool {
        let path = self.results.path(RESTART);
        if let Some(schedule) = &mut self.restarts {
            schedule.last = Some(schedule.number(snapshot.step, snapshot.progress.time));
        }
        let snapshot = Snapshot {
            model: self.fingerprint.clone(),
            angles: self.values.angles().clone(),
            ..snapshot.clone()
        };
        match write_snapshot(&snapshot, &path) {
            Ok(()) => {
                self.kept = Some(path);
                true
            }
            Err(problem) => {
                self.problem = Some(problem);
                false
            }
        }
    }

    fn stopped(&mut self, accepted: &AcceptedStep<'_>, snapshot: &Snapshot) -> bool {
        let is_written = self.written.or(self.resumed) == Some(accepted.step);
        if !is_written && let Err(problem) = self.write_row(accepted) {
            self.problem = Some(problem);
            return false;
        }
        self.keep(snapshot)
    }
}

/// Columns omitted from the figure, as text; empty if there are none.
pub fn not_drawn_text(not_drawn: &[String]) -> String {
    const SHOWN: usize = 8;
    if not_drawn.is_empty() {
        return String::new();
    }
    let shown = not_drawn[..not_drawn.len().min(SHOWN)].join(", ");
    let more = match not_drawn.len().saturating_sub(SHOWN) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    format!(
        "\nremark: the figure leaves out the columns {shown}{more}; \
         `plot` draws those given with --columns\n"
    )
}

/// All columns of the table at `path`, if it can be drawn.
fn default_plot(title: &str, path: &Path) -> Option<TimePlot> {
    let size = std::fs::metadata(path).ok()?.len() as usize;
    if size / 8 > MOST_NUMBERS {
        return None;
    }
    let table = TimeTable::read(path).ok()?;
    let plot = TimePlot::new(&[table], "time", &[]).ok()?;
    Some(plot.titled(title))
}

/// Times at which output is due.
#[derive(Debug, Clone, Copy)]
struct Schedule {
    every: Every,
    /// Number of the latest due time; `None` before the first.
    last: Option<u64>,
}

impl Schedule {
    /// Round-off of times, as part of the distance of due times.
    const ROUND_OFF: f64 = 1e-6;

    /// A schedule whose latest due time was at `resumed`.
    fn new(every: Every, resumed: Option<&Snapshot>) -> Self {
        let mut schedule = Self { every, last: None };
        schedule.last =
            resumed.map(|snapshot| schedule.number(snapshot.step, snapshot.progress.time));
        schedule
    }

    /// Number of the due time to which a step belongs.
    fn number(&self, step: usize, time: f64) -> u64 {
        match self.every {
            Every::Steps(count) => (step / count.max(1)) as u64,
            // All times before zero count as one due time.
            Every::Time(distance) => (time / distance + Self::ROUND_OFF).floor() as u64,
        }
    }

    fn would_be_due(&self, accepted: &AcceptedStep<'_>) -> bool {
        self.last != Some(self.number(accepted.step, accepted.time))
    }

    fn is_due(&mut self, accepted: &AcceptedStep<'_>) -> bool {
        let is_due = self.would_be_due(accepted);
        self.last = Some(self.number(accepted.step, accepted.time));
        is_due
    }
}
