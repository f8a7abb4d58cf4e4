//! Equilibria as field files.

use shared_geom::vtk::FieldFile;

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
    structure.moved_grid(
        &result.nodes,
        &step.positions,
        &step.rotations,
        &step.sections,
    )
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
