//! The pattern of the factors for given pivots, in dense blocks.
//!
//! Neighboring columns of L with (nearly) the same rows are one *panel*: a block of rows by
//! columns; the upper triangle of its diagonal block belongs to U. The columns of a panel are
//! computed in *strips* of [`LANES`]; above the panel, the columns of U in a strip are stored
//! in *segments*, each of consecutive rows that belong to one panel. Entries of a block outside
//! the exact pattern are zeros.
//!
//! Each list is contiguous and has small numbers: reading it takes time, as reading the factors
//! does.
//!
//! References: [Demmel1999], whose supernodes the panels are.

use std::ops::Range;
use std::sync::Arc;

use super::fill::Fill;
use super::order::inverse;
use super::pivots::Pivots;
use crate::number::LANES;
use crate::pattern::Pattern;

/// Maximum number of columns of a panel.
const WIDEST: usize = 16;
/// Maximum number of zeros of a panel, relative to its entries [-].
const SPARSE: f64 = 0.25;

/// A block of columns of L.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Panel {
    /// First column, and the one after the last.
    columns: [u32; 2],
    /// First of its rows in the list of all panels, and the one after the last.
    rows: [u32; 2],
    /// First of its values, row by row.
    pub values: usize,
}

impl Panel {
    /// First column, and the one after the last.
    #[inline(always)]
    pub fn columns(&self) -> (usize, usize) {
        (self.columns[0] as usize, self.columns[1] as usize)
    }
}

/// Columns of a panel that are computed together.
#[derive(Debug, Clone, Copy)]
pub(super) struct Strip {
    /// First column, and the one after the last.
    columns: [u32; 2],
    /// First of its segments in the list of all, and the one after the last.
    segments: [u32; 2],
    panel: u32,
}

impl Strip {
    /// First column, and the one after the last.
    #[inline(always)]
    pub fn columns(&self) -> (usize, usize) {
        (self.columns[0] as usize, self.columns[1] as usize)
    }

    /// Number of its panel.
    #[inline(always)]
    pub fn panel(&self) -> usize {
        self.panel as usize
    }
}

/// Consecutive rows of U, which belong to one panel.
#[derive(Debug, Clone, Copy)]
pub(super) struct Segment {
    panel: u32,
    /// First row, and the one after the last.
    rows: [u32; 2],
    /// First of its values, in numbers of lanes.
    values: u32,
}

impl Segment {
    /// Number of the panel.
    #[inline(always)]
    pub fn panel(&self) -> usize {
        self.panel as usize
    }

    /// First row, and the one after the last.
    #[inline(always)]
    pub fn rows(&self) -> (usize, usize) {
        (self.rows[0] as usize, self.rows[1] as usize)
    }

    /// First of its values, in numbers of lanes.
    #[inline(always)]
    pub fn values(&self) -> usize {
        self.values as usize
    }
}

/// An independent part of the computation: a branch of the tree of elimination, or the rest
/// after the branches.
#[derive(Debug, Clone, Default)]
pub(super) struct Part {
    pub columns: Range<usize>,
    pub panels: Range<usize>,
    pub strips: Range<usize>,
    /// Its values of L.
    pub lower: Range<usize>,
    /// Its values of U, in numbers of lanes.
    pub upper: Range<usize>,
}

/// The pattern of the factors.
#[derive(Debug, Clone)]
pub(super) struct Structure {
    pub panels: Vec<Panel>,
    pub strips: Vec<Strip>,
    pub segments: Vec<Segment>,
    panel_rows: Vec<u32>,
    pub pattern: Arc<Pattern>,
    /// Rows and columns in the order of elimination.
    pub pivots: Pivots,
    /// Index of each row in that order.
    pub row_indices: Vec<u32>,
    /// Numbers in all panels.
    pub panel_values: usize,
    /// Lanes in all segments.
    pub segment_values: usize,
    /// Independent parts.
    pub branches: Vec<Part>,
    /// The rest, computed after them.
    pub trunk: Part,
}

impl Structure {
    /// The pattern for given pivots, the pivots of independent branches first.
    pub fn new(pattern: &Arc<Pattern>, pivots: Pivots, branches: &[Range<usize>]) -> Self {
        let mut structure = Self {
            panels: Vec::new(),
            strips: Vec::new(),
            segments: Vec::new(),
            panel_rows: Vec::new(),
            pattern: Arc::clone(pattern),
            row_indices: inverse(&pivots.rows),
            pivots,
            panel_values: 0,
            segment_values: 0,
            branches: Vec::new(),
            trunk: Part::default(),
        };
        let fill = Fill::new(pattern, structure.columns(), &structure.row_indices);
        structure.find_panels(&fill, branches);
        structure.find_strips(&fill);
        structure.find_parts(branches);
        structure.segments.shrink_to_fit();
        structure.panel_rows.shrink_to_fit();
        structure
    }

    /// All rows of a panel, the rows of its columns first.
    #[inline(always)]
    pub fn rows_of(&self, panel: &Panel) -> &[u32] {
        &self.panel_rows[panel.rows[0] as usize..panel.rows[1] as usize]
    }

