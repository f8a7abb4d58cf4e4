//! Roots by the eigenvalues about the equilibrium of the turning frame.

use std::f64::consts::TAU;

use super::branches::Found;
use super::{Failed, ROUND_OFF, Source, nothing};
use crate::analysis::around_the_axis::{copies, rotor};
use crate::analysis::linearized::{Linearized, describe, point_of};
use crate::analysis::modes::Failure;
use crate::analysis::stability::names::{named, size};
use crate::analysis::steady::{Equilibrium, equilibrium};
use crate::analysis::trim::{fits, small_motions};
use crate::case::{Model, Words};
use crate::input::Input;
use crate::modes::{Eigenpair, ModeMotion, Rotor};
use crate::result::{BoundaryKind, ModePoint, StabilityRoot, Whirl};
use crate::solver::LinearSolver;

/// Relative difference of the magnitudes of copies of one root.
const COPY: f64 = 1e-6;

impl Source<'_> {
    /// The roots at a value, from the modes that are known there or are found now.
    pub(super) fn of_modes(&mut self, at: f64) -> Result<Vec<StabilityRoot>, Failed> {
        if !self.branches.has(at) {
            self.find_modes(at)?;
            self.complete_from_nearest(at);
        }
        let (input, steady) = self.about(at)?;
        self.note_operation(at, (&input, &steady.state), &steady.conditions);
        self.is_double |= input.model.around_the_axis(true).len() == 2;
        let found = self.branches.at(at);
        let found = found.ok_or_else(|| nothing("there are no modes"))?;
        Ok(self.roots_of(&input, &steady, found))
    }

    /// Finds the modes at a value without the ones of other values.
    pub(super) fn find_modes(&mut self, at: f64) -> Result<(), Failed> {
        let (input, steady) = self.about(at)?;
        let settings = input
            .modes
            .as_ref()
            .ok_or_else(|| nothing("[modes] is missing"))?;
        let count = self.count_of_modes(settings.count);
        let linearized = Linearized::new(&input.model, &steady);
        let solver = LinearSolver::new(input.model.system.pattern());
        let problem = linearized.problem(&solver).ok_or_else(|| {
            let failure = Failure::Singular {
                speed: speed(&input),
            };
            let remedy = "hold the motion by a stiffness, or choose other values of the parameter";
            [failure.to_string(), remedy.to_owned()]
        })?;
        let lowest = problem.lowest(count + 2 * copies(&input.model) - 1);
        let of_real = |value: &f64| Eigenpair {
            growth: *value,
            angular_frequency: 0.0,
            ..problem.real_pair(*value)
        };
        let real = lowest.real.iter().map(of_real).collect();
        self.branches
            .add(at, Found::new(lowest.pairs, real, lowest.unconfirmed));
        Ok(())
    }

    /// The model at a value with its equilibrium, from the nearest known one.
    pub(super) fn about(&mut self, at: f64) -> Result<(Input, Equilibrium), Failed> {
        let Some(trim) = self.trim else {
            let input = self.input(at)?;
            let steady = self.steady(at, &input)?;
            return Ok((input, steady));
        };
        let (input, _) = self.trimmed(at, trim)?;
        let (conditions, _) = small_motions(&input).ok_or_else(|| nothing("[trim] is missing"))?;
        let known = self.known_at(at);
        let state = known.map(|known| known.state.clone());
        let steady = state.map(|state| Equilibrium {
            state,
            conditions,
            iterations: 0,
            residual: 0.0,
        });
        let steady = steady.ok_or_else(|| nothing("the trim has no state"))?;
        Ok((input, steady))
    }

    /// The equilibrium, from the nearest known one.
    fn steady(&mut self, at: f64, input: &Input) -> Result<Equilibrium, Failed> {
        let model = &input.model;
        let conditions = model.conditions(speed(input), 1.0, 1.0);
        let rest = model.system.rest();
        let nothing = model.conditions(0.0, 1.0, 1.0);
        let near = self.nearest(at).map(|near| &near.state);
        let near = near.filter(|state| fits(state, model));
        let solver = LinearSolver::new(model.system.pattern());
        let from = |known, state| equilibrium(model, &solver, (known, state), &conditions);
        let found = near.map(|state| from(&conditions, state));
        let found = match found {
            Some(Ok(found)) => Ok(found),
            _ => from(&nothing, &rest),
        };
        let steady = found.map_err(|failure| {
            let remedy = "choose values of the parameter at which the model has an equilibrium";
            [failure.to_string(), remedy.to_owned()]
        })?;
        self.keep(at, &steady.state, Vec::new());
        Ok(steady)
    }

    /// Modes as roots.
    fn roots_of(&self, input: &Input, steady: &Equilibrium, found: &Found) -> Vec<StabilityRoot> {
        let model = &input.model;
        let speed = speed(input);
        let words = input.words();
        let rotor = rotor(model, speed > 0.0);
        let linearized = Linearized::new(model, steady);
        let motions = |pairs: &[Eigenpair], number: fn(&Eigenpair) -> f64| {
            linearized.motions(pairs, number, rotor.as_ref())
        };
        let oscillations = motions(&found.oscillations, |pair| pair.angular_frequency);
        let damped = motions(&found.overdamped, |pair| pair.growth.abs());
        let real = found
            .real
            .iter()
            .map(|pair| linearized.motion(pair))
            .collect();
        let kinds: [(&[Eigenpair], Vec<ModeMotion>, Root); 3] = [
            (&found.oscillations, oscillations, root),
            (&found.overdamped, damped, overdamped),
            (&found.real, real, root),
        ];
        let all = kinds.into_iter().flat_map(|(pairs, motions, root)| {
            let pairs = pairs.iter().zip(motions);
            pairs.map(move |(pair, motion)| (pair, motion, root))
        });
        let seen = Seen {
            of: (model, rotor.as_ref()),
            speed,
            words,
        };
        let roots = all.map(|(pair, motion, root)| seen.root((pair, &motion), root));
        let known = found.oscillations.iter().chain(&found.overdamped);
        let vacuum = vacuum(&linearized, known, &seen);
        let has_states = !model.system.scalars().is_empty();
        let mut roots = named(roots.collect(), vacuum.map(|modes| (modes, has_states)));
        let requested = input.modes.as_ref().map_or(0, |own| own.count);
        let count = self.count_of_modes(requested) + copies(model) - 1;
        keep_lowest(&mut roots, count);
        roots
    }

    /// Number of modes, without copies of the last one, for the number that `[modes]` requests.
    fn count_of_modes(&self, requested: usize) -> usize {
        self.settings.count.unwrap_or(0).max(requested)
    }
}

