//! Assigns each cell to its region.

use std::collections::BTreeMap;

use shared_geom::document::Document;
use shared_geom::mesh::{GroupKind, GroupSet, Mesh, PhysicalGroup};

use super::problem::InputProblem;
use super::regions::{Written, WrittenRegion};

const SURFACE: u8 = 2;
const CURVE: u8 = 1;
const POINT: u8 = 0;

/// The physical group named `written`: by its name, otherwise by its number. An unknown
/// group is noted, with the nearest name.
fn find(document: &Document, mesh: &Mesh, dimension: u8, written: &Written) -> Option<usize> {
    let found = named(mesh, dimension, written);
    if found.is_none() {
        let of_dimension = mesh
            .groups
            .iter()
            .filter(|group| group.dimension == dimension);
        let problem = InputProblem::UnknownGroup {
            kind: kind(mesh, dimension),
            group: written.text.clone(),
            known: of_dimension.map(PhysicalGroup::label).collect(),
            is_other: dimension != POINT
                && mesh
                    .group(SURFACE + CURVE - dimension, &written.text)
                    .is_some(),
        };
        document.note(written.line, &problem);
    }
    found
}

fn named(mesh: &Mesh, dimension: u8, written: &Written) -> Option<usize> {
    let by_number = |group: &PhysicalGroup| {
        group.dimension == dimension && group.tag.to_string() == written.text
    };
    let by_name = mesh.group(dimension, &written.text);
    by_name.or_else(|| mesh.groups.iter().position(by_number))
}

/// The label of the curve named `written`, if it exists.
pub(super) fn label_of_curve(mesh: &Mesh, written: &Written) -> Option<String> {
    named(mesh, CURVE, written).map(|group| mesh.groups[group].label())
}

/// The groups of one dimension, as the file of the mesh has them.
fn kind(mesh: &Mesh, dimension: u8) -> GroupKind {
    GroupKind {
        form: mesh.group_form,
        dimension,
    }
}

/// The curve named `written`, which must have lines: its index in the groups of the mesh.
pub(super) fn curve(document: &Document, mesh: &Mesh, written: &Written) -> Option<usize> {
    let group = find(document, mesh, CURVE, written)?;
    let has_lines = mesh.lines.iter().any(|line| line.groups.contains(group));
    if !has_lines {
        note_empty(document, written, kind(mesh, CURVE), "lines");
    }
    has_lines.then_some(group)
}

/// The surface named `written`: its index in the groups of the mesh.
pub(super) fn surface(document: &Document, mesh: &Mesh, written: &Written) -> Option<usize> {
    find(document, mesh, SURFACE, written)
}

/// The tags of the nodes in the physical point named `written`.
pub(super) fn point(document: &Document, mesh: &Mesh, written: &Written) -> Option<Vec<u64>> {
    let group = find(document, mesh, POINT, written)?;
    let points = mesh
        .points
        .iter()
        .filter(|point| point.groups.contains(group));
    let nodes = points.filter_map(|point| mesh.nodes.get(point.node as usize));
    let tags: Vec<_> = nodes.map(|node| node.tag).collect();
    if tags.is_empty() {
        note_empty(document, written, kind(mesh, POINT), "points");
    }
    (!tags.is_empty()).then_some(tags)
}

fn note_empty(document: &Document, written: &Written, kind: GroupKind, content: &'static str) {
    let problem = InputProblem::EmptyGroup {
        kind,
        group: written.text.clone(),
        content,
    };
    document.note(written.line, &problem);
}

/// For each cell of the mesh the index of its region: the region that names a group of
/// the cell. `None` if no region or two regions do, which has been noted. The other cells
/// then belong only to the group of their region.
pub(super) fn region_of_cells(
    document: &Document,
    mesh: &mut Mesh,
    mesh_key: &Written,
    regions: &[WrittenRegion],
) -> Vec<Option<usize>> {
    let region_of_group = region_of_groups(document, mesh, regions);
    note_groups_without_region(document, mesh, mesh_key, &region_of_group);
    note_cells_without_group(document, mesh, mesh_key);
    let mut claims = Claims::default();
    let alone: Vec<GroupSet> = (0..mesh.groups.len()).map(GroupSet::from).collect();
    let mut region_of_cell = Vec::with_capacity(mesh.cells.len());
    for cell in &mut mesh.cells {
        let mut claiming = claiming(&cell.groups, &region_of_group);
        let first = claiming.next();
        let second = claiming.find(|(_, region)| first.is_some_and(|(_, one)| one != *region));
        drop(claiming);
        region_of_cell.push(match (first, second) {
            (Some((_, region)), Some((_, other))) => {
                claims.add([region.min(other), region.max(other)], cell.tag);
                None
            }
            (Some((group, region)), None) => {
                cell.groups = alone[group].clone();
                Some(region)
            }
            (None, _) => None,
        });
    }
    claims.note(document, regions);
    region_of_cell
}

