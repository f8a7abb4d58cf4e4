//! Stresses under many internal forces.
//!
//! ```text
//! sigma = D G theta                                                          (S-33)
//! ```
//!
//! For k forces the stresses at a point are a product of 6 x 6 and 6 x k numbers; the
//! stresses of a block of points are one product of matrices, and stay in the cache while
//! they are used.

use std::ops::Range;

use nalgebra::{DMatrix, DMatrixView, Matrix6, Matrix6xX, Vector6};
use shared_geom::wrench;

use super::Recoverer;
use crate::recovery::axes::{USUAL_ORDER, stress_in_axes};

/// Points of a block: with a hundred forces its stresses take 300 kB.
const BLOCK: usize = 64;

/// Stresses at some integration points under many internal forces.
#[derive(Debug, Clone, Copy)]
pub struct StressBlock<'a> {
    first: usize,
    stress: DMatrixView<'a, f64>,
}

impl<'a> StressBlock<'a> {
    /// The points, numbered as in [`crate::recovery::Recovery::points`].
    pub fn points(&self) -> Range<usize> {
        self.first..self.first + self.stress.nrows() / 6
    }

    /// Stresses in section axes: six rows per point, order xx yy zz yz xz xy, a column per
    /// force \[Pa\].
    pub fn stress(&self) -> DMatrixView<'a, f64> {
        self.stress
    }
}

impl Recoverer<'_> {
    /// Finds the stresses at all integration points under each of `forces` (6 x k, about
    /// the reference point, order of [`wrench::COMPONENTS`]) \[N, N m\], and passes them to
    /// `see` block by block. Driven electrodes are at zero volt, floating ones at the
    /// voltage of zero charge.
    pub fn each_stress(&self, forces: &Matrix6xX<f64>, mut see: impl FnMut(&StressBlock<'_>)) {
        let shifted = wrench::shift_matrix(&self.offset()) * forces;
        let theta = DMatrix::from_column_slice(6, forces.ncols(), shifted.as_slice());
        let mut operators = DMatrix::zeros(6 * BLOCK, 6);
        let mut stress = DMatrix::zeros(6 * BLOCK, theta.ncols());
        let (mut first, mut count) = (0, 0);
        let mut flush = |operators: &DMatrix<f64>, first: usize, count: usize| {
            let rows = 6 * count;
            let mut stress = stress.rows_mut(0, rows);
            stress.gemm(1.0, &operators.rows(0, rows), &theta, 0.0);
            see(&StressBlock {
                first,
                stress: stress.as_view(),
            });
        };
        for (cell, grid) in self.cells.iter().enumerate() {
            let law = &self.laws[self.law_of_cell[cell]].stiffness;
            let law = Matrix6::from_fn(|i, j| law[(USUAL_ORDER[i], j)]);
            for (point, (unit, ..)) in grid.points.iter().enumerate() {
                let mut rows = operators.fixed_view_mut::<6, 6>(6 * count, 0);
                rows.copy_from(&(law * unit));
                if let (Some(electric), Some(field)) = (&self.electric, grid.fields.get(point)) {
                    rows -= electric.stress_per_field(cell, field);
                }
                count += 1;
                if count == BLOCK {
                    flush(&operators, first, count);
                    (first, count) = (first + count, 0);
                }
            }
        }
        if count > 0 {
            flush(&operators, first, count);
        }
    }
    /// Mean stress of each cell in material axes per unit internal force about the reference
    /// point: 6x6, rows 11 22 33 23 13 12, columns in the order of [`wrench::COMPONENTS`]
    /// \[1/m^2, 1/m^3\].
    pub fn unit_cell_stresses(&self) -> Vec<Matrix6<f64>> {
        let cells = self.cells.iter().enumerate();
        let mut points =
            cells.flat_map(|(cell, grid)| grid.points.iter().map(move |point| (cell, point.2)));
        let mut sums = vec![(Matrix6::zeros(), 0.0); self.cells.len()];
        self.each_stress(&Matrix6xX::identity(6), |block| {
            for (point, (cell, area)) in (0..block.points().len()).zip(&mut points) {
                let (sum, total) = &mut sums[cell];
                *sum += area * block.stress().fixed_view::<6, 6>(6 * point, 0);
                *total += area;
            }
        });
        let sums = sums.iter().enumerate();
        let mean = |(cell, (sum, area)): (usize, &(Matrix6<f64>, f64))| {
            let axes = &self.laws[self.law_of_cell[cell]].axes;
            let columns = sum.column_iter();
            let columns: Vec<Vector6<f64>> = columns
                .map(|column| stress_in_axes(axes, &(column / *area)))
                .collect();
            Matrix6::from_columns(&columns)
        };
        sums.map(mean).collect()
    }
}
