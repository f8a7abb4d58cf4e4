//! The modes of averaged equations: the oscillations, which overdamped motions must not push out of the
//! number that is searched.
//!
//! A motion of the blades oscillates if it does so in axes that turn with them. Values are searched until enough
//! oscillations are among them. Others are slow if they decay by less than a factor `exp(2 pi)` in a
//! revolution, `-Re s < Omega`.

use nalgebra::Complex;

use super::{Averaged, USE_FLOQUET, averaged};
use crate::analysis::fewer_modes::why_no_more;
use crate::analysis::multiblade::{Named, Names};
use crate::assembly::MasslessMotions;
use crate::case::{Model, PeriodicSettings, Words};
use crate::model::State;
use crate::modes::{EigenProblem, Eigenpair, MassMatrix, ModeMotion};
use crate::solver::LinearSolver;

/// Largest number of values that are searched, as a multiple of the oscillations.
const MOST: usize = 16;
/// Imaginary part, relative to the value, that is round-off of a real one.
const REAL: f64 = 1e-9;

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
        coordinates,
    } = averaged(model, settings, state)?;
    let nodes = model.system.nodes().len();
    let massless = MasslessMotions::new(&model.system, &tangent);
    let solver = LinearSolver::new(tangent.by_rates.pattern());
    let problem = EigenProblem::new(&solver, &tangent, &massless, 2 * coordinates.blades.len());
    let problem = problem.ok_or_else(|| {
        let remedy = "hold all motions by a stiffness, or choose by = \"Floquet\"";
        let reason = "the averaged equations have a motion without stiffness";
        [reason.to_owned(), remedy.to_owned()]
    })?;
    let seen = Seen {
        names: Names::new(&model, &coordinates, words),
        mass: MassMatrix::new(&tangent.by_rates, nodes),
        speed: settings.speed.unwrap_or(0.0).abs(),
    };
    searched(&problem, wanted, &seen)
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
        let pairs = lowest.pairs.iter();
        let mut modes: Vec<_> = pairs.map(|pair| seen.mode(pair)).collect();
        let found = modes.iter().filter(|mode| mode.named.oscillates).count();
        if found >= wanted || is_end || requested >= MOST * wanted {
            let all = modes.iter().map(|mode| mode.exponent.im);
            let last = all.fold(0.0, f64::max);
            let real = lowest.real.iter().map(|value| problem.real_pair(*value));
            modes.extend(real.map(|pair| seen.mode(&pair)));
            let is_all = is_end && lowest.is_all;
            let complete_to = (!is_all).then_some(last);
            if found < wanted && lowest.unconfirmed > 0 {
                let reason = format!(
                    "only {found} of {wanted} oscillations are confirmed: {}",
                    why_no_more(&lowest)
                );
                return Err([reason, USE_FLOQUET.to_owned()]);
            }
            return Ok(AveragedModes { modes, complete_to });
        }
        requested *= 2;
    }
}

/// The model in which modes are seen.
struct Seen<'a> {
    names: Names<'a>,
    mass: MassMatrix,
    /// Of the rotor \[rad/s\].
    speed: f64,
}

impl Seen<'_> {
    fn mode(&self, pair: &Eigenpair) -> AveragedMode {
        let motion = ModeMotion::new(pair, &self.mass);
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
