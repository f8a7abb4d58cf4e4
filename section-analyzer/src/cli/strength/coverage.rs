//! Warnings about loads: stations without forces, forces beyond the positions of a table, columns
//! without effect.

use std::collections::BTreeMap;

use shared_geom::error::quoted;

use crate::input::span_loads::{ListedStation, LoadInstant, SpanLoads};
use crate::mesh::short;

/// Largest number of cases or columns in a warning.
const MOST: usize = 8;

/// The warnings about loads at stations, and about columns that are not used.
pub(super) fn warnings(stations: &[ListedStation], found: &SpanLoads) -> Vec<String> {
    let (loads, unused) = (&found.instants, &found.unused);
    let mut cases: BTreeMap<Option<&str>, Vec<&LoadInstant>> = BTreeMap::new();
    for load in loads {
        cases.entry(load.case.as_deref()).or_default().push(load);
    }
    // the cases of each warning
    let mut texts_of: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for (case, loads) in &cases {
        let texts = [
            without_force(stations, loads),
            extrapolated(stations, loads),
        ];
        for text in texts.into_iter().flatten() {
            let known = texts_of.entry(text).or_default();
            known.extend(case.map(str::to_owned));
        }
    }
    let mut all: Vec<String> = texts_of.into_iter().map(of_cases).collect();
    if loads
        .iter()
        .flat_map(|load| &load.points)
        .all(|point| point.1.norm() == 0.0)
    {
        all.push("all forces are zero".to_owned());
    }
    if found.is_mixed {
        let text = "positions of one case are of different instants, as in the envelope of a run, so that forces \
                    between them and beyond are of no instant, and may be larger or smaller than any that acts: the \
                    .extremes.csv beside it has these instants with all positions";
        all.push(text.to_owned());
    }
    if !unused.is_empty() {
        all.push(format!("columns that are not used: {}", listed(unused)));
    }
    all
}

/// A warning with the cases that it is about.
fn of_cases((text, cases): (String, Vec<String>)) -> String {
    match &cases[..] {
        [] => text,
        [case] => format!("{text}, in case \"{case}\""),
        _ => format!("{text}, in cases {}", listed(&cases)),
    }
}

/// Names in quotes, the first ones of many.
fn listed(names: &[String]) -> String {
    match names.len() {
        count if count > MOST => {
            format!("{} and {} more", quoted(&names[..MOST]), count - MOST)
        }
        _ => quoted(names),
    }
}

/// Stations at which instants have no force: they have one position, which is not there.
fn without_force(stations: &[ListedStation], loads: &[&LoadInstant]) -> Option<String> {
    let lacking = |station: &ListedStation| {
        let without = loads.iter().filter(|load| load.at(station.eta).is_none());
        without.count()
    };
    let counts: Vec<usize> = stations.iter().map(lacking).collect();
    let most = counts.iter().copied().max().filter(|most| *most > 0)?;
    let position = loads.iter().find_map(|load| match load.points[..] {
        [(eta, _)] => Some(short(eta)),
        _ => None,
    });
    let position = position.unwrap_or_default();
    if counts.iter().all(|count| *count == loads.len()) {
        return Some(format!(
            "no station is at the only position of the force, eta {position}"
        ));
    }
    let without = stations.iter().zip(&counts).filter(|pair| *pair.1 > 0);
    let labels: Vec<String> = without.map(|pair| pair.0.label()).collect();
    let share = if most == loads.len() {
        String::new()
    } else {
        format!(" at {most} of {} instants", loads.len())
    };
    Some(format!(
        "the stations at eta {} have no force{share}: the only position is eta {position}",
        labels.join(", ")
    ))
}

/// Stations beyond the positions of the loads.
fn extrapolated(stations: &[ListedStation], loads: &[&LoadInstant]) -> Option<String> {
    let mut labels = Vec::new();
    let mut largest: Option<(f64, &LoadInstant)> = None;
    for station in stations {
        let beyond = loads
            .iter()
            .filter_map(|load| Some((load.extrapolated(station.eta)?, *load)));
        let Some(most) = beyond.max_by(|a, b| a.0.total_cmp(&b.0)) else {
            continue;
        };
        labels.push(station.label());
        if largest.is_none_or(|known| most.0 > known.0) {
            largest = Some(most);
        }
    }
    let (most, load) = largest?;
    let (first, last) = (load.points.first()?.0, load.points.last()?.0);
    Some(format!(
        "forces at eta {} are extrapolated by up to {} of the length, beyond the positions eta {} to {}",
        labels.join(", "),
        short(most),
        short(first),
        short(last)
    ))
}
