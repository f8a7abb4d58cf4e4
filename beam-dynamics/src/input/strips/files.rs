//! Stations of a blade in the air from a file: `file` of `[blade.aerodynamics]`.
//!
//! Readers give a station the position (x, y, z) of its reference point, at p chords from the
//! leading edge, and the nose-up twist b. With the line L(s) of the beam, and s where the line has
//! the same x, the line is at
//!
//! ```text
//! axis = p + e . ((0, y, z) - L(s)) / c,   e = (0, cos b, sin b)
//! ```
//!
//! chords from the leading edge. The distance normal to the chord is reported if it is not small.

use nalgebra::Vector3;
use rotor_aero::airfoil::Section;
use rotor_aero::airfoil::files::blade::{
    AeroStation, BladeAero, BladeFormat, BladeOptions, SpanOrigin, StationAirfoil, read_blade,
};
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Count, NotNegative, Text, Texts};
use shared_geom::exchange;
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::line::BladeLine;
use super::stations::{Station, Stations};
use crate::input::aerodynamics::Airfoils;
use crate::input::short_number;

mod pool;
mod problem;

pub(in crate::input) use pool::Pool;
use problem::FileProblem;

keys! {
    /// A file of the aerodynamic blade, instead of `stations`; its format is recognized.
    pub(super) FILE: Option<String> = "file", [Text], optional, "\"AeroDyn15_blade.dat\"";
    /// Airfoils of the stations of `file`, in the order of their indices: names of `[airfoils]`,
    /// built-in ones, or files, in whose names `*` is any letters, or folders of files. They take the
    /// place of airfoils of `file` that have the same names, and so do the ones of `[airfoils]`.
    pub(super) AIRFOILS: Option<Vec<String>> = "airfoils", [Texts], optional,
        "[\"Cylinder\", \"polars/*.dat\"]";
    /// A file with all airfoils of the stations of `file`, such as a pc file of HAWC2.
    pub(super) AIRFOIL_FILE: Option<String> = "airfoil_file", [Text], optional, "\"pc.dat\"";
    /// Set of a HAWC2 ae file, from one.
    pub(super) SET: Option<usize> = "set", [Count(1000)], or "the first", "2";
    /// A blade file, in any known format, that has the twist of the chord: for files without
    /// twist, such as HAWC2 ae.
    pub(super) TWIST_FILE: Option<String> = "twist_file", [Text], optional, "\"blade.htc\"";
    /// Radius of the root, for files of stations by their radius.
    pub(super) ROOT_RADIUS: Option<f64> = "root_radius", [NotNegative(Dimension::LENGTH)],
        or "the radius of the hub of `file`", "1.5";
}

/// Part of the length by which a station of a file may lie beyond an end, and difference of thicknesses over
/// chord: digits of files.
const DIGITS: f64 = 1e-4;
/// Difference of two angles of the cone that is not reported \[rad\]: digits of files.
const SAME_CONE: f64 = 1e-3;
/// Distance from the line, normal to the chord and over it, that is not reported \[-\].
const NORMAL: f64 = 0.02;

/// Notes the keys that a table has without `file`.
pub(super) fn note_without_file(table: &Table<'_>) {
    let keys = [
        (AIRFOILS.name(), table.has(&AIRFOILS)),
        (AIRFOIL_FILE.name(), table.has(&AIRFOIL_FILE)),
        (SET.name(), table.has(&SET)),
        (TWIST_FILE.name(), table.has(&TWIST_FILE)),
        (ROOT_RADIUS.name(), table.has(&ROOT_RADIUS)),
    ];
    for (key, _) in keys.iter().filter(|key| key.1) {
        table.note(key, &FileProblem::WithoutFile { key });
    }
}

/// Notes that the table has `stations` too.
pub(super) fn note_stations(table: &Table<'_>) {
    table.note(&FILE, &FileProblem::FileAndStations);
}

