//! The choice of pivots: little fill, and no small pivots.
//!
//! Candidates are the entries that are not small in the remaining part of their column,
//! `|a_ij| >= u max_k |a_kj|` (D-131). The one that may cause the least fill is chosen, of
//! count `(r_i - 1)(c_j - 1)` (D-132), with r_i and c_j the remaining entries of its row and
//! column; with equal counts an entry of the diagonal, then the largest. Only the shortest
//! columns and rows are searched. So the identities that define momenta are eliminated first,
//! multipliers are paired with the forces they cause, and chains of blocks are eliminated from
//! their ends. A long chain is divided into stages ([`dissection`]), one after the other.
//!
//! [`dissection`]: super::dissection
//!
//! References: [Markowitz1957].

use super::branches::LARGE;
use super::dissection::stages;
use super::lines::{Lines, Turn};
use super::lists::Lists;
use crate::number::Number;
use crate::pattern::Pattern;

/// u: a pivot is at least this part of the largest entry of its column [-].
const THRESHOLD: f64 = 0.1;
/// Number of columns and rows searched for a pivot.
const SEARCHED: usize = 4;
/// A column is zero if no entry is larger, in a matrix scaled to largest entries of one [-].
const ZERO: f64 = 1e-17;

/// Scales of rows, and of columns.
type Scales<'a> = (&'a [f64], &'a [f64]);

/// Row and column of each pivot, in the order of elimination.
#[derive(Debug, Clone, Default)]
pub(super) struct Pivots {
    pub rows: Vec<u32>,
    pub columns: Vec<u32>,
}

/// Chooses pivots for the matrix of the given values, scaled; `None` if it is singular.
pub(super) fn choose<T: Number>(
    pattern: &Pattern,
    values: &[T],
    scales: Scales<'_>,
) -> Option<Pivots> {
    let mut active = Active::new(pattern, values, scales);
    let mut pivots = Pivots::default();
    for _ in 0..pattern.size() {
        let mut best = active.best();
        while best.is_none() && active.show_next() {
            best = active.best();
        }
        let (row, column) = best?;
        active.eliminate(row, column);
        pivots.rows.push(row as u32);
        pivots.columns.push(column as u32);
    }
    Some(pivots)
}

/// The remaining part of a matrix during elimination.
struct Active<'a, T> {
    pattern: &'a Pattern,
    values: &'a [T],
    scales: Scales<'a>,
    /// Whether elimination has not yet changed a column.
    is_given: Vec<bool>,
    /// Entries of each other column: row and value.
    columns: Lists<(u32, T)>,
    /// Columns of the entries of each row.
    rows: Lists<u32>,
    by_columns: Lines,
    by_rows: Lines,
    /// For each row its index among the multipliers of the pivot, counted from one.
    slots: Vec<u32>,
}

#[derive(Clone, Copy)]
struct Candidate {
    index: (usize, usize),
    /// Entries that may fill.
    cost: usize,
    /// Size relative to the largest entry of the column [-].
    size: f64,
}

impl Candidate {
    fn is_better_than(&self, other: &Self) -> bool {
        let diagonal = |it: &Self| it.index.0 == it.index.1;
        let rank = |it: &Self| (it.cost, !diagonal(it));
        rank(self) < rank(other) || (rank(self) == rank(other) && self.size > other.size)
    }
}

impl<'a, T: Number> Active<'a, T> {
    fn new(pattern: &'a Pattern, values: &'a [T], scales: Scales<'a>) -> Self {
        let n = pattern.size();
        let mut counts = vec![0_u32; n];
        let all = pattern.rows().iter();
        all.for_each(|&row| counts[row as usize] += 1);
        let mut rows = Lists::new(n, pattern.entries() + pattern.entries() / 16);
        for (row, count) in counts.iter().enumerate() {
            rows.reserve(row, *count, 0);
        }
        for j in 0..n {
            let own = pattern.rows()[pattern.column(j)].iter();
            own.for_each(|&row| rows.push(row as usize, j as u32));
        }
        let stages = stages(pattern).unwrap_or_else(|| vec![0; n]);
        let turn = if n >= LARGE {
            Turn::EachInTurn
        } else {
            Turn::LatestFirst
        };
        Self {
            pattern,
            values,
            scales,
            is_given: vec![true; n],
            columns: Lists::new(n, pattern.entries() / 2),
            by_columns: Lines::new(
                (0..n).map(|j| pattern.column(j).len()),
                turn,
                stages.clone(),
            ),
            by_rows: Lines::new(counts.iter().map(|count| *count as usize), turn, stages),
            rows,
            slots: vec![0; n],
        }
    }

