//! Which region each cell belongs to.

use shared_geom::document::Document;
use shared_geom::mesh::{Mesh, PhysicalGroup};

use super::problem::InputProblem;
use super::regions::{Written, WrittenRegion};

const SURFACE: u8 = 2;
const CURVE: u8 = 1;

/// The physical group that `written` names: by its name, else by its number.
/// One that does not exist is noted, with the nearest name.
fn find(document: &Document, mesh: &Mesh, dimension: u8, written: &Written) -> Option<usize> {
    let by_number = |group: &PhysicalGroup| {
        group.dimension == dimension && group.tag.to_string() == written.text
    };
    let found = mesh
        .group(dimension, &written.text)
        .or_else(|| mesh.groups.iter().position(by_number));
    if found.is_none() {
        let of_dimension = mesh
            .groups
            .iter()
            .filter(|group| group.dimension == dimension);
        let problem = InputProblem::UnknownGroup {
            kind: word(dimension),
            group: written.text.clone(),
            known: of_dimension.map(PhysicalGroup::label).collect(),
        };
        document.note(written.line, &problem);
    }
    found
}

fn word(dimension: u8) -> &'static str {
    if dimension == SURFACE {
        "surface"
    } else {
        "curve"
    }
}

/// The curve that `written` names, which must have lines: its index in the groups
/// of the mesh.
pub(super) fn curve(document: &Document, mesh: &Mesh, written: &Written) -> Option<usize> {
    let group = find(document, mesh, CURVE, written)?;
    let has_lines = mesh.lines.iter().any(|line| line.group == Some(group));
    if !has_lines {
        note_empty(document, written, CURVE, "lines");
    }
    has_lines.then_some(group)
}

fn note_empty(document: &Document, written: &Written, dimension: u8, content: &'static str) {
    let problem = InputProblem::EmptyGroup {
        kind: word(dimension),
        group: written.text.clone(),
        content,
    };
    document.note(written.line, &problem);
}

/// For each cell of the mesh the index of its region. Cells have none when their
/// group has none, which has been noted.
pub(super) fn region_of_cells(
    document: &Document,
    mesh: &Mesh,
    mesh_key: &Written,
    regions: &[WrittenRegion],
) -> Vec<Option<usize>> {
    let region_of_group = region_of_groups(document, mesh, regions);
    note_groups_without_region(document, mesh, mesh_key, &region_of_group);
    note_cells_without_group(document, mesh, mesh_key);
    let groups = mesh.cells.iter().map(|cell| cell.group);
    groups
        .map(|group| group.and_then(|group| region_of_group[group]))
        .collect()
}

/// For each group of the mesh the index of its region. Notes regions without a
/// group of their own, and groups without cells.
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
        if !mesh.cells.iter().any(|cell| cell.group == Some(group)) {
            note_empty(document, written, SURFACE, "cells");
        }
        match region_of_group[group] {
            None => region_of_group[group] = Some(index),
            Some(first) => {
                let problem = InputProblem::GroupInTwoRegions {
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
    for (index, group) in mesh.groups.iter().enumerate() {
        let cells = mesh
            .cells
            .iter()
            .filter(|cell| cell.group == Some(index))
            .count();
        if cells > 0 && region_of_group[index].is_none() {
            let group = group.label();
            let problem = InputProblem::GroupWithoutRegion { group, cells };
            document.note(mesh_key.line, &problem);
        }
    }
}

fn note_cells_without_group(document: &Document, mesh: &Mesh, mesh_key: &Written) {
    let mut lonely = mesh.cells.iter().filter(|cell| cell.group.is_none());
    if let Some(example) = lonely.next() {
        let problem = InputProblem::CellsWithoutGroup {
            mesh: mesh_key.text.clone(),
            cells: 1 + lonely.count(),
            example: example.tag,
        };
        document.note(mesh_key.line, &problem);
    }
}
