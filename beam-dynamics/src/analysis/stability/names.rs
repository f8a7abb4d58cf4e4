//! Names of roots by the modes without air at the same value of the parameter.
//!
//! The modes without air have the kind of their own motion, and a number by ascending frequency among the modes of
//! one kind and pattern. A root has the name of the mode that [`assign`] gives it, from its magnitude and
//! its shape (D-425): oscillations first, then motions that decay without oscillation. Modes of one kind and pattern
//! do not cross but exchange their shapes, so that their roots have their numbers by ascending magnitude.
//!
//! Roots that decay and are no mode without air are the air's own: lags of its
//! induced velocities, of its circulation and of its separation. Without states of the air there are none.
//! The blades follow the slow ones of these without inertia: a root that decays with
//!
//! ```text
//! |s|^2 < w^2 / 4                                                                      (D-426)
//! ```
//!
//! the kinetic energy as a part of the potential one, is not the mode of this shape where the air has states.
//!
//! So the name of a root depends on the state at its value alone; where that is not clear, [`super::votes`] give one
//! name along a mode that continues.

use std::collections::BTreeMap;

use crate::modes::{assign, unlikeness};
use crate::result::StabilityRoot;

/// Frequency in the axes of the blades, relative to the growth, that is round-off.
const REAL: f64 = 1e-6;
/// Part of the potential energy below which the kinetic energy of a root is the one of a motion that follows
/// the air.
const INERTIA: f64 = 0.25;
/// Damping ratio of a mode without air that is round-off.
const UNDAMPED: f64 = 1e-6;
/// The name of roots of states of the air.
const OF_AIR: &str = "aerodynamic";

/// The roots of a value with names and numbers that identify them at all values. Of a model in air `vacuum` has
/// its modes without air, and whether the air has states.
pub(super) fn named(mut roots: Vec<StabilityRoot>, vacuum: Vacuum) -> Vec<StabilityRoot> {
    let has_modes = vacuum.is_some();
    give_names(&mut roots, vacuum);
    let is_same = |a: &StabilityRoot, b: &StabilityRoot| is_alike(a, b) && a.number == b.number;
    let is_once = |root: &StabilityRoot| {
        let is_mode = !has_modes || is_of_part(root) || root.unlikeness.is_some();
        is_mode && roots.iter().filter(|own| is_same(own, root)).count() == 1
    };
    let once: Vec<_> = roots.iter().map(is_once).collect();
    let both = roots.iter_mut().zip(once);
    both.for_each(|(root, is_once)| root.is_named = is_once);
    roots
}

/// Modes without air, and whether the air has states; `None` if no air acts or they are not known.
pub(super) type Vacuum = Option<(Vec<StabilityRoot>, bool)>;

/// Gives the roots of a value names and numbers.
pub(super) fn give_names(roots: &mut [StabilityRoot], vacuum: Vacuum) {
    match vacuum {
        Some(vacuum) => from_vacuum(roots, vacuum),
        None => number(roots),
    }
}

/// Gives each root its number among all of its name, by ascending frequency in the axes of the blades;
/// oscillations before others. Blades without one pattern have the place of a pattern that is missing.
fn number(roots: &mut [StabilityRoot]) {
    // Indices of the roots with each number, by names.
    let mut families: BTreeMap<String, Vec<Vec<usize>>> = BTreeMap::new();
    for index in order(roots) {
        let own = &roots[index];
        if own.pattern.is_none() {
            // It is numbered behind the pattern.
            roots[index].number = 1;
            continue;
        }
        let all = families.entry(own.name.clone()).or_default();
        let places = own.blades.unwrap_or(1).max(1);
        let fits = |family: &Vec<usize>| {
            let mut others = family.iter().map(|other| &roots[*other]);
            let all_have_patterns = others.clone().all(has_pattern);
            let has_place = family.len() < places || has_pattern(own) && all_have_patterns;
            has_place && !(has_pattern(own) && others.any(|other| is_alike(other, own)))
        };
        let place = all.iter().position(fits).unwrap_or(all.len());
        if place == all.len() {
            all.push(Vec::new());
        }
        all[place].push(index);
        roots[index].number = place + 1;
    }
}

