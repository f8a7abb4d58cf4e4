//! Shapes of critical loads as field files.

use nalgebra::Vector3;
use shared_geom::vtk::FieldFile;

use crate::output::grid::add_vectors;
use crate::output::structure::Structure;
use crate::result::{BucklingMode, BucklingResult};

/// Largest displacement that is shown, as part of the size of the model.
const DISPLACED: f64 = 0.1;

/// The equilibrium at which the model buckles: its nodes.
pub(super) fn base(result: &BucklingResult) -> Vec<Vector3<f64>> {
    match &result.base {
        Some(step) => step.positions.clone(),
        None => result.nodes.iter().map(|node| node.position).collect(),
    }
}

/// The nodes in the shape, its largest displacement a tenth of the size of the model.
pub(super) fn displaced(
    structure: &Structure,
    base: &[Vector3<f64>],
    mode: &BucklingMode,
) -> Vec<Vector3<f64>> {
    let sizes = mode.displacements.iter().map(|v| v.norm());
    let largest = sizes.fold(0.0, f64::max);
    let scale = if largest > 0.0 {
        DISPLACED * structure.size() / largest
    } else {
        0.0
    };
    let moved = base.iter().zip(&mode.displacements);
    moved
        .map(|(position, moved)| position + scale * moved)
        .collect()
}

/// The nodes moved along the second axis by their rotation about the first, the largest
/// displacement a tenth of the size of the model: torsion in a figure.
pub(super) fn turned(
    structure: &Structure,
    base: &[Vector3<f64>],
    mode: &BucklingMode,
    [about, across]: [usize; 2],
) -> Vec<Vector3<f64>> {
    let scale = DISPLACED * structure.size();
    let moved = |(position, turn): (&Vector3<f64>, &Vector3<f64>)| {
        let mut position = *position;
        position[across] += scale * turn[about];
        position
    };
    base.iter().zip(&mode.rotations).map(moved).collect()
}

/// The model in the shape, with the shape itself as arrays: displacements scaled to a maximum of
/// one, rotations in the same scale.
pub(super) fn shape_grid(
    structure: &Structure,
    base: &[Vector3<f64>],
    mode: &BucklingMode,
) -> FieldFile {
    let mut file = structure.grid(&displaced(structure, base, mode));
    add_vectors(&mut file, "displacement", &mode.displacements);
    add_vectors(&mut file, "rotation", &mode.rotations);
    file
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples::{column, read_back, values};

    // The box around the nodes is 10 m by 2 m; the tip is displaced by a tenth of its
    // diagonal.
    #[test]
    fn a_shape_is_read_back() {
        let result = column();
        let structure = Structure::new(&result.nodes, &result.beams, &[]);
        let grid = read_back(shape_grid(&structure, &base(&result), &result.modes[0]));
        let points: Vec<f64> = grid.points.clone().cast_into().unwrap();
        assert!((points[3 * 8 + 2] - 0.1 * 104.0_f64.sqrt()).abs() < 1e-12);
        let (components, moved) = values(&grid.data.point, "displacement");
        assert_eq!((components, moved[3 * 8 + 2]), (3, 1.0));
        assert_eq!(values(&grid.data.point, "rotation").1.len(), 30);
    }
}
