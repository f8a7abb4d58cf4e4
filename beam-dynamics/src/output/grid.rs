//! A model as a grid of VTK: nodes are points, half beams are lines.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::vector;
use shared_geom::vtk::{Cell, FieldFile};
use shared_geom::wrench::COMPONENTS;

use super::structure::Structure;
use crate::elements::SectionState;
use crate::model::Node;

/// Names of the arrays of axes.
const AXES: [&str; 3] = ["axis_x", "axis_y", "axis_z"];

impl Structure {
    /// The grid with its nodes at `positions`: two lines per beam, from its first node to the
    /// middle one and to the last, with the numbers of beam and member; a node without beams is a
    /// vertex with the numbers -1.
    pub fn grid(&self, positions: &[Vector3<f64>]) -> FieldFile {
        let mut file = FieldFile::new(positions.iter().map(|position| (*position).into()));
        let (mut beams, mut members) = (Vec::new(), Vec::new());
        for ((number, nodes), position) in self.beams.iter().enumerate().zip(self.indices()) {
            for pair in nodes.windows(2) {
                file.add_cell(Cell::Line, pair.iter().map(|node| *node as u64));
                beams.push(number as i64);
                members.push(position.0 as i64);
            }
        }
        for node in self.loose_nodes() {
            file.add_cell(Cell::Vertex, [node as u64]);
            beams.push(-1);
            members.push(-1);
        }
        file.cell_numbers("beam", beams);
        file.cell_numbers("member", members);
        file.point_numbers("node", (0..positions.len() as i64).collect());
        file
    }

    /// The model with its nodes at `positions` and `rotations`: at the nodes displacement,
    /// rotation vector and axes; on each half beam the internal force, the generalized
    /// strain and the section axes at its evaluation point.
    pub fn moved_grid(
        &self,
        nodes: &[Node],
        positions: &[Vector3<f64>],
        rotations: &[Matrix3<f64>],
        sections: &[SectionState],
    ) -> FieldFile {
        let mut file = self.grid(positions);
        let nodes = || nodes.iter().enumerate();
        let moved: Vec<_> = nodes()
            .map(|(k, node)| positions[k] - node.position)
            .collect();
        add_vectors(&mut file, "displacement", &moved);
        let turned: Vec<Vector3<f64>> = nodes()
            .map(|(k, node)| vector::from_rotation(&(rotations[k] * node.rotation.transpose())))
            .collect();
        add_vectors(&mut file, "rotation", &turned);
        add_axes(&mut file, rotations);
        add_sections(&mut file, self, sections);
        file
    }

    /// Number of cells of the grid.
    pub fn cell_count(&self) -> usize {
        2 * self.beams.len() + self.loose_nodes().len()
    }
}

/// Adds vectors, one per point.
pub(super) fn add_vectors(file: &mut FieldFile, name: &str, vectors: &[Vector3<f64>]) {
    let values = vectors.iter().flat_map(|v| v.iter().copied());
    file.point_values(name, 3, values.collect());
}

/// Adds the columns of attitudes, one per point, as unit vectors.
pub(super) fn add_axes(file: &mut FieldFile, attitudes: &[Matrix3<f64>]) {
    for (column, name) in AXES.iter().enumerate() {
        let vectors: Vec<_> = attitudes
            .iter()
            .map(|attitude| attitude.column(column).into_owned())
            .collect();
        add_vectors(file, name, &vectors);
    }
}

/// Adds the quantities of the evaluation points; NaN where there is none.
fn add_sections(file: &mut FieldFile, structure: &Structure, sections: &[SectionState]) {
    let count = structure.cell_count();
    let values = |value: &dyn Fn(&SectionState) -> f64| -> Vec<f64> {
        let known = sections.iter().take(2 * structure.beams.len()).map(value);
        known
            .chain(std::iter::repeat(f64::NAN))
            .take(count)
            .collect()
    };
    for (component, name) in COMPONENTS.iter().enumerate() {
        let name = name.replace(' ', "_");
        let forces = values(&|section| section.internal_force[component]);
        file.cell_values(&format!("internal_force_{name}"), 1, forces);
        let strains = values(&|section| section.strain[component]);
        file.cell_values(&format!("strain_{name}"), 1, strains);
    }
    for (column, name) in ["section_x", "section_y", "section_z"].iter().enumerate() {
        let parts = [0, 1, 2].map(|row| values(&|section| section.axes[(row, column)]));
        let vectors = (0..count).flat_map(|cell| [0, 1, 2].map(|row: usize| parts[row][cell]));
        file.cell_values(name, 3, vectors.collect());
    }
}
