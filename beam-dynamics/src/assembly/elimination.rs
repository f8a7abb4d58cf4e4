//! Sparse elimination of rows, and the motions that they leave free.
//!
//! The rows of A are brought to echelon form, `A = L U` up to the order of rows and columns. Each
//! pivot is chosen in the column with the fewest remaining rows, in the shortest of these rows
//! whose entry is large enough (the rule of Markowitz with threshold pivoting), so that the rows of
//! trees of bodies have no fill: work and memory are linear in their number. A row of which nothing
//! remains follows from the others. Columns without a pivot are free: with numbers xi for these
//! columns, the others follow from
//!
//! ```text
//! U_kk x_k = - sum_{j after k} U_kj x_j ,      A x = 0
//! ```

use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

/// A row: column and value of each nonzero entry, by ascending columns.
pub(super) type SparseRow = Vec<(usize, f64)>;

/// Remainder of a subtraction below which it is round-off.
const ROUND_OFF: f64 = 1e-14;
/// Least pivot as a fraction of the largest entry of its column.
const OF_COLUMN: f64 = 0.3;
/// Least pivot as a fraction of the largest entry of its row.
const OF_ROW: f64 = 0.03;

/// Rows in echelon form.
#[derive(Debug, Default)]
pub(super) struct Echelon {
    /// Column of each pivot, in the order of elimination, with its row.
    pivots: Vec<(usize, SparseRow)>,
    /// Columns without a pivot.
    free: Vec<usize>,
}

impl Echelon {
    /// The echelon form of rows of `columns` numbers, each row of size one or zero; remainders of a
    /// row up to `zero` are zero.
    pub fn of(rows: Vec<SparseRow>, columns: usize, zero: f64) -> Self {
        let mut elimination = Elimination::new(rows, columns, zero);
        while let Some((row, column)) = elimination.next_pivot() {
            elimination.eliminate(row, column);
        }
        let mut is_free = vec![true; columns];
        for (column, _) in &elimination.pivots {
            is_free[*column] = false;
        }
        Self {
            pivots: elimination.pivots,
            free: (0..columns).filter(|&column| is_free[column]).collect(),
        }
    }

    /// Columns without a pivot: their number is the dimension of the null space.
    pub fn free(&self) -> &[usize] {
        &self.free
    }

    /// Number of rows that do not follow from others.
    pub fn rank(&self) -> usize {
        self.pivots.len()
    }

    /// The echelon forms of groups of columns that no row connects.
    pub fn split(self, mut group_of: impl FnMut(usize) -> usize) -> BTreeMap<usize, Self> {
        let mut split = BTreeMap::new();
        for pivot in self.pivots {
            let part: &mut Self = split.entry(group_of(pivot.0)).or_default();
            part.pivots.push(pivot);
        }
        for column in self.free {
            let part: &mut Self = split.entry(group_of(column)).or_default();
            part.free.push(column);
        }
        split
    }

    /// Completes a vector of the null space, given its numbers in the free columns.
    pub fn complete(&self, x: &mut [f64]) {
        for (column, row) in self.pivots.iter().rev() {
            let (mut sum, mut pivot) = (0.0, 1.0);
            for &(j, value) in row {
                if j == *column {
                    pivot = value
                } else {
                    sum += value * x[j]
                }
            }
            x[*column] = -sum / pivot;
        }
    }
}

/// An elimination in progress.
struct Elimination {
    /// Remaining rows; finished ones are empty.
    rows: Vec<SparseRow>,
    /// Rows that have, or had, an entry in each column.
    of_column: Vec<Vec<usize>>,
    /// Columns by the number of their rows; entries may be out of date.
    waiting: BinaryHeap<Reverse<(usize, usize)>>,
    pivots: Vec<(usize, SparseRow)>,
    /// Remainder of a row up to which it is zero.
    zero: f64,
    /// Buffer for sums of rows.
    sum: SparseRow,
}

