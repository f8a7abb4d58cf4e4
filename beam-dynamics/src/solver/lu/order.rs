//! The order of elimination, pivots being given: what belongs together is brought
//! together, without other fill.
//!
//! In the tree of elimination the parent of a pivot is the first later one that its
//! elimination changes. Any order in which children stand before their parents leaves
//! the same numbers in the same places; in postorder the pivots of a block follow each
//! other.
//!
//! References: [Liu1990].

use super::pivots::Pivots;
use crate::assembly::Pattern;

const NONE: usize = usize::MAX;

/// Brings pivots into a postorder of their tree of elimination.
pub(super) fn postordered(pattern: &Pattern, pivots: &Pivots) -> Pivots {
    let parents = tree(pattern, pivots);
    let order = postorder(&parents);
    let taken = |of: &[usize]| order.iter().map(|&k| of[k]).collect();
    Pivots {
        rows: taken(&pivots.rows),
        columns: taken(&pivots.columns),
    }
}

/// Place of each row, or column, in the order of the pivots.
pub(super) fn inverse(order: &[usize]) -> Vec<usize> {
    let mut places = vec![0; order.len()];
    for (place, &line) in order.iter().enumerate() {
        places[line] = place;
    }
    places
}

/// Parent of each pivot in the tree of elimination of the pattern and its transpose.
fn tree(pattern: &Pattern, pivots: &Pivots) -> Vec<usize> {
    let n = pattern.size();
    let (row_places, column_places) = (inverse(&pivots.rows), inverse(&pivots.columns));
    let mut earlier = vec![Vec::new(); n];
    for column in 0..n {
        for at in pattern.column_starts()[column]..pattern.column_starts()[column + 1] {
            let (i, j) = (row_places[pattern.rows()[at]], column_places[column]);
            if i != j {
                earlier[i.max(j)].push(i.min(j));
            }
        }
    }
    let mut parents = vec![NONE; n];
    // The latest known ancestor of each, to shorten the ways.
    let mut ancestors = vec![NONE; n];
    for (k, earlier) in earlier.iter().enumerate() {
        for &start in earlier {
            let mut at = start;
            while ancestors[at] != NONE && ancestors[at] != k {
                at = std::mem::replace(&mut ancestors[at], k);
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
fn postorder(parents: &[usize]) -> Vec<usize> {
    let n = parents.len();
    let mut children = vec![Vec::new(); n];
    let mut open = Vec::new();
    for (k, &parent) in parents.iter().enumerate().rev() {
        match children.get_mut(parent) {
            Some(siblings) => siblings.push(k),
            None => open.push(k),
        }
    }
    // A parent is met again once its children are done; the first stand on top.
    let mut order = Vec::with_capacity(n);
    while let Some(&k) = open.last() {
        match std::mem::take(&mut children[k]) {
            of_k if of_k.is_empty() => {
                order.push(k);
                open.pop();
            }
            of_k => open.extend(of_k),
        }
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn subtrees_follow_each_other() {
        // 0 and 2 under 4, 1 and 3 under 5, both under 6.
        let parents = [4, 5, 4, 5, 6, 6, NONE];
        assert_eq!(postorder(&parents), [0, 2, 4, 1, 3, 5, 6]);
    }

    #[test]
    fn the_tree_of_an_arrow_is_a_star() {
        let places = (0..4).flat_map(|i| [(i, i), (i, 3)]).collect();
        let pattern = Pattern::new(4, places);
        let all: Vec<_> = (0..4).collect();
        let pivots = Pivots {
            rows: all.clone(),
            columns: all,
        };
        assert_eq!(tree(&pattern, &pivots), [3, 3, 3, NONE]);
    }
}
