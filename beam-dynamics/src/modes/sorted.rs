//! Eigenvalues by kind: zeros of motions without stiffness, real values of motions that do not
//! oscillate, and oscillations.

use faer::c64;

/// Imaginary parts below this part of the magnitude belong to a motion that decays without
/// oscillation: internal damping gathers many such values at -1 / time, where round-off makes
/// pairs of them.
pub(super) const OVERDAMPED: f64 = 0.03;
/// Real parts below this part of the magnitude are round-off of an undamped mode.
pub(super) const OSCILLATING: f64 = 1e-9;

/// Values within this part of each other are copies of one value: far above the
/// round-off of the eigenvalues of stiff models, far below the differences of frequencies.
pub(super) const COPIES: f64 = 1e-6;

/// Eigenvalues by kind.
pub(super) struct Sorted {
    /// Number of those that are zero, later without the ones of free motions.
    pub zeros: usize,
    /// The real ones, ascending.
    pub real: Vec<f64>,
    /// Eigenvalues of oscillations, one of each pair, by angular frequency.
    pub above: Vec<c64>,
}

impl Sorted {
    /// Sorts eigenvalues, of which those up to `zero` in magnitude are zero.
    pub fn new(values: Vec<c64>, zero: f64) -> Self {
        let (zeros, values): (Vec<_>, Vec<_>) = values.into_iter().partition(|s| s.norm() <= zero);
        let is_real = |s: &&c64| {
            let part = if s.re < 0.0 { OVERDAMPED } else { OSCILLATING };
            s.im.abs() <= part * s.norm()
        };
        let mut real: Vec<_> = values.iter().filter(is_real).map(|s| s.re).collect();
        real.sort_by(f64::total_cmp);
        let mut above: Vec<_> = values
            .into_iter()
            .filter(|s| !is_real(&s) && s.im > 0.0)
            .collect();
        above.sort_by(|a, b| a.im.total_cmp(&b.im));
        Self {
            zeros: zeros.len(),
            real,
            above,
        }
    }
}

/// Number of values from the first on that are copies of it, itself included.
pub(super) fn copies_at_front(values: &[c64]) -> usize {
    let is_copy = |s: &&c64| (**s - values[0]).norm() <= COPIES * values[0].norm();
    values.iter().take_while(is_copy).count().max(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_value_has_its_index() {
        let values = [
            (1e-9, 2e-9),
            (-3.0, 0.0),
            (0.0, 7.0),
            (0.0, -7.0),
            (-1.0, 5.0),
            (-1.0, -5.0),
            (2.0, 0.0),
        ];
        let values = values.map(|(re, im)| c64::new(re, im)).to_vec();
        let sorted = Sorted::new(values, 1e-6);
        assert_eq!((sorted.zeros, sorted.real), (1, vec![-3.0, 2.0]));
        let frequencies: Vec<_> = sorted.above.iter().map(|s| s.im).collect();
        assert_eq!(frequencies, [5.0, 7.0]);
    }
}
