//! Reserve factors and fatigue loads of a blade.

use std::fmt::Write;

use nalgebra::Vector6;

use super::text::{csv, table};
use crate::input::result_tables::RESERVES;
use crate::recovery::FailureIndex;

/// The governing instant and point of a ply at a station.
#[derive(Debug, Clone, PartialEq)]
pub struct ReserveRow {
    /// Position of the station along the span [-].
    pub eta: f64,
    /// The section.
    pub section: String,
    /// The ply: a physical surface of the section.
    pub ply: String,
    /// Its material.
    pub material: String,
    /// The failure index with the smallest reserve factor.
    pub worst: FailureIndex,
    /// The instant.
    pub instant: String,
    /// Position (y, z) in the section \[m\].
    pub position: [f64; 2],
    /// Internal force at this instant about the reference line, in section axes \[N, N m\].
    pub force: Vector6<f64>,
}

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

/// One row per station and ply, as CSV.
pub fn strength_csv(rows: &[ReserveRow]) -> String {
    let heading = RESERVES.map(str::to_owned).to_vec();
    let cells = rows.iter().map(|row| {
        let worst = &row.worst;
        let mut cells = vec![format!("{:e}", row.eta), row.section.clone()];
        cells.extend([row.ply.clone(), row.material.clone()]);
        cells.extend([worst.reserve_factor, worst.index].map(|value| format!("{value:e}")));
        cells.extend([worst.criterion.key(), worst.mode.name()].map(str::to_owned));
        cells.push(row.instant.clone());
        let numbers = row.position.iter().chain(&row.force);
        cells.extend(numbers.map(|value| format!("{value:e}")));
        cells
    });
    csv(std::iter::once(heading).chain(cells))
}

/// One row per station, component and exponent, as CSV.
pub fn fatigue_csv(rows: &[FatigueRow]) -> String {
    let heading = [
        "eta [-]",
        "section",
        "component",
        "cycles [-]",
        "largest_range",
        "exponent [-]",
        "equivalent_range",
    ];
    let cells = rows.iter().map(|row| {
        let mut cells = vec![format!("{:e}", row.eta), row.section.clone()];
        cells.push(row.component.clone());
        let values = [row.cycles, row.largest, row.exponent, row.equivalent];
        cells.extend(values.map(|value| format!("{value:e}")));
        cells
    });
    csv(std::iter::once(heading.map(str::to_owned).to_vec()).chain(cells))
}

/// The critical ply of each station, and of all.
pub fn strength_text(rows: &[ReserveRow]) -> String {
    let heading = [
        "eta",
        "critical ply",
        "reserve factor",
        "criterion",
        "mode",
        "instant",
    ];
    let mut lines = vec![heading.map(str::to_owned).to_vec()];
    let mut stations: Vec<&ReserveRow> = Vec::new();
    let least = |row: &ReserveRow| row.worst.reserve_factor;
    for row in rows {
        match stations
            .last_mut()
            .filter(|known| known.section == row.section)
        {
            Some(known) if least(row) < least(known) => *known = row,
            Some(_) => {}
            None => stations.push(row),
        }
    }
    lines.extend(stations.iter().map(|row| {
        vec![
            crate::mesh::short(row.eta),
            row.ply.clone(),
            format!("{:.4}", least(row)),
            row.worst.criterion.name().to_owned(),
            row.worst.mode.name().to_owned(),
            row.instant.clone(),
        ]
    }));
    let mut text = format!("Reserve factors\n{}", table(&lines, "llrlll"));
    if let Some(row) = stations.iter().min_by(|a, b| least(a).total_cmp(&least(b))) {
        // writing to a string cannot fail
        let _ = writeln!(
            text,
            "\nCritical: ply \"{}\" ({}) at eta {}, y {:.4} m, z {:.4} m, {}: reserve factor {:.4}, \
             {}, {}",
            row.ply,
            row.material,
            crate::mesh::short(row.eta),
            row.position[0],
            row.position[1],
            row.instant,
            least(row),
            row.worst.criterion.name(),
            row.worst.mode.name(),
        );
    }
    text
}