/// Keeps the `count` oscillations of lowest magnitude with the copies of the last one, the ones that grow, and the
/// motions that do not oscillate. Others were found for names only, which depend on the modes above.
fn keep_lowest(roots: &mut Vec<StabilityRoot>, count: usize) {
    let oscillations = roots.iter().filter(|root| root.in_blades > 0.0);
    let mut sizes: Vec<_> = oscillations.map(size).collect();
    sizes.sort_by(f64::total_cmp);
    if let Some(last) = sizes.get(count.saturating_sub(1)) {
        let largest = last * (1.0 + COPY);
        roots.retain(|root| root.in_blades == 0.0 || root.growth() > 0.0 || size(root) <= largest);
    }
}

/// The model in which modes are seen.
struct Seen<'a> {
    of: (&'a Model, Option<&'a Rotor>),
    speed: f64,
    words: Words,
}

impl Seen<'_> {
    fn root(&self, (pair, motion): (&Eigenpair, &ModeMotion), root: Root) -> StabilityRoot {
        let mut point = point_of(pair.growth, pair.angular_frequency);
        describe(self.of, motion, &mut point);
        root((&point, motion), self.speed, self.words)
    }
}

/// The modes without air at the same state, as many as there are `known` ones with air, and some beyond them;
/// `None` if no air acts.
fn vacuum<'a>(
    linearized: &'a Linearized<'a>,
    known: impl Iterator<Item = &'a Eigenpair>,
    seen: &Seen<'_>,
) -> Option<Vec<StabilityRoot>> {
    let alone = linearized.without_air()?;
    let sizes: Vec<_> = known
        .map(|pair| pair.growth.hypot(pair.angular_frequency))
        .filter(|size| *size > 0.0)
        .collect();
    let least = sizes.iter().copied().fold(f64::INFINITY, f64::min);
    let solver = LinearSolver::new(seen.of.0.system.pattern());
    let problem = alone.problem_near(&solver, least)?;
    let pairs = problem.structural(sizes.len() + copies(seen.of.0));
    let motions = alone.motions(&pairs, |pair| pair.angular_frequency, seen.of.1);
    let both = pairs.iter().zip(&motions);
    Some(both.map(|both| seen.root(both, root)).collect())
}

