//! Jumps at a corner of drives, and the impulses that cause them.
//!
//! If the rate of a driven constraint jumps, unbounded reactions act in zero time: the velocities
//! jump at unchanged positions, with the impulse Lambda of the reactions,
//!
//! ```text
//! M (v+ - v-) + C^T Lambda = 0,   C v+ + Phi_t+ = 0                            (D-153)
//! ```
//!
//! the change of the least kinetic energy that fulfills the constraints. No motion can follow a
//! jump of a driven position.

use std::borrow::Cow;
use std::cell::Cell;
use std::fmt;
use std::ops::Range;

use shared_geom::units::rounded;

use super::failure::TransientFailure;
use super::placing::velocity_constraints;
use super::rates::{Accelerated, consistent_rates, find_momenta};
use super::saddle::MOTION;
use super::scalars::{self, Settling};
use crate::assembly::{Residual, Sharing, System};
use crate::case::Model;
use crate::elements::{Element, Level, PositionJump, Queries};
use crate::integrator::{Corner, Renewal};
use crate::model::{Conditions, Equation, NODE_UNKNOWNS, Scalars, State};

/// Next corner of the given functions of time, kept until it is reached.
#[derive(Debug, Clone, Default)]
pub(super) struct NextCorner(Cell<Option<[f64; 2]>>);

impl NextCorner {
    /// The first corner of the model after `time` \[s\].
    pub fn after(&self, model: &Model, time: f64) -> f64 {
        match self.0.get() {
            Some([requested, known]) if (requested..known).contains(&time) => known,
            _ => {
                let corner = model.next_corner(time);
                self.0.set(Some([time, corner]));
                corner
            }
        }
    }
}

/// Error of positions after the iteration of a step, relative to the size of the model and in
/// radians: velocities that move less in a step are ignored.
const LEFT: f64 = 1e-9;
/// Relative jump of a force, or of an acceleration, below which a corner is ignored: the residual
/// of a step is no smaller.
const NEGLIGIBLE: f64 = 1e-8;
/// Number of corners of an element that are checked before a run; the others are checked when they
/// are reached.
const LOOKED_AT: usize = 1000;
/// Part of the jumping velocities that a velocity may be off by after an impulse, if no velocities
/// follow it.
const FOLLOWED: f64 = 1e-6;
/// Largest number of joints whose impulses are reported.
const MOST_REPORTED: usize = 5;

/// Kinds of jumps at a corner.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Jump {
    /// No significant jump.
    Nothing,
    /// Forces, or driven accelerations.
    Acting,
    /// Rates of the constraints of these indices.
    Rates(Vec<usize>),
}

/// The kind of jump at a state between the conditions just before a corner, where its residual was
/// `earlier`, and those just after it, for the wished step length `step` \[s\]; `None` if an
/// element does not define its jumps.
pub(super) fn jump(
    system: &System,
    (state, earlier): (&State, &Residual),
    [before, after]: [&Conditions; 2],
    step: f64,
) -> Option<Jump> {
    let later = system.residual(state, after);
    let (by_time_before, left_before) = system.constraint_rates(state, before)?;
    let (by_time_after, left_after) = system.constraint_rates(state, after)?;
    let first = NODE_UNKNOWNS * state.nodes.len();
    let least = LEFT * system.size().min(1.0) / step;
    let levels = system.levels().into_iter().enumerate();
    let rates = levels.filter(|&(i, level)| {
        let jump = match level {
            Level::Position => by_time_after[i] - by_time_before[i],
            Level::Velocity => later.values[first + i] - earlier.values[first + i],
        };
        // NaN is not less either, and reported by the next step.
        !matches!(
            jump.abs().partial_cmp(&least),
            Some(std::cmp::Ordering::Less | std::cmp::Ordering::Equal)
        )
    });
    let rates: Vec<_> = rates.map(|(i, _)| i).collect();
    if !rates.is_empty() {
        return Some(Jump::Rates(rates));
    }
    let of_force = |row: usize| row % NODE_UNKNOWNS >= Equation::Force.row();
    let forces = (0..first).filter(|row| of_force(*row));
    let scalars = system.numbering().first_scalar()..earlier.values.len();
    let is_felt = forces.chain(scalars).any(|row| {
        let least = NEGLIGIBLE * earlier.sizes[row].max(later.sizes[row]);
        (later.values[row] - earlier.values[row]).abs() > least
    });
    let mut pairs = left_before.iter().zip(&left_after);
    let jumps = |(a, b): (&f64, &f64)| (b - a).abs() > NEGLIGIBLE * a.abs().max(b.abs());
    if is_felt || pairs.any(jumps) {
        Some(Jump::Acting)
    } else {
        Some(Jump::Nothing)
    }
}

