//! The frequencies of a mode in the fixed frame, and its motion there.
//!
//! A mode is `exp(s t) u(t)` with periodic u. Its harmonics in components that do not turn, blades in
//! multiblade coordinates, carry kinetic energy at the frequencies `Im s + m 2 pi/T`:
//!
//! ```text
//! u_m = 1/n sum_k u(t_k) exp(-i 2 pi m k/n) ,   w_m = sum_j m_j |u_mj|^2            (D-447)
//! Q_h = 1/N sum_k r_k exp(i h psi_k) ,          weight N m_j
//! ```
//!
//! with `r_k` the vectors of the nodes of blade k of a rotor in axes that turn with the blade, at the azimuth
//! `psi_k`; each rotor has its own blades and speed, a multiple of `2 pi/T`. The branch m with the largest
//! energy is the frequency that an observer in the fixed frame sees.
//!
//! References: [ColemanFeingold1958].

use std::f64::consts::TAU;

use nalgebra::{Complex, Matrix3, Vector3};
use shared_geom::rotation::vector;

use crate::analysis::multiblade::{Coordinates, Named, Names, SIX, SlotKind};
use crate::case::{Model, Words};
use crate::model::{MOTION_WORDS, NODE_UNKNOWNS, State};
use crate::modes::{MassMatrix, ModeMotion};

/// A vector of a mode: position or rotation.
pub(super) type Motion = Vector3<Complex<f64>>;

/// Entries of the motion in a pattern: by the first blade of its rotor, or its number, and the waves h.
type Entries = ((usize, i32), Vec<Complex<f64>>);

/// Harmonics on each side of the principal branch that are examined.
const MOST: i32 = 24;

/// Energies of the harmonics of a mode.
pub(super) struct Content {
    /// Number m of each harmonic, its share, and the dominant motion in it.
    pub shares: Vec<(i32, f64, String)>,
    tracks: Vec<Track>,
}

impl Content {
    /// The harmonic m of all parts, three entries of each, times the roots of their masses.
    pub fn shape(&self, m: i32) -> Vec<Complex<f64>> {
        let part = |track: &Track| {
            let of = harmonic(&track.values, m) * Complex::from(track.weight.sqrt());
            [of.x, of.y, of.z]
        };
        self.tracks.iter().flat_map(part).collect()
    }
}

/// The part of a track.
#[derive(Debug, Clone, Copy)]
enum Part {
    /// A node that no blade has.
    Node(usize),
    /// A pattern h of the nodes of a family.
    Blades { family: usize, h: i32 },
}

/// A group of three components of the motion over the period.
struct Track {
    name: String,
    part: Part,
    is_rotation: bool,
    weight: f64,
    values: Vec<Motion>,
}

/// Multiblade coordinates along the motion.
pub(super) struct InBlades {
    coordinates: Coordinates,
    /// The axes of each blade at the first instant (columns), and the axis about which it turns then.
    blades: Vec<(Matrix3<f64>, Vector3<f64>)>,
    mass: MassMatrix,
}

impl InBlades {
    /// Of a model at the first state of a motion of a period \[s\]; `None` without equal blades.
    pub fn new(model: &Model, (state, mass): (&State, MassMatrix), period: f64) -> Option<Self> {
        let coordinates = Coordinates::new(model).ok()?.turning(state, period);
        let turned = coordinates.turned(state);
        let rotors = coordinates.rotors.iter().zip(turned);
        let blades = rotors.flat_map(|(rotor, turned)| {
            let axis = turned * rotor.axis;
            let blades = rotor.blades();
            blades.map(move |blade| (turned, blade, axis))
        });
        let blades = blades.map(|(turned, blade, axis)| (turned * coordinates.blade(blade), axis));
        Some(Self {
            blades: blades.collect(),
            coordinates,
            mass,
        })
    }
}

/// The content of a mode.
pub(super) struct Observer<'a> {
    /// The model.
    pub model: &'a Model,
    /// Its rotors.
    pub in_blades: Option<InBlades>,
    /// Period [s].
    pub period: f64,
    /// Mass [kg] and moment of inertia [kg m^2] of the nodes.
    pub masses: Vec<[f64; 2]>,
    /// Words in the names.
    pub words: Words,
}

