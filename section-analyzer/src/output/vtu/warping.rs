//! The warping of a section as a field file.

use nalgebra::{DMatrix, DMatrixView};
use shared_geom::vtk::FieldFile;
use shared_geom::wrench::COMPONENTS;

use super::grid::section_grid;
use crate::section::Section;
use crate::solution::SectionSolution;

/// The warping under each unit internal force and each unit generalized strain, as
/// vectors (x, y, z) at the nodes; what the cells are made of.
///
/// ```text
/// warping_NAME = X        warping_per_strain_NAME = X K
/// ```
pub fn warping_vtu(section: &Section, solution: &SectionSolution) -> FieldFile {
    let mesh = &section.mesh;
    let mut file = section_grid(section, mesh.nodes.iter().copied(), |cell| {
        mesh.cells[cell].nodes().to_vec()
    });
    file.point_numbers(
        "tag",
        mesh.node_tags.iter().map(|tag| *tag as i64).collect(),
    );
    let per_strain: DMatrix<f64> =
        &solution.warping * DMatrix::from_column_slice(6, 6, solution.stiffness.as_slice());
    add_columns(&mut file, "warping", solution.warping.as_view());
    add_columns(&mut file, "warping_per_strain", per_strain.as_view());
    file
}

/// Adds the columns of `warping` (3n x 6), each as an array of vectors.
fn add_columns(file: &mut FieldFile, name: &str, warping: DMatrixView<'_, f64>) {
    for (component, column) in COMPONENTS.iter().zip(warping.column_iter()) {
        let name = format!("{name}_{}", component.replace(' ', "_"));
        file.point_values(&name, 3, column.iter().copied().collect());
    }
}
