//! Blade files of other tools, read and written.
//!
//! Every format is a file of this folder with the same three functions: `recognize`,
//! `read` and `write`; absent if the format cannot do it. Only the list of doors knows
//! all formats.
//!
//! # Example
//!
//! ```
//! use std::path::Path;
//!
//! use shared_geom::exchange::{self, Format};
//!
//! // a blade of BeamDyn, written for HAWC2
//! let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/reference/exchange");
//! let reading = exchange::read(&Path::new(folder).join("plain_BeamDyn.dat")).expect("a sound blade");
//! assert!(reading.blade.mass() > 0.0);
//! let written = exchange::write(&reading.blade, Format::Hawc2, "blade").expect("a blade to write");
//! assert!(written.files[0].1.contains("c2_def"));
//! ```

use std::path::{Path, PathBuf};

use crate::blade::{Blade, PlacedProblem};
use crate::document::read_text;
use crate::error::{Diagnostics, SourceLocation};
use crate::file_kind::FileKind;
use crate::line::LineProblem;

mod beamdyn;
mod csv;
mod dymore;
mod elastodyn;
pub mod frame;
mod hawc2;
mod header;
mod mbdyn;
mod named;
mod openfast;
mod own;
mod plain;
pub mod problem;
mod qblade;
mod stations;
pub mod text;
mod vabs;
mod windio;
pub mod yaml;

pub use crate::blade::Reading;
pub use frame::Convention;
pub use header::Header;
pub use problem::ExchangeProblem;
pub use windio::{WINDIO_PART, fields as windio_fields, length_remark, reference_line};

/// Number of problems of a blade that are reported one by one.
const PROBLEMS_SHOWN: usize = 4;

impl Reading {
    /// Refuses numbers that can neither be used nor described.
    fn check_numbers(&self, file: &Path) -> Result<(), Diagnostics> {
        self.report(&self.blade.shared_unusable(), file)
    }

    /// Checks the blade that was read from `file`.
    ///
    /// # Errors
    /// The problems of the blade (see [`Blade::problems`]), with the location of their
    /// station, and those that many stations share as one; of many, the first.
    pub fn check(&self, file: &Path) -> Result<(), Diagnostics> {
        self.report(&self.blade.shared_problems(), file)
    }

    /// Reports problems with the location of their station; of many, the first.
    fn report(&self, found: &[PlacedProblem], file: &Path) -> Result<(), Diagnostics> {
        let whole = || SourceLocation::file(file.display().to_string());
        let mut problems = Diagnostics::new();
        for (station, problem) in found.iter().take(PROBLEMS_SHOWN) {
            let location = station.and_then(|station| self.locations.get(station));
            problems.push(location.cloned().unwrap_or_else(whole), problem);
        }
        if found.len() > PROBLEMS_SHOWN {
            let more = ExchangeProblem::More(found.len() - PROBLEMS_SHOWN);
            problems.push(whole(), &more);
        }
        problems.into_result(())
    }
}

/// Files of a blade in another format, and the properties that they cannot carry.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Writing {
    /// Names of the files, relative to the folder of the first, and their texts.
    pub files: Vec<(PathBuf, String)>,
    /// Lost properties, as text, with their size.
    pub lost: Vec<String>,
}

/// Settings of a reader that the file does not contain.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Options {
    /// Length of a uniform blade, for files of sections without a line: straight, or with the curvature of its section file [m].
    pub length: Option<f64>,
    /// Whether stations without shear stiffness become rigid in shear, which is remarked: see
    /// [`Blade::make_shear_rigid`].
    pub rigid_shear: bool,
    /// Name of the body in a file with several, in place of the blade: a `main_body` of an htc file, or
    /// `tower` of a windIO file.
    pub body: Option<String>,
}

/// A file format of blades.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Format {
    /// Helicoid's blade files, JSON and TOML.
    Helicoid,
    /// BeamDyn of OpenFAST 5: primary file with key points, and blade file.
    BeamDyn,
    /// The same in the layout of OpenFAST 3 and 4.
    BeamDyn4,
    /// ElastoDyn of OpenFAST: blade file, or primary file.
    ElastoDyn,
    /// Main file of OpenFAST, which leads to one of the former.
    OpenFast,
    /// HAWC2 structural file.
    Hawc2,
    /// windIO, first version.
    WindIo1,
    /// windIO, second version.
    WindIo2,
    /// DYMORE table of sectional properties.
    Dymore,
    /// Output of VABS, one section per file.
    Vabs,
    /// MBDyn constitutive laws and bodies.
    MbDyn,
    /// QBlade: structural table and geometry, or a file that leads to them.
    QBlade,
    /// Helicoid's table.
    Csv,
}