impl Observer<'_> {
    /// Of the periodic part `u` at equal distances: position and rotation of each node; `is_real`
    /// for a mode that is its own conjugate, whose harmonics m and -m are one.
    pub fn content(&self, u: &[Vec<[Motion; 2]>], is_real: bool) -> Content {
        let tracks = self.tracks(u);
        let n = u.len();
        let most = MOST.min((n as i32 - 1) / 2);
        let mut energies: Vec<(i32, f64, String)> = Vec::new();
        for m in -most..=most {
            let mut sum = 0.0;
            let mut largest = (0.0, String::new());
            for track in &tracks {
                let of = harmonic(&track.values, m);
                for axis in 0..3 {
                    let energy = track.weight * of[axis].norm_sqr();
                    sum += energy;
                    if energy > largest.0 {
                        let word = MOTION_WORDS[axis + 3 * usize::from(track.is_rotation)];
                        largest = (energy, format!("{}: {word}", track.name));
                    }
                }
            }
            match energies.iter_mut().find(|own| is_real && own.0 == -m) {
                Some(own) => own.1 += sum,
                None => energies.push((if is_real { m.abs() } else { m }, sum, largest.1)),
            }
        }
        let whole: f64 = energies.iter().map(|own| own.1).sum();
        energies
            .iter_mut()
            .for_each(|own| own.1 /= whole.max(f64::MIN_POSITIVE));
        energies.sort_by(|a, b| b.1.total_cmp(&a.1));
        Content {
            shares: energies,
            tracks,
        }
    }

    fn tracks(&self, u: &[Vec<[Motion; 2]>]) -> Vec<Track> {
        let in_blades = self.in_blades.as_ref().map(|own| &own.coordinates);
        let is_of_blade = |node: usize| {
            let slot = in_blades.map(|own| &own.slots[own.slot_of[NODE_UNKNOWNS * node]]);
            slot.is_some_and(|slot| slot.of_blade.is_some())
        };
        let mut tracks = Vec::new();
        for (node, masses) in self.masses.iter().enumerate() {
            if is_of_blade(node) {
                continue;
            }
            let name = format!("node \"{}\"", self.model.system.nodes()[node].label);
            for (kind, &weight) in masses.iter().enumerate().filter(|(_, mass)| **mass > 0.0) {
                tracks.push(Track {
                    name: name.clone(),
                    part: Part::Node(node),
                    is_rotation: kind == 1,
                    weight,
                    values: u.iter().map(|all| all[node][kind]).collect(),
                });
            }
        }
        if let Some(own) = &self.in_blades {
            for family in 0..own.coordinates.families.len() {
                self.add_blades(u, (own, family), &mut tracks);
            }
        }
        tracks
    }

    /// Adds the multiblade coordinates of a family of vectors of motion.
    fn add_blades(
        &self,
        u: &[Vec<[Motion; 2]>],
        (own, family): (&InBlades, usize),
        tracks: &mut Vec<Track>,
    ) {
        let coordinates = &own.coordinates;
        let slots = coordinates.families[family]
            .iter()
            .map(|slot| &coordinates.slots[*slot]);
        let slots: Vec<_> = slots.collect();
        let Some((first, (blade, _))) = slots.first().and_then(|slot| Some((slot, slot.of_blade?)))
        else {
            return;
        };
        let (node, kind) = (first.first / NODE_UNKNOWNS, first.first % NODE_UNKNOWNS / 3);
        if first.kind != SlotKind::Vector || kind > 1 || self.masses[node][kind] == 0.0 {
            return;
        }
        let rotor = coordinates.rotor_of(blade);
        let label = &self.model.system.nodes()[node].label;
        let turn = |k: usize| rotor.speed * self.period * k as f64 / u.len() as f64;
        // The vectors in the axes of the blades, at all instants.
        let seen = rotor.blades().zip(&slots).map(|(blade, slot)| {
            let (axes, axis) = own.blades[blade];
            let in_axes = |k: usize| {
                let axes = vector::to_rotation(&(axis * turn(k))) * axes;
                axes.transpose().map(Complex::from) * u[k][slot.first / NODE_UNKNOWNS][kind]
            };
            (0..u.len()).map(in_axes).collect::<Vec<_>>()
        });
        let seen: Vec<_> = seen.collect();
        let count = rotor.count;
        for h in -(rotor.waves() as i32)..=count as i32 / 2 {
            let is_differential = 2 * h.unsigned_abs() as usize == count;
            let value = |k: usize| {
                let parts = rotor.blades().zip(&seen).map(|(blade, seen)| {
                    let turned = if is_differential { 0.0 } else { turn(k) };
                    let psi = coordinates.azimuths[blade] + turned;
                    seen[k] * Complex::from_polar(1.0 / count as f64, f64::from(h) * psi)
                });
                parts.fold(Motion::zeros(), |a, b| a + b)
            };
            tracks.push(Track {
                name: format!("blades as \"{label}\", {}", pattern(h, is_differential)),
                part: Part::Blades { family, h },
                is_rotation: kind == 1,
                weight: self.masses[node][kind] * count as f64,
                values: (0..u.len()).map(value).collect(),
            });
        }
    }

    /// The motion of a mode at one instant by patterns of the blades: for each pattern of a rotor, the first with
    /// zero of the parts without one, its entries, times the roots of their masses.
    pub fn patterns(&self, u: Vec<[Motion; 2]>, is_real: bool) -> Vec<Entries> {
        let Some(own) = &self.in_blades else {
            return Vec::new();
        };
        let mut found = vec![((0, 0), Vec::new())];
        for track in self.tracks(&[u]) {
            let key = match track.part {
                Part::Node(_) => (0, 0),
                Part::Blades { family, h } => {
                    let first = &own.coordinates.slots[own.coordinates.families[family][0]];
                    let blade = first.of_blade.map_or(0, |own| own.0);
                    (1 + blade, if is_real { h.abs() } else { h })
                }
            };
            let entries = track.values[0] * Complex::from(track.weight.sqrt());
            match found.iter_mut().find(|own| own.0 == key) {
                Some((_, all)) => all.extend(entries.iter()),
                None => found.push((key, entries.iter().copied().collect())),
            }
        }
        found
    }

    /// The name of a mode by its harmonic m with an exponent of the fixed frame; `None` without equal blades,
    /// where the largest motion names it.
    pub fn named(
        &self,
        content: &Content,
        m: i32,
        exponent: Complex<f64>,
    ) -> Option<(Named, String, ModeMotion)> {
        let own = self.in_blades.as_ref()?;
        let motion = own.motion(content, (m, exponent.im < 0.0), self.masses.len());
        let names = Names::new(self.model, &own.coordinates, self.words);
        let exponent = Complex::new(exponent.re, exponent.im.abs());
        let named = names.of(&motion, exponent, exponent.im == 0.0);
        let pattern = names.pattern(named.whirl);
        Some((named, pattern, motion))
    }
}

