//! Keys of systems that sample.

use shared_geom::document::schema::ValueKind::{
    Lines, NotNegative, Positive, Quantities, Quantity, Vector,
};
use shared_geom::document::{ByHand, Table};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::StateSpaceProblem;
use crate::elements::control::{Limits, Sampling};

keys! {
    /// Interval between samples: the matrices map the states of one sample to the next, and
    /// transfer functions are in z.
    pub(super) SAMPLE_TIME: Option<f64> = "sample_time", [Positive(Dimension::TIME)], or "continuous",
        "0.01";
    /// Time of a sample.
    pub(super) OFFSET: f64 = "offset", [Quantity(Dimension::TIME)], or "0" = 0.0, "0.005";
    /// Number of samples between an input and the output computed from it.
    pub(super) DELAY: f64 = "delay", [NotNegative(Dimension::NUMBER)]
        as "a whole number of samples, 0 to 100000", or "0" = 0.0, "1";
    /// Smallest and largest value of all outputs, or a pair for each.
    pub(super) LIMITS: ByHand = "limits", [Vector(2, Dimension::NUMBER), Lines(2)], or "none",
        "[-10, 10]";
    /// Largest rate of each output, per second.
    pub(super) RATE_LIMITS: Option<Vec<f64>> = "rate_limits", [Quantities(Dimension::NUMBER)], or "none",
        "[60]";
}

/// Keys only for systems that sample.
const KEYS: [&str; 4] = [
    OFFSET.name(),
    DELAY.name(),
    LIMITS.name(),
    RATE_LIMITS.name(),
];

/// Sample times below this part of an instant are lost in round-off.
const DISTINCT: f64 = 1e-9;
/// Largest delay, in samples: one second at 100 kHz.
const MOST_DELAY: f64 = 1e5;

/// Sample times of a system, and the limits of its outputs; empty for one that does not
/// sample, and `None` if something is wrong.
#[expect(clippy::option_option, reason = "wrong, or absent, or there")]
pub(super) fn read(table: &Table<'_>, outputs: usize) -> Option<Option<(Sampling, Vec<Limits>)>> {
    if !table.has(&SAMPLE_TIME) {
        let mut without = KEYS.into_iter().filter(|key| table.has(key));
        return match without.next() {
            None => Some(None),
            Some(key) => {
                table.note(key, &StateSpaceProblem::NotSampled { key });
                None
            }
        };
    }
    let period = table.get(&SAMPLE_TIME).flatten();
    let offset = table.get(&OFFSET);
    let delay = delay(table);
    let limits = limits(table, outputs);
    let (period, offset) = (period?, offset?);
    let sampling = Sampling {
        period,
        offset,
        delay: delay?,
    };
    if period < DISTINCT * offset.abs() {
        table.wrong(
            &OFFSET,
            "less than 1e9 sample times, the resolution of instants",
        );
        return None;
    }
    Some(Some((sampling, limits?)))
}

/// Limits of `outputs` outputs; `None` if something is wrong.
fn limits(table: &Table<'_>, outputs: usize) -> Option<Vec<Limits>> {
    let ranges = match table.has(&LIMITS) {
        false => Some(Vec::new()),
        true if table.is_nested(&LIMITS) => table.rows(LIMITS.name(), outputs, 2),
        true => {
            let range = table.array(LIMITS.name(), Dimension::NUMBER, "a list of 2 numbers");
            range.map(|range: [f64; 2]| vec![range.to_vec(); outputs])
        }
    };
    let is_right = |rates: &Option<Vec<f64>>| rates.as_ref().is_none_or(|r| r.len() == outputs);
    let rates = table.get_if(
        &RATE_LIMITS,
        is_right,
        &format!("a list of {outputs} numbers"),
    );
    let rates = rates.map(Option::unwrap_or_default);
    let (ranges, rates) = (ranges?, rates?);
    let mut limits = vec![Limits::default(); outputs];
    for (i, limits) in limits.iter_mut().enumerate() {
        if let Some(range) = ranges.get(i) {
            limits.range = [range[0], range[1]];
        }
        if let Some(rate) = rates.get(i) {
            limits.rate = *rate;
        }
    }
    let has_range = limits.iter().all(|own| own.range[0] <= own.range[1]);
    if !has_range {
        table.wrong(&LIMITS, "the least value before the largest");
    }
    let has_rate = limits.iter().all(|own| own.rate > 0.0);
    if !has_rate {
        table.wrong(&RATE_LIMITS, "rates greater than zero");
    }
    (has_range && has_rate).then_some(limits)
}

/// A whole number of samples.
fn delay(table: &Table<'_>) -> Option<usize> {
    let is_right = |number: &f64| number.fract() == 0.0 && *number <= MOST_DELAY;
    let number = table.get_if(&DELAY, is_right, DELAY.schema.expected)?;
    Some(number as usize)
}
