//! The constraints of one loop, and the loads in them that balance each other.

use nalgebra::DMatrix;

use super::basis;
use super::member::{MOTION, Member};
use super::tree::Tree;
use crate::assembly::Pattern;
use crate::assembly::system::{Loop, System, Workspace};
use crate::model::{Conditions, State};

/// The constraints of one loop.
#[derive(Debug, Clone)]
pub(super) struct Part {
    members: Vec<Member>,
    /// Indices of the multipliers.
    pub constraints: Vec<usize>,
    /// Force along a unit displacement by the multiplier of each constraint [-, 1/m].
    pub forces: Vec<f64>,
    /// The latest result for each constraint: `P mu`.
    pub found: Vec<f64>,
    /// Its `N^T mu`.
    along: Vec<f64>,
    /// N, column by column.
    basis: DMatrix<f64>,
    tree: Tree,
    /// A, and in its first columns Q; then P. Only if the tree method fails.
    all: Option<[DMatrix<f64>; 2]>,
    entries: Entries,
}

/// Entries of the pattern for the loads that balance each other: load after load, and for each
/// load constraint after constraint.
#[derive(Debug, Clone)]
struct Entries {
    /// In the rows of the constraints.
    gives: Vec<usize>,
    /// In the columns of their multipliers.
    takes: Vec<usize>,
    /// Of the loads themselves.
    own: Vec<usize>,
}

impl Entries {
    /// The rows and columns of the constraints and of the loads; `first` are the first indices of
    /// both.
    fn new(pattern: &Pattern, constraints: &[usize], first: [usize; 2], loads: usize) -> Self {
        let pairs = || (0..loads).flat_map(|k| constraints.iter().map(move |i| (*i, k)));
        let index = |row: usize, column: usize| pattern.index(row, column);
        Self {
            gives: pairs()
                .filter_map(|(i, k)| index(first[0] + i, first[1] + k))
                .collect(),
            takes: pairs()
                .filter_map(|(i, k)| index(first[1] + k, first[0] + i))
                .collect(),
            own: (0..loads)
                .filter_map(|k| index(first[1] + k, first[1] + k))
                .collect(),
        }
    }
}

impl Part {
    /// The part of a loop whose loads that balance each other have rows from `surplus` on.
    pub fn new(system: &System, of: &Loop, surplus: usize) -> Self {
        let mut nodes: Vec<usize> = Vec::new();
        let mut constraints = Vec::new();
        let members = of.elements.iter().map(|&index| {
            let own = system.elements[index].nodes().iter().map(|node| {
                let known = nodes.iter().position(|other| other == node);
                known.unwrap_or_else(|| {
                    nodes.push(*node);
                    nodes.len() - 1
                })
            });
            let own = own.collect();
            let first = constraints.len();
            constraints.extend(system.numbering.multipliers_of(index));
            Member::new(system, index, first, own)
        });
        let members: Vec<_> = members.collect();
        let (count, loads) = (constraints.len(), of.redundant.len());
        let first = [system.numbering.first_multiplier(), surplus];
        Self {
            tree: Tree::new(&members, nodes.len()),
            members,
            forces: vec![1.0; count],
            found: vec![0.0; count],
            along: vec![0.0; loads],
            basis: DMatrix::zeros(count, loads),
            all: None,
            entries: Entries::new(&system.pattern, &constraints, first, loads),
            constraints,
        }
    }

    /// Finds A and N at a state; rotations are scaled by `size` \[m\].
    pub fn update(
        &mut self,
        system: &System,
        at: (&State, &Conditions),
        size: f64,
        work: &mut Workspace,
    ) {
        for member in &mut self.members {
            member.read(system, at, size, work, &mut self.forces);
        }
        if !self.tree.find(&self.members, &mut self.basis) {
            self.look_at_all();
        }
    }

    /// N from all columns of A together; the time is cubic in the number of constraints.
    pub fn look_at_all(&mut self) {
        let (count, loads) = self.basis.shape();
        let nodes = self.members.iter().flat_map(|member| &member.nodes).max();
        let nodes = nodes.map_or(0, |last| last + 1);
        let [rows, shares] = self.all.get_or_insert_with(|| {
            [
                DMatrix::zeros(count, MOTION * nodes),
                DMatrix::zeros(count, count),
            ]
        });
        rows.fill(0.0);
        for member in &self.members {
            for (row, constraint) in member.constraints().enumerate() {
                for (index, node) in member.nodes.iter().enumerate() {
                    for i in 0..MOTION {
                        let entry = member.rows[(row, MOTION * index + i)];
                        rows[(constraint, MOTION * node + i)] += entry;
                    }
                }
            }
        }
        let found = basis::gather(rows, count - loads.min(count));
        basis::beside(rows, found, shares);
        let found = basis::gather(shares, loads);
        self.basis.fill(0.0);
        let mut basis = self.basis.columns_mut(0, found);
        basis.copy_from(&shares.columns(0, found));
    }

    /// P times the numbers `of` each constraint, given its index and its force along a unit
    /// displacement; written to `found`.
    pub fn project(&mut self, of: impl Fn(usize, f64) -> f64) {
        let numbers = self.constraints.iter().zip(&self.forces);
        for (out, (&constraint, &force)) in self.found.iter_mut().zip(numbers) {
            *out = of(constraint, force);
        }
        for (along, column) in self.along.iter_mut().zip(self.basis.column_iter()) {
            *along = column.iter().zip(&self.found).map(|(a, b)| a * b).sum();
        }
        self.found.fill(0.0);
        for (along, column) in self.along.iter().zip(self.basis.column_iter()) {
            for (out, part) in self.found.iter_mut().zip(column.iter()) {
                *out += along * part;
            }
        }
    }

    /// `P_ii` of the constraint with this index in the loop.
    pub fn own_share(&self, i: usize) -> f64 {
        self.basis.row(i).norm_squared()
    }

    /// Adds (D-281) to the entries of a matrix, with the compliance c \[m/N\].
    pub fn add_to(&self, weight: f64, compliance: f64, entries: &mut [f64]) {
        let forces = || self.forces.iter().cycle();
        let numbers = self.basis.iter().zip(forces());
        for (&index, (part, force)) in self.entries.gives.iter().zip(numbers.clone()) {
            entries[index] += weight * compliance * force * part;
        }
        for (&index, (part, force)) in self.entries.takes.iter().zip(numbers) {
            entries[index] -= weight * force * part;
        }
        for &index in &self.entries.own {
            entries[index] += weight;
        }
    }

    /// Whether the tree method failed.
    #[cfg(test)]
    pub fn looks_at_all(&self) -> bool {
        self.all.is_some()
    }

    /// Multipliers of a load that balances itself, by its index.
    #[cfg(test)]
    pub fn balanced(&self, load: usize) -> Vec<f64> {
        let count = self.constraints.iter().max().map_or(0, |last| last + 1);
        let mut multipliers = vec![0.0; count];
        let numbers = self.constraints.iter().zip(&self.forces);
        for ((constraint, force), part) in numbers.zip(self.basis.column(load).iter()) {
            multipliers[*constraint] = part / force;
        }
        multipliers
    }
}
