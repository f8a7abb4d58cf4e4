//! Files of airfoil tables, read and written.
//!
//! Every format is a file of this folder with the functions `recognize`, `read` and perhaps
//! `write`. Only the list of doors knows all formats.
//!
//! # Example
//!
//! ```
//! use rotor_aero::airfoil::files;
//!
//! let text = "alpha [deg],cl,cd,cm\n-10,-1.0,0.02,0\n10,1.0,0.02,0\n";
//! let reading = files::parse(text, "section.csv".as_ref(), &files::Options::default()).expect("a table");
//! assert_eq!(reading.airfoils[0].data.lift[0].values, [-1.0, 1.0]);
//! ```

use std::path::Path;

use shared_geom::error::Diagnostics;
use shared_geom::exchange::ExchangeProblem;

mod aerodyn12;
mod aerodyn15;
pub mod blade;
mod c81;
mod csv;
mod family;
mod grid;
mod hawc2_pc;
mod joint;
mod notes;
pub mod performance;
mod reading;
mod source;
mod tree;
mod windio;
mod xfoil;

pub use super::constants::UnsteadyConstants;
pub use family::merge;
pub use reading::{Columns, Format, Options, ReadAirfoil, Reading, Writing};

use super::{AirfoilData, RADIANS};
use notes::Notes;
use source::text_of;

/// Reader of a format.
type Read = fn(&str, &Options, &mut Notes) -> Option<Vec<ReadAirfoil>>;
/// Writer of a format.
type Write = fn(&[ReadAirfoil], &mut Notes) -> Option<Writing>;

/// A format: how it is recognized, read and written.
struct Door {
    format: Format,
    recognize: fn(&str) -> bool,
    read: Read,
    write: Option<Write>,
}

/// Lift coefficient that no section has within a few degrees of zero lift.
const LARGE_LIFT: f64 = 1.0;

/// All formats, in the order in which they are tried.
const DOORS: [Door; 7] = [
    Door {
        format: Format::WindIo,
        recognize: windio::recognize,
        read: windio::read,
        write: None,
    },
    Door {
        format: Format::AeroDyn15,
        recognize: aerodyn15::recognize,
        read: aerodyn15::read,
        write: Some(aerodyn15::write),
    },
    Door {
        format: Format::AeroDyn12,
        recognize: aerodyn12::recognize,
        read: aerodyn12::read,
        write: None,
    },
    Door {
        format: Format::Xfoil,
        recognize: xfoil::recognize,
        read: xfoil::read,
        write: None,
    },
    Door {
        format: Format::Csv,
        recognize: csv::recognize,
        read: csv::read,
        write: Some(csv::write),
    },
    Door {
        format: Format::Hawc2Pc,
        recognize: hawc2_pc::recognize,
        read: hawc2_pc::read,
        write: Some(hawc2_pc::write),
    },
    Door {
        format: Format::C81,
        recognize: c81::recognize,
        read: c81::read,
        write: Some(c81::write),
    },
];

/// Endings of file names that decide the format, in any state of the file.
const ENDINGS: [(&str, Format); 2] = [("c81", Format::C81), ("csv", Format::Csv)];

/// The format of a text in the file at `path`, if it is known.
pub fn recognize(text: &str, path: &Path) -> Option<Format> {
    let ending = path
        .extension()
        .unwrap_or_default()
        .to_string_lossy()
        .to_ascii_lowercase();
    let named = ENDINGS.iter().find(|(known, _)| *known == ending);
    let door = DOORS.iter().find(|door| (door.recognize)(text));
    named
        .map(|(_, format)| *format)
        .or(door.map(|door| door.format))
}

/// Reads the airfoils of the file at `path`.
///
/// # Errors
/// A file that cannot be read, an unknown format, and all errors of the content.
pub fn read(path: &Path) -> Result<Reading, Diagnostics> {
    read_with(path, &Options::default())
}

/// Reads the airfoils of the file at `path`, with settings beyond the file.
///
/// # Errors
/// As [`read`].
pub fn read_with(path: &Path, options: &Options) -> Result<Reading, Diagnostics> {
    parse(&text_of(path)?, path, options)
}

