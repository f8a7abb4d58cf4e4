//! The largest damage of the regions of a section by histories of the internal force.
//!
//! The components of stress and strain in material axes are linear in the internal force,
//! `s(t) = a theta(t)`, so that the cycles of each component at each point follow from the
//! histories alone. Most of them are not counted: with the range of values `[u, v]`, the ratio
//! `rho` of one cycle from u to v, and the total variation V, which is twice the sum of all ranges,
//!
//! ```text
//! D = sum n_i rho_i^m <= rho^(m-1) V / (4 min(T - v, C + u))                        (S-174)
//! V(s) <= sum_j |a_j| V(theta_j)
//! ```
//!
//! Components are counted in the order of these bounds, as long as a bound is larger than the damage
//! that has been found, or one is at least one with the loads times the smallest reserve factor
//! that has been found: the others have no effect on the result. A reserve factor is computed
//! only if the damage with the smallest one that has been found is above one.

use std::collections::BTreeMap;

use nalgebra::{RowVector6, Vector6};

use super::force_tree::ForceTree;
use super::goodman::ConstantLife;
use super::rainflow::{Cycle, cycles};
use super::unit::{UnitPoint, weights};
use crate::material::{
    DirectionalLimits, MaterialLimits, Slopes, StrainLimit, Strength, UniformLimits,
};
use crate::section::Section;

/// More than the round-off of a bound, relative to it.
const SLACK: f64 = 1e-9;

/// Internal forces about the reference point over time.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LoadHistory {
    /// In the order of time \[N, N m\].
    pub forces: Vec<Vector6<f64>>,
    /// How often they occur \[-\].
    pub repetitions: f64,
}

impl LoadHistory {
    /// The cycles of a linear function of the force in all histories together.
    pub fn cycles(histories: &[Self], row: &RowVector6<f64>) -> Vec<Cycle> {
        let of_one = |history: &Self| {
            let mut counted = cycles(history.forces.iter().map(|theta| (row * theta).x));
            for cycle in &mut counted {
                cycle.count *= history.repetitions;
            }
            counted
        };
        histories.iter().flat_map(of_one).collect()
    }

    /// As [`Self::cycles`], and a cycle without range for each history in which the function is
    /// constant.
    fn cycles_and_means(histories: &[Self], row: &RowVector6<f64>) -> Vec<Cycle> {
        let of_one = |history: &Self| {
            let mut counted = Self::cycles(std::slice::from_ref(history), row);
            if counted.is_empty() {
                counted.extend(history.forces.first().map(|theta| Cycle {
                    range: 0.0,
                    mean: (row * theta).x,
                    count: history.repetitions,
                }));
            }
            counted
        };
        histories.iter().flat_map(of_one).collect()
    }

    /// Total variation of each component of all histories \[N, N m\].
    fn variation(histories: &[Self]) -> Vector6<f64> {
        let of_one = |history: &Self| {
            let steps = history.forces.windows(2);
            let sum: Vector6<f64> = steps.map(|pair| (pair[1] - pair[0]).abs()).sum();
            history.repetitions * sum
        };
        histories.iter().map(of_one).sum()
    }
}

/// A component of stress or strain in material axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Component {
    /// Whether it is a strain.
    pub is_strain: bool,
    /// Index in the order 11 22 33 23 13 12.
    pub index: usize,
}

impl Component {
    /// Name and unit for tables.
    pub fn name(self) -> String {
        const AXES: [&str; 6] = ["11", "22", "33", "23", "13", "12"];
        if self.is_strain {
            format!("strain {} [-]", AXES[self.index])
        } else {
            format!("stress {} [Pa]", AXES[self.index])
        }
    }

    /// Its value per unit internal force.
    fn row(self, point: &UnitPoint) -> RowVector6<f64> {
        let tensor = if self.is_strain {
            &point.material_strain
        } else {
            &point.material_stress
        };
        tensor.row(self.index).into_owned()
    }
}