/// The stations of the file of a table, for the blade that `user` describes.
pub(super) fn read(
    table: &Table<'_>,
    airfoils: &Airfoils,
    (user, line): (&str, &BladeLine<'_>),
    remarks: &mut Vec<String>,
) -> Option<Stations> {
    let (file, set) = (table.get(&FILE), table.get(&SET));
    let (root, twist) = (table.get(&ROOT_RADIUS), table.get(&TWIST_FILE));
    let (names, all) = (table.get(&AIRFOILS), table.get(&AIRFOIL_FILE));
    let (file, set) = (file??, set?);
    let blade = blade(table, &file, set);
    let mut pool = Pool::new(table, airfoils, user);
    let is_read = pool.add(names?, all?, remarks);
    let twist = twist?.map(|file| twist_of(table, &file));
    let (mut blade, root) = (blade?, root?);
    let has_twist = blade.format != BladeFormat::Hawc2Ae || twist.is_some();
    if !has_twist {
        let file = file.clone();
        table.note(&FILE, &FileProblem::NoTwist { file });
    }
    // The twist of the other file replaces the remark that there is none.
    let of_file = std::mem::take(&mut blade.remarks).into_iter();
    let of_file = of_file.filter(|remark| twist.is_none() || !remark.contains("twist"));
    remarks.extend(of_file.map(|remark| format!("{user}: {remark}")));
    remarks.extend(remark_on_cone(user, &file, [blade.cone, line.precone]));
    pool.add_own(std::mem::take(&mut blade.airfoils));
    let source = Source {
        table,
        file: &file,
        line,
        root,
        twist: match twist {
            Some(found) => Some(found?),
            None => None,
        },
    };
    let placed = source.place(&blade);
    let sections = pool.sections(&blade.stations, &file, remarks);
    let (placed, sections) = (placed?, sections?);
    remarks.extend(distance(&blade, &placed).map(|remark| format!("{user}: {remark}")));
    let stations = placed.into_iter().zip(sections);
    let stations: Vec<_> = stations
        .map(|(placed, section)| placed.station(section))
        .collect();
    let more = pool.between(&blade.stations, &stations, remarks)?;
    let stations = Stations::new(stations, more);
    let stations = stations.map_err(|problem| table.note(&FILE, &problem));
    stations.ok().filter(|_| is_read && has_twist)
}

/// A remark on the cone of the rotor of a file, if the blades have another precone, by these angles \[rad\].
/// Files have positive angles away from the tower, and blades along the axis of the hub.
fn remark_on_cone(user: &str, file: &str, [cone, precone]: [Option<f64>; 2]) -> Option<String> {
    let (cone, precone) = (cone?.abs(), precone?.abs());
    ((cone - precone).abs() > SAME_CONE).then(|| {
        let [cone, precone] = [cone, precone].map(|angle| short_number(angle.to_degrees(), 4));
        format!(
            "{user}: the rotor of \"{file}\" has a cone of {cone} deg, and the blade a \"precone\" of \
             {precone} deg, which counts"
        )
    })
}

/// Reads the file of the blade.
fn blade(table: &Table<'_>, file: &str, set: Option<usize>) -> Option<BladeAero> {
    let path = table.existing(&FILE, file)?;
    let options = BladeOptions {
        set,
        ..BladeOptions::default()
    };
    table.keep_file(FILE.name(), read_blade(&path, &options))
}

/// Twist over arc length of a blade file.
type Twist = Box<dyn Fn(f64) -> f64>;

fn twist_of(table: &Table<'_>, file: &str) -> Option<Twist> {
    let path = table.existing(&TWIST_FILE, file)?;
    let reading = table.keep_file(TWIST_FILE.name(), exchange::read(&path))?;
    let curve = reading.blade.line.curve();
    Some(Box::new(move |at| curve.at(at).twist))
}

/// A file and the line on which its stations are.
struct Source<'a> {
    table: &'a Table<'a>,
    file: &'a str,
    line: &'a BladeLine<'a>,
    /// Radius of the root, if given \[m\].
    root: Option<f64>,
    twist: Option<Twist>,
}

/// A station on the line of the beam.
struct Placed {
    /// Arc length \[m\].
    at: f64,
    /// Chord \[m\].
    chord: f64,
    /// Twist, nose up \[rad\].
    twist: f64,
    /// Distance of the line from the leading edge, in chords \[-\].
    axis: f64,
    /// Distance from the line, normal to the chord \[m\].
    normal: f64,
}

impl Placed {
    /// The station with its airfoil.
    fn station(self, airfoil: Section) -> Station {
        Station {
            at: self.at,
            chord: self.chord,
            twist: self.twist,
            axis: self.axis,
            airfoil,
        }
    }
}

