//! The blade file that people write: TOML, with tables in separate files.
//!
//! [`frame`](self::frame) reads the declared axes, [`line`](self::line) the reference
//! line, [`stations`](self::stations) the properties; the book describes their meaning on
//! the page of the blade file.

use std::cell::RefCell;
use std::path::Path;

use nalgebra::Vector2;

use super::{Blade, BladeDamping, CurvedStation, Interpolation, Reading, Station};
use crate::document::{Document, Table, read_text};
use crate::error::{Diagnostics, SourceLocation};
use crate::files::name_without;
use crate::hash::sha256_of;
use crate::line::ReferenceLine;
use crate::section::Provenance;
use crate::units::Dimension;

mod columns;
mod engineering;
mod frame;
mod keys;
mod line;
mod matrix;
mod problem;
mod station_axes;
mod station_file;
mod stations;
mod values;

pub use keys::{BLADE, LINE_TABLE};
pub use problem::InputProblem;

use frame::Frame;
use keys::{BLADE_FILE, DAMPING, INTERPOLATION, LINE, NAME, PROPORTIONAL, REFERENCE_POINT, TIMES};

/// Reads the table `[line]` of another input file, in Helicoid's axes; `None` after a problem,
/// which has been noted.
pub fn read_line(table: &Table<'_>) -> Option<ReferenceLine> {
    let line = line::read(table, Some(&Frame::ours()), &Sources::default())?;
    let problems = line.problems();
    for problem in &problems {
        table.note("", problem);
    }
    problems.is_empty().then_some(line)
}

/// The ending of the files that people write.
const ENDING: &str = ".blade.toml";

/// Files that were read with the file, and remarks.
#[derive(Debug, Default)]
struct Sources {
    texts: RefCell<Vec<String>>,
    remarks: RefCell<Vec<String>>,
}

impl Sources {
    /// The text of a file, which is then an input.
    fn read(&self, path: &Path) -> Result<String, Diagnostics> {
        let text = read_text(path)?;
        self.texts.borrow_mut().push(text.clone());
        Ok(text)
    }

    fn remark(&self, remark: String) {
        self.remarks.borrow_mut().push(remark);
    }
}

/// A station, its location in the file, and its own damping.
#[derive(Debug)]
struct Placed {
    location: SourceLocation,
    station: Station,
    damping: Option<crate::section::Damping>,
    /// Its section if that was solved for a curved beam.
    curved: Option<CurvedStation>,
}

/// Reads and checks the text of a blade file in TOML, shown as `file` in messages; the
/// files that it names lie in its folder. If `rigid_shear`, stations without shear stiffness
/// become rigid in shear, which is remarked.
///
/// # Errors
/// Every problem of the file, of the tables that it names, and of the blade.
pub(super) fn parse(text: &str, file: &str, rigid_shear: bool) -> Result<Reading, Diagnostics> {
    let document = Document::parse(text, file)?;
    let sources = Sources::default();
    sources.texts.borrow_mut().push(text.to_owned());
    let root = document.root_of(&BLADE_FILE);
    document.declare_units(&root);
    let read = blade(&root, &sources);
    root.finish();
    let checked = read.and_then(|(mut blade, locations, curved)| {
        if rigid_shear {
            sources.remark(blade.replace_absent_shear());
        }
        document.keep(check(&blade, &locations, file))?;
        document.keep(check_curved(&blade, &locations, &curved, &sources))?;
        Some((blade, locations))
    });
    let unit = document.factor(Dimension::LENGTH);
    let frame = checked.as_ref().and_then(|_| Frame::words(&root));
    let (mut blade, locations) = document.finish(checked)?;
    let texts = sources.texts.into_inner();
    let parts: Vec<_> = texts.iter().map(|text| text.as_bytes()).collect();
    blade.provenance.input_hash = sha256_of(&parts);
    let mut remarks = sources.remarks.into_inner();
    remarks.extend(blade.remarks_of_units(Some(unit)));
    Ok(Reading {
        locations,
        frame,
        ..Reading::new(blade, remarks)
    })
}

/// A blade, the locations of its stations in the file, and those stations of curved
/// beams.
type Written = (Blade, Vec<SourceLocation>, Vec<Option<CurvedStation>>);

/// Remark on the default reference point of property files.
const ON_LINE: &str = "reference_point is not declared: the origin of the property files is on \
                       the line";