/// The point and component of a region with the largest damage, and its smallest reserve factor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RegionDamage {
    /// Region: index of the physical surface in the mesh of the section.
    pub group: usize,
    /// Index of the material.
    pub material: usize,
    /// The component.
    pub component: Component,
    /// Its constant-life diagram.
    pub life: ConstantLife,
    /// Miner's sum \[-\].
    pub damage: f64,
    /// The smallest factor on all loads at which a point and component of the region has the damage
    /// one \[-\].
    pub reserve_factor: f64,
    /// Number of cycles \[-\].
    pub cycles: f64,
    /// The cycle with the largest range; zero without cycles \[Pa or -\].
    pub largest: Cycle,
    /// Tag of the cell.
    pub tag: u64,
    /// Its position (y, z) \[m\].
    pub position: [f64; 2],
}

/// A component at a point, and an upper bound of its damage.
struct Candidate<'a> {
    bound: f64,
    point: &'a UnitPoint,
    component: Component,
    life: ConstantLife,
    /// Its smallest and largest value \[Pa or -\].
    range: [f64; 2],
    /// An upper bound of its total variation \[Pa or -\].
    variation: f64,
}

impl Candidate<'_> {
    /// Whether its reserve factor may be less than `factor`.
    fn may_be_below(&self, factor: f64) -> bool {
        if factor.is_infinite() {
            return self.range != [0.0; 2];
        }
        let range = self.range.map(|value| factor * value);
        bound(&self.life, range, factor * self.variation) >= 1.0
    }
}

/// The candidate with the largest damage, and the smallest reserve factor of all.
struct Worst<'a> {
    candidate: Candidate<'a>,
    cycles: Vec<Cycle>,
    damage: f64,
    least_factor: f64,
}

impl Worst<'_> {
    /// Its own reserve factor.
    fn own_factor(&self) -> f64 {
        self.candidate.life.reserve_factor(&self.cycles)
    }
}

/// The largest damage of each region whose material has slopes of S-N lines, over all integration
/// points and components. Histories that do not occur have no effect.
pub fn region_damages(
    section: &Section,
    limits: &[MaterialLimits],
    points: &[UnitPoint],
    histories: &[LoadHistory],
) -> Vec<RegionDamage> {
    let measures: Vec<_> = limits.iter().map(measures).collect();
    let occurring = histories.iter().filter(|history| history.repetitions > 0.0);
    let histories: Vec<LoadHistory> = occurring.cloned().collect();
    let forces: Vec<Vector6<f64>> = histories
        .iter()
        .flat_map(|history| history.forces.iter().copied())
        .collect();
    let tree = ForceTree::new(&forces, &weights(points));
    let variation = LoadHistory::variation(&histories);
    let mut regions: BTreeMap<usize, Vec<Candidate<'_>>> = BTreeMap::new();
    for point in points {
        let material = section.cells[point.cell].material;
        let group = section.mesh.cells[point.cell].group;
        for &(component, life) in &measures[material] {
            let row = component.row(point);
            let (range, variation) = (tree.range_of(&row), (row.abs() * variation).x);
            let candidate = Candidate {
                bound: bound(&life, range, variation),
                point,
                component,
                life,
                range,
                variation,
            };
            regions.entry(group).or_default().push(candidate);
        }
    }
    let regions = regions.into_iter();
    let worst = regions.filter_map(|(group, all)| Some((group, worst(all, &histories)?)));
    worst
        .map(|(group, worst)| reported(group, &worst, section))
        .collect()
}

/// An upper bound of the damage of a component with values in a range.
fn bound(life: &ConstantLife, [low, high]: [f64; 2], variation: f64) -> f64 {
    let least = (life.tension - high).min(life.compression + low);
    if least <= 0.0 {
        return f64::INFINITY;
    }
    let ratio = life.ratio(high - low, 0.5 * (low + high));
    (1.0 + SLACK) * ratio.powf(life.slope - 1.0) * variation / (4.0 * least)
}

