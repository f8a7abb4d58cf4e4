//! A multibody model as a differential-algebraic system.
//!
//! Orientations are matrices. The integration schemes use parameters relative to the latest
//! accepted state (the updated-updated scheme): with `R_1, omega_1` that state and `R_2, omega_2`
//! the previous one,
//!
//! ```text
//! history      g_1 = 0                    g_1' = omega_1
//!              g_2 = g(R_2 R_1^T)         g_2' = G(g_2)^-1 omega_2
//! prediction   R_0 = R(g) R_1             w_0  = G(g) g'
//! correction   R   = R(u) R_0             omega = G(u) u' + R(u) w_0
//! variation    theta = G du               d omega = G du' + H(u, u') du + theta x R(u) w_0
//! ```
//!
//! All motions of nodes are relative to axes that turn with the part to which they belong: see
//! [`frames`].
//!
//! The simplified variation, `theta = du` and `d omega = du' - omega x du`, applies to a correction
//! that vanishes.
//!
//! References: [Masarati], section 3.4.

use std::sync::Arc;

use nalgebra::Matrix3;

use crate::analysis::balance::{Scales, largest_motion};
use crate::assembly::{
    Combination, Pattern, Residual, ScalarScales, Sharing, Slack, Variation, Workspace,
};
use crate::case::Model;
use crate::elements::Element;
use crate::integrator::{Corner, Dae, Renewal};
use crate::model::{NODE_UNKNOWNS, Name, Pace, State};
use crate::solver::Worst;

use super::corner::{Impulses, NextCorner, pass};

mod base;
mod frames;
mod numbers;
mod own_axes;
mod trial;
mod turned;

use frames::Frames;
use numbers::{move_own, orthogonal, split, write, write_latest};
use own_axes::OwnAxes;
use trial::Trial;
use turned::Turned;

/// Accepted states that are kept.
const KEPT: usize = 2;
/// Numbers of the velocity of a node.
const MOTION: usize = 6;
/// Least fraction of its scale to which a scalar is resolved; the scale is the scale of round-off.
const SMALL: f64 = 1e-3;
/// Growth in a step above which the previous scalars are no reference.
const GROWN: f64 = 2.0;

/// A multibody model as a system of the integrators.
#[derive(Debug)]
pub(in crate::analysis) struct Multibody<'a> {
    pub(super) model: &'a Model,
    /// Accepted states, the latest first.
    pub(super) states: [State; KEPT],
    /// Length of the step to the latest; zero if there was none [s].
    length: f64,
    /// Axes of the nodes in the next step.
    frames: Frames,
    /// The impulses so far.
    pub(super) impulses: Impulses,
    trials: Vec<Trial>,
    variations: Vec<Variation>,
    /// Nodes whose angular momentum is integrated in axes that follow their long axis.
    own_axes: Vec<Option<Box<OwnAxes>>>,
    turned: Turned,
    work: Workspace,
    algebraic: Vec<bool>,
    is_simplified: bool,
    scales: Scales,
    /// References for local errors of scalars that have a rate.
    with_rate: ScalarScales,
    /// The largest violation of a constraint of a loop in the latest state.
    slack: Option<Slack>,
    /// Limits of variable steps from inputs prescribed in time, and the corners of these.
    pub(super) pace: Pace,
    corner: NextCorner,
}

