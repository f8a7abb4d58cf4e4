//! Residual and Jacobian of a system as time integration asks for them.

use nalgebra::{Matrix3, Matrix3xX};

use super::{Residual, System};
use crate::assembly::{Combination, Variation};
use crate::model::{Conditions, NODE_UNKNOWNS, State, Variable};

/// Room for the evaluation of elements.
#[derive(Debug, Default)]
pub struct Workspace {}

impl System {
    /// Room for [`Self::residual_into`] and [`Self::combine`].
    pub fn workspace(&self) -> Workspace {
        Workspace {}
    }

    /// The residual at a state, written to `out`, which has the size of the system.
    pub fn residual_into(
        &self,
        state: &State,
        conditions: &Conditions,
        out: &mut Residual,
        _work: &mut Workspace,
    ) {
        *out = self.residual(state, conditions);
    }

    /// Sums of the derivatives at a state, by the unknowns of a formula: those of
    /// rotations turn the nodes by `variations`, one a node.
    pub fn combine(
        &self,
        state: &State,
        conditions: &Conditions,
        variations: &[Variation],
        out: &mut [Combination<'_>],
        _work: &mut Workspace,
    ) {
        for sum in out.iter_mut() {
            sum.matrix.values_mut().fill(0.0);
        }
        let first_multiplier = NODE_UNKNOWNS * self.nodes.len();
        for (index, scatter) in self.scatter.iter().enumerate() {
            let local = self.local_jacobian(index, state, conditions);
            let (mut by_unknowns, mut by_rates) =
                (local.by_unknowns().clone(), local.by_rates().clone());
            for (i, &node) in self.elements[index].nodes().iter().enumerate() {
                let first = NODE_UNKNOWNS * i + Variable::Rotation.column();
                let Variation { turn, spin } = &variations[node];
                let columns = |of: &nalgebra::DMatrix<f64>| -> Matrix3xX<f64> {
                    of.columns(first, 3)
                        .transpose()
                        .fixed_rows::<3>(0)
                        .into_owned()
                };
                let (theta, omega) = (columns(&by_unknowns), columns(&by_rates));
                let part = |of: &Matrix3xX<f64>, map: &Matrix3<f64>| map.transpose() * of;
                let by_u = part(&theta, turn) + part(&omega, spin);
                by_unknowns
                    .columns_mut(first, 3)
                    .copy_from(&by_u.transpose());
                by_rates
                    .columns_mut(first, 3)
                    .copy_from(&part(&omega, turn).transpose());
            }
            let places = self.places_of(index);
            for sum in out.iter_mut() {
                for &(i, j, place) in scatter {
                    sum.matrix.values_mut()[place] += match places[j] < first_multiplier {
                        true => {
                            sum.by_unknowns * by_unknowns[(i, j)] + sum.by_rates * by_rates[(i, j)]
                        }
                        false => sum.by_algebraic * by_unknowns[(i, j)],
                    };
                }
            }
        }
    }
}