/// Whether its blades have one pattern.
fn has_pattern(root: &StabilityRoot) -> bool {
    root.pattern.as_deref().is_some_and(|own| !own.is_empty())
}

/// Whether it is of a part outside the blades.
fn is_of_part(root: &StabilityRoot) -> bool {
    root.blades == Some(0)
}

/// Indices by ascending frequency in the axes of the blades, of roots that do not oscillate last.
fn order(roots: &[StabilityRoot]) -> Vec<usize> {
    let mut order: Vec<_> = (0..roots.len()).collect();
    order.sort_by(|a, b| {
        let [a, b] = [&roots[*a], &roots[*b]];
        let by_kind = is_real(a).cmp(&is_real(b));
        by_kind.then(a.in_blades.total_cmp(&b.in_blades))
    });
    order
}

/// Whether it does not oscillate, and is no mode that does at other values.
fn is_real(root: &StabilityRoot) -> bool {
    root.in_blades <= REAL * root.growth().abs() && !root.is_overdamped
}

fn is_alike(a: &StabilityRoot, b: &StabilityRoot) -> bool {
    (&a.name, &a.pattern) == (&b.name, &b.pattern) && b.pattern.is_some()
}

/// Gives the roots the names and numbers of the modes without air, or of the air.
fn from_vacuum(roots: &mut [StabilityRoot], (mut modes, has_states): (Vec<StabilityRoot>, bool)) {
    number(&mut modes);
    let mut mode_of = assigned(roots, (&modes, has_states));
    ascend(&mut mode_of, roots, &modes);
    // Parts outside the blades are named by their own motion: the air hardly changes it, but separates directions
    // of equal stiffness apart.
    number(roots);
    for (root, mode) in roots.iter_mut().zip(&mode_of) {
        match mode {
            Some(mode) => take(root, &modes[*mode]),
            None if is_of_part(root) => {}
            None if has_states && root.growth() < 0.0 => OF_AIR.clone_into(&mut root.name),
            None => {}
        }
    }
    let order = order(roots);
    let mut others: Vec<usize> = Vec::new();
    let is_other = |index: &usize| mode_of[*index].is_none() && !is_of_part(&roots[*index]);
    let unnamed: Vec<_> = order.into_iter().filter(is_other).collect();
    for index in unnamed {
        let own = &roots[index];
        let of_modes = modes.iter().filter(|mode| is_alike(mode, own)).count();
        let before = others.iter().filter(|other| is_alike(&roots[**other], own));
        roots[index].number = 1 + of_modes + before.count();
        others.push(index);
    }
}

/// The index of the mode of each root; `None` for roots that are no mode.
fn assigned(
    roots: &[StabilityRoot],
    (modes, has_states): (&[StabilityRoot], bool),
) -> Vec<Option<usize>> {
    let mut mode_of = vec![None; roots.len()];
    for of_real in [false, true] {
        let own: Vec<_> = (0..roots.len())
            .filter(|i| is_real(&roots[*i]) == of_real)
            .collect();
        let free: Vec<_> = (0..modes.len())
            .filter(|j| !mode_of.contains(&Some(*j)))
            .collect();
        let found = assign([own.len(), free.len()], |i, j| {
            let (root, mode) = (&roots[own[i]], &modes[free[j]]);
            match has_states && follows(root, mode) {
                true => f64::INFINITY,
                false => cost(root, mode),
            }
        });
        for (root, mode) in own.into_iter().zip(found) {
            mode_of[root] = mode.map(|mode| free[mode]);
        }
    }
    mode_of
}

