//! The motion over one period, in equal steps of Radau IIA, and its linearization.

use super::map::{PeriodMap, StepMap};
use crate::analysis::transient::Multibody;
use crate::assembly::Sparse;
use crate::case::{Model, PeriodicSettings};
use crate::integrator::{Dae, OneStep, StepFailure};
use crate::model::{Conditions, State};
use crate::solver::LinearSolver;

/// Distance of a corner from the end of a step, as a part of the step, within which the step ends
/// at the corner, under the conditions before it.
const AT_CORNER: f64 = 1e-6;

/// A state of the period.
pub(super) struct Passed<'a> {
    /// Number of the step that led to it; zero is the first instant.
    pub step: usize,
    /// Time [s].
    pub time: f64,
    /// Length of the step [s].
    pub length: f64,
    /// Iterations of the step.
    pub iterations: usize,
    /// The state.
    pub state: &'a State,
    /// The conditions.
    pub conditions: &'a Conditions,
}

/// The map of a state at the first instant to the state a period later.
///
/// All steps are in axes that turn as the rotors do at the first instant of this period, so that the map
/// depends on nothing but the state and its rates: axes of another attitude have other errors.
pub(super) struct Flow<'a> {
    model: &'a Model,
    dae: Multibody<'a>,
    step: OneStep,
    solver: LinearSolver,
    from: f64,
    period: f64,
    steps: usize,
    /// Periods integrated so far.
    pub periods: usize,
}

impl<'a> Flow<'a> {
    /// Over the period of `settings` in `steps` steps; `state` is any state of the model.
    pub fn new(model: &'a Model, settings: &PeriodicSettings, steps: usize, state: &State) -> Self {
        let stages = settings.stages();
        let mut dae = Multibody::new(model, [state.clone(), state.clone()], (stages, false));
        dae.without_own_axes();
        let step = OneStep::new(&dae, settings.three_stages, settings.start.newton);
        Self {
            model,
            solver: LinearSolver::new(step.pattern()),
            step,
            dae,
            from: settings.start.from,
            period: settings.period,
            steps,
            periods: 0,
        }
    }

    /// The period \[s\].
    pub fn period(&self) -> f64 {
        self.period
    }

    /// Steps in a period.
    pub fn steps(&self) -> usize {
        self.steps
    }

    fn time(&self, step: usize) -> f64 {
        self.from + self.period * step as f64 / self.steps as f64
    }

    /// Drives with a corner within a step: the order of the formula is lower there.
    pub fn corners_in_steps(&self) -> usize {
        let length = self.period / self.steps as f64;
        let end = self.time(self.steps);
        let (mut time, mut count) = (self.from, 0);
        loop {
            time = self.model.next_corner(time);
            if time >= end || count > self.steps {
                return count;
            }
            let part = (time - self.from) / length;
            count += usize::from((part - part.round()).abs() > AT_CORNER);
        }
    }

    /// Begins a period.
    fn begin(&mut self, start: &State) {
        self.dae.begin_at(start);
        self.dae.keep_axes(self.from);
    }

    /// Converges the step of a number from one; returns its length, iterations and the time of the
    /// conditions at its end.
    fn converge(&mut self, number: usize) -> Result<(f64, usize), StepFailure> {
        let (begin, end) = (self.time(number - 1), self.time(number));
        let length = end - begin;
        let corner = self.dae.next_corner(begin + AT_CORNER * length);
        let last = if (corner - end).abs() <= AT_CORNER * length {
            corner.min(end).next_down()
        } else {
            end
        };
        self.dae.begin_step_at(begin);
        let iterations = self.step.converge(&mut self.dae, [begin, end], last)?;
        Ok((length, iterations))
    }

