//! The tables: points of the line, stations, names of section files.

use std::path::Path;

use nalgebra::{Matrix6, Vector2, Vector3};

use crate::blade::{CurvedStation, Station};
use crate::document::read_text;
use crate::error::{Diagnostics, SourceLocation, nearest_name};
use crate::exchange::frame::Convention;
use crate::exchange::problem::{ExchangeProblem, Problems};
use crate::exchange::text::{Line, from_upper, not_a_number, number};
use crate::exchange::vabs::blocks;
use crate::line::{Course, LinePoint, ReferenceLine};
use crate::section;

/// A station, and its section if that was solved for a curved beam.
pub(super) type CsvStation = (Station, Option<CurvedStation>);

/// The tables of a file, as lines.
#[derive(Debug, Default)]
pub(super) struct Tables<'a> {
    line: Vec<Line<'a>>,
    stations: Option<Vec<Line<'a>>>,
    sections: Option<Vec<Line<'a>>>,
}

const NAMES: [&str; 3] = ["line", "stations", "sections"];

/// Names of the columns of the line.
pub(super) const LINE: [&str; 4] = ["x [m]", "y [m]", "z [m]", "twist [rad]"];
/// Names of the columns of section files.
pub(super) const SECTIONS: [&str; 2] = ["s [m]", "file"];

/// Names of the columns of stations.
pub(super) fn station_columns() -> Vec<String> {
    let pairs = || (1..=6).flat_map(|i| (i..=6).map(move |j| (i, j)));
    let of = |letter: &'static str, units: [&'static str; 3]| {
        // of two forces, of a force and a moment, of two moments
        let unit = move |i, j| units[usize::from(i > 3) + usize::from(j > 3)];
        pairs().map(move |(i, j)| format!("{letter}{i}{j} [{}]", unit(i, j)))
    };
    std::iter::once(SECTIONS[0].to_owned())
        .chain(of("K", ["N", "N m", "N m^2"]))
        .chain(of("M", ["kg/m", "kg", "kg m"]))
        .collect()
}

/// Whether a column has a name, with or without its unit.
fn is_named(found: &str, name: &str) -> bool {
    let bare = name.split_once(" [").map_or(name, |(bare, _)| bare);
    found == name || found == bare
}

