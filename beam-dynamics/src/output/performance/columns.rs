//! The quantities of operating points, by the fields of the machines.

use std::f64::consts::PI;

use crate::case::MachineKind;
use crate::result::PerformancePoint;

/// A quantity of an operating point.
#[derive(Debug, Clone, Copy)]
pub(super) struct Column {
    /// Name.
    pub name: &'static str,
    /// Unit of the value.
    pub unit: &'static str,
    /// The value.
    pub value: fn(&PerformancePoint) -> f64,
}

impl Column {
    /// Name and unit.
    pub fn title(&self) -> String {
        format!("{} [{}]", self.name, self.unit)
    }
}

/// A column by its name, unit and value.
const fn column(
    name: &'static str,
    unit: &'static str,
    value: fn(&PerformancePoint) -> f64,
) -> Column {
    Column { name, unit, value }
}

pub(super) const SPEED: Column = column("speed", "m/s", |at| at.setting().speed);
pub(super) const ROTOR_SPEED: Column =
    column("rotor speed", "rpm", |at| at.setting().omega * 30.0 / PI);
pub(super) const PITCH: Column = column("pitch", "deg", |at| at.setting().pitch.to_degrees());
pub(super) const POWER: Column = column("power", "W", |at| at.performance.power);
pub(super) const THRUST: Column = column("thrust", "N", |at| at.performance.thrust);
const TORQUE: Column = column("torque", "N m", |at| at.performance.torque);

/// Quantities of all machines.
const COMMON: [Column; 6] = [SPEED, ROTOR_SPEED, PITCH, POWER, THRUST, TORQUE];

pub(super) const TURBINE_CP: Column = column("CP", "-", |at| at.performance.turbine().power);
pub(super) const TURBINE_CT: Column = column("CT", "-", |at| at.performance.turbine().thrust);
pub(super) const TIP_SPEED_RATIO: Column = column("tip speed ratio", "-", |at| {
    at.performance.turbine().tip_speed_ratio
});
pub(super) const PROPELLER_CT: Column = column("CT", "-", |at| at.performance.propeller().thrust);
pub(super) const PROPELLER_CP: Column = column("CP", "-", |at| at.performance.propeller().power);
pub(super) const EFFICIENCY: Column = column("efficiency", "-", |at| {
    let found = at.performance.propeller();
    // Thrust and power of opposite signs give no efficiency.
    if found.thrust > 0.0 && found.power > 0.0 {
        found.efficiency
    } else {
        f64::NAN
    }
});
pub(super) const LIFTING_CT: Column = column("CT", "-", |at| at.performance.helicopter().thrust);
pub(super) const LIFTING_CP: Column = column("CP", "-", |at| at.performance.helicopter().power);
pub(super) const FIGURE_OF_MERIT: Column = column("figure of merit", "-", |at| {
    at.performance.helicopter().figure_of_merit
});

const TURBINE: [Column; 4] = [
    TIP_SPEED_RATIO,
    TURBINE_CP,
    TURBINE_CT,
    column("CQ", "-", |at| at.performance.turbine().torque),
];
const PROPELLER: [Column; 5] = [
    column("advance ratio", "-", |at| {
        at.performance.propeller().advance_ratio
    }),
    PROPELLER_CT,
    PROPELLER_CP,
    column("CQ", "-", |at| at.performance.propeller().torque),
    EFFICIENCY,
];
const HELICOPTER: [Column; 4] = [
    column("climb ratio", "-", |at| {
        at.performance.helicopter().climb_ratio
    }),
    LIFTING_CT,
    LIFTING_CP,
    FIGURE_OF_MERIT,
];

/// All quantities of a machine, in the order of the tables.
pub(super) fn columns(machine: MachineKind) -> Vec<Column> {
    let own: &[Column] = match machine {
        MachineKind::Turbine => &TURBINE,
        MachineKind::Propeller => &PROPELLER,
        MachineKind::Helicopter => &HELICOPTER,
    };
    COMMON.iter().chain(own).copied().collect()
}
