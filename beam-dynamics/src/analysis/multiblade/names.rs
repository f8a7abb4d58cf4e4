//! Names of modes of rotors in multiblade coordinates: the kind of the motion, or the part outside the
//! blades that moves most, and the pattern of the blades.
//!
//! The pattern is the one in axes that turn with the blades, as in modes of a turning frame. A mode s of the
//! fixed frame with h waves has there the frequency
//!
//! ```text
//! w = Im s - h Omega                                                                          (D-350)
//! ```
//!
//! If w < 0, its conjugate has the positive frequency -w and -h waves, which name it: a lag mode of less
//! than one per revolution is regressive, although it is seen to run forward. A motion oscillates if
//! `|w| > 0.2 |Re s|`; an overdamped one keeps the waves of the fixed frame.
//!
//! References: [ColemanFeingold1958].

use nalgebra::Complex;

use super::coordinates::{Coordinates, RotorBlades};
use super::support::support;
use crate::case::{Model, Words};
use crate::model::{NODE_UNKNOWNS, NamingAxes};
use crate::modes::ModeMotion;
use crate::result::{ModeKind, Whirl};

/// Least frequency in the axes of the blades, relative to the growth, of an oscillation.
const OSCILLATES: f64 = 0.2;
/// Least part of the energy of the blades with which one of several rotors names a mode.
const MOST: f64 = 0.6;
/// Unknowns of motion of a node.
pub(in crate::analysis) const SIX: usize = 6;

/// The name of a mode.
#[derive(Debug, Clone)]
pub(in crate::analysis) struct Named {
    /// The name without number and pattern.
    pub name: String,
    /// The pattern of the blades; `None` where they rest, and if other parts have most of the energy.
    pub whirl: Option<Whirl>,
    /// Frequency in axes that turn with the blades [rad/s].
    pub in_blades: f64,
    /// Whether it oscillates in these axes.
    pub oscillates: bool,
}

/// Names of the modes of a model.
pub(in crate::analysis) struct Names<'a> {
    model: &'a Model,
    coordinates: &'a Coordinates,
    /// Axes for names: a blade has the axes of its coordinates.
    axes: Vec<NamingAxes>,
    words: Words,
}

impl<'a> Names<'a> {
    /// For a model with its coordinates.
    pub fn new(model: &'a Model, coordinates: &'a Coordinates, words: Words) -> Self {
        let mut axes = model.naming.clone();
        for (node, axes) in axes.iter_mut().enumerate() {
            let slot = &coordinates.slots[coordinates.slot_of[NODE_UNKNOWNS * node]];
            if let Some((blade, _)) = slot.of_blade {
                let turn = coordinates.blade(blade).transpose();
                axes.blade = turn * axes.blade;
                axes.section = turn * axes.section;
            }
        }
        Self {
            model,
            coordinates,
            axes,
            words,
        }
    }

    /// The pattern as text after the name and its number, perhaps empty.
    pub fn pattern(&self, whirl: Option<Whirl>) -> String {
        pattern(whirl, self.words)
    }

    /// The name of a mode with an exponent of the fixed frame whose frequency is not negative; `is_real` if
    /// it does not oscillate there.
    pub fn of(&self, motion: &ModeMotion, exponent: Complex<f64>, is_real: bool) -> Named {
        let tower = ModeKind::main_of_tower(motion.of_tower(&self.axes));
        let tower = tower.map(|kind| kind.word().to_owned());
        let support = tower.or_else(|| support(self.model, self.coordinates, motion));
        let pattern = match support {
            Some(_) => None,
            None => self.whirl(motion),
        };
        let turns = pattern.as_ref().map_or(0.0, Pattern::turns);
        let relative = exponent.im - turns;
        let oscillates = !is_real && relative.abs() > OSCILLATES * exponent.re.abs();
        let is_turned = oscillates && relative < 0.0;
        let kind = || ModeKind::main(&motion.shares(&self.axes)).word_in(self.words);
        let own = support.unwrap_or_else(|| match pattern.as_ref().and_then(Pattern::owner) {
            Some(rotor) => format!("{rotor} {}", kind()),
            None => kind().to_owned(),
        });
        Named {
            name: match (is_real, oscillates) {
                (true, _) => format!("aperiodic {own}"),
                (false, true) => own,
                (false, false) => format!("overdamped {own}"),
            },
            whirl: pattern.map(|own| own.seen(is_turned)),
            in_blades: relative.abs(),
            oscillates,
        }
    }

