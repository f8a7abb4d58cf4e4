//! The stations: tables `[[station]]`, or a table of a file named by `[stations]`.

use nalgebra::{Matrix6, Vector2, Vector3};

use super::columns::{Columns, Measure};
use super::engineering::{self, ANGLES, CENTERS, MASS, Numbers, Parts, STIFFNESS};
use super::frame::{self, Frame};
use super::matrix::{self, Kind};
use super::problem::InputProblem;
use super::{Placed, Sources};
use crate::blade::Station;
use crate::document::Table;
use crate::error::Place;
use crate::line::about_x;
use crate::section::{self, Damping, Engineering};
use crate::units::Dimension;
use crate::wrench;

/// What the file says for all stations.
#[derive(Debug, Clone, Copy)]
pub(super) struct Given<'a> {
    pub frame: Option<&'a Frame>,
    pub reference_point: Option<Vector2<f64>>,
    /// Length of the line.
    pub length: Option<f64>,
}

/// Where a station stands and how its axes lie.
#[derive(Debug, Clone, Copy)]
struct Seat {
    arc_length: f64,
    /// Its own reference point.
    point: Vector2<f64>,
    /// From the section axes of the line to its own.
    angle: f64,
}

/// Reads all stations.
pub(super) fn read(root: &Table<'_>, given: &Given<'_>, sources: &Sources) -> Option<Vec<Placed>> {
    match (root.has("stations"), root.has("station")) {
        (true, false) => of_file(&root.table("stations")?, given, sources),
        (false, true) => {
            let tables = root.tables("station");
            let read = tables.iter().map(|table| {
                let station = in_place(table, given, sources);
                table.finish();
                station
            });
            // Every station is looked at, so that each wrong one is noted.
            let read: Vec<_> = read.collect();
            read.into_iter().collect()
        }
        (true, true) => {
            let problem = InputProblem::Both {
                table: root.title().to_owned(),
                one: "[stations]".to_owned(),
                other: "[[station]]".to_owned(),
            };
            root.note("station", &problem);
            None
        }
        (false, false) => {
            let problem = InputProblem::Neither {
                table: root.title().to_owned(),
                known: vec!["[stations] with a \"file\"", "tables [[station]]"],
            };
            root.note("stations", &problem);
            None
        }
    }
}

/// The 6x6 about the reference point of the blade, in the section axes of the line.
fn seated(matrix: &Matrix6<f64>, seat: &Seat, given: &Given<'_>) -> Option<Matrix6<f64>> {
    let turned = match seat.angle {
        0.0 => *matrix,
        angle => wrench::rotate(matrix, &about_x(-angle)),
    };
    let by = given.reference_point? - seat.point;
    Some(match by == Vector2::zeros() {
        true => turned,
        false => wrench::shift(&turned, &Vector3::new(0.0, by.x, by.y)),
    })
}

/// Notes two keys for one thing, or none; `Some(true)` for the first.
fn either(table: &Table<'_>, has: impl Fn(&str) -> bool, one: &str, other: &str) -> Option<bool> {
    match (has(one), has(other)) {
        (true, false) => Some(true),
        (false, true) => Some(false),
        (true, true) => {
            let problem = InputProblem::Both {
                table: table.title().to_owned(),
                one: one.to_owned(),
                other: other.to_owned(),
            };
            table.note(other, &problem);
            None
        }
        (false, false) => {
            let problem = InputProblem::Neither {
                table: table.title().to_owned(),
                known: vec!["\"arc_length\"", "\"eta\" (part of the length)"],
            };
            table.note("eta", &problem);
            None
        }
    }
}

/// A `[[station]]`.
fn in_place(table: &Table<'_>, given: &Given<'_>, sources: &Sources) -> Option<Placed> {
    let arc_length = match either(table, |key| table.has(key), "arc_length", "eta") {
        Some(true) => table.quantity("arc_length", Dimension::LENGTH),
        Some(false) => {
            let eta = table.quantity("eta", Dimension::NUMBER);
            eta.and_then(|eta| Some(eta * given.length?))
        }
        None => None,
    };
    let point = match table.has("reference_point") {
        true => frame::point(table, "reference_point", given.frame),
        false => given.reference_point,
    };
    let angle = match table.has("angle") {
        true => table.quantity("angle", Dimension::ANGLE),
        false => Some(0.0),
    };
    let matrices = match table.has("file") {
        true => of_section(table, sources),
        false => in_table(table, given).map(|(k, m)| (k, m, None)),
    };
    let (stiffness, mass, damping) = matrices?;
    let seat = Seat {
        arc_length: arc_length?,
        point: point?,
        angle: given.frame?.twist(angle?),
    };
    let damping = match damping {
        Some(Damping::Viscous(matrix)) => Some(Damping::Viscous(seated(&matrix, &seat, given)?)),
        other => other,
    };
    Some(Placed {
        place: Place::line(table.document().file(), table.line()),
        station: Station {
            arc_length: seat.arc_length,
            stiffness: seated(&stiffness, &seat, given)?,
            mass: seated(&mass, &seat, given)?,
        },
        damping,
    })
}

