//! Reserve factors of a blade.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use nalgebra::Vector6;
use shared_geom::error::joined;

use super::text::{csv, table};
use crate::input::result_tables::RESERVES;
use crate::input::span_loads::ListedStation;
use crate::recovery::RegionReserve;

/// The governing instant and point of a ply at a station.
#[derive(Debug, Clone, PartialEq)]
pub struct ReserveRow {
    /// The station.
    pub station: ListedStation,
    /// Fingerprint of the files of its section.
    pub fingerprint: String,
    /// The ply: a physical surface of the section.
    pub ply: String,
    /// Its material.
    pub material: String,
    /// The governing point.
    pub found: RegionReserve,
    /// The instant.
    pub instant: String,
    /// Internal force at this instant about the reference line, in section axes \[N, N m\].
    pub force: Vector6<f64>,
}

/// The plies of each material that are not assessed.
pub type NotAssessed = BTreeMap<String, BTreeSet<String>>;

/// Plies that are not assessed, and the key that their materials lack, as text; empty if there are none.
pub fn not_assessed_text(found: &NotAssessed, key: &str) -> String {
    let material = |(name, plies): (&String, &BTreeSet<String>)| {
        let plies: Vec<&String> = plies.iter().collect();
        format!("\"{name}\" ({})", joined(&plies))
    };
    let materials: Vec<String> = found.iter().map(material).collect();
    if materials.is_empty() {
        return String::new();
    }
    format!("\nNot assessed, without {key}: {}\n", materials.join(", "))
}

/// One row per station and ply, as CSV.
pub fn strength_csv(rows: &[ReserveRow]) -> String {
    let heading = RESERVES.map(str::to_owned).to_vec();
    let cells = rows.iter().map(|row| {
        let worst = &row.found.worst;
        let mut cells = vec![
            format!("{:e}", row.station.eta),
            row.station.section.clone(),
        ];
        cells.extend([row.ply.clone(), row.material.clone()]);
        cells.extend([worst.reserve_factor, worst.index].map(|value| format!("{value:e}")));
        cells.extend([worst.criterion.key(), worst.mode.name()].map(str::to_owned));
        cells.push(row.instant.clone());
        let numbers = row.found.position.iter().chain(&row.force);
        let numbers = numbers.chain(&row.found.stress);
        cells.extend(numbers.map(|value| format!("{value:e}")));
        cells.push(format!("{:e}", row.found.of_cell));
        cells.push(row.fingerprint.clone());
        cells
    });
    csv(std::iter::once(heading).chain(cells))
}

/// The row of each station, whose rows follow each other, than which no other one is worse.
pub(super) fn critical<'a, R>(
    rows: &'a [R],
    station: impl Fn(&R) -> &ListedStation,
    is_worse: impl Fn(&R, &R) -> bool,
) -> Vec<&'a R> {
    let mut stations: Vec<&'a R> = Vec::new();
    for row in rows {
        match stations
            .last_mut()
            .filter(|known| station(known) == station(row))
        {
            Some(known) if is_worse(row, known) => *known = row,
            Some(_) => {}
            None => stations.push(row),
        }
    }
    stations
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
    let least = |row: &ReserveRow| row.found.worst.reserve_factor;
    let stations = critical(
        rows,
        |row| &row.station,
        |row, known| least(row) < least(known),
    );
    lines.extend(stations.iter().map(|row| {
        vec![
            row.station.label(),
            row.ply.clone(),
            format!("{:.4}", least(row)),
            row.found.worst.criterion.name().to_owned(),
            row.found.worst.mode.name().to_owned(),
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
            row.station.label(),
            row.found.position[0],
            row.found.position[1],
            row.instant,
            least(row),
            row.found.worst.criterion.name(),
            row.found.worst.mode.name(),
        );
    }
    text + &of_cells(rows, &stations)
}

/// Part by which the reserve factor of a point may be below the one of the mean stress of its cell
/// without a remark.
const VARIES: f64 = 0.1;

/// Part by which the reserve factor of a ply may be above the smallest one of its station and still
/// become the critical one with other cells.
const NEAR_CRITICAL: f64 = 0.1;

/// The plies of stations whose reserve factor depends on the size of the cells, of those near the smallest
/// one of their station, as text; empty if there are none.
fn of_cells(rows: &[ReserveRow], critical: &[&ReserveRow]) -> String {
    let factors = |row: &ReserveRow| (row.found.worst.reserve_factor, row.found.of_cell);
    let least = |row: &ReserveRow| {
        let mut stations = critical.iter();
        let station = stations.find(|known| known.station == row.station);
        station.map_or(f64::INFINITY, |known| factors(known).0)
    };
    let varies = |row: &&ReserveRow| {
        let (point, cell) = factors(row);
        point <= (1.0 + NEAR_CRITICAL) * least(row) && point < (1.0 - VARIES) * cell
    };
    let ply = |row: &ReserveRow| {
        let (point, cell) = factors(row);
        let station = row.station.label();
        format!("{station} ply \"{}\" ({point:.3}, {cell:.3})", row.ply)
    };
    let found: Vec<String> = rows.iter().filter(varies).map(ply).collect();
    if found.is_empty() {
        return String::new();
    }
    format!(
        "\nNot converged with the mesh: the reserve factor is more than {} % below the one of the mean stress \
         of the cell (both in brackets); solve with smaller cells, \"size\" in [mesh], and compare: eta \
         {}\n",
        100.0 * VARIES,
        found.join(", ")
    )
}