/// `state` after the impulse after which its velocities fulfill the constraints (D-153), with its
/// momenta; and the impulse \[N s, N m s\], the minimum-norm one if constraints are redundant.
/// `None` if there is none, or if no velocities fulfill all constraints.
pub(super) fn after_impulse(
    system: &System,
    state: &State,
    conditions: &Conditions,
) -> Option<(State, Vec<f64>)> {
    let nodes = state.nodes.len();
    let off = velocity_constraints(system, state, conditions);
    let tangent = system.tangent(state, conditions);
    let mut right = vec![0.0; MOTION * nodes];
    right.extend(off.iter().map(|off| -off));
    let mut solution = Accelerated::new(system, state, &tangent).solve(nodes, &right)?;
    let mut impulse = solution.split_off(MOTION * nodes);
    let mut state = state.clone();
    for (node, change) in state.nodes.iter_mut().zip(solution.chunks(MOTION)) {
        for i in 0..3 {
            node.velocity[i] += change[i];
            node.angular_velocity[i] += change[3 + i];
        }
    }
    let left = largest(&velocity_constraints(system, &state, conditions));
    let follows = left <= FOLLOWED * largest(&off);
    if !follows {
        return None;
    }
    Sharing::new(system, &state, conditions).take_surplus(&mut impulse);
    find_momenta(system, &mut state, conditions);
    Some((state, impulse))
}

/// The largest size, infinite if one is not a number.
fn largest(values: &[f64]) -> f64 {
    let sizes = values.iter().map(|value| {
        if value.is_nan() {
            f64::INFINITY
        } else {
            value.abs()
        }
    });
    sizes.fold(0.0, f64::max)
}

