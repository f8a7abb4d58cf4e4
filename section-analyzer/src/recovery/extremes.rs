//! Smallest and largest stresses and the worst failure indices of each region.

use super::criteria::{Criterion, FailureIndex, failure_indices};
use super::state::{Recovery, Tensors};
use crate::material::MaterialLimits;
use crate::section::Section;

/// The stresses that [`RegionStresses`] lists: six in section axes, six in material axes,
/// and the von Mises stress.
pub const STRESS_NAMES: [&str; 13] = [
    "xx",
    "yy",
    "zz",
    "yz",
    "xz",
    "xy",
    "11",
    "22",
    "33",
    "23",
    "13",
    "12",
    "von Mises",
];

/// A value and its location.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extreme {
    /// Stress \[Pa\].
    pub value: f64,
    /// Tag of the cell at integration points, of the node at nodes.
    pub tag: u64,
    /// Position (y, z) \[m\].
    pub position: [f64; 2],
}

/// Smallest and largest value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Smallest.
    pub min: Extreme,
    /// Largest.
    pub max: Extreme,
}

/// Extreme stresses of a region, in the order of [`STRESS_NAMES`].
#[derive(Debug, Clone, PartialEq)]
pub struct RegionStresses {
    /// Region: index of the physical surface in the mesh of the section.
    pub group: usize,
    /// Over the integration points; tags are cell tags.
    pub points: [Range; 13],
    /// Over the smoothed nodes; tags are node tags.
    pub nodes: [Range; 13],
}

/// The governing point of a region by one criterion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RegionFailure {
    /// Region: index of the physical surface in the mesh of the section.
    pub group: usize,
    /// Failure index at the integration point with the smallest reserve factor.
    pub worst: FailureIndex,
    /// Tag of its cell.
    pub tag: u64,
    /// Its position (y, z) \[m\].
    pub position: [f64; 2],
}

/// Extreme stresses of each region that has cells, in the order of the mesh.
pub fn region_stresses(section: &Section, recovery: &Recovery) -> Vec<RegionStresses> {
    let mesh = &section.mesh;
    let groups = 0..mesh.groups.len();
    let mut points = vec![None; groups.len()];
    for point in &recovery.points {
        let cell = &mesh.cells[point.cell];
        widen(
            &mut points[cell.group],
            &point.tensors,
            cell.tag,
            point.position,
        );
    }
    let mut nodes = vec![None; groups.len()];
    for state in &recovery.nodes {
        let (tag, position) = (mesh.node_tag(state.node), mesh.nodes[state.node]);
        widen(&mut nodes[state.group], &state.tensors, tag, position);
    }
    groups
        .filter_map(|group| {
            Some(RegionStresses {
                group,
                points: points[group]?,
                nodes: nodes[group]?,
            })
        })
        .collect()
}

/// The values of [`STRESS_NAMES`].
fn stresses(tensors: &Tensors) -> [f64; 13] {
    std::array::from_fn(|i| match i {
        0..6 => tensors.stress[i],
        6..12 => tensors.material_stress[i - 6],
        _ => tensors.von_mises(),
    })
}

fn widen(ranges: &mut Option<[Range; 13]>, tensors: &Tensors, tag: u64, position: [f64; 2]) {
    let here = stresses(tensors).map(|value| Extreme {
        value,
        tag,
        position,
    });
    let ranges = ranges.get_or_insert_with(|| here.map(|at| Range { min: at, max: at }));
    for (range, at) in ranges.iter_mut().zip(here) {
        if at.value < range.min.value {
            range.min = at;
        }
        if at.value > range.max.value {
            range.max = at;
        }
    }
}

/// The governing point of each region by each criterion for which its materials have
/// limits: the integration point with the smallest reserve factor. `limits` are parallel to
/// the materials of the section.
pub fn region_failures(
    section: &Section,
    limits: &[MaterialLimits],
    recovery: &Recovery,
) -> Vec<RegionFailure> {
    let mut worst: Vec<RegionFailure> = Vec::new();
    for point in &recovery.points {
        let cell = &section.mesh.cells[point.cell];
        let material = section.cells[point.cell].material;
        for found in failure_indices(&limits[material], &point.tensors) {
            let here = RegionFailure {
                group: cell.group,
                worst: found,
                tag: cell.tag,
                position: point.position,
            };
            let known = worst.iter_mut().find(|known| {
                known.group == here.group && known.worst.criterion == found.criterion
            });
            match known {
                Some(known) if found.reserve_factor < known.worst.reserve_factor => *known = here,
                Some(_) => {}
                None => worst.push(here),
            }
        }
    }
    worst.sort_by_key(|known| (known.group, known.worst.criterion));
    worst
}

/// The criteria for which any of the limits are given, in the order of [`Criterion::ALL`].
pub fn criteria_of(limits: &[MaterialLimits]) -> Vec<Criterion> {
    let mut criteria: Vec<_> = limits
        .iter()
        .flat_map(|limits| failure_indices(limits, &Tensors::default()))
        .map(|index| index.criterion)
        .collect();
    criteria.sort();
    criteria.dedup();
    criteria
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::analyze;
    use crate::material::Strength;
    use crate::recovery::{LoadCase, recover};
    use crate::section::samples::coupled_rectangle;
    use nalgebra::Vector6;
    use shared_geom::mesh::CellKind;

    /// The extremes against a plain search, and the smallest reserve factor against the
    /// largest von Mises stress, which is at the same point.
    #[test]
    fn extremes_are_those_of_a_plain_search() {
        let section = coupled_rectangle(CellKind::Quadrilateral8);
        let load = LoadCase {
            name: "load".into(),
            force: Vector6::new(1.0, 2.0, -1.0, 0.5, 0.3, -0.2),
            imposed: Vec::new(),
            voltages: Vec::new(),
        };
        let recovery = recover(&section, &analyze(&section).unwrap(), &load).unwrap();
        let [region] = &region_stresses(&section, &recovery)[..] else {
            panic!("one region");
        };
        let values = recovery.points.iter().map(|point| point.tensors.stress[5]);
        assert_eq!(
            region.points[5].max.value,
            values.clone().fold(f64::MIN, f64::max)
        );
        assert_eq!(region.points[5].min.value, values.fold(f64::MAX, f64::min));
        let nodes = recovery.nodes.iter().map(|node| node.tensors.von_mises());
        let largest = nodes.fold(0.0, f64::max);
        assert_eq!(region.nodes[12].max.value, largest);

        let limits = [MaterialLimits {
            strength: Some(Strength::Yield(3.0)),
            ..MaterialLimits::default()
        }];
        assert_eq!(criteria_of(&limits), [Criterion::VonMises]);
        let [failure] = &region_failures(&section, &limits, &recovery)[..] else {
            panic!("one criterion");
        };
        let highest = region.points[12].max;
        assert_eq!(
            (failure.tag, failure.position),
            (highest.tag, highest.position)
        );
        assert_eq!(failure.worst.index, highest.value / 3.0);
    }
}
