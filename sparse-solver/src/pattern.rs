//! A sparsity pattern that is found once, and the matrices that share it.

use std::ops::Range;
use std::sync::Arc;

/// Pattern of a square sparse matrix in compressed columns.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Pattern {
    size: usize,
    column_starts: Vec<usize>,
    rows: Vec<u32>,
}

impl Pattern {
    /// The pattern of the given entries (row, column); repeated ones count once.
    pub fn new(size: usize, indices: Vec<(usize, usize)>) -> Self {
        Self::of(size, |add| {
            let indices = indices.iter();
            indices.for_each(|&(row, column)| add(row, column));
        })
    }

    /// The pattern of the entries (row, column) that `each` adds, in any order; repeated ones
    /// count once. `each` is called twice, so that no list of all entries is needed.
    pub fn of(size: usize, each: impl Fn(&mut dyn FnMut(usize, usize))) -> Self {
        let mut ends = vec![0; size + 1];
        each(&mut |_, column| ends[column + 1] += 1);
        for column in 0..size {
            ends[column + 1] += ends[column];
        }
        let mut rows = vec![0_u32; ends[size]];
        // Each column begins where the previous one ends, once all are filled.
        each(&mut |row, column| {
            rows[ends[column]] = row as u32;
            ends[column] += 1;
        });
        let mut column_starts = Vec::with_capacity(size + 1);
        let (mut begin, mut kept) = (0, 0);
        for &end in &ends[..size] {
            column_starts.push(kept);
            rows[begin..end].sort_unstable();
            let mut last = None;
            for at in begin..end {
                if last != Some(rows[at]) {
                    last = Some(rows[at]);
                    rows[kept] = rows[at];
                    kept += 1;
                }
            }
            begin = end;
        }
        column_starts.push(kept);
        rows.truncate(kept);
        rows.shrink_to_fit();
        Self {
            size,
            column_starts,
            rows,
        }
    }

    /// Number of rows and of columns.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Number of stored entries.
    pub fn entries(&self) -> usize {
        self.rows.len()
    }

    /// Start of each column among the entries, and the end.
    pub fn column_starts(&self) -> &[usize] {
        &self.column_starts
    }

    /// Indices of the entries of a column.
    pub fn column(&self, column: usize) -> Range<usize> {
        self.column_starts[column]..self.column_starts[column + 1]
    }

    /// Row of each entry, ascending in each column.
    pub fn rows(&self) -> &[u32] {
        &self.rows
    }

    /// Index of (row, column) among the entries, if it is stored.
    pub fn index(&self, row: usize, column: usize) -> Option<usize> {
        let range = self.column(column);
        let found = self.rows[range.clone()].binary_search(&(row as u32)).ok()?;
        Some(range.start + found)
    }
}

/// A sparse matrix on a shared pattern.
#[derive(Debug, Clone, PartialEq)]
pub struct Sparse {
    pattern: Arc<Pattern>,
    values: Vec<f64>,
}

impl Sparse {
    /// Zero.
    pub fn zero(pattern: Arc<Pattern>) -> Self {
        let values = vec![0.0; pattern.entries()];
        Self { pattern, values }
    }

    /// The pattern.
    pub fn pattern(&self) -> &Arc<Pattern> {
        &self.pattern
    }

    /// Stored values, in the order of the pattern.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Stored values, mutable.
    pub fn values_mut(&mut self) -> &mut [f64] {
        &mut self.values
    }

    /// The entry at (row, column), zero if it is not stored.
    pub fn entry(&self, row: usize, column: usize) -> f64 {
        let index = self.pattern.index(row, column);
        index.map_or(0.0, |index| self.values[index])
    }

    /// Adds `A x` to `y`.
    pub fn multiply_add(&self, x: &[f64], y: &mut [f64]) {
        let pattern = &self.pattern;
        for (column, &factor) in x.iter().enumerate() {
            for index in pattern.column(column) {
                y[pattern.rows[index] as usize] += self.values[index] * factor;
            }
        }
    }

    /// `self + factor other`, on the same pattern.
    ///
    /// # Panics
    /// If the patterns differ.
    pub fn plus(&self, factor: f64, other: &Self) -> Self {
        assert!(Arc::ptr_eq(&self.pattern, &other.pattern), "two patterns");
        let values = self.values.iter().zip(&other.values);
        Self {
            pattern: Arc::clone(&self.pattern),
            values: values.map(|(a, b)| a + factor * b).collect(),
        }
    }

    /// Stored entries as (row, column, value), column by column.
    pub fn triplets(&self) -> impl Iterator<Item = (usize, usize, f64)> + '_ {
        let pattern = &self.pattern;
        (0..pattern.size).flat_map(move |column| {
            let range = pattern.column(column);
            range.map(move |index| (pattern.rows[index] as usize, column, self.values[index]))
        })
    }
}
