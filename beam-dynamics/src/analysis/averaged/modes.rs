//! The modes of averaged equations: the oscillations, which overdamped motions must not push out of the
//! number that is searched.
//!
//! A motion of the blades oscillates if it does so in axes that turn with them. Values are searched until enough
//! oscillations are among them. Others are slow if they decay by less than a factor `exp(2 pi)` in a
//! revolution, `-Re s < Omega`.

use nalgebra::Complex;

use super::{Air, Averaged, USE_FLOQUET, air_acts, averaged};
use crate::analysis::fewer_modes::why_no_more;
use crate::analysis::frozen::{frozen, is_frozen};
use crate::analysis::multiblade::{Coordinates, Named, Names};
use crate::assembly::{MasslessMotions, Tangent};
use crate::case::{Model, PeriodicSettings, Words};
use crate::model::State;
use crate::modes::{EigenProblem, Eigenpair, MassMatrix, ModeMotion, separate_by};
use crate::solver::LinearSolver;

/// Largest number of values that are searched, as a multiple of the oscillations.
const MOST: usize = 16;
/// Imaginary part, relative to the value, that is round-off of a real one.
const REAL: f64 = 1e-9;
/// Distance of frequencies, relative, of copies of one mode.
const COPY: f64 = 1e-6;

/// A mode of the averaged equations.
#[derive(Debug, Clone)]
pub(in crate::analysis) struct AveragedMode {
    /// The eigenvalue, with the frequency in the fixed frame [1/s].
    pub exponent: Complex<f64>,
    /// Its name.
    pub named: Named,
    /// Whether it decays by less than a factor `exp(2 pi)` in a revolution, or grows.
    pub is_slow: bool,
    /// The motion in multiblade coordinates.
    pub motion: ModeMotion,
}

/// The modes that were found.
pub(in crate::analysis) struct AveragedModes {
    /// The modes: all oscillations up to a frequency, and others.
    pub modes: Vec<AveragedMode>,
    /// The modes without air, at least as many as oscillations; `None` if no air acts.
    pub vacuum: Option<Vec<AveragedMode>>,
    /// This frequency; `None` if the model has no others [rad/s].
    pub complete_to: Option<f64>,
}

/// Modes about the periodic motion that begins with a state, at least `wanted` oscillations if there are
/// so many; or the reason why there are none, with a remedy.
pub(in crate::analysis) fn averaged_modes(
    model: &Model,
    settings: &PeriodicSettings,
    state: &State,
    (wanted, words): (usize, Words),
) -> Result<AveragedModes, [String; 2]> {
    let Averaged {
        model,
        tangent,
        vacuum,
        coordinates,
    } = averaged(model, settings, state, Air::WithAndWithout)?;
    let massless = MasslessMotions::new(&model.system, &tangent);
    let solver = LinearSolver::new(tangent.by_rates.pattern());
    let problem = EigenProblem::new(&solver, &tangent, &massless, 2 * coordinates.blades.len());
    let problem = problem.ok_or_else(|| {
        let remedy = "hold all motions by a stiffness, or choose by = \"Floquet\"";
        let reason = "the averaged equations have a motion without stiffness";
        [reason.to_owned(), remedy.to_owned()]
    })?;
    let problem = problem.with_vacuum(vacuum.as_ref());
    let seen = |tangent: &Tangent| Seen {
        names: Names::new(&model, &coordinates, words),
        mass: MassMatrix::new(&tangent.by_rates, model.system.nodes().len()),
        speed: settings.speed.unwrap_or(0.0).abs(),
    };
    let mut found = searched(&problem, wanted, &seen(&tangent))?;
    if !frozen(
        &tangent.by_unknowns,
        &tangent.by_rates,
        model.system.numbering(),
    )
    .is_empty()
    {
        let is_constant =
            |mode: &AveragedMode| !mode.named.oscillates && is_frozen(mode.exponent.re);
        found.modes.retain(|mode| !is_constant(mode));
    }
    found.vacuum = vacuum.as_ref().and_then(|vacuum| {
        let oscillations = found.modes.iter().filter(|mode| mode.named.oscillates);
        let wanted = oscillations.count().max(wanted);
        without_air((&model, &coordinates), vacuum, wanted, &seen(vacuum))
    });
    Ok(found)
}

/// As many modes without air about the periodic motion that begins with a state, and some beyond them; `None` if no
/// air acts, and without averaged equations.
pub(in crate::analysis) fn modes_without_air(
    model: &Model,
    settings: &PeriodicSettings,
    state: &State,
    (wanted, words): (usize, Words),
) -> Option<Vec<AveragedMode>> {
    let conditions = model.conditions_at(settings.start.from);
    if !air_acts(&model.system, state, &conditions) {
        return None;
    }
    let averaged = averaged(model, settings, state, Air::WithAndWithout).ok()?;
    let vacuum = averaged.vacuum.as_ref()?;
    let Averaged {
        model, coordinates, ..
    } = &averaged;
    let seen = Seen {
        names: Names::new(model, coordinates, words),
        mass: MassMatrix::new(&vacuum.by_rates, model.system.nodes().len()),
        speed: settings.speed.unwrap_or(0.0).abs(),
    };
    without_air((model, coordinates), vacuum, wanted, &seen)
}

