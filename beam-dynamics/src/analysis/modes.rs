//! Modes over rotor speed: equilibrium, linearization, eigenvalues, names.

use std::collections::BTreeSet;
use std::f64::consts::TAU;
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::iter::{IntoParallelRefIterator, ParallelExtend, ParallelIterator};

use crate::case::{Model, ModesSettings};
use crate::model::State;
use crate::modes::{EigenProblem, Eigenpair, Lowest, ModeMotion, Rotor};
use crate::result::{DecayingMotion, EquilibriumReport, FrequencyTable};
use crate::solver::LinearSolver;

use super::around_the_axis::{copies, left_out, rotor};
use super::branches::Branches;
use super::deformation::{deformation, folded};
use super::fewer_modes::why_no_more;
use super::first_order::first_order;
use super::growing;
use super::linearized::{self, Linearized, point_of};
use super::linking::{Mode, direct_links};
use super::modal_damping;
use super::operation::Operation;
use super::stall::air_at;
use super::steady::{Equilibrium, NoEquilibrium, equilibrium, rpm};

/// Modes computed beyond those reported, so that a mode that rises out of the list
/// at one speed is still followed to the next.
const SPARE: usize = 6;
/// Assurance below which a step in speed is halved to follow the modes.
const FOLLOWED: f64 = 0.8;
/// Relative residual above which a loss of digits is reported: frequencies are then wrong in
/// about the fifth digit.
const TRUSTED: f64 = 1e-5;
/// Halvings of a step in speed for following modes.
const HALVINGS: usize = 5;

/// Why an analysis stopped before its end.
#[derive(Debug, Clone, thiserror::Error)]
pub enum Failure {
    /// No equilibrium at some speed.
    #[error(transparent)]
    Equilibrium(#[from] Box<NoEquilibrium>),
    /// The linearized system cannot be inverted.
    #[error(
        "the model has a motion without stiffness at {}: its frequency is zero",
        rpm(*speed)
    )]
    Singular {
        /// Speed of rotation [rad/s].
        speed: f64,
    },
}

/// The modes of all speeds reached, and the reason for an early end.
#[derive(Debug)]
pub struct ModesOutcome {
    /// Frequencies at the speeds that were reached.
    pub table: FrequencyTable,
    /// Why the remaining speeds are missing.
    pub failure: Option<Failure>,
}

/// Modes at one speed.
struct Modes {
    speed: f64,
    state: State,
    /// Modes to report: of a free model the rigid ones beside the requested ones.
    count: usize,
    found: Vec<Mode>,
    /// Real eigenvalues that were found.
    real: Vec<Mode>,
    /// Remarks on oscillations that grow.
    growing: Vec<String>,
    /// The reason for fewer modes than requested.
    why_no_more: String,
    /// Largest residual of the eigenpairs and of the equilibrium, relative.
    residual: f64,
}

/// Called with the progress.
type Watch<'a> = &'a (dyn Fn(ModesProgress) + Sync);

/// A model and the settings of its modes.
#[derive(Clone, Copy)]
struct Case<'a> {
    model: &'a Model,
    settings: &'a ModesSettings,
    rotor: Option<&'a Rotor>,
    /// Whether the tangent is symmetric in the undeformed model.
    is_symmetric: bool,
    watch: Watch<'a>,
}

impl Case<'_> {
    /// Reports the progress.
    fn note(&self, equilibria: usize, solved: usize) {
        (self.watch)(ModesProgress {
            equilibria,
            solved,
            all: self.settings.speeds.len(),
        });
    }

    /// Adds the shares of the energy and the kind of motion of a mode.
    fn describe(&self, mode: &mut Mode) {
        let of = (self.model, self.rotor);
        linearized::describe(of, &mode.motion, &mut mode.point);
    }
}

/// Progress of the modes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ModesProgress {
    /// Speeds whose equilibrium is known.
    pub equilibria: usize,
    /// Speeds whose modes are known.
    pub solved: usize,
    /// All speeds.
    pub all: usize,
}

/// Steady equilibrium and modes at each speed of `settings`.
pub fn modes(model: &Model, settings: &ModesSettings) -> ModesOutcome {
    modes_watched(model, settings, &|_| {})
}

