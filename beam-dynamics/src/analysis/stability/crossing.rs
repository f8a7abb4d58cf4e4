//! Boundaries between two values of the parameter.
//!
//! The n-th largest growth is a continuous function of the parameter, however modes exchange
//! their ranks: where the number of unstable roots increases from n - 1 to n, it has a zero. Where modes
//! pass in both directions between two values, each is followed by the exponent between its ends.

use std::cell::RefCell;

use super::follow::{cost, links, size};
use super::refine::root;
use super::request::Evaluate;
use crate::result::{StabilityBoundary, StabilityPoint, StabilityRoot, StableSide};

/// Part of the growth at the ends above which a growth is not zero: the function has a jump.
const JUMP: f64 = 1e-2;
/// Part of the change of the growth between the ends that is small.
const SMALL: f64 = 1e-4;

/// A function of the roots that is zero at a boundary.
#[derive(Debug, Clone)]
enum Growth {
    /// The growth of this number among all, neutral roots left out, from zero.
    Rank(usize),
    /// Of the mode between these ends: values of the parameter, and roots.
    Followed(Box<[(f64, StabilityRoot); 2]>),
}

impl Growth {
    /// Index of its root among `roots` at a value, of which `neutral` are neutral.
    fn index(&self, at: f64, roots: &[StabilityRoot], neutral: usize) -> Option<usize> {
        match self {
            Self::Rank(rank) => {
                let indices = active(roots, neutral);
                let mut expanded = indices
                    .into_iter()
                    .flat_map(|index| std::iter::repeat_n(index, roots[index].kind.roots()));
                expanded.nth(*rank)
            }
            Self::Followed(ends) => {
                let [(a, first), (b, last)] = &**ends;
                let part = (at - a) / (b - a);
                let mut expected = [first.clone(), last.clone()];
                let between = first.exponent + (last.exponent - first.exponent) * part;
                expected.iter_mut().for_each(|end| end.exponent = between);
                let size = size(roots.iter());
                let cost = |root: &StabilityRoot| {
                    let costs = expected.iter().map(|end| cost(end, root, size).0);
                    costs.fold(f64::INFINITY, f64::min)
                };
                let costs = roots.iter().map(cost).enumerate();
                costs.min_by(|a, b| a.1.total_cmp(&b.1)).map(|own| own.0)
            }
        }
    }
}

/// Indices of the roots by falling growth without the `neutral` ones that are nearest to a multiplier
/// of one.
fn active(roots: &[StabilityRoot], neutral: usize) -> Vec<usize> {
    let mut indices: Vec<_> = (0..roots.len()).collect();
    let off = |index: &usize| {
        let multiplier = roots[*index].multiplier;
        multiplier.map_or(f64::INFINITY, |own| (own - 1.0).norm())
    };
    indices.sort_by(|a, b| off(a).total_cmp(&off(b)));
    indices.drain(..neutral.min(indices.len()));
    indices.sort_by(|a, b| roots[*b].growth().total_cmp(&roots[*a].growth()));
    indices
}

/// Number of neutral roots.
fn neutral(point: &StabilityPoint) -> usize {
    point.roots.iter().filter(|root| root.is_neutral).count()
}

/// The boundaries between two points with numbered modes.
///
/// # Errors
/// The value that failed, with reason and remedy.
pub(super) fn crossings(
    ends: [&StabilityPoint; 2],
    modes: &[String],
    tolerance: f64,
    evaluate: Evaluate<'_>,
) -> Result<Vec<StabilityBoundary>, (f64, [String; 2])> {
    let [a, b] = ends;
    let followed = links(&a.roots, &b.roots);
    let pairs = a.roots.iter().zip(followed);
    let changed = pairs.filter_map(|(root, link)| {
        let next = &b.roots[link?.to];
        (root.is_unstable() != next.is_unstable()).then_some((root, next))
    });
    let changed: Vec<_> = changed.collect();
    let rises = |pair: &(&StabilityRoot, &StabilityRoot)| pair.1.is_unstable();
    let mut search = Search {
        ends,
        modes,
        tolerance,
        evaluate,
        used: Vec::new(),
    };
    let mut found = Vec::new();
    if changed.iter().any(rises) && !changed.iter().all(rises) {
        for (first, last) in changed {
            let ends = [(a.at, first.clone()), (b.at, last.clone())];
            let growth = Growth::Followed(Box::new(ends));
            found.push(search.boundary(&growth, last.is_unstable())?);
        }
        return Ok(found);
    }
    let counts = [a.unstable(), b.unstable()];
    let mut rank = counts[0].min(counts[1]);
    while rank < counts[0].max(counts[1]) {
        let boundary = search.boundary(&Growth::Rank(rank), counts[1] > counts[0])?;
        rank += boundary.kind.roots();
        found.push(boundary);
    }
    Ok(found)
}

