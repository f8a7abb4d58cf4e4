//! Which modes at one rotor speed are which at the next.
//!
//! Modes are paired by their shapes, and where shapes mix by their frequencies: in the turning axes
//! by the slope over the speed, in the fixed system by the frequency itself. The forward whirl of a
//! shaft passes through the frequency zero of the turning axes at its critical speed; beyond it the
//! same motion is found at the opposite frequency, with the conjugate shape.

use std::f64::consts::TAU;

use crate::modes::{ModeMotion, align, assurances, closeness, follow};
use crate::result::ModePoint;

/// Relative difference of frequencies in the fixed system up to which a whirl that passes through
/// zero in the turning axes is continued.
const CONTINUED: f64 = 0.1;

/// A mode at one speed.
pub(super) struct Mode {
    /// Its motion.
    pub motion: ModeMotion,
    /// Its properties.
    pub point: ModePoint,
    /// `d (f^2) / d (Omega^2)` from the speed before, where the mode was followed from
    /// there: nearly constant for a turning blade [Hz^2 s^2/rad^2].
    pub slope: Option<f64>,
}

impl Mode {
    /// Frequency to be expected at another speed \[Hz\].
    fn expected(&self, from: f64, to: f64) -> Option<f64> {
        let square = self.point.frequency.powi(2) + self.slope? * (to * to - from * from);
        Some(square.max(0.0).sqrt())
    }

    /// Waves around the rotor and signed frequency \[Hz\] in the fixed system of a whirl; the
    /// frequency of a shaft's whirl hardly changes with the speed there.
    fn in_fixed_system(&self, speed: f64) -> Option<(i32, f64)> {
        let whirl = self
            .point
            .whirl
            .filter(|w| w.is_pure() && w.has_direction())?;
        let seen = whirl.signed_in_fixed_system(self.point.frequency, speed / TAU);
        Some((whirl.harmonic, seen))
    }
}

/// A mode at one speed and a mode at the next one.
struct Pair<'a> {
    modes: [&'a Mode; 2],
    speeds: [f64; 2],
}

impl Pair<'_> {
    /// Waves and frequencies of both in the fixed system.
    fn in_fixed_system(&self) -> Option<[(i32, f64); 2]> {
        let [a, b] = [0, 1].map(|k| self.modes[k].in_fixed_system(self.speeds[k]));
        Some([a?, b?])
    }

    /// Whether the first is the second after its frequency in the turning axes has passed through
    /// zero: it runs the other way around there, and has the same frequency in the fixed system.
    fn passes_zero(&self) -> bool {
        let both = self.in_fixed_system();
        both.is_some_and(|[a, b]| a.0 == -b.0 && (a.1 - b.1).abs() <= CONTINUED * a.1.abs())
    }

    /// Closeness of the frequencies, of the turning axes or of the fixed system.
    fn closeness(&self) -> Option<f64> {
        let ([a, b], [from, to]) = (self.modes, self.speeds);
        let turning = a.expected(from, to);
        let turning = turning.map(|expected| closeness(expected, b.point.frequency));
        let both = self.in_fixed_system();
        let fixed = both.filter(|[a, b]| a.0.abs() == b.0.abs());
        let fixed = fixed.map(|[a, b]| closeness(a.1, b.1));
        turning.into_iter().chain(fixed).reduce(f64::max)
    }
}

/// For each mode at the speed before, its continuation among the modes `now` and the assurance.
/// Repeated modes of `now` are turned toward the modes before, and described after that.
pub(super) fn direct_links(
    (from, before): (f64, &[Mode]),
    (to, now): (f64, &mut [Mode]),
    describe: impl Fn(&mut Mode),
) -> Vec<Option<(usize, f64)>> {
    let motions = |modes: &[Mode]| -> Vec<ModeMotion> {
        modes.iter().map(|mode| mode.motion.clone()).collect()
    };
    let frequencies: Vec<_> = now.iter().map(|mode| mode.point.frequency).collect();
    let (known, mut found) = (motions(before), motions(now));
    align(&mut found, &frequencies, &known);
    let mut macs = assurances(&known, &found);
    let conjugate: Vec<_> = found.iter().map(ModeMotion::conjugate).collect();
    let of_conjugates = assurances(&known, &conjugate);
    for (mode, motion) in now.iter_mut().zip(found) {
        mode.motion = motion;
        describe(mode);
    }
    let pair = |i: usize, j: usize| Pair {
        modes: [&before[i], &now[j]],
        speeds: [from, to],
    };
    for (i, row) in macs.iter_mut().enumerate() {
        for (j, mac) in row.iter_mut().enumerate() {
            if pair(i, j).passes_zero() {
                *mac = of_conjugates[i][j];
            }
        }
    }
    let weights: Vec<Vec<f64>> = (0..before.len())
        .map(|i| {
            let closeness = (0..now.len()).map(|j| pair(i, j).closeness().unwrap_or(1.0));
            closeness.collect()
        })
        .collect();
    let followed = follow(&macs, &weights);
    let squares = to.powi(2) - from.powi(2);
    let slope = |i: usize, j: usize| {
        let pair = pair(i, j);
        let [from, to] = pair.modes.map(|mode| mode.point.frequency);
        (!pair.passes_zero()).then(|| (to * to - from * from) / squares)
    };
    let links = followed.iter().enumerate();
    let links: Vec<_> = links.filter_map(|(i, j)| Some((i, (*j)?))).collect();
    let slopes: Vec<_> = links.iter().map(|(i, j)| (*j, slope(*i, *j))).collect();
    for (j, slope) in slopes {
        now[j].slope = slope;
    }
    let linked = |(i, next): (usize, &Option<usize>)| next.map(|j| (j, macs[i][j]));
    followed.iter().enumerate().map(linked).collect()
}
