//! The pattern of the factors, pivots being given, in blocks that the numbers fill.
//!
//! Neighboring columns of L with (nearly) the same rows are one *panel*: a block of
//! rows by columns, the upper triangle of its diagonal block being of U. The columns of
//! a panel are computed in *strips* of [`LANES`]; above the panel, the columns of U in
//! a strip are kept in *segments*, each of consecutive rows that belong to one panel.
//! Places of a block that the exact pattern leaves out hold zeros.
//!
//! References: [Demmel1999], whose supernodes the panels are.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::number::LANES;
use super::order::inverse;
use super::pivots::Pivots;
use crate::assembly::Pattern;

/// Most columns of a panel.
const WIDEST: usize = 16;
/// Zeros of a panel, relative to its entries [-].
const SPARSE: f64 = 0.25;

/// A block of columns of L.
#[derive(Debug, Clone, Default)]
pub(super) struct Panel {
    /// First column, and the one after the last.
    pub columns: (usize, usize),
    /// All rows, those of the columns first.
    pub rows: Vec<u32>,
    /// First of its values, row by row.
    pub values: usize,
}

/// Some columns of a panel, which are computed together.
#[derive(Debug, Clone)]
pub(super) struct Strip {
    /// First column, and the one after the last.
    pub columns: (usize, usize),
    pub panel: usize,
    /// Rows of U above the strip.
    pub segments: Vec<Segment>,
    /// Its columns in the matrix.
    pub entries: [Column; LANES],
}

/// Consecutive rows of U, which belong to one panel.
#[derive(Debug, Clone, Copy)]
pub(super) struct Segment {
    pub panel: usize,
    /// First row, and the one after the last.
    pub rows: (usize, usize),
    /// First of its values, in numbers of lanes.
    pub values: usize,
}

/// Entries of a column of the matrix, which follow each other in its pattern.
#[derive(Debug, Clone, Copy)]
pub(super) struct Column {
    /// First entry in the pattern of the matrix.
    pub place: u32,
    /// First entry among the rows of the structure.
    pub first: u32,
    pub count: u32,
}

/// The pattern of the factors.
#[derive(Debug, Clone, Default)]
pub(super) struct Structure {
    pub panels: Vec<Panel>,
    pub strips: Vec<Strip>,
    /// Row of each entry of the matrix in the order of elimination, strip by strip and
    /// column by column.
    pub rows: Vec<u32>,
    /// Numbers in all panels.
    pub panel_values: usize,
    /// Lanes in all segments.
    pub segment_values: usize,
}

impl Structure {
    pub fn new(pattern: &Pattern, pivots: &Pivots) -> Self {
        let permuted = Permuted::new(pattern, pivots);
        let fill = Fill::new(&permuted);
        let mut structure = Self::default();
        structure.find_panels(&fill);
        structure.find_strips(&permuted, &fill);
        structure
    }

    /// Joins columns to panels while few zeros have to be stored.
    fn find_panels(&mut self, fill: &Fill) {
        let n = fill.lower.len();
        let mut first = 0;
        while first < n {
            let mut below = fill.lower[first].clone();
            let (mut end, mut exact) = (first + 1, below.len());
            while end < n && end - first < WIDEST {
                let joined = union(&below, &fill.lower[end], end);
                let width = end + 1 - first;
                let stored = joined.len() * width + width * (width - 1) / 2;
                exact += fill.lower[end].len();
                if (stored - exact) as f64 > SPARSE * stored as f64 {
                    break;
                }
                below = joined;
                end += 1;
            }
            let rows: Vec<_> = (first..end)
                .chain(below.into_iter().filter(|&row| row >= end))
                .map(|row| row as u32)
                .collect();
            let values = self.panel_values;
            self.panel_values += rows.len() * (end - first);
            self.panels.push(Panel {
                columns: (first, end),
                rows,
                values,
            });
            first = end;
        }
    }

