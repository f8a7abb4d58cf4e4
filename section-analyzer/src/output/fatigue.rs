//! Fatigue loads of a blade, and the damage of its plies.

use std::fmt::Write;

use super::strength::critical;
use super::text::{csv, table};
use crate::input::span_loads::ListedStation;
use crate::mesh::short;
use crate::recovery::fatigue::RegionDamage;

/// Columns of the table of equivalent ranges.
const EQUIVALENT: [&str; 7] = [
    "eta [-]",
    "section",
    "component",
    "cycles [-]",
    "largest_range",
    "exponent [-]",
    "equivalent_range",
];

/// Columns of the table of damage.
const DAMAGE: [&str; 16] = [
    "eta [-]",
    "section",
    "ply",
    "material",
    "damage [-]",
    "life_factor [-]",
    "life [h]",
    "reserve_factor [-]",
    "component",
    "cycles [-]",
    "largest_range",
    "mean_of_largest",
    "limit_amplitude",
    "slope [-]",
    "y [m]",
    "z [m]",
];

/// Seconds of an hour, and hours of a year of 365.25 days.
const HOUR: f64 = 3600.0;
const YEAR: f64 = 8766.0;

/// The fatigue load of a component at a station.
#[derive(Debug, Clone, PartialEq)]
pub struct FatigueRow {
    /// Position of the station along the span [-].
    pub eta: f64,
    /// The section.
    pub section: String,
    /// The component, with its unit.
    pub component: String,
    /// Number of cycles [-].
    pub cycles: f64,
    /// The largest range [unit of the component].
    pub largest: f64,
    /// Woehler exponent [-].
    pub exponent: f64,
    /// Range of equal damage [unit of the component].
    pub equivalent: f64,
}

/// The governing point and component of a ply at a station in fatigue.
#[derive(Debug, Clone, PartialEq)]
pub struct DamageRow {
    /// The station.
    pub station: ListedStation,
    /// The ply: a physical surface of the section.
    pub ply: String,
    /// Its material.
    pub material: String,
    /// The damage.
    pub found: RegionDamage,
}

/// One row per station, component and exponent, as CSV.
pub fn fatigue_csv(rows: &[FatigueRow]) -> String {
    let cells = rows.iter().map(|row| {
        let mut cells = vec![format!("{:e}", row.eta), row.section.clone()];
        cells.push(row.component.clone());
        let values = [row.cycles, row.largest, row.exponent, row.equivalent];
        cells.extend(values.map(|value| format!("{value:e}")));
        cells
    });
    csv(std::iter::once(EQUIVALENT.map(str::to_owned).to_vec()).chain(cells))
}

/// One row per station and ply, as CSV; `duration` is the time of all histories \[s\].
pub fn damage_csv(rows: &[DamageRow], duration: f64) -> String {
    let cells = rows.iter().map(|row| {
        let (station, found) = (&row.station, &row.found);
        let mut cells = vec![format!("{:e}", station.eta), station.section.clone()];
        cells.extend([row.ply.clone(), row.material.clone()]);
        let factor = 1.0 / found.damage;
        let life = duration / HOUR * factor;
        cells.extend([found.damage, factor].map(|value| format!("{value:e}")));
        // one instant has no time
        cells.push(if duration > 0.0 {
            format!("{life:e}")
        } else {
            String::new()
        });
        cells.extend([
            format!("{:e}", found.reserve_factor),
            found.component.name(),
        ]);
        let values = [
            found.cycles,
            found.largest.range,
            found.largest.mean,
            found.life.amplitude(found.largest.mean),
            found.life.slope,
        ];
        let values = values.iter().chain(&found.position);
        cells.extend(values.map(|value| format!("{value:e}")));
        cells
    });
    csv(std::iter::once(DAMAGE.map(str::to_owned).to_vec()).chain(cells))
}

/// The ply with the largest damage of each station, and of all; `duration` is the time of all
/// histories \[s\].
pub fn damage_text(rows: &[DamageRow], duration: f64) -> String {
    let heading = [
        "eta",
        "critical ply",
        "damage",
        "life factor",
        "reserve factor",
        "component",
    ];
    let mut lines = vec![heading.map(str::to_owned).to_vec()];
    let is_worse = |row: &DamageRow, known: &DamageRow| row.found.damage > known.found.damage;
    let stations = critical(rows, |row| &row.station, is_worse);
    lines.extend(stations.iter().map(|row| {
        vec![
            row.station.label(),
            row.ply.clone(),
            format!("{:.3e}", row.found.damage),
            format!("{:.3e}", 1.0 / row.found.damage),
            format!("{:.4}", row.found.reserve_factor),
            row.found.component.name(),
        ]
    }));
    let hours = duration / HOUR;
    let mut text = format!("Damage of {} h\n{}", short(hours), table(&lines, "llrrrl"));
    let damage = |row: &&&DamageRow| row.found.damage;
    let worst = stations
        .iter()
        .max_by(|a, b| damage(a).total_cmp(&damage(b)));
    if let Some(row) = worst {
        let found = &row.found;
        let life = format!(", life {:.3e} years", hours / YEAR / found.damage);
        let life = if hours > 0.0 { &life } else { "" };
        // writing to a string cannot fail
        let _ = writeln!(
            text,
            "\nCritical in fatigue: ply \"{}\" ({}) at eta {}, y {:.4} m, z {:.4} m, {}: damage \
             {:.3e}{life}, factor {:.4} on all loads",
            row.ply,
            row.material,
            row.station.label(),
            found.position[0],
            found.position[1],
            found.component.name(),
            found.damage,
            found.reserve_factor,
        );
    }
    text
}