    /// Shows the state of the first instant to `visit`.
    pub fn first(&self, state: &State, visit: &mut dyn FnMut(&Passed<'_>) -> bool) -> bool {
        visit(&Passed {
            step: 0,
            time: self.from,
            length: 0.0,
            iterations: 0,
            state,
            conditions: &self.model.conditions_at(self.from),
        })
    }

    /// The state a period after `start`; every state is shown to `visit`.
    pub fn run(
        &mut self,
        start: &State,
        visit: &mut dyn FnMut(&Passed<'_>) -> bool,
    ) -> Result<State, StepFailure> {
        self.begin(start);
        for step in 1..=self.steps {
            let (length, iterations) = self.converge(step)?;
            self.dae.accept(self.step.stages() - 1);
            let time = self.time(step);
            let goes_on = visit(&Passed {
                step,
                time,
                length,
                iterations,
                state: self.dae.state(),
                conditions: &self.model.conditions_at(time),
            });
            if !goes_on {
                break;
            }
        }
        self.periods += 1;
        Ok(self.dae.state().clone())
    }

    /// The state a period after `start`, where `act` may change the state after each step.
    pub fn piloted(
        &mut self,
        start: &State,
        act: &mut dyn FnMut(&mut State),
    ) -> Result<State, StepFailure> {
        let mut state = start.clone();
        self.begin(start);
        for step in 1..=self.steps {
            self.dae.begin_at(&state);
            self.converge(step)?;
            self.dae.accept(self.step.stages() - 1);
            state.copy_from(self.dae.state());
            act(&mut state);
        }
        self.periods += 1;
        Ok(state)
    }

    /// The state a period after `start`, and the derivative of this map; `None` instead of the
    /// derivative if the matrix of a step is singular.
    pub fn linearized(&mut self, start: &State) -> Result<(State, Option<PeriodMap>), StepFailure> {
        self.begin(start);
        let mut maps = Some(Vec::with_capacity(self.steps));
        let (mut before, mut travel) = (start.scalars.clone(), vec![0.0; start.scalars.len()]);
        for number in 1..=self.steps {
            let (length, _) = self.converge(number)?;
            let map = maps.as_ref().and_then(|_| self.step_map(length));
            maps = maps.zip(map).map(|(mut maps, map)| {
                maps.push(map);
                maps
            });
            self.dae.accept(self.step.stages() - 1);
            let scalars = &self.dae.state().scalars;
            for (sum, (before, now)) in travel.iter_mut().zip(before.iter().zip(scalars)) {
                *sum += (now - before).abs();
            }
            before.clone_from(scalars);
        }
        self.periods += 1;
        let algebraic = self.dae.algebraic().to_vec();
        let map = maps.map(|maps| PeriodMap::new(maps, algebraic, &travel));
        Ok((self.dae.state().clone(), map))
    }

    /// The linearization of the converged step.
    fn step_map(&mut self, length: f64) -> Option<StepMap> {
        let matrix = self.step.matrix(&mut self.dae, length);
        let factors = self.solver.factorize(matrix)?;
        let stages = self.step.stages();
        let by_base = |dae: &mut Multibody<'_>, stage: usize| {
            let mut matrix = Sparse::zero(dae.pattern().clone());
            dae.by_base(stage, &mut matrix);
            matrix
        };
        Some(StepMap {
            factors,
            by_base: (0..stages).map(|s| by_base(&mut self.dae, s)).collect(),
            carried: self.dae.carried(stages - 1),
            weights: self.step.weights(length)[stages - 1][..stages].to_vec(),
        })
    }
}

#[cfg(test)]
pub(super) mod tests {
    use nalgebra::Vector3;
    use shared_geom::rotation::vector;

    use super::*;
    use crate::analysis::transient::start;

