//! One name along each continuing mode of a sweep.
//!
//! A root is named from its own state, and where two modes without air are nearly as near to it, its name may
//! change from value to value. Of the roots that continue each other (D-330), the name that at least two thirds of
//! them have becomes the one of all. Where the air changes a mode so much that no name has so many, as a mode that
//! flutters, all have the name of the root that is nearest to its mode without air (D-425), among the names that
//! no other mode has at the same values.

use super::follow::links;
use crate::result::{StabilityPoint, StabilityRoot};

/// Least number of values at which a mode continues.
const LEAST: usize = 3;

/// Number of a point, and of a root there.
type Place = (usize, usize);

/// A chain of roots with its name, and the number of roots that had it.
type Named = ((Key, usize), Vec<Place>);

/// A name without the pattern, which does not change along a mode.
type Key = (String, usize);

fn key(root: &StabilityRoot) -> Key {
    (root.name.clone(), root.number)
}

/// Gives roots along modes the name of most of them; roots of one value that then have one name are no longer
/// identified by it, but the one whose mode has most votes.
pub(super) fn settle(points: &mut [StabilityPoint]) {
    let (elected, others) = named_chains(points);
    for chain in others {
        if roots(points, &chain).all(|root| root.is_named) {
            continue;
        }
        let Some((name, pattern, number)) = common(points, &chain) else {
            continue;
        };
        for (point, root) in chain {
            let own = &mut points[point].roots[root];
            own.name.clone_from(&name);
            own.pattern.clone_from(&pattern);
            (own.number, own.is_named) = (number, false);
        }
    }
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

/// Chains of roots with a name for all of them, and the number of roots that had it; and chains with none.
fn named_chains(points: &[StabilityPoint]) -> (Vec<Named>, Vec<Vec<Place>>) {
    let long = chains(points)
        .into_iter()
        .filter(|chain| chain.len() >= LEAST);
    let (mut done, mut others) = (Vec::new(), Vec::new());
    for chain in long {
        match elected(points, &chain) {
            Some(name) => done.push((name, chain)),
            None => others.push(chain),
        }
    }
    loop {
        let nearest = others.iter().enumerate().filter_map(|(index, chain)| {
            let (name, unlikeness) = nearest(points, (chain, &done))?;
            Some((index, name, unlikeness))
        });
        let Some((index, name, _)) = nearest.min_by(|a, b| a.2.total_cmp(&b.2)) else {
            return (done, others);
        };
        done.push((name, others.swap_remove(index)));
    }
}

/// The name of the root of a chain that is nearest to its mode without air, among the ones that no other chain has at the
/// same values, with the number of roots that have it; and the difference from the mode.
fn nearest(
    points: &[StabilityPoint],
    (chain, others): (&[Place], &[Named]),
) -> Option<((Key, usize), f64)> {
    let is_free = |own: &&StabilityRoot| {
        !others.iter().any(|((name, _), other)| {
            let is_beside = |place: &Place| {
                chain.iter().any(|own| own.0 == place.0)
                    && points[place.0].roots[place.1].pattern == own.pattern
            };
            *name == key(own) && other.iter().any(is_beside)
        })
    };
    let free = roots(points, chain)
        .filter(|own| own.is_named)
        .filter(is_free);
    let free: Vec<_> = free
        .filter_map(|own| Some((key(own), own.unlikeness?)))
        .collect();
    let (name, unlikeness) = free.iter().min_by(|a, b| a.1.total_cmp(&b.1))?;
    let votes = free.iter().filter(|own| own.0 == *name).count();
    Some(((name.clone(), votes), *unlikeness))
}

/// The motion with pattern and number that most roots of a chain without a name have; of several the least one.
fn common(points: &[StabilityPoint], chain: &[Place]) -> Option<(String, Option<String>, usize)> {
    let keys = roots(points, chain).map(|own| (own.name.clone(), own.pattern.clone(), own.number));
    most_frequent(&keys.collect::<Vec<_>>()).map(|(most, _)| most)
}

/// The roots at the places of a chain.
fn roots<'a>(
    points: &'a [StabilityPoint],
    chain: &'a [Place],
) -> impl Iterator<Item = &'a StabilityRoot> {
    chain
        .iter()
        .map(|(point, root)| &points[*point].roots[*root])
}

/// The most frequent item, of several the least one, and how often it is there.
fn most_frequent<T: Ord + Clone>(items: &[T]) -> Option<(T, usize)> {
    let count = |item: &T| items.iter().filter(|own| *own == item).count();
    let most = items
        .iter()
        .max_by(|a, b| count(a).cmp(&count(b)).then_with(|| b.cmp(a)))?;
    Some((most.clone(), count(most)))
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
    let named = roots(points, chain).filter(|root| root.is_named).map(key);
    let (most, votes) = most_frequent(&named.collect::<Vec<_>>())?;
    (3 * votes >= 2 * chain.len()).then_some((most, votes))
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

    // The air changes a mode from value to value: all have the name of the value where its root is nearest to a mode
    // without air, unless another one has this name there; a root of no mode has the motion of most of its chain.
    #[test]
    fn a_mode_that_the_air_changes_has_the_name_of_the_nearest_value() {
        let at = |k: usize, [first, second]: [(&str, usize, Option<f64>); 2]| {
            let low = (first.0, first.1, 8.0 + 0.01 * k as f64);
            let high = (second.0, second.1, 20.0 + 0.01 * k as f64);
            let mut point = point(k as f64, &[low, high]);
            for (root, own) in point.roots.iter_mut().zip([first, second]) {
                root.unlikeness = own.2;
                root.is_named = own.2.is_some();
            }
            point
        };
        let flap = |number, unlikeness| ("flap", number, Some(unlikeness));
        let edge = |number, unlikeness| ("edge", number, Some(unlikeness));
        let mut points = vec![
            at(0, [edge(2, 0.5), flap(3, 0.2)]),
            at(1, [flap(1, 1.4), flap(3, 0.2)]),
            at(2, [flap(3, 0.1), flap(4, 0.2)]),
            at(3, [("flap", 9, None), flap(3, 0.2)]),
        ];
        settle(&mut points);
        let names = |points: &[StabilityPoint], root: usize| -> Vec<Key> {
            points.iter().map(|point| key(&point.roots[root])).collect()
        };
        assert_eq!(names(&points, 0), vec![("edge".to_owned(), 2); 4]);
        assert_eq!(names(&points, 1), vec![("flap".to_owned(), 3); 4]);
        let none = |name| (name, 7, None);
        let mut points = vec![
            at(0, [none("aerodynamic"), flap(3, 0.2)]),
            at(1, [none("flap"), flap(3, 0.2)]),
            at(2, [none("aerodynamic"), flap(3, 0.2)]),
        ];
        settle(&mut points);
        assert_eq!(names(&points, 0), vec![("aerodynamic".to_owned(), 7); 3]);
        assert!(points.iter().all(|point| !point.roots[0].is_named));
    }
}