/// As [`modes`]; `watch` is called after each equilibrium and each set of modes, of which several
/// are found in parallel.
pub fn modes_watched(model: &Model, settings: &ModesSettings, watch: Watch<'_>) -> ModesOutcome {
    let turns = settings.speeds.iter().any(|speed| *speed > 0.0);
    let rotor = rotor(model, turns);
    let case = &Case {
        model,
        settings,
        rotor: rotor.as_ref(),
        is_symmetric: growing::is_symmetric_at_rest(&model.system),
        watch,
    };
    let mut branches = Branches::default();
    let mut table = FrequencyTable {
        name: model.name.clone(),
        speeds: Vec::new(),
        branches: Vec::new(),
        equilibria: Vec::new(),
        decaying: Vec::new(),
        remarks: Vec::new(),
        style: settings.style.clone(),
        is_single_blade: model.blades.len() == 1,
        blade_files: blade_files(model),
    };
    let failure = run(case, &mut branches, &mut table).err();
    table.branches = branches.into_table(&table.speeds, settings);
    let unknown = modal_damping::give(&settings.damping, &mut table.branches);
    table.remarks.extend(unknown);
    table.remarks.extend(left_out(&table, &model.arms));
    ModesOutcome { table, failure }
}

/// The files of the blades, each once.
fn blade_files(model: &Model) -> Vec<String> {
    let all = model.blades.iter().filter_map(|blade| blade.file.clone());
    let distinct: BTreeSet<String> = all.collect();
    distinct.into_iter().collect()
}

/// Equilibria one after the other, each from the last; their modes, which take most of
/// the time, side by side; then the modes are followed from speed to speed.
fn run(
    case: &Case<'_>,
    branches: &mut Branches,
    table: &mut FrequencyTable,
) -> Result<(), Failure> {
    let solver = LinearSolver::new(case.model.system.pattern());
    let (equilibria, failure) = equilibria(case, &solver);
    // The first chooses pivots that the others share.
    let (first, others) = equilibria.split_at(1.min(equilibria.len()));
    let solved = AtomicUsize::new(0);
    let at = |solver: &LinearSolver, (speed, steady): &(f64, Equilibrium)| {
        let found = at_equilibrium(case, solver, *speed, steady);
        let solved = 1 + solved.fetch_add(1, Ordering::Relaxed);
        case.note(equilibria.len(), solved);
        found
    };
    let mut found: Vec<_> = first.iter().map(|at_first| at(&solver, at_first)).collect();
    found.par_extend(others.par_iter().map(|other| at(&solver.clone(), other)));
    let mut last: Option<Modes> = None;
    let mut operation = Operation::default();
    for ((speed, steady), found) in equilibria.iter().zip(found) {
        let mut now = found?;
        let links = match &last {
            Some(before) => Some(links(case, &solver, before, &mut now, HALVINGS)?),
            None => {
                now.found.iter_mut().for_each(|mode| case.describe(mode));
                None
            }
        };
        let with_shapes = case.settings.shapes.contains(speed);
        let found: Vec<_> = now.found.iter().map(|m| (&m.point, &m.motion)).collect();
        branches.add(&found, links.as_deref(), with_shapes);
        let air = air_at(&case.model.system, &steady.state, &steady.conditions);
        operation.add(&rpm(*speed), &air, case.model.words);
        table.speeds.push(*speed);
        table.equilibria.push(report(steady));
        table.decaying.push(decaying(case, &mut now));
        table.remarks.extend(remarks(case, &now, last.is_none()));
        last = Some(now);
    }
    table.remarks.extend(operation.remarks());
    let fastest = equilibria.last().map(|(speed, steady)| {
        let conditions = case.model.conditions(*speed, 1.0, 1.0);
        let sections = case
            .model
            .system
            .observe(&steady.state, &conditions)
            .sections;
        let when = format!("at {}", rpm(*speed));
        let [bent, strained] = deformation(&sections, &when);
        [bent, strained, first_order(&sections, &when)]
    });
    table
        .remarks
        .extend(fastest.into_iter().flatten().flatten());
    failure.map_or(Ok(()), Err)
}

