//! Loads along the blades, mean over the azimuth.

use rotor_aero::rotor::{Sector, SpanLoad};
use shared_geom::figure::{Panel, PanelPlot};

use crate::input::short_number;
use crate::result::{PerformancePoint, PerformanceResult, PerformanceTable};

/// A quantity along the blade.
type Quantity = (&'static str, &'static str, fn(&SpanLoad) -> f64);

const QUANTITIES: [Quantity; 5] = [
    ("normal force", "N/m", |load| load.normal),
    ("tangential force", "N/m", |load| load.tangential),
    ("angle of attack", "deg", |load| load.alpha.to_degrees()),
    ("axial induction", "-", |load| load.axial_induction),
    ("induced velocity", "m/s", |load| load.induced_axial),
];

/// The loads of the chosen points of a table; `None` if there are none.
pub(super) fn load_plot(result: &PerformanceResult, table: &PerformanceTable) -> Option<PanelPlot> {
    let points: Vec<&PerformancePoint> = table.loaded().collect();
    let panel = |(name, unit, value): &Quantity| {
        let curves = points.iter();
        let curves = curves.map(|point| mean(&point.performance.sectors, *value));
        Panel::scaled((name, unit), curves.collect())
    };
    let name = |point: &&PerformancePoint| {
        let title = table.abscissa.title();
        let (name, unit) = title.split_once(" [").unwrap_or((title, "]"));
        let unit = unit.trim_end_matches(']').trim_matches('-');
        let value = short_number(table.at(point), 4);
        format!("{name} {value} {unit}").trim_end().to_owned()
    };
    (!points.is_empty()).then(|| PanelPlot {
        title: format!("{}: {}, loads along the blade", result.name, table.name),
        across: "radius [m]".to_owned(),
        names: points.iter().map(name).collect(),
        panels: QUANTITIES.iter().map(panel).collect(),
    })
}

/// The mean of a quantity over the azimuth, over the radius.
fn mean(sectors: &[Sector], value: fn(&SpanLoad) -> f64) -> Vec<[f64; 2]> {
    let Some(first) = sectors.first() else {
        return Vec::new();
    };
    let stations = first.stations.iter().enumerate();
    let at = |(index, load): (usize, &SpanLoad)| {
        let values = sectors.iter().filter_map(|it| it.stations.get(index));
        let sum: f64 = values.map(value).sum();
        [load.radius, sum / sectors.len() as f64]
    };
    stations.map(at).collect()
}
