//! One name along each continuing mode of a sweep.
//!
//! A root is named from its own state, and where two modes without air are nearly as near to it, its name may
//! change from value to value. Of the roots that continue each other (D-330), the name that at least two thirds of
//! them have becomes the one of all.

use super::follow::links;
use crate::result::{StabilityPoint, StabilityRoot};

/// Least number of values at which a mode continues.
const LEAST: usize = 3;

/// Number of a point, and of a root there.
type Place = (usize, usize);

/// A name without the pattern, which does not change along a mode.
type Key = (String, usize);

fn key(root: &StabilityRoot) -> Key {
    (root.name.clone(), root.number)
}

/// Gives roots along modes the name of most of them; roots of one value that then have one name are no longer
/// identified by it, but the one whose mode has most votes.
pub(super) fn settle(points: &mut [StabilityPoint]) {
    let elected: Vec<_> = chains(points)
        .into_iter()
        .filter_map(|chain| Some((elected(points, &chain)?, chain)))
        .collect();
    let mut votes: Vec<Vec<usize>> = points.iter().map(|at| vec![0; at.roots.len()]).collect();
    for (((name, number), count), chain) in &elected {
        for &(point, root) in chain {
            let own = &mut points[point].roots[root];
            (own.name, own.number) = (name.clone(), *number);
            own.is_named = true;
            votes[point][root] = *count;
        }
    }
    for (point, votes) in points.iter_mut().zip(&votes) {
        let roots = &mut point.roots;
        let beaten = |index: usize| {
            let own = &roots[index];
            let rivals = roots.iter().enumerate().filter(|(other, root)| {
                *other != index && key(root) == key(own) && root.pattern == own.pattern
            });
            let mut rivals = rivals.map(|(other, _)| (votes[other], std::cmp::Reverse(other)));
            rivals.any(|rival| rival > (votes[index], std::cmp::Reverse(index)))
        };
        let beaten: Vec<_> = (0..roots.len()).map(beaten).collect();
        for (root, is_beaten) in roots.iter_mut().zip(beaten) {
            root.is_named &= !is_beaten;
        }
    }
}

/// The roots that continue each other.
fn chains(points: &[StabilityPoint]) -> Vec<Vec<Place>> {
    let mut chains: Vec<Vec<Place>> = Vec::new();
    // The chain of each root of the last point.
    let mut last: Vec<usize> = Vec::new();
    for (index, point) in points.iter().enumerate() {
        let mut of_root = vec![None; point.roots.len()];
        if let Some(before) = index.checked_sub(1) {
            let links = links(&points[before].roots, &point.roots);
            for (chain, link) in last.iter().zip(links) {
                if let Some(link) = link {
                    of_root[link.to] = Some(*chain);
                }
            }
        }
        last = of_root
            .into_iter()
            .enumerate()
            .map(|(root, chain)| {
                let chain = chain.unwrap_or_else(|| {
                    chains.push(Vec::new());
                    chains.len() - 1
                });
                chains[chain].push((index, root));
                chain
            })
            .collect();
    }
    chains
}

/// The name of two thirds of a chain of identified roots, and their number.
fn elected(points: &[StabilityPoint], chain: &[Place]) -> Option<(Key, usize)> {
    let named = chain
        .iter()
        .map(|(point, root)| &points[*point].roots[*root]);
    let named: Vec<_> = named.filter(|root| root.is_named).map(key).collect();
    let count = |key: &Key| named.iter().filter(|own| *own == key).count();
    let most = named.iter().max_by(|a, b| {
        let by_count = count(a).cmp(&count(b));
        by_count.then_with(|| b.cmp(a))
    })?;
    let votes = count(most);
    (chain.len() >= LEAST && 3 * votes >= 2 * chain.len()).then(|| (most.clone(), votes))
}

#[cfg(test)]
mod tests {
    use nalgebra::Complex;

    use super::*;

    fn point(at: f64, roots: &[(&str, usize, f64)]) -> StabilityPoint {
        let root = |(name, number, frequency): &(&str, usize, f64)| {
            let mut root = StabilityRoot::new(Complex::new(-1.0, *frequency));
            root.name = (*name).to_owned();
            root.number = *number;
            root.pattern = Some(String::new());
            root.is_named = true;
            root
        };
        StabilityPoint {
            at,
            is_requested: true,
            roots: roots.iter().map(root).collect(),
            modes: Vec::new(),
            controls: Vec::new(),
        }
    }

    // One value of five calls the first mode flap 2, as the second one is called: the name of the first is of
    // most values, in both directions, and votes decide which of two modes of one name at a value keeps it.
    #[test]
    fn one_value_does_not_rename_a_mode() {
        let at = |at: f64, first: usize| {
            let low = ("flap", first, 8.0 + 0.01 * at);
            point(at, &[low, ("flap", 2, 20.0 + 0.01 * at)])
        };
        let mut points: Vec<_> = [1, 1, 1, 1, 2]
            .into_iter()
            .enumerate()
            .map(|(k, first)| at(k as f64, first))
            .collect();
        for _ in 0..2 {
            settle(&mut points);
            for point in &points {
                let found: Vec<_> = point.roots.iter().map(|own| own.number).collect();
                assert_eq!(found, [1, 2]);
                assert!(point.roots.iter().all(|own| own.is_named));
            }
            points.reverse();
        }
        // Two values are no majority, and three of which each differs elect nothing.
        let mut two = vec![at(0.0, 1), at(1.0, 2)];
        settle(&mut two);
        assert_eq!(two[1].roots[0].number, 2);
        let mut odd = vec![at(0.0, 1), at(1.0, 3), at(2.0, 4)];
        settle(&mut odd);
        assert_eq!(odd[2].roots[0].number, 4);
    }
}
