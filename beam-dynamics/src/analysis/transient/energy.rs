//! Energy balance of a run in time.
//!
//! The energy input of an element e is the work of its forces on the nodes, with the power `P = sum
//! F . v + M . omega`, beyond the change of its own energy:
//!
//! ```text
//! W_e = int P_e dt + E_e(t) - E_e(0)
//! G   = E(t) - E(0) - sum W_e                                                  (D-271)
//! ```
//!
//! W is zero except for loads, driven joints and springs, dampers, electrodes, varying gravity,
//! whose power is `a_g . sum beta` over all momenta, and impulses. The integral is the trapezoid
//! between accepted states; at a corner the powers are evaluated again. G is the gain by the
//! discretization. It is compared every few steps with
//!
//! ```text
//! G > g S + U ,     S = E_kin(0) + |E_el(0)| + sum int |P_e| dt + falls of potentials
//!                   U = sum h/2 |P_1 - P_0|
//! ```
//!
//! U being the possible error of the trapezoid if powers are not resolved, and g = 0.1, or 0.02 for
//! schemes without damping, whose gains continue as long as the run; their energy may alternate from
//! step to step, and the larger of two successive gains is compared. The dissipation of
//! dampers is excluded from this G, which is therefore too small: the work of a damper too stiff
//! for the steps is unknown.

use crate::assembly::{System, Workspace};
use crate::case::{Model, TransientSettings};
use crate::elements::{Energy, Exchange, Queries};
use crate::integrator::Corner;
use crate::model::{Conditions, State};

use super::multibody::Multibody;

mod finding;

pub(super) use finding::Finding;
use finding::damps;

/// Steps between two checks of the energy.
const LOOKED_AT: usize = 16;
/// The step before a check.
const BEFORE: usize = LOOKED_AT - 1;
/// Part of the total input above which a gain is reported, if it lasts for two checks.
const GAINED: f64 = 0.1;
/// The same for schemes without damping.
const GAINED_UNDAMPED: f64 = 0.02;
/// Part above which it is reported at once.
const SURELY: f64 = 1.0;
/// Error of the iteration, relative to the size of the model and in radians.
const LEFT: f64 = 1e-9;

/// Energy input of a run, and energy balance.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct EnergyBalance {
    /// Energy at the start, or at the beginning of a continued run [J].
    pub start: f64,
    /// Growth of the energy since then [J].
    pub growth: f64,
    /// Work of loads, drives and all others that supplied more than they absorbed [J].
    pub put_in: f64,
    /// Energy absorbed by dampers and all others that absorbed more than they supplied [J].
    pub taken_out: f64,
}

/// Integrals of a power, by the trapezoid.
#[derive(Debug, Clone, Copy, Default)]
struct Sum {
    /// The power at the latest accepted state [W].
    power: f64,
    /// Its integral, the integral of its magnitude, and their possible error [J].
    work: f64,
    amount: f64,
    doubt: f64,
}

impl Sum {
    fn at(power: f64) -> Self {
        Self {
            power,
            ..Self::default()
        }
    }

    /// Advances by a step of `length` \[s\].
    fn add(&mut self, power: f64, length: f64) {
        let half = 0.5 * length;
        self.work += half * (self.power + power);
        self.amount += half * (self.power.abs() + power.abs());
        self.doubt += half * (power - self.power).abs();
        self.power = power;
    }
}

/// An element that exchanges energy.
#[derive(Debug)]
struct Exchanger {
    element: usize,
    is_viscous: bool,
    sum: Sum,
}

/// The balance (D-271) with its measures.
#[derive(Debug, Clone, Copy, Default)]
struct Look {
    time: f64,
    balance: EnergyBalance,
    /// The unexplained gain, and its reference [J].
    gain: f64,
    scale: f64,
    doubt: f64,
}

/// The energy balance of a run.
#[derive(Debug)]
pub(super) struct EnergyWatch {
    exchangers: Vec<Exchanger>,
    /// The work of gravity, if it varies.
    gravity: Option<Sum>,
    work: Workspace,
    /// Energy of each element at the start, at the latest check and at the check of the largest
    /// gain, the last empty if there is none.
    start: Vec<Energy>,
    now: Vec<Energy>,
    then: Vec<Energy>,
    /// Largest decrease of potentials: elastic, of gravity, electric [J].
    falls: [f64; 3],
    /// Whether the energy can alternate from step to step.
    alternates: bool,
    /// The balance at the step before a check, if it is evaluated, and the energies of the elements.
    before: Option<Look>,
    now_before: Vec<Energy>,
    /// Energies of the error of the iteration: of positions [J], and of displacements in a
    /// step [J s^2].
    left: [f64; 2],
    steps: usize,
    length: f64,
    latest: Look,
    /// Beginning of a gain [s], and whether it is reported.
    since: Option<f64>,
    is_found: bool,
    largest: Look,
}

