//! Modes as field files: the nodes move about their equilibrium through one period.

use std::f64::consts::TAU;

use nalgebra::{Complex, Matrix3, Vector3};
use shared_geom::rotation::vector;
use shared_geom::vtk::FieldFile;

use crate::model::NamingAxes;
use crate::output::grid::{add_axes, add_vectors};
use crate::output::structure::Structure;
use crate::result::{EquilibriumReport, ModeShape};

/// Frames of one period.
pub(super) const PHASES: usize = 24;
/// Largest displacement that is shown, as part of the size of the model...
const DISPLACED: f64 = 0.1;
/// ...and largest rotation \[rad\]: the smaller of the two scales applies.
const TURNED: f64 = 0.35;

/// Data common to all modes: the equilibrium and the axes of the sections in it.
pub(super) struct Still<'a> {
    pub structure: &'a Structure,
    pub positions: Vec<Vector3<f64>>,
    /// Axes of the sections, in the order of the nodes \[-\].
    pub axes: Vec<Matrix3<f64>>,
}

impl<'a> Still<'a> {
    /// The equilibrium `report`; `undeformed` are the attitudes of the nodes without
    /// loads.
    pub fn new(
        structure: &'a Structure,
        report: &EquilibriumReport,
        undeformed: &[Matrix3<f64>],
        naming: &[NamingAxes],
    ) -> Self {
        let positions = report
            .positions
            .iter()
            .map(|position| Vector3::from(*position));
        let turned = report.rotations.iter().zip(undeformed).zip(naming);
        let axes = turned.map(|((now, before), naming)| now * before.transpose() * naming.section);
        Self {
            structure,
            positions: positions.collect(),
            axes: axes.collect(),
        }
    }

    /// The factor by which a shape is shown.
    pub fn amplitude(&self, shape: &ModeShape) -> f64 {
        let largest = |vectors: &[[Complex<f64>; 3]]| {
            let size = |v: &[Complex<f64>; 3]| v.iter().map(Complex::norm_sqr).sum::<f64>().sqrt();
            vectors.iter().map(size).fold(0.0, f64::max)
        };
        let scale = |wanted: f64, found: f64| {
            if found > 0.0 {
                wanted / found
            } else {
                f64::INFINITY
            }
        };
        let displaced = scale(
            DISPLACED * self.structure.size(),
            largest(&shape.displacements),
        );
        let both = displaced.min(scale(TURNED, largest(&shape.rotations)));
        if both.is_finite() { both } else { 0.0 }
    }

    /// The model at a phase, from 0 to 1: at the nodes the shown displacement and rotation from the
    /// equilibrium, and the axes of the section.
    pub fn grid(&self, shape: &ModeShape, phase: f64) -> FieldFile {
        let turn = Complex::from_polar(self.amplitude(shape), TAU * phase);
        let real = |vectors: &[[Complex<f64>; 3]]| -> Vec<Vector3<f64>> {
            let real = vectors.iter().map(|v| v.map(|z| (z * turn).re));
            real.map(Vector3::from).collect()
        };
        let [moved, turned] = [&shape.displacements, &shape.rotations].map(|v| real(v));
        let positions = self.positions.iter().zip(&moved);
        let positions: Vec<_> = positions
            .map(|(position, moved)| position + moved)
            .collect();
        let axes = self.axes.iter().zip(&turned);
        let axes: Vec<_> = axes
            .map(|(axes, turned)| vector::to_rotation(turned) * axes)
            .collect();
        let mut file = self.structure.grid(&positions);
        add_vectors(&mut file, "displacement", &moved);
        add_vectors(&mut file, "rotation", &turned);
        add_axes(&mut file, &axes);
        file
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples::{read_back, tip_motion, values};

    // The tip moves by (0, -1, 2) and turns by 1 about x: in a model of 10 m shown as 1 m at most,
    // hence times 1 / sqrt 5, unless the rotation exceeds 0.35.
    #[test]
    fn a_period_is_read_back() {
        let (nodes, beams, shape) = tip_motion();
        let structure = Structure::new(&nodes, &beams, &[]);
        let count = nodes.len();
        let report = EquilibriumReport {
            iterations: 1,
            residual: 0.0,
            positions: nodes.iter().map(|node| node.position.into()).collect(),
            rotations: vec![Matrix3::identity(); count],
        };
        let undeformed = vec![Matrix3::identity(); count];
        let naming = vec![NamingAxes::default(); count];
        let still = Still::new(&structure, &report, &undeformed, &naming);
        assert!((still.amplitude(&shape) - 0.35).abs() < 1e-15);

        let tip = 3 * (count - 1);
        for (phase, part) in [(0.0, 1.0), (0.25, 0.0), (0.5, -1.0), (1.0 / 6.0, 0.5)] {
            let grid = read_back(still.grid(&shape, phase));
            let points: Vec<f64> = grid.points.clone().cast_into().unwrap();
            let (_, moved) = values(&grid.data.point, "displacement");
            let (_, turned) = values(&grid.data.point, "rotation");
            let (_, axis) = values(&grid.data.point, "axis_y");
            let angle: f64 = 0.35 * part;
            assert!((moved[tip + 2] - 2.0 * angle).abs() < 1e-15);
            assert!((points[tip + 1] + angle).abs() < 1e-15);
            assert!((turned[tip] - angle).abs() < 1e-15);
            assert!((axis[tip + 2] - angle.sin()).abs() < 1e-15);
        }
    }
}
