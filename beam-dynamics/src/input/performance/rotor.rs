//! The rotor: `[rotor]`.

use rotor_aero::airfoil::{RotorStallDelay, Section};
use rotor_aero::rotor::{Machine, RigidRotor, Station};
use shared_geom::document::schema::ValueKind::{
    Count, NotNegative, Positive, Quantity, Tables, Word,
};
use shared_geom::document::{ByHand, Table};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::blade_file::{self, FileBlade};
use super::momentum::Momentum;
use super::problem::PerformanceProblem;
use super::stations;
use crate::case::{MachineKind, linear_between};
use crate::input::aerodynamics::Airfoils;
use crate::input::aerodynamics::family::{self, FAMILY};
use crate::input::aerodynamics::rotor_delay::{self, BLADE_STALL_DELAY};
use crate::input::blades::remark_on_hub;
use crate::input::short_number;

keys! {
    /// The rotor.
    pub(super) CARD = "[rotor]";
    /// Kind of machine. Of a turbine, power is positive if the wind drives it, thrust is along
    /// the wind, and twist and pitch are positive towards feather; of the others, power is
    /// positive if the shaft drives it, thrust is against the wind, and twist and pitch are
    /// positive nose up.
    MACHINE: usize = "machine", [Word(&WORDS)], or "\"turbine\"" = 0, "\"propeller\"";
    /// Number of blades.
    BLADES: Option<usize> = "blades", [Count(100)], or "by `file`", "3";
    /// Distance from the shaft at which the blades begin, along their axis.
    HUB_RADIUS: Option<f64> = "hub_radius", [NotNegative(Dimension::LENGTH)],
        or "by `file`, or the first station", "1.5";
    /// Distance from the shaft at which the blades end, along their axis.
    TIP_RADIUS: Option<f64> = "tip_radius", [Positive(Dimension::LENGTH)],
        or "by `file`, or the last station", "63";
    /// Angle of the blades to the plane of rotation, tips upwind positive.
    PRECONE: Option<f64> = "precone", [Quantity(Dimension::ANGLE)], or "by `file`, or 0", "2.5";
    /// Angle of the shaft to the horizon, upwind end up positive.
    TILT: f64 = "tilt", [Quantity(Dimension::ANGLE)], or "0" = 0.0, "5";
    /// Angle of the shaft to the wind about the vertical axis.
    YAW: f64 = "yaw", [Quantity(Dimension::ANGLE)], or "0" = 0.0, "10";
    /// Height of the hub above the ground, for `shear`.
    HUB_HEIGHT: f64 = "hub_height", [NotNegative(Dimension::LENGTH)], or "0" = 0.0, "90";
    /// Exponent of the vertical shear of the wind.
    pub(super) SHEAR: f64 = "shear", [NotNegative(Dimension::NUMBER)], or "0" = 0.0, "0.2";
    /// Number of azimuths over which loads are averaged.
    SECTORS: Option<usize> = "sectors", [Count(360)],
        or "1 in axial flow, else 8", "36";
    /// Points at which the loads are computed and summed: panels, dense at both ends, between which and
    /// the stations the shape is linear; or the stations alone, with zero loads at hub and tip, as in
    /// programs for comparison.
    INTEGRATION: usize = "integration", [Word(&["panels", "stations"])], or "\"panels\"" = 0,
        "\"stations\"";
    /// Number of panels.
    PANELS: Option<usize> = "panels", [Count(2000)], or "60", "120";
    /// Stations from the hub to the tip. Panels beyond the first and the last one, up to `hub_radius` and
    /// `tip_radius`, have the shape of these stations.
    STATIONS: ByHand = "stations", [Tables(&stations::CARD)], optional, "";
    /// Mach numbers of operating points beyond the tables of an airfoil: an error, or the values
    /// of the last table.
    pub(super) OUTSIDE_MACH: usize = "outside_mach", [Word(&["refuse", "hold"])],
        or "\"refuse\"" = 0, "\"hold\"";
    with BLADE_STALL_DELAY.schema, FAMILY.schema, blade_file::FILE.schema, blade_file::AIRFOIL.schema, blade_file::AIRFOILS.schema,
        blade_file::AIRFOIL_FILE.schema, blade_file::SET.schema, blade_file::TWIST_RADII.schema,
        blade_file::TWIST.schema, blade_file::GEOMETRY_RADIUS.schema;
}

