//! The stations of a table in a file: `[stations]`.

use nalgebra::{Matrix6, Vector2};

use super::columns::{Columns, Measure};
use super::engineering::{self, ANGLES, CENTERS, MASS, Numbers, Parts, STIFFNESS};
use super::keys::ROOT_AT;
use super::matrix::{self, Kind};
use super::station_axes::{Settings, StationAxes, either, moved, note_foreign};
use super::{Placed, Sources};
use crate::blade::Station;
use crate::document::Table;
use crate::error::SourceLocation;
use crate::section::Engineering;
use crate::units::Dimension;

/// Keys of columns, besides the keys of matrices and engineering properties.
const SEAT_KEYS: [&str; 6] = [
    "arc_length",
    "eta",
    "angle",
    "reference_point_x",
    "reference_point_y",
    "reference_point_z",
];

/// All keys to which a column may be assigned.
fn keys() -> Vec<String> {
    let entries = [Kind::Stiffness, Kind::Mass]
        .into_iter()
        .flat_map(|kind| matrix::upper().map(move |(i, j)| kind.entry(i, j)));
    let centers = CENTERS.iter().flat_map(|center| center.1);
    let engineering = STIFFNESS.iter().chain(&MASS).map(|key| key.0);
    let words = SEAT_KEYS.into_iter().chain(engineering).chain(centers);
    words
        .chain(ANGLES)
        .map(str::to_owned)
        .chain(entries)
        .collect()
}

/// The stations of `[stations]`.
pub(super) fn read(
    table: &Table<'_>,
    settings: &Settings<'_>,
    sources: &Sources,
) -> Option<Vec<Placed>> {
    let root_at = table.get(&ROOT_AT);
    let columns = Columns::read(table, &keys(), sources);
    let stations = columns.as_ref().and_then(|columns| {
        let file = StationFile {
            table,
            columns,
            settings,
        };
        file.stations(root_at?)
    });
    if let Some(columns) = columns {
        columns.finish(sources);
    }
    stations
}

/// A table of stations and the settings for all of them.
struct StationFile<'a> {
    table: &'a Table<'a>,
    columns: &'a Columns<'a>,
    settings: &'a Settings<'a>,
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
        let is_ours = note_foreign(self.table, parts, self.settings);
        let engineering = self.engineering(parts);
        let of = |kind: Kind, requested: bool| {
            if requested {
                Some(Vec::new())
            } else {
                self.matrices(kind)
            }
        };
        let stiffness = of(Kind::Stiffness, parts.stiffness);
        let mass = of(Kind::Mass, parts.mass);
        let (arc_lengths, points, angles) = (arc_lengths?, points?, angles?);
        let (engineering, stiffness, mass) = (engineering?, stiffness?, mass?);
        if !is_ours {
            return None;
        }
        let locations = self.columns.locations().into_iter().enumerate();
        let station = |(row, location): (usize, SourceLocation)| {
            let axes = StationAxes {
                arc_length: arc_lengths[row],
                point: points[row],
                angle: self.settings.frame?.twist(angles[row]),
            };
            let own = engineering.get(row)?;
            let stiffness = stiffness.get(row).copied();
            let mass = mass.get(row).copied();
            let stiffness = stiffness.unwrap_or_else(|| own.stiffness_matrix());
            let mass = mass.unwrap_or_else(|| own.mass_matrix());
            Some(Placed {
                location,
                station: Station {
                    arc_length: axes.arc_length,
                    stiffness: moved(&stiffness, &axes, self.settings)?,
                    mass: moved(&mass, &axes, self.settings)?,
                },
                damping: None,
                curved: None,
            })
        };
        locations.map(station).collect()
    }

    fn numbers(&self, key: &str, dimension: Dimension) -> Option<Vec<f64>> {
        let factor = self.table.document().factor(dimension);
        self.columns.numbers(key, Measure { dimension, factor })
    }

    /// As [`StationFile::numbers`]; zeros without the column.
    fn optional(&self, key: &str, dimension: Dimension) -> Option<Vec<f64>> {
        if self.columns.has(key) {
            self.numbers(key, dimension)
        } else {
            Some(vec![0.0; self.columns.locations().len()])
        }
    }

    fn arc_lengths(&self, root_at: f64) -> Option<Vec<f64>> {
        let has = |key: &str| self.columns.has(key);
        let numbers = if either(self.table, has, "arc_length", "eta")? {
            self.numbers("arc_length", Dimension::LENGTH)?
        } else {
            let parts = self.numbers("eta", Dimension::NUMBER)?;
            let length = self.settings.length?;
            parts.into_iter().map(|eta| eta * length).collect()
        };
        Some(numbers.into_iter().map(|s| s - root_at).collect())
    }

    /// The reference point of each station.
    fn points(&self) -> Option<Vec<Vector2<f64>>> {
        let frame = self.settings.frame?;
        let keys = frame
            .plane_names()
            .map(|name| format!("reference_point_{name}"));
        if keys.iter().all(|key| !self.columns.has(key)) {
            let all = self.settings.reference_point?;
            return Some(vec![all; self.columns.locations().len()]);
        }
        let [first, second] = keys.map(|key| self.optional(&key, Dimension::LENGTH));
        let pairs = first?.into_iter().zip(second?);
        Some(pairs.map(|(a, b)| frame.point([a, b])).collect())
    }

    fn angles(&self) -> Option<Vec<f64>> {
        self.optional("angle", Dimension::ANGLE)
    }

    fn matrices(&self, kind: Kind) -> Option<Vec<Matrix6<f64>>> {
        let (frame, document) = (self.settings.frame?, self.table.document());
        let mut written = vec![Matrix6::zeros(); self.columns.locations().len()];
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
        // Columns are read once each, so that each problem is reported once.
        let mut known = Vec::new();
        let requested = [(&STIFFNESS[..], parts.stiffness), (&MASS[..], parts.mass)];
        for (keys, _) in requested.into_iter().filter(|part| part.1) {
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
        (0..self.columns.locations().len()).map(of_row).collect()
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
