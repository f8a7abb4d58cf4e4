//! Rows and entries of an element in the system, determined once, and the buffers in which elements
//! are evaluated.

use std::ops::Range;

use nalgebra::DMatrix;

use super::kind::Kind;

use crate::assembly::Pattern;
use crate::elements::{Element, LocalJacobian, LocalResidual, LocalRun, LocalSize, Queries};
use crate::model::{NODE_UNKNOWNS, NodeMotion, Numbering};

/// Indices of one element in the vectors and matrices of the system.
#[derive(Debug, Clone)]
pub(super) struct Layout {
    /// Row in the system of each local row.
    pub rows: Vec<usize>,
    /// Index of the kind of the element.
    pub kind: usize,
    /// The first node if the nodes are consecutive.
    pub consecutive: Option<usize>,
    /// Number of nodes.
    nodes: usize,
    /// Index in the pattern of the first entry of each run of the kind.
    indices: Vec<u32>,
}

impl Layout {
    /// Rows of the element with index `index`: of its nodes, then its multipliers, then its
    /// scalars.
    pub fn rows(element: &dyn Element, index: usize, numbering: &Numbering) -> Vec<usize> {
        let of_nodes = element.nodes().iter().flat_map(|&node| {
            let first = numbering.node(node);
            first..first + NODE_UNKNOWNS
        });
        let first = numbering.first_multiplier_of(index);
        of_nodes
            .chain(first..first + element.multipliers())
            .chain((numbering.scalars_of(index).iter()).map(|i| numbering.first_scalar() + i))
            .collect()
    }

    /// The layout of an element of the kind with index `index` on `rows`.
    pub fn new(rows: Vec<usize>, (index, kind): (usize, &Kind), pattern: &Pattern) -> Self {
        let nodes = kind.size.nodes;
        let firsts = rows[..NODE_UNKNOWNS * nodes].iter().step_by(NODE_UNKNOWNS);
        let follows = |(at, first): (usize, &usize)| *first == rows[0] + NODE_UNKNOWNS * at;
        let consecutive = nodes > 0 && firsts.enumerate().all(follows);
        let entry = |run: &LocalRun| {
            let (row, column) = (
                run.first as usize % rows.len(),
                run.first as usize / rows.len(),
            );
            // The pattern has the entries of all elements.
            pattern.index(rows[row], rows[column]).unwrap_or_default() as u32
        };
        Self {
            kind: index,
            consecutive: consecutive.then(|| rows[0] / NODE_UNKNOWNS),
            nodes,
            indices: kind.runs.iter().map(entry).collect(),
            rows,
        }
    }

    /// Adds a local vector to the system's, for the rows that `sum` contains.
    pub fn add_vector(&self, local: &[f64], within: Within, sum: &mut [f64]) {
        if !within.is_whole {
            for (&row, value) in self.rows.iter().zip(local) {
                let at = row.wrapping_sub(within.first);
                if let Some(sum) = sum.get_mut(at) {
                    *sum += value;
                }
            }
            return;
        }
        let (of_nodes, own) = local.split_at(NODE_UNKNOWNS * self.nodes);
        let (values, _) = of_nodes.as_chunks::<NODE_UNKNOWNS>();
        for (i, values) in values.iter().enumerate() {
            let index = match self.consecutive {
                Some(first) => NODE_UNKNOWNS * (first + i),
                None => self.rows[NODE_UNKNOWNS * i],
            };
            let sums = &mut sum[index - within.first..];
            add_some::<NODE_UNKNOWNS>(sums, values, |sum, value| sum + value);
        }
        if own.is_empty() {
            return;
        }
        let rows = &self.rows[of_nodes.len()..];
        for (&row, value) in rows.iter().zip(own) {
            sum[row - within.first] += value;
        }
    }

    /// Adds `by_unknowns F_y + by_rates F_y'` in the columns of nodes and of scalars with a rate,
    /// and `by_algebraic F_y` in all other columns, for the entries that `sum` contains.
    pub fn add_weighted(
        &self,
        kind: &Kind,
        local: &LocalJacobian,
        [by_unknowns, by_rates, by_algebraic]: [f64; 3],
        (within, sum): (Within, &mut [f64]),
    ) {
        let (differential, algebraic) = kind.runs.split_at(kind.differential);
        let indices = self.indices.split_at(kind.differential);
        let differential = (differential, indices.0);
        let mut add = |runs, weight: f64, local: &DMatrix<f64>| match within.is_whole {
            _ if weight == 0.0 => {}
            true => add_runs::<true>(runs, weight, local, (within.first, sum)),
            false => add_runs::<false>(runs, weight, local, (within.first, sum)),
        };
        add(differential, by_unknowns, local.by_unknowns());
        if kind.rates {
            add(differential, by_rates, local.by_rates());
        }
        add((algebraic, indices.1), by_algebraic, local.by_unknowns());
    }
}

