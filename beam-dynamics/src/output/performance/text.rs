//! The report of performance.

use std::fmt::Write;

use shared_geom::figure::scale;

use super::columns::{Column, PROPELLER_CT, TURBINE_CP, columns};
use crate::case::{Abscissa, MachineKind};
use crate::input::short_number;
use crate::output::text::aligned;
use crate::result::{PerformancePoint, PerformanceResult, PerformanceTable, PointStatus};

/// Rows of a table that are printed; larger tables are in the file alone.
const MOST_ROWS: usize = 60;
/// Digits of the numbers.
const DIGITS: usize = 5;

/// The report: the rotor, the table of each part, remarks.
pub fn performance_text(result: &PerformanceResult) -> String {
    let mut text = format!(
        "{}: {} blades, radius {} m, air of {} kg/m^3\n",
        result.name,
        result.blades,
        short_number(result.disk_radius, 6),
        short_number(result.density, 5),
    );
    for table in &result.tables {
        // Writing to a string cannot fail.
        let _ = write!(text, "\n{}\n", table.name);
        text.push_str(&table_text(result.machine, table));
        if let Some(best) = best(result.machine, table) {
            let _ = writeln!(text, "{best}");
        }
        let unsolved = table.unsolved();
        if unsolved > 0 {
            let count = table.points.len();
            let _ = writeln!(
                text,
                "remark: at {unsolved} of {count} points some stations have no state in balance, and \
                 no induction"
            );
        }
    }
    for remark in &result.remarks {
        let _ = write!(text, "\nremark: {remark}");
    }
    if !result.remarks.is_empty() {
        text.push('\n');
    }
    text
}

fn table_text(machine: MachineKind, table: &PerformanceTable) -> String {
    if table.points.len() > MOST_ROWS {
        return format!(
            "{} points, in the table of the results\n",
            table.points.len()
        );
    }
    let columns = columns(machine);
    let is_controlled = table
        .points
        .iter()
        .any(|it| it.status != PointStatus::Given);
    let scales = columns.iter().map(|column| scale_of(column, table));
    let scales: Vec<_> = scales.collect();
    let mut rows = vec![heading(&columns, &scales, is_controlled)];
    for (curve, points) in table.curves() {
        if !curve.is_empty() {
            rows.push(vec![curve.to_owned()]);
        }
        for point in points {
            let numbers = columns.iter().zip(&scales);
            let numbers =
                numbers.map(|(column, (_, factor))| shown((column.value)(point) * factor));
            let mut row: Vec<String> = numbers.collect();
            if is_controlled {
                row.push(point.status.word().to_owned());
            }
            rows.push(row);
        }
    }
    aligned(&rows)
}

fn scale_of(column: &Column, table: &PerformanceTable) -> (&'static str, f64) {
    scale(column.unit, table.points.iter().map(column.value))
}

fn heading(columns: &[Column], scales: &[(&str, f64)], is_controlled: bool) -> Vec<String> {
    let titles = columns.iter().zip(scales);
    let titles = titles.map(|(column, (prefix, _))| match column.unit {
        "-" => column.name.to_owned(),
        unit => format!("{} [{prefix}{unit}]", column.name),
    });
    let mut titles: Vec<String> = titles.collect();
    titles.extend(is_controlled.then(|| "state".to_owned()));
    titles
}

fn shown(value: f64) -> String {
    if value.is_finite() {
        short_number(value, DIGITS)
    } else {
        "-".to_owned()
    }
}

/// The largest power coefficient of a turbine over the points of a sweep.
fn best(machine: MachineKind, table: &PerformanceTable) -> Option<String> {
    let (column, is_turbine) = match machine {
        MachineKind::Turbine => (TURBINE_CP, true),
        _ => (PROPELLER_CT, false),
    };
    let is_given = table
        .points
        .iter()
        .all(|it| it.status == PointStatus::Given);
    let is_sweep = table.abscissa == Abscissa::TipSpeedRatio && is_given;
    if !is_turbine || !is_sweep {
        return None;
    }
    let value = |point: &&PerformancePoint| (column.value)(point);
    let finite = table.points.iter().filter(|point| value(point).is_finite());
    let best = finite.max_by(|a, b| value(a).total_cmp(&value(b)))?;
    Some(format!(
        "largest CP {} at tip speed ratio {}, pitch {} deg",
        short_number(value(&best), 4),
        short_number(best.performance.turbine().tip_speed_ratio, 4),
        short_number(best.setting().pitch.to_degrees(), 4)
    ))
}
