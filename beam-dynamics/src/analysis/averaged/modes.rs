//! The modes of averaged equations: the oscillations, which overdamped motions must not push out of the
//! number that is searched.
//!
//! A motion s of the blades with h waves oscillates if it does so in axes that turn with them, where an
//! overdamped one has the frequency zero: `|Im s - h Omega| > 0.2 |Re s|`. Values are searched until enough
//! oscillations are among them. Others are slow if they decay by less than a factor `exp(2 pi)` in a
//! revolution, `-Re s < Omega`.

use nalgebra::Complex;

use super::coordinates::Coordinates;
use super::support::support;
use super::{Averaged, USE_FLOQUET, averaged};
use crate::analysis::fewer_modes::why_no_more;
use crate::assembly::MasslessMotions;
use crate::case::{Model, PeriodicSettings, Words};
use crate::model::{NODE_UNKNOWNS, NamingAxes, State};
use crate::modes::{EigenProblem, Eigenpair, MassMatrix, ModeMotion};
use crate::result::{ModeKind, Whirl};
use crate::solver::LinearSolver;

/// Largest number of values that are searched, as a multiple of the oscillations.
const MOST: usize = 16;
/// Least frequency in the axes of the blades, relative to the growth, of an oscillation.
const OSCILLATES: f64 = 0.2;
/// Imaginary part, relative to the value, that is round-off of a real one.
const REAL: f64 = 1e-9;

/// A mode of the averaged equations.
#[derive(Debug, Clone)]
pub(in crate::analysis) struct AveragedMode {
    /// The eigenvalue, with the frequency in the fixed frame [1/s].
    pub exponent: Complex<f64>,
    /// Whether it oscillates in axes that turn with the blades.
    pub oscillates: bool,
    /// Whether it decays by less than a factor `exp(2 pi)` in a revolution, or grows.
    pub is_slow: bool,
    /// The motion in multiblade coordinates.
    pub motion: ModeMotion,
    /// The name without the number.
    pub name: String,
    /// The pattern of the blades; `None` where they rest, and if other parts have most of the energy.
    pub whirl: Option<Whirl>,
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
    let problem = EigenProblem::new(&solver, &tangent, &massless, 2 * coordinates.count());
    let problem = problem.ok_or_else(|| {
        let remedy = "hold all motions by a stiffness, or choose by = \"Floquet\"";
        let reason = "the averaged equations have a motion without stiffness";
        [reason.to_owned(), remedy.to_owned()]
    })?;
    let seen = Seen {
        model: &model,
        coordinates: &coordinates,
        axes: naming(&model, &coordinates),
        mass: MassMatrix::new(&tangent.by_rates, nodes),
        speed: settings.speed.unwrap_or(0.0).abs(),
        words,
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
        let found = modes.iter().filter(|mode| mode.oscillates).count();
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
    model: &'a Model,
    coordinates: &'a Coordinates,
    axes: Vec<NamingAxes>,
    mass: MassMatrix,
    /// Of the rotor \[rad/s\].
    speed: f64,
    words: Words,
}

impl Seen<'_> {
    fn mode(&self, pair: &Eigenpair) -> AveragedMode {
        let motion = ModeMotion::new(pair, &self.mass);
        let size = pair.growth.hypot(pair.angular_frequency);
        let is_real = pair.angular_frequency.abs() <= REAL * size;
        let tower = ModeKind::of_tower(motion.of_tower(&self.axes));
        let tower = tower.map(|kind| kind.word().to_owned());
        let support = tower.or_else(|| support(self.model, self.coordinates, &motion));
        let whirl = match support {
            Some(_) => None,
            None => whirl(&motion, self.coordinates),
        };
        let of_blades = pair.angular_frequency - waves(whirl) * self.speed;
        let oscillates = !is_real && of_blades.abs() > OSCILLATES * pair.growth.abs();
        let kind = || ModeKind::of(&motion.shares(&self.axes)).word_in(self.words);
        let own = support.unwrap_or_else(|| kind().to_owned());
        AveragedMode {
            exponent: Complex::new(
                pair.growth,
                if is_real { 0.0 } else { pair.angular_frequency },
            ),
            oscillates,
            is_slow: self.speed == 0.0 || pair.growth > -self.speed,
            name: match (is_real, oscillates) {
                (true, _) => format!("aperiodic {own}"),
                (false, true) => own,
                (false, false) => format!("overdamped {own}"),
            },
            whirl,
            motion,
        }
    }
}

/// Waves that turn with the blades: none of a differential pattern, whose coordinate does not turn.
fn waves(whirl: Option<Whirl>) -> f64 {
    let turning = whirl.filter(|own| 2 * own.harmonic.unsigned_abs() as usize != own.blades);
    turning.map_or(0.0, |own| f64::from(own.harmonic))
}

/// Axes for names: a blade has the axes of its coordinates.
fn naming(model: &Model, coordinates: &Coordinates) -> Vec<NamingAxes> {
    let mut axes = model.naming.clone();
    for (node, axes) in axes.iter_mut().enumerate() {
        let slot = &coordinates.slots[coordinates.slot_of[NODE_UNKNOWNS * node]];
        if let Some((blade, _)) = slot.of_blade {
            let turn = coordinates.blade(blade).transpose();
            axes.blade = turn * axes.blade;
            axes.section = turn * axes.section;
        }
    }
    axes
}

/// The pattern with most of the energy of the blades: of the motion exp(i w t) the coordinates
/// `(1, -i)` of cosine and sine run with the rotation.
fn whirl(motion: &ModeMotion, coordinates: &Coordinates) -> Option<Whirl> {
    let [q, p] = motion.parts();
    let n = coordinates.count();
    let waves = (n - 1) / 2;
    let mut energies = vec![0.0; n];
    for family in &coordinates.families {
        let firsts: Vec<_> = family
            .iter()
            .map(|slot| coordinates.slots[*slot].first)
            .collect();
        let is_motion = |first: &usize| {
            first / NODE_UNKNOWNS < q.len() / 6 && first % NODE_UNKNOWNS < NODE_UNKNOWNS / 2
        };
        if !firsts.iter().all(is_motion) {
            continue;
        }
        let places = firsts
            .iter()
            .map(|first| 6 * (first / NODE_UNKNOWNS) + first % NODE_UNKNOWNS);
        let places: Vec<_> = places.collect();
        for along in 0..3 {
            let at = |j: usize| (q[places[j] + along], p[places[j] + along]);
            let energy = |(q, p): (Complex<f64>, Complex<f64>)| (q.conj() * p).re;
            energies[0] += energy(at(0));
            for wave in 0..waves {
                let [cos, sin] = [at(1 + 2 * wave), at(2 + 2 * wave)];
                for (place, sign) in [(1 + 2 * wave, 1.0), (2 + 2 * wave, -1.0)] {
                    let i = Complex::new(0.0, sign);
                    energies[place] += 0.5 * energy((cos.0 + i * sin.0, cos.1 + i * sin.1));
                }
            }
            if n.is_multiple_of(2) {
                energies[n - 1] += energy(at(n - 1));
            }
        }
    }
    let total: f64 = energies.iter().sum();
    let place = (0..n).max_by(|a, b| energies[*a].total_cmp(&energies[*b]))?;
    let harmonic = match place {
        0 => 0,
        _ if n.is_multiple_of(2) && place == n - 1 => n as i32 / 2,
        place if place % 2 == 1 => (place as i32 + 1) / 2,
        place => -(place as i32) / 2,
    };
    (total > 0.0).then(|| Whirl {
        harmonic,
        blades: n,
        share: energies[place] / total,
    })
}
