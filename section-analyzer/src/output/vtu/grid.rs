//! The mesh of a section as a grid.

use shared_geom::vtk::{Cell, FieldFile};

use crate::material::material_axes;
use crate::section::{CellMaterial, Section};

/// A grid of the cells of `section` on `points` (y, z); `cell_points` returns the points of
/// each cell in the order of its nodes.
pub(super) fn section_grid(
    section: &Section,
    points: impl Iterator<Item = [f64; 2]>,
    cell_points: impl Fn(usize) -> Vec<u32>,
) -> FieldFile {
    let mut file = FieldFile::new(points.map(|[y, z]| [0.0, y, z]));
    for (index, cell) in section.mesh.cells.iter().enumerate() {
        let points = cell_points(index);
        file.add_cell(Cell::Section(cell.kind), points.into_iter().map(u64::from));
    }
    add_cell_values(&mut file, section);
    add_names(&mut file, section);
    file
}

/// Names of the numbers of regions and materials.
fn add_names(file: &mut FieldFile, section: &Section) {
    for (number, name) in section.mesh.groups.iter().enumerate() {
        file.field_number(&format!("region {name}"), number as i64);
    }
    for (number, material) in section.materials.iter().enumerate() {
        file.field_number(&format!("material {}", material.name), number as i64);
    }
}

/// Materials and orientations of the cells.
fn add_cell_values(file: &mut FieldFile, section: &Section) {
    let cells = || section.mesh.cells.iter().zip(&section.cells);
    let regions = cells().map(|(cell, _)| cell.group as i64);
    file.cell_numbers("region", regions.collect());
    let materials = cells().map(|(_, made)| made.material as i64);
    file.cell_numbers("material", materials.collect());
    file.cell_numbers("tag", cells().map(|(cell, _)| cell.tag as i64).collect());

    let density = |material: usize| section.materials.get(material).map_or(0.0, |m| m.density);
    let densities = cells().map(|(_, made)| density(made.material));
    file.cell_values("density", 1, densities.collect());
    let fiber = |made: &CellMaterial| {
        let axes = material_axes(made.fiber_angle, made.plane_angle);
        [0, 1, 2].map(|axis| axes[(axis, 0)])
    };
    let fibers = section.cells.iter().flat_map(fiber);
    file.cell_values("fiber_direction", 3, fibers.collect());
    let plane = |made: &CellMaterial| [0.0, made.plane_angle.cos(), made.plane_angle.sin()];
    let planes = section.cells.iter().flat_map(plane);
    file.cell_values("plane_direction", 3, planes.collect());
}