/// The search between two points.
struct Search<'a, 'b> {
    ends: [&'a StabilityPoint; 2],
    modes: &'a [String],
    tolerance: f64,
    evaluate: Evaluate<'b>,
    /// Modes that have a boundary in the interval.
    used: Vec<usize>,
}

impl Search<'_, '_> {
    /// The boundary at which a growth is zero; `rises` if the mode is unstable at the upper end.
    fn boundary(
        &mut self,
        growth: &Growth,
        rises: bool,
    ) -> Result<StabilityBoundary, (f64, [String; 2])> {
        let [a, b] = self.ends;
        let neutral = neutral(a).min(neutral(b));
        let own = |point: &StabilityPoint| {
            let index = growth.index(point.at, &point.roots, neutral)?;
            point.roots.get(index).cloned()
        };
        let (first, last) = own(a)
            .zip(own(b))
            .ok_or_else(|| (a.at, unresolved("a root is missing at an end")))?;
        let (calm, unstable, stable) = if rises {
            (&first, &last, StableSide::Below)
        } else {
            (&last, &first, StableSide::Above)
        };
        // At the end of an undamped mode its growth is round-off.
        let doubt = first.doubt.max(last.doubt);
        let zero = if calm.growth() < -calm.doubt {
            0.0
        } else {
            doubt.max(f64::MIN_POSITIVE)
        };
        let found = RefCell::new(Vec::new());
        let evaluate = &mut *self.evaluate;
        let mut value = |at: f64| {
            let roots = evaluate(at).map_err(|failure| (at, failure))?;
            let index = growth.index(at, &roots, neutral);
            let growth = index.map(|index| roots[index].growth());
            *found.borrow_mut() = roots;
            growth
                .map(|growth| growth - zero)
                .ok_or_else(|| (at, unresolved("a root is missing")))
        };
        let bracket = [[a.at, first.growth() - zero], [b.at, last.growth() - zero]];
        let at = root(&mut value, bracket, self.tolerance)?;
        let roots = found.into_inner();
        let index = growth.index(at, &roots, neutral).unwrap_or(0);
        let left = roots[index].growth() - zero;
        let change = (first.growth() - last.growth()).abs();
        let (index, other, name) = self.named(&roots, index, SMALL * change);
        if left.abs() > JUMP * change {
            return Err((at, unresolved("the growth jumps")));
        }
        Ok(StabilityBoundary {
            at,
            kind: unstable.kind,
            frequency: other.map_or(roots[index].frequency(), |other| {
                roots[index].others[other].frequency
            }),
            growth: roots[index].growth(),
            name,
            stable,
            unstable: [a.unstable(), b.unstable()],
        })
    }

    /// The root at `index`, or, if its mode has a boundary in this interval, another one whose growth is
    /// `small` \[1/s\], too; the other frequency at which it is shown; and the name of its mode.
    fn named(
        &mut self,
        roots: &[StabilityRoot],
        index: usize,
        small: f64,
    ) -> (usize, Option<usize>, String) {
        let [a, b] = self.ends;
        let nearer = match (roots.is_empty(), a.roots.is_empty()) {
            (false, false) => a,
            _ => b,
        };
        let mut modes = vec![None; roots.len()];
        for (link, mode) in links(&nearer.roots, roots).into_iter().zip(&nearer.modes) {
            if let Some(link) = link {
                modes[link.to] = Some((*mode, link.other));
            }
        }
        let mut all: Vec<_> = (0..roots.len()).collect();
        let size = |index: &usize| roots[*index].growth().abs();
        all.sort_by(|a, b| size(a).total_cmp(&size(b)));
        all.sort_by_key(|other| *other != index);
        let is_free = |other: &usize| {
            let is_used = modes[*other].is_some_and(|own| self.used.contains(&own.0));
            !is_used && (*other == index || size(other) <= small)
        };
        let chosen = all.into_iter().find(is_free).unwrap_or(index);
        match modes[chosen] {
            Some((mode, other)) => {
                self.used.push(mode);
                (chosen, other, self.modes[mode].clone())
            }
            None => (chosen, None, roots[chosen].name.clone()),
        }
    }
}

/// The failure of a search.
fn unresolved(reason: &str) -> [String; 2] {
    [
        format!("the boundary near this value is not resolved: {reason}"),
        "choose values nearer to each other, or more roots by \"count\"".to_owned(),
    ]
}
