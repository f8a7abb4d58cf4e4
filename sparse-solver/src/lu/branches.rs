//! Independent branches of a tree of elimination: their columns are eliminated in parallel, and
//! the rest of the tree, the trunk, after them.
//!
//! They depend only on the tree: the values are the same on any number of threads.

use std::collections::BinaryHeap;
use std::ops::Range;

/// Index of a missing parent.
pub(super) const NONE: u32 = u32::MAX;
/// Number of pivots from which a matrix has branches: the pivots of 400 beams of three nodes.
pub(super) const LARGE: usize = 9600;
/// Maximum number of branches.
const MOST: usize = 16;
/// Size below which a subtree belongs to the trunk, relative to the whole [-].
const SMALL: f64 = 0.02;
/// Size of trunk and longest branch together, relative to the whole, from which branches do not
/// save time [-].
const LONG: f64 = 0.75;

/// Independent subtrees of a tree in postorder, ascending; empty if the tree is small or hardly
/// branches. The choice minimizes the longest branch and the trunk together.
pub(super) fn of(parents: &[u32]) -> Vec<Range<usize>> {
    if parents.len() >= LARGE {
        found(parents)
    } else {
        Vec::new()
    }
}

/// The same for trees of any size.
fn found(parents: &[u32]) -> Vec<Range<usize>> {
    let n = parents.len();
    let sizes = sizes(parents);
    let least = (SMALL * n as f64) as usize + 1;
    let (mut subtrees, mut best) = (BinaryHeap::new(), Vec::new());
    let mut shortest = (LONG * n as f64) as usize;
    let mut trunk = add_subtrees(0..n, least, &sizes, &mut subtrees);
    while subtrees.len() <= MOST && trunk < shortest {
        let Some(&(longest, root)) = subtrees.peek() else {
            break;
        };
        if subtrees.len() > 1 && trunk + longest < shortest {
            shortest = trunk + longest;
            best = subtrees
                .iter()
                .map(|&(size, k)| k + 1 - size..k + 1)
                .collect();
        }
        // The root of the longest branch moves to the trunk.
        subtrees.pop();
        trunk += 1 + add_subtrees(root + 1 - longest..root, least, &sizes, &mut subtrees);
    }
    best.sort_by_key(|branch: &Range<usize>| branch.start);
    best
}

/// Number of pivots in the subtree of each.
fn sizes(parents: &[u32]) -> Vec<usize> {
    let mut sizes = vec![1; parents.len()];
    for (k, &parent) in parents.iter().enumerate() {
        if parent != NONE {
            sizes[parent as usize] += sizes[k];
        }
    }
    sizes
}

/// Adds the subtrees of a range, except those smaller than `least`; returns the number of
/// pivots in the latter.
fn add_subtrees(
    range: Range<usize>,
    least: usize,
    sizes: &[usize],
    subtrees: &mut BinaryHeap<(usize, usize)>,
) -> usize {
    let (mut end, mut small) = (range.end, 0);
    while end > range.start {
        let (root, size) = (end - 1, sizes[end - 1]);
        if size >= least {
            subtrees.push((size, root))
        } else {
            small += size
        }
        end -= size;
    }
    small
}

/// An order with the branches first, one after the other, and the trunk last.
pub(super) fn first(branches: &[Range<usize>], order: &[u32]) -> Vec<u32> {
    let mut moved = Vec::with_capacity(order.len());
    for branch in branches {
        moved.extend_from_slice(&order[branch.clone()]);
    }
    let mut end = 0;
    for branch in branches {
        moved.extend_from_slice(&order[end..branch.start]);
        end = branch.end;
    }
    moved.extend_from_slice(&order[end..]);
    moved
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Parents of a chain of `n` pivots, whose last one has the parent `end`.
    fn chain(first: u32, n: u32, end: u32) -> Vec<u32> {
        (1..n).map(|k| first + k).chain([end]).collect()
    }

    #[test]
    fn two_chains_on_a_short_one_are_branches_and_one_chain_has_none() {
        assert!(found(&chain(0, 100, NONE)).is_empty());
        let fork = [chain(0, 40, 100), chain(40, 60, 100), chain(100, 10, NONE)].concat();
        assert_eq!(found(&fork), [0..40, 40..100]);
        // Two trees without a common root.
        let apart = [chain(0, 50, NONE), chain(50, 50, NONE)].concat();
        assert_eq!(found(&apart), [0..50, 50..100]);
        // Too short to save time.
        let uneven = [chain(0, 10, 100), chain(10, 90, 100), vec![NONE]].concat();
        assert!(found(&uneven).is_empty());
    }

    #[test]
    fn the_trunk_comes_last() {
        let order = [3, 1, 4, 5, 9, 2];
        assert_eq!(first(&[1..2, 3..5], &order), [1, 5, 9, 3, 4, 2]);
    }
}