/// Words of the machines.
pub(super) const WORDS: [&str; 3] = ["turbine", "propeller", "helicopter"];

/// Azimuths of a rotor in oblique or sheared flow.
const SECTORS_OBLIQUE: usize = 8;

/// Panels of a blade: thrust and power of 60 are within .1 % of the ones of many.
const USUAL_PANELS: usize = 60;

/// Smallest angle of precone at which the blades are along the shaft rather than across it \[rad\].
const STEEPEST: f64 = 80.0_f64.to_radians();

/// Least number of azimuths by which the mean of a turn is a mean.
const LEAST_SECTORS: usize = 3;

/// Radius of the tip of a file over the one of its last station, from which it is remarked.
const LONGER: f64 = 1.02;

/// Part of a radius by which the digits of a file may differ.
const ROUNDING: f64 = 1e-9;

/// A rotor, and the settings of its card.
pub(super) struct Rotor {
    pub machine: MachineKind,
    pub rotor: RigidRotor<Section>,
    pub shear: f64,
    pub holds_mach: bool,
}

/// Reads a `[rotor]` with its blades.
pub(super) fn read(
    table: &Table<'_>,
    airfoils: &Airfoils,
    momentum: Option<Momentum>,
    remarks: &mut Vec<String>,
) -> Option<Rotor> {
    let machine = table.get(&MACHINE).map(kind);
    let (blades, sectors) = (table.get(&BLADES), table.get(&SECTORS));
    let ends = (table.get(&HUB_RADIUS), table.get(&TIP_RADIUS));
    let (precone, tilt, yaw) = (table.get(&PRECONE), table.get(&TILT), table.get(&YAW));
    let (hub_height, shear) = (table.get(&HUB_HEIGHT), table.get(&SHEAR));
    let outside = table.get(&OUTSIDE_MACH);
    let (panels, delay) = (panels(table), rotor_delay::read(table));
    let blade = blade(table, (machine.unwrap_or_default(), airfoils), remarks);
    table.finish();
    let (ends, blades) = ((ends.0?, ends.1?), blades?);
    let mut blade = blade?;
    let count = blades.or(blade.blades);
    if count.is_none() {
        let (key, example) = (BLADES.name(), "blades = 3");
        table.note("", &PerformanceProblem::Missing { key, example });
    }
    remarks.extend(blade.tilt.and_then(|tilt| remark_on_tilt(table, tilt)));
    let [hub_radius, tip_radius] = radii(table, ends, (&mut blade, remarks))?;
    let (machine, momentum) = (machine?, momentum?);
    let (tilt, yaw, shear) = (tilt?, yaw?, shear?);
    let precone = precone?.or(blade.cone).unwrap_or_default();
    let (hub_height, panels) = (hub_height?, (panels?, delay?));
    let flow = Flow {
        precone,
        is_axial: tilt == 0.0 && yaw == 0.0 && shear == 0.0,
        shear,
        hub_height,
        tip_radius,
    };
    let usual = if flow.is_axial { 1 } else { SECTORS_OBLIQUE };
    let sectors = sectors?.unwrap_or(usual);
    flow.check(table, sectors)?;
    let rotor = RigidRotor {
        machine: signs(machine),
        blades: count?,
        hub_radius,
        tip_radius,
        precone,
        tilt,
        yaw,
        hub_height,
        stations: blade.stations,
        options: momentum.options,
        annulus_radius: momentum.radius,
        skewed_wake: momentum.skewed_wake,
        sectors,
    };
    Some(Rotor {
        machine,
        shear,
        holds_mach: outside? == 1,
        rotor: with_panels(rotor, panels, table, remarks)?,
    })
}

