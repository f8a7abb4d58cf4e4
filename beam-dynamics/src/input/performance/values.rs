//! Values of a sweep: one, a list, or a range.

use shared_geom::document::schema::ValueKind::{Count, Free};
use shared_geom::document::{ByHand, Key, Table};
use shared_geom::keys;

use super::problem::PerformanceProblem;

keys! {
    /// Values at equal distances, both ends included, in the unit of the key.
    pub(super) RANGE = "{ from, to, steps }";
    /// First value.
    FROM: ByHand = "from", [Free], required, "3";
    /// Last value.
    TO: ByHand = "to", [Free], required, "25";
    /// Number of values.
    STEPS: usize = "steps", [Count(MOST)], required, "23";
}

/// Values of one range.
const MOST: usize = 10_000;

/// The values of a key in SI units: `Some(None)` if it is absent, `None` if it is wrong.
pub(super) fn read(table: &Table<'_>, key: &Key<Option<Vec<f64>>>) -> Option<Option<Vec<f64>>> {
    let values = if table.is_table(key) {
        Some(range(&table.table(key)?, key)?)
    } else {
        table.get(key)?
    };
    if values.as_ref().is_some_and(Vec::is_empty) {
        table.note(key, &PerformanceProblem::Empty { key: key.name() });
        return None;
    }
    Some(values)
}

fn range(table: &Table<'_>, key: &Key<Option<Vec<f64>>>) -> Option<Vec<f64>> {
    let dimension = key.schema.dimension();
    let from = table.require_quantity(FROM.name(), dimension);
    let to = table.require_quantity(TO.name(), dimension);
    let steps = table.get(&STEPS);
    table.finish();
    let (from, to, steps) = (from?, to?, steps?);
    let last = steps.saturating_sub(1).max(1) as f64;
    let value = |k: usize| from + (to - from) * k as f64 / last;
    Some((0..steps).map(value).collect())
}

/// Whether values increase; notes the first that does not.
pub(super) fn increasing(table: &Table<'_>, key: &'static str, values: &[f64]) -> bool {
    let wrong = values.windows(2).find(|pair| pair[1] <= pair[0]);
    if let Some(&[first, second]) = wrong {
        let problem = PerformanceProblem::NotIncreasing { key, first, second };
        table.note(key, &problem);
    }
    wrong.is_none()
}