impl<'a> Tables<'a> {
    /// Splits the file; notes tables of other names.
    pub fn parse(lines: &[Line<'a>], problems: &mut Problems) -> Self {
        let mut tables = Self::default();
        let mut into: Option<&mut Vec<Line<'a>>> = None;
        for line in lines.iter().filter(|line| !line.text.starts_with('#')) {
            if let Some(name) = line.text.strip_prefix("table,") {
                into = match name.trim_matches([' ', ',']) {
                    "line" => Some(&mut tables.line),
                    "stations" => Some(tables.stations.insert(Vec::new())),
                    "sections" => Some(tables.sections.insert(Vec::new())),
                    other => {
                        problems.push(line.number, &unknown_table(other));
                        None
                    }
                };
            } else if let Some(table) = &mut into {
                table.push(*line);
            }
        }
        tables
    }

    /// The line through its points.
    pub fn line(&self, course: Course, problems: &mut Problems) -> Option<ReferenceLine> {
        let names = LINE.map(str::to_owned);
        let rows = body(&self.line, "line", &names, problems)?;
        let mut points: Vec<LinePoint> = Vec::new();
        for (i, line) in rows.iter().enumerate() {
            let Some([x, y, z, twist]) = line.numbers(&format!("point {}", i + 1), problems) else {
                continue;
            };
            let position = Vector3::new(x, y, z);
            let before = points.last().map(|point| point.position);
            if let Some(before) = before
                .filter(|before| *before == position || before.x >= x && course == Course::Spline)
            {
                let problem = ExchangeProblem::Other {
                    what: format!("x of point {}", i + 1),
                    found: x.to_string(),
                    expected: format!("more than the value of the previous point, {}", before.x),
                    help: "put the points in order from the root to the tip".to_owned(),
                };
                problems.push(line.number, &problem);
            }
            points.push(LinePoint { position, twist });
        }
        if rows.len() < 2 {
            let problem = ExchangeProblem::CutShort {
                what: format!("the table \"line\", which has {} points", rows.len()),
                expected: "at least two points, root and tip".to_owned(),
            };
            problems.push(self.line.last().map_or(0, |line| line.number), &problem);
        }
        Some(ReferenceLine::through(points, course))
    }

    /// Location of each station.
    pub fn locations(&self, file: &Path) -> Vec<SourceLocation> {
        let lines = self.stations.as_ref().or(self.sections.as_ref());
        // The first line has the names of the columns.
        let rows = lines.into_iter().flatten().skip(1);
        let file = file.display().to_string();
        rows.map(|line| SourceLocation::line(&file, line.number))
            .collect()
    }

    /// Notes another number of stations than the header states.
    pub fn check_count(&self, stated: Option<usize>, problems: &mut Problems) {
        let Some(lines) = self.stations.as_ref().or(self.sections.as_ref()) else {
            return;
        };
        // The first line has the names of the columns.
        let found = lines.len().saturating_sub(1);
        let Some(stated) = stated.filter(|&stated| stated != found) else {
            return;
        };
        let line = lines.last().map_or(0, |line| line.number);
        let what = format!("the table of stations, after {found} of {stated}");
        let problem = if found < stated {
            ExchangeProblem::CutShort {
                what,
                expected: format!("{stated} stations, as the header states"),
            }
        } else {
            ExchangeProblem::Other {
                what: "the table of stations".to_owned(),
                found: format!("{found} stations"),
                expected: format!("{stated}, as the header states"),
                help: "correct the line \"# stations:\" of the header, or remove it".to_owned(),
            }
        };
        problems.push(line, &problem);
    }

    /// The stations, from their table or from section files.
    pub fn stations(
        &self,
        frame: Option<Convention>,
        file: &Path,
        problems: &mut Problems,
        all: &mut Diagnostics,
    ) -> Option<Vec<CsvStation>> {
        match (&self.stations, &self.sections) {
            (Some(lines), None) => {
                let stations = stations(lines, frame?, problems)?.into_iter();
                Some(stations.map(|station| (station, None)).collect())
            }
            (None, Some(lines)) => sections(lines, frame?, file, problems, all),
            (None, None) => {
                problems.push(0, &no_stations());
                None
            }
            (Some(_), Some(lines)) => {
                let problem = ExchangeProblem::Other {
                    what: "tables".to_owned(),
                    found: "both \"stations\" and \"sections\"".to_owned(),
                    expected: "one of them".to_owned(),
                    help: "remove one".to_owned(),
                };
                problems.push(lines.first().map_or(0, |line| line.number), &problem);
                None
            }
        }
    }
}

fn unknown_table(name: &str) -> ExchangeProblem {
    ExchangeProblem::Other {
        what: "table".to_owned(),
        found: format!("\"{name}\""),
        expected: "\"line\", \"stations\" or \"sections\"".to_owned(),
        help: nearest_name(name, NAMES).map_or_else(
            || "remove it".to_owned(),
            |name| format!("did you mean \"{name}\"?"),
        ),
    }
}

fn no_stations() -> ExchangeProblem {
    ExchangeProblem::Missing {
        what: "the table of stations".to_owned(),
        help: "a line \"table,stations\" begins it, or \"table,sections\" for section files; is \
               the file cut short?"
            .to_owned(),
    }
}

/// The lines below the names of the columns, which must be those expected.
fn body<'t, 'a>(
    lines: &'t [Line<'a>],
    table: &str,
    names: &[String],
    problems: &mut Problems,
) -> Option<&'t [Line<'a>]> {
    let Some((head, rows)) = lines.split_first() else {
        problems.push(
            0,
            &ExchangeProblem::Missing {
                what: format!("the table \"{table}\""),
                help: format!(
                    "a line \"table,{table}\" begins it, then the names of its columns: {}",
                    names.join(",")
                ),
            },
        );
        return None;
    };
    let found: Vec<_> = head.text.split(',').map(str::trim).collect();
    let mut pairs = found.iter().zip(names);
    let differs = pairs.position(|(found, name)| !is_named(found, name));
    if differs.is_some() || found.len() != names.len() {
        let position = differs.unwrap_or(found.len().min(names.len()));
        problems.push(
            head.number,
            &ExchangeProblem::Other {
                what: format!("columns of the table \"{table}\""),
                found: format!(
                    "{}, of which number {} is \"{}\"",
                    found.len(),
                    position + 1,
                    found.get(position).unwrap_or(&"missing")
                ),
                expected: format!(
                    "{}, with \"{}\" there",
                    names.len(),
                    names.get(position).map_or("none", String::as_str)
                ),
                help: format!("the columns are {}", names.join(",")),
            },
        );
        return None;
    }
    Some(rows)
}

