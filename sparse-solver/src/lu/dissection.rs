//! Division of a long chain by a cut, so that its halves can be eliminated in parallel: from
//! both ends to the cut, without more fill than from one end to the other. Each half is divided
//! into stages of some thousand unknowns: the choice of pivots needs memory for one of them.
//!
//! Levels of unknowns, by their distance from an end of the chain, are found twice: the last
//! unknown of the first search is an end. The unknowns of the middle level that have neighbors
//! in the next level form the cut, which is the last stage.
//!
//! References: [GeorgeLiu1981].

use super::branches::LARGE;
use crate::pattern::Pattern;

/// Least size of a half, relative to the whole [-].
const HALF: f64 = 0.4;
/// Largest size of a cut, relative to the whole [-].
const CUT: f64 = 0.02;

const NONE: u32 = u32::MAX;

/// Stage of each unknown of a large chain, the cut in the last one; `None` for small matrices,
/// and for matrices that are no chains: trees already have branches.
pub(super) fn stages(pattern: &Pattern) -> Option<Vec<u16>> {
    let count = (pattern.size() / LARGE).min(u16::MAX.into());
    (count > 0).then(|| found(pattern, count as u16)).flatten()
}

/// The same for matrices of any size, with `count` stages before the cut.
fn found(pattern: &Pattern, count: u16) -> Option<Vec<u16>> {
    let n = pattern.size();
    let graph = symmetric(pattern);
    let nothing = vec![false; n];
    let (first, _) = search(&graph, 0, &nothing);
    let (order, levels) = search(&graph, *first.last()?, &nothing);
    if order.len() < n {
        return None;
    }
    let middle = levels[order[n / 2] as usize];
    let is_cut = |i: usize| {
        let mut near = graph.rows()[graph.column(i)].iter();
        levels[i] == middle && near.any(|&j| levels[j as usize] == middle + 1)
    };
    let cut: Vec<_> = (0..n).map(is_cut).collect();
    let size = cut.iter().filter(|is_cut| **is_cut).count();
    let part = |from: u32| search(&graph, from, &cut).0.len() as f64 / n as f64;
    let ends = [order[0], *order.last()?];
    let is_chain = size as f64 <= CUT * n as f64 && ends.into_iter().all(|end| part(end) >= HALF);
    let length = levels[ends[1] as usize];
    let half = f64::from(length / 2 + 1);
    let stage = |i: usize| {
        let from_end = levels[i].min(length - levels[i]);
        if cut[i] {
            count
        } else {
            (f64::from(from_end) / half * f64::from(count)) as u16
        }
    };
    is_chain.then(|| (0..n).map(stage).collect())
}

/// The pattern and its transpose.
fn symmetric(pattern: &Pattern) -> Pattern {
    let n = pattern.size();
    Pattern::of(n, |add| {
        for j in 0..n {
            for &i in &pattern.rows()[pattern.column(j)] {
                add(i as usize, j);
                add(j, i as usize);
            }
        }
    })
}

/// All unknowns that are reached from one without passing one that is `left_out`, the nearest
/// first, and the distance of each.
fn search(graph: &Pattern, from: u32, left_out: &[bool]) -> (Vec<u32>, Vec<u32>) {
    let mut levels = vec![NONE; graph.size()];
    let mut order = vec![from];
    levels[from as usize] = 0;
    let mut next = 0;
    while let Some(&i) = order.get(next) {
        next += 1;
        let level = levels[i as usize] + 1;
        for &j in &graph.rows()[graph.column(i as usize)] {
            if levels[j as usize] == NONE && !left_out[j as usize] {
                levels[j as usize] = level;
                order.push(j);
            }
        }
    }
    (order, levels)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pattern(n: usize, parent: impl Fn(usize) -> usize) -> Pattern {
        let indices = (0..n).flat_map(|i| [(i, i), (i, parent(i)), (parent(i), i)]);
        Pattern::new(n, indices.collect())
    }

    #[test]
    fn a_chain_is_cut_in_the_middle_and_a_star_is_not() {
        let stages = found(&pattern(101, |i| i.saturating_sub(1)), 2).unwrap();
        let expected = |i: usize| match i.abs_diff(50) {
            0 => 2,
            1..=24 => 1,
            _ => 0,
        };
        assert!((0..101).all(|i| stages[i] == expected(i)), "{stages:?}");
        assert!(found(&pattern(100, |i| i.saturating_sub(4)), 1).is_none());
        // Two separate chains.
        assert!(
            found(
                &pattern(100, |i| if i == 50 { i } else { i.saturating_sub(1) }),
                1
            )
            .is_none()
        );
    }
}
