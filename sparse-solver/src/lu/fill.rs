//! The exact pattern of the factors for given pivots.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::pattern::Pattern;

/// Rows of many columns, one column after the other.
#[derive(Debug)]
pub(super) struct Columns {
    starts: Vec<u32>,
    rows: Vec<u32>,
}

impl Columns {
    fn new(count: usize) -> Self {
        let mut starts = Vec::with_capacity(count + 1);
        starts.push(0);
        Self {
            starts,
            rows: Vec::new(),
        }
    }

    fn push(&mut self, rows: &[u32]) {
        self.rows.extend_from_slice(rows);
        self.starts.push(self.rows.len() as u32);
    }

    /// Number of columns.
    pub fn count(&self) -> usize {
        self.starts.len() - 1
    }

    /// Rows of a column.
    pub fn of(&self, column: usize) -> &[u32] {
        &self.rows[self.starts[column] as usize..self.starts[column + 1] as usize]
    }
}

/// Exact patterns of the columns of the factors, ascending.
pub(super) struct Fill {
    /// Rows of L, below the diagonal.
    pub lower: Columns,
    /// Rows of U, above the diagonal.
    pub upper: Columns,
}

impl Fill {
    /// Column k has the rows of its entries, and for each row j of them above the diagonal the
    /// rows of column j of L. The columns of the matrix are given in the order of elimination,
    /// and the index of each row in it.
    pub fn new(pattern: &Pattern, columns: &[u32], row_indices: &[u32]) -> Self {
        let n = columns.len();
        let (mut lower, mut upper) = (Columns::new(n), Columns::new(n));
        let mut met = vec![u32::MAX; n];
        let mut open = BinaryHeap::new();
        let (mut above, mut below) = (Vec::new(), Vec::new());
        for k in 0..n as u32 {
            above.clear();
            below.clear();
            let mut add = |row: u32, open: &mut BinaryHeap<_>, below: &mut Vec<_>| {
                if std::mem::replace(&mut met[row as usize], k) != k {
                    match row.cmp(&k) {
                        std::cmp::Ordering::Less => open.push(Reverse(row)),
                        std::cmp::Ordering::Equal => {}
                        std::cmp::Ordering::Greater => below.push(row),
                    }
                }
            };
            let entries = pattern.column(columns[k as usize] as usize);
            for &row in &pattern.rows()[entries] {
                add(row_indices[row as usize], &mut open, &mut below);
            }
            while let Some(Reverse(j)) = open.pop() {
                above.push(j);
                let rows = lower.of(j as usize).iter();
                rows.for_each(|&row| add(row, &mut open, &mut below));
            }
            below.sort_unstable();
            lower.push(&below);
            upper.push(&above);
        }
        Self { lower, upper }
    }
}
