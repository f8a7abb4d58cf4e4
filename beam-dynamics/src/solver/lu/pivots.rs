//! The choice of pivots: little fill, and no small pivots.
//!
//! Among the entries that are not small in what is left of their column,
//! `|a_ij| >= u max_k |a_kj|` (D-131), the one that may fill the fewest places is taken, of
//! count `(r_i - 1)(c_j - 1)` (D-132) with r_i and c_j the entries left in its row and column;
//! where counts are equal, one of the diagonal, then the largest. The search looks at
//! the shortest columns and rows alone. So the identities by which momenta are defined
//! go first, multipliers are paired with the forces they cause, and chains of blocks
//! are eliminated from their ends.
//!
//! References: [Markowitz1957].

use super::lines::Lines;
use super::number::Number;
use crate::assembly::Pattern;

/// u: a pivot is at least this part of the largest entry of its column [-].
const THRESHOLD: f64 = 0.1;
/// Columns and rows that are searched for a pivot.
const SEARCHED: usize = 4;
/// A column is zero where no entry is larger, in a matrix scaled to largest entries of
/// one [-].
const ZERO: f64 = 1e-17;

/// Row and column of each pivot, in the order of elimination.
#[derive(Debug, Clone, Default)]
pub(super) struct Pivots {
    pub rows: Vec<usize>,
    pub columns: Vec<usize>,
}

/// Chooses pivots for a scaled matrix; `None` when it is singular.
pub(super) fn choose<T: Number>(pattern: &Pattern, scaled: &[T]) -> Option<Pivots> {
    let mut active = Active::new(pattern, scaled);
    let mut pivots = Pivots::default();
    for _ in 0..pattern.size() {
        let (row, column) = active.best()?;
        active.eliminate(row, column);
        pivots.rows.push(row);
        pivots.columns.push(column);
    }
    Some(pivots)
}

/// What is left of a matrix during elimination.
struct Active<T> {
    /// Entries of each column: row and value.
    columns: Vec<Vec<(usize, T)>>,
    /// Columns of the entries of each row.
    rows: Vec<Vec<usize>>,
    by_columns: Lines,
    by_rows: Lines,
    /// For each row its place among the multipliers of the pivot, counted from one.
    slots: Vec<usize>,
}

#[derive(Clone, Copy)]
struct Candidate {
    place: (usize, usize),
    /// Places that may fill.
    cost: usize,
    /// Size relative to the largest entry of the column [-].
    size: f64,
}

impl Candidate {
    fn is_better_than(&self, other: &Self) -> bool {
        let diagonal = |it: &Self| it.place.0 == it.place.1;
        let rank = |it: &Self| (it.cost, !diagonal(it));
        rank(self) < rank(other) || (rank(self) == rank(other) && self.size > other.size)
    }
}

impl<T: Number> Active<T> {
    fn new(pattern: &Pattern, scaled: &[T]) -> Self {
        let n = pattern.size();
        let mut rows = vec![Vec::new(); n];
        let mut columns = Vec::with_capacity(n);
        for j in 0..n {
            let range = pattern.column_starts()[j]..pattern.column_starts()[j + 1];
            let entries: Vec<_> = range.map(|at| (pattern.rows()[at], scaled[at])).collect();
            entries.iter().for_each(|entry| rows[entry.0].push(j));
            columns.push(entries);
        }
        Self {
            by_columns: Lines::new(columns.iter().map(Vec::len)),
            by_rows: Lines::new(rows.iter().map(Vec::len)),
            columns,
            rows,
            slots: vec![0; n],
        }
    }

    /// The best pivot in the shortest columns and rows; `None` when all that is left is
    /// zero.
    fn best(&self) -> Option<(usize, usize)> {
        let mut best: Option<Candidate> = None;
        let mut consider = |found: Option<Candidate>| {
            let Some(found) = found else { return };
            if best.is_none_or(|best| found.is_better_than(&best)) {
                best = Some(found);
            }
        };
        let of_columns = self.by_columns.ascending();
        let in_columns = of_columns.filter_map(|column| self.best_of_column(column));
        in_columns.take(SEARCHED).for_each(|it| consider(Some(it)));
        for row in self.by_rows.ascending().take(SEARCHED) {
            let of_row = self.rows[row].iter();
            of_row.for_each(|&column| consider(self.candidate(row, column)));
        }
        best.map(|best| best.place)
    }

    fn largest(&self, column: usize) -> f64 {
        let entries = self.columns[column].iter();
        entries.fold(0.0, |largest, entry| entry.1.size().max(largest))
    }

    fn best_of_column(&self, column: usize) -> Option<Candidate> {
        let largest = self.largest(column);
        let entries = self.columns[column].iter();
        entries
            .filter_map(|&(row, value)| self.rated(row, column, value, largest))
            .reduce(|a, b| if b.is_better_than(&a) { b } else { a })
    }

    fn candidate(&self, row: usize, column: usize) -> Option<Candidate> {
        let entry = self.columns[column].iter().find(|entry| entry.0 == row)?;
        self.rated(row, column, entry.1, self.largest(column))
    }

    /// An entry as a pivot; `None` where it is too small.
    fn rated(&self, row: usize, column: usize, value: T, largest: f64) -> Option<Candidate> {
        let fits = largest > ZERO && value.size() >= THRESHOLD * largest;
        fits.then(|| Candidate {
            place: (row, column),
            cost: (self.rows[row].len() - 1) * (self.columns[column].len() - 1),
            size: value.size() / largest,
        })
    }

    /// Eliminates the pivot at (row, column) from all other rows.
    fn eliminate(&mut self, row: usize, column: usize) {
        let pivot_column = std::mem::take(&mut self.columns[column]);
        let pivot_row = std::mem::take(&mut self.rows[row]);
        self.by_columns.remove(column);
        self.by_rows.remove(row);
        let pivot = pivot_column.iter().find(|entry| entry.0 == row);
        let pivot = pivot.map_or(T::ONE, |entry| entry.1);
        let others = pivot_column.iter().filter(|entry| entry.0 != row);
        let factors: Vec<_> = others.map(|&(i, value)| (i, value / pivot)).collect();
        for (slot, &(i, _)) in factors.iter().enumerate() {
            self.slots[i] = slot + 1;
            self.rows[i].retain(|&j| j != column);
        }
        let mut met = vec![usize::MAX; factors.len()];
        for &j in pivot_row.iter().filter(|&&j| j != column) {
            self.update(row, j, &factors, &mut met);
        }
        for &(i, _) in &factors {
            self.slots[i] = 0;
            self.by_rows.change(i, self.rows[i].len());
        }
    }

    /// `a_ij -= l_i a_pj` in column j, p being the row of the pivot.
    fn update(&mut self, row: usize, j: usize, factors: &[(usize, T)], met: &mut [usize]) {
        let target = &mut self.columns[j];
        let Some(at) = target.iter().position(|entry| entry.0 == row) else {
            return;
        };
        let (_, in_pivot_row) = target.swap_remove(at);
        for (i, value) in target.iter_mut() {
            if let Some(slot) = self.slots[*i].checked_sub(1) {
                *value -= factors[slot].1 * in_pivot_row;
                met[slot] = j;
            }
        }
        for (&(i, factor), _) in factors.iter().zip(&*met).filter(|it| *it.1 != j) {
            target.push((i, -factor * in_pivot_row));
            self.rows[i].push(j);
        }
        self.by_columns.change(j, target.len());
    }
}