impl<'a> Multibody<'a> {
    /// The model with the accepted states `states`, the latest first, and one trial state per
    /// stage of the scheme; with exact derivatives unless `is_simplified`.
    pub fn new(
        model: &'a Model,
        states: [State; KEPT],
        (stages, is_simplified): (usize, bool),
    ) -> Self {
        let system = &model.system;
        let nodes = system.nodes().len();
        let numbering = system.numbering();
        // Of the model and not of a state: a run that is continued has the same. The tangent
        // is freed before other memory is allocated.
        let (own_axes, frames) = {
            let rest = system.rest();
            let tangent = system.tangent(&rest, &model.conditions_at(0.0));
            let own_axes = own_axes::find(system, &rest.nodes, &tangent);
            (own_axes, Frames::new(model, &tangent))
        };
        let sharing = Sharing::new(system, &states[0], &model.conditions_at(0.0));
        let trial = Trial::new(&states[0], model.conditions_at(0.0), sharing);
        let variation = Variation {
            turn: Matrix3::identity(),
            rate_by_turn: Matrix3::zeros(),
            axes: None,
        };
        let mut dae = Self {
            model,
            trials: vec![trial; stages],
            variations: vec![variation; nodes],
            turned: Turned::new(system),
            own_axes,
            work: system.workspace(),
            algebraic: std::iter::repeat_n(false, NODE_UNKNOWNS * nodes)
                .chain(std::iter::repeat_n(true, numbering.multipliers()))
                .chain(system.scalars().iter().map(|scalar| !scalar.has_rate))
                .chain(std::iter::repeat_n(true, system.surpluses()))
                .collect(),
            is_simplified,
            scales: Scales::of(system),
            with_rate: system.scalar_scales(|scalar| scalar.has_rate).finer(SMALL),
            impulses: Impulses::default(),
            slack: None,
            pace: Pace::default(),
            corner: NextCorner::default(),
            states,
            length: 0.0,
            frames,
        };
        dae.begin_step(0.0);
        dae
    }

    /// Begins a step after one of `length`, zero if there was none \[s\].
    pub fn begin_step(&mut self, length: f64) {
        self.length = length;
        self.frames.begin(&self.states[0].nodes, length);
    }

    /// The largest violation of a constraint of a loop in the latest state, if constraints share
    /// loads.
    pub fn slack(&self) -> Option<&Slack> {
        self.slack.as_ref()
    }

    /// Angular speed of each node relative to the axes in which it is integrated \[rad/s\].
    pub fn turns(&self) -> impl Iterator<Item = f64> + '_ {
        let nodes = self.states[0].nodes.iter().zip(self.frames.of_nodes());
        nodes.map(|(node, frame)| (node.angular_velocity - frame.angular_velocity).norm())
    }

    /// The latest accepted state.
    pub fn state(&self) -> &State {
        &self.states[0]
    }

    /// An element without a value at a state that was tried last; whether it has no value at the
    /// latest accepted state at that time either; and the reason, if the element knows it.
    pub fn without_value(&self) -> Option<(&dyn Element, bool, Option<String>)> {
        let system = &self.model.system;
        self.trials.iter().find_map(|trial| {
            let (state, conditions) = (&trial.state, &trial.conditions);
            let (index, element) = system.without_value(state, conditions)?;
            let then = system.has_value(index, &self.states[0], conditions);
            let why = system.why_without_value(index, state, conditions);
            Some((element, !then, why))
        })
    }

    /// The accepted states, the latest first.
    pub fn states(&self) -> &[State] {
        &self.states
    }
}

