//! The factor of the ground on the velocities of a disk: one of its unknowns.

use num_dual::DualSVec64;
use shared_geom::rotation::skew;

use super::{DiskInflow, Hub, LOADS, MOST, STATES, flow};
use crate::elements::{Local, LocalJacobian, LocalResidual};
use crate::model::Variable;

/// Inputs of the factor: height, flow, loads and states.
const INPUTS: usize = 1 + STATES + MOST;

impl DiskInflow {
    /// Adds the row of the factor of the ground, by the mean velocity of the model, or the thrust.
    pub(super) fn add_ground(
        &self,
        at: &Local<'_>,
        hub: &Hub,
        out: &mut LocalResidual,
        jacobian: Option<&mut LocalJacobian>,
    ) {
        let Some(ground) = &self.disk.ground else {
            return;
        };
        let count = self.disk.state_count();
        let row = STATES + count;
        let values = at.scalars.values;
        let height = ground.up.dot(&hub.shaft.center) - ground.level;
        let mut inputs = [height; INPUTS];
        inputs[1..1 + STATES + count].copy_from_slice(&values[..STATES + count]);
        let of: [_; INPUTS] =
            std::array::from_fn(|i| DualSVec64::<INPUTS>::from_re(inputs[i]).derivative(i));
        let states = &of[1 + STATES..1 + STATES + count];
        let factor = self.disk.disk.ground_factor(
            (&flow(&of[1..]), self.air.atmosphere.density),
            (states, of[1 + LOADS]),
            of[0],
        );
        out.add_scalar(row, values[row]);
        out.add_scalar(row, -factor.re);
        let Some(out) = jacobian else { return };
        let slopes = factor.eps.unwrap_generic(nalgebra::Const, nalgebra::Const);
        out.add_scalar(row, row, 1.0, false);
        for i in 0..STATES + count {
            out.add_scalar(row, i, -slopes[1 + i], false);
        }
        if !self.nodes.is_empty() {
            let by_point = -slopes[0] * ground.up.transpose();
            out.add_scalar_row(row, (0, Variable::Position), &by_point);
            let by_turn = by_point * -skew(&hub.shaft.offset);
            out.add_scalar_row(row, (0, Variable::Rotation), &by_turn);
        }
    }
}