/// Stiffness, mass and damping of a property file.
fn of_section(
    table: &Table<'_>,
    sources: &Sources,
) -> Option<(Matrix6<f64>, Matrix6<f64>, Option<Damping>)> {
    let document = table.document();
    let written = table.require_text("file", "the name of a property file")?;
    let path = document.path(&written);
    let text = document.keep(sources.read(&path))?;
    let section = document.keep(section::parse(&text, &path.display().to_string()))?;
    for (is_there, what) in [
        (section.piezo.is_some(), "piezoelectric coupling"),
        (section.thermal_force.is_some(), "thermal force"),
    ] {
        if is_there {
            let remark = format!("{written}: its {what} is not part of a blade");
            sources.remark(remark);
        }
    }
    Some((section.stiffness, section.mass, section.damping))
}

/// Matrices or engineering properties of a table.
fn in_table(table: &Table<'_>, given: &Given<'_>) -> Option<(Matrix6<f64>, Matrix6<f64>)> {
    let parts = Parts {
        stiffness: !table.has("stiffness"),
        mass: !table.has("mass"),
    };
    let is_ours = note_foreign(table, parts, given);
    let engineering = engineering::read(&InTable(table), parts);
    let of = |kind: Kind, asked: bool| match asked {
        true => Some(Matrix6::zeros()),
        false => matrix::read(table, kind, given.frame),
    };
    let stiffness = of(Kind::Stiffness, parts.stiffness);
    let mass = of(Kind::Mass, parts.mass);
    let (engineering, stiffness, mass) = (engineering?, stiffness?, mass?);
    is_ours.then(|| {
        (
            stiffness + engineering.stiffness_matrix(),
            mass + engineering.mass_matrix(),
        )
    })
}

/// Notes engineering properties in a frame that is not ours.
fn note_foreign(table: &Table<'_>, parts: Parts, given: &Given<'_>) -> bool {
    let foreign = given.frame.is_some_and(|frame| !frame.is_ours());
    let key = match (parts.stiffness, parts.mass) {
        (true, _) => STIFFNESS[0].0,
        (false, true) => MASS[0].0,
        (false, false) => return true,
    };
    if foreign {
        let problem = InputProblem::EngineeringFrame {
            table: table.title().to_owned(),
            key,
        };
        table.note(key, &problem);
    }
    !foreign
}

struct InTable<'a>(&'a Table<'a>);

impl Numbers for InTable<'_> {
    fn number(&self, key: &'static str, dimension: Dimension) -> Option<f64> {
        self.0.require_quantity(key, dimension)
    }

    fn point(&self, (key, _): (&'static str, [&'static str; 2])) -> Option<Vector2<f64>> {
        match self.0.has(key) {
            true => frame::point(self.0, key, Some(&Frame::ours())),
            false => Some(Vector2::zeros()),
        }
    }

    fn angle(&self, key: &'static str) -> Option<f64> {
        match self.0.has(key) {
            true => self.0.quantity(key, Dimension::ANGLE),
            false => Some(0.0),
        }
    }
}

/// The stations of `[stations]`.
fn of_file(table: &Table<'_>, given: &Given<'_>, sources: &Sources) -> Option<Vec<Placed>> {
    let root_at = match table.has("root_at") {
        true => table.quantity("root_at", Dimension::LENGTH),
        false => Some(0.0),
    };
    let columns = Columns::read(table, sources);
    let stations = columns.as_ref().and_then(|columns| {
        let file = StationFile {
            table,
            columns,
            given,
        };
        file.stations(root_at?)
    });
    table.finish();
    if let Some(columns) = columns {
        columns.finish(sources);
    }
    stations
}

/// A table of stations and what is given for all of them.
struct StationFile<'a> {
    table: &'a Table<'a>,
    columns: &'a Columns<'a>,
    given: &'a Given<'a>,
}

