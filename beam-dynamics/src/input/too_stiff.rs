//! Stiffnesses and dampers that are beyond the digits of a model.

use shared_geom::document::Table;
use shared_geom::error::Explain;

use super::short_number;

/// The largest stiffness or damping in SI units \[N/m, N m, or times s\]: a hundred thousand times
/// the stiffness of any structure. Beyond it modes of soft blades are lost in round-off.
const MOST: f64 = 1e20;

/// A stiffness or a damper above the limit.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{owner}: \"{key}\" is {} in SI units, expected at most 1e20", short_number(*.found, 6))]
pub struct TooStiff {
    /// The card, as text.
    owner: String,
    /// The key.
    key: String,
    /// The value in SI units.
    found: f64,
}

impl Explain for TooStiff {
    fn help(&self) -> Option<String> {
        let text = "the stiffness of all other parts would be lost in round-off, and modes with it; \
                    for parts that move as one leave the hinge out, or use [[rigid]] or a [[joint]]";
        Some(text.to_owned())
    }
}

/// Whether all `values` under `key`, in SI units, are within the limit; notes the first other one.
pub(super) fn is_resolved(
    table: &Table<'_>,
    key: &str,
    values: impl IntoIterator<Item = f64>,
) -> bool {
    let above = values.into_iter().find(|value| value.abs() > MOST);
    if let Some(found) = above {
        let (owner, key) = (table.title().to_owned(), key.to_owned());
        table.note(key.clone(), &TooStiff { owner, key, found });
    }
    above.is_none()
}
