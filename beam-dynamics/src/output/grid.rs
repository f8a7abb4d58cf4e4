//! A model as a grid of VTK: nodes are points, half beams are lines.

use nalgebra::{Matrix3, Vector3};
use shared_geom::vtk::{Cell, FieldFile};

use super::structure::Structure;

/// Names of the arrays of axes.
const AXES: [&str; 3] = ["axis_x", "axis_y", "axis_z"];

impl Structure {
    /// The grid with its nodes at `positions`: two lines a beam, from its first node to
    /// the middle one and on to the last, with the numbers of beam and member; a node
    /// without beams is a vertex with the numbers -1.
    pub fn grid(&self, positions: &[Vector3<f64>]) -> FieldFile {
        let mut file = FieldFile::new(positions.iter().map(|place| (*place).into()));
        let (mut beams, mut members) = (Vec::new(), Vec::new());
        for ((number, nodes), place) in self.beams.iter().enumerate().zip(self.places()) {
            for pair in nodes.windows(2) {
                file.add_cell(Cell::Line, pair.iter().map(|node| *node as u64));
                beams.push(number as i64);
                members.push(place.0 as i64);
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

    /// Number of cells of the grid.
    pub fn cell_count(&self) -> usize {
        2 * self.beams.len() + self.loose_nodes().len()
    }
}

/// Adds vectors, one a point.
pub(super) fn add_vectors(file: &mut FieldFile, name: &str, vectors: &[Vector3<f64>]) {
    let values = vectors.iter().flat_map(|v| v.iter().copied());
    file.point_values(name, 3, values.collect());
}

/// Adds the columns of attitudes, one a point, as unit vectors.
pub(super) fn add_axes(file: &mut FieldFile, attitudes: &[Matrix3<f64>]) {
    for (column, name) in AXES.iter().enumerate() {
        let vectors: Vec<_> = attitudes
            .iter()
            .map(|attitude| attitude.column(column).into_owned())
            .collect();
        add_vectors(file, name, &vectors);
    }
}
