//! Blades of rotors from the files of other programs.

use std::sync::Arc;

use rotor_aero::airfoil::files::blade::{
    AeroStation, BladeAero, BladeOptions, SpanOrigin, StationAirfoil, read_blade,
};
use rotor_aero::airfoil::files::{self, ReadAirfoil};
use rotor_aero::airfoil::{Airfoil, Blend, Interpolation, Section};
use rotor_aero::rotor::Station;
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Count, Positive, Quantities, Text, Texts};
use shared_geom::error::Explain;
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::problem::PerformanceProblem;
use super::qprop;
use crate::case::MachineKind;
use crate::input::aerodynamics::Airfoils;

keys! {
    /// The file of a blade: AeroDyn 15, HAWC2 (ae), windIO, APC (PE0), UIUC or QPROP; its format
    /// is recognized.
    pub(super) FILE: Option<String> = "file", [Text], optional, "\"10x7SF-PERF.PE0\"";
    /// Airfoil of all stations of the file, in place of its own: a name of `[airfoils]`.
    pub(super) AIRFOIL: Option<String> = "airfoil", [Text], optional, "\"naca4412\"";
    /// Names of `[airfoils]` in the order in which a file of AeroDyn counts them.
    pub(super) AIRFOILS: Option<Vec<String>> = "airfoils", [Texts], optional,
        "[\"cylinder\", \"DU40\"]";
    /// File with the airfoils of the blade: profile coefficients of HAWC2.
    pub(super) AIRFOIL_FILE: Option<String> = "airfoil_file", [Text], optional, "\"pc.dat\"";
    /// Set of a HAWC2 ae file.
    pub(super) SET: Option<usize> = "set", [Count(1000)], or "1", "2";
    /// Radii at which `twist` is given, for files without twist.
    pub(super) TWIST_RADII: Option<Vec<f64>> = "twist_radii", [Quantities(Dimension::LENGTH)],
        optional, "[3, 20, 120]";
    /// Twist at `twist_radii`, linear between them, in place of the twist of the file.
    pub(super) TWIST: Option<Vec<f64>> = "twist", [Quantities(Dimension::ANGLE)], optional,
        "[15, 6, -2]";
    /// Radius of the tip of a UIUC geometry, if the name of the file does not have it.
    pub(super) GEOMETRY_RADIUS: Option<f64> = "geometry_radius", [Positive(Dimension::LENGTH)],
        optional, "0.127";
}

/// The keys that only files use.
pub(super) const KEYS: [&str; 7] = [
    AIRFOIL.name(),
    AIRFOILS.name(),
    AIRFOIL_FILE.name(),
    SET.name(),
    TWIST_RADII.name(),
    TWIST.name(),
    GEOMETRY_RADIUS.name(),
];

/// A blade of a file.
pub(super) struct FileBlade {
    /// Stations with the signs of the machine; their radius begins at the root if the file's does.
    pub stations: Vec<Station<Section>>,
    /// Twist by the distance from the shaft, in place of the one of the stations \[m\], \[rad\].
    pub twist: Option<Vec<[f64; 2]>>,
    /// Whether radii begin at the root.
    pub from_root: bool,
    /// Number of blades, if known.
    pub blades: Option<usize>,
    /// Radius of the hub, if known \[m\].
    pub hub_radius: Option<f64>,
    /// Radius of the tip, if known \[m\].
    pub tip_radius: Option<f64>,
}

/// Reads the file that a card names.
pub(super) fn read(
    table: &Table<'_>,
    file: &str,
    (machine, airfoils): (MachineKind, &Airfoils),
    remarks: &mut Vec<String>,
) -> Option<FileBlade> {
    let (radius, set, twist) = (table.get(&GEOMETRY_RADIUS), table.get(&SET), twist(table)?);
    let options = BladeOptions {
        radius: radius?,
        set: set?,
        has_twist: twist.is_some(),
    };
    let path = table.existing(FILE.name(), file)?;
    let blade = table.document().keep(read_blade(&path, &options))?;
    remarks.extend(
        blade
            .remarks
            .iter()
            .map(|remark| format!("\"{file}\": {remark}")),
    );
    let sections = sections(table, &blade, (file, airfoils))?;
    let from_root = blade.origin != SpanOrigin::RotationAxis;
    let stations = blade.stations.iter().zip(sections);
    let stations = stations.map(|(station, section)| {
        let (own, prebend) = signs(station, machine);
        Station {
            radius: station.span,
            chord: station.chord,
            twist: own,
            prebend,
            section,
        }
    });
    Some(FileBlade {
        stations: stations.collect(),
        twist,
        from_root,
        blades: blade.blades,
        hub_radius: blade.hub_radius,
        tip_radius: blade.tip_radius,
    })
}