/// The blade as written.
fn blade(root: &Table<'_>, sources: &Sources) -> Option<Written> {
    let file = root.document().file();
    let name = root.get(&NAME);
    let frame = Frame::read(root);
    let reference_point = if !root.has(&REFERENCE_POINT) && stations::are_files(root) {
        // Property files have the origin of their axes.
        sources.remark(ON_LINE.to_owned());
        Some(Vector2::zeros())
    } else {
        frame::reference_point(root, frame.as_ref())
    };
    let interpolation = root.get(&INTERPOLATION);
    let line = root.nested(&LINE, |table| line::read(table, frame.as_ref(), sources));
    let line = line.flatten();
    // The length of an invalid line may be no number.
    let length = line.as_ref().filter(|line| line.problems().is_empty());
    let length = length.map(|line| line.length());
    let settings = station_axes::Settings {
        frame: frame.as_ref(),
        reference_point,
        length,
    };
    let placed = stations::read(root, &settings, sources);
    let damping = root.nested(&DAMPING, |table| damping(table, frame.as_ref()));
    let (placed, line) = (placed?, line?);
    let damping = of_stations(root, damping?, &placed);
    let curved = placed.iter().map(|placed| placed.curved.clone()).collect();
    let (indices, stations) = placed.into_iter().map(|p| (p.location, p.station)).unzip();
    let blade = Blade {
        name: name?.unwrap_or_else(|| name_without(Path::new(file), ENDING)),
        line,
        reference_point: reference_point?,
        stations,
        interpolation: [Interpolation::Linear, Interpolation::Constant][interpolation?],
        damping: damping?,
        provenance: Provenance {
            program: "helicoid".to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            input_hash: String::new(),
            nodes: 0,
            cells: 0,
            history: Vec::new(),
            sections: Vec::new(),
        },
    };
    Some((blade, indices, curved))
}

/// The table `[damping]`.
fn damping(table: &Table<'_>, frame: Option<&Frame>) -> Option<BladeDamping> {
    match (table.has(&PROPORTIONAL), table.has(&TIMES)) {
        (true, false) => table.get(&PROPORTIONAL).map(BladeDamping::Proportional),
        (false, true) => times(table, frame),
        (true, true) => {
            let problem = InputProblem::Both {
                table: "[damping]".to_owned(),
                one: PROPORTIONAL.name().to_owned(),
                other: TIMES.name().to_owned(),
            };
            table.note(&TIMES, &problem);
            None
        }
        (false, false) => {
            let problem = InputProblem::Neither {
                table: "[damping]".to_owned(),
                known: vec!["\"proportional\"", "\"times\""],
            };
            table.note("", &problem);
            None
        }
    }
}

/// Six times in the order of the frame.
fn times(table: &Table<'_>, frame: Option<&Frame>) -> Option<BladeDamping> {
    let times = table.get(&TIMES)?;
    let found = times.len();
    match <[f64; 6]>::try_from(times) {
        Ok(times) => Some(BladeDamping::Times(frame?.values(times))),
        Err(_) => {
            let expected = "six times, one for each component";
            let problem = InputProblem::Count {
                key: TIMES.name().to_owned(),
                found,
                expected,
            };
            table.note(&TIMES, &problem);
            None
        }
    }
}

/// The damping of the blade, from `[damping]` or from its property files.
fn of_stations(
    root: &Table<'_>,
    damping: Option<BladeDamping>,
    placed: &[Placed],
) -> Option<Option<BladeDamping>> {
    use crate::section::Damping;
    let Some(own) = placed.iter().find(|placed| placed.damping.is_some()) else {
        return Some(damping);
    };
    if damping.is_some() {
        let file = own.location.file.clone();
        root.note(&DAMPING, &InputProblem::TwoDampings { file });
        return None;
    }
    let first = placed.first().and_then(|placed| placed.damping);
    let is_same = placed.iter().all(|placed| placed.damping == first);
    if let (true, Some(Damping::StiffnessProportional(time))) = (is_same, first) {
        return Some(Some(BladeDamping::Proportional(time)));
    }
    let matrix = |placed: &Placed| match placed.damping {
        Some(Damping::StiffnessProportional(time)) => placed.station.stiffness * time,
        Some(Damping::Viscous(matrix)) => matrix,
        None => nalgebra::Matrix6::zeros(),
    };
    let matrices = placed.iter().map(matrix).collect();
    Some(Some(BladeDamping::Viscous(matrices)))
}

/// The problems of the blade, with the location of their station.
fn check(blade: &Blade, locations: &[SourceLocation], file: &str) -> Result<(), Diagnostics> {
    let mut problems = Diagnostics::new();
    for (station, problem) in blade.shared_problems() {
        let location = station.and_then(|station| locations.get(station)).cloned();
        problems.push(
            location.unwrap_or_else(|| SourceLocation::file(file)),
            &problem,
        );
    }
    problems.into_result(())
}

/// Sections of curved beams on a line of another curvature, with their location.
fn check_curved(
    blade: &Blade,
    locations: &[SourceLocation],
    curved: &[Option<CurvedStation>],
    sources: &Sources,
) -> Result<(), Diagnostics> {
    let (found, remarks) = blade.compare_curved(curved);
    let mut problems = Diagnostics::new();
    for (station, problem) in found {
        problems.push(locations[station].clone(), &problem);
    }
    for remark in remarks {
        sources.remark(remark);
    }
    problems.into_result(())
}

#[cfg(test)]
mod bad_tests;
#[cfg(test)]
mod schema_tests;
#[cfg(test)]
mod tests;
