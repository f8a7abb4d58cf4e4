//! The derivatives of a step by its first state.
//!
//! In a step that begins with the prediction of no change, `R = R(u) R_0` and `omega = G(u) u'`:
//! at fixed u and u', a rotation of the first state is carried along, and all other unknowns with
//! their axes, of which U is the rotation and w the angular velocity,
//!
//! ```text
//! theta = R(u) U theta_0 ,   d omega = 0 ,   dx = U dx_0 ,   dv = [w]x U dx_0           (D-440)
//! ```

use nalgebra::Matrix3;
use shared_geom::rotation::gibbs::{self, Increment};

use super::{Multibody, Variation};
use crate::assembly::{Combination, Sparse};
use crate::model::State;

impl Multibody<'_> {
    /// Integrates all angular momenta as [`Self::by_base`] expects, in axes that do not follow single
    /// nodes.
    pub fn without_own_axes(&mut self) {
        for own in &mut self.own_axes {
            *own = None;
        }
    }

    /// Integrates all nodes in axes that turn as in the latest state, at `time` \[s\], in every step
    /// from now on.
    pub fn keep_axes(&mut self, time: f64) {
        self.frames.keep(&self.states[0].nodes, time);
    }

    /// Begins a step in these axes at `time` \[s\].
    pub fn begin_step_at(&mut self, time: f64) {
        self.frames.move_to(time);
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
        let turns = trial.turns.iter().zip(&trial.axes);
        let turns = turns.zip(self.frames.of_nodes());
        for (variation, ((turn, axes), frame)) in self.variations.iter_mut().zip(turns) {
            *variation = Variation {
                turn: gibbs::to_rotation(&turn.parameters) * axes,
                rate_by_turn: Matrix3::zeros(),
                axes: frame.variation(axes),
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

    /// G U, R(u) U and U of each node at the trial state `stage`: `theta = G U dg + R U theta_0`, with
    /// g in the turning axes, and `dx = U (dxi + dx_0)`.
    pub fn carried(&self, stage: usize) -> Vec<[Matrix3<f64>; 3]> {
        let trial = &self.trials[stage];
        let carried = |(turn, axes): (&Increment, &Matrix3<f64>)| {
            let g = &turn.parameters;
            [
                gibbs::tangent(g) * axes,
                gibbs::to_rotation(g) * axes,
                *axes,
            ]
        };
        trial.turns.iter().zip(&trial.axes).map(carried).collect()
    }
}