impl Format {
    /// All formats.
    pub const ALL: [Self; 13] = [
        Self::Helicoid,
        Self::BeamDyn,
        Self::BeamDyn4,
        Self::ElastoDyn,
        Self::OpenFast,
        Self::Hawc2,
        Self::WindIo1,
        Self::WindIo2,
        Self::Dymore,
        Self::Vabs,
        Self::MbDyn,
        Self::QBlade,
        Self::Csv,
    ];

    /// The name that commands take.
    pub fn name(self) -> &'static str {
        match self {
            Self::Helicoid => "helicoid",
            Self::BeamDyn => "beamdyn",
            Self::BeamDyn4 => "beamdyn4",
            Self::ElastoDyn => "elastodyn",
            Self::OpenFast => "openfast",
            Self::Hawc2 => "hawc2",
            Self::WindIo1 => "windio1",
            Self::WindIo2 => "windio2",
            Self::Dymore => "dymore",
            Self::Vabs => "vabs",
            Self::MbDyn => "mbdyn",
            Self::QBlade => "qblade",
            Self::Csv => "csv",
        }
    }

    /// Its description, as text.
    pub fn title(self) -> &'static str {
        match self {
            Self::Helicoid => "Helicoid blade file",
            Self::BeamDyn => "BeamDyn (OpenFAST) blade",
            Self::BeamDyn4 => "BeamDyn blade for OpenFAST 3 and 4",
            Self::ElastoDyn => "ElastoDyn (OpenFAST) blade",
            Self::OpenFast => "OpenFAST main file",
            Self::Hawc2 => "HAWC2 structural file",
            Self::WindIo1 => "windIO blade, version 1",
            Self::WindIo2 => "windIO blade, version 2",
            Self::Dymore => "DYMORE table of sectional properties",
            Self::Vabs => "VABS section output",
            Self::MbDyn => "MBDyn constitutive laws and bodies",
            Self::QBlade => "QBlade blade",
            Self::Csv => "Helicoid blade table (CSV)",
        }
    }

    /// The format that commands call `name`.
    pub fn from_name(name: &str) -> Option<Self> {
        let lower = name.to_lowercase();
        Self::ALL.into_iter().find(|format| format.name() == lower)
    }

    /// The format that the ending of a file implies; `None` if it may be several.
    pub fn of_path(path: &Path) -> Option<Self> {
        let name = path.file_name()?.to_string_lossy().to_lowercase();
        let ending = |format: &Self| format.endings().iter().any(|end| name.ends_with(end));
        Self::ALL.into_iter().find(ending)
    }

    /// Endings of file names, lower case.
    pub fn endings(self) -> &'static [&'static str] {
        match self {
            Self::Helicoid => &[".json", ".toml"],
            Self::BeamDyn => &[".inp", "_beamdyn.dat"],
            Self::Hawc2 => &[".htc", ".st"],
            Self::WindIo1 | Self::BeamDyn4 | Self::ElastoDyn => &[],
            Self::OpenFast => &[".fst"],
            Self::QBlade => &[".str", ".bld", ".trb"],
            Self::WindIo2 => &[".yaml", ".yml"],
            Self::Dymore => &[".dym"],
            Self::Vabs => &[".k"],
            Self::MbDyn => &[".mbd", ".mbdyn"],
            Self::Csv => &[".csv"],
        }
    }

    /// The axes of its sections, and with them the order of its components.
    pub fn convention(self) -> Convention {
        match self {
            Self::Helicoid | Self::Csv => Convention::Helicoid,
            Self::BeamDyn
            | Self::BeamDyn4
            | Self::ElastoDyn
            | Self::OpenFast
            | Self::QBlade
            | Self::WindIo1
            | Self::WindIo2 => Convention::BeamDyn,
            Self::Hawc2 => Convention::Hawc2,
            Self::Dymore | Self::Vabs | Self::MbDyn => Convention::Vabs,
        }
    }

    /// The reference point of its matrices, as text.
    pub fn reference_point(self) -> &'static str {
        match self {
            Self::Helicoid | Self::Csv => "the reference line, or the point that the file states",
            Self::BeamDyn | Self::BeamDyn4 => "the reference line through the key points",
            Self::WindIo1 | Self::WindIo2 => "the reference axis",
            Self::ElastoDyn => "the straight axis of the blade; there are no offsets",
            Self::OpenFast => "as in the file of the blade: see the remarks",
            Self::QBlade => "the thread axis of the blade",
            Self::Hawc2 => {
                "the line c2_def for offsets and mass; the elastic center, in axes turned by \
                 the structural pitch, for fully populated stiffness"
            }
            Self::Dymore => "the curve of the beam",
            Self::Vabs => "the origin of the section, through which the reference line goes",
            Self::MbDyn => "the reference line of the beam elements",
        }
    }

    /// Whether files of the format can be read.
    pub fn is_read(self) -> bool {
        DOORS
            .iter()
            .any(|door| door.format == self && door.read.is_some())
    }

    /// Whether files of the format can be written.
    pub fn is_written(self) -> bool {
        DOORS
            .iter()
            .any(|door| door.format == self && door.write.is_some())
    }
}

