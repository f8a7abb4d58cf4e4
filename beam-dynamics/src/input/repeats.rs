//! Drives and air that are not the same a period later.
//!
//! A period is integrated from the same first instant again and again, so that a model whose residual at the
//! undeformed state is another one a period later,
//!
//! ```text
//! F(y_0, t + T) /= F(y_0, t)    at a time t of the period,
//! ```
//!
//! has no periodic motion, but a motion with a jump at the end of each period.

use std::collections::BTreeMap;

use shared_geom::error::Explain;

use super::short_number;
use crate::case::{Model, PeriodicSettings};

/// Parts of the period at which the model is compared: no common fractions, where drives of several times
/// the frequency vanish.
const PARTS: [f64; 8] = [0.0, 0.131, 0.243, 0.389, 0.517, 0.633, 0.769, 0.911];
/// Change in a period, as a part of the change within the period: rounded digits of speeds and periods.
const SAME: f64 = 1e-5;
/// Round-off, as a part of the largest terms of equations of a unit.
const ROUND_OFF: f64 = 1e-11;
/// The same of equations without terms: constraints that are met.
const NOTHING: f64 = 1e-12;
/// Digits of numbers.
const DIGITS: usize = 6;

/// A model that is not the same a period later.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error(
    "the model is another one a period of {} s later: from {} s to {} s the {equation} changes by {} {unit}{}",
    short_number(*period, DIGITS), short_number(*from, DIGITS), short_number(from + period, DIGITS),
    short_number(*change, 3), share(*within, *change)
)]
pub struct NotRepeated {
    /// The period \[s\].
    pub period: f64,
    /// The time \[s\].
    pub from: f64,
    /// The equation with the largest change.
    pub equation: String,
    /// Its change \[`unit`\].
    pub change: f64,
    /// Its unit.
    pub unit: String,
    /// Its change within the period \[`unit`\].
    pub within: f64,
}

fn share(within: f64, change: f64) -> String {
    match within > change {
        true => format!(
            ", {} % of its change within the period",
            short_number(100.0 * change / within, 3)
        ),
        false => String::new(),
    }
}

impl Explain for NotRepeated {
    fn help(&self) -> Option<String> {
        Some(
            "the period must be a whole number of periods of all drives, angles and winds: compare their \
             speeds with [periodic], and let ramps end before \"from\""
                .to_owned(),
        )
    }
}

/// The equation that changes most over a period, relative to its change within the period, if it is not the
/// same.
pub(super) fn problem(model: &Model, settings: &PeriodicSettings) -> Option<NotRepeated> {
    let system = &model.system;
    let rest = system.rest();
    let residual = |time: f64| system.residual(&rest, &model.conditions_at(time));
    let times = PARTS.map(|part| settings.start.from + part * settings.period);
    let pairs = times.map(|time| [residual(time), residual(time + settings.period)]);
    let equations = pairs[0][0].values.len();
    let mut sizes: BTreeMap<String, f64> = BTreeMap::new();
    let names: Vec<_> = (0..equations).map(|index| system.equation(index)).collect();
    for one in pairs.iter().flatten() {
        for (name, (size, value)) in names.iter().zip(one.sizes.iter().zip(&one.values)) {
            let of_unit = sizes
                .entry(name.unit.to_string())
                .or_insert(NOTHING / ROUND_OFF);
            *of_unit = of_unit.max(*size).max(value.abs());
        }
    }
    let mut worst: Option<(f64, NotRepeated)> = None;
    for index in 0..equations {
        let value = |pair: usize, side: usize| pairs[pair][side].values[index];
        let sides = |pair: usize| [value(pair, 0), value(pair, 1)];
        let all = (0..PARTS.len()).flat_map(sides);
        let (low, high) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value), high.max(value))
        });
        let within = high - low;
        let change = |pair: usize| (value(pair, 1) - value(pair, 0)).abs();
        let changes = (0..PARTS.len()).map(|pair| (pair, change(pair)));
        let Some((pair, change)) = changes.max_by(|a, b| a.1.total_cmp(&b.1)) else {
            continue;
        };
        let part = change / within;
        // Also numbers that are not finite.
        let name = &names[index];
        let size = sizes.get(name.unit.as_ref()).copied().unwrap_or_default();
        if !(change > SAME * within && change > ROUND_OFF * size) {
            continue;
        }
        if worst.as_ref().is_none_or(|(before, _)| part > *before) {
            let found = NotRepeated {
                period: settings.period,
                from: times[pair],
                equation: name.to_string(),
                change,
                unit: name.unit.to_string(),
                within,
            };
            worst = Some((part, found));
        }
    }
    worst.map(|(_, found)| found)
}