/// Reads the airfoils of a text in the file at `path`.
///
/// # Errors
/// An unknown format, and all errors of the content.
pub fn parse(text: &str, path: &Path, options: &Options) -> Result<Reading, Diagnostics> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut notes = Notes::new(path);
    let format = recognize(text, path);
    let door = DOORS.iter().find(|door| Some(door.format) == format);
    let Some(door) = door else {
        let titles: Vec<_> = DOORS.iter().map(|door| door.format.title()).collect();
        notes.unknown(text, &titles);
        return Err(notes.problems.into_diagnostics());
    };
    let mut airfoils = (door.read)(text, options, &mut notes);
    if let Some(airfoils) = &mut airfoils {
        complete(airfoils, text, path, &mut notes);
    }
    let (airfoils, remarks) = notes.finish(airfoils, &format!("the {}", door.format.title()))?;
    Ok(Reading {
        format: door.format,
        airfoils,
        remarks,
    })
}

/// A remark on angles that seem to be in radians: none is beyond a half turn of radians, and the lift is
/// the one of large angles.
fn in_radians(data: &AirfoilData) -> Option<String> {
    let angles = data.lift.iter().flat_map(|curve| &curve.alpha);
    let largest = angles.fold(0.0, |a: f64, angle| a.max(angle.abs()));
    let values = data.lift.iter().flat_map(|curve| &curve.values);
    let lift = values.fold(0.0, |a: f64, value| a.max(value.abs()));
    let is_small = largest > 0.0 && largest.to_degrees() <= RADIANS;
    (is_small && lift > LARGE_LIFT).then(|| {
        format!(
            "the angles of airfoil \"{}\" end at {:.2} deg, and its lift coefficient reaches {lift:.2}: \
             the angles seem to be in radians, but are read as degrees",
            data.name,
            largest.to_degrees()
        )
    })
}

/// Names airfoils without a name after their file, and notes airfoils without a coefficient.
fn complete(airfoils: &mut [ReadAirfoil], text: &str, path: &Path, notes: &mut Notes) {
    if text.contains('\u{fffd}') {
        notes.remark(0, "bytes that are no UTF-8 are replaced");
    }
    if airfoils.is_empty() {
        notes.missing(0, "an airfoil", "the file has no table");
    }
    for airfoil in airfoils {
        let data = &mut airfoil.data;
        if data.name.is_empty() {
            data.name = path
                .file_stem()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned();
        }
        let lists = [("lift", &data.lift), ("drag", &data.drag)];
        for (what, _) in lists.iter().filter(|(_, list)| list.is_empty()) {
            notes.missing(
                0,
                &format!("{what} of airfoil \"{}\"", data.name),
                "give angles and values",
            );
        }
        if data.moment.is_empty() {
            notes.remark(0, &format!("airfoil \"{}\" has no moment", data.name));
        }
        if let Some(remark) = in_radians(data) {
            notes.remark(0, &remark);
        }
        family::check(data, notes);
    }
}

/// The airfoils as the text of a file of another format, which is called `name` in messages.
///
/// # Errors
/// A format that is not written, and airfoils that it cannot carry.
pub fn write(airfoils: &[ReadAirfoil], format: Format, name: &str) -> Result<Writing, Diagnostics> {
    let mut notes = Notes::new(Path::new(name));
    let write = DOORS
        .iter()
        .find(|door| door.format == format)
        .and_then(|door| door.write);
    let Some(write) = write else {
        let title = format.title();
        notes
            .problems
            .push(0, &ExchangeProblem::NotWritten { title });
        return Err(notes.problems.into_diagnostics());
    };
    if airfoils.is_empty() {
        notes.missing(0, "an airfoil", "give at least one");
    }
    let writing = write(airfoils, &mut notes);
    Ok(notes.finish(writing, &format!("the {}", format.title()))?.0)
}

#[cfg(test)]
mod random_tests;
#[cfg(test)]
mod samples;
#[cfg(test)]
mod tests;
