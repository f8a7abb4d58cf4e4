//! Multiblade coordinates: how the blades of a rotor move together.
//!
//! With u_k the motion of blade k, in axes that are turned with it about the axis, psi_k its azimuth
//! and N equal blades at equal distances,
//!
//! ```text
//! u_k = sum_h Q_h exp(-i h psi_k)        Q_h = 1/N sum_k u_k exp(i h psi_k)
//! ```
//!
//! h from -(N-1)/2 to N/2. In a motion exp(i w t) the part h runs around the rotor as
//! `w t - h psi`: in the direction of rotation for h > 0 (progressive), against it for
//! h < 0 (regressive); h = 0 is collective, and h = N/2 of an even number of blades
//! differential, each blade against its neighbors. Seen from the fixed system, where the
//! rotor turns with Omega, its frequency is `w + h Omega`.
//!
//! The kinetic energies of the parts are, with P_h the same sums of the momenta,
//!
//! ```text
//! E_h = N Q_h^H P_h
//! ```
//!
//! References: [ColemanFeingold1958].

use nalgebra::{Complex, Matrix3, Vector3};
use shared_geom::rotation::vector;

use super::ModeMotion;
use crate::case::BladeNodes;
use crate::result::Whirl;

/// Distances of the blades in azimuth may differ by this [rad].
const EQUAL: f64 = 1e-6;
/// Part of the kinetic energy below which the motion of a blade is ignored.
const STILL: f64 = 1e-6;
/// Unknowns of motion of a node.
const SIX: usize = 6;

/// Equal blades at equal distances around the axis.
#[derive(Debug, Clone)]
pub struct Rotor {
    blades: Vec<BladeNodes>,
    /// Turn of each blade about the axis, back to the azimuth zero.
    back: Vec<Matrix3<f64>>,
}

impl Rotor {
    /// The rotor of `blades` around an axis of unit length; `None` for one blade, for blades of
    /// different numbers of nodes, and for blades at unequal distances.
    pub fn new(blades: &[BladeNodes], axis: &Vector3<f64>) -> Option<Self> {
        let first = blades.first()?;
        let count = blades.len();
        let step = std::f64::consts::TAU / count as f64;
        let around = |blade: &BladeNodes| {
            // The azimuth of the first blade may be a whole turn.
            let steps = ((blade.azimuth - first.azimuth) / step + 0.5).rem_euclid(count as f64);
            steps - 0.5
        };
        let mut steps: Vec<_> = blades.iter().map(around).collect();
        steps.sort_by(f64::total_cmp);
        let apart = (0..count).all(|k| (steps[k] - k as f64).abs() * step < EQUAL);
        let alike = blades
            .iter()
            .all(|blade| blade.nodes.len() == first.nodes.len());
        (count > 1 && apart && alike).then(|| Self {
            blades: blades.to_vec(),
            back: blades
                .iter()
                .map(|blade| vector::to_rotation(&(-axis * blade.azimuth)))
                .collect(),
        })
    }

    /// The numbers of waves around the rotor.
    pub fn harmonics(&self) -> impl Iterator<Item = i32> + use<> {
        let count = self.blades.len() as i32;
        -((count - 1) / 2)..=count / 2
    }

    /// The parts of a mode by harmonics.
    pub(super) fn parts(&self, mode: &ModeMotion) -> Parts {
        Parts {
            motion: self.parts_of(&mode.motion),
            momentum: self.parts_of(&mode.momentum),
        }
    }

    /// `N Q_h` for each harmonic: six entries a node of a blade, turned with the blade.
    fn parts_of(&self, values: &[Complex<f64>]) -> Vec<Vec<Complex<f64>>> {
        let blades = self.blades.iter().zip(&self.back);
        let turned: Vec<_> = blades
            .map(|(blade, back)| turned(blade, values, back))
            .collect();
        let part = |h: i32| {
            let mut sum = vec![Complex::new(0.0, 0.0); turned.first().map_or(0, Vec::len)];
            for (blade, turned) in self.blades.iter().zip(&turned) {
                let phase = Complex::from_polar(1.0, f64::from(h) * blade.azimuth);
                let entries = sum.iter_mut().zip(turned);
                entries.for_each(|(sum, value)| *sum += phase * value);
            }
            sum
        };
        self.harmonics().map(part).collect()
    }

    /// The nodes of all blades.
    pub(super) fn nodes(&self) -> impl Iterator<Item = usize> + '_ {
        self.blades
            .iter()
            .flat_map(|blade| blade.nodes.iter().copied())
    }

    /// The part that holds most of the energy of the blades, with its share of that: a
    /// hub that moves most of all goes with the blades. `None` where the blades rest.
    pub fn whirl(&self, motion: &ModeMotion) -> Option<Whirl> {
        let parts = self.parts(motion);
        let energies = parts.energies(&parts);
        let total: f64 = energies.iter().map(|energy| energy.re).sum();
        if total <= STILL * motion.product(motion).re {
            return None;
        }
        let parts = self.harmonics().zip(energies);
        let (harmonic, energy) = parts
            .map(|(harmonic, energy)| (harmonic, energy.re))
            .max_by(|a, b| a.1.total_cmp(&b.1))?;
        Some(Whirl {
            harmonic,
            blades: self.blades.len(),
            share: energy / total,
        })
    }
}

/// The parts of a mode by harmonics, in the order of [`Rotor::harmonics`]: `N Q_h` and `N P_h`.
#[derive(Debug, Clone)]
pub(super) struct Parts {
    motion: Vec<Vec<Complex<f64>>>,
    momentum: Vec<Vec<Complex<f64>>>,
}

impl Parts {
    /// `Q_h^H P_h N` for each harmonic, from the motion of this mode and the momentum of another.
    pub fn energies(&self, other: &Self) -> Vec<Complex<f64>> {
        let count = self.motion.len() as f64;
        let pairs = self.motion.iter().zip(&other.momentum);
        let product = |(q, p): (&Vec<Complex<f64>>, &Vec<Complex<f64>>)| {
            let terms = q.iter().zip(p).map(|(q, p)| q.conj() * p);
            terms.sum::<Complex<f64>>() / count
        };
        pairs.map(product).collect()
    }
}

/// The entries of the nodes of a blade, turned `back` to the azimuth zero, six a node.
fn turned(blade: &BladeNodes, values: &[Complex<f64>], back: &Matrix3<f64>) -> Vec<Complex<f64>> {
    let mut turned = Vec::with_capacity(SIX * blade.nodes.len());
    let back = back.map(Complex::from);
    for &node in &blade.nodes {
        for half in [0, 3] {
            let vector = Vector3::from_column_slice(&values[SIX * node + half..][..3]);
            turned.extend((back * vector).iter());
        }
    }
    turned
}