    /// Columns in the order of elimination.
    #[inline(always)]
    pub fn columns(&self) -> &[u32] {
        &self.pivots.columns
    }

    /// Indices of the entries of the column that is eliminated k-th.
    #[inline(always)]
    pub fn entries(&self, k: usize) -> Range<usize> {
        self.pattern.column(self.columns()[k] as usize)
    }

    /// Rows of U above a strip.
    #[inline(always)]
    pub fn segments_of(&self, strip: &Strip) -> &[Segment] {
        &self.segments[strip.segments[0] as usize..strip.segments[1] as usize]
    }

    /// Joins columns to panels while few zeros have to be stored; no panel crosses the end of a
    /// branch.
    fn find_panels(&mut self, fill: &Fill, branches: &[Range<usize>]) {
        let n = fill.lower.count();
        let mut first = 0;
        while first < n {
            let mut below = fill.lower.of(first).to_vec();
            let (mut end, mut exact) = (first + 1, below.len());
            let border = branches.iter().find(|branch| branch.end > first);
            let last = n.min(first + WIDEST).min(border.map_or(n, |it| it.end));
            while end < last {
                let joined = union(&below, fill.lower.of(end), end);
                let width = end + 1 - first;
                let stored = joined.len() * width + width * (width - 1) / 2;
                exact += fill.lower.of(end).len();
                if (stored - exact) as f64 > SPARSE * stored as f64 {
                    break;
                }
                below = joined;
                end += 1;
            }
            let from = self.panel_rows.len();
            let own = first as u32..end as u32;
            self.panel_rows.extend(own.clone());
            let others = below.into_iter().filter(|row| *row >= own.end);
            self.panel_rows.extend(others);
            let rows = [from as u32, self.panel_rows.len() as u32];
            let values = self.panel_values;
            self.panel_values += (self.panel_rows.len() - from) * (end - first);
            self.panels.push(Panel {
                columns: [own.start, own.end],
                rows,
                values,
            });
            first = end;
        }
    }

    fn find_strips(&mut self, fill: &Fill) {
        let mut panel_of = vec![0; fill.lower.count()];
        for (index, panel) in self.panels.iter().enumerate() {
            panel_of[panel.columns().0..panel.columns().1].fill(index as u32);
        }
        let mut above = Vec::new();
        for index in 0..self.panels.len() {
            let (begin, end) = self.panels[index].columns();
            let mut first = begin;
            while first < end {
                let columns = first..end.min(first + LANES);
                above.clear();
                let of_columns = columns.clone().flat_map(|k| fill.upper.of(k));
                above.extend(of_columns.filter(|row| **row < first as u32));
                above.extend(begin as u32..first as u32);
                above.sort_unstable();
                above.dedup();
                let segments = self.segments.len() as u32;
                self.add_segments(&above, first, &panel_of);
                self.strips.push(Strip {
                    columns: [first as u32, columns.end as u32],
                    segments: [segments, self.segments.len() as u32],
                    panel: index as u32,
                });
                first = columns.end;
            }
        }
    }

    /// The rows `above` the column `first`, in segments.
    fn add_segments(&mut self, above: &[u32], first: usize, panel_of: &[u32]) {
        let mut last = None;
        for &row in above {
            let panel = panel_of[row as usize];
            if last.replace(panel) == Some(panel) {
                continue;
            }
            let end = self.panels[panel as usize].columns[1].min(first as u32);
            self.segments.push(Segment {
                panel,
                rows: [row, end],
                values: self.segment_values as u32,
            });
            self.segment_values += (end - row) as usize;
        }
    }

    fn find_parts(&mut self, branches: &[Range<usize>]) {
        let n = self.columns().len();
        let mut last = Part::default();
        let mut next = |end: usize| {
            let panels = self.panels.partition_point(|it| it.columns().0 < end);
            let strips = self.strips.partition_point(|it| it.columns().0 < end);
            let lower = self.panels.get(panels);
            let upper = self.strips.get(strips).map(|it| it.segments[0] as usize);
            let upper = upper.and_then(|at| self.segments.get(at));
            last = Part {
                columns: last.columns.end..end,
                panels: last.panels.end..panels,
                strips: last.strips.end..strips,
                lower: last.lower.end..lower.map_or(self.panel_values, |it| it.values),
                upper: last.upper.end..upper.map_or(self.segment_values, Segment::values),
            };
            last.clone()
        };
        let parts: Vec<_> = branches.iter().map(|branch| next(branch.end)).collect();
        // It has access to all values.
        self.trunk = next(n);
        self.branches = parts;
    }
}

/// Union of both sorted lists, from row `from` on.
fn union(a: &[u32], b: &[u32], from: usize) -> Vec<u32> {
    let rows = a.iter().chain(b).copied();
    let mut all: Vec<_> = rows.filter(|&i| i as usize > from).collect();
    all.sort_unstable();
    all.dedup();
    all
}
