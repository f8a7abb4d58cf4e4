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
    /// Of the constraints `G x = 0`, sorted by a key of the unknowns.
    ///
    /// # Errors
    /// The index of an unknown in a constraint that follows from the others.
    pub fn new(constraints: &Mat<f64>, key: impl Fn(usize) -> usize) -> Result<Self, usize> {
        let count = constraints.nrows();
        let parts = ranked(constraints.as_ref(), (DEPENDENT, None));
        if parts.rank < count {
            return Err(parts.order.get(parts.rank).copied().unwrap_or(0));
        }
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
        Ok(Self {
            indices: sorted.into_iter().map(|(_, index)| index).collect(),
            all,
        })
    }

    /// The rows of the free unknowns.
    pub fn rows(&self, matrix: &Mat<f64>) -> Mat<f64> {
        Mat::from_fn(self.indices.len(), matrix.ncols(), |i, j| {
            matrix[(self.indices[i], j)]
        })
    }
}