/// Index in a vector of its first available number, and whether all entries of an element are
/// available.
#[derive(Debug, Clone, Copy)]
pub(super) struct Within {
    pub first: usize,
    pub is_whole: bool,
}

impl Within {
    /// All entries are available.
    pub const ALL: Self = Self {
        first: 0,
        is_whole: true,
    };
}

/// Most runs are one or two equations of a node long: for these the length is known at compile
/// time. The sum contains the numbers from `first` on: all to which is added if `WHOLE`, otherwise
/// some of them. A run belongs to one column, of which all or no entries are available.
fn add_runs<const WHOLE: bool>(
    (runs, indices): (&[LocalRun], &[u32]),
    weight: f64,
    local: &DMatrix<f64>,
    (first, sum): (usize, &mut [f64]),
) {
    let local = local.as_slice();
    for (run, &to) in runs.iter().zip(indices) {
        let (from, count) = (run.first as usize, run.count as usize);
        let to = (to as usize).wrapping_sub(first);
        if !WHOLE && to >= sum.len() {
            continue;
        }
        let (values, sums) = (&local[from..from + count], &mut sum[to..to + count]);
        let weighted = |sum: f64, value: f64| sum + weight * value;
        match count {
            3 => add_some::<3>(sums, values, weighted),
            6 => add_some::<6>(sums, values, weighted),
            _ => {
                for (sum, value) in sums.iter_mut().zip(values) {
                    *sum = weighted(*sum, *value);
                }
            }
        }
    }
}

/// Adds the first N numbers.
#[inline(always)]
fn add_some<const N: usize>(sums: &mut [f64], values: &[f64], add: impl Fn(f64, f64) -> f64) {
    if let (Some(sums), Some(values)) = (sums.first_chunk_mut::<N>(), values.first_chunk::<N>()) {
        let old = *sums;
        *sums = std::array::from_fn(|i| add(old[i], values[i]));
    }
}

/// Buffers for the evaluation of elements, overwritten by each use.
#[derive(Debug, Clone)]
pub struct Workspace {
    /// Buffers of the parts that are summed in parallel.
    pub(super) parts: Vec<Part>,
    /// Buffers for single elements.
    pub(super) buffers: Buffers,
}

/// Buffers for the elements that add to a range of unknowns.
#[derive(Debug, Clone)]
pub(super) struct Part {
    pub unknowns: Range<usize>,
    /// Indices of these elements, and whether all their entries are in the range; `None` if they
    /// are all elements.
    pub elements: Option<Vec<(u32, bool)>>,
    pub buffers: Buffers,
}

/// Buffers for one element at a time.
#[derive(Debug, Clone)]
pub(super) struct Buffers {
    pub gathered: Gathered,
    /// One for each kind.
    pub of_kinds: Vec<Buffer>,
}

/// Copies of the motions and scalars of an element that are not consecutive in a state.
#[derive(Debug, Clone, Default)]
pub(super) struct Gathered {
    pub motions: Vec<NodeMotion>,
    pub scalars: Vec<f64>,
    pub rates: Vec<f64>,
}

/// Residual and Jacobian of an element.
#[derive(Debug, Clone)]
pub(super) struct Buffer {
    pub residual: LocalResidual,
    pub jacobian: LocalJacobian,
}

impl Buffers {
    /// Buffers for elements of the given kinds.
    pub fn new(kinds: &[Kind]) -> Self {
        let most = |count: fn(&LocalSize) -> usize| {
            let counts = kinds.iter().map(|kind| count(&kind.size));
            counts.max().unwrap_or(0)
        };
        let buffer = |kind: &Kind| Buffer {
            residual: LocalResidual::new(kind.size),
            jacobian: LocalJacobian::unmarked(kind.size),
        };
        let scalars = most(|size| size.scalars);
        Self {
            gathered: Gathered {
                motions: Vec::with_capacity(most(|size| size.nodes)),
                scalars: Vec::with_capacity(scalars),
                rates: Vec::with_capacity(scalars),
            },
            of_kinds: kinds.iter().map(buffer).collect(),
        }
    }
}