/// The modes of the lowest frequencies without air.
fn without_air(
    (model, coordinates): (&Model, &Coordinates),
    vacuum: &Tangent,
    wanted: usize,
    seen: &Seen<'_>,
) -> Option<Vec<AveragedMode>> {
    let massless = MasslessMotions::new(&model.system, vacuum);
    let solver = LinearSolver::new(vacuum.by_rates.pattern());
    let copies = 2 * coordinates.blades.len();
    let problem = EigenProblem::new(&solver, vacuum, &massless, copies)?;
    let mut requested = wanted + copies;
    loop {
        let modes = seen.modes(&problem.structural(requested));
        let oscillations = modes.iter().filter(|mode| mode.named.oscillates).count();
        let is_end = modes.len() < requested || requested >= MOST * wanted;
        if oscillations >= wanted + copies || is_end {
            return Some(modes);
        }
        requested *= 2;
    }
}

/// The lowest modes, with at least `wanted` oscillations if there are so many. Values that no vector confirms
/// are round-off of the infinite ones of constraints, and take places of others.
///
/// # Errors
/// Too few oscillations among the values that are confirmed, and others that are not; with a remedy.
fn searched(
    problem: &EigenProblem<'_>,
    wanted: usize,
    seen: &Seen<'_>,
) -> Result<AveragedModes, [String; 2]> {
    let mut requested = wanted;
    loop {
        let lowest = problem.lowest(requested);
        let is_end = lowest.pairs.len() < requested && lowest.unconfirmed == 0;
        let mut modes = seen.modes(&lowest.pairs);
        let found = modes.iter().filter(|mode| mode.named.oscillates).count();
        if found >= wanted || is_end || requested >= MOST * wanted {
            let last = kept(&mut modes, wanted);
            let real = lowest.real.iter().map(|value| problem.real_pair(*value));
            modes.extend(seen.modes(&real.collect::<Vec<_>>()));
            let is_all = is_end && lowest.is_all && found <= wanted;
            let complete_to = (!is_all).then_some(last);
            if found < wanted && lowest.unconfirmed > 0 {
                let reason = format!(
                    "only {found} of {wanted} oscillations are confirmed: {}",
                    why_no_more(&lowest)
                );
                return Err([reason, USE_FLOQUET.to_owned()]);
            }
            return Ok(AveragedModes {
                modes,
                vacuum: None,
                complete_to,
            });
        }
        requested *= 2;
    }
}

/// Keeps the `count` lowest oscillations with the copies of the last one, and others up to its frequency or that grow;
/// returns this frequency \[rad/s\].
fn kept(modes: &mut Vec<AveragedMode>, count: usize) -> f64 {
    let oscillations = modes.iter().filter(|mode| mode.named.oscillates);
    let mut frequencies: Vec<_> = oscillations.map(|mode| mode.exponent.im).collect();
    frequencies.sort_by(f64::total_cmp);
    let all = modes.iter().map(|mode| mode.exponent.im);
    let highest = all.fold(0.0, f64::max);
    let last = frequencies.get(count.saturating_sub(1));
    let last = last.map_or(highest, |last| last * (1.0 + COPY));
    modes.retain(|mode| mode.exponent.im <= last || mode.exponent.re > 0.0);
    last
}

/// The model in which modes are seen.
struct Seen<'a> {
    names: Names<'a>,
    mass: MassMatrix,
    /// Of the rotor \[rad/s\].
    speed: f64,
}

impl Seen<'_> {
    /// The modes of pairs. Uncoupled blades of an even number have one value in the collective and the differential
    /// pattern: they are separated.
    fn modes(&self, pairs: &[Eigenpair]) -> Vec<AveragedMode> {
        let motions = pairs.iter().map(|pair| ModeMotion::new(pair, &self.mass));
        let mut motions: Vec<_> = motions.collect();
        let value = |pair: &Eigenpair| Complex::new(pair.growth, pair.angular_frequency);
        let values: Vec<_> = pairs.iter().map(value).collect();
        separate_by(&mut motions, &values, |a, b| self.names.form(a, b));
        let both = pairs.iter().zip(motions);
        both.map(|(pair, motion)| self.mode(pair, motion)).collect()
    }

    fn mode(&self, pair: &Eigenpair, motion: ModeMotion) -> AveragedMode {
        let size = pair.growth.hypot(pair.angular_frequency);
        let is_real = pair.angular_frequency.abs() <= REAL * size;
        let frequency = if is_real { 0.0 } else { pair.angular_frequency };
        let exponent = Complex::new(pair.growth, frequency);
        AveragedMode {
            exponent,
            named: self.names.of(&motion, exponent, is_real),
            is_slow: self.speed == 0.0 || pair.growth > -self.speed,
            motion,
        }
    }
}
