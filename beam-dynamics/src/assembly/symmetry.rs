//! Rotational symmetry of a system: equal parts at equal distances around an axis.
//!
//! A turn by `2 pi / N` about the axis moves every node to another one, its image, and nodes on the
//! axis to themselves. The system has the symmetry if the blocks of its derivatives without
//! deformation turn with the nodes,
//!
//! ```text
//! A_s(i)s(j) = T A_ij T^T                                                        (D-341)
//! ```
//!
//! with s(i) the image of node i and T the turn of the three components of every vector. Unknowns
//! that are not of nodes, as multipliers of joints, enter by the products of their rows and columns,
//! which do not depend on the axes that an element chooses for its constraints. Pairs of two nodes on
//! the axis are not compared: a hub or a shaft may differ around the axis.

use std::cell::OnceCell;
use std::collections::BTreeSet;

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::vector;

use super::System;
use blocks::Blocks;

mod blocks;

/// Part of the size of the model up to which positions agree, and part of the largest entry of a
/// kind up to which blocks agree: the difference of frequencies up to which modes are copies.
const EQUAL: f64 = 1e-6;

/// Equal parts around an axis: for each part its nodes, in the same order for all parts. The part k
/// is the first one turned by k N-ths of a turn.
pub type EqualParts = Vec<Vec<usize>>;

/// Why parts are not equal.
#[derive(Debug, Clone, PartialEq)]
pub enum Unequal {
    /// No node is where the image of this one would be.
    NoImage {
        /// The node.
        node: usize,
        /// Distance of the nearest node from there [m].
        nearest: f64,
    },
    /// This node is connected with others in another way than the node in the position of its image.
    Connected(usize),
    /// The blocks of two nodes and of their images differ.
    Different([usize; 2]),
}

/// The search for rotational symmetry.
#[derive(Debug)]
pub struct Symmetry<'a> {
    system: &'a System,
    center: Vector3<f64>,
    axis: Vector3<f64>,
    /// Whether a node is its own image.
    central: &'a [bool],
    /// Largest distance of a node from the center \[m\].
    size: f64,
    /// Computed where positions agree.
    blocks: OnceCell<Blocks>,
}

impl<'a> Symmetry<'a> {
    /// Of a system about an axis of unit length through `center`; `central` nodes are on the axis and
    /// belong to no part.
    pub fn new(
        system: &'a System,
        (center, axis): (Vector3<f64>, Vector3<f64>),
        central: &'a [bool],
    ) -> Self {
        let nodes = system.nodes().iter();
        let distances = nodes.map(|node| (node.position - center).norm());
        Self {
            size: distances.fold(0.0, f64::max),
            system,
            center,
            axis,
            central,
            blocks: OnceCell::new(),
        }
    }

    /// The equal parts of the highest order; `None` if there are none.
    pub fn highest(&self) -> Option<EqualParts> {
        let count = self.others().count();
        let orders = (2..=count).rev().filter(|n| count.is_multiple_of(*n));
        orders
            .map(|order| self.of_order(order))
            .find_map(Result::ok)
    }

    /// Number of parts that only central nodes connect, of two nodes at least.
    pub fn parts(&self) -> usize {
        let mut neighbors = vec![Vec::new(); self.central.len()];
        for element in self.system.elements().filter(|element| element.acts()) {
            for pair in element.nodes().windows(2) {
                neighbors[pair[0]].push(pair[1]);
                neighbors[pair[1]].push(pair[0]);
            }
        }
        let mut is_known = self.central.to_vec();
        let mut parts = 0;
        for node in self.others() {
            let mut stack = vec![node];
            let mut size = 0;
            while let Some(node) = stack.pop() {
                if !std::mem::replace(&mut is_known[node], true) {
                    size += 1;
                    stack.extend(&neighbors[node]);
                }
            }
            parts += usize::from(size > 1);
        }
        parts
    }

