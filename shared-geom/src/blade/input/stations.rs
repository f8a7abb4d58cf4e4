//! The stations: tables `[[station]]`, or `[stations]` with a table of a file.

use nalgebra::{Matrix6, Vector2};

use super::engineering::{self, Numbers, Parts};
use super::frame::{self, Frame};
use super::keys::{ANGLE, ARC_LENGTH, ETA, SECTION_FILE, STATION, STATION_POINT, STATIONS};
use super::matrix::{self, Kind};
use super::problem::InputProblem;
use super::station_axes::{Settings, StationAxes, either, moved, note_foreign};
use super::{Placed, Sources, station_file};
use crate::blade::{CurvedStation, Station};
use crate::document::Table;
use crate::error::SourceLocation;
use crate::section::{self, Damping, SectionProperties};
use crate::units::Dimension;

/// Reads all stations.
pub(super) fn read(
    root: &Table<'_>,
    settings: &Settings<'_>,
    sources: &Sources,
) -> Option<Vec<Placed>> {
    match (root.has(&STATIONS), root.has(&STATION)) {
        (true, false) => root
            .nested(&STATIONS, |table| {
                station_file::read(table, settings, sources)
            })
            .flatten(),
        (false, true) => root.each(&STATION, |table| in_place(table, settings, sources)),
        (true, true) => {
            let problem = InputProblem::Both {
                table: root.title().to_owned(),
                one: "[stations]".to_owned(),
                other: "[[station]]".to_owned(),
            };
            root.note(&STATION, &problem);
            None
        }
        (false, false) => {
            let problem = InputProblem::Neither {
                table: root.title().to_owned(),
                known: vec!["[stations] with a \"file\"", "tables [[station]]"],
            };
            root.note("", &problem);
            None
        }
    }
}

/// Whether there are tables `[[station]]`, and all of them name property files.
pub(super) fn are_files(root: &Table<'_>) -> bool {
    let is_file = |table: Table<'_>| table.has(&SECTION_FILE);
    !root.has(&STATIONS) && root.has(&STATION) && root.tables(&STATION).into_iter().all(is_file)
}

/// A `[[station]]`.
fn in_place(table: &Table<'_>, settings: &Settings<'_>, sources: &Sources) -> Option<Placed> {
    let arc_length = match either(table, |key| table.has(key), "arc_length", "eta") {
        Some(true) => table.given(&ARC_LENGTH).flatten(),
        Some(false) => {
            let eta = table.given(&ETA).flatten();
            eta.and_then(|eta| Some(eta * settings.length?))
        }
        None => None,
    };
    let point = if table.has(&STATION_POINT) {
        frame::point(table, STATION_POINT.name(), settings.frame)
    } else {
        settings.reference_point
    };
    let angle = table.get(&ANGLE);
    let matrices = if table.has(&SECTION_FILE) {
        of_section(table, sources).map(Matrices::Section)
    } else {
        in_table(table, settings).map(|(k, m)| Matrices::Written(Box::new([k, m])))
    };
    let matrices = matrices?;
    let axes = StationAxes {
        arc_length: arc_length?,
        point: point?,
        angle: settings.frame?.twist(angle?),
    };
    let curved = match &matrices {
        Matrices::Section((file, section)) => {
            CurvedStation::of(file, section, axes.point, axes.angle)
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
            Some(Damping::Viscous(moved(&(matrix * c), &axes, settings)?))
        }
        other => other,
    };
    Some(Placed {
        location: SourceLocation::line(table.document().file(), table.line()),
        station: Station {
            arc_length: axes.arc_length,
            stiffness: moved(&(stiffness * c), &axes, settings)?,
            mass: moved(&(mass / c), &axes, settings)?,
        },
        damping,
        curved,
    })
}

/// Source of the matrices of a station.
enum Matrices {
    /// A property file and its name.
    Section((String, Box<SectionProperties>)),
    /// Stiffness and mass as written.
    Written(Box<[Matrix6<f64>; 2]>),
}

/// The content of a property file, and its name.
fn of_section(table: &Table<'_>, sources: &Sources) -> Option<(String, Box<SectionProperties>)> {
    let document = table.document();
    let written = table.get(&SECTION_FILE)?;
    let path = table.existing(&SECTION_FILE, &written)?;
    let text = document.keep(sources.read(&path))?;
    let section = table.keep_file(
        SECTION_FILE.name(),
        section::parse(&text, &path.display().to_string()),
    )?;
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
fn in_table(table: &Table<'_>, settings: &Settings<'_>) -> Option<(Matrix6<f64>, Matrix6<f64>)> {
    let parts = Parts {
        stiffness: !table.has("stiffness"),
        mass: !table.has("mass"),
    };
    let is_ours = note_foreign(table, parts, settings);
    let engineering = engineering::read(&InTable(table), parts);
    let of = |kind: Kind, requested: bool| {
        if requested {
            Some(Matrix6::zeros())
        } else {
            matrix::read(table, kind, settings.frame)
        }
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

struct InTable<'a>(&'a Table<'a>);

impl Numbers for InTable<'_> {
    fn number(&self, key: &'static str, dimension: Dimension) -> Option<f64> {
        self.0.require_quantity(key, dimension)
    }

    fn point(&self, (key, _): (&'static str, [&'static str; 2])) -> Option<Vector2<f64>> {
        if self.0.has(key) {
            frame::point(self.0, key, Some(&Frame::ours()))
        } else {
            Some(Vector2::zeros())
        }
    }

    fn angle(&self, key: &'static str) -> Option<f64> {
        if self.0.has(key) {
            self.0.quantity(key, Dimension::ANGLE)
        } else {
            Some(0.0)
        }
    }
}
