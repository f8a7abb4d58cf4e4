//! Files of the aerodynamic geometry of blades and propellers.
//!
//! Every format is a file of this folder with the functions `recognize` and `read`. Only the
//! list of doors knows all formats.

use std::path::Path;

use shared_geom::error::Diagnostics;

use super::notes::Notes;
use super::source::text_of;

mod aerodyn;
mod apc;
mod csv;
mod hawc2_ae;
mod qprop;
mod station;
mod uiuc;
mod windio;

pub use station::{AeroStation, BladeAero, BladeFormat, QpropPolar, SpanOrigin, StationAirfoil};

/// Settings of a reader that the file does not contain.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct BladeOptions {
    /// Radius of the tip, for a geometry of UIUC \[m\].
    pub radius: Option<f64>,
    /// Set of a HAWC2 ae file, from one; the first if absent.
    pub set: Option<usize>,
    /// Whether the twist is from elsewhere: a file without it then has no remark.
    pub has_twist: bool,
}

/// Reader of a format.
type Read = fn(&str, &BladeOptions, &mut Notes) -> Option<BladeAero>;

/// A format: how it is recognized and read.
struct Door {
    format: BladeFormat,
    recognize: fn(&str) -> bool,
    read: Read,
}

/// All formats, in the order in which they are tried.
const DOORS: [Door; 7] = [
    Door {
        format: BladeFormat::WindIo,
        recognize: windio::recognize,
        read: windio::read,
    },
    Door {
        format: BladeFormat::AeroDyn15,
        recognize: aerodyn::recognize,
        read: aerodyn::read,
    },
    Door {
        format: BladeFormat::Apc,
        recognize: apc::recognize,
        read: apc::read,
    },
    Door {
        format: BladeFormat::Uiuc,
        recognize: uiuc::recognize,
        read: uiuc::read,
    },
    Door {
        format: BladeFormat::Qprop,
        recognize: qprop::recognize,
        read: qprop::read,
    },
    Door {
        format: BladeFormat::Csv,
        recognize: csv::recognize,
        read: csv::read,
    },
    Door {
        format: BladeFormat::Hawc2Ae,
        recognize: hawc2_ae::recognize,
        read: hawc2_ae::read,
    },
];

/// The format of a text, if it is known.
pub fn recognize_blade(text: &str) -> Option<BladeFormat> {
    let door = DOORS.iter().find(|door| (door.recognize)(text));
    door.map(|door| door.format)
}

/// Reads the aerodynamic blade of the file at `path`.
///
/// # Errors
/// A file that cannot be read, an unknown format, and all errors of the content.
pub fn read_blade(path: &Path, options: &BladeOptions) -> Result<BladeAero, Diagnostics> {
    parse_blade(&text_of(path)?, path, options)
}

/// Reads the aerodynamic blade of a text in the file at `path`.
///
/// # Errors
/// An unknown format, and all errors of the content.
pub fn parse_blade(
    text: &str,
    path: &Path,
    options: &BladeOptions,
) -> Result<BladeAero, Diagnostics> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut notes = Notes::new(path);
    let door = DOORS.iter().find(|door| (door.recognize)(text));
    let Some(door) = door else {
        let titles: Vec<_> = DOORS.iter().map(|door| door.format.title()).collect();
        notes.unknown(text, &titles);
        return Err(notes.problems.into_diagnostics());
    };
    if text.contains('\u{fffd}') {
        notes.remark(0, "bytes that are no UTF-8 are replaced");
    }
    let blade = (door.read)(text, options, &mut notes);
    if let Some(blade) = &blade {
        check(&blade.stations, &mut notes);
    }
    let (mut blade, remarks) = notes.finish(blade, &format!("the {}", door.format.title()))?;
    if blade.name.is_empty() {
        blade.name = path
            .file_stem()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
    }
    blade.remarks = remarks;
    Ok(blade)
}

/// Notes too few stations, stations out of order, and chords that are not positive.
fn check(stations: &[AeroStation], notes: &mut Notes) {
    if stations.len() < 2 {
        let found = format!("{} stations", stations.len());
        notes.wrong(
            0,
            [
                "the blade",
                &found,
                "at least two",
                "the file may have been cut off",
            ],
        );
    }
    for (i, two) in stations.windows(2).enumerate() {
        if two[1].span <= two[0].span {
            let found = format!("{} m after {} m", two[1].span, two[0].span);
            let what = format!("span of station {}", i + 2);
            notes.wrong(
                0,
                [
                    &what,
                    &found,
                    "increasing values",
                    "put the stations in order from the root to the tip",
                ],
            );
        }
    }
    for (i, station) in stations.iter().enumerate() {
        if station.chord <= 0.0 {
            let what = format!("chord of station {}", i + 1);
            notes.wrong(
                0,
                [
                    &what,
                    &format!("{} m", station.chord),
                    "a positive chord",
                    "correct the row",
                ],
            );
        }
        if station.thickness.is_some_and(|thickness| thickness < 0.0) {
            let what = format!("thickness of station {}", i + 1);
            notes.wrong(
                0,
                [
                    &what,
                    &format!("{:?}", station.thickness),
                    "0 or more",
                    "correct the row",
                ],
            );
        }
    }
}

#[cfg(test)]
mod tests;
