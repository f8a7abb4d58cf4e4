//! Which root at one value of the parameter is which at the next.
//!
//! ```text
//! c_ij = |s_i - s_j| / s_0 + 3 (1 - MAC_ij) ,     s_0 = mean |s|                     (D-330)
//! ```
//!
//! Pairs are taken by rising c, each root once; whirls of a rotor that differ in their number of
//! waves are no pair, since the conjugate of a forward whirl has the shape of a backward one. Where
//! the energy of a mode is shared by several frequencies, c is the least one of them, each with the
//! shape that it has there, and the mode continues at that frequency.

use std::collections::BTreeSet;

use crate::result::{StabilityPoint, StabilityRoot};

/// Weight of the shape beside the exponent [-].
const WEIGHT: f64 = 3.0;
/// Largest c of two roots that are treated as the same one; beyond it only near ones are.
const SAME: f64 = 2.0;
/// Distance of exponents, in s_0, up to which roots of any shapes are the same.
const NEAR: f64 = 0.1;
/// Part of the energy at the chosen frequency above which a mode may be followed at another one.
const SEEN: f64 = 0.3;

/// The continuation of a root.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Link {
    /// Its index among the roots after.
    pub to: usize,
    /// The other frequency of it at which it is continued.
    pub other: Option<usize>,
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

/// Cost of the pair of two roots, its distance of the exponents, and the other frequency of the second
/// root at which it is least, if it is not at the one that it has.
pub(super) fn cost(a: &StabilityRoot, b: &StabilityRoot, size: f64) -> (f64, f64, Option<usize>) {
    let cost = |frequency: f64, mac: Option<f64>, other| {
        let distance = (b.growth() - a.growth()).hypot(frequency - a.frequency()) / size;
        (
            distance + WEIGHT * (1.0 - mac.unwrap_or(1.0)),
            distance,
            other,
        )
    };
    let own = cost(b.frequency(), b.assurance(a), None);
    let others = b.others.iter().enumerate();
    let others = others.filter(|(_, seen)| seen.share > SEEN * b.share);
    let others = others.map(|(k, seen)| cost(seen.frequency, a.assurance_with(seen), Some(k)));
    others.fold(own, |a, b| if b.0 < a.0 { b } else { a })
}