/// Impulses of a joint.
#[derive(Debug, Clone, PartialEq)]
struct JointImpulse {
    joint: String,
    /// The first time [s].
    time: f64,
    /// Number of impulses.
    count: usize,
    /// The largest impulses so far of its constraints whose rates jump, by unit: of forces, of
    /// moments [N s, N m s].
    largest: Vec<(f64, Cow<'static, str>)>,
    /// Whether velocities followed it each time.
    is_followed: bool,
}

impl JointImpulse {
    /// Notes an impulse by its sizes in several units.
    fn grow(&mut self, sizes: Vec<(f64, Cow<'static, str>)>) {
        for (size, unit) in sizes {
            match self.largest.iter_mut().find(|known| known.1 == unit) {
                Some(known) => known.0 = known.0.max(size),
                None => self.largest.push((size, unit)),
            }
        }
    }
}

/// Sizes of the impulse of the constraints `constraints` that are in `own`, by the units of their
/// reactions.
fn sizes(
    system: &System,
    (constraints, impulse): (&[usize], &[f64]),
    own: &Range<usize>,
) -> Vec<(f64, Cow<'static, str>)> {
    let first = NODE_UNKNOWNS * system.nodes().len();
    let mut sizes: Vec<(f64, Cow<'static, str>)> = Vec::new();
    for &one in constraints.iter().filter(|one| own.contains(one)) {
        let unit = system.unknown(first + one).unit;
        match sizes.iter_mut().find(|known| known.1 == unit) {
            Some(known) => known.0 = known.0.hypot(impulse[one]),
            None => sizes.push((impulse[one].abs(), unit)),
        }
    }
    sizes
}

/// The impulses of a run so far, by joint.
#[derive(Debug, Clone, Default)]
pub(super) struct Impulses {
    joints: Vec<JointImpulse>,
    /// Their energy input [J].
    pub work: f64,
}

impl Impulses {
    /// Notes the joints with the constraints `constraints`, and the impulse of all constraints if
    /// velocities follow it.
    fn add(&mut self, system: &System, constraints: &[usize], impulse: Option<&[f64]>, time: f64) {
        let mut first = 0;
        for element in system.elements() {
            let own = first..first + element.multipliers();
            first = own.end;
            if !constraints.iter().any(|one| own.contains(one)) {
                continue;
            }
            let label = element.label();
            let known = self.joints.iter().position(|one| one.joint == label);
            let known = known.unwrap_or_else(|| {
                self.joints.push(JointImpulse {
                    joint: label.to_owned(),
                    time,
                    count: 0,
                    largest: Vec::new(),
                    is_followed: true,
                });
                self.joints.len() - 1
            });
            let known = &mut self.joints[known];
            known.count += 1;
            match impulse {
                Some(impulse) => known.grow(sizes(system, (constraints, impulse), &own)),
                None => known.is_followed = false,
            }
        }
    }

    /// Remarks on the impulses.
    pub fn remarks(&self) -> impl Iterator<Item = String> {
        let more = self.joints.len().saturating_sub(MOST_REPORTED);
        let more = (more > 0).then(|| format!("impulses of {more} more joints as well"));
        let reported = self
            .joints
            .iter()
            .take(MOST_REPORTED)
            .map(ToString::to_string);
        reported.chain(more)
    }
}

/// A number with four digits.
fn short_number(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}

impl fmt::Display for JointImpulse {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            joint, time, count, ..
        } = self;
        write!(
            f,
            "the drive of \"{joint}\" jumps in rate at t = {} s",
            rounded(*time)
        )?;
        match *count {
            0 | 1 => {}
            2 => write!(f, " and once more")?,
            _ => write!(f, " and {} more times", count - 1)?,
        }
        let sizes = self.largest.iter();
        let sizes = sizes.map(|(size, unit)| format!("{} {unit} s", short_number(*size)));
        let sizes = sizes.collect::<Vec<_>>().join(" and ");
        write!(f, ": an impulse")?;
        match (sizes.is_empty(), *count) {
            (true, _) => {}
            (false, 1) => write!(f, " of {sizes}")?,
            (false, _) => write!(f, " of up to {sizes}")?,
        }
        if self.is_followed {
            write!(f, "; velocities were set to follow it")
        } else {
            write!(
                f,
                "; no velocities fulfill all constraints there, and the step after it must \
                 determine them"
            )
        }
    }
}

/// Passes a corner with the accepted `states`, the latest first, and notes the impulses, see
/// [`crate::integrator::Dae::renew`].
pub(super) fn pass(
    model: &Model,
    states: &mut [State; 2],
    impulses: &mut Impulses,
    corner: &Corner,
    step: f64,
) -> Renewal {
    let [before, after] = [corner.before, corner.after].map(|time| model.conditions_at(time));
    let system = &model.system;
    // The memory of elements may have changed here, such as a sampled output.
    let earlier = {
        let [latest, previous] = &mut *states;
        std::mem::swap(&mut latest.memory, &mut previous.memory);
        let residual = system.residual(latest, &before);
        std::mem::swap(&mut latest.memory, &mut previous.memory);
        residual
    };
    let state = &mut states[0];
    let jump = jump(system, (state, &earlier), [&before, &after], step);
    let mut renewal = Renewal::Rates;
    match jump {
        None => return Renewal::Unknown,
        Some(Jump::Nothing) => return Renewal::Smooth,
        Some(Jump::Acting) => {}
        Some(Jump::Rates(constraints)) => {
            let found = after_impulse(system, state, &after);
            let impulse = found.as_ref().map(|found| &found.1[..]);
            impulses.add(system, &constraints, impulse, corner.after);
            let Some((moved, _)) = found else {
                return Renewal::Unknown;
            };
            renewal = Renewal::Velocities;
            let kinetic = |state: &State| system.energy(state, &after).kinetic;
            impulses.work += kinetic(&moved) - kinetic(state);
            *state = moved;
        }
    }
    let settled = scalars::settle(system, state, &after, Settling::InMotion);
    if settled.is_err() {
        return Renewal::Unknown;
    }
    match consistent_rates(system, state, &after) {
        Some(found) => {
            *state = found;
            renewal
        }
        None => Renewal::Unknown,
    }
}

fn jumped(element: &dyn Element, jump: PositionJump, corner: &Corner) -> TransientFailure {
    TransientFailure::Jump {
        joint: element.label().to_owned(),
        jump,
        time: corner.after,
    }
}

/// Checks that no driven position jumps at a corner.
pub(super) fn check_corner(
    model: &Model,
    state: &State,
    corner: &Corner,
) -> Result<(), TransientFailure> {
    let [before, after] = [corner.before, corner.after].map(|time| model.conditions_at(time));
    match model.system.position_jump(state, [&before, &after]) {
        None => Ok(()),
        Some((element, jump)) => Err(jumped(element, jump, corner)),
    }
}

/// Checks that no position driven in time alone jumps in a run \[s\].
pub(super) fn check_positions(model: &Model, [from, to]: [f64; 2]) -> Result<(), TransientFailure> {
    for element in model.system.elements() {
        // Scalars are not known ahead.
        if element.multipliers() == 0 || element.senses() {
            continue;
        }
        let mut time = from;
        for _ in 0..LOOKED_AT {
            time = element.next_corner(time);
            if time.is_nan() || time > to {
                break;
            }
            let corner = Corner {
                before: time.next_down(),
                after: time,
            };
            let [before, after] =
                [corner.before, corner.after].map(|time| model.conditions_at(time));
            let jump = element.jump([&before.loading, &after.loading], Scalars::NONE);
            if let Some(jump) = jump {
                return Err(jumped(element, jump, &corner));
            }
        }
    }
    Ok(())
}
