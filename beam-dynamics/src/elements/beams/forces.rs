//! Forces of a beam on its nodes, by the test functions of a formulation.

use nalgebra::{Matrix3, SMatrix, Vector3, Vector6};

use super::strain::Variation;
use crate::elements::{LocalJacobian, LocalResidual};
use crate::model::Equation::{Force, Moment};
use crate::model::Variable;

/// Displacements and rotations of the nodes.
const NUMBERS: usize = 18;

/// Six equations of each node, by a matrix of columns.
pub(super) type Test = SMatrix<f64, 6, 18>;

/// A force and a moment on the line of a beam, with their variations by the rotations of
/// the nodes, model axes [N, N m].
pub(super) struct LineForce {
    pub force: Vector3<f64>,
    pub moment: Vector3<f64>,
    pub by_rotation: Option<[[Matrix3<f64>; 3]; 2]>,
}

/// Adds the forces on the nodes of the section force `q`, by terms of force and of moment.
pub(super) fn add_forces(test: &Test, q: &Vector6<f64>, out: &mut LocalResidual) {
    let parts = [0, 3].map(|row| {
        let rows = test.fixed_rows::<3>(row);
        -rows.tr_mul(&q.fixed_rows::<3>(row))
    });
    for node in 0..3 {
        let of = |part: &SMatrix<f64, 18, 1>, row: usize| {
            part.fixed_rows::<3>(6 * node + row).into_owned()
        };
        out.add(node, Force, &of(&parts[0], 0));
        out.add(node, Moment, &of(&parts[0], 3));
        out.add(node, Moment, &of(&parts[1], 3));
    }
}

/// Adds `- sum W^T by` over points, the variation of the forces on the nodes with the section
/// forces, by displacements and rotations, or by their rates.
pub(super) fn add_tangent(points: &[(Test, Variation)], rates: bool, out: &mut LocalJacobian) {
    let mut columns = [[0.0; NUMBERS]; NUMBERS];
    for (test, by) in points {
        add_product(test, by, &mut columns);
    }
    let variables = if rates {
        [Variable::Velocity, Variable::AngularVelocity]
    } else {
        [Variable::Position, Variable::Rotation]
    };
    for i in 0..6 {
        let row = (i / 2, [Force, Moment][i % 2]);
        for j in 0..6 {
            let block = Matrix3::from_fn(|m, n| -columns[3 * j + n][3 * i + m]);
            out.add(row, (j / 2, variables[j % 2]), &block);
        }
    }
}

/// Adds `W^T by`, column by column.
fn add_product(test: &Test, by: &Variation, columns: &mut [[f64; NUMBERS]; NUMBERS]) {
    // Whole rows of W: each product adds one of them to a column.
    let mut rows = [[0.0; NUMBERS]; 6];
    for (j, column) in test.column_iter().enumerate() {
        for (row, value) in rows.iter_mut().zip(column.iter()) {
            row[j] = *value;
        }
    }
    for (sums, factors) in columns.iter_mut().zip(by.column_iter()) {
        // A separate sum: equal terms of opposite sign at the two points cancel exactly.
        let mut column = [0.0; NUMBERS];
        for (row, factor) in rows.iter().zip(factors.iter()) {
            for (sum, value) in column.iter_mut().zip(row) {
                *sum += factor * value;
            }
        }
        for (sum, value) in sums.iter_mut().zip(column) {
            *sum += value;
        }
    }
}

/// Adds the variation of the forces on the nodes by a scalar, or its rate, that causes the section
/// force `q` per unit.
pub(super) fn add_column(
    test: &Test,
    q: &Vector6<f64>,
    column: (usize, bool),
    out: &mut LocalJacobian,
) {
    let forces = -test.tr_mul(q);
    for node in 0..3 {
        for (row, equation) in [(0, Force), (3, Moment)] {
            let force = forces.fixed_rows::<3>(6 * node + row).into_owned();
            out.add_by_scalar((node, equation), column, &force);
        }
    }
}
