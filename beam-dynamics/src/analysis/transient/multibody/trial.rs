//! A state under trial: predicted, corrected, and varied.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::gibbs::{self, Increment};
use shared_geom::rotation::skew;

use super::frames::Frame;
use super::numbers::{
    Integrated, corrected, integrated_latest, lifted, moved, moved_momentum, part, relative, split,
};
use super::own_axes::OwnAxes;
use crate::assembly::{Sharing, Variation};
use crate::model::{Conditions, NodeMotion, State};

/// The axes in which each node is integrated: the ones that follow its long axis, and the ones that
/// turn with its part.
type Axes<'a> = (&'a [Option<Box<OwnAxes>>], &'a [Frame]);

/// A state under trial.
#[derive(Debug, Clone)]
pub(super) struct Trial {
    /// As predicted.
    pub base: State,
    /// As corrected.
    pub state: State,
    pub conditions: Conditions,
    /// Correction of the orientation of each node.
    pub turns: Vec<Increment>,
    /// Angular momenta as they are integrated, as predicted.
    pub gammas: Vec<Integrated>,
    /// Time since the latest accepted state [s].
    pub since: f64,
    /// U of the axes of each node.
    pub axes: Vec<Matrix3<f64>>,
    /// The sharing of loads between redundant constraints at the prediction.
    pub sharing: Sharing,
    /// Attitudes of the nodes at the prediction for which the kept Jacobian was computed, in space
    /// and in their axes.
    pub held: [Vec<Matrix3<f64>>; 2],
}

impl Trial {
    /// A trial that is equal to `state`.
    pub fn new(state: &State, conditions: Conditions, sharing: Sharing) -> Self {
        let nodes = state.nodes.len();
        let still = Increment {
            parameters: Vector3::zeros(),
            rate: Vector3::zeros(),
        };
        Self {
            base: state.clone(),
            state: state.clone(),
            conditions,
            turns: vec![still; nodes],
            gammas: vec![[Vector3::zeros(); 2]; nodes],
            since: 0.0,
            axes: vec![Matrix3::identity(); nodes],
            sharing,
            held: [(); 2].map(|()| vec![Matrix3::identity(); nodes]),
        }
    }

    /// The motion of the nodes at `since` \[s\] after the `latest` state, from numbers and their rates.
    pub fn predict(
        &mut self,
        latest: &[NodeMotion],
        since: f64,
        (own_axes, frames): Axes<'_>,
        [y, rates]: [&[f64]; 2],
    ) {
        self.since = since;
        let (y, rates) = (split(y, latest.len()).0, split(rates, latest.len()).0);
        let bases = self.base.nodes.iter_mut().zip(&mut self.gammas);
        let bases = bases.zip(&mut self.axes).zip(y.zip(rates));
        let origins = latest.iter().zip(own_axes).zip(frames);
        for ((((base, gamma), axes), numbers), ((node, own), frame)) in bases.zip(origins) {
            *axes = frame.turn(since);
            let own = own.as_deref();
            let [y, rates] = frame.lifted(axes, lifted(own), numbers);
            let numbers = (&y[..], &rates[..]);
            let turn = Increment {
                parameters: part(numbers.0, 1),
                rate: part(numbers.1, 1),
            };
            let carried = frame.carried(node, (since, axes));
            let turned = corrected(&turn, &carried, &frame.angular_velocity);
            *gamma = match own {
                None => moved_momentum(&integrated_latest(&carried, None), numbers),
                Some(_) => {
                    let [gamma, _] = integrated_latest(node, own);
                    moved_momentum(&[gamma, Vector3::zeros()], numbers)
                }
            };
            let own = own.map(|own| (own, &node.rotation));
            *base = moved(&carried, &turned, (gamma, own), numbers);
        }
    }

    /// The motion of the nodes, from changes of their predicted numbers and rates.
    pub fn correct(
        &mut self,
        latest: &[NodeMotion],
        (own_axes, frames): Axes<'_>,
        [y, rates]: [&[f64]; 2],
    ) {
        let (y, rates) = (split(y, latest.len()).0, split(rates, latest.len()).0);
        let axes = own_axes.iter().zip(frames).zip(&self.axes);
        let bases = self.base.nodes.iter().zip(&self.gammas).zip(latest);
        let bases = bases.zip(axes).zip(y.zip(rates));
        let states = self.state.nodes.iter_mut().zip(&mut self.turns);
        for ((state, turn), ((((base, gamma), origin), ((own, frame), axes)), numbers)) in
            states.zip(bases)
        {
            let own = own.as_deref();
            let [y, rates] = frame.lifted(axes, lifted(own), numbers);
            let numbers = (&y[..], &rates[..]);
            turn.parameters = part(numbers.0, 1);
            turn.rate = part(numbers.1, 1);
            let turned = corrected(turn, base, &frame.angular_velocity);
            let gamma = moved_momentum(gamma, numbers);
            let own = own.map(|own| (own, &origin.rotation));
            *state = moved(base, &turned, (&gamma, own), numbers);
        }
    }

    /// The variations of the nodes by the corrections, exact or simplified.
    pub fn vary(&self, frames: &[Frame], is_simplified: bool, out: &mut [Variation]) {
        let nodes = self.base.nodes.iter().zip(&self.turns);
        let nodes = nodes.zip(frames.iter().zip(&self.axes));
        for (variation, ((base, turn), (frame, axes))) in out.iter_mut().zip(nodes) {
            let base = relative(base, &frame.angular_velocity);
            let (turn, rate_by_turn) = if is_simplified {
                let omega = gibbs::corrected(turn, &base).angular_velocity;
                (Matrix3::identity(), -skew(&omega))
            } else {
                let exact = gibbs::linearized(turn, &base);
                (exact.rotation, exact.velocity)
            };
            *variation = Variation {
                turn,
                rate_by_turn,
                axes: frame.variation(axes),
            };
            if variation.axes.is_some() {
                variation.turn *= axes;
                variation.rate_by_turn *= axes;
            }
        }
    }

    /// Remembers the attitudes of the prediction.
    pub fn hold(&mut self) {
        let [in_space, in_axes] = &mut self.held;
        let held = in_space.iter_mut().zip(in_axes);
        let bases = self.base.nodes.iter().zip(&self.axes);
        for ((in_space, in_axes), (base, axes)) in held.zip(bases) {
            *in_space = base.rotation;
            *in_axes = axes.tr_mul(&base.rotation);
        }
    }
}