    /// A body on a hinge across a turning shaft.
    pub(in crate::analysis::periodic) const HOOP: &str = "[units]\nangle = \"rad\"\nrotation_speed = \"rad/s\"\n\
        [[node]]\nname = \"shaft\"\nposition = [0, 0, 0]\nangular_velocity = [0, 0, 5]\n\
        [[node]]\nname = \"arm\"\nposition = [0.65, 0, -0.46]\norientation = [0, -0.95, 0]\n\
        velocity = [0, 3.25, 0]\nangular_velocity = [0, 0, 5]\n\
        [[body]]\nname = \"shaft\"\nnode = \"shaft\"\nmass = 1\ninertia = [1, 1, 2]\n\
        [[body]]\nname = \"arm\"\nnode = \"arm\"\nmass = 1.5\ninertia = [0.14, 0.24, 0.2]\n\
        [[joint]]\nname = \"hinge\"\nkind = \"revolute\"\nnodes = [\"shaft\", \"arm\"]\n\
        at = [0, 0, 0]\naxis = [0, 1, 0]\n\
        [[joint]]\nname = \"bearing\"\nkind = \"revolute\"\nnodes = [\"shaft\"]\naxis = [0, 0, 1]\n\
        [gravity]\nacceleration = [0, 0, -9.81]\n";
    /// One step of a revolution in 64.
    const STEP: &str = "[periodic]\nperiod = 0.019634954\nsteps = 8\n";

    /// Changes of the nodes from one state to another, in the order of their unknowns.
    fn difference(from: &State, to: &State) -> Vec<f64> {
        let pairs = from.nodes.iter().zip(&to.nodes);
        let of_node = |(a, b): (&crate::model::NodeMotion, &crate::model::NodeMotion)| {
            let parts: [Vector3<f64>; 4] = [
                b.position - a.position,
                vector::from_rotation(&(b.rotation * a.rotation.transpose())),
                b.momentum - a.momentum,
                b.angular_momentum - a.angular_momentum,
            ];
            parts.iter().flatten().copied().collect::<Vec<_>>()
        };
        pairs.flat_map(of_node).collect()
    }

    // The linearized step against differences of fourth order of the step itself, in directions that violate
    // the constraints too: 1e-8 of the largest entry. An independent program has 1.7e-10 for the same
    // (`theory-periodic/maps.json`).
    #[test]
    fn the_map_of_a_step_is_its_derivative() {
        const SMALL: f64 = 2e-3;
        let text = format!("{HOOP}{STEP}");
        let input = crate::input::parse(&text, "hoop.dynamics.toml").unwrap();
        let settings = input.periodic.as_ref().unwrap();
        let model = &input.model;
        let state = start(model, &settings.start).unwrap().state;
        let mut flow = Flow::new(model, settings, 1, &state);
        let (_, map) = flow.linearized(&state).unwrap();
        let map = map.unwrap();
        let nodes = state.nodes.len();
        for seed in 0..4 {
            let entry = |i: usize| {
                if map.algebraic()[i] {
                    0.0
                } else {
                    (1.7 * (i + 30 * seed) as f64).sin()
                }
            };
            let direction: Vec<f64> = (0..map.size()).map(entry).collect();
            let mut slope = |size: f64| {
                let ends = [-size, size].map(|factor| {
                    let mut moved = state.clone();
                    let change: Vec<_> = direction.iter().map(|d| d * factor).collect();
                    moved.correct(&change);
                    flow.run(&moved, &mut |_| true).unwrap()
                });
                let found = difference(&ends[0], &ends[1]);
                found.iter().map(|d| d / (2.0 * size)).collect::<Vec<_>>()
            };
            let [fine, coarse] = [SMALL, 2.0 * SMALL].map(&mut slope);
            let mut expected = direction.clone();
            map.apply(&mut expected).unwrap();
            assert_eq!(fine.len(), crate::model::NODE_UNKNOWNS * nodes);
            let largest = expected.iter().fold(1.0_f64, |a, b| a.max(b.abs()));
            for ((fine, coarse), expected) in fine.iter().zip(&coarse).zip(&expected) {
                let off = (4.0 * fine - coarse) / 3.0 - expected;
                assert!(off.abs() < 1e-8 * largest, "{off} {expected} {largest}");
            }
        }
    }
}