/// The decaying motions among the real values, slow to fast, up to the magnitude of the highest of
/// the modes: beyond it they are not complete.
fn decaying(case: &Case<'_>, modes: &mut Modes) -> Vec<DecayingMotion> {
    let listed = modes.found.iter().take(modes.count);
    let sizes = listed.map(|m| m.point.growth.hypot(TAU * m.point.frequency));
    let fastest = sizes.fold(0.0, f64::max);
    let own = modes.real.iter_mut();
    let own = own.filter(|mode| mode.point.growth < 0.0 && -mode.point.growth <= fastest);
    let motion = |mode: &mut Mode| {
        case.describe(mode);
        DecayingMotion {
            growth: mode.point.growth,
            kind: mode.point.kind(),
        }
    };
    let mut found: Vec<_> = own.map(motion).collect();
    found.sort_by(|a, b| b.growth.total_cmp(&a.growth));
    found.truncate(modes.count);
    found
}

/// Equilibria at the speeds up to the first that has none, and why that has none.
fn equilibria(
    case: &Case<'_>,
    solver: &LinearSolver,
) -> (Vec<(f64, Equilibrium)>, Option<Failure>) {
    let mut found: Vec<(f64, Equilibrium)> = Vec::with_capacity(case.settings.speeds.len());
    for &speed in &case.settings.speeds {
        let rest = (0.0, case.model.system.rest());
        let from = found
            .last()
            .map_or(rest, |(speed, steady)| (*speed, steady.state.clone()));
        match steady(case, solver, (from.0, &from.1), speed) {
            Ok(steady) => {
                found.push((speed, steady));
                case.note(found.len(), 0);
            }
            Err(problem) => return (found, Some(problem.into())),
        }
    }
    (found, None)
}

/// The equilibrium at a speed, from a state known at another.
fn steady(
    case: &Case<'_>,
    solver: &LinearSolver,
    from: (f64, &State),
    speed: f64,
) -> Result<Equilibrium, Box<NoEquilibrium>> {
    let [there, here] = [from.0, speed].map(|speed| case.model.conditions(speed, 1.0, 1.0));
    equilibrium(case.model, solver, (&there, from.1), &here)
}

fn report(steady: &Equilibrium) -> EquilibriumReport {
    EquilibriumReport {
        iterations: steady.iterations,
        residual: steady.residual,
        positions: steady
            .state
            .nodes
            .iter()
            .map(|node| node.position.into())
            .collect(),
        rotations: steady
            .state
            .nodes
            .iter()
            .map(|node| node.rotation)
            .collect(),
    }
}

/// Remarks on the modes at one speed.
fn remarks(case: &Case<'_>, modes: &Modes, is_first: bool) -> Vec<String> {
    let at = format!("at {}", rpm(modes.speed));
    let mut found = Vec::new();
    if let Some((node, angle)) = folded(case.model, modes.speed, &modes.state) {
        found.push(format!(
            "{at} node \"{node}\" has turned by {angle:.0} deg: the model is folded, and another \
             equilibrium may be the one that is sought"
        ));
    }
    if is_first && modes.found.len() < modes.count {
        let why = &modes.why_no_more;
        let rigid = modes.count - case.settings.count;
        let (beside, elastic) = match rigid {
            0 => (String::new(), ""),
            _ => (format!(" beside the {rigid} rigid ones"), "elastic "),
        };
        found.push(format!(
            "{} of {} {elastic}modes were found{beside}: {why}",
            modes.found.len().saturating_sub(rigid),
            case.settings.count
        ));
    }
    let mut real = modes.real.iter().map(|own| own.point.growth);
    if let Some(worst) = real.rfind(|growth| *growth > 0.0) {
        found.push(format!(
            "{at} the equilibrium is unstable: a motion grows with {worst:.3e} 1/s"
        ));
    }
    found.extend(modes.growing.iter().cloned());
    if modes.residual > TRUSTED || modes.residual.is_nan() {
        found.push(format!(
            "{at} digits are lost (relative residual {:.1e}): stiffnesses, masses or lengths \
             of very different size meet in the model",
            modes.residual
        ));
    }
    found
}

