//! Numbers of steps, modes and the like, which have an upper limit.

use shared_geom::document::Table;

use super::problem::InputProblem;

/// The number `found` under `key`, unless it is above `limit`, which is noted.
pub(super) fn at_most(
    table: &Table<'_>,
    key: &'static str,
    found: Option<usize>,
    limit: usize,
) -> Option<usize> {
    let found = found?;
    if found > limit {
        table.note(key, &InputProblem::TooMany { key, found, limit });
        return None;
    }
    Some(found)
}