    fn find_strips(&mut self, permuted: &Permuted, fill: &Fill) {
        let mut panel_of = vec![0; fill.lower.len()];
        for (index, panel) in self.panels.iter().enumerate() {
            panel_of[panel.columns.0..panel.columns.1].fill(index);
        }
        for (index, panel) in self.panels.iter().enumerate() {
            let (mut first, end) = panel.columns;
            while first < end {
                let columns = (first, end.min(first + LANES));
                let mut above: Vec<_> = (columns.0..columns.1)
                    .flat_map(|k| fill.upper[k].iter().copied())
                    .chain(panel.columns.0..first)
                    .filter(|&row| row < first)
                    .collect();
                above.sort_unstable();
                above.dedup();
                let mut segments: Vec<Segment> = Vec::new();
                for row in above {
                    let panel = panel_of[row];
                    if segments.last().is_none_or(|last| last.panel != panel) {
                        let rows = (row, self.panels[panel].columns.1.min(first));
                        segments.push(Segment {
                            panel,
                            rows,
                            values: self.segment_values,
                        });
                        self.segment_values += rows.1 - rows.0;
                    }
                }
                let entries = std::array::from_fn(|lane| {
                    let column = permuted.columns.get(columns.0 + lane);
                    let column = column.filter(|_| columns.0 + lane < columns.1);
                    let entries = column.map_or(&[][..], |column| &column[..]);
                    let first = self.rows.len() as u32;
                    self.rows.extend(entries.iter().map(|entry| entry.0 as u32));
                    Column {
                        place: entries.first().map_or(0, |entry| entry.1 as u32),
                        first,
                        count: entries.len() as u32,
                    }
                });
                self.strips.push(Strip {
                    columns,
                    panel: index,
                    segments,
                    entries,
                });
                first = columns.1;
            }
        }
    }
}

/// Both sorted lists in one, from row `from` on.
fn union(a: &[usize], b: &[usize], from: usize) -> Vec<usize> {
    let mut all: Vec<_> = a.iter().chain(b).copied().filter(|&i| i > from).collect();
    all.sort_unstable();
    all.dedup();
    all
}

/// The matrix in the order of elimination.
struct Permuted {
    /// Row and place of the entries of each column.
    columns: Vec<Vec<(usize, usize)>>,
}

impl Permuted {
    fn new(pattern: &Pattern, pivots: &Pivots) -> Self {
        let rows = inverse(&pivots.rows);
        let column = |&column: &usize| {
            let range = pattern.column_starts()[column]..pattern.column_starts()[column + 1];
            range.map(|at| (rows[pattern.rows()[at]], at)).collect()
        };
        Self {
            columns: pivots.columns.iter().map(column).collect(),
        }
    }
}

/// Exact patterns of the columns of the factors, ascending.
struct Fill {
    /// Rows of L, below the diagonal.
    lower: Vec<Vec<usize>>,
    /// Rows of U, above the diagonal.
    upper: Vec<Vec<usize>>,
}

impl Fill {
    /// Column k has the rows of its entries, and for each row j of them above the
    /// diagonal the rows of column j of L.
    fn new(permuted: &Permuted) -> Self {
        let n = permuted.columns.len();
        let mut lower: Vec<Vec<usize>> = Vec::with_capacity(n);
        let mut upper = Vec::with_capacity(n);
        let mut met = vec![usize::MAX; n];
        let mut open = BinaryHeap::new();
        for (k, entries) in permuted.columns.iter().enumerate() {
            let (mut above, mut below) = (Vec::new(), Vec::new());
            let mut add = |row: usize, open: &mut BinaryHeap<_>, below: &mut Vec<_>| {
                if std::mem::replace(&mut met[row], k) != k {
                    match row.cmp(&k) {
                        std::cmp::Ordering::Less => open.push(Reverse(row)),
                        std::cmp::Ordering::Equal => {}
                        std::cmp::Ordering::Greater => below.push(row),
                    }
                }
            };
            let rows = entries.iter().map(|entry| entry.0);
            rows.for_each(|row| add(row, &mut open, &mut below));
            while let Some(Reverse(j)) = open.pop() {
                above.push(j);
                let rows = lower[j].iter();
                rows.for_each(|&row| add(row, &mut open, &mut below));
            }
            below.sort_unstable();
            lower.push(below);
            upper.push(above);
        }
        Self { lower, upper }
    }
}
