//! Blades of rotors from the files of other programs.

use std::sync::Arc;

use rotor_aero::airfoil::Section;
use rotor_aero::airfoil::files::blade::{
    AeroStation, BladeAero, BladeOptions, SpanOrigin, read_blade,
};
use rotor_aero::rotor::Station;
use shared_geom::document::Table;
use shared_geom::document::schema::ValueKind::{Count, Positive, Quantities, Text, Texts};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::problem::PerformanceProblem;
use super::qprop;
use crate::case::MachineKind;
use crate::input::aerodynamics::Airfoils;
use crate::input::strips::Pool;

keys! {
    /// The file of a blade: AeroDyn 15, HAWC2 (ae), windIO, APC (PE0), UIUC or QPROP; its format
    /// is recognized.
    pub(super) FILE: Option<String> = "file", [Text], optional, "\"10x7SF-PERF.PE0\"";
    /// Airfoil of all stations of the file, in place of its own: a name of `[airfoils]`.
    pub(super) AIRFOIL: Option<String> = "airfoil", [Text], optional, "\"naca4412\"";
    /// Airfoils in the order in which a file of AeroDyn counts them: names of `[airfoils]`, built-in
    /// ones, or files, in whose names `*` is any letters, or folders of files. Files have the names of
    /// their airfoils, else their own without the ending; stations may use them by these names.
    pub(super) AIRFOILS: Option<Vec<String>> = "airfoils", [Texts], optional,
        "\"polars/*.dat\"";
    /// A file with all airfoils of the blade, such as profile coefficients of HAWC2.
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
pub(super) const KEYS: [&str; 5] = [
    AIRFOIL.name(),
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
    /// Cone, tips upwind positive, if known \[rad\].
    pub cone: Option<f64>,
    /// Tilt of the shaft, if known \[rad\].
    pub tilt: Option<f64>,
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
    let mut blade = table.document().keep(read_blade(&path, &options))?;
    remarks.extend(
        blade
            .remarks
            .iter()
            .map(|remark| format!("\"{file}\": {remark}")),
    );
    let sections = sections(table, &mut blade, (file, airfoils), remarks)?;
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
        cone: blade.cone,
        tilt: blade.tilt,
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
    blade: &mut BladeAero,
    (file, airfoils): (&str, &Airfoils),
    remarks: &mut Vec<String>,
) -> Option<Vec<Section>> {
    if let Some(name) = table.get(&AIRFOIL)? {
        let section = airfoils.find(&name, (table, AIRFOIL.name()), "[rotor]")?;
        return Some(vec![section; blade.stations.len()]);
    }
    let (names, all) = (table.get(&AIRFOILS)?, table.get(&AIRFOIL_FILE)?);
    let mut pool = Pool::new(table, airfoils, "[rotor]");
    let is_read = pool.add(names, all, remarks);
    if let Some(polar) = &blade.polar {
        match qprop::airfoil(&blade.name, polar) {
            Ok(airfoil) => pool.add_section(Section::single(Arc::new(airfoil))),
            Err(problems) => problems.iter().for_each(|it| table.note(FILE.name(), it)),
        }
    }
    pool.add_own(std::mem::take(&mut blade.airfoils));
    let sections = pool.sections(&blade.stations, file, remarks);
    sections.filter(|_| is_read)
}

/// The named airfoils with the ones of `airfoils` and `airfoil_file`, beside stations that are typed.
pub(super) fn beside_stations(
    table: &Table<'_>,
    named: &Airfoils,
    remarks: &mut Vec<String>,
) -> Option<Airfoils> {
    let (names, all) = (table.get(&AIRFOILS)?, table.get(&AIRFOIL_FILE)?);
    let mut pool = Pool::new(table, named, "[rotor]");
    let is_read = pool.add(names, all, remarks);
    let airfoils = pool.into_named(remarks);
    is_read.then_some(airfoils)
}