impl Elimination {
    fn new(rows: Vec<SparseRow>, columns: usize, zero: f64) -> Self {
        let mut of_column = vec![Vec::new(); columns];
        for (number, row) in rows.iter().enumerate() {
            row.iter().for_each(|entry| of_column[entry.0].push(number));
        }
        let counts = of_column.iter().map(Vec::len).enumerate();
        Self {
            waiting: counts.map(|(j, count)| Reverse((count, j))).collect(),
            of_column,
            rows,
            zero,
            pivots: Vec::new(),
            sum: Vec::new(),
        }
    }

    fn entry(&self, row: usize, column: usize) -> Option<f64> {
        let row = &self.rows[row];
        let index = row.binary_search_by_key(&column, |entry| entry.0).ok()?;
        Some(row[index].1)
    }

    /// Row and column of the next pivot.
    fn next_pivot(&mut self) -> Option<(usize, usize)> {
        while let Some(Reverse((count, column))) = self.waiting.pop() {
            let mut own = std::mem::take(&mut self.of_column[column]);
            own.sort_unstable();
            own.dedup();
            own.retain(|&row| self.entry(row, column).is_some());
            let now = own.len();
            self.of_column[column] = own;
            if now > count {
                self.waiting.push(Reverse((now, column)));
                continue;
            }
            if let Some(found) = self.pivot_in(column) {
                if found.1 != column {
                    self.waiting.push(Reverse((now, column)));
                }
                return Some(found);
            }
        }
        None
    }

    /// The pivot in a column, or in another one if its entries are small in their rows.
    fn pivot_in(&self, column: usize) -> Option<(usize, usize)> {
        let own = self.of_column[column].iter();
        let entries = own.filter_map(|&row| Some((row, self.entry(row, column)?.abs())));
        let entries: Vec<_> = entries.collect();
        let largest = entries.iter().map(|entry| entry.1).fold(0.0, f64::max);
        if largest <= self.zero {
            return None;
        }
        let large = entries
            .iter()
            .filter(|entry| entry.1 >= OF_COLUMN * largest);
        let &(row, value) = large.min_by_key(|entry| self.rows[entry.0].len())?;
        let size = |entry: &&(usize, f64)| entry.1.abs();
        let most = self.rows[row]
            .iter()
            .max_by(|a, b| size(a).total_cmp(&size(b)))?;
        if value >= OF_ROW * most.1.abs() {
            Some((row, column))
        } else {
            Some((row, most.0))
        }
    }

    /// Chooses a pivot, and eliminates its column from the remaining rows.
    fn eliminate(&mut self, row: usize, column: usize) {
        let Some(pivot) = self.entry(row, column) else {
            return;
        };
        let pivot_row = std::mem::take(&mut self.rows[row]);
        let others = std::mem::take(&mut self.of_column[column]);
        for other in others {
            let Some(value) = self.entry(other, column) else {
                continue;
            };
            self.subtract((&pivot_row, column), value / pivot, other);
        }
        for &(j, _) in pivot_row.iter().filter(|entry| entry.0 != column) {
            let count = self.of_column[j].len().saturating_sub(1);
            self.waiting.push(Reverse((count, j)));
        }
        self.pivots.push((column, pivot_row));
    }

