//! The whirl of a shaft: motion across the axis of rotation of the nodes on it.
//!
//! With u_1, u_2 the motion of a node along two directions across the axis, which with the
//! axis are right-handed, and a motion exp(i w t),
//!
//! ```text
//! a_+ = (u_1 + i u_2) / sqrt(2)        a_- = (u_1 - i u_2) / sqrt(2)
//! ```
//!
//! are the parts that run with the rotation and against it, of the harmonics +1 and -1:
//! in the fixed system their frequencies are `w + Omega` and `w - Omega`. Rotations are
//! split in the same way. Motion along and about the axis has the harmonic 0.

use nalgebra::{Complex, Vector3};

use super::ModeMotion;
use crate::model::NamingAxes;
use crate::result::Whirl;

/// Least part of the kinetic energy that nodes on the axis hold in a mode of a shaft.
const MOST: f64 = 0.6;
/// Unknowns of motion of a node.
const SIX: usize = 6;

/// The pattern that holds most of the energy of the nodes on the axis; `None` for modes of which
/// other nodes hold much.
pub fn shaft_whirl(motion: &ModeMotion, axes: &[NamingAxes]) -> Option<Whirl> {
    let mut parts = [0.0; 3];
    let central = axes.iter().enumerate().filter(|node| node.1.is_central);
    for (node, axes) in central {
        for first in [SIX * node, SIX * node + 3] {
            let [q, p] = [&motion.motion, &motion.momentum].map(|values| {
                let vector = Vector3::new(values[first], values[first + 1], values[first + 2]);
                circular(axes, &vector)
            });
            for (part, (q, p)) in parts.iter_mut().zip(q.iter().zip(p)) {
                *part += (q.conj() * p).re;
            }
        }
    }
    // In a turning frame the part of a pattern may be negative.
    let parts = parts.map(f64::abs);
    let total: f64 = parts.iter().sum();
    if total < MOST * motion.product(motion).re {
        return None;
    }
    let numbered = parts.into_iter().zip([0, 1, -1]);
    let (energy, harmonic) = numbered.max_by(|a, b| a.0.total_cmp(&b.0))?;
    Some(Whirl {
        harmonic,
        blades: 0,
        share: energy / total,
    })
}

/// Parts along the axis, with the rotation and against it.
fn circular(axes: &NamingAxes, vector: &Vector3<Complex<f64>>) -> [Complex<f64>; 3] {
    let [along, one, two] =
        [0, 1, 2].map(|axis| axes.blade.column(axis).map(Complex::from).dot(vector));
    let turned = Complex::new(0.0, 1.0) * two;
    let half = std::f64::consts::FRAC_1_SQRT_2;
    [along, (one + turned) * half, (one - turned) * half]
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Matrix3;

    // Rotation about x. The circle y = cos(w t), z = sin(w t) runs with the rotation: its complex
    // motion is (0, 1, -i). The line y = cos(w t) is half of each.
    #[test]
    fn circles_and_lines_are_distinguished() {
        let [zero, one, i] = [Complex::new(0.0, 0.0), Complex::new(1.0, 0.0), Complex::i()];
        let whirl = |displacement: [Complex<f64>; 3], is_central| {
            let mut motion = displacement.to_vec();
            motion.extend([zero; 3]);
            let momentum = motion.clone();
            let axes = NamingAxes {
                blade: Matrix3::identity(),
                section: Matrix3::identity(),
                is_central,
                tower: None,
            };
            shaft_whirl(&ModeMotion { motion, momentum }, &[axes])
        };
        let of = |displacement| {
            let whirl = whirl(displacement, true).unwrap();
            (whirl.harmonic, whirl.share)
        };
        assert_eq!(of([zero, one, -i]).0, 1);
        assert_eq!(of([zero, one, i]).0, -1);
        assert_eq!(of([one, zero, zero]), (0, 1.0));
        assert!((of([zero, one, -i]).1 - 1.0).abs() < 1e-15);
        assert!((of([zero, one, zero]).1 - 0.5).abs() < 1e-15);
        assert_eq!(whirl([zero, one, -i], false), None);
    }
}
