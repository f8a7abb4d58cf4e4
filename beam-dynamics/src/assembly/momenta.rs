//! Removes the momenta of motions without mass from the rates.
//!
//! Where n is a motion of a node that moves no mass, `M n = 0`, the equation of its
//! momentum has no rates,
//!
//! ```text
//! n^T p + a x = 0                                                               (D-272)
//! ```
//!
//! with a from the rotation of the other momenta. It replaces the rate of that momentum in all
//! balances: with `w^T n = 1`,
//!
//! ```text
//! F_y'  <-  F_y' - F_y'p w ( n^T p + a x )                                      (D-273)
//! ```
//!
//! The finite eigenvalues of `F_y + s F_y'` and their vectors do not change; the infinite
//! eigenvalues of these motions, which were defective, become simple and exactly infinite.
//! Otherwise round-off makes them large numbers in a spectrum.

use std::collections::BTreeMap;

use nalgebra::{DMatrix, SVector};

use super::massless::{MOTION, scale, without_mass};
use super::{System, Tangent};
use crate::model::NODE_UNKNOWNS;

/// Fraction of its terms below which an entry is round-off.
const ROUND_OFF: f64 = 1e-14;

/// The six motions or momenta of a node.
type Six = SVector<f64, MOTION>;

/// An entry of a matrix: row, column, value.
pub type Entry = (usize, usize, f64);

/// Motions of nodes that move no mass.
#[derive(Debug, Clone, Default)]
pub struct MasslessMotions {
    /// n and w of each, by nodes.
    nodes: Vec<Vec<[Six; 2]>>,
}

impl MasslessMotions {
    /// The motions of a system with a tangent.
    pub fn new(system: &System, tangent: &Tangent) -> Self {
        let size = system.size();
        let scale = scale(size);
        let of_node = |basis: &DMatrix<f64>| {
            let motions = basis.column_iter().map(|column| {
                let column = Six::from_iterator(column.iter().copied());
                [column.component_mul(&scale), column.component_div(&scale)]
            });
            motions.collect()
        };
        let bases = without_mass(system, tangent, size);
        Self {
            nodes: bases.iter().map(of_node).collect(),
        }
    }

    /// No motions, in a system of `nodes` nodes.
    pub fn none(nodes: usize) -> Self {
        Self {
            nodes: vec![Vec::new(); nodes],
        }
    }

    /// Number of nodes of the system.
    pub fn nodes(&self) -> usize {
        self.nodes.len()
    }

    /// Entries of the derivatives by rates (D-273) of `tangent`, none of them zero.
    pub fn rates(&self, tangent: &Tangent) -> Vec<Entry> {
        let is_some = |entry: &Entry| entry.2 != 0.0;
        let mut rates: BTreeMap<(usize, usize), [f64; 2]> = BTreeMap::new();
        let mut add = |(row, column, value): Entry| {
            let [sum, size] = rates.entry((column, row)).or_default();
            (*sum, *size) = (*sum + value, size.max(value.abs()));
        };
        tangent
            .by_rates
            .triplets()
            .filter(is_some)
            .for_each(&mut add);
        for (row, column, value) in self.terms(tangent) {
            add((row, column, -value));
        }
        let of = |((column, row), [value, size]): ((usize, usize), [f64; 2])| {
            (value.abs() > ROUND_OFF * size).then_some((row, column, value))
        };
        rates.into_iter().filter_map(of).collect()
    }

    /// The terms of `F_y'p w ( n^T p + a x )`.
    fn terms(&self, tangent: &Tangent) -> Vec<Entry> {
        if self.nodes.iter().all(Vec::is_empty) {
            return Vec::new();
        }
        let mut momenta = vec![Momenta::default(); self.nodes.len()];
        for (row, column, value) in tangent.by_unknowns.triplets() {
            if let Some((node, equation)) = self.position(row, 0) {
                momenta[node].equations.push((equation, column, value));
            }
        }
        for (row, column, value) in tangent.by_rates.triplets() {
            if let Some((node, momentum)) = self.position(column, MOTION) {
                momenta[node].rates.push((row, momentum, value));
            }
        }
        let nodes = self.nodes.iter().zip(&momenta);
        let terms = nodes.flat_map(|(motions, own)| motions.iter().map(|motion| own.terms(motion)));
        terms.flatten().collect()
    }

    /// The node with motions without mass to whose six numbers from `first` on an index belongs,
    /// and the number among the six.
    fn position(&self, index: usize, first: usize) -> Option<(usize, usize)> {
        let (node, number) = (index / NODE_UNKNOWNS, index % NODE_UNKNOWNS);
        let is_own = self.nodes.get(node).is_some_and(|own| !own.is_empty());
        let is_among = (first..first + MOTION).contains(&number);
        (is_own && is_among).then(|| (node, number - first))
    }
}

/// Entries of the momenta of a node.
#[derive(Clone, Default)]
struct Momenta {
    /// In their equations, by the unknowns: equation, column, value.
    equations: Vec<Entry>,
    /// In the columns of their rates: row, momentum, value.
    rates: Vec<Entry>,
}

impl Momenta {
    /// The terms of one motion without mass.
    fn terms(&self, [n, w]: &[Six; 2]) -> Vec<Entry> {
        let mut terms = Vec::new();
        for &(row, momentum, rate) in &self.rates {
            let by = rate * w[momentum];
            let equations = self.equations.iter();
            let own = equations.map(|&(i, column, value)| (row, column, by * n[i] * value));
            terms.extend(own.filter(|term| term.2 != 0.0));
        }
        terms
    }
}