    /// Subtracts `factor` times the row of a pivot from the row with index `from`.
    fn subtract(&mut self, (pivot, column): (&SparseRow, usize), factor: f64, from: usize) {
        let row = std::mem::take(&mut self.rows[from]);
        let mut sum = std::mem::take(&mut self.sum);
        sum.clear();
        let (mut own, mut others) = (row.iter().peekable(), pivot.iter().peekable());
        loop {
            let next = match (own.peek(), others.peek()) {
                (Some(a), Some(b)) => a.0.min(b.0),
                (Some(a), None) => a.0,
                (None, Some(b)) => b.0,
                (None, None) => break,
            };
            let before = own.next_if(|entry| entry.0 == next).map(|entry| entry.1);
            let less = others.next_if(|entry| entry.0 == next).map(|entry| entry.1);
            let value = before.unwrap_or(0.0) - factor * less.unwrap_or(0.0);
            if next == column || value.abs() <= ROUND_OFF {
                continue;
            }
            if before.is_none() {
                self.of_column[next].push(from);
            }
            sum.push((next, value));
        }
        // Only round-off remains: the row follows from others.
        if sum.iter().all(|entry| entry.1.abs() <= self.zero) {
            sum.clear();
        }
        self.sum = row;
        self.rows[from] = sum;
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::DMatrix;

    use super::*;

    const ZERO: f64 = 1e-9;

    /// Numbers between -1 and 1, the same in each run.
    struct Random(u64);

    impl Random {
        fn number(&mut self) -> f64 {
            self.0 = self
                .0
                .wrapping_mul(6364136223846793005)
                .wrapping_add(1442695040888963407);
            (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        }

        fn below(&mut self, count: usize) -> usize {
            ((self.number() + 1.0) * 0.5 * count as f64) as usize % count
        }
    }

    /// Sparse rows, the last of them sums of others.
    fn rows(random: &mut Random, [count, columns, sums]: [usize; 3]) -> DMatrix<f64> {
        let mut matrix = DMatrix::zeros(count + sums, columns);
        for i in 0..count {
            for _ in 0..1 + random.below(4) {
                matrix[(i, random.below(columns))] = random.number();
            }
        }
        for i in count..count + sums {
            let (a, b) = (random.below(count), random.below(count));
            let sum = matrix.row(a) * random.number() + matrix.row(b) * random.number();
            matrix.set_row(i, &sum);
        }
        for mut row in matrix.row_iter_mut() {
            let size = row.amax();
            if size > 0.0 {
                row /= size;
            }
        }
        matrix
    }

    // The singular values of the same matrix: for random sparse rows they are above 1e-7 or zero. A
    // vector of the null space is checked with the rows themselves.
    #[test]
    fn the_null_space_is_that_of_the_singular_values() {
        let mut random = Random(7);
        let mut seen = [0; 2];
        for _ in 0..400 {
            let size = [1 + random.below(30), 2 + random.below(40), random.below(6)];
            let matrix = rows(&mut random, size);
            let sparse = matrix.row_iter().map(|row| {
                let entries = row.iter().copied().enumerate();
                entries.filter(|entry| entry.1 != 0.0).collect()
            });
            let columns = matrix.ncols();
            let echelon = Echelon::of(sparse.collect(), columns, ZERO);
            let values = matrix.clone().svd(false, false).singular_values;
            let rank = values.iter().filter(|value| **value > ZERO).count();
            assert_eq!(echelon.rank(), rank, "{matrix}");
            assert_eq!(echelon.free().len(), columns - rank);
            seen[usize::from(rank < columns)] += 1;
            let mut x = vec![0.0; columns];
            echelon
                .free()
                .iter()
                .for_each(|&free| x[free] = random.number());
            echelon.complete(&mut x);
            let x = nalgebra::DVector::from_vec(x);
            assert!((&matrix * &x).amax() <= 1e-11 * x.amax().max(1.0));
        }
        assert!(seen.iter().all(|count| *count > 20), "{seen:?}");
    }

    // A chain, in both orders of its rows: there is no fill.
    #[test]
    fn chains_stay_sparse() {
        let count = 20_000;
        let chain = (0..count).map(|i| match i {
            0 => vec![(0, 1.0), (1, -0.4)],
            _ => vec![
                (2 * i - 2, -1.0),
                (2 * i - 1, 0.5),
                (2 * i, 1.0),
                (2 * i + 1, 0.3),
            ],
        });
        let chain: Vec<SparseRow> = chain.collect();
        for rows in [chain.clone(), chain.into_iter().rev().collect()] {
            let echelon = Echelon::of(rows, 2 * count, ZERO);
            assert_eq!(echelon.free().len(), count);
            let entries: usize = echelon.pivots.iter().map(|pivot| pivot.1.len()).sum();
            assert!(entries <= 5 * count, "{entries}");
        }
    }
}
