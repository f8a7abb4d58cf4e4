//! The order of elimination for given pivots: connected pivots become consecutive, without
//! additional fill.
//!
//! In the tree of elimination the parent of a pivot is the first later one that its elimination
//! changes. Any order with children before their parents gives the same numbers at the same
//! indices; in postorder the pivots of a block are consecutive, and independent branches can be
//! eliminated in parallel.
//!
//! References: [Liu1990].

use std::ops::Range;

use super::branches::{self, NONE};
use super::pivots::Pivots;
use crate::pattern::Pattern;

/// Sorts pivots into a postorder of their tree of elimination; in a large matrix the pivots of
/// independent branches come first, and their ranges are returned.
pub(super) fn ordered(pattern: &Pattern, pivots: &Pivots) -> (Pivots, Vec<Range<usize>>) {
    let parents = tree(pattern, pivots);
    let mut order = postorder(&parents);
    let parents = relabeled(&parents, &order);
    let branches = branches::of(&parents);
    if !branches.is_empty() {
        order = branches::first(&branches, &order);
    }
    let taken = |of: &[u32]| order.iter().map(|&k| of[k as usize]).collect();
    let pivots = Pivots {
        rows: taken(&pivots.rows),
        columns: taken(&pivots.columns),
    };
    let mut first = 0;
    let moved = branches.iter().map(|branch| {
        let begin = first;
        first += branch.len();
        begin..first
    });
    (pivots, moved.collect())
}

/// Index of each row, or column, in the order of the pivots.
pub(super) fn inverse(order: &[u32]) -> Vec<u32> {
    let mut indices = vec![0; order.len()];
    for (index, &line) in order.iter().enumerate() {
        indices[line as usize] = index as u32;
    }
    indices
}

/// Parent of each pivot in the tree of elimination of the pattern and its transpose.
fn tree(pattern: &Pattern, pivots: &Pivots) -> Vec<u32> {
    let n = pattern.size();
    let (row_indices, column_indices) = (inverse(&pivots.rows), inverse(&pivots.columns));
    // The earlier of the two pivots of each entry, with the later one as its column.
    let earlier = Pattern::of(n, |add| {
        for column in 0..n {
            let j = column_indices[column] as usize;
            for &row in &pattern.rows()[pattern.column(column)] {
                let i = row_indices[row as usize] as usize;
                if i != j {
                    add(i.min(j), i.max(j));
                }
            }
        }
    });
    let mut parents = vec![NONE; n];
    // The latest known ancestor of each, to shorten the paths.
    let mut ancestors = vec![NONE; n];
    for k in 0..n {
        for &start in &earlier.rows()[earlier.column(k)] {
            let (k, mut at) = (k as u32, start as usize);
            while ancestors[at] != NONE && ancestors[at] != k {
                at = std::mem::replace(&mut ancestors[at], k) as usize;
            }
            if ancestors[at] == NONE {
                ancestors[at] = k;
                parents[at] = k;
            }
        }
    }
    parents
}

/// Children before parents, subtree after subtree.
fn postorder(parents: &[u32]) -> Vec<u32> {
    let n = parents.len();
    // The children of each as a linked list, ascending; those without a parent are open.
    let (mut first, mut next) = (vec![NONE; n], vec![NONE; n]);
    let mut open = Vec::new();
    for (k, &parent) in parents.iter().enumerate().rev() {
        match first.get_mut(parent as usize) {
            Some(head) => next[k] = std::mem::replace(head, k as u32),
            None => open.push(k as u32),
        }
    }
    // A parent is reached again after its children; the first children are on top of the stack.
    let mut order = Vec::with_capacity(n);
    while let Some(&k) = open.last() {
        let mut child = std::mem::replace(&mut first[k as usize], NONE);
        if child == NONE {
            order.push(k);
            open.pop();
            continue;
        }
        let begin = open.len();
        while child != NONE {
            open.push(child);
            child = next[child as usize];
        }
        open[begin..].reverse();
    }
    order
}

/// The same tree, each pivot named by its index in an order.
fn relabeled(parents: &[u32], order: &[u32]) -> Vec<u32> {
    let indices = inverse(order);
    let parent = |&k: &u32| match parents[k as usize] {
        NONE => NONE,
        parent => indices[parent as usize],
    };
    order.iter().map(parent).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn subtrees_follow_each_other() {
        // 0 and 2 under 4, 1 and 3 under 5, both under 6.
        let parents = [4, 5, 4, 5, 6, 6, NONE];
        let order = postorder(&parents);
        assert_eq!(order, [0, 2, 4, 1, 3, 5, 6]);
        assert_eq!(relabeled(&parents, &order), [2, 2, 6, 5, 5, 6, NONE]);
    }

    #[test]
    fn the_tree_of_an_arrow_is_a_star() {
        let indices = (0..4).flat_map(|i| [(i, i), (i, 3)]).collect();
        let pattern = Pattern::new(4, indices);
        let pivots = Pivots {
            rows: (0..4).collect(),
            columns: (0..4).collect(),
        };
        assert_eq!(tree(&pattern, &pivots), [3, 3, 3, NONE]);
    }
}
