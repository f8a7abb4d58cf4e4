//! The unknowns with rates that constraints leave free.

use faer::Mat;

use super::ranked::ranked;

/// Part of the largest pivot below which a constraint follows from the others.
const DEPENDENT: f64 = 1e-10;

/// The free unknowns, and all unknowns with rates by them.
pub(super) struct Free {
    /// Indices of the free ones.
    pub indices: Vec<usize>,
    /// All by the free ones.
    pub all: Mat<f64>,
}

impl Free {
    /// Of the constraints `G x = 0`, sorted by a key of the unknowns. Constraints that follow from others leave a
    /// reaction undetermined, which the end of the elimination finds.
    pub fn new(constraints: &Mat<f64>, key: impl Fn(usize) -> usize) -> Self {
        let parts = ranked(constraints.as_ref(), (DEPENDENT, None));
        let count = parts.rank;
        let by_rest = parts.dependent();
        let (bound, rest) = parts.order.split_at(count);
        let mut sorted: Vec<_> = rest.iter().copied().enumerate().collect();
        sorted.sort_by_key(|(_, index)| key(*index));
        let mut all = Mat::zeros(constraints.ncols(), rest.len());
        for (column, &(place, index)) in sorted.iter().enumerate() {
            all[(index, column)] = 1.0;
            for (row, &own) in bound.iter().enumerate() {
                all[(own, column)] = -by_rest[(row, place)];
            }
        }
        Self {
            indices: sorted.into_iter().map(|(_, index)| index).collect(),
            all,
        }
    }
}