type Recognize = fn(&str) -> bool;
type Read = fn(&str, &Path, &Options) -> Result<Reading, Diagnostics>;
type Write = fn(&Blade, &str) -> Writing;

/// Functions of a format.
struct Door {
    format: Format,
    recognize: Recognize,
    read: Option<Read>,
    write: Option<Write>,
}

/// The formats, in the order in which a text is tried.
const DOORS: &[Door] = &[
    Door {
        format: Format::Helicoid,
        recognize: own::recognize,
        read: Some(own::read),
        write: Some(own::write),
    },
    Door {
        format: Format::Csv,
        recognize: csv::recognize,
        read: Some(csv::read),
        write: Some(csv::write),
    },
    Door {
        format: Format::BeamDyn,
        recognize: beamdyn::recognize,
        read: Some(beamdyn::read),
        write: Some(beamdyn::write),
    },
    // The previous reader takes both layouts.
    Door {
        format: Format::BeamDyn4,
        recognize: |_| false,
        read: Some(beamdyn::read),
        write: Some(beamdyn::write_four),
    },
    Door {
        format: Format::ElastoDyn,
        recognize: elastodyn::recognize,
        read: Some(elastodyn::read),
        write: None,
    },
    Door {
        format: Format::OpenFast,
        recognize: openfast::recognize,
        read: Some(openfast::read),
        write: None,
    },
    Door {
        format: Format::Vabs,
        recognize: vabs::recognize,
        read: Some(vabs::read),
        write: Some(vabs::write),
    },
    Door {
        format: Format::Hawc2,
        recognize: hawc2::recognize,
        read: Some(hawc2::read),
        write: Some(hawc2::write),
    },
    Door {
        format: Format::WindIo1,
        recognize: windio::is_version_1,
        read: Some(windio::read),
        write: Some(windio::write_version_1),
    },
    Door {
        format: Format::WindIo2,
        recognize: windio::is_version_2,
        read: Some(windio::read),
        write: Some(windio::write_version_2),
    },
    Door {
        format: Format::MbDyn,
        recognize: mbdyn::recognize,
        read: None,
        write: Some(mbdyn::write),
    },
    Door {
        format: Format::QBlade,
        recognize: qblade::recognize,
        read: Some(qblade::read),
        write: None,
    },
    // The last: a table of numbers without any word.
    Door {
        format: Format::Dymore,
        recognize: dymore::recognize,
        read: Some(dymore::read),
        write: Some(dymore::write),
    },
];

/// The format of `text`, from its content.
pub fn recognize(text: &str) -> Option<Format> {
    let door = DOORS.iter().find(|door| (door.recognize)(text));
    door.map(|door| door.format)
}

/// Whether the file at `path` holds a single section; the length of the blade must then
/// be given.
pub fn is_section(path: &Path) -> bool {
    read_text(path).is_ok_and(|text| vabs::recognize(&text) || own::is_section(&text))
}