/// Twist and prebend with the signs of the machine: a file has both toward the suction side, which
/// is downwind at a turbine and upwind at a propeller.
fn signs(station: &AeroStation, machine: MachineKind) -> (f64, f64) {
    match machine {
        MachineKind::Turbine => (-station.twist, station.prebend),
        _ => (station.twist, -station.prebend),
    }
}

/// Rows of `twist_radii` and `twist`: `Some(None)` if absent.
fn twist(table: &Table<'_>) -> Option<Option<Vec<[f64; 2]>>> {
    let (radii, twist) = (table.get(&TWIST_RADII)?, table.get(&TWIST)?);
    let (radii, twist) = match (radii, twist) {
        (None, None) => return Some(None),
        (Some(radii), Some(twist)) if radii.len() == twist.len() => (radii, twist),
        (radii, twist) => {
            let length = |list: Option<Vec<f64>>| list.map_or(0, |list| list.len());
            let problem = PerformanceProblem::Lengths {
                key: TWIST.name(),
                found: length(twist),
                expected: length(radii),
                longest: TWIST_RADII.name(),
            };
            table.note(TWIST.name(), &problem);
            return None;
        }
    };
    let sound = super::values::increasing(table, TWIST_RADII.name(), &radii);
    sound.then(|| {
        Some(
            radii
                .into_iter()
                .zip(twist)
                .map(|row| [row.0, row.1])
                .collect(),
        )
    })
}

/// The airfoils of the stations of a file.
fn sections(
    table: &Table<'_>,
    blade: &BladeAero,
    (file, airfoils): (&str, &Airfoils),
) -> Option<Vec<Section>> {
    if let Some(name) = table.get(&AIRFOIL)? {
        let section = airfoils.find(&name, (table, AIRFOIL.name()), "[rotor]")?;
        return Some(vec![section; blade.stations.len()]);
    }
    let mut source = Source {
        table,
        file,
        airfoils,
        own: checked(table, FILE.name(), &blade.airfoils)?,
        listed: listed(table, airfoils)?,
        by_thickness: by_thickness(table)?,
        polar: None,
        without: Vec::new(),
        help: "",
    };
    if let Some(polar) = &blade.polar {
        match qprop::airfoil(&blade.name, polar) {
            Ok(airfoil) => source.polar = Some(Section::single(Arc::new(airfoil))),
            Err(problems) => problems.iter().for_each(|it| table.note(FILE.name(), it)),
        }
    }
    let stations = blade.stations.iter().enumerate();
    let found: Vec<_> = stations
        .map(|(index, station)| source.section(index + 1, station))
        .collect();
    source.report(blade.stations.len());
    found.into_iter().collect()
}

/// An airfoil with the set of its file.
type OfSet = (Option<usize>, Arc<Airfoil>);

/// Airfoils of a file, ready for evaluation; problems are noted under `key`.
fn checked(table: &Table<'_>, key: &str, read: &[ReadAirfoil]) -> Option<Vec<OfSet>> {
    let airfoil = |read: &ReadAirfoil| match Airfoil::new(&read.data, Interpolation::Monotone) {
        Ok(airfoil) => Some((read.set, Arc::new(airfoil))),
        Err(problems) => {
            problems.iter().for_each(|problem| table.note(key, problem));
            None
        }
    };
    let airfoils: Vec<_> = read.iter().map(airfoil).collect();
    airfoils.into_iter().collect()
}

/// The airfoils that `airfoils` lists.
fn listed(table: &Table<'_>, airfoils: &Airfoils) -> Option<Vec<Section>> {
    let names = table.get(&AIRFOILS)?.unwrap_or_default();
    let find = |name: &String| airfoils.find(name, (table, AIRFOILS.name()), "[rotor]");
    let found: Vec<_> = names.iter().map(find).collect();
    found.into_iter().collect()
}

