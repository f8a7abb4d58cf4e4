//! The periodic motion by Newton's method for its first state.
//!
//! ```text
//! ( I - M ) d = y(T) seen from y(0) ,     y(0) <- y(0) o d                         (D-446)
//! ```
//!
//! by generalized minimal residuals: the multipliers that the constraints add are zero, so that all
//! unknowns of the redundant coordinates take part without projection, and the number of products is
//! the number of independent states at most. The first state need not fulfill the constraints.

use nalgebra::{DMatrix, DVector};

use super::border::Border;
use super::failure::PeriodicFailure;
use super::flow::Flow;
use super::map::PeriodMap;
use super::passes::Passes;
use super::sizes::{seen, worst};
use crate::analysis::effects::{self, Noise};
use crate::case::{Model, PeriodicSettings};
use crate::integrator::StepFailure;
use crate::model::{NODE_UNKNOWNS, State};
use crate::result::PeriodicPass;
use crate::solver::{Gmres, gmres};

/// Residual of the correction [-].
const TOLERANCE: f64 = 1e-8;
/// Residual above which a correction is none [-].
const SINGULAR: f64 = 1e-3;
/// Largest rotation of a correction, without and with controls: these turn blades, whose lift has its
/// slope up to stall only [rad].
const FARTHEST: [f64; 2] = [0.3, 0.15];
/// Largest number of products of a correction.
const MOST: usize = 400;
/// Iterations in which a control would leave the bound at which it is, after which it is given up.
const BLOCKED: usize = 3;
/// Largest number of halvings of a correction after which the period has no solution.
const HALVINGS: usize = 4;

/// A periodic motion.
pub(super) struct Orbit {
    /// Its first state.
    pub state: State,
    /// The state a period later, with the rates and multipliers of the motion.
    pub end: State,
    /// The linearized period.
    pub map: PeriodMap,
}

/// Changes of the periodic motion by controls of unit size.
pub(super) struct Responses {
    /// Of the means of the targets (rows), of unit size, by the controls (columns).
    pub means: DMatrix<f64>,
    /// Largest rotation of a node by each control \[rad\].
    pub turns: Vec<f64>,
}

/// The last correction of a state.
struct Tried {
    base: State,
    d: Vec<f64>,
    halvings: usize,
    /// The largest error before it, as text.
    worst: String,
}

impl Tried {
    fn new(base: State, d: Vec<f64>, worst: String) -> Self {
        Self {
            base,
            d,
            halvings: 0,
            worst,
        }
    }
}

/// Newton's method.
pub(super) struct Shooting<'a> {
    pub model: &'a Model,
    pub settings: &'a PeriodicSettings,
    pub border: &'a Border,
    /// Sizes of the unknowns.
    pub sizes: &'a [f64],
}

