//! Which root at one value of the parameter is which at the next.
//!
//! ```text
//! c_ij = |s_i - s_j| / s_0 + 3 (1 - MAC_ij) ,     s_0 = mean |s|                     (D-330)
//! ```
//!
//! Pairs are taken by rising c, each root once; whirls of a rotor that differ in their number of
//! waves are no pair, since the conjugate of a forward whirl has the shape of a backward one. Where
//! the energy of a mode is shared by several frequencies, the one that is nearest to the frequency
//! before is kept.

use crate::result::{StabilityPoint, StabilityRoot};

/// Weight of the shape beside the exponent [-].
const WEIGHT: f64 = 3.0;
/// Largest c of two roots that are treated as the same one; beyond it only near ones are.
const SAME: f64 = 2.0;
/// Distance of exponents, in s_0, up to which roots of any shapes are the same.
const NEAR: f64 = 0.1;
/// Assurance of frequencies beside the one whose shape is known.
const BESIDE: f64 = 0.7;

/// The continuation of a root.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Link {
    /// Its index among the roots after.
    pub to: usize,
    /// The frequency at which it is continued \[rad/s\].
    pub frequency: f64,
}

/// The mean magnitude of the exponents \[1/s\]; one if all are zero.
pub(super) fn size<'a>(roots: impl Iterator<Item = &'a StabilityRoot>) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    for root in roots {
        sum += root.exponent.norm();
        count += 1.0;
    }
    if sum > 0.0 { sum / count } else { 1.0 }
}

/// Cost of the pair of two roots, its distance of the exponents, and the frequency of the second one.
pub(super) fn cost(a: &StabilityRoot, b: &StabilityRoot, size: f64) -> [f64; 3] {
    let distance =
        |frequency: f64| (b.growth() - a.growth()).hypot(frequency - a.frequency()) / size;
    let own = b.assurance(a).unwrap_or(1.0);
    let known = (b.frequency(), own);
    let others = b.others.iter().map(|frequency| (*frequency, BESIDE));
    let costs = std::iter::once(known)
        .chain(others)
        .map(|(frequency, mac)| {
            let distance = distance(frequency);
            [distance + WEIGHT * (1.0 - mac), distance, frequency]
        });
    costs
        .reduce(|a, b| if b[0] < a[0] { b } else { a })
        .unwrap_or([f64::INFINITY; 3])
}

/// For each root before, its continuation among the roots after.
pub fn links(before: &[StabilityRoot], after: &[StabilityRoot]) -> Vec<Option<Link>> {
    let size = size(before.iter().chain(after));
    let mut pairs = Vec::new();
    for (i, a) in before.iter().enumerate() {
        for (j, b) in after.iter().enumerate() {
            let [cost, distance, frequency] = cost(a, b, size);
            let differ = a.waves.zip(b.waves).is_some_and(|(a, b)| a != b);
            let is_alike = a.is_neutral == b.is_neutral && !differ;
            if is_alike && (cost < SAME || distance < NEAR) {
                pairs.push((cost, i, Link { to: j, frequency }));
            }
        }
    }
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut found = vec![None; before.len()];
    let mut is_taken = vec![false; after.len()];
    for (_, i, link) in pairs {
        if found[i].is_none() && !is_taken[link.to] {
            (found[i], is_taken[link.to]) = (Some(link), true);
        }
    }
    found
}

/// Numbers the modes through all points and keeps the frequency of each mode; returns their names. New
/// modes of a point are named by ascending frequency.
pub(super) fn number(points: &mut [StabilityPoint]) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for index in 0..points.len() {
        let (before, rest) = points.split_at_mut(index);
        let point = &mut rest[0];
        let mut modes = vec![None; point.roots.len()];
        if let Some(before) = before.last() {
            for (i, link) in links(&before.roots, &point.roots).into_iter().enumerate() {
                if let Some(link) = link {
                    point.roots[link.to].exponent.im = link.frequency;
                    modes[link.to] = Some(before.modes[i]);
                }
            }
        }
        let mut new: Vec<_> = (0..modes.len()).filter(|i| modes[*i].is_none()).collect();
        let frequency = |index: &usize| point.roots[*index].frequency();
        new.sort_by(|a, b| frequency(a).total_cmp(&frequency(b)));
        for index in new {
            names.push(new_name(&names, &point.roots[index]));
            modes[index] = Some(names.len() - 1);
        }
        point.modes = modes.into_iter().flatten().collect();
    }
    names
}

/// A name that no mode has.
fn new_name(names: &[String], root: &StabilityRoot) -> String {
    let stem = &root.name;
    let numbered = |number: usize| match (&root.pattern, number) {
        (Some(pattern), _) => format!("{stem} {number}{pattern}"),
        (None, _) if stem.is_empty() => format!("mode {number}"),
        (None, 1) => stem.clone(),
        (None, _) => format!("{stem} ({number})"),
    };
    let mut numbers = (1..).map(numbered);
    numbers
        .find(|name| !names.contains(name))
        .unwrap_or_else(|| stem.clone())
}
