//! Many internal forces as a tree of boxes, for the largest value of a function over them.
//!
//! Each node of the tree holds a range of the forces and their box `|theta - c| <= h`. With an
//! upper bound of the function over a box, the boxes that cannot have a larger value than a known
//! one are left out. A linear function has
//!
//! ```text
//! max over the box of  a theta  =  a c + |a| h
//! ```

use nalgebra::{RowVector6, Vector6};

/// A node: some of the forces.
#[derive(Debug)]
struct Node {
    center: Vector6<f64>,
    half: Vector6<f64>,
    /// Its first force and the one after the last, in the order of the tree.
    range: [usize; 2],
    /// Its two halves, unless it is one force.
    halves: Option<[usize; 2]>,
}

/// Internal forces in a tree of boxes.
#[derive(Debug)]
pub(super) struct ForceTree<'a> {
    forces: &'a [Vector6<f64>],
    order: Vec<usize>,
    nodes: Vec<Node>,
}

impl<'a> ForceTree<'a> {
    /// A tree of `forces` \[N, N m\]: each box is divided in the middle of its forces, across the
    /// component whose range has the largest effect by the `weights` of the components.
    pub fn new(forces: &'a [Vector6<f64>], weights: &Vector6<f64>) -> Self {
        let mut tree = Self {
            forces,
            order: (0..forces.len()).collect(),
            nodes: Vec::with_capacity(2 * forces.len()),
        };
        if !forces.is_empty() {
            tree.nodes.push(tree.boxed([0, forces.len()]));
            let mut next = 0;
            while next < tree.nodes.len() {
                tree.divide(next, weights);
                next += 1;
            }
        }
        tree
    }

    fn boxed(&self, range: [usize; 2]) -> Node {
        let own = &self.order[range[0]..range[1]];
        let first = self.forces[own[0]];
        let (low, high) = own.iter().fold((first, first), |(low, high), &force| {
            (low.inf(&self.forces[force]), high.sup(&self.forces[force]))
        });
        Node {
            center: 0.5 * (low + high),
            half: 0.5 * (high - low),
            range,
            halves: None,
        }
    }

    fn divide(&mut self, number: usize, weights: &Vector6<f64>) {
        let Node { half, range, .. } = self.nodes[number];
        let [first, after] = range;
        // equal forces are one
        if after - first < 2 || half == Vector6::zeros() {
            return;
        }
        let component = half.component_mul(weights).imax();
        let middle = (after - first) / 2;
        let forces = self.forces;
        self.order[first..after].select_nth_unstable_by(middle, |a, b| {
            forces[*a][component].total_cmp(&forces[*b][component])
        });
        let middle = first + middle;
        let halves = [[first, middle], [middle, after]].map(|range| {
            self.nodes.push(self.boxed(range));
            self.nodes.len() - 1
        });
        self.nodes[number].halves = Some(halves);
    }

    /// Finds the largest value over the forces, if it is larger than `known`: the force and the
    /// value. `bound` gives an upper bound in a box from its center and half widths, `value`
    /// the value for a force.
    pub fn largest(
        &self,
        known: f64,
        bound: impl Fn(&Vector6<f64>, &Vector6<f64>) -> f64,
        value: impl Fn(&Vector6<f64>) -> f64,
    ) -> Option<(usize, f64)> {
        let bound = |number: usize| bound(&self.nodes[number].center, &self.nodes[number].half);
        let mut best = None;
        let mut known = known;
        let mut open = Vec::with_capacity(64);
        if !self.nodes.is_empty() {
            open.push((0, bound(0)));
        }
        while let Some((number, most)) = open.pop() {
            if most <= known {
                continue;
            }
            if let Some(halves) = self.nodes[number].halves {
                let mut halves = halves.map(|half| (half, bound(half)));
                // the half with the larger bound is next
                halves.sort_by(|a, b| a.1.total_cmp(&b.1));
                open.extend(halves);
            } else {
                let force = self.order[self.nodes[number].range[0]];
                let found = value(&self.forces[force]);
                if found > known {
                    known = found;
                    best = Some((force, found));
                }
            }
        }
        best
    }

    /// Smallest and largest value of a linear function over the forces; zeros without forces.
    pub fn range_of(&self, row: &RowVector6<f64>) -> [f64; 2] {
        let most = |row: &RowVector6<f64>| {
            let size = row.abs();
            let bound = |c: &Vector6<f64>, h: &Vector6<f64>| (row * c + size * h).x;
            let found = self.largest(f64::NEG_INFINITY, bound, |theta| (row * theta).x);
            found.map_or(0.0, |found| found.1)
        };
        [-most(&-row), most(row)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 200 linear functions of 500 random forces, some of them equal: range and force are those
    /// of all values, to the last digit.
    #[test]
    fn the_tree_finds_what_all_forces_give() {
        let mut state = 5_u64;
        let mut random = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as f64 / (1_u64 << 30) as f64 - 1.0
        };
        let scale = [1e6, 0.0, 1e3, 1e4, 1e-3, 1.0];
        let mut forces: Vec<Vector6<f64>> = (0..500)
            .map(|_| Vector6::from_fn(|i, _| scale[i] * random()))
            .collect();
        forces.extend_from_within(100..200);
        let weights = Vector6::from_fn(|i, _| [1e-6, 0.0, 2e-3, 1e-4, 1e3, 0.0][i]);
        let tree = ForceTree::new(&forces, &weights);
        for _ in 0..200 {
            let row = RowVector6::from_fn(|_, i| random() / scale[i].max(1e-9));
            let values: Vec<f64> = forces.iter().map(|theta| (row * theta).x).collect();
            let low = values.iter().copied().fold(f64::INFINITY, f64::min);
            let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            assert_eq!(tree.range_of(&row), [low, high]);
        }
        let none = ForceTree::new(&[], &weights);
        assert_eq!(none.range_of(&RowVector6::zeros()), [0.0; 2]);
    }
}