/// Reads a blade from a file of any format that is read, and checks it.
///
/// # Errors
/// A file that cannot be read, an unknown format, and all errors of the content and of
/// the blade (see [`Blade::problems`]).
pub fn read(path: &Path) -> Result<Reading, Diagnostics> {
    let (_, reading) = read_with(path, &Options::default())?;
    reading.check(path)?;
    Ok(reading)
}

/// Reads a blade with the settings that the file does not contain; returns the format
/// too. The blade is not checked beyond its file.
///
/// # Errors
/// A file that cannot be read, an unknown format, and all errors of the content.
pub fn read_with(path: &Path, options: &Options) -> Result<(Format, Reading), Diagnostics> {
    let text = read_text(path)?;
    FileKind::Blade.require(path, &text)?;
    let (format, reading) = parse(&text, path, options)?;
    let location = || SourceLocation::file(path.display().to_string());
    let has = |body: &&String| hawc2::has_bodies(&text) || windio::has_body(&text, body);
    if let Some(body) = options.body.as_ref().filter(|body| !has(body)) {
        let problem = ExchangeProblem::no_bodies(body);
        return Err(Diagnostics::one(location(), &problem));
    }
    // An invalid line cannot be described either.
    let found = reading.blade.length();
    if !found.is_finite() {
        return Err(Diagnostics::one(location(), &LineProblem::Length { found }));
    }
    Ok((format, reading))
}

/// Reads a blade from the text of the file at `path`; the files that it names are in the
/// same folder.
///
/// # Errors
/// As [`read_with`].
pub fn parse(text: &str, path: &Path, options: &Options) -> Result<(Format, Reading), Diagnostics> {
    let unknown = || {
        let problem = ExchangeProblem::unknown(text, readable());
        Diagnostics::one(SourceLocation::file(path.display().to_string()), &problem)
    };
    // Helicoid's files are recognized by their endings, in any state.
    let own = own::is_named(path).then_some(Format::Helicoid);
    let is_it = |door: &&Door| match own {
        Some(own) => door.format == own,
        None => (door.recognize)(text),
    };
    let door = DOORS.iter().find(is_it).ok_or_else(unknown)?;
    let read = door.read.ok_or_else(|| {
        let problem = ExchangeProblem::NotRead {
            title: door.format.title(),
        };
        Diagnostics::one(SourceLocation::file(path.display().to_string()), &problem)
    })?;
    let refused = |problems: Diagnostics| {
        let what = format!("the {}", door.format.title());
        problems.explained(&path.display().to_string(), &what)
    };
    let mut reading = read(text, path, options).map_err(refused)?;
    reading.check_numbers(path)?;
    // Readers of Helicoid's files know the units too, and have reported them.
    if door.format != Format::Helicoid {
        let remarks = reading.blade.remarks();
        reading.remarks.extend(remarks);
    }
    reading
        .remarks
        .extend(stations::unused_length(&reading.blade, options));
    // Readers of Helicoid's files check the blade: they have replaced it before.
    if options.rigid_shear && door.format != Format::Helicoid {
        reading.make_shear_rigid();
    }
    Ok((door.format, reading))
}

/// The files of `blade` in another format; `name` is the name of the first without its
/// ending.
///
/// # Errors
/// A format that is not written.
pub fn write(blade: &Blade, format: Format, name: &str) -> Result<Writing, ExchangeProblem> {
    let door = DOORS.iter().find(|door| door.format == format);
    let write = door.and_then(|door| door.write);
    let write = write.ok_or(ExchangeProblem::NotWritten {
        title: format.title(),
    })?;
    Ok(write(blade, name))
}

/// The text of the windIO file at `path`, `existing`, in which the reference axis, the
/// twist and the elastic properties are replaced by the ones of `blade`; all other lines stay as they are. The file of
/// the result has the name of `path`.
///
/// # Errors
/// A text that is no windIO file, or whose tables cannot be replaced line by line.
pub fn write_into(blade: &Blade, existing: &str, path: &Path) -> Result<Writing, Diagnostics> {
    windio::write_into(blade, existing, path)
}

/// Titles of the formats that are read.
fn readable() -> Vec<&'static str> {
    let read = DOORS.iter().filter(|door| door.read.is_some());
    read.map(|door| door.format.title()).collect()
}

#[cfg(test)]
mod fixture_tests;
#[cfg(test)]
mod refusal_tests;
#[cfg(test)]
mod samples;
#[cfg(test)]
mod tests;
