//! Remarks on operating points beyond the airfoils: sections beyond the speed of sound, and Reynolds numbers
//! beyond the tables, whose ends are then held. Remarks on turbines that do not work as such: tip speed ratios
//! that none has, and power that most points take.

use rotor_aero::airfoil::Section;
use rotor_aero::rotor::{Performance, RigidRotor};

use crate::analysis::operation::RATIOS;
use crate::analysis::steady::rpm;
use crate::case::{Abscissa, MachineKind};
use crate::input::short_number;

/// Part of the radius at which the Reynolds number counts \[-\].
const PLACE: f64 = 0.75;
/// Ratio to the end of a table beyond which a Reynolds number is reported \[-\].
const BEYOND: f64 = 1.25;

/// Numbers that an operating point reaches.
#[derive(Debug, Clone)]
pub(super) struct Reached {
    /// Largest Mach number of a section \[-\].
    mach: f64,
    /// Speed of rotation \[rad/s\].
    omega: f64,
    /// Of a turbine the tip speed ratio, unless the table is over it \[-\], and whether it takes power.
    turbine: Option<(f64, bool)>,
    /// Airfoils beyond whose tables the Reynolds number is.
    beyond: Vec<Beyond>,
}

/// An airfoil with a Reynolds number beyond its table.
#[derive(Debug, Clone)]
struct Beyond {
    airfoil: String,
    range: [f64; 2],
    reynolds: f64,
}

impl Reached {
    /// Of a rotor at a point with its loads along the blades, of a table over a quantity.
    pub fn of(
        rotor: &RigidRotor<Section>,
        point: &Performance,
        (machine, abscissa): (MachineKind, Abscissa),
    ) -> Self {
        let all = point.sectors.iter().flat_map(|sector| &sector.stations);
        let mach = all.map(|station| station.mach).fold(0.0, f64::max);
        let place = PLACE * point.disk_radius;
        let off = |radius: f64| (radius - place).abs();
        let loads = point
            .sectors
            .first()
            .into_iter()
            .flat_map(|sector| &sector.stations);
        let load = loads.min_by(|a, b| off(a.radius).total_cmp(&off(b.radius)));
        let stations = rotor.stations.iter();
        let station = stations.min_by(|a, b| off(a.radius).total_cmp(&off(b.radius)));
        let beyond = load.zip(station).map_or_else(Vec::new, |(load, station)| {
            beyond(&station.section, load.reynolds)
        });
        let is_turbine = machine == MachineKind::Turbine && abscissa != Abscissa::TipSpeedRatio;
        Self {
            mach,
            omega: point.operating.omega,
            turbine: is_turbine.then(|| (point.turbine().tip_speed_ratio, point.power < 0.0)),
            beyond,
        }
    }
}

/// The airfoils of a section beyond whose tables a Reynolds number is; none where the air rests.
fn beyond(section: &Section, reynolds: f64) -> Vec<Beyond> {
    let airfoils = section.parts().map(|(_, airfoil)| airfoil);
    let found = airfoils.filter_map(|airfoil| {
        let range = airfoil.reynolds_range()?;
        let is_beyond = reynolds * BEYOND < range[0] || reynolds > BEYOND * range[1];
        (is_beyond && reynolds > 0.0).then(|| Beyond {
            airfoil: airfoil.name().to_owned(),
            range,
            reynolds,
        })
    });
    found.collect()
}

/// The remarks on all points.
pub(super) fn remarks(all: &[Reached]) -> Vec<String> {
    let found = [supersonic(all), implausible(all), taken(all)];
    let mut remarks: Vec<String> = found.into_iter().flatten().collect();
    let mut names: Vec<&str> = Vec::new();
    for found in all.iter().flat_map(|point| &point.beyond) {
        if !names.contains(&found.airfoil.as_str()) {
            names.push(&found.airfoil);
            remarks.push(held(all, found));
        }
    }
    remarks
}

fn supersonic(all: &[Reached]) -> Option<String> {
    let fast = || all.iter().filter(|point| point.mach > 1.0);
    let fastest = fast().max_by(|a, b| a.mach.total_cmp(&b.mach))?;
    Some(format!(
        "at {} of {} points sections move faster than sound, up to a Mach number of {} at {}, for which \
         no airfoil here is meant: are radii and speeds in the units of the file?",
        fast().count(),
        all.len(),
        short_number(fastest.mach, 3),
        rpm(fastest.omega)
    ))
}

/// Tip speed ratios that no turbine has.
fn implausible(all: &[Reached]) -> Option<String> {
    let ratios = all.iter().filter_map(|point| Some(point.turbine?.0));
    let is_none = |ratio: &f64| ratio.is_finite() && !(RATIOS[0]..=RATIOS[1]).contains(ratio);
    let mut found = ratios.filter(is_none);
    let first = found.next()?;
    Some(format!(
        "at {} of {} points the tip speed ratio is none of a turbine, first {}, expected {} to {}: check the unit \
         of the speed of rotation, which is rpm without a unit, the radius and the wind",
        1 + found.count(),
        all.len(),
        short_number(first, 3),
        RATIOS[0],
        RATIOS[1]
    ))
}

/// Turbines that take power at most points.
fn taken(all: &[Reached]) -> Option<String> {
    let turbines = all.iter().filter_map(|point| point.turbine);
    let count = turbines.clone().count();
    let taking = turbines.filter(|own| own.1).count();
    (2 * taking > count).then(|| {
        format!(
            "at {taking} of {count} points the turbine takes power from its shaft: check the signs of pitch and twist, \
             the speed of rotation and the wind"
        )
    })
}

/// The remark on the airfoil of `found`, with the Reynolds number farthest from its table.
fn held(all: &[Reached], found: &Beyond) -> String {
    let own = |point: &Reached| {
        let mut own = point.beyond.iter();
        let own = own.find(|own| own.airfoil == found.airfoil)?;
        Some(own.reynolds)
    };
    let numbers: Vec<f64> = all.iter().filter_map(own).collect();
    let [low, high] = found.range;
    let off = |reynolds: f64| (low / reynolds).max(reynolds / high);
    let farthest = numbers
        .iter()
        .copied()
        .fold(found.reynolds, |a, b| if off(b) > off(a) { b } else { a });
    format!(
        "at {} of {} points the Reynolds number at {PLACE} of the radius, {farthest:.2e}, is beyond the table of \
         \"{}\", {low:.2e} to {high:.2e}, whose ends are held",
        numbers.len(),
        all.len(),
        found.airfoil
    )
}
