//! Forces of a beam on its nodes, by the test functions of a formulation.

use nalgebra::{Matrix3, SMatrix, Vector3, Vector6};

use super::strain::Variation;
use crate::elements::{LocalJacobian, LocalResidual};
use crate::model::Equation::{Force, Moment};
use crate::model::Variable;

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

/// Adds `- W^T by`, the variation of the forces on the nodes with that of the section force
/// by displacements and rotations, or by their rates.
pub(super) fn add_tangent(test: &Test, by: &Variation, rates: bool, out: &mut LocalJacobian) {
    let variables = match rates {
        true => [Variable::Velocity, Variable::AngularVelocity],
        false => [Variable::Position, Variable::Rotation],
    };
    let product = test.tr_mul(by);
    for (node, row) in (0..3)
        .flat_map(|node| [(node, Force), (node, Moment)])
        .enumerate()
    {
        for (other, variable) in (0..3).flat_map(|k| variables.map(|v| (k, v))).enumerate() {
            let block: Matrix3<f64> = -product.fixed_view::<3, 3>(3 * node, 3 * other);
            out.add(row, variable, &block);
        }
    }
}

/// Adds the variation of the forces on the nodes by a scalar, or its rate, that makes the
/// section force `q` for each unit.
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