/// Notes an arc length below the previous station.
fn check_order(
    position: f64,
    line: &Line<'_>,
    number: usize,
    last: Option<&Station>,
    problems: &mut Problems,
) {
    if let Some(before) = last
        .map(|last| last.arc_length)
        .filter(|&before| before > position)
    {
        let (what, found) = (format!("arc length s of station {number}"), position);
        let problem = ExchangeProblem::Order {
            what,
            found,
            before,
        };
        problems.push(line.number, &problem);
    }
}

fn stations(
    lines: &[Line<'_>],
    frame: Convention,
    problems: &mut Problems,
) -> Option<Vec<Station>> {
    let rows = body(lines, "stations", &station_columns(), problems)?;
    let mut stations: Vec<Station> = Vec::new();
    for (i, line) in rows.iter().enumerate() {
        let Some(values) = line.numbers::<43>(&format!("station {}", i + 1), problems) else {
            continue;
        };
        check_order(values[0], line, i + 1, stations.last(), problems);
        stations.push(Station {
            arc_length: values[0],
            stiffness: frame.to_ours(&from_upper(&values[1..22])),
            mass: frame.to_ours(&from_upper(&values[22..43])),
        });
    }
    if rows.is_empty() {
        problems.push(0, &no_stations());
    }
    Some(stations)
}

fn sections(
    lines: &[Line<'_>],
    frame: Convention,
    file: &Path,
    problems: &mut Problems,
    all: &mut Diagnostics,
) -> Option<Vec<CsvStation>> {
    let names = SECTIONS.map(str::to_owned);
    let rows = body(lines, "sections", &names, problems)?;
    let folder = file.parent().unwrap_or(Path::new(""));
    let mut stations: Vec<CsvStation> = Vec::new();
    for (i, line) in rows.iter().enumerate() {
        let Some((position, name)) = line.text.split_once(',') else {
            let (what, expected, found) = (format!("section {}", i + 1), 2, 1);
            let problem = ExchangeProblem::Count {
                what,
                expected,
                found,
                separator: "commas",
            };
            problems.push(line.number, &problem);
            continue;
        };
        let Some(arc_length) = number(position.trim()) else {
            problems.push(line.number, &not_a_number("arc length s", position.trim()));
            continue;
        };
        let last = stations.last().map(|last| &last.0);
        check_order(arc_length, line, i + 1, last, problems);
        let name = name.trim().trim_matches('"');
        let path = folder.join(name);
        if !problems.finds(&path, &format!("section {}", i + 1), name, line.number) {
            continue;
        }
        if let Some(([stiffness, mass], curved)) = all.keep(section_file(&path, name, frame)) {
            let station = Station {
                arc_length,
                stiffness,
                mass,
            };
            stations.push((station, curved));
        }
    }
    if rows.is_empty() {
        problems.push(0, &no_stations());
    }
    Some(stations)
}

/// Stiffness and mass of a section file: VABS output, in the axes of the stated frame, or
/// a property file of section-analyzer, which is in Helicoid's axes and may be of a
/// curved beam.
fn section_file(
    path: &Path,
    name: &str,
    frame: Convention,
) -> Result<([Matrix6<f64>; 2], Option<CurvedStation>), Diagnostics> {
    let text = read_text(path)?;
    let shown = path.display().to_string();
    if blocks::recognize(&text) {
        let (stiffness, mass) = blocks::section(&text, &shown)?;
        return Ok(([frame.to_ours(&stiffness), frame.to_ours(&mass)], None));
    }
    let section = section::parse(&text, &shown)?;
    let curved = CurvedStation::of(name, &section, Vector2::zeros(), 0.0);
    let section = section.per_arc_length();
    Ok(([section.stiffness, section.mass], curved))
}