impl Shooting<'_> {
    /// The periodic motion of `flow` near the first state `state`, which becomes the last state of the
    /// iteration; iterations are added to `passes`. If it is not found, controls that do not determine
    /// the targets are named: the corrections of dependent controls are finite but for the errors of
    /// the linear equations.
    pub fn solve(
        &self,
        flow: &mut Flow<'_>,
        state: &mut State,
        passes: &mut Passes<'_>,
    ) -> Result<Orbit, PeriodicFailure> {
        let mut last = None;
        let found = self.iterate(flow, state, passes, &mut last);
        found.map_err(|failure| {
            let is_search = matches!(
                failure,
                PeriodicFailure::NotConverged { .. }
                    | PeriodicFailure::Unreached { .. }
                    | PeriodicFailure::Bound { .. }
            );
            let idle = last.filter(|_| is_search).and_then(|map| self.idle(&map));
            idle.map_or(failure, |reason| PeriodicFailure::Idle { reason })
        })
    }

    /// Newton's method; `last` is the last linearized period.
    fn iterate(
        &self,
        flow: &mut Flow<'_>,
        state: &mut State,
        passes: &mut Passes<'_>,
        last: &mut Option<PeriodMap>,
    ) -> Result<Orbit, PeriodicFailure> {
        self.border.begin(state);
        let rows = self.border.sizes(self.sizes);
        let (mut iterations, mut blocked) = (0, 0);
        let (mut tried, begun): (Option<Tried>, _) = (None, passes.list().len());
        loop {
            let (end, map) = match flow.linearized(state) {
                Ok(found) => found,
                Err(failure) => {
                    self.step_back(state, tried.as_mut(), failure)?;
                    continue;
                }
            };
            let map = map.ok_or(PeriodicFailure::SingularStep)?;
            let (residual, (index, part)) = self.residual(state, (&end, map.algebraic()), &rows);
            let worst = self.name(index, part, rows[index]);
            passes.push(self.pass(state, (&end, map.algebraic())));
            if part <= self.settings.tolerance {
                let state = state.clone();
                return self.determined(Orbit { state, end, map }, &rows);
            }
            let map = last.insert(map);
            if self.is_over(iterations, &passes.list()[begun..]) || !part.is_finite() {
                return Err(PeriodicFailure::NotConverged { iterations, worst });
            }
            let found = self.correction(map, &residual, &rows);
            let Some(found) = found.filter(|found| found.residual < SINGULAR) else {
                return Err(self.singular(map, worst));
            };
            let mut d: Vec<_> = found.x.iter().zip(self.sizes).map(|(x, s)| x * s).collect();
            self.check_controls(map, &d)?;
            let applied = self.part(&d);
            d.iter_mut().for_each(|d| *d *= applied);
            if let Some(pass) = passes.last_mut() {
                (pass.products, pass.part) = (found.products, applied);
            }
            let limited = self.border.limit(&mut d, state);
            blocked = limited.map_or(0, |_| blocked + 1);
            if let Some((control, bound)) = limited.filter(|_| blocked >= BLOCKED) {
                return Err(PeriodicFailure::bound(control, bound, worst));
            }
            let base = end_rates(state.clone(), &end);
            *state = moved(&base, &d);
            tried = Some(Tried::new(base, d, worst));
            iterations += 1;
        }
    }

    /// Whether the iteration of `passes` ends without a motion: its number is the largest one, or the change has not
    /// become smaller in the last half of it.
    fn is_over(&self, iterations: usize, passes: &[PeriodicPass]) -> bool {
        let most = self.settings.iterations;
        let mut recent = passes.iter().rev().map(|pass| pass.residual);
        let last = recent.by_ref().take(most.div_ceil(2));
        let last = last.fold(f64::INFINITY, f64::min);
        iterations >= most || recent.fold(f64::INFINITY, f64::min) <= last
    }

    /// Halves the last correction, from which the period has no solution.
    ///
    /// # Errors
    /// The failure of the period, if there was no correction or it was halved often enough.
    fn step_back(
        &self,
        state: &mut State,
        tried: Option<&mut Tried>,
        failure: StepFailure,
    ) -> Result<(), PeriodicFailure> {
        let Some(tried) = tried else {
            return Err(failure.into());
        };
        if tried.halvings == HALVINGS {
            state.copy_from(&tried.base);
            return Err(match self.border.count() {
                0 => failure.into(),
                _ => PeriodicFailure::Unreached {
                    worst: tried.worst.clone(),
                    controls: self.border.written(state),
                    step: Box::new(failure),
                },
            });
        }
        tried.halvings += 1;
        tried.d.iter_mut().for_each(|d| *d *= 0.5);
        *state = moved(&tried.base, &tried.d);
        Ok(())
    }

    /// The change of a state in a period with the errors of the targets, and the index and the size of
    /// its largest entry relative to the sizes of the `rows`.
    pub fn residual(
        &self,
        state: &State,
        (end, algebraic): (&State, &[bool]),
        rows: &[f64],
    ) -> (Vec<f64>, (usize, f64)) {
        let mut residual = seen(end, state, algebraic);
        self.border.complete(&mut residual, end);
        let worst = worst(&residual, rows);
        (residual, worst)
    }

    /// A period from a state, without a correction.
    pub fn pass(&self, state: &State, (end, algebraic): (&State, &[bool])) -> PeriodicPass {
        let rows = self.border.sizes(self.sizes);
        let (_, (index, part)) = self.residual(state, (end, algebraic), &rows);
        PeriodicPass {
            residual: part,
            worst: self.name(index, part, rows[index]),
            products: 0,
            part: 0.0,
            reached: self.border.reached(end),
        }
    }

    /// The solution in sizes of the unknowns; `None` if it is not finite.
    fn correction(&self, map: &PeriodMap, residual: &[f64], rows: &[f64]) -> Option<Gmres> {
        let right: Vec<_> = residual
            .iter()
            .zip(rows)
            .map(|(r, size)| r / size)
            .collect();
        gmres(
            &mut |x| self.product(map, rows, x),
            &right,
            (TOLERANCE, MOST),
        )
    }

    /// `(I - M) x` with the rows of the border, in sizes of rows and unknowns.
    fn product(&self, map: &PeriodMap, rows: &[f64], x: &mut [f64]) -> Option<()> {
        let d: Vec<_> = x.iter().zip(self.sizes).map(|(x, size)| x * size).collect();
        let mut later = d.clone();
        map.apply(&mut later)?;
        for (x, (d, later)) in x.iter_mut().zip(d.iter().zip(&later)) {
            *x = d - later;
        }
        self.border.product([&d, &later], x);
        x.iter_mut().zip(rows).for_each(|(x, size)| *x /= size);
        Some(())
    }

    /// The part of a correction that turns no node far.
    fn part(&self, d: &[f64]) -> f64 {
        part_of(self.largest_turn(d), self.border.count() > 0)
    }

    /// The largest rotation of a node in a variation \[rad\].
    fn largest_turn(&self, d: &[f64]) -> f64 {
        let nodes = self.model.system.nodes().len();
        let turns = d[..NODE_UNKNOWNS * nodes].chunks(NODE_UNKNOWNS);
        let all = turns.flat_map(|node| &node[3..6]);
        all.fold(0.0, |largest, turn| largest.max(turn.abs()))
    }

    /// The unknown or the target of the largest entry, as text.
    pub fn name(&self, index: usize, part: f64, size: f64) -> String {
        match self.border.target(index) {
            Some(target) => format!(
                "the mean of \"{}\" is off by {:.3e}",
                target.name,
                part * size
            ),
            None => self.model.system.unknown(index).off_by(part, size),
        }
    }

    /// The reason of a singular correction: a control that does not act, or the motion that does not
    /// repeat.
    fn singular(&self, map: &PeriodMap, name: String) -> PeriodicFailure {
        match self.idle(map) {
            Some(reason) => PeriodicFailure::Idle { reason },
            None => PeriodicFailure::Singular {
                reason: format!("nothing determines {name}"),
            },
        }
    }

    /// Checks that the controls determine the targets, if a correction `d` of them is large.
    fn check_controls(&self, map: &PeriodMap, d: &[f64]) -> Result<(), PeriodicFailure> {
        let is_large = self.border.is_suspicious(d);
        match is_large.then(|| self.idle(map)).flatten() {
            Some(reason) => Err(PeriodicFailure::Idle { reason }),
            None => Ok(()),
        }
    }

    /// A motion that has its targets, if its controls determine them: targets that depend on each
    /// other are met by any of many controls. Any other targets are reached by a correction if they do.
    fn determined(&self, orbit: Orbit, rows: &[f64]) -> Result<Orbit, PeriodicFailure> {
        let mut other = vec![0.0; rows.len()];
        let targets = self.border.target_rows();
        for (number, row) in targets.iter().enumerate() {
            // Values without a pattern.
            other[*row] = rows[*row] * (1.0 + 0.618 * number as f64).sin();
        }
        if targets.is_empty() {
            return Ok(orbit);
        }
        let found = self.correction(&orbit.map, &other, rows);
        let is_regular = |found: Gmres| {
            let d = found.x.iter().zip(self.sizes).map(|(x, size)| x * size);
            // Equations that are singular but for round-off have a solution of large controls.
            found.residual < SINGULAR && !self.border.is_suspicious(&d.collect::<Vec<_>>())
        };
        if found.is_some_and(is_regular) {
            return Ok(orbit);
        }
        match self.idle(&orbit.map) {
            Some(reason) => Err(PeriodicFailure::Idle { reason }),
            None => Ok(orbit),
        }
    }

    /// Why the controls do not determine the targets near a motion; `None` if they do.
    pub fn idle(&self, map: &PeriodMap) -> Option<String> {
        let response = self.responses(map)?.means;
        self.border.idle(&response, effects::BY_PRODUCTS)
    }

    /// The changes of the means and of the first state in the periodic motion by the controls; means whose
    /// changes are round-off do not change.
    pub fn responses(&self, map: &PeriodMap) -> Option<Responses> {
        let count = self.border.count();
        let mut means = DMatrix::zeros(count, count);
        // Of each column: means of the sizes of the momentary changes of the targets, and the largest change
        // of the motion.
        let (mut sizes, mut motions) = (DMatrix::zeros(count, count), vec![0.0; count]);
        let mut turns = vec![0.0; count];
        for column in 0..count {
            let mut later = self.change_by(self.border.control(column), map)?;
            turns[column] = self.largest_turn(&later);
            motions[column] = self.largest_motion(&later);
            let sum = map.apply_with_travel(&mut later)?;
            means.set_column(column, &DVector::from_vec(self.border.means(&later)));
            sizes.set_column(column, &DVector::from_vec(self.border.means(&sum)));
        }
        let travel = self.border.means(map.travel());
        for row in 0..count {
            let noise = Noise {
                travel: travel[row],
                changes: sizes.row(row).iter().copied().collect(),
                motions: &motions,
            };
            if noise.hides(means.row(row).iter()) {
                means.row_mut(row).fill(0.0);
            }
        }
        Some(Responses { means, turns })
    }

    /// The change of the first state of the periodic motion by a control of unit size.
    fn change_by(&self, control: usize, map: &PeriodMap) -> Option<Vec<f64>> {
        let held = self.border.unknowns();
        let mut first = vec![0.0; self.sizes.len()];
        first[control] = self.sizes[control];
        let mut right = first.clone();
        map.apply(&mut right)?;
        held.iter().for_each(|i| right[*i] = 0.0);
        let mut product = |x: &mut [f64]| {
            let mut d: Vec<_> = x.iter().zip(self.sizes).map(|(x, s)| x * s).collect();
            map.apply(&mut d)?;
            held.iter().for_each(|i| d[*i] = 0.0);
            let scaled = d.iter().zip(self.sizes).map(|(d, s)| d / s);
            x.iter_mut().zip(scaled).for_each(|(x, d)| *x -= d);
            Some(())
        };
        let scaled: Vec<_> = right.iter().zip(self.sizes).map(|(d, s)| d / s).collect();
        let found = gmres(&mut product, &scaled, (TOLERANCE, MOST))?;
        let moved = found.x.iter().zip(self.sizes).map(|(x, s)| x * s);
        let both = first.iter().zip(moved);
        Some(both.map(|(first, moved)| first + moved).collect())
    }

    /// The largest entry of a variation relative to its size, without controls and integrals.
    fn largest_motion(&self, d: &[f64]) -> f64 {
        let held = self.border.unknowns();
        let parts = d.iter().zip(self.sizes).enumerate();
        let own = parts.filter(|(i, _)| !held.contains(i));
        own.fold(0.0, |most, (_, (d, size))| most.max((d / size).abs()))
    }
}