impl StationFile<'_> {
    fn stations(&self, root_at: f64) -> Option<Vec<Placed>> {
        let arc_lengths = self.arc_lengths(root_at);
        let points = self.points();
        let angles = self.angles();
        let has = |kind: Kind| self.columns.has(&kind.entry(0, 0));
        let parts = Parts {
            stiffness: !has(Kind::Stiffness),
            mass: !has(Kind::Mass),
        };
        let is_ours = note_foreign(self.table, parts, self.given);
        let engineering = self.engineering(parts);
        let of = |kind: Kind, asked: bool| match asked {
            true => Some(Vec::new()),
            false => self.matrices(kind),
        };
        let stiffness = of(Kind::Stiffness, parts.stiffness);
        let mass = of(Kind::Mass, parts.mass);
        let (arc_lengths, points, angles) = (arc_lengths?, points?, angles?);
        let (engineering, stiffness, mass) = (engineering?, stiffness?, mass?);
        if !is_ours {
            return None;
        }
        let places = self.columns.places().into_iter().enumerate();
        let station = |(row, place): (usize, Place)| {
            let seat = Seat {
                arc_length: arc_lengths[row],
                point: points[row],
                angle: self.given.frame?.twist(angles[row]),
            };
            let own = engineering.get(row)?;
            let stiffness = stiffness.get(row).copied();
            let mass = mass.get(row).copied();
            let stiffness = stiffness.unwrap_or_else(|| own.stiffness_matrix());
            let mass = mass.unwrap_or_else(|| own.mass_matrix());
            Some(Placed {
                place,
                station: Station {
                    arc_length: seat.arc_length,
                    stiffness: seated(&stiffness, &seat, self.given)?,
                    mass: seated(&mass, &seat, self.given)?,
                },
                damping: None,
            })
        };
        places.map(station).collect()
    }

    fn numbers(&self, key: &str, dimension: Dimension) -> Option<Vec<f64>> {
        let factor = self.table.document().factor(dimension);
        self.columns.numbers(key, Measure { dimension, factor })
    }

    /// As [`StationFile::numbers`]; zeros without the column.
    fn optional(&self, key: &str, dimension: Dimension) -> Option<Vec<f64>> {
        match self.columns.has(key) {
            true => self.numbers(key, dimension),
            false => Some(vec![0.0; self.columns.places().len()]),
        }
    }

    fn arc_lengths(&self, root_at: f64) -> Option<Vec<f64>> {
        let has = |key: &str| self.columns.has(key);
        let numbers = match either(self.table, has, "arc_length", "eta")? {
            true => self.numbers("arc_length", Dimension::LENGTH)?,
            false => {
                let parts = self.numbers("eta", Dimension::NUMBER)?;
                let length = self.given.length?;
                parts.into_iter().map(|eta| eta * length).collect()
            }
        };
        Some(numbers.into_iter().map(|s| s - root_at).collect())
    }

    /// The reference point of each station.
    fn points(&self) -> Option<Vec<Vector2<f64>>> {
        let frame = self.given.frame?;
        let keys = frame
            .plane_names()
            .map(|name| format!("reference_point_{name}"));
        if keys.iter().all(|key| !self.columns.has(key)) {
            let all = self.given.reference_point?;
            return Some(vec![all; self.columns.places().len()]);
        }
        let [first, second] = keys.map(|key| self.optional(&key, Dimension::LENGTH));
        let pairs = first?.into_iter().zip(second?);
        Some(pairs.map(|(a, b)| frame.point([a, b])).collect())
    }

    fn angles(&self) -> Option<Vec<f64>> {
        self.optional("angle", Dimension::ANGLE)
    }

    fn matrices(&self, kind: Kind) -> Option<Vec<Matrix6<f64>>> {
        let (frame, document) = (self.given.frame?, self.table.document());
        let mut written = vec![Matrix6::zeros(); self.columns.places().len()];
        let mut all_good = true;
        for (i, j) in matrix::upper() {
            let measure = kind.measure(document, frame, i, j);
            let Some(numbers) = self.columns.numbers(&kind.entry(i, j), measure) else {
                all_good = false;
                continue;
            };
            for (matrix, number) in written.iter_mut().zip(numbers) {
                (matrix[(i, j)], matrix[(j, i)]) = (number, number);
            }
        }
        all_good.then(|| written.iter().map(|matrix| frame.matrix(matrix)).collect())
    }

    /// The engineering properties of all rows.
    fn engineering(&self, parts: Parts) -> Option<Vec<Engineering>> {
        // Columns are read once each, so that each problem is told once.
        let mut known = Vec::new();
        let asked = [(&STIFFNESS[..], parts.stiffness), (&MASS[..], parts.mass)];
        for (keys, _) in asked.into_iter().filter(|part| part.1) {
            let read = |&(key, dimension)| (key, self.numbers(key, dimension));
            known.extend(keys.iter().map(read));
        }
        let of_parts = [parts.stiffness, parts.stiffness, parts.mass];
        for (center, _) in CENTERS.iter().zip(of_parts).filter(|part| part.1) {
            let read = |key| (key, self.optional(key, Dimension::LENGTH));
            known.extend(center.1.map(read));
        }
        for (key, _) in ANGLES
            .into_iter()
            .zip([parts.stiffness, parts.mass])
            .filter(|part| part.1)
        {
            known.push((key, self.optional(key, Dimension::ANGLE)));
        }
        let of_row = |row| engineering::read(&OfRow { known: &known, row }, parts);
        (0..self.columns.places().len()).map(of_row).collect()
    }
}

/// A row of the columns that were read.
struct OfRow<'a> {
    known: &'a [(&'static str, Option<Vec<f64>>)],
    row: usize,
}

impl Numbers for OfRow<'_> {
    fn number(&self, key: &'static str, _: Dimension) -> Option<f64> {
        let known = self.known.iter().find(|known| known.0 == key)?;
        known.1.as_ref()?.get(self.row).copied()
    }

    fn point(&self, (_, keys): (&'static str, [&'static str; 2])) -> Option<Vector2<f64>> {
        let [y, z] = keys.map(|key| self.number(key, Dimension::LENGTH));
        Some(Vector2::new(y?, z?))
    }

    fn angle(&self, key: &'static str) -> Option<f64> {
        self.number(key, Dimension::ANGLE)
    }
}