fn power_of_gravity(state: &State, conditions: &Conditions) -> f64 {
    let powers = state.nodes.iter().map(|node| node.momentum);
    powers
        .sum::<nalgebra::Vector3<f64>>()
        .dot(&conditions.loading.gravity)
}

/// Energies of the error of the iteration, see [`EnergyWatch`].
fn left_over(system: &System, (state, conditions): (&State, &Conditions), left: f64) -> [f64; 2] {
    let energy = system.energy(state, conditions);
    let mut other = state.clone();
    let way = left * system.size();
    for (i, node) in other.nodes.iter_mut().enumerate() {
        // In any direction, and of a different size at each node.
        let part =
            |k: usize| (0.7 + 0.3 * ((3 * i + k) as f64).sin()) * (1.0 - 2.0 * (i % 2) as f64);
        let all = nalgebra::Vector3::new(part(0), part(1), part(2));
        node.position += way * all;
        node.velocity = way * all;
        node.angular_velocity = left * all;
    }
    let moved = system.energy(&other, conditions);
    let of_positions = (moved.elastic - energy.elastic).abs()
        + (moved.gravity - energy.gravity).abs()
        + (moved.electric - energy.electric).abs();
    [of_positions, moved.kinetic]
}

impl EnergyWatch {
    /// An energy balance from the state of `dae` on, under `conditions`.
    pub fn new(
        model: &Model,
        settings: &TransientSettings,
        dae: &Multibody<'_>,
        conditions: &Conditions,
    ) -> Self {
        let (system, state) = (&model.system, dae.state());
        let at = (state, conditions);
        let mut work = system.workspace();
        let elements = system.elements().enumerate();
        let exchange = elements.filter_map(|(element, one)| match one.exchange() {
            Exchange::Nothing => None,
            exchange => Some((element, exchange == Exchange::Viscous)),
        });
        let exchangers = exchange.map(|(element, is_viscous)| Exchanger {
            element,
            is_viscous,
            sum: Sum::at(system.power_of(element, at, &mut work)),
        });
        let exchangers = exchangers.collect();
        let changes = model.gravity_drive.constant().is_none();
        let count = system.element_count();
        let start: Vec<_> = (0..count)
            .map(|element| system.energy_of(element, at, &mut work))
            .collect();
        Self {
            exchangers,
            gravity: changes.then(|| Sum::at(power_of_gravity(state, conditions))),
            work,
            now: start.clone(),
            then: Vec::new(),
            now_before: start.clone(),
            start,
            falls: [0.0; 3],
            alternates: !damps(settings.scheme),
            before: None,
            left: left_over(system, at, settings.newton.correction.max(LEFT)),
            steps: 0,
            length: f64::INFINITY,
            latest: Look::default(),
            since: None,
            is_found: false,
            largest: Look::default(),
        }
    }

    /// Advances by an accepted step to `time`, of `length` \[s\], which began at `corner` if there
    /// was one; `conditions` apply at its end.
    pub fn step(
        &mut self,
        dae: &Multibody<'_>,
        (corner, conditions): (Option<Corner>, &Conditions),
        [time, length]: [f64; 2],
    ) {
        let model = dae.model;
        if let Some(corner) = corner {
            let after = model.conditions_at(corner.after);
            self.renew((&dae.states()[1], &after), &model.system);
        }
        let at = (dae.state(), conditions);
        for one in &mut self.exchangers {
            let power = model.system.power_of(one.element, at, &mut self.work);
            one.sum.add(power, length);
        }
        if let Some(sum) = &mut self.gravity {
            sum.add(power_of_gravity(at.0, conditions), length);
        }
        self.steps += 1;
        self.length = length;
        match self.steps % LOOKED_AT {
            0 => self.look(dae, conditions, time),
            BEFORE if self.alternates => {
                self.before = Some(self.evaluate(dae, conditions, time));
                self.now_before.clone_from(&self.now);
            }
            _ => {}
        }
    }