fn worst<'a>(mut candidates: Vec<Candidate<'a>>, histories: &[LoadHistory]) -> Option<Worst<'a>> {
    candidates.sort_by(|a, b| b.bound.total_cmp(&a.bound));
    let mut best: Option<Worst<'a>> = None;
    for candidate in candidates {
        let (known, least) = best.as_ref().map_or((-1.0, f64::INFINITY), |best| {
            (best.damage, best.least_factor)
        });
        if candidate.bound <= known && !candidate.may_be_below(least) {
            continue;
        }
        let row = candidate.component.row(candidate.point);
        let cycles = LoadHistory::cycles_and_means(histories, &row);
        let damage = candidate.life.damage(&cycles);
        let is_below = least.is_infinite()
            || candidate.may_be_below(least) && candidate.life.is_below(&cycles, least);
        let least_factor = if is_below {
            least.min(candidate.life.reserve_factor(&cycles))
        } else {
            least
        };
        let found = Worst {
            candidate,
            cycles,
            damage,
            least_factor,
        };
        match &mut best {
            Some(best)
                if damage < known
                    || (damage == known && found.own_factor() >= best.own_factor()) =>
            {
                best.least_factor = least_factor;
            }
            _ => best = Some(found),
        }
    }
    best
}

fn reported(group: usize, worst: &Worst<'_>, section: &Section) -> RegionDamage {
    let none = Cycle {
        range: 0.0,
        mean: 0.0,
        count: 0.0,
    };
    let counted = worst.cycles.iter().filter(|cycle| cycle.range > 0.0);
    let largest = counted.clone().fold(none, |most, cycle| {
        if cycle.range > most.range {
            *cycle
        } else {
            most
        }
    });
    let found = &worst.candidate;
    RegionDamage {
        group,
        material: section.cells[found.point.cell].material,
        component: found.component,
        life: found.life,
        damage: worst.damage,
        reserve_factor: worst.least_factor,
        cycles: counted.fold(0.0, |sum, cycle| sum + cycle.count),
        largest,
        tag: section.mesh.cells[found.point.cell].tag,
        position: found.point.position,
    }
}

/// The components with a limit and a slope, and their diagrams.
fn measures(limits: &MaterialLimits) -> Vec<(Component, ConstantLife)> {
    let mut found = Vec::new();
    let mut add = |is_strain: bool, limits: DirectionalLimits, slopes: Slopes| {
        found.extend((0..6).filter_map(|index| {
            let slope = if index == 0 {
                slopes.fiber?
            } else {
                slopes.matrix
            };
            let [tension, compression] = match index {
                0..3 => [limits.tension[index], limits.compression[index]],
                _ => [limits.shear[index - 3]; 2],
            };
            let life = ConstantLife {
                tension,
                compression,
                slope,
            };
            Some((Component { is_strain, index }, life))
        }));
    };
    let uniform = |limits: &UniformLimits| DirectionalLimits {
        tension: [limits.tension; 3],
        compression: [limits.compression; 3],
        shear: [limits.shear; 3],
    };
    if let (Some(strength), Some(slopes)) = (&limits.strength, limits.fatigue.stress) {
        let limits = match strength {
            Strength::Ply { limits, .. } => *limits,
            Strength::Uniform(limits) => uniform(limits),
            Strength::Yield(stress) => DirectionalLimits {
                tension: [*stress; 3],
                compression: [*stress; 3],
                // von Mises
                shear: [stress / 3f64.sqrt(); 3],
            },
        };
        add(false, limits, slopes);
    }
    if let (Some(strain), Some(slopes)) = (&limits.strain, limits.fatigue.strain) {
        let limits = match strain {
            StrainLimit::Ply(limits) => *limits,
            StrainLimit::Uniform(limits) => uniform(limits),
        };
        add(true, limits, slopes);
    }
    found
}

#[cfg(test)]
#[path = "fatigue_tests.rs"]
mod tests;