/// The groups of a cell that have a region, each with that region.
fn claiming(
    groups: &GroupSet,
    region_of_group: &[Option<usize>],
) -> impl Iterator<Item = (usize, usize)> {
    groups
        .iter()
        .filter_map(|group| Some((group, region_of_group[group]?)))
}

/// Cells that are in two regions: for each such pair their number and the tag of one.
#[derive(Debug, Default)]
struct Claims(BTreeMap<[usize; 2], (usize, u64)>);

impl Claims {
    fn add(&mut self, pair: [usize; 2], cell: u64) {
        self.0.entry(pair).or_insert((0, cell)).0 += 1;
    }

    fn note(self, document: &Document, regions: &[WrittenRegion]) {
        let name = |region: usize| {
            let group = regions[region].group.as_ref();
            group.map_or_else(String::new, |group| group.text.clone())
        };
        for ([first, second], (cells, example)) in self.0 {
            let problem = InputProblem::CellInTwoRegions {
                first: name(first),
                line: regions[first].line,
                second: name(second),
                cells,
                example,
            };
            document.note(regions[second].line, &problem);
        }
    }
}

/// For each group of the mesh the index of its region. Notes regions that share a group,
/// and groups without cells.
fn region_of_groups(
    document: &Document,
    mesh: &Mesh,
    regions: &[WrittenRegion],
) -> Vec<Option<usize>> {
    let mut region_of_group: Vec<Option<usize>> = vec![None; mesh.groups.len()];
    for (index, region) in regions.iter().enumerate() {
        let written = region.group.as_ref();
        let found = written.and_then(|name| Some((name, find(document, mesh, SURFACE, name)?)));
        let Some((written, group)) = found else {
            continue;
        };
        if !mesh.cells.iter().any(|cell| cell.groups.contains(group)) {
            note_empty(document, written, kind(mesh, SURFACE), "cells");
        }
        match region_of_group[group] {
            None => region_of_group[group] = Some(index),
            Some(first) => {
                let problem = InputProblem::GroupInTwoRegions {
                    kind: kind(mesh, SURFACE),
                    group: mesh.groups[group].label(),
                    line: regions[first].line,
                };
                document.note(written.line, &problem);
            }
        }
    }
    region_of_group
}

fn note_groups_without_region(
    document: &Document,
    mesh: &Mesh,
    mesh_key: &Written,
    region_of_group: &[Option<usize>],
) {
    // cells without region, counted in the first of their groups
    let mut lonely = vec![0; mesh.groups.len()];
    for cell in &mesh.cells {
        if claiming(&cell.groups, region_of_group).next().is_none()
            && let Some(group) = cell.groups.first()
        {
            lonely[group] += 1;
        }
    }
    for (group, cells) in mesh.groups.iter().zip(lonely) {
        if cells > 0 {
            let problem = InputProblem::GroupWithoutRegion {
                kind: kind(mesh, SURFACE),
                group: group.label(),
                cells,
            };
            document.note(mesh_key.line, &problem);
        }
    }
}

fn note_cells_without_group(document: &Document, mesh: &Mesh, mesh_key: &Written) {
    let mut lonely = mesh.cells.iter().filter(|cell| cell.groups.is_empty());
    if let Some(example) = lonely.next() {
        let problem = InputProblem::CellsWithoutGroup {
            kind: kind(mesh, SURFACE),
            mesh: mesh_key.text.clone(),
            cells: 1 + lonely.count(),
            example: example.tag,
        };
        document.note(mesh_key.line, &problem);
    }
}