impl InBlades {
    /// The harmonic m in multiblade coordinates with cosine and sine, or its conjugate.
    fn motion(
        &self,
        content: &Content,
        (m, is_conjugate): (i32, bool),
        nodes: usize,
    ) -> ModeMotion {
        let seen = |track: &Track| {
            let value = harmonic(&track.values, m);
            if is_conjugate {
                value.conjugate()
            } else {
                value
            }
        };
        let mut motion = vec![Complex::new(0.0, 0.0); SIX * nodes];
        // Nodes of blades move as the ones of the first blade in each pattern.
        let mut patterns: Vec<Entries> = Vec::new();
        for track in &content.tracks {
            let value = seen(track);
            let half = 3 * usize::from(track.is_rotation);
            match track.part {
                Part::Node(node) => {
                    motion[SIX * node + half..][..3].copy_from_slice(value.as_slice())
                }
                Part::Blades { family, h } => {
                    let first = self.coordinates.families[family][0];
                    let slot = &self.coordinates.slots[first];
                    let Some((blade, _)) = slot.of_blade else {
                        continue;
                    };
                    let h = if is_conjugate { -h } else { h };
                    let place = patterns.iter().position(|own| own.0 == (blade, h));
                    let place = place.unwrap_or_else(|| {
                        patterns.push(((blade, h), vec![Complex::new(0.0, 0.0); SIX * nodes]));
                        patterns.len() - 1
                    });
                    let node = slot.first / NODE_UNKNOWNS;
                    let in_space = self.blades[blade].0.map(Complex::from) * value;
                    patterns[place].1[SIX * node + half..][..3]
                        .copy_from_slice(in_space.as_slice());
                }
            }
        }
        let mut momentum = self.mass.times(&motion);
        for (node, own) in momentum.chunks_exact_mut(SIX).enumerate() {
            let slot = &self.coordinates.slots[self.coordinates.slot_of[NODE_UNKNOWNS * node]];
            if slot.of_blade.is_some() {
                own.fill(Complex::new(0.0, 0.0));
            }
        }
        for ((blade, h), pattern) in &patterns {
            self.spread(
                (*blade, *h),
                [pattern, &self.mass.times(pattern)],
                [&mut motion, &mut momentum],
            );
        }
        ModeMotion::from_parts(motion, momentum)
    }