/// A root of a mode, by the speed of the rotor \[rad/s\].
type Root = fn((&ModePoint, &ModeMotion), f64, Words) -> StabilityRoot;

/// Speed of the modes of a file \[rad/s\].
fn speed(input: &Input) -> f64 {
    let settings = input.modes.as_ref();
    let first = settings.and_then(|own| own.speeds.first().copied());
    first.unwrap_or(0.0)
}

/// A mode of the turning frame, as seen from the fixed frame.
fn root((point, motion): (&ModePoint, &ModeMotion), speed: f64, words: Words) -> StabilityRoot {
    let whirl = point.whirl.filter(Whirl::is_pure);
    let seen = whirl.map_or(point.frequency, |whirl| {
        whirl.in_fixed_system(point.frequency, speed / TAU).0
    });
    let is_real = point.frequency == 0.0;
    let frequency = if is_real { 0.0 } else { TAU * seen };
    let doubt = match is_real {
        true => 0.0,
        false => ROUND_OFF * point.growth.hypot(TAU * point.frequency),
    };
    StabilityRoot {
        doubt,
        ..described((point, motion), frequency, words)
    }
}

/// An overdamped mode: of blades that move around the rotor it turns with them in the fixed frame.
fn overdamped(
    (point, motion): (&ModePoint, &ModeMotion),
    speed: f64,
    words: Words,
) -> StabilityRoot {
    let whirl = point.whirl.filter(Whirl::is_pure);
    let seen = whirl.map_or(0.0, |whirl| whirl.in_fixed_system(0.0, speed / TAU).0);
    StabilityRoot {
        is_overdamped: true,
        ..described((point, motion), TAU * seen, words)
    }
}

/// A mode of a frequency \[rad/s\] in the fixed frame.
fn described(
    (point, motion): (&ModePoint, &ModeMotion),
    frequency: f64,
    words: Words,
) -> StabilityRoot {
    let whirl = point.whirl.filter(Whirl::is_pure);
    let pattern = whirl.filter(|whirl| whirl.blades > 0 || whirl.harmonic != 0);
    let pattern = pattern.map_or_else(String::new, |w| format!(" {}", w.word_in(words)));
    StabilityRoot {
        kind: if frequency == 0.0 {
            BoundaryKind::Divergence
        } else {
            BoundaryKind::Flutter
        },
        name: point.main_kind().word_in(words).to_owned(),
        in_blades: TAU * point.frequency,
        pattern: Some(pattern),
        waves: whirl.filter(|w| w.blades > 0).map(|w| w.harmonic),
        blades: point.whirl.map(|w| w.blades).filter(|blades| *blades > 0),
        shape: motion.parts().map(<[_]>::to_vec),
        ..StabilityRoot::new(nalgebra::Complex::new(point.growth, frequency))
    }
}
