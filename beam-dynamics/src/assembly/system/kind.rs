//! Kinds of elements: elements with the same nonzero entries in their Jacobians.

use std::collections::HashMap;

use crate::assembly::Variation;
use crate::elements::{LocalJacobian, LocalRun, LocalSize};
use crate::model::{NODE_UNKNOWNS, Variable};

/// Nonzero entries in the Jacobians of the elements of a kind.
#[derive(Debug, Clone)]
pub(super) struct Kind {
    pub size: LocalSize,
    /// Whether they depend on rates.
    pub rates: bool,
    /// Entries in the columns of nodes and of scalars with a rate, then entries in the columns of
    /// multipliers and of scalars without.
    pub runs: Vec<LocalRun>,
    /// Number of the former.
    pub differential: usize,
    /// All entries, with the gaps of a few zeros between them: fewer and longer runs.
    spans: Vec<LocalRun>,
    /// Entries in the first column of each vector of each node; the entries in the other two columns
    /// are next to them.
    turned: Vec<[Vec<LocalRun>; 4]>,
}

impl Kind {
    /// The kind of an element that touched the entries of `jacobian`; `has_rate` of each of
    /// its scalars.
    fn new(jacobian: &LocalJacobian, has_rate: &[bool]) -> Self {
        let size = jacobian.size();
        let rows = size.rows();
        let first_scalar = rows - size.scalars;
        let is_differential = |column: usize| match column.checked_sub(first_scalar) {
            Some(scalar) => has_rate[scalar],
            None => column < NODE_UNKNOWNS * size.nodes,
        };
        let of = |column: usize| runs(jacobian, column);
        let (with_rate, without): (Vec<_>, Vec<_>) = (0..rows).partition(|&j| is_differential(j));
        let mut all: Vec<_> = with_rate.into_iter().flat_map(of).collect();
        let differential = all.len();
        all.extend(without.into_iter().flat_map(of));
        let of_vectors =
            |i: usize| Variable::UNKNOWNS.map(|vector| of(NODE_UNKNOWNS * i + vector.column()));
        Self {
            size,
            rates: jacobian.touches_rates(),
            turned: (0..size.nodes).map(of_vectors).collect(),
            spans: spans(&all),
            runs: all,
            differential,
        }
    }

    /// Row and column of each entry.
    pub fn entries(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let rows = self.size.rows();
        let indices = self.runs.iter().flat_map(|run| run.range());
        indices.map(move |index| (index % rows, index / rows))
    }

    /// Makes a Jacobian of the kind zero.
    pub fn clear(&self, jacobian: &mut LocalJacobian) {
        jacobian.clear(&self.spans);
    }

    /// Converts the derivatives by the motion of node `i` of an element into derivatives by the
    /// unknowns of a formula (D-130).
    pub fn turn(&self, i: usize, by: &Variation, jacobian: &mut LocalJacobian) {
        for (vector, touched) in Variable::UNKNOWNS.into_iter().zip(&self.turned[i]) {
            let matrices = match vector {
                Variable::Rotation => Some([by.turn, by.rate_by_turn]),
                _ => by.axes,
            };
            if let Some(matrices) = &matrices {
                jacobian.turn((i, vector), touched, matrices);
            }
        }
    }
}

/// Longest gap between two runs that are cleared together: storing zeros costs less than the
/// next call.
const GAP: u32 = 16;

/// Runs that contain all the given ones, in ascending order.
fn spans(runs: &[LocalRun]) -> Vec<LocalRun> {
    let mut sorted = runs.to_vec();
    sorted.sort_unstable_by_key(|run| run.first);
    let mut spans: Vec<LocalRun> = Vec::new();
    for run in sorted {
        let end = run.first + run.count;
        match spans.last_mut() {
            Some(span) if run.first <= span.first + span.count + GAP => {
                span.count = span.count.max(end - span.first);
            }
            _ => spans.push(run),
        }
    }
    spans
}

/// Touched entries of a column: of one node, of the multipliers, or of one scalar, each of which
/// are consecutive in the system too.
fn runs(jacobian: &LocalJacobian, column: usize) -> Vec<LocalRun> {
    let size = jacobian.size();
    let rows = size.rows();
    let of_nodes = NODE_UNKNOWNS * size.nodes;
    let group = |row: usize| match row {
        _ if row < of_nodes => row / NODE_UNKNOWNS,
        _ if row < of_nodes + size.multipliers => size.nodes,
        _ => row,
    };
    let mut runs: Vec<LocalRun> = Vec::new();
    let mut last = None;
    for row in (0..rows).filter(|&row| jacobian.touched()[(row, column)]) {
        let follows = last.is_some_and(|last| last + 1 == row && group(last) == group(row));
        match runs.last_mut().filter(|_| follows) {
            Some(run) => run.count += 1,
            None => runs.push(LocalRun {
                first: (row + rows * column) as u32,
                count: 1,
            }),
        }
        last = Some(row);
    }
    runs
}

/// Kinds found so far.
#[derive(Debug, Default)]
pub(super) struct Kinds {
    pub all: Vec<Kind>,
    known: HashMap<Mark, usize>,
}

/// Properties that elements of one kind share: size, whether scalars have rates, whether
/// derivatives by rates are touched, entries touched.
type Mark = (LocalSize, Vec<bool>, bool, Vec<bool>);

impl Kinds {
    /// Index of the kind of an element that touched the entries of `jacobian`.
    pub fn index(&mut self, jacobian: &LocalJacobian, has_rate: Vec<bool>) -> usize {
        let touched = jacobian.touched().as_slice().to_vec();
        let mark = (jacobian.size(), has_rate, jacobian.touches_rates(), touched);
        if let Some(&index) = self.known.get(&mark) {
            return index;
        }
        self.all.push(Kind::new(jacobian, &mark.1));
        self.known.insert(mark, self.all.len() - 1);
        self.all.len() - 1
    }
}