/// A remark on a tilt of the shaft of a file, which is not used.
fn remark_on_tilt(table: &Table<'_>, tilt: f64) -> Option<String> {
    let is_unused = tilt != 0.0 && !table.has(&TILT);
    is_unused.then(|| {
        let shown = short_number(tilt.to_degrees(), 4);
        format!(
            "[rotor]: the shaft of the file of the blade has a tilt of {shown} deg, which is not used: give \
             \"tilt\" if it counts"
        )
    })
}

/// The rotor with a number of panels and with delayed stall, if it is to have them.
fn with_panels(
    rotor: RigidRotor<Section>,
    (panels, delay): (Option<usize>, Option<RotorStallDelay>),
    table: &Table<'_>,
    remarks: &mut Vec<String>,
) -> Option<RigidRotor<Section>> {
    if let Some(delay) = &delay {
        let sections = rotor.stations.iter().map(|station| &station.section);
        rotor_delay::check((table, delay), sections, "[rotor]", remarks)?;
        let first = rotor
            .stations
            .first()
            .map_or(rotor.hub_radius, |first| first.radius);
        let ends = [first, rotor.tip_radius];
        remarks.extend(rotor_delay::remark_on_end(Some(delay), "[rotor]", ends));
    }
    let found = match panels {
        Some(count) => rotor.with_panels(count),
        None => Ok(rotor),
    };
    let rotor = found.map_err(|problem| table.note("", &problem)).ok()?;
    Some(match delay {
        Some(delay) => rotor.with_stall_delay(&delay),
        None => rotor,
    })
}

/// The signs of a kind of machine.
fn signs(machine: MachineKind) -> Machine {
    match machine {
        MachineKind::Turbine => Machine::Turbine,
        MachineKind::Propeller | MachineKind::Helicopter => Machine::Propeller,
    }
}

/// The number of panels; `Some(None)` for loads at the stations alone.
fn panels(table: &Table<'_>) -> Option<Option<usize>> {
    let (integration, panels) = (table.get(&INTEGRATION), table.get(&PANELS));
    let (integration, panels) = (integration?, panels?);
    if integration == 1 && panels.is_some() {
        table.wrong(&PANELS, "no such key beside integration = \"stations\"");
        return None;
    }
    Some((integration == 0).then(|| panels.unwrap_or(USUAL_PANELS)))
}

/// Numbers of the flow that depend on each other.
struct Flow {
    precone: f64,
    is_axial: bool,
    shear: f64,
    hub_height: f64,
    tip_radius: f64,
}

impl Flow {
    /// Notes numbers that would have no effect, or that no rotor has.
    fn check(&self, table: &Table<'_>, sectors: usize) -> Option<()> {
        let is_low = self.shear != 0.0 && self.hub_height <= self.tip_radius;
        let wrong = [
            (
                self.precone.abs() >= STEEPEST,
                PRECONE.name(),
                "less than 80 degrees to either side of the plane of rotation",
            ),
            (
                is_low && self.hub_height == 0.0,
                SHEAR.name(),
                "\"hub_height\" beside it: the shear is about this height",
            ),
            (
                is_low && self.hub_height > 0.0,
                HUB_HEIGHT.name(),
                "more than the radius of the tip, since the wind has shear above the ground",
            ),
            (
                !self.is_axial && sectors < LEAST_SECTORS,
                SECTORS.name(),
                "at least 3 azimuths, since the flow has yaw, tilt or shear",
            ),
        ];
        let Some((_, key, expected)) = wrong.into_iter().find(|wrong| wrong.0) else {
            return Some(());
        };
        table.wrong(key, expected);
        None
    }
}