/// For each root before, its continuation among the roots after.
pub fn links(before: &[StabilityRoot], after: &[StabilityRoot]) -> Vec<Option<Link>> {
    let size = size(before.iter().chain(after));
    let mut pairs = Vec::new();
    for (i, a) in before.iter().enumerate() {
        for (j, b) in after.iter().enumerate() {
            let (cost, distance, other) = cost(a, b, size);
            let differ = a.waves.zip(b.waves).is_some_and(|(a, b)| a != b);
            let is_alike = a.is_neutral == b.is_neutral && !differ;
            if is_alike && (cost < SAME || distance < NEAR) {
                pairs.push((cost, i, Link { to: j, other }));
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

/// Numbers the modes through all points and keeps the frequency of each mode; returns their names. Roots whose
/// names identify them are the mode of this name. Others are followed: a
/// mode that was missing continues where a root of its name and pattern is near to its last one. New
/// modes of a point are named by ascending frequency in the axes of the blades.
pub(super) fn number(points: &mut [StabilityPoint]) -> Vec<String> {
    // Names of identified modes are the ones of no other.
    let all = points.iter().flat_map(|point| &point.roots);
    let identified = all.filter(|root| root.is_named);
    let reserved: BTreeSet<String> = identified.map(|root| numbered(root, root.number)).collect();
    let mut names: Vec<String> = Vec::new();
    // The last root of each mode.
    let mut last: Vec<StabilityRoot> = Vec::new();
    for index in 0..points.len() {
        let (before, rest) = points.split_at_mut(index);
        let roots = &mut rest[0].roots;
        let mut modes: Vec<_> = roots.iter().map(|root| known(&names, root)).collect();
        let present = before.last().map_or(&[][..], |before| &before.modes);
        let free = |mode: &usize| !last[*mode].is_named;
        let (present, absent): (Vec<_>, Vec<_>) = (0..last.len())
            .filter(free)
            .partition(|mode| present.contains(mode));
        continued(&present, (&last, false), roots, &mut modes);
        continued(&absent, (&last, true), roots, &mut modes);
        let mut new: Vec<_> = (0..modes.len()).filter(|i| modes[*i].is_none()).collect();
        // Real roots that are no overdamped modes after the oscillations.
        let order = |index: &usize| {
            let root: &StabilityRoot = &roots[*index];
            let is_real = root.frequency() == 0.0 && !root.is_overdamped;
            (is_real, root.in_blades)
        };
        new.sort_by(|a, b| {
            let (a, b) = (order(a), order(b));
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
        });
        for index in new {
            names.push(new_name((&names, &reserved), &roots[index]));
            last.push(roots[index].clone());
            modes[index] = Some(names.len() - 1);
        }
        let modes: Vec<_> = modes.into_iter().flatten().collect();
        for (root, mode) in roots.iter().zip(&modes) {
            last[*mode].clone_from(root);
        }
        rest[0].modes = modes;
    }
    names
}

/// The mode of this name, if names identify modes.
fn known(names: &[String], root: &StabilityRoot) -> Option<usize> {
    let name = numbered(root, root.number);
    let index = names.iter().position(|other| *other == name);
    index.filter(|_| root.is_named)
}

/// Gives roots without a mode the ones of `candidates` that they continue, from the last root of each.
/// Modes that were `absent` have the names of the roots.
fn continued(
    candidates: &[usize],
    (last, absent): (&[StabilityRoot], bool),
    roots: &mut [StabilityRoot],
    modes: &mut [Option<usize>],
) {
    let is_free = |i: &usize| modes[*i].is_none() && !roots[*i].is_named;
    let free: Vec<_> = (0..roots.len()).filter(is_free).collect();
    let before: Vec<_> = candidates.iter().map(|mode| last[*mode].clone()).collect();
    let after: Vec<_> = free.iter().map(|index| roots[*index].clone()).collect();
    let key = |root: &StabilityRoot| (root.name.clone(), root.pattern.clone());
    for (i, link) in links(&before, &after).into_iter().enumerate() {
        let Some(link) = link else { continue };
        if !absent || key(&before[i]) == key(&after[link.to]) {
            if let Some(other) = link.other {
                roots[free[link.to]].show_at(other);
            }
            modes[free[link.to]] = Some(candidates[i]);
        }
    }
}

/// The name of an identified root, or else one that no mode has, from the number of the root on.
fn new_name((names, reserved): (&[String], &BTreeSet<String>), root: &StabilityRoot) -> String {
    if root.is_named {
        return numbered(root, root.number);
    }
    let mut numbers = (root.number..).map(|number| numbered(root, number));
    numbers
        .find(|name| !names.contains(name) && !reserved.contains(name))
        .unwrap_or_else(|| root.name.clone())
}

/// The name of a root with a number.
fn numbered(root: &StabilityRoot, number: usize) -> String {
    let stem = &root.name;
    match (&root.pattern, number) {
        (Some(pattern), _) => format!("{stem} {number}{pattern}"),
        (None, _) if stem.is_empty() => format!("mode {number}"),
        (None, 1) => stem.clone(),
        (None, _) => format!("{stem} ({number})"),
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Complex;

    use super::*;

    fn point(roots: &[(&str, f64)]) -> StabilityPoint {
        let root = |(name, frequency): &(&str, f64)| {
            let mut root = StabilityRoot::new(Complex::new(-1.0, *frequency));
            root.name = (*name).to_owned();
            root.pattern = Some(String::new());
            root
        };
        StabilityPoint {
            at: 0.0,
            is_requested: true,
            roots: roots.iter().map(root).collect(),
            modes: Vec::new(),
            controls: Vec::new(),
        }
    }

    #[test]
    fn a_mode_that_was_missing_keeps_its_number() {
        let both = [("edge", 4.0), ("flap", 10.0), ("flap", 20.0)];
        let mut points = [&both[..], &both[..2], &both[..1], &both].map(point);
        assert_eq!(number(&mut points), ["edge 1", "flap 1", "flap 2"]);
        assert_eq!(points[3].modes, [0, 1, 2]);
        // Another motion at the place of the missing one is another mode.
        let other = [("edge", 4.0), ("torsion", 10.0), ("flap", 20.0)];
        let mut points = [&both[..], &both[..1], &other].map(point);
        let expected = ["edge 1", "flap 1", "flap 2", "torsion 1"];
        assert_eq!(number(&mut points), expected);
        assert_eq!(points[2].modes, [0, 3, 2]);
    }
}
