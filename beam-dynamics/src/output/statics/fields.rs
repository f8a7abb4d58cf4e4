//! Equilibria as field files.

use nalgebra::Vector3;
use shared_geom::rotation::vector;
use shared_geom::vtk::FieldFile;
use shared_geom::wrench::COMPONENTS;

use crate::elements::SectionState;
use crate::output::grid::{add_axes, add_vectors};
use crate::output::structure::Structure;
use crate::result::{StaticResult, StaticStep};

/// The deformed model at one step: at the nodes displacement, rotation vector and axes;
/// on each half beam the internal force, the generalized strain and the section axes at
/// its evaluation point.
pub(super) fn step_grid(
    result: &StaticResult,
    structure: &Structure,
    step: &StaticStep,
) -> FieldFile {
    let mut file = structure.grid(&step.positions);
    let nodes = || result.nodes.iter().enumerate();
    let moved: Vec<_> = nodes()
        .map(|(k, node)| step.positions[k] - node.position)
        .collect();
    add_vectors(&mut file, "displacement", &moved);
    let turned: Vec<Vector3<f64>> = nodes()
        .map(|(k, node)| vector::from_rotation(&(step.rotations[k] * node.rotation.transpose())))
        .collect();
    add_vectors(&mut file, "rotation", &turned);
    add_axes(&mut file, &step.rotations);
    add_sections(&mut file, structure, step);
    file
}

/// Adds what the evaluation points tell; where there is none it is not a number.
fn add_sections(file: &mut FieldFile, structure: &Structure, step: &StaticStep) {
    let count = structure.cell_count();
    let values = |value: &dyn Fn(&SectionState) -> f64| -> Vec<f64> {
        let known = step
            .sections
            .iter()
            .take(2 * structure.beams.len())
            .map(value);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples::{self, read_back, values};

    #[test]
    fn a_step_is_read_back() {
        let result = samples::bent(&[0.0, 1.0]);
        let structure = Structure::new(&result.nodes, &result.beams, &result.blades);
        let grid = read_back(step_grid(&result, &structure, &result.steps[1]));
        // Numbers of VTK for lines and vertices.
        let types: Vec<_> = grid.cells.types.iter().map(|found| *found as u8).collect();
        assert_eq!(types, [3, 3, 3, 3, 3, 3, 3, 3, 1]);
        let points: Vec<f64> = grid.points.clone().cast_into().unwrap();
        let (components, moved) = values(&grid.data.point, "displacement");
        assert_eq!(components, 3);
        // The tip, undeformed at 10 m.
        assert_eq!(points[24] - 10.0, moved[24]);
        let (_, turned) = values(&grid.data.point, "rotation");
        assert!((turned[25] + std::f64::consts::FRAC_PI_3).abs() < 1e-12);
        let (_, axis) = values(&grid.data.point, "axis_x");
        assert!((axis[24] - 0.5).abs() < 1e-12, "cos 60 deg");

        let cells = &grid.data.cell;
        let (_, bending) = values(cells, "internal_force_bending_y");
        assert_eq!(bending[7], -625.0);
        assert!(bending[8].is_nan());
        assert!((values(cells, "strain_axial").1[3] - 8e-5).abs() < 1e-18);
        assert_eq!(values(cells, "section_z").1.len(), 27);
        let beams = [0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0, -1.0];
        assert_eq!(values(cells, "beam").1, beams);
    }
}
