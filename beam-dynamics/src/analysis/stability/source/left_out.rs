//! Roots that the number of roots leaves out although roots of higher frequency are kept.

use std::f64::consts::TAU;

use crate::input::short_number;
use crate::result::StabilityRoot;

/// Damping ratio above which a root is no oscillation: it decays by 1e-19 in a period \[-\].
const OVERDAMPED: f64 = 0.99;

/// Oscillations that a number of roots leaves out at the values of a parameter.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct LeftOut {
    /// Largest number of oscillations of lower frequency than the highest one that is kept.
    oscillations: usize,
    /// Lowest frequency of an oscillation that is left out, over all values [rad/s].
    lowest: Option<f64>,
}

impl LeftOut {
    /// Adds the roots that are kept and left out at a value.
    pub fn add(&mut self, kept: &[StabilityRoot], others: &[StabilityRoot]) {
        let highest = kept
            .iter()
            .map(StabilityRoot::frequency)
            .fold(0.0, f64::max);
        let lower = others.iter().filter(|root| {
            let damping = root.damping_ratio();
            damping.is_some_and(|ratio| ratio < OVERDAMPED)
        });
        let lower = lower.map(StabilityRoot::frequency);
        let lower = lower.filter(|own| (0.0..highest).contains(own) && *own > 0.0);
        self.oscillations = self.oscillations.max(lower.clone().count());
        self.lowest = lower.chain(self.lowest).reduce(f64::min);
    }

    /// The remark on a number of roots.
    pub fn remark(&self, count: usize) -> Option<String> {
        let hertz = short_number(self.lowest? / TAU, 4);
        let modes = match self.oscillations {
            1 => "1 oscillation is".to_owned(),
            several => format!("{several} oscillations are"),
        };
        Some(format!(
            "\"count\" = {count} of [stability] keeps the least damped roots: up to {modes} left out although \
             others of higher frequency are kept, and the modes are complete below {hertz} Hz only; without \
             \"count\", or with a larger one, they are shown"
        ))
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Complex;

    use super::*;

    // Frequencies in Hz. Above the highest one that is kept nothing is missing, and real roots are no oscillations.
    #[test]
    fn lower_oscillations_that_are_left_out_are_counted() {
        let roots = |frequencies: &[f64]| -> Vec<_> {
            let root = |own: &f64| StabilityRoot::new(Complex::new(-1.0, TAU * own));
            frequencies.iter().map(root).collect()
        };
        let mut found = LeftOut::default();
        found.add(&roots(&[2.0, 5.0]), &roots(&[6.0, 0.0]));
        assert_eq!(found.remark(4), None);
        // Round-off makes a pair of two equal real roots.
        let pair = StabilityRoot::new(Complex::new(-1.0, 1e-5));
        found.add(&roots(&[2.0, 5.0]), &[pair]);
        assert_eq!(found.remark(4), None);
        found.add(&roots(&[2.0, 5.0]), &roots(&[4.0, 1.5, 9.0]));
        found.add(&roots(&[2.0, 5.0]), &roots(&[1.0]));
        let text = found.remark(4).unwrap();
        assert!(text.contains("up to 2 oscillations are left out"), "{text}");
        assert!(text.contains("complete below 1 Hz only"), "{text}");
    }
}
