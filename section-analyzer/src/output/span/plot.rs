//! Figures of the properties along the span.

use shared_geom::blade::Blade;
use shared_geom::figure::{Panel, PanelPlot};

use super::compare::{QUANTITIES, values_beside};
use super::table::SpanRow;
use super::{SolvedSpan, SolvedStation};

/// A quantity of a station: name, unit and value. The first ones are the [`QUANTITIES`] of comparisons.
type Quantity = (
    &'static str,
    &'static str,
    fn(&SolvedStation, &SpanRow) -> f64,
);

const STIFFNESS: [Quantity; 6] = [
    ("mass", "kg/m", |station, _| station.properties.mass[(0, 0)]),
    ("EA", "N", |_, row| row.stiffness[0]),
    ("EI flap", "N m^2", |_, row| row.bending[0]),
    ("EI edge", "N m^2", |_, row| row.bending[1]),
    ("GJ", "N m^2", |_, row| row.stiffness[3]),
    ("principal twist", "deg", |station, row| {
        let angle = station.properties.principal_axes.bending_angle;
        (row.twist + angle).to_degrees()
    }),
];

const SHEAR: [Quantity; 2] = [
    ("GA along y", "N", |_, row| row.stiffness[1]),
    ("GA along z", "N", |_, row| row.stiffness[2]),
];

/// The figures with their names: `span` has mass, stiffness and the twist of the principal axes of
/// bending, `shear` the shear stiffness, `centers` the three centers in section axes. Mass and stiffness
/// of `other` are beside the ones of the blade, as its table of comparison has both.
pub fn span_plots(span: &SolvedSpan<'_>, other: Option<&Blade>) -> Vec<(&'static str, PanelPlot)> {
    let rows: Vec<SpanRow> = span
        .stations
        .iter()
        .map(|one| SpanRow::new(span, one))
        .collect();
    let curve = |value: &dyn Fn(&SolvedStation, &SpanRow) -> f64| -> Vec<[f64; 2]> {
        let stations = span.stations.iter().zip(&rows);
        stations
            .map(|(station, row)| [row.arc_length, value(station, row)])
            .collect()
    };
    let panel = |(name, unit, value): &Quantity| Panel::scaled((name, unit), vec![curve(value)]);
    let beside = |(number, quantity): (usize, &Quantity)| match other {
        Some(other) if number < QUANTITIES.len() => {
            let curves = both(span, &rows, other, number);
            Panel::scaled((quantity.0, quantity.1), curves.to_vec())
        }
        _ => panel(quantity),
    };
    let names = other.map_or_else(Vec::new, |other| vec![span.name, &other.name]);
    let plot = |title: &str, names: &[&str], panels: Vec<Panel>| PanelPlot {
        title: format!("{}: {title}", span.name),
        across: "arc length from the root [m]".to_owned(),
        names: names.iter().map(|&name| name.to_owned()).collect(),
        panels,
    };
    let center = |axis: usize| {
        let curves = [0, 1, 2].map(|which| {
            curve(&|station, _| {
                let centers = &station.properties.centers;
                [centers.tension, centers.shear, centers.mass][which][axis]
            })
        });
        let name = ["y, toward the leading edge", "z, toward the upper side"][axis];
        Panel::scaled((name, "m"), curves.to_vec())
    };
    vec![
        (
            "span",
            plot(
                "mass and stiffness along the span",
                &names,
                STIFFNESS.iter().enumerate().map(beside).collect(),
            ),
        ),
        (
            "shear",
            plot("shear stiffness", &[], SHEAR.iter().map(panel).collect()),
        ),
        (
            "centers",
            plot(
                "centers in section axes",
                &["tension center", "shear center", "mass center"],
                vec![center(0), center(1)],
            ),
        ),
    ]
}

/// The curves of a quantity of the blade and of another one, a point for each station.
fn both(
    span: &SolvedSpan<'_>,
    rows: &[SpanRow],
    other: &Blade,
    number: usize,
) -> [Vec<[f64; 2]>; 2] {
    let stations = span.stations.iter().zip(rows);
    let points = stations.map(|(station, row)| {
        let values = values_beside(station, other).map(|values| values[number]);
        values.map(|value| [row.arc_length, value])
    });
    let points: Vec<[[f64; 2]; 2]> = points.collect();
    [0, 1].map(|which| points.iter().map(|pair| pair[which]).collect())
}
