//! Drives and air that are not the same a period later.
//!
//! A period is integrated from the same first instant again and again, so that a model whose residual at some
//! state is another one a period later,
//!
//! ```text
//! F(y_0, t + T) /= F(y_0, t)    at a time t of the period,
//! ```
//!
//! has no periodic motion, but a motion with a jump at the end of each period.

use std::collections::BTreeMap;

use nalgebra::Vector3;
use shared_geom::error::Explain;

use super::short_number;
use crate::assembly::Residual;
use crate::case::{Model, PeriodicSettings};
use crate::model::{Name, State};

/// Parts of the period at which the model is compared: no common fractions, where drives of several times
/// the frequency vanish.
const PARTS: [f64; 8] = [0.0, 0.131, 0.243, 0.389, 0.517, 0.633, 0.769, 0.911];
/// Change in a period, as a part of the change within the period: rounded digits of speeds and periods.
const SAME: f64 = 1e-5;
/// Round-off, as a part of the largest terms of equations of a unit.
const ROUND_OFF: f64 = 1e-11;
/// The same of equations without terms: constraints that are met.
const NOTHING: f64 = 1e-12;
/// Speeds and turns of nodes of the second state \[m/s, rad/s\], and its scalars \[their units\].
const MOTION: [f64; 3] = [7.0, 3.0, 0.7];
/// Distance from the end of a period within which a corner is at its end, as a part of it.
const AT_END: f64 = 1e-6;
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
             speeds with [periodic], with all digits, and let ramps end before \"from\""
                .to_owned(),
        )
    }
}

/// The equation that changes most over a period, relative to its change within the period, if it is not the
/// same at the undeformed state, or at one in motion with scalars other than zero, where drives act that
/// are multiplied by controls and sensed quantities or need a flow.
///
/// Tables of one period that end where they begin repeat: they are compared at the ends of the period only.
pub(super) fn problem(model: &Model, settings: &PeriodicSettings) -> Option<NotRepeated> {
    let rest = model.system.rest();
    let mut moving = rest.clone();
    let mut number = 0.0_f64;
    let mut next = || {
        number += 1.0;
        // Between 0.5 and 1.5, all different.
        0.5 + (0.618_034 * number).fract()
    };
    for node in &mut moving.nodes {
        node.velocity = Vector3::from_fn(|_, _| MOTION[0] * next());
        node.angular_velocity = Vector3::from_fn(|_, _| MOTION[1] * next());
    }
    for scalar in &mut moving.scalars {
        *scalar = MOTION[2] * next();
    }
    let equations = 0..model
        .system
        .residual(&rest, &model.conditions_at(settings.start.from))
        .values
        .len();
    let names: Vec<_> = equations
        .map(|index| model.system.equation(index))
        .collect();
    let changed = |state: &State| changed(model, settings, (state, &names));
    changed(&rest).or_else(|| changed(&moving))
}

/// Whether the last corner of all drives is the end of the period.
fn ends_with_period(model: &Model, [from, period]: [f64; 2]) -> bool {
    let end = from + period;
    let is_at_end = |time: f64| (time - end).abs() <= AT_END * period;
    is_at_end(model.next_corner(end - 2.0 * AT_END * period))
        && model.next_corner(end + 2.0 * AT_END * period) > end + period
}

/// The equation that changes most at a state.
fn changed(
    model: &Model,
    settings: &PeriodicSettings,
    (state, names): (&State, &[Name]),
) -> Option<NotRepeated> {
    let span = [settings.start.from, settings.period];
    let residual = |time: f64| model.system.residual(state, &model.conditions_at(time));
    let times = PARTS.map(|part| span[0] + part * span[1]);
    let pairs = times.map(|time| [residual(time), residual(time + span[1])]);
    let sizes = sizes(names, &pairs);
    let compared = if ends_with_period(model, span) {
        1
    } else {
        PARTS.len()
    };
    let mut worst: Option<(f64, NotRepeated)> = None;
    for (index, name) in names.iter().enumerate() {
        let value = |pair: usize, side: usize| pairs[pair][side].values[index];
        let all = (0..PARTS.len()).flat_map(|pair| [value(pair, 0), value(pair, 1)]);
        let all = all.filter(|value| value.is_finite());
        let (low, high) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value), high.max(value))
        });
        let within = high - low;
        // Tables without a value after their end are compared at the ends of the period.
        let changes = (0..compared).map(|pair| (pair, (value(pair, 1) - value(pair, 0)).abs()));
        let changes = changes.filter(|(_, change)| change.is_finite());
        let Some((pair, change)) = changes.max_by(|a, b| a.1.total_cmp(&b.1)) else {
            continue;
        };
        let size = sizes.get(name.unit.as_ref()).copied().unwrap_or_default();
        if change <= SAME * within || change <= ROUND_OFF * size {
            continue;
        }
        let part = change / within;
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

/// The largest finite terms of the equations of each unit.
fn sizes(names: &[Name], pairs: &[[Residual; 2]]) -> BTreeMap<String, f64> {
    let mut sizes = BTreeMap::new();
    for one in pairs.iter().flatten() {
        for (name, (size, value)) in names.iter().zip(one.sizes.iter().zip(&one.values)) {
            let of_unit = sizes
                .entry(name.unit.to_string())
                .or_insert(NOTHING / ROUND_OFF);
            for number in [*size, value.abs()]
                .into_iter()
                .filter(|own| own.is_finite())
            {
                *of_unit = number.max(*of_unit);
            }
        }
    }
    sizes
}
