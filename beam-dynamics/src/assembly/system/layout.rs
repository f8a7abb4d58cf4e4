//! Where the equations and unknowns of an element stand in the system, found once, and
//! the room in which elements are evaluated.

use std::ops::Range;

use nalgebra::DMatrix;

use crate::assembly::Pattern;
use crate::elements::{Element, LocalJacobian, LocalResidual, LocalSize, Queries};
use crate::model::{NODE_UNKNOWNS, NodeMotion, Numbering};

/// Places of one element in the vectors and matrices of the system.
#[derive(Debug, Clone)]
pub(super) struct Layout {
    /// Place in the system of each local row.
    pub places: Vec<usize>,
    /// Which room of the workspace has the size of the element.
    pub room: usize,
    /// Whether the element hangs on rates.
    pub rates: bool,
    /// The first node where the nodes follow each other.
    pub consecutive: Option<usize>,
    /// Number of nodes.
    nodes: usize,
    /// Entries in the columns of nodes.
    of_nodes: Vec<Run>,
    /// Entries in the columns of multipliers, and of scalars without rate.
    algebraic: Vec<Run>,
    /// Entries in the columns of scalars with a rate.
    with_rate: Vec<Run>,
}

/// Entries that follow each other in a column of the local Jacobian, and in the pattern.
#[derive(Debug, Clone, Copy)]
struct Run {
    /// First entry in the local matrix, column by column.
    local: u32,
    /// First entry in the pattern.
    place: u32,
    count: u32,
}

impl Layout {
    /// Rows of element number `index`: those of its nodes, then its multipliers, then its
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

    /// The layout of an element of `nodes` nodes on the rows `places`, the last of which are
    /// of scalars that have a rate or have none; it touched the entries of `jacobian`.
    pub fn new(
        places: Vec<usize>,
        (nodes, has_rate): (usize, &[bool]),
        room: usize,
        jacobian: &LocalJacobian,
        pattern: &Pattern,
    ) -> Self {
        let columns_of_nodes = NODE_UNKNOWNS * nodes;
        let firsts = || places[..columns_of_nodes].iter().step_by(NODE_UNKNOWNS);
        let follows = |(at, first): (usize, &usize)| *first == places[0] + NODE_UNKNOWNS * at;
        let consecutive = nodes > 0 && firsts().enumerate().all(follows);
        let runs = |columns| runs(&places, columns, jacobian.touched(), pattern);
        let first_scalar = places.len() - has_rate.len();
        let (mut algebraic, mut with_rate) = (Vec::new(), Vec::new());
        algebraic.extend(runs(columns_of_nodes..first_scalar));
        for (column, has_rate) in (first_scalar..).zip(has_rate) {
            let kind = if *has_rate {
                &mut with_rate
            } else {
                &mut algebraic
            };
            kind.extend(runs(column..column + 1));
        }
        Self {
            of_nodes: runs(0..columns_of_nodes),
            algebraic,
            with_rate,
            room,
            rates: jacobian.touches_rates(),
            consecutive: consecutive.then(|| places[0] / NODE_UNKNOWNS),
            nodes,
            places,
        }
    }

    /// Adds a local vector to that of the system.
    pub fn add_vector(&self, local: &[f64], sum: &mut [f64]) {
        let (of_nodes, own) = local.split_at(NODE_UNKNOWNS * self.nodes);
        let (values, _) = of_nodes.as_chunks::<NODE_UNKNOWNS>();
        for (i, values) in values.iter().enumerate() {
            let place = match self.consecutive {
                Some(first) => NODE_UNKNOWNS * (first + i),
                None => self.places[NODE_UNKNOWNS * i],
            };
            add_some::<NODE_UNKNOWNS>(&mut sum[place..], values, |sum, value| sum + value);
        }
        if own.is_empty() {
            return;
        }
        let places = &self.places[of_nodes.len()..];
        for (&place, value) in places.iter().zip(own) {
            sum[place] += value;
        }
    }

    /// Adds a local matrix to the entries of one of the system.
    pub fn add_matrix(&self, local: &DMatrix<f64>, sum: &mut [f64]) {
        add_runs(&self.of_nodes, 1.0, local, sum);
        add_runs(&self.algebraic, 1.0, local, sum);
        add_runs(&self.with_rate, 1.0, local, sum);
    }

    /// Adds `by_unknowns F_y + by_rates F_y'` in the columns of nodes and of scalars
    /// with a rate, and `by_algebraic F_y` in those of all others.
    pub fn add_weighted(
        &self,
        local: &LocalJacobian,
        [by_unknowns, by_rates, by_algebraic]: [f64; 3],
        sum: &mut [f64],
    ) {
        add_runs(&self.of_nodes, by_unknowns, local.by_unknowns(), sum);
        add_runs(&self.with_rate, by_unknowns, local.by_unknowns(), sum);
        if self.rates {
            add_runs(&self.of_nodes, by_rates, local.by_rates(), sum);
            add_runs(&self.with_rate, by_rates, local.by_rates(), sum);
        }
        add_runs(&self.algebraic, by_algebraic, local.by_unknowns(), sum);
    }
}

fn runs(
    places: &[usize],
    columns: Range<usize>,
    touched: &DMatrix<bool>,
    pattern: &Pattern,
) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    for j in columns {
        for i in (0..places.len()).filter(|&i| touched[(i, j)]) {
            let Some(place) = pattern.place(places[i], places[j]) else {
                continue;
            };
            let (local, place) = ((i + places.len() * j) as u32, place as u32);
            let next =
                |run: &&mut Run| local == run.local + run.count && place == run.place + run.count;
            match runs.last_mut().filter(next) {
                Some(run) => run.count += 1,
                None => runs.push(Run {
                    local,
                    place,
                    count: 1,
                }),
            }
        }
    }
    runs
}

/// Most runs are one or two equations of a node long: for these the length is known when
/// this is compiled.
fn add_runs(runs: &[Run], weight: f64, local: &DMatrix<f64>, sum: &mut [f64]) {
    let local = local.as_slice();
    for run in runs {
        let (from, to, count) = (run.local as usize, run.place as usize, run.count as usize);
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

/// Room for the evaluation of elements: what it holds is written anew at each use.
#[derive(Debug, Clone)]
pub struct Workspace {
    pub(super) gathered: Gathered,
    pub(super) rooms: Vec<Room>,
}

/// Copies of the motions and scalars of an element that do not follow each other in a state.
#[derive(Debug, Clone, Default)]
pub(super) struct Gathered {
    pub motions: Vec<NodeMotion>,
    pub scalars: Vec<f64>,
    pub rates: Vec<f64>,
}

/// Residual and Jacobian of an element.
#[derive(Debug, Clone)]
pub(super) struct Room {
    pub residual: LocalResidual,
    pub jacobian: LocalJacobian,
}

impl Workspace {
    /// Room for elements of the given sizes.
    pub(super) fn new(sizes: &[LocalSize]) -> Self {
        let most = |count: fn(&LocalSize) -> usize| sizes.iter().map(count).max().unwrap_or(0);
        let room = |&size: &LocalSize| Room {
            residual: LocalResidual::new(size),
            jacobian: LocalJacobian::unmarked(size),
        };
        let scalars = most(|size| size.scalars);
        Self {
            gathered: Gathered {
                motions: Vec::with_capacity(most(|size| size.nodes)),
                scalars: Vec::with_capacity(scalars),
                rates: Vec::with_capacity(scalars),
            },
            rooms: sizes.iter().map(room).collect(),
        }
    }
}