impl Source<'_> {
    /// All stations on the line; notes those that are not.
    fn place(&self, blade: &BladeAero) -> Option<Vec<Placed>> {
        let origin = match (blade.origin, self.root.or(blade.hub_radius)) {
            (SpanOrigin::RotationAxis, Some(root)) => root,
            (SpanOrigin::RotationAxis, None) => {
                let file = self.file.to_owned();
                self.table.note(&FILE, &FileProblem::NoRoot { file });
                return None;
            }
            (SpanOrigin::Root | SpanOrigin::RootAlongCurve, _) => 0.0,
        };
        let is_curved = blade.origin == SpanOrigin::RootAlongCurve;
        let placed = blade.stations.iter().enumerate().map(|(index, station)| {
            let span = station.span - origin;
            match self.arc_length(span, is_curved) {
                Some(at) => Some(self.at(station, at, is_curved)),
                None => {
                    let problem = FileProblem::OffLine {
                        file: self.file.to_owned(),
                        index,
                        found: span,
                        length: self.reach(is_curved),
                        is_by_radius: blade.origin == SpanOrigin::RotationAxis,
                    };
                    self.table.note(&FILE, &problem);
                    None
                }
            }
        });
        let placed: Vec<_> = placed.collect();
        placed.into_iter().collect()
    }

    /// The largest span on the line \[m\].
    fn reach(&self, is_curved: bool) -> f64 {
        if is_curved {
            self.line.length
        } else {
            (self.line.position)(self.line.length).x
        }
    }

    /// The arc length of a span; `None` outside of the line.
    fn arc_length(&self, span: f64, is_curved: bool) -> Option<f64> {
        let length = self.line.length;
        let x = |at: f64| {
            if is_curved {
                at
            } else {
                (self.line.position)(at).x
            }
        };
        let slack = DIGITS * length;
        let (low, high) = (x(0.0), x(length));
        if !(span >= low - slack && span <= high + slack) {
            return None;
        }
        let span = span.max(low).min(high);
        // A straight line along x keeps the numbers of the file.
        if (0.0..=length).contains(&span) && (x(span) - span).abs() <= f64::EPSILON * length {
            return Some(span);
        }
        let (mut from, mut to) = (0.0, length);
        // Halves of the length down to round-off.
        for _ in 0..60 {
            let middle = 0.5 * (from + to);
            if x(middle) < span {
                from = middle
            } else {
                to = middle
            }
        }
        Some(to)
    }

    fn at(&self, station: &AeroStation, at: f64, is_curved: bool) -> Placed {
        let twist = match &self.twist {
            Some(twist) => twist(at),
            None => station.twist,
        };
        // A file by curved lengths has the line itself as reference.
        let offset = if is_curved {
            Vector3::zeros()
        } else {
            let line = (self.line.position)(at);
            Vector3::new(0.0, station.sweep - line.y, station.prebend - line.z)
        };
        let (sin, cos) = twist.sin_cos();
        Placed {
            at,
            chord: station.chord,
            twist,
            axis: station.reference_point + (cos * offset.y + sin * offset.z) / station.chord,
            normal: cos * offset.z - sin * offset.y,
        }
    }
}

/// A remark on the largest distance of the file's stations from the line, normal to the chord.
fn distance(blade: &BladeAero, placed: &[Placed]) -> Option<String> {
    let part = |placed: &Placed| (placed.normal / placed.chord).abs();
    let numbered = placed.iter().enumerate();
    let (index, most) = numbered.max_by(|a, b| part(a.1).total_cmp(&part(b.1)))?;
    (part(most) > NORMAL).then(|| {
        format!(
            "station {} of \"{}\" is {} m off the line of the blade, normal to the chord: its \
             forces act on the chord through the line",
            index + 1,
            blade.name,
            short_number(most.normal.abs(), 3)
        )
    })
}

/// Whether two stations have profiles by thickness of one set.
fn one_set(a: &AeroStation, b: &AeroStation) -> Option<usize> {
    match (&a.airfoil, &b.airfoil) {
        (StationAirfoil::ByThickness(set), StationAirfoil::ByThickness(other)) if set == other => {
            Some(*set)
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests;
