//! Finds the electrodes on the mesh, by the names that they give.

use std::collections::HashMap;

use shared_geom::error::quoted;

use super::{
    ElectrodeProblem, WrittenElectrode, WrittenElectrodes, WrittenFingers, WrittenLocation,
};
use crate::input::distributed::{DistributedProblem, Lookup, groups_of};
use crate::input::groups;
use crate::input::regions::Written;
use crate::mesh::SectionMesh;

/// An electrode on the mesh; nothing is known about materials yet.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::input) enum Found {
    /// A conductor.
    Conductor {
        /// Nodes, ascending, each once.
        nodes: Vec<u32>,
        /// Whether it is a body of cells rather than a line.
        is_body: bool,
    },
    /// Fingers across the beam.
    Fingers {
        /// Regions, indices in the groups of the mesh, each once, with the sign of the field.
        groups: Vec<(usize, f64)>,
        /// Effective spacing \[m\].
        spacing: f64,
        /// Material axis of the field, from zero.
        axis: usize,
    },
}

impl WrittenElectrodes {
    /// Electrodes on the mesh; `None` if the names of one have a problem, which has been
    /// noted.
    pub fn on_mesh(&self, lookup: Lookup<'_>) -> Option<Vec<Found>> {
        // all electrodes are checked before the first wrong one ends the search
        self.note_unknown(lookup.document);
        let found: Vec<_> = self.all.iter().map(|one| one.on_mesh(lookup)).collect();
        found.into_iter().collect()
    }
}

impl WrittenElectrode {
    fn on_mesh(&self, lookup: Lookup<'_>) -> Option<Found> {
        match self.location.as_ref()? {
            WrittenLocation::Curves(names) => {
                let nodes = all(names.iter().map(|name| nodes_of_curve(lookup, name)))?;
                Some(conductor(nodes, false))
            }
            WrittenLocation::Points(names) => {
                let tags = all(names
                    .iter()
                    .map(|name| groups::point(lookup.document, lookup.mesh, name)))?;
                let mesh = lookup.section_mesh?;
                // nodes without cells are not part of the section
                let nodes =
                    (0..mesh.nodes.len()).filter(|node| tags.contains(&mesh.node_tag(*node)));
                Some(conductor(nodes.map(|node| node as u32).collect(), false))
            }
            WrittenLocation::Regions(names) => {
                let groups = all(names.iter().map(|name| groups_of(lookup, name)))?;
                let mesh = lookup.section_mesh?;
                let cells = mesh
                    .cells
                    .iter()
                    .filter(|cell| groups.contains(&cell.group));
                let nodes = cells.flat_map(|cell| cell.nodes().to_vec());
                Some(conductor(nodes.collect(), true))
            }
            WrittenLocation::Fingers(fingers) => fingers.on_mesh(lookup),
        }
    }

    /// Its location as text.
    pub fn location_words(&self) -> String {
        let names = |names: &[Written]| {
            let names: Vec<_> = names.iter().map(|name| name.text.clone()).collect();
            quoted(&names)
        };
        match &self.location {
            Some(WrittenLocation::Curves(curves)) => format!("curve {}", names(curves)),
            Some(WrittenLocation::Points(points)) => format!("point {}", names(points)),
            Some(WrittenLocation::Regions(regions)) => format!("region {}", names(regions)),
            Some(WrittenLocation::Fingers(fingers)) => {
                let regions = fingers.regions.as_deref().unwrap_or_default();
                format!("interdigitated {}", names(regions))
            }
            None => String::new(),
        }
    }
}

impl WrittenFingers {
    fn on_mesh(&self, lookup: Lookup<'_>) -> Option<Found> {
        // the names of both lists are looked up even if the others are wrong
        let regions = self.regions.as_ref();
        let regions =
            regions.and_then(|names| all(names.iter().map(|name| groups_of(lookup, name))));
        let reversed = self.reversed.iter().flatten();
        let reversed: Vec<_> = reversed
            .map(|name| (name, groups_of(lookup, name)))
            .collect();
        let regions = regions?;
        let mut signs: HashMap<usize, f64> = regions.iter().map(|group| (*group, 1.0)).collect();
        let mut is_sound = self.reversed.is_some();
        for (name, groups) in reversed {
            let Some(groups) = groups else {
                is_sound = false;
                continue;
            };
            if !groups.iter().all(|group| signs.contains_key(group)) {
                let regions = self.regions.iter().flatten();
                let problem = ElectrodeProblem::ReversedElsewhere {
                    region: name.text.clone(),
                    regions: regions.map(|name| name.text.clone()).collect(),
                };
                lookup.document.note(name.line, &problem);
                is_sound = false;
                continue;
            }
            signs.extend(groups.into_iter().map(|group| (group, -1.0)));
        }
        let mut groups: Vec<_> = signs.into_iter().collect();
        groups.sort_by_key(|(group, _)| *group);
        let (spacing, axis) = (self.spacing?, self.axis?);
        is_sound.then_some(Found::Fingers {
            groups,
            spacing,
            axis,
        })
    }
}

fn conductor(mut nodes: Vec<u32>, is_body: bool) -> Found {
    nodes.sort_unstable();
    nodes.dedup();
    Found::Conductor { nodes, is_body }
}

/// The combined results of several searches; all of them are made.
fn all<T>(searches: impl Iterator<Item = Option<Vec<T>>>) -> Option<Vec<T>> {
    let found: Vec<_> = searches.collect();
    let found: Option<Vec<_>> = found.into_iter().collect();
    Some(found?.into_iter().flatten().collect())
}

fn nodes_of_curve(lookup: Lookup<'_>, written: &Written) -> Option<Vec<u32>> {
    let Lookup {
        document,
        mesh,
        faces,
        ..
    } = lookup;
    if faces.is_open(&written.text) {
        return None;
    }
    let group = groups::curve(document, mesh, written)?;
    let label = mesh.groups[group].label();
    let section_mesh: &SectionMesh = lookup.section_mesh?;
    let curve = section_mesh.curves.iter().find(|c| c.label == label)?;
    match section_mesh.nodes_of_curve(curve) {
        Ok(nodes) => Some(nodes),
        Err(line) => {
            let problem = DistributedProblem::NoSide {
                curve: written.text.clone(),
                line: line.tag,
                at: [0, 1].map(|axis| 0.5 * (line.first[axis] + line.second[axis])),
                faces: faces.on(&label),
            };
            document.note(written.line, &problem);
            None
        }
    }
}