    /// Row and value of each entry of a column.
    fn entries(&self, column: usize) -> impl Iterator<Item = (u32, T)> + '_ {
        let given = if self.is_given[column] {
            self.pattern.column(column)
        } else {
            0..0
        };
        let given = given.map(move |at| self.given(at, column));
        given.chain(self.columns.of(column).iter().copied())
    }

    /// Row and scaled value of an entry of the given matrix.
    fn given(&self, at: usize, column: usize) -> (u32, T) {
        let row = self.pattern.rows()[at];
        let (of_rows, of_columns) = self.scales;
        let scale = of_rows[row as usize] * of_columns[column];
        (row, self.values[at] * scale)
    }

    /// Copies the entries of a column, so that they can be changed.
    fn take_over(&mut self, column: usize) {
        if self.is_given[column] {
            let entries = self.pattern.column(column);
            self.columns
                .reserve(column, entries.len() as u32, (0, T::ZERO));
            for at in entries {
                let entry = self.given(at, column);
                self.columns.push(column, entry);
            }
            self.is_given[column] = false;
        }
    }

    /// Allows pivots of the next stage from now on; `false` after the last one.
    fn show_next(&mut self) -> bool {
        self.by_columns.show_next();
        self.by_rows.show_next()
    }

    /// The best pivot in the shortest columns and rows; `None` if all remaining entries are
    /// zero, or of a later stage.
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
            let of_row = self.rows.of(row).iter();
            of_row.for_each(|&column| consider(self.candidate(row, column as usize)));
        }
        best.map(|best| best.index)
    }

    fn largest(&self, column: usize) -> f64 {
        let entries = self.entries(column);
        entries.fold(0.0, |largest, entry| entry.1.size().max(largest))
    }

    fn best_of_column(&self, column: usize) -> Option<Candidate> {
        let largest = self.largest(column);
        self.entries(column)
            .filter_map(|(row, value)| self.rated(row as usize, column, value, largest))
            .reduce(|a, b| if b.is_better_than(&a) { b } else { a })
    }

    fn candidate(&self, row: usize, column: usize) -> Option<Candidate> {
        let mut entries = self.entries(column);
        let entry = entries.find(|entry| entry.0 as usize == row)?;
        self.rated(row, column, entry.1, self.largest(column))
    }

    /// An entry as a pivot; `None` if it is too small, or of a later
    /// stage.
    fn rated(&self, row: usize, column: usize, value: T, largest: f64) -> Option<Candidate> {
        let is_late = self.by_rows.is_hidden(row) || self.by_columns.is_hidden(column);
        let fits = largest > ZERO && value.size() >= THRESHOLD * largest && !is_late;
        fits.then(|| Candidate {
            index: (row, column),
            cost: (self.rows.of(row).len() - 1) * (self.by_columns.length(column) - 1),
            size: value.size() / largest,
        })
    }

    /// Eliminates the pivot at (row, column) from all other rows.
    fn eliminate(&mut self, row: usize, column: usize) {
        self.take_over(column);
        let pivot_column = self.columns.of(column).to_vec();
        let pivot_row = self.rows.of(row).to_vec();
        self.columns.clear(column);
        self.rows.clear(row);
        self.by_columns.remove(column);
        self.by_rows.remove(row);
        let pivot = pivot_column.iter().find(|entry| entry.0 as usize == row);
        let pivot = pivot.map_or(T::ONE, |entry| entry.1);
        let others = pivot_column.iter().filter(|entry| entry.0 as usize != row);
        let factors: Vec<_> = others.map(|&(i, value)| (i, value / pivot)).collect();
        for (slot, &(i, _)) in factors.iter().enumerate() {
            self.slots[i as usize] = slot as u32 + 1;
            let of_row = self.rows.of(i as usize).iter();
            if let Some(at) = of_row.clone().position(|&j| j as usize == column) {
                self.rows.remove(i as usize, at);
            }
        }
        let mut met = vec![u32::MAX; factors.len()];
        for &j in pivot_row.iter().filter(|&&j| j as usize != column) {
            self.update(row, j, &factors, &mut met);
        }
        for &(i, _) in &factors {
            let i = i as usize;
            self.slots[i] = 0;
            self.by_rows.change(i, self.rows.of(i).len());
        }
    }

    /// `a_ij -= l_i a_pj` in column j, p being the row of the pivot.
    fn update(&mut self, row: usize, j: u32, factors: &[(u32, T)], met: &mut [u32]) {
        self.take_over(j as usize);
        let column = j as usize;
        let entries = self.columns.of(column).iter();
        let Some(at) = entries.clone().position(|entry| entry.0 as usize == row) else {
            return;
        };
        let (_, in_pivot_row) = self.columns.swap_remove(column, at);
        for (i, value) in self.columns.of_mut(column) {
            if let Some(slot) = self.slots[*i as usize].checked_sub(1) {
                *value -= factors[slot as usize].1 * in_pivot_row;
                met[slot as usize] = j;
            }
        }
        for (&(i, factor), _) in factors.iter().zip(&*met).filter(|it| *it.1 != j) {
            self.columns.push(column, (i, -factor * in_pivot_row));
            self.rows.push(i as usize, j);
        }
        self.by_columns
            .change(column, self.columns.of(column).len());
    }
}
