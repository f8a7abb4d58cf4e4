//! The derivatives of a system in blocks of two nodes.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::{Matrix3, SMatrix};

use crate::assembly::{Sparse, System};
use crate::model::{Conditions, NODE_UNKNOWNS};

/// Derivatives of the equations of a node by the unknowns of a node: four vectors by four vectors.
type Block = SMatrix<f64, NODE_UNKNOWNS, NODE_UNKNOWNS>;
/// Vectors among the unknowns of a node.
const VECTORS: usize = NODE_UNKNOWNS / 3;
/// Kinds of blocks: by unknowns and by rates, of the nodes themselves and by other unknowns.
const KINDS: usize = 4;

/// Blocks of all kinds that are not zero, by their nodes; pairs of two central nodes are left out.
#[derive(Debug)]
pub(super) struct Blocks {
    of: [BTreeMap<(usize, usize), Block>; KINDS],
    neighbors: BTreeMap<usize, BTreeSet<usize>>,
    /// Largest entry of each kind by the two vectors.
    largest: [[[f64; VECTORS]; VECTORS]; KINDS],
}

impl Blocks {
    /// The derivatives of `system` without deformation and without loads.
    pub fn new(system: &System, central: &[bool]) -> Self {
        let tangent = system.tangent(&system.rest(), &Conditions::at_rest());
        let mut blocks = Self {
            of: Default::default(),
            neighbors: BTreeMap::new(),
            largest: [[[0.0; VECTORS]; VECTORS]; KINDS],
        };
        let size = NODE_UNKNOWNS * system.nodes().len();
        for (k, matrix) in [&tangent.by_unknowns, &tangent.by_rates]
            .into_iter()
            .enumerate()
        {
            blocks.add(matrix, size, [2 * k, 2 * k + 1], central);
        }
        blocks
    }

    /// Adds the entries of a matrix whose first `size` rows and columns are of nodes: their own to the
    /// first of the kinds, and products by other unknowns to the second.
    fn add(&mut self, matrix: &Sparse, size: usize, kinds: [usize; 2], central: &[bool]) {
        type Line = Vec<(usize, f64)>;
        let mut others: BTreeMap<usize, [Line; 2]> = BTreeMap::new();
        for (row, column, value) in matrix.triplets().filter(|entry| entry.2 != 0.0) {
            match (row < size, column < size) {
                (true, true) => self.enter((row, column, value), kinds[0], central),
                (true, false) => others.entry(column).or_default()[0].push((row, value)),
                (false, true) => others.entry(row).or_default()[1].push((column, value)),
                (false, false) => {}
            }
        }
        for [rows, columns] in others.values() {
            for (row, a) in rows {
                for (column, b) in columns {
                    self.enter((*row, *column, a * b), kinds[1], central);
                }
            }
        }
    }

    fn enter(&mut self, (row, column, value): (usize, usize, f64), kind: usize, central: &[bool]) {
        let (i, j) = (row / NODE_UNKNOWNS, column / NODE_UNKNOWNS);
        if central[i] && central[j] {
            return;
        }
        let (row, column) = (row % NODE_UNKNOWNS, column % NODE_UNKNOWNS);
        let block = self.of[kind].entry((i, j)).or_insert_with(Block::zeros);
        block[(row, column)] += value;
        let largest = &mut self.largest[kind][row / 3][column / 3];
        *largest = largest.max(block[(row, column)].abs());
        if i != j {
            self.neighbors.entry(i).or_default().insert(j);
            self.neighbors.entry(j).or_default().insert(i);
        }
    }

    /// Nodes that have blocks with a node.
    pub fn neighbors(&self, node: usize) -> impl Iterator<Item = usize> + '_ {
        self.neighbors.get(&node).into_iter().flatten().copied()
    }

    /// The pair among `others` whose blocks are nearest to the ones of `pair` after a turn.
    pub fn nearest(
        &self,
        pair: (usize, usize),
        others: impl Iterator<Item = (usize, usize)>,
        turn: &Matrix3<f64>,
    ) -> Option<(usize, usize)> {
        let off = others.map(|other| (self.difference(pair, other, turn), other));
        off.min_by(|a, b| a.0.total_cmp(&b.0)).map(|found| found.1)
    }

    /// The first pair of nodes whose blocks after a turn differ from the ones of the images by more
    /// than a part of the largest entry.
    pub fn first_different(
        &self,
        images: &[usize],
        turn: &Matrix3<f64>,
        part: f64,
    ) -> Option<[usize; 2]> {
        let mut pairs = self.of.iter().flat_map(BTreeMap::keys);
        let differs = |&&(i, j): &&(usize, usize)| {
            self.difference((i, j), (images[i], images[j]), turn) > part
        };
        pairs.find(differs).map(|&(i, j)| [i, j])
    }

    /// Largest difference of the blocks of `a` after a turn and the ones of `b`, relative to the
    /// largest entry of each kind.
    fn difference(&self, a: (usize, usize), b: (usize, usize), turn: &Matrix3<f64>) -> f64 {
        let zero = Block::zeros();
        let mut most = 0.0_f64;
        for kind in 0..KINDS {
            let [a, b] = [a, b].map(|pair| self.of[kind].get(&pair).unwrap_or(&zero));
            for i in 0..VECTORS {
                for j in 0..VECTORS {
                    let largest = self.largest[kind][i][j];
                    if largest > 0.0 {
                        let [a, b] =
                            [a, b].map(|of| of.fixed_view::<3, 3>(3 * i, 3 * j).into_owned());
                        let off = turn * a * turn.transpose() - b;
                        most = most.max(off.amax() / largest);
                    }
                }
            }
        }
        most
    }
}
