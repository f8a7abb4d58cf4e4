//! The stations: tables `[[station]]`, or `[stations]` with a table of a file.

use nalgebra::{Matrix6, Vector2, Vector3};

use super::engineering::{self, MASS, Numbers, Parts, STIFFNESS};
use super::frame::{self, Frame};
use super::matrix::{self, Kind};
use super::problem::InputProblem;
use super::{Placed, Sources, station_file};
use crate::blade::{CurvedStation, Station};
use crate::document::Table;
use crate::error::Place;
use crate::line::about_x;
use crate::section::{self, Damping, SectionProperties};
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
pub(super) struct Seat {
    pub arc_length: f64,
    /// Its own reference point.
    pub point: Vector2<f64>,
    /// From the section axes of the line to its own.
    pub angle: f64,
}

/// Reads all stations.
pub(super) fn read(root: &Table<'_>, given: &Given<'_>, sources: &Sources) -> Option<Vec<Placed>> {
    match (root.has("stations"), root.has("station")) {
        (true, false) => station_file::read(&root.table("stations")?, given, sources),
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
pub(super) fn seated(
    matrix: &Matrix6<f64>,
    seat: &Seat,
    given: &Given<'_>,
) -> Option<Matrix6<f64>> {
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
pub(super) fn either(
    table: &Table<'_>,
    has: impl Fn(&str) -> bool,
    one: &str,
    other: &str,
) -> Option<bool> {
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
        true => of_section(table, sources).map(Matrices::Section),
        false => in_table(table, given).map(|(k, m)| Matrices::Written(Box::new([k, m]))),
    };
    let matrices = matrices?;
    let seat = Seat {
        arc_length: arc_length?,
        point: point?,
        angle: given.frame?.twist(angle?),
    };
    let curved = match &matrices {
        Matrices::Section((file, section)) => {
            CurvedStation::of(file, section, seat.point, seat.angle)
        }
        Matrices::Written(_) => None,
    };
    // Per arc length of the line, (D-231).
    let c = curved.as_ref().map_or(1.0, CurvedStation::stretch);
    let (stiffness, mass, damping) = match matrices {
        Matrices::Section((_, section)) => (section.stiffness, section.mass, section.damping),
        Matrices::Written(matrices) => {
            let [stiffness, mass] = *matrices;
            (stiffness, mass, None)
        }
    };
    let damping = match damping {
        Some(Damping::Viscous(matrix)) => {
            Some(Damping::Viscous(seated(&(matrix * c), &seat, given)?))
        }
        other => other,
    };
    Some(Placed {
        place: Place::line(table.document().file(), table.line()),
        station: Station {
            arc_length: seat.arc_length,
            stiffness: seated(&(stiffness * c), &seat, given)?,
            mass: seated(&(mass / c), &seat, given)?,
        },
        damping,
        curved,
    })
}

/// What a station has its matrices from.
enum Matrices {
    /// A property file and its name.
    Section((String, Box<SectionProperties>)),
    /// Stiffness and mass as written.
    Written(Box<[Matrix6<f64>; 2]>),
}

/// The content of a property file, and its name.
fn of_section(table: &Table<'_>, sources: &Sources) -> Option<(String, Box<SectionProperties>)> {
    let document = table.document();
    let written = table.require_text("file", "the name of a property file")?;
    let path = table.existing("file", &written)?;
    let text = document.keep(sources.read(&path))?;
    let section = document.keep(section::parse(&text, &path.display().to_string()))?;
    for (is_there, what) in [
        (section.piezo.is_some(), "piezoelectric coupling"),
        (section.thermal_force.is_some(), "thermal force"),
        (!section.imposed.is_empty(), "imposed strain"),
        (section.prestress.is_some(), "table of prestress"),
    ] {
        if is_there {
            let remark = format!("{written}: its {what} is not part of a blade");
            sources.remark(remark);
        }
    }
    Some((written, Box::new(section)))
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
pub(super) fn note_foreign(table: &Table<'_>, parts: Parts, given: &Given<'_>) -> bool {
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