    /// The parts of `order` equal ones.
    ///
    /// # Errors
    /// [`Unequal`]: the first difference.
    pub fn of_order(&self, order: usize) -> Result<EqualParts, Unequal> {
        let angle = std::f64::consts::TAU / order as f64;
        let turn = vector::to_rotation(&(self.axis * angle));
        let images = self.images(&turn)?;
        if let Some(pair) = self.blocks().first_different(&images, &turn, EQUAL) {
            return Err(Unequal::Different(pair));
        }
        let mut parts = vec![Vec::new(); order];
        let mut is_known = self.central.to_vec();
        for first in self.others() {
            if is_known[first] {
                continue;
            }
            let mut node = first;
            for part in &mut parts {
                is_known[node] = true;
                part.push(node);
                node = images[node];
            }
            if node != first {
                return Err(Unequal::Connected(first));
            }
        }
        Ok(parts)
    }

    fn blocks(&self) -> &Blocks {
        self.blocks
            .get_or_init(|| Blocks::new(self.system, self.central))
    }

    /// Nodes that are not central.
    fn others(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.central.len()).filter(|node| !self.central[*node])
    }

    /// The image of each node: from a node whose image no other node could be, on along the pairs of
    /// nodes that have blocks, which distinguish nodes in one position.
    fn images(&self, turn: &Matrix3<f64>) -> Result<Vec<usize>, Unequal> {
        let mut images = Images {
            symmetry: self,
            turn,
            of: (0..self.central.len())
                .map(|node| self.central[node].then_some(node))
                .collect(),
            taken: BTreeSet::new(),
        };
        let has_none = |node: &usize| images.candidates(*node, self.others()).is_empty();
        if let Some(node) = self.others().find(has_none) {
            let nearest = self.others().map(|other| images.off(node, other));
            let nearest = nearest.fold(f64::INFINITY, f64::min);
            return Err(Unequal::NoImage { node, nearest });
        }
        let nodes = self.system.nodes();
        let off = |node: usize| {
            self.axis
                .cross(&(nodes[node].position - self.center))
                .norm()
        };
        let mut order: Vec<_> = self.others().collect();
        order.sort_by(|a, b| off(*b).total_cmp(&off(*a)));
        for only in [true, false] {
            for &node in &order {
                images.begin(node, only)?;
            }
        }
        let found: Option<Vec<_>> = images.of.into_iter().collect();
        found.ok_or(Unequal::Connected(0))
    }
}

/// Images that are found one after the other.
struct Images<'a> {
    symmetry: &'a Symmetry<'a>,
    turn: &'a Matrix3<f64>,
    of: Vec<Option<usize>>,
    taken: BTreeSet<usize>,
}

impl Images<'_> {
    /// Finds the image of `node`, and of all nodes that are connected with it; if `only`, of a node
    /// with several candidates nothing.
    fn begin(&mut self, node: usize, only: bool) -> Result<(), Unequal> {
        if self.of[node].is_some() {
            return Ok(());
        }
        let found = self.candidates(node, self.symmetry.others());
        if only && found.len() > 1 {
            return Ok(());
        }
        let blocks = self.symmetry.blocks();
        let image = blocks.nearest((node, node), found.iter().map(|b| (*b, *b)), self.turn);
        let image = image.map(|pair| pair.0);
        self.take(node, image.ok_or(Unequal::Connected(node))?);
        let mut open = vec![node];
        while let Some(node) = open.pop() {
            let Some(image) = self.of[node] else { continue };
            for next in blocks.neighbors(node) {
                if self.of[next].is_some() {
                    continue;
                }
                let found = self.candidates(next, blocks.neighbors(image));
                let pairs = found.iter().map(|b| (image, *b));
                let found = blocks.nearest((node, next), pairs, self.turn);
                self.take(next, found.ok_or(Unequal::Connected(next))?.1);
                open.push(next);
            }
        }
        Ok(())
    }

    fn take(&mut self, node: usize, image: usize) {
        self.of[node] = Some(image);
        self.taken.insert(image);
    }

    /// Nodes among `from` that are where the image of `node` is.
    fn candidates(&self, node: usize, from: impl Iterator<Item = usize>) -> Vec<usize> {
        let limit = EQUAL * self.symmetry.size;
        from.filter(|other| !self.symmetry.central[*other] && !self.taken.contains(other))
            .filter(|other| self.off(node, *other) <= limit)
            .collect()
    }

    /// Distance of `other` from the position of the image of `node` \[m\].
    fn off(&self, node: usize, other: usize) -> f64 {
        let nodes = self.symmetry.system.nodes();
        let center = self.symmetry.center;
        let position = center + self.turn * (nodes[node].position - center);
        (nodes[other].position - position).norm()
    }
}
