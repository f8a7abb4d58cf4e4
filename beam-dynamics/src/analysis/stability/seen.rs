//! The frequency at which a mode of a periodic motion is shown.
//!
//! ```text
//! max over d of sum_i w_i(|f_i + d 2 pi/T_i|)                                      (D-342)
//! ```
//!
//! with the frequency `f_i` at which the mode was followed to value i, its fundamental frequency
//! `2 pi/T_i`, and the share w of the energy at a frequency: the mode is shown at the frequencies, one
//! distance from the followed ones at all values, that have the largest part of its energy.

use crate::result::StabilityPoint;

/// Largest distance d.
const MOST: i32 = 6;
/// Distance of two frequencies, as a part of the fundamental one, up to which they are the same.
const SAME: f64 = 1e-6;

/// Shows each of `modes` modes at the frequencies of most energy.
pub(super) fn show_most(points: &mut [StabilityPoint], modes: usize) {
    for mode in 0..modes {
        let own = |point: &StabilityPoint| point.modes.iter().position(|own| *own == mode);
        let places: Vec<_> = points
            .iter()
            .enumerate()
            .filter_map(|(i, point)| Some((i, own(point)?)))
            .collect();
        let energy = |d: i32| -> f64 {
            let roots = places.iter().map(|(i, j)| &points[*i].roots[*j]);
            roots.map(|root| root.share_at(root.shifted(d), SAME)).sum()
        };
        let distances = (1..=MOST).flat_map(|d| [d, -d]);
        let (most, _) = distances
            .map(|d| (d, energy(d)))
            .fold(
                (0, energy(0)),
                |best, own| if own.1 > best.1 { own } else { best },
            );
        for (i, j) in places {
            let root = &mut points[i].roots[j];
            root.show(root.shifted(most), SAME);
        }
    }
}