/// Linearizes at an equilibrium and finds the lowest modes.
fn at_equilibrium(
    case: &Case<'_>,
    solver: &LinearSolver,
    speed: f64,
    steady: &Equilibrium,
) -> Result<Modes, Failure> {
    let linearized = Linearized::new(case.model, steady);
    let problem = linearized.problem(solver);
    let problem = problem.ok_or(Failure::Singular { speed })?;
    // Copies are separated together, and some of them alone cannot be followed to another speed.
    let of_copies = copies(case.model) - 1;
    let spare = match case.settings.speeds.len() {
        0 | 1 => of_copies,
        _ => SPARE.max(of_copies),
    };
    let lowest = lowest(&problem, (case.settings.count, spare), case.settings.free);
    let rigid = lowest.pairs.iter().filter(|pair| is_rigid(pair)).count();
    let count = case.settings.count + if case.settings.free { rigid } else { 0 };
    let Lowest { pairs, real, .. } = &lowest;
    let residual = pairs.iter().map(|pair| pair.residual);
    // At rest all terms of the equilibrium are round-off.
    let steady_residual = if speed == 0.0 { 0.0 } else { steady.residual };
    let motions = linearized.motions(pairs, |pair| pair.angular_frequency, case.rotor);
    let mode = |(pair, motion): (&Eigenpair, ModeMotion)| Mode {
        motion,
        point: point_of(pair.growth, pair.angular_frequency),
        slope: None,
    };
    let of_real = |value: &f64| Mode {
        motion: linearized.motion(&problem.real_pair(*value)),
        point: point_of(*value, 0.0),
        slope: None,
    };
    let own = &pairs[..pairs.len().min(count)];
    let at = format!("at {}", rpm(speed));
    Ok(Modes {
        growing: growing::remarks(&problem, own, case.is_symmetric, &at),
        speed,
        state: steady.state.clone(),
        count,
        found: pairs.iter().zip(motions).map(mode).collect(),
        why_no_more: why_no_more(&lowest),
        real: real.iter().map(of_real).collect(),
        residual: residual.fold(steady_residual, larger),
    })
}

/// The lowest `count` modes and `spare` ones; of a free model beside its rigid ones.
fn lowest(problem: &EigenProblem<'_>, (count, spare): (usize, usize), free: bool) -> Lowest {
    let mut requested = count + spare;
    loop {
        let found = problem.lowest(requested);
        let rigid = found.pairs.iter().filter(|pair| is_rigid(pair)).count();
        if !free || rigid + count + spare <= requested || found.pairs.len() < requested {
            return found;
        }
        requested = rigid + count + spare;
    }
}

/// Whether the motion has no stiffness.
fn is_rigid(pair: &Eigenpair) -> bool {
    pair.angular_frequency == 0.0
}

/// The larger of two, or not a number when one of them is none.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

/// For each mode of `before`, its continuation in `now` and the least assurance on
/// the way. Where some mode changes its shape too much in one step, the speed half
/// way is computed as well.
fn links(
    case: &Case<'_>,
    solver: &LinearSolver,
    before: &Modes,
    now: &mut Modes,
    halvings: usize,
) -> Result<Vec<Option<(usize, f64)>>, Failure> {
    let from = (before.speed, &before.found[..]);
    let to = (now.speed, &mut now.found[..]);
    let direct = direct_links(from, to, |mode| case.describe(mode));
    let reported = direct.iter().take(case.settings.count);
    let certain = reported
        .clone()
        .all(|link| link.is_some_and(|(_, mac)| mac >= FOLLOWED));
    if certain || halvings == 0 {
        return Ok(direct);
    }
    let middle = 0.5 * (before.speed + now.speed);
    let from = (before.speed, &before.state);
    let steady = steady(case, solver, from, middle)?;
    let mut between = at_equilibrium(case, solver, middle, &steady)?;
    let first = links(case, solver, before, &mut between, halvings - 1)?;
    let second = links(case, solver, &between, now, halvings - 1)?;
    let chained = first.into_iter().map(|link| {
        let (middle, mac) = link?;
        let (end, other) = second[middle]?;
        Some((end, mac.min(other)))
    });
    Ok(chained.collect())
}