    /// Evaluates the powers again just after a corner.
    fn renew(&mut self, at: (&State, &Conditions), system: &System) {
        for one in &mut self.exchangers {
            one.sum.power = system.power_of(one.element, at, &mut self.work);
        }
        if let Some(sum) = &mut self.gravity {
            sum.power = power_of_gravity(at.0, at.1);
        }
    }

    /// Checks the energy at the end, unless this was done already.
    pub fn end(&mut self, dae: &Multibody<'_>, conditions: &Conditions, time: f64) {
        if !self.steps.is_multiple_of(LOOKED_AT) {
            self.look(dae, conditions, time);
        }
    }

    /// The balance at the latest check.
    pub fn balance(&self) -> EnergyBalance {
        self.latest.balance
    }

    /// The balance at a state.
    fn evaluate(&mut self, dae: &Multibody<'_>, conditions: &Conditions, time: f64) -> Look {
        let system = &dae.model.system;
        for (element, now) in self.now.iter_mut().enumerate() {
            *now = system.energy_of(element, (dae.state(), conditions), &mut self.work);
        }
        self.account(dae.impulses.work, time)
    }

    /// Checks the energy, and the one of the step before if that is larger.
    fn look(&mut self, dae: &Multibody<'_>, conditions: &Conditions, time: f64) {
        let look = self.evaluate(dae, conditions, time);
        self.latest = look;
        let before = self.before.take();
        let before = before.filter(|before| before.gain > look.gain);
        let energies = match before {
            Some(_) => &self.now_before,
            None => &self.now,
        };
        let look = before.unwrap_or(look);
        let [of_positions, ways] = self.left;
        let left = of_positions + ways / (self.length * self.length);
        let is_above = |part: f64| look.gain > part * look.scale + look.doubt + left;
        let gained = match self.alternates {
            true => GAINED_UNDAMPED,
            false => GAINED,
        };
        if !is_above(gained) {
            if !self.is_found {
                self.since = None;
            }
            return;
        }
        let is_second = self.since.is_some();
        if !is_second || look.gain > self.largest.gain {
            self.largest = look;
            self.then.clone_from(energies);
        }
        self.since.get_or_insert(look.time);
        self.is_found |= is_second || is_above(SURELY);
    }

    /// The balance of the energies of the latest check.
    fn account(&mut self, impulses: f64, time: f64) -> Look {
        let sum = |energies: &[Energy]| {
            let mut sum = Energy::default();
            energies.iter().for_each(|energy| sum += *energy);
            sum
        };
        let [start, now] = [&self.start, &self.now].map(|energies| sum(energies));
        let falls = [
            start.elastic - now.elastic,
            start.gravity - now.gravity,
            start.electric - now.electric,
        ];
        for (largest, fall) in self.falls.iter_mut().zip(falls) {
            *largest = largest.max(fall);
        }
        let growth = now.total() - start.total();
        let falls = [
            self.falls[0].max(start.elastic.abs()),
            // Varying gravity supplies energy.
            self.gravity.map_or(self.falls[1], |_| 0.0),
            self.falls[2].max(start.electric.abs()),
        ];
        let mut look = Look {
            time,
            balance: EnergyBalance {
                start: start.total(),
                growth,
                ..EnergyBalance::default()
            },
            gain: growth,
            scale: start.kinetic + falls.iter().sum::<f64>(),
            doubt: 0.0,
        };
        for one in &self.exchangers {
            let stored = self.now[one.element].total() - self.start[one.element].total();
            look.add(&one.sum, stored, one.is_viscous);
        }
        if let Some(sum) = &self.gravity {
            look.add(sum, now.gravity - start.gravity, false);
        }
        let impulse = Sum {
            work: impulses,
            amount: impulses.abs(),
            ..Sum::default()
        };
        look.add(&impulse, 0.0, false);
        look
    }
}

impl Look {
    /// Adds the input of one element, which has `stored` \[J\] itself.
    fn add(&mut self, sum: &Sum, stored: f64, is_viscous: bool) {
        let work = sum.work + stored;
        if work > 0.0 {
            self.balance.put_in += work
        } else {
            self.balance.taken_out -= work
        }
        self.doubt += sum.doubt;
        if is_viscous {
            self.gain -= work.max(0.0);
            self.scale += work.max(0.0);
        } else {
            self.gain -= work;
            self.scale += sum.amount;
        }
    }
}