impl Dae for Multibody<'_> {
    fn pattern(&self) -> &Arc<Pattern> {
        self.model.system.pattern()
    }

    fn algebraic(&self) -> &[bool] {
        &self.algebraic
    }

    fn past(&self, ago: f64, y: &mut [f64], rates: &mut [f64]) {
        let back = usize::from(ago > 0.0);
        let [latest, _] = &self.states;
        let then = &self.states[back];
        let nodes = latest.nodes.len();
        let ends = (y.split_at_mut(NODE_UNKNOWNS * nodes)).0;
        let slopes = (rates.split_at_mut(NODE_UNKNOWNS * nodes)).0;
        let numbers = ends
            .chunks_mut(NODE_UNKNOWNS)
            .zip(slopes.chunks_mut(NODE_UNKNOWNS));
        let axes = self.own_axes.iter().zip(self.frames.of_nodes());
        let pairs = then.nodes.iter().zip(&latest.nodes).zip(axes);
        for (((node, origin), (own, frame)), out) in pairs.zip(numbers) {
            let nodes = [&frame.seen(node, -ago), node];
            match back {
                0 => write_latest(nodes, own.as_deref(), out),
                _ => write(nodes, origin, own.as_deref(), out),
            }
        }
        let multipliers = then.multipliers.iter().zip(&latest.multipliers);
        let scalars = then.scalars.iter().zip(&latest.scalars);
        let first = NODE_UNKNOWNS * nodes;
        let changes = multipliers.chain(scalars);
        for (value, (now, origin)) in y[first..].iter_mut().zip(changes) {
            *value = now - origin;
        }
        let (of_multipliers, of_scalars) = rates[first..].split_at_mut(then.multipliers.len());
        of_multipliers.fill(0.0);
        of_scalars[..then.scalars.len()].copy_from_slice(&then.scalar_rates);
    }

    fn renew(&mut self, corner: &Corner, step: f64) -> Renewal {
        let passed = pass(
            self.model,
            &mut self.states,
            &mut self.impulses,
            corner,
            step,
        );
        self.begin_step(self.length);
        passed
    }

    fn predict(&mut self, stage: usize, [time, tau]: [f64; 2], y: &[f64], rates: &[f64]) {
        let latest = &self.states[0];
        let trial = &mut self.trials[stage];
        trial.conditions = self.model.conditions_at(time);
        let axes = (&self.own_axes[..], self.frames.of_nodes());
        trial.predict(&latest.nodes, tau, axes, [y, rates]);
        let nodes = latest.nodes.len();
        let ((_, own), (_, own_rates)) = (split(y, nodes), split(rates, nodes));
        move_own(&mut trial.base, latest, own);
        self.turned.predict(latest, &mut trial.base);
        let first = latest.multipliers.len();
        let of_scalars = first..first + latest.scalars.len();
        (trial.base.scalar_rates).copy_from_slice(&own_rates[of_scalars]);
        trial.base.memory.copy_from_slice(&latest.memory);
        trial.state.copy_from(&trial.base);
        for turn in &mut trial.turns {
            turn.parameters.fill(0.0);
            turn.rate.fill(0.0);
        }
        let (system, conditions) = (&self.model.system, &trial.conditions);
        (trial.sharing).update(system, &trial.base, conditions, &mut self.work);
        trial.sharing.take_surplus(&mut trial.state.multipliers);
    }

    fn correct(&mut self, stage: usize, y: &[f64], rates: &[f64]) {
        let trial = &mut self.trials[stage];
        let nodes = trial.base.nodes.len();
        let axes = (&self.own_axes[..], self.frames.of_nodes());
        trial.correct(&self.states[0].nodes, axes, [y, rates]);
        let ((_, own), (_, own_rates)) = (split(y, nodes), split(rates, nodes));
        move_own(&mut trial.state, &trial.base, own);
        trial.sharing.take_surplus(&mut trial.state.multipliers);
        let changes = &own_rates[trial.base.multipliers.len()..];
        let bases = trial.base.scalar_rates.iter().zip(changes);
        for (state, (base, change)) in trial.state.scalar_rates.iter_mut().zip(bases) {
            *state = base + change;
        }
    }

    fn residual(&mut self, stage: usize, out: &mut Residual) {
        let trial = &mut self.trials[stage];
        let system = &self.model.system;
        system.residual_into(&trial.state, &trial.conditions, out, &mut self.work);
        let first = system.numbering().first_multiplier();
        trial.sharing.add_residual(first, out);
        complete(out, system.pattern().size());
    }

    fn jacobian(
        &mut self,
        stage: usize,
        out: &mut [Combination<'_>],
        mut residual: Option<&mut Residual>,
    ) {
        let trial = &mut self.trials[stage];
        let frames = self.frames.of_nodes();
        trial.vary(frames, self.is_simplified, &mut self.variations);
        self.model.system.combine(
            &trial.state,
            &trial.conditions,
            &self.variations,
            (out, residual.as_deref_mut()),
            &mut self.work,
        );
        if let Some(residual) = residual {
            let system = &self.model.system;
            let first = system.numbering().first_multiplier();
            trial.sharing.add_residual(first, residual);
            complete(residual, system.pattern().size());
        }
        trial.sharing.add_jacobian(out);
        let nodes = trial.state.nodes.iter().zip(&self.variations);
        let origins = self.own_axes.iter().zip(&self.states[0].nodes);
        for ((node, variation), (own, origin)) in nodes.zip(origins) {
            let Some(own) = own else { continue };
            for sum in out.iter_mut() {
                own.rewrite(node, &origin.rotation, variation, sum);
            }
        }
    }

    fn hold(&mut self) {
        self.trials.iter_mut().for_each(Trial::hold);
    }

    fn turn_back(&self, stage: usize, equations: &mut [f64]) {
        let trial = &self.trials[stage];
        let held = &trial.held[0];
        self.turned.back(&trial.base.nodes, held, equations);
    }

    fn turn_forth(&self, stage: usize, unknowns: &mut [f64]) {
        let trial = &self.trials[stage];
        let nodes = (&trial.base.nodes[..], &self.own_axes[..]);
        self.turned
            .forth(nodes, (&trial.axes, &trial.held), unknowns);
    }

    fn accept(&mut self, stage: usize) {
        self.states.swap(0, 1);
        let trial = &mut self.trials[stage];
        self.states[0].copy_from(&trial.state);
        let slack = trial.sharing.slack();
        self.slack = slack.max_by(|a, b| a.part.abs().total_cmp(&b.part.abs()));
        for node in &mut self.states[0].nodes {
            node.rotation = orthogonal(&node.rotation);
        }
        // At a corner the conditions before it apply, at the time of the corner.
        let conditions = &self.trials[stage].conditions;
        let time = conditions.loading.time.next_up();
        let system = &self.model.system;
        system.remember(&mut self.states[0], (conditions, time), &mut self.work);
        self.begin_step(self.trials[stage].since);
    }

    fn next_corner(&self, time: f64) -> f64 {
        self.corner.after(self.model, time)
    }

    fn longest_step(&self, time: f64) -> f64 {
        self.pace.longest_step(time)
    }

    fn worst(&self, residual: &Residual) -> Worst {
        self.scales.worst(residual)
    }

    fn size(&self, stage: usize, correction: &[f64]) -> f64 {
        self.scales
            .size(correction, &self.trials[stage].state.scalars)
    }

    fn error(&self, difference: &[f64]) -> f64 {
        let (nodes, _) = split(difference, self.states[0].nodes.len());
        largest_motion(nodes, self.scales.reach())
    }

    fn error_of_scalars(&self, stage: usize, difference: &[f64]) -> f64 {
        let first = self.model.system.numbering().first_scalar();
        let [now, before] = [&self.trials[stage].state, &self.states[0]].map(|of| &of.scalars);
        let size = |i: usize| now[i].abs().max(before[i].abs());
        self.with_rate.largest(&difference[first..], size).part
    }

    fn speeds(&self, stage: Option<usize>, out: &mut Vec<f64>) {
        let state = stage.map_or(&self.states[0], |stage| &self.trials[stage].state);
        out.clear();
        for node in &state.nodes {
            out.extend(node.velocity.iter());
            out.extend(node.angular_velocity.iter());
        }
        out.extend(&state.scalars);
    }

    fn drift(&self, missed: &[f64], [now, largest]: [&[f64]; 2], time: f64) -> f64 {
        let first = MOTION * self.states[0].nodes.len();
        let moved = time * largest_motion(missed[..first].chunks(MOTION), self.scales.reach());
        let [missed, now, largest] = [missed, now, largest].map(|all| &all[first..]);
        let of_scalars = self.with_rate.error(missed, [now, largest], GROWN);
        if of_scalars > moved {
            of_scalars
        } else {
            moved
        }
    }

    fn describe_error(&self, difference: &[f64]) -> String {
        let system = &self.model.system;
        let scaled = |index: usize| match index % NODE_UNKNOWNS {
            0..3 => (difference[index] / self.scales.reach()).abs(),
            3..6 => difference[index].abs(),
            _ => 0.0,
        };
        let first = system.numbering().first_scalar();
        let now = &self.states[0].scalars;
        let of_scalars = self
            .with_rate
            .largest(&difference[first..], |i| now[i].abs());
        let indices = 0..NODE_UNKNOWNS * system.nodes().len();
        let worst = indices.max_by(|a, b| scaled(*a).total_cmp(&scaled(*b)));
        let Some(index) = worst.filter(|index| scaled(*index) >= of_scalars.part) else {
            let name = system.unknown(first + of_scalars.scalar);
            return name.off_by(of_scalars.part, of_scalars.scale);
        };
        let scale = match index % NODE_UNKNOWNS {
            0..3 => self.scales.reach(),
            _ => 1.0,
        };
        system.unknown(index).off_by(scaled(index), scale)
    }

    fn name(&self, index: usize) -> Name {
        self.model.system.equation(index)
    }
}

/// Appends to a residual the rows of the loads that balance each other: they are fulfilled.
fn complete(residual: &mut Residual, rows: usize) {
    residual.values.resize(rows, 0.0);
    residual.sizes.resize(rows, 0.0);
}