/// Exchanges the modes of oscillations so that the ones of one motion and pattern ascend with their roots: two of them
/// do not cross, but exchange their shapes.
fn ascend(mode_of: &mut [Option<usize>], roots: &[StabilityRoot], modes: &[StabilityRoot]) {
    for (first, kind) in modes.iter().enumerate() {
        let alike = |mode: usize| is_alike(&modes[mode], kind);
        if (0..first).any(alike) {
            continue;
        }
        let is_own = |root: &usize| !is_real(&roots[*root]) && mode_of[*root].is_some_and(alike);
        let mut own: Vec<_> = (0..roots.len()).filter(is_own).collect();
        own.sort_by(|a, b| size(&roots[*a]).total_cmp(&size(&roots[*b])));
        let mut numbers: Vec<_> = own.iter().filter_map(|root| mode_of[*root]).collect();
        numbers.sort_by_key(|mode| modes[*mode].number);
        for (root, mode) in own.into_iter().zip(numbers) {
            mode_of[root] = Some(mode);
        }
    }
}

/// Gives the name of a mode without air to a root, which keeps its own pattern, or none, and notes whether this
/// mode is damped.
fn take(root: &mut StabilityRoot, mode: &StabilityRoot) {
    root.unlikeness = Some(cost(root, mode));
    root.name.clone_from(&mode.name);
    if root.pattern.is_none() {
        root.pattern.clone_from(&mode.pattern);
    }
    root.number = mode.number;
    root.has_no_structural_damping = mode.growth().abs() <= UNDAMPED * size(mode);
}

/// Magnitude in the axes of the blades \[1/s\].
pub(super) fn size(root: &StabilityRoot) -> f64 {
    root.growth().hypot(root.in_blades)
}

/// Whether the blades follow a root that decays without inertia (D-426), and that is no mode which oscillates at
/// other values.
fn follows(root: &StabilityRoot, mode: &StabilityRoot) -> bool {
    root.growth() < 0.0 && !root.is_overdamped && size(root).powi(2) < INERTIA * size(mode).powi(2)
}

/// Whether the blades move in different patterns: in the fixed frame a progressive mode and the conjugate of a
/// regressive one have one shape.
fn differ(a: &StabilityRoot, b: &StabilityRoot) -> bool {
    let [a, b] = [a, b].map(|root| root.pattern.as_deref().unwrap_or_default());
    !a.is_empty() && !b.is_empty() && a != b
}

/// c of a root and a mode without air (D-425).
fn cost(root: &StabilityRoot, mode: &StabilityRoot) -> f64 {
    if is_of_part(root) || is_of_part(mode) {
        return f64::INFINITY;
    }
    let Some(mac) = root.assurance(mode).filter(|_| !differ(root, mode)) else {
        return f64::INFINITY;
    };
    unlikeness([root, mode].map(size), mac)
}

#[cfg(test)]
mod tests {
    use nalgebra::Complex;

    use super::*;

    fn root(name: &str, pattern: &str, frequency: f64, blades: usize) -> StabilityRoot {
        StabilityRoot {
            name: name.to_owned(),
            pattern: Some(pattern.to_owned()),
            in_blades: frequency,
            blades: Some(blades),
            ..StabilityRoot::new(Complex::new(-0.1, frequency))
        }
    }

    // On a tower the backward whirl of edge 1 has no clear pattern: it has the place of the missing one, and the
    // backward whirl of edge 2 is no first one. Parts outside the blades have a number each.
    #[test]
    fn a_mode_without_a_pattern_has_the_place_of_the_missing_one() {
        let mut roots = [
            root("edge", "", 5.0, 3),
            root("edge", " collective", 5.1, 3),
            root("edge", " forward", 5.2, 3),
            root("edge", " backward", 14.0, 3),
            root("edge", " collective", 14.1, 3),
            root("edge", "", 14.2, 3),
            root("tower fore-aft", "", 1.5, 0),
            root("tower fore-aft", "", 12.0, 0),
            root("edge", " forward", 25.0, 3),
        ];
        number(&mut roots);
        let found: Vec<_> = roots.iter().map(|own| own.number).collect();
        assert_eq!(found, [1, 1, 1, 2, 2, 2, 1, 2, 3]);
    }
}