fn kind(index: usize) -> MachineKind {
    match index {
        0 => MachineKind::Turbine,
        1 => MachineKind::Propeller,
        _ => MachineKind::Helicopter,
    }
}

/// The blade of the stations or of the file.
fn blade(
    table: &Table<'_>,
    (machine, airfoils): (MachineKind, &Airfoils),
    remarks: &mut Vec<String>,
) -> Option<FileBlade> {
    let file = table.get(&blade_file::FILE)?;
    let found = match (table.has(&STATIONS), &file) {
        (true, None) => {
            if let Some(key) = blade_file::KEYS.iter().find(|key| table.has(key)) {
                table.wrong(key, "no such key: it is for the \"file\" of a blade");
                return None;
            }
            let airfoils = blade_file::beside_stations(table, airfoils, remarks)?;
            return Some(FileBlade {
                stations: stations::read(table, STATIONS.name(), &airfoils)?,
                twist: None,
                from_root: false,
                blades: None,
                hub_radius: None,
                tip_radius: None,
                cone: None,
                tilt: None,
            });
        }
        (false, Some(file)) => {
            if family::note_beside_file(table) {
                return None;
            }
            return blade_file::read(table, file, (machine, airfoils), remarks);
        }
        (true, Some(_)) => "both \"stations\" and \"file\"",
        (false, None) => "neither \"stations\" nor \"file\"",
    };
    table.note("", &PerformanceProblem::StationSource { found });
    None
}

/// Radii of hub and tip. Stations of a file that begin at the root move by the radius of the hub.
fn radii(
    table: &Table<'_>,
    (hub, tip): (Option<f64>, Option<f64>),
    (blade, remarks): (&mut FileBlade, &mut Vec<String>),
) -> Option<[f64; 2]> {
    if blade.from_root {
        let Some(hub) = hub.or(blade.hub_radius) else {
            let (key, example) = (HUB_RADIUS.name(), "hub_radius = 1.5");
            table.note("", &PerformanceProblem::Missing { key, example });
            return None;
        };
        let length = blade.stations.last().map_or(0.0, |last| last.radius);
        remarks.extend(remark_on_hub("[rotor]", hub, length));
        let move_out = |station: &mut Station<Section>| station.radius += hub;
        blade.stations.iter_mut().for_each(move_out);
    }
    if let Some(rows) = &blade.twist {
        for station in &mut blade.stations {
            station.twist = linear_between(rows, station.radius);
        }
    }
    let first = blade.stations.first()?.radius;
    let last = blade.stations.last()?.radius;
    // The hub of a file may be a larger radius, at which its shape begins.
    let of_file = |hub: f64| if blade.from_root { hub } else { hub.min(first) };
    let hub = hub.unwrap_or_else(|| blade.hub_radius.map_or(first, of_file));
    let slack = ROUNDING * last;
    let of_file = blade.tip_radius.filter(|_| tip.is_none());
    if let Some(found) = of_file.filter(|found| *found < last - slack || *found > LONGER * last) {
        let [found, last] = [found, last].map(|radius| short_number(radius, 6));
        remarks.push(format!(
            "[rotor]: the file has the radius {found} m for the tip, and its blade ends at {last} m along its \
             axis: the larger one is used, give \"tip_radius\" if it is another"
        ));
    }
    let tip = tip.unwrap_or_else(|| of_file.map_or(last, |found| found.max(last)));
    if hub > first + slack {
        let problem = PerformanceProblem::End {
            key: HUB_RADIUS.name(),
            found: hub,
            station: first,
            side: "less",
            which: "first",
        };
        table.note(&HUB_RADIUS, &problem);
    }
    if tip < last - slack {
        let problem = PerformanceProblem::End {
            key: TIP_RADIUS.name(),
            found: tip,
            station: last,
            side: "more",
            which: "last",
        };
        table.note(&TIP_RADIUS, &problem);
    }
    (hub <= first + slack && tip >= last - slack).then_some([hub, tip])
}
