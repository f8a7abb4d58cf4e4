//! The frequencies of a mode in the fixed frame, and its dominant motion.
//!
//! A mode is `exp(s t) u(t)` with periodic u. Its harmonics in components that do not turn, blades in
//! multiblade coordinates, carry kinetic energy at the frequencies `Im s + m 2 pi/T`:
//!
//! ```text
//! u_m = 1/n sum_k u(t_k) exp(-i 2 pi m k/n) ,   w_m = sum_j m_j |u_mj|^2            (D-207)
//! Q_h = 1/N sum_k r_k exp(i h psi_k) ,          weight N m_j
//! ```
//!
//! with `r_k` the vectors of the nodes of blade k in axes that turn with the blade, at the azimuth
//! `psi_k`. The branch m with the largest energy is the frequency that an observer in the fixed frame
//! sees.
//!
//! References: [ColemanFeingold1958].

use std::f64::consts::TAU;

use nalgebra::{Complex, Matrix3, Rotation3, Unit, Vector3};

use crate::case::Model;
use crate::model::MOTION_WORDS;
use crate::modes::Rotor;

/// A vector of a mode: position or rotation.
type Motion = Vector3<Complex<f64>>;

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

/// A group of three components of the motion over the period.
struct Track {
    name: String,
    is_rotation: bool,
    weight: f64,
    values: Vec<Motion>,
}

/// The content of a mode.
pub(super) struct Observer<'a> {
    /// The model.
    pub model: &'a Model,
    /// Speed of the rotor [rad/s].
    pub speed: Option<f64>,
    /// Period [s].
    pub period: f64,
    /// Mass [kg] and moment of inertia [kg m^2] of the nodes.
    pub masses: Vec<[f64; 2]>,
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
        let axis = &self.model.frame_rotation.axis;
        let rotor = self.speed.zip(Rotor::new(&self.model.blades, axis));
        let of_blades: Vec<_> = match &rotor {
            Some(_) => self
                .model
                .blades
                .iter()
                .flat_map(|blade| &blade.nodes)
                .collect(),
            None => Vec::new(),
        };
        let mut tracks = Vec::new();
        for (node, masses) in self.masses.iter().enumerate() {
            if of_blades.contains(&&node) {
                continue;
            }
            let name = format!("node \"{}\"", self.model.system.nodes()[node].label);
            for (kind, &weight) in masses.iter().enumerate().filter(|(_, mass)| **mass > 0.0) {
                tracks.push(Track {
                    name: name.clone(),
                    is_rotation: kind == 1,
                    weight,
                    values: u.iter().map(|all| all[node][kind]).collect(),
                });
            }
        }
        if let Some((speed, rotor)) = &rotor {
            self.add_blades(u, (*speed, rotor), &mut tracks);
        }
        tracks
    }

    /// Adds the multiblade coordinates.
    fn add_blades(
        &self,
        u: &[Vec<[Motion; 2]>],
        (speed, rotor): (f64, &Rotor),
        tracks: &mut Vec<Track>,
    ) {
        let blades = &self.model.blades;
        let count = blades.len();
        let axis = Unit::new_normalize(self.model.frame_rotation.axis);
        let turn = |angle: f64| {
            let matrix: Matrix3<f64> = Rotation3::from_axis_angle(&axis, -angle).into();
            matrix.map(|value| Complex::new(value, 0.0))
        };
        let azimuth = |blade: usize, k: usize| {
            blades[blade].azimuth + speed * self.period * k as f64 / u.len() as f64
        };
        for index in 0..blades[0].nodes.len() {
            let node = blades[0].nodes[index];
            let label = &self.model.system.nodes()[node].label;
            for kind in 0..2 {
                let weight = self.masses[node][kind] * count as f64;
                if weight == 0.0 {
                    continue;
                }
                for h in rotor.harmonics() {
                    let is_differential = 2 * h.unsigned_abs() as usize == count;
                    let value = |k: usize| {
                        let parts = (0..count).map(|blade| {
                            let psi = azimuth(blade, k);
                            let own = if is_differential {
                                blades[blade].azimuth
                            } else {
                                psi
                            };
                            let wave = Complex::from_polar(1.0 / count as f64, f64::from(h) * own);
                            (turn(psi) * u[k][blades[blade].nodes[index]][kind]) * wave
                        });
                        parts.fold(Motion::zeros(), |a, b| a + b)
                    };
                    tracks.push(Track {
                        name: format!("blades as \"{label}\", {}", pattern(h, is_differential)),
                        is_rotation: kind == 1,
                        weight,
                        values: (0..u.len()).map(value).collect(),
                    });
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