/// The airfoils of `airfoil_file`.
fn by_thickness(table: &Table<'_>) -> Option<Vec<OfSet>> {
    let Some(file) = table.get(&AIRFOIL_FILE)? else {
        return Some(Vec::new());
    };
    let path = table.existing(AIRFOIL_FILE.name(), &file)?;
    let reading = table.document().keep(files::read(&path))?;
    checked(table, AIRFOIL_FILE.name(), &reading.airfoils)
}

/// All airfoils that a station can name.
struct Source<'a> {
    table: &'a Table<'a>,
    file: &'a str,
    airfoils: &'a Airfoils,
    own: Vec<OfSet>,
    listed: Vec<Section>,
    by_thickness: Vec<OfSet>,
    polar: Option<Section>,
    /// Numbers of the stations without an airfoil.
    without: Vec<usize>,
    help: &'static str,
}

impl Source<'_> {
    fn section(&mut self, number: usize, station: &AeroStation) -> Option<Section> {
        let found = match &station.airfoil {
            StationAirfoil::Unknown => self.polar.clone(),
            StationAirfoil::Index(index) => self.listed.get(*index).cloned(),
            StationAirfoil::Blend(parts) => return self.blend(number, parts),
            StationAirfoil::ByThickness(set) if !self.by_thickness.is_empty() => {
                return self.of_thickness(number, *set, station.thickness.unwrap_or(1.0));
            }
            StationAirfoil::ByThickness(_) => None,
        };
        if found.is_none() {
            self.without.push(number);
            self.help = match &station.airfoil {
                StationAirfoil::Index(_) => {
                    "list the airfoils of AeroDyn in their order as airfoils = [\"NAME\", ...] of \
                     [rotor], each with a table [airfoils.NAME]"
                }
                StationAirfoil::ByThickness(_) => {
                    "name the profile coefficients as airfoil_file = \"pc.dat\" of [rotor]"
                }
                _ => "add airfoil = \"NAME\" to [rotor], and a table [airfoils.NAME]",
            };
        }
        found
    }

    /// The airfoils with weights: of the file itself, or of `[airfoils]`.
    fn blend(&self, number: usize, parts: &[(String, f64)]) -> Option<Section> {
        let user = format!("station {number} of \"{}\"", self.file);
        let airfoil = |(name, weight): &(String, f64)| {
            if let Some((_, own)) = self.own.iter().find(|own| own.1.name() == name) {
                return Some((*weight, Arc::clone(own)));
            }
            let section = self.airfoils.find(name, (self.table, FILE.name()), &user)?;
            let (_, only) = section.parts().next()?;
            Some((*weight, Arc::clone(only)))
        };
        let parts: Vec<_> = parts.iter().map(airfoil).collect();
        let parts = parts.into_iter().collect::<Option<Vec<_>>>()?;
        self.keep(number, Section::weighted(&parts))
    }

    fn of_thickness(&self, number: usize, set: usize, thickness: f64) -> Option<Section> {
        let of_set = self.by_thickness.iter();
        let of_set = of_set.filter(|(own, _)| own.unwrap_or(1) == set);
        let airfoils: Vec<_> = of_set.map(|(_, airfoil)| Arc::clone(airfoil)).collect();
        let blend = Blend::by_thickness(&airfoils);
        self.keep(number, blend.and_then(|blend| blend.section(thickness)))
    }

    /// The section, or its problem, noted.
    fn keep<P: Explain>(&self, number: usize, section: Result<Section, P>) -> Option<Section> {
        match section {
            Ok(section) => Some(section),
            Err(problem) => {
                let found = PerformanceProblem::Station {
                    number,
                    file: self.file.to_owned(),
                    reason: problem.to_string(),
                    help: problem.help(),
                };
                self.table.note(FILE.name(), &found);
                None
            }
        }
    }

    /// Notes the stations without an airfoil, of so many.
    fn report(&self, count: usize) {
        let stations = match &self.without[..] {
            [] => return,
            [only] => format!("station {only}"),
            all if all.len() == count => "all stations".to_owned(),
            [first, others @ ..] => format!("station {first} and {} more", others.len()),
        };
        let problem = PerformanceProblem::NoAirfoil {
            stations,
            file: self.file.to_owned(),
            help: self.help,
        };
        self.table.note(FILE.name(), &problem);
    }
}
