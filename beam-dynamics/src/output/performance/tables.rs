//! Tables of performance and of loads along the blades, for programs.

use std::f64::consts::PI;

use rotor_aero::rotor::SpanLoad;

use super::columns::columns;
use crate::output::rows::{csv_text, number};
use crate::result::PerformanceResult;

const LOADS: &str = "part,speed [m/s],rotor speed [rpm],pitch [deg],azimuth [deg],radius [m],\
    normal force [N/m],tangential force [N/m],axial induction [-],tangential induction [-],\
    induced velocity [m/s],induced swirl [m/s],\
    angle of attack [deg],CL [-],CD [-],CM [-],inflow angle [deg],flow speed [m/s],loss [-],\
    Reynolds number [-],Mach number [-],state";

/// A number, or nothing if it is not finite.
fn cell(value: f64) -> String {
    if value.is_finite() {
        number(value)
    } else {
        String::new()
    }
}

/// One row for each operating point: its part and curve, the point, forces and coefficients, the
/// way in which it was found, and the number of stations without a state in balance. Coefficients
/// that have no value, such as the power coefficient of a turbine without wind, are empty.
pub fn performance_csv(result: &PerformanceResult) -> String {
    let columns = columns(result.machine);
    let mut heading = vec!["part".to_owned(), "curve".to_owned()];
    heading.extend(columns.iter().map(|column| column.title()));
    heading.extend(["state", "unsolved stations"].map(str::to_owned));
    let rows = result.tables.iter().flat_map(|table| {
        let columns = &columns;
        table.curves().flat_map(move |(curve, points)| {
            points.iter().map(move |point| {
                let mut row = vec![table.name.clone(), curve.to_owned()];
                row.extend(columns.iter().map(|column| cell((column.value)(point))));
                row.push(point.status.word().to_owned());
                row.push(point.performance.unsolved.to_string());
                row
            })
        })
    });
    csv_text(&heading.join(","), rows)
}

/// One row for each station and azimuth of the points with loads along the blades; `None` if there
/// are none.
pub fn span_load_csv(result: &PerformanceResult) -> Option<String> {
    let mut rows = Vec::new();
    for table in &result.tables {
        for point in table.loaded() {
            let at = point.setting();
            for sector in &point.performance.sectors {
                let mut lead = vec![table.name.clone()];
                let numbers = [
                    at.speed,
                    at.omega * 30.0 / PI,
                    at.pitch.to_degrees(),
                    sector.azimuth.to_degrees(),
                ];
                lead.extend(numbers.map(number));
                rows.extend(sector.stations.iter().map(|load| load_row(&lead, load)));
            }
        }
    }
    (!rows.is_empty()).then(|| csv_text(LOADS, rows))
}

fn load_row(lead: &[String], load: &SpanLoad) -> Vec<String> {
    let mut row = lead.to_vec();
    let values = [
        load.radius,
        load.normal,
        load.tangential,
        load.axial_induction,
        load.tangential_induction,
        load.induced_axial,
        load.induced_swirl,
        load.alpha.to_degrees(),
        load.lift,
        load.drag,
        load.moment,
        load.phi.to_degrees(),
        load.speed,
        load.loss,
        load.reynolds,
        load.mach,
    ];
    row.extend(values.map(cell));
    row.push(format!("{:?}", load.outcome).to_lowercase());
    row
}