    /// Adds the pattern h of the vectors of the first blade of a rotor, in space, to the coordinates of
    /// its families: `u = sum_h Q_h exp(-i h psi)` has the cosine `Q_h + Q_-h` and the sine `-i (Q_h - Q_-h)`,
    /// whose masses are N/2 of the one of a blade.
    fn spread(
        &self,
        (blade, h): (usize, i32),
        pattern: [&[Complex<f64>]; 2],
        out: [&mut [Complex<f64>]; 2],
    ) {
        let Coordinates {
            slots, families, ..
        } = &self.coordinates;
        let rotor = self.coordinates.rotor_of(blade);
        let (n, waves) = (rotor.count as f64, h.unsigned_abs() as usize);
        let one = Complex::new(1.0, 0.0);
        let targets = match waves {
            0 => vec![(0, one, n)],
            _ if 2 * waves == rotor.count => vec![(rotor.count - 1, one, n)],
            _ => vec![
                (2 * waves - 1, one, 0.5 * n),
                (
                    2 * waves,
                    Complex::new(0.0, -f64::from(h.signum())),
                    0.5 * n,
                ),
            ],
        };
        let back = self.blades[blade].0.transpose().map(Complex::from);
        for family in families {
            let first = &slots[family[0]];
            let half = first.first % NODE_UNKNOWNS;
            let is_own = first.of_blade.is_some_and(|own| own.0 == blade);
            if !is_own || first.kind != SlotKind::Vector || half > 3 {
                continue;
            }
            let from = SIX * (first.first / NODE_UNKNOWNS) + half;
            for (j, factor, mass) in &targets {
                let to = SIX * (slots[family[*j]].first / NODE_UNKNOWNS) + half;
                for (number, weight) in [1.0, *mass].into_iter().enumerate() {
                    let own = Vector3::from_column_slice(&pattern[number][from..from + 3]);
                    let value = back * own * (factor * weight);
                    let out = out[number][to..to + 3].iter_mut();
                    out.zip(&value).for_each(|(out, value)| *out += value);
                }
            }
        }
    }
}

fn pattern(h: i32, is_differential: bool) -> String {
    match h {
        0 => "collective".to_owned(),
        _ if is_differential => "differential".to_owned(),
        1 | -1 => "cyclic".to_owned(),
        _ => format!("cyclic {}", h.abs()),
    }
}

/// The harmonic m of values at equal distances.
fn harmonic(values: &[Motion], m: i32) -> Motion {
    let n = values.len();
    let mut sum = Motion::zeros();
    for (k, value) in values.iter().enumerate() {
        let step = (i64::from(m) * k as i64).rem_euclid(n as i64);
        sum += value * Complex::from_polar(1.0 / n as f64, -TAU * step as f64 / n as f64);
    }
    sum
}
