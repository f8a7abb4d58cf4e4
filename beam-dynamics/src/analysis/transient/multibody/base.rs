//! The derivatives of a step by its first state.
//!
//! In a step that begins with the prediction of no change, `R = R(u) R_0` and `omega = G(u) u'`:
//! at fixed u and u', a rotation of the first state is carried along,
//!
//! ```text
//! theta = R(u) theta_0 ,     d omega = 0                                        (D-200)
//! ```
//!
//! and all other unknowns change with it one to one.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::gibbs;

use super::{Multibody, Variation};
use crate::assembly::{Combination, Sparse};
use crate::model::State;

impl Multibody<'_> {
    /// Integrates all angular momenta in components in space, of which [`Self::by_base`] is the
    /// derivative.
    pub fn in_space(&mut self) {
        for own in &mut self.own_axes {
            *own = None;
        }
    }

    /// Begins anew from a state.
    pub fn begin_at(&mut self, state: &State) {
        for own in &mut self.states {
            own.copy_from(state);
        }
    }

    /// The residual's derivative by the spatial variation of the first state of a step, at the trial
    /// state `stage` that was predicted without a change; with all momenta in space.
    pub fn by_base(&mut self, stage: usize, matrix: &mut Sparse) {
        let trial = &self.trials[stage];
        for (variation, turn) in self.variations.iter_mut().zip(&trial.turns) {
            *variation = Variation {
                turn: gibbs::to_rotation(&turn.parameters),
                rate_by_turn: Matrix3::zeros(),
            };
        }
        let mut out = [Combination {
            by_unknowns: 1.0,
            by_rates: 0.0,
            by_algebraic: 0.0,
            matrix,
        }];
        self.model.system.combine(
            &trial.state,
            &trial.conditions,
            &self.variations,
            (&mut out, None),
            &mut self.work,
        );
    }

    /// G(u) and R(u) of each node at the trial state `stage`: `theta = G du + R theta_0`.
    pub fn carried(&self, stage: usize) -> Vec<[Matrix3<f64>; 2]> {
        let turns = self.trials[stage].turns.iter();
        let carried = |g: &Vector3<f64>| [gibbs::tangent(g), gibbs::to_rotation(g)];
        turns.map(|turn| carried(&turn.parameters)).collect()
    }
}