    /// The pattern with most of the energy of the blades of the rotor that has most of it: of the motion
    /// exp(i w t) the coordinates `(1, -i)` of cosine and sine run with the rotation.
    fn whirl(&self, motion: &ModeMotion) -> Option<Pattern<'a>> {
        let rotors = &self.coordinates.rotors;
        let of_rotors: Vec<_> = (0..rotors.len())
            .map(|own| self.energies([motion; 2], own))
            .collect();
        let of_rotors: Vec<Vec<f64>> = of_rotors
            .into_iter()
            .map(|own| own.iter().map(|energy| energy.re).collect())
            .collect();
        let sums: Vec<f64> = of_rotors.iter().map(|own| own.iter().sum()).collect();
        let total: f64 = sums.iter().sum();
        let most = (0..rotors.len()).max_by(|a, b| sums[*a].total_cmp(&sums[*b]))?;
        let (rotor, energies) = (&rotors[most], &of_rotors[most]);
        let n = rotor.count;
        let place = (0..n).max_by(|a, b| energies[*a].total_cmp(&energies[*b]))?;
        let harmonic = match place {
            0 => 0,
            _ if n.is_multiple_of(2) && place == n - 1 => n as i32 / 2,
            place if place % 2 == 1 => (place as i32 + 1) / 2,
            place => -(place as i32) / 2,
        };
        // Rotors of equal speeds move together, each in the same pattern about its own axis.
        let alike = rotors
            .iter()
            .zip(&of_rotors)
            .filter(|(own, _)| own.count == n && own.speed == rotor.speed);
        let sum: f64 = alike.map(|(_, own)| own[place]).sum();
        (total > 0.0).then(|| Pattern {
            rotor,
            owns: rotors.len() > 1 && sums[most] >= MOST * total,
            whirl: Whirl {
                harmonic,
                blades: n,
                share: sum / total,
            },
        })
    }

    /// The energies of all patterns of two modes, each times a number of its own: modes of equal values are pure in
    /// combinations that are the vectors of this form.
    pub fn form(&self, a: &ModeMotion, b: &ModeMotion) -> Complex<f64> {
        let rotors = 0..self.coordinates.rotors.len();
        let energies = rotors.flat_map(|rotor| self.energies([a, b], rotor));
        let numbered = energies.zip(1..);
        numbered
            .map(|(energy, number)| energy * f64::from(number))
            .sum()
    }

    /// Energies of the patterns of a rotor, of the motion of one mode and the momentum of another: collective, then one and minus one wave, and so on; last the
    /// differential one of an even number of blades.
    fn energies(&self, [a, b]: [&ModeMotion; 2], rotor: usize) -> Vec<Complex<f64>> {
        let [q, p] = [a.parts()[0], b.parts()[1]];
        let coordinates = self.coordinates;
        let own = &coordinates.rotors[rotor];
        let n = own.count;
        let mut energies = vec![Complex::from(0.0); n];
        for family in coordinates.families_of(rotor) {
            let firsts = family.iter().map(|slot| coordinates.slots[*slot].first);
            let is_motion = |first: &usize| {
                first / NODE_UNKNOWNS < q.len() / SIX && first % NODE_UNKNOWNS < NODE_UNKNOWNS / 2
            };
            let places = firsts.map(|first| {
                is_motion(&first).then(|| SIX * (first / NODE_UNKNOWNS) + first % NODE_UNKNOWNS)
            });
            let places: Option<Vec<_>> = places.collect();
            let Some(places) = places else { continue };
            for along in 0..3 {
                let at = |j: usize| (q[places[j] + along], p[places[j] + along]);
                let energy = |(q, p): (Complex<f64>, Complex<f64>)| q.conj() * p;
                energies[0] += energy(at(0));
                for wave in 0..own.waves() {
                    let [cos, sin] = [at(1 + 2 * wave), at(2 + 2 * wave)];
                    for (place, sign) in [(1 + 2 * wave, 1.0), (2 + 2 * wave, -1.0)] {
                        let i = Complex::new(0.0, sign);
                        energies[place] += energy((cos.0 + i * sin.0, cos.1 + i * sin.1)) * 0.5;
                    }
                }
                if n.is_multiple_of(2) {
                    energies[n - 1] += energy(at(n - 1));
                }
            }
        }
        energies
    }
}

/// The pattern as text after the name and its number, perhaps empty.
pub(in crate::analysis) fn pattern(whirl: Option<Whirl>, words: Words) -> String {
    let pure = whirl.filter(Whirl::is_pure);
    pure.map_or_else(String::new, |own| format!(" {}", own.word_in(words)))
}

/// The pattern of a mode in the fixed frame.
struct Pattern<'a> {
    rotor: &'a RotorBlades,
    /// Whether one of several rotors has most of the energy.
    owns: bool,
    /// Positive in the direction of ascending azimuth.
    whirl: Whirl,
}

impl Pattern<'_> {
    /// Frequency in the fixed frame of a motion that rests in the axes of the blades \[rad/s\]: of waves that
    /// turn with the blades, none of a differential pattern, whose coordinate does not turn.
    fn turns(&self) -> f64 {
        match self.whirl.has_direction() {
            true => f64::from(self.whirl.harmonic) * self.rotor.speed,
            false => 0.0,
        }
    }

    /// The rotor that names the mode.
    fn owner(&self) -> Option<&str> {
        self.owns.then_some(self.rotor.name.as_str())
    }

    /// The pattern with its sign in the direction of rotation, or the one of the conjugate motion.
    fn seen(&self, is_turned: bool) -> Whirl {
        let is_against = is_turned != (self.rotor.speed < 0.0);
        Whirl {
            harmonic: match is_against && self.whirl.has_direction() {
                true => -self.whirl.harmonic,
                false => self.whirl.harmonic,
            },
            ..self.whirl
        }
    }
}
