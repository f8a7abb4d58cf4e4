//! Curves of performance: of turbines over the wind, of propellers over the advance ratio.

use shared_geom::figure::{Panel, PanelPlot, scale};

use super::columns::{
    Column, EFFICIENCY, FIGURE_OF_MERIT, LIFTING_CP, LIFTING_CT, PITCH, POWER, PROPELLER_CP,
    PROPELLER_CT, ROTOR_SPEED, THRUST, TURBINE_CP, TURBINE_CT,
};
use crate::case::{Abscissa, MachineKind};
use crate::result::{PerformanceResult, PerformanceTable};

/// Part of the largest value by which a quantity must vary to be drawn.
const VARIES: f64 = 1e-9;

/// The curves of a table; `None` if it has fewer than two points on each curve.
pub(super) fn curve_plot(
    result: &PerformanceResult,
    table: &PerformanceTable,
) -> Option<PanelPlot> {
    if !table.curves().any(|(_, points)| points.len() > 1) {
        return None;
    }
    let quantities = quantities(result.machine, table.abscissa);
    let panels = quantities.iter().filter_map(|column| panel(table, column));
    let panels: Vec<Panel> = panels.collect();
    (!panels.is_empty()).then(|| PanelPlot {
        title: format!("{}: {}", result.name, table.name),
        across: table.abscissa.title().to_owned(),
        names: table.curves.clone(),
        panels,
    })
}

/// The quantities that are usual over an axis.
fn quantities(machine: MachineKind, abscissa: Abscissa) -> Vec<Column> {
    match (machine, abscissa) {
        (MachineKind::Turbine, Abscissa::TipSpeedRatio) => vec![TURBINE_CP, TURBINE_CT],
        (MachineKind::Turbine, _) => {
            vec![POWER, THRUST, PITCH, ROTOR_SPEED, TURBINE_CP, TURBINE_CT]
        }
        (MachineKind::Propeller, Abscissa::AdvanceRatio | Abscissa::TipSpeedRatio) => {
            vec![PROPELLER_CT, PROPELLER_CP, EFFICIENCY]
        }
        (MachineKind::Propeller, _) => {
            vec![THRUST, POWER, EFFICIENCY, PROPELLER_CT, PROPELLER_CP]
        }
        (MachineKind::Helicopter, _) => {
            vec![THRUST, POWER, LIFTING_CT, LIFTING_CP, FIGURE_OF_MERIT]
        }
    }
}

/// The panel of a quantity; `None` if it is constant, or has no value.
fn panel(table: &PerformanceTable, column: &Column) -> Option<Panel> {
    let (prefix, factor) = scale(column.unit, table.points.iter().map(column.value));
    let curves = table.curves().map(|(_, points)| {
        let points = points.iter();
        points
            .map(|point| [table.at(point), (column.value)(point) * factor])
            .collect::<Vec<_>>()
    });
    let curves: Vec<_> = curves.collect();
    let values = curves.iter().flatten().map(|point| point[1]);
    let values = values.filter(|value| value.is_finite());
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    // The pitch and the speed of rotation of many points are constant.
    let varies = high - low > VARIES * high.abs().max(low.abs());
    varies.then(|| Panel {
        title: format!("{} [{prefix}{}]", column.name, column.unit),
        curves,
    })
}