/// The part of a change that turns a node by an angle \[rad\] which is not too far, with controls or
/// without.
pub(super) fn part_of(turn: f64, has_controls: bool) -> f64 {
    let farthest = FARTHEST[usize::from(has_controls)];
    if turn > farthest {
        farthest / turn
    } else {
        1.0
    }
}

/// A state after a correction; its rates turn with the nodes, and with them the axes of the rotors in the next
/// period.
fn moved(base: &State, d: &[f64]) -> State {
    let mut state = base.clone();
    state.correct(d);
    for (node, before) in state.nodes.iter_mut().zip(&base.nodes) {
        let turn = node.rotation * before.rotation.transpose();
        node.angular_velocity = turn * before.angular_velocity;
    }
    state
}

/// The state with the rates, multipliers and algebraic scalars of the end of the period, from which
/// the iteration of its first step begins.
fn end_rates(state: State, end: &State) -> State {
    let mut begun = end.clone();
    for (node, own) in begun.nodes.iter_mut().zip(&state.nodes) {
        node.position = own.position;
        node.rotation = own.rotation;
        node.momentum = own.momentum;
        node.angular_momentum = own.angular_momentum;
    }
    begun.scalars = state.scalars;
    begun
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::periodic::flow::tests::HOOP;
    use crate::analysis::periodic::{algebraic, sizes};
    use crate::analysis::transient::start;

    /// A drag of the shaft and a torque that drives it; the target is the azimuth.
    const DRIVEN: &str = "[[spring]]\nname = \"drag\"\nnode = \"shaft\"\nrotational_damping = [0, 0, 0.3]\n\
        [[load]]\nnode = \"shaft\"\nmoment = [0, 0, 1]\ndrive = \"= torque\"\n\
        [sensors.side]\nquantity = \"position\"\nof = \"arm\"\ncomponent = \"y\"\nunit = \"m\"\n\
        [periodic]\nperiod = 1.2566370614359172\n\
        [[trim.control]]\nname = \"torque\"\nguess = 1.5\n\
        [[trim.target]]\nname = \"azimuth\"\nsignal = \"= 2*side*cos(5*t)\"\nvalue = 0\n";

    // The free azimuth makes `I - M` singular, and the torque with its target does not: conditions of 1e14 and
    // 130 of an independent program in its own sizes (`theory-periodic/hoop.json`); below 1e4 is required.
    #[test]
    fn a_free_azimuth_is_regular_with_its_torque() {
        let text = format!("{HOOP}{DRIVEN}");
        let input = crate::input::parse(&text, "hoop.dynamics.toml").unwrap();
        let (model, settings) = (&input.model, input.periodic.as_ref().unwrap());
        let mut state = start(model, &settings.start).unwrap().state;
        let border = Border::new(model, settings).unwrap();
        let mut flow = Flow::new(model, settings, settings.steps, &state);
        let conditions = model.conditions_at(0.0);
        let free = algebraic(model, &state);
        let sizes = sizes::sizes(model, (&state, &conditions), &free, settings.period);
        let shooting = Shooting {
            model,
            settings,
            border: &border,
            sizes: &sizes,
        };
        let mut list = Vec::new();
        let mut quiet = |_: &PeriodicPass| {};
        let passes = &mut Passes::new(&mut list, &mut quiet);
        let orbit = shooting.solve(&mut flow, &mut state, passes).unwrap();
        let rows = border.sizes(&sizes);
        let condition = |border: &Border| {
            let shooting = Shooting { border, ..shooting };
            let n = sizes.len();
            let mut matrix = DMatrix::identity(n, n);
            for mut column in matrix.column_iter_mut() {
                let mut x: Vec<f64> = column.iter().copied().collect();
                shooting.product(&orbit.map, &rows, &mut x).unwrap();
                column.copy_from_slice(&x);
            }
            let values = matrix.singular_values();
            values.max() / values.min()
        };
        let [bordered, plain] = [condition(&border), condition(&border.held())];
        println!("{bordered:e} {plain:e}");
        assert!(bordered < 1e4, "{bordered:e}");
        assert!(plain > 1e8, "{plain:e}");
    }
}
