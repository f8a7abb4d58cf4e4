//! Keys of systems that sample.

use shared_geom::document::Table;
use shared_geom::units::Dimension;

use super::StateSpaceProblem;
use crate::elements::control::{Limits, Sampling};

/// Keys that only a system that samples has.
const KEYS: [&str; 4] = ["offset", "delay", "limits", "rate_limits"];

/// When a system samples, and the limits of its outputs; nothing of one that does not sample,
/// and `None` when something is wrong.
#[expect(clippy::option_option, reason = "wrong, or absent, or there")]
pub(super) fn read(table: &Table<'_>, outputs: usize) -> Option<Option<(Sampling, Vec<Limits>)>> {
    if !table.has("sample_time") {
        let mut without = KEYS.into_iter().filter(|key| table.has(key));
        return match without.next() {
            None => Some(None),
            Some(key) => {
                table.note(key, &StateSpaceProblem::NotSampled { key });
                None
            }
        };
    }
    let period = table.require_positive("sample_time", Dimension::TIME);
    let offset = match table.has("offset") {
        true => table.quantity("offset", Dimension::TIME),
        false => Some(0.0),
    };
    let delay = match table.has("delay") {
        true => table.count("delay"),
        false => Some(0),
    };
    let ranges = match table.has("limits") {
        false => Some(Vec::new()),
        true if table.is_nested("limits") => table.rows("limits", outputs, 2),
        true => numbers(table, "limits", 2).map(|range| vec![range; outputs]),
    };
    let rates = match table.has("rate_limits") {
        false => Some(Vec::new()),
        true => numbers(table, "rate_limits", outputs),
    };
    let sampling = Sampling {
        period: period?,
        offset: offset?,
        delay: delay?,
    };
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
        table.wrong("limits", "the least value before the largest");
    }
    let has_rate = limits.iter().all(|own| own.rate > 0.0);
    if !has_rate {
        table.wrong("rate_limits", "rates greater than zero");
    }
    (has_range && has_rate).then_some(Some((sampling, limits)))
}

/// A list of so many numbers.
fn numbers(table: &Table<'_>, key: &str, count: usize) -> Option<Vec<f64>> {
    let numbers = table.quantities(key, Dimension::NUMBER)?;
    if numbers.len() != count {
        table.wrong(key, &format!("a list of {count} numbers"));
        return None;
    }
    Some(numbers)
}
