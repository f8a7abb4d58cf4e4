//! The warping of a section as a field file.

use nalgebra::{DMatrix, DMatrixView};
use shared_geom::vtk::{Cell, FieldFile};
use shared_geom::wrench::COMPONENTS;

use super::grid::section_grid;
use crate::section::{ExternalSection, Section};
use crate::solution::{PiezoSolution, SectionSolution};

/// The warping under each unit internal force and each unit generalized strain, as
/// vectors (x, y, z) at the nodes; region, material and directions of the cells.
///
/// ```text
/// warping_NAME = X        warping_per_strain_NAME = X K
/// ```
///
/// With electrodes, at constant voltage, the potential under each unit internal force, and
/// warping and potential at one volt of each electrode, the others at zero.
pub fn warping_vtu(section: &Section, solution: &SectionSolution) -> FieldFile {
    let mesh = &section.mesh;
    let mut file = section_grid(section, mesh.nodes.iter().copied(), |cell| {
        mesh.cells[cell].nodes().to_vec()
    });
    add_warping(&mut file, &mesh.node_tags, solution);
    if let Some(piezo) = &solution.piezo {
        add_potentials(&mut file, piezo);
    }
    file
}

/// As [`warping_vtu`], for a section without cells: points at its nodes.
pub fn external_warping_vtu(section: &ExternalSection, solution: &SectionSolution) -> FieldFile {
    let mut file = FieldFile::new(section.nodes.iter().map(|&[y, z]| [0.0, y, z]));
    for node in 0..section.nodes.len() as u64 {
        file.add_cell(Cell::Vertex, [node]);
    }
    add_warping(&mut file, &section.tags, solution);
    file
}

fn add_warping(file: &mut FieldFile, tags: &[u64], solution: &SectionSolution) {
    file.point_numbers("tag", tags.iter().map(|tag| *tag as i64).collect());
    let per_strain: DMatrix<f64> =
        &solution.warping * DMatrix::from_column_slice(6, 6, solution.stiffness.as_slice());
    add_columns(file, "warping", solution.warping.as_view());
    add_columns(file, "warping_per_strain", per_strain.as_view());
}

/// Adds the potentials per internal force, and warping and potentials per volt.
fn add_potentials(file: &mut FieldFile, piezo: &PiezoSolution) {
    for (component, column) in COMPONENTS.iter().zip(piezo.potential.column_iter()) {
        let name = format!("potential_{}", component.replace(' ', "_"));
        file.point_values(&name, 1, column.iter().copied().collect());
    }
    for electrode in &piezo.electrodes {
        let name = electrode.name.replace(' ', "_");
        let warping = electrode.warping.as_slice().to_vec();
        file.point_values(&format!("warping_per_volt_{name}"), 3, warping);
        let potential = electrode.potential.as_slice().to_vec();
        file.point_values(&format!("potential_per_volt_{name}"), 1, potential);
    }
}

/// Adds the columns of `warping` (3n x 6), each as an array of vectors.
fn add_columns(file: &mut FieldFile, name: &str, warping: DMatrixView<'_, f64>) {
    for (component, column) in COMPONENTS.iter().zip(warping.column_iter()) {
        let name = format!("{name}_{}", component.replace(' ', "_"));
        file.point_values(&name, 3, column.iter().copied().collect());
    }
}
