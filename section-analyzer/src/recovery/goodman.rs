//! Damage of cycles by a constant-life diagram.
//!
//! With strengths T in tension and C in compression the largest amplitude about a mean `s_m` is the
//! one that reaches a strength; the lines of constant life are proportional to it (Goodman, with
//! its peak in the middle of both strengths), and Miner's sum adds the cycles `n_i`:
//!
//! ```text
//! S(s_m) = min(T - s_m, C + s_m)     N = (S(s_m) / s_a)^m                        (S-172)
//! D = sum n_i / N_i                                                              (S-173)
//! ```
//!
//! # References
//! - \[Germanischer2010\], 5.5: the diagram and its slope.
//! - \[Miner1945\]: the sum.

use super::rainflow::Cycle;

/// Largest number of iterations for the reserve factor, and its relative error.
const ITERATIONS: usize = 60;
const ERROR: f64 = 1e-9;

/// A constant-life diagram.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConstantLife {
    /// Strength in tension [unit of the cycles].
    pub tension: f64,
    /// Strength in compression, positive [unit of the cycles].
    pub compression: f64,
    /// Slope m \[-\].
    pub slope: f64,
}

impl ConstantLife {
    /// The largest amplitude about a mean; not positive if the mean is beyond a strength.
    pub fn amplitude(&self, mean: f64) -> f64 {
        (self.tension - mean).min(self.compression + mean)
    }

    /// The part of the largest amplitude that a cycle has \[-\]; infinite beyond the strengths.
    pub fn ratio(&self, range: f64, mean: f64) -> f64 {
        let largest = self.amplitude(mean);
        if largest > 0.0 {
            0.5 * range / largest
        } else {
            f64::INFINITY
        }
    }

    /// Miner's sum of cycles \[-\].
    pub fn damage(&self, cycles: &[Cycle]) -> f64 {
        let damage = |cycle: &Cycle| {
            let ratio = self.ratio(cycle.range, cycle.mean);
            cycle.count * ratio.powf(self.slope)
        };
        let counted = cycles.iter().filter(|cycle| cycle.count > 0.0);
        // a sum of nothing is -0
        counted.fold(0.0, |sum, cycle| sum + damage(cycle))
    }

    /// Whether the factor on all loads at which the damage is one is less than `factor`.
    pub fn is_below(&self, cycles: &[Cycle], factor: f64) -> bool {
        let mut damage = 0.0;
        let mut counted = cycles.iter().filter(|cycle| cycle.count > 0.0);
        counted.any(|cycle| {
            let ratio = self.ratio(factor * cycle.range, factor * cycle.mean);
            damage += cycle.count * ratio.powf(self.slope);
            damage > 1.0
        })
    }

    /// The factor on all loads at which the damage is one \[-\]; infinite without cycles. A cycle
    /// without range has the factor at which its mean reaches a strength.
    pub fn reserve_factor(&self, cycles: &[Cycle]) -> f64 {
        let counted = cycles.iter().filter(|cycle| cycle.count > 0.0);
        // the factor at which a mean reaches a strength
        let limit = counted.clone().map(|cycle| {
            if cycle.mean > 0.0 {
                self.tension / cycle.mean
            } else {
                self.compression / -cycle.mean
            }
        });
        let limit = limit.map(f64::abs).fold(f64::INFINITY, f64::min);
        let cycles: Vec<Cycle> = counted.filter(|cycle| cycle.range > 0.0).copied().collect();
        if cycles.is_empty() {
            return limit;
        }
        // Newton's method for ln D over ln of the factor, in an interval that becomes smaller
        let (mut low, mut high) = (0.0, limit);
        let mut factor = if limit > 1.0 { 1.0 } else { 0.5 * limit };
        for _ in 0..ITERATIONS {
            let (damage, rate) = self.scaled(&cycles, factor);
            if damage > 1.0 {
                high = factor
            } else {
                low = factor
            }
            let next = factor * (-damage.ln() / rate).exp();
            let next = match next > low && next < high {
                true => next,
                false if high.is_finite() => 0.5 * (low + high),
                false => 2.0 * factor,
            };
            let change = (next / factor - 1.0).abs();
            factor = next;
            if change < ERROR {
                break;
            }
        }
        factor
    }

    /// The damage of cycles times `factor`, and the derivative of its logarithm by the one of the
    /// factor.
    fn scaled(&self, cycles: &[Cycle], factor: f64) -> (f64, f64) {
        let (mut damage, mut rate) = (0.0, 0.0);
        for cycle in cycles {
            let mean = factor * cycle.mean;
            let largest = self.amplitude(mean);
            let ratio = self.ratio(factor * cycle.range, mean);
            let part = cycle.count * ratio.powf(self.slope);
            damage += part;
            // S + s_m dS: the strength that is nearer
            let strength = if self.tension - mean < self.compression + mean {
                self.tension
            } else {
                self.compression
            };
            rate += part * self.slope * strength / largest;
        }
        (damage, rate / damage)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLY: ConstantLife = ConstantLife {
        tension: 1000.0,
        compression: 600.0,
        slope: 10.0,
    };

    fn cycle(count: f64, range: f64, mean: f64) -> Cycle {
        Cycle { range, mean, count }
    }

    /// A factor is below another one if the damage with that one is above one; cycles without
    /// range count by their mean.
    #[test]
    fn factors_are_compared_without_being_computed() {
        for cycles in [
            vec![cycle(50.0, 300.0, 100.0), cycle(3.0, 500.0, -80.0)],
            vec![cycle(1.0, 0.0, 250.0)],
        ] {
            let factor = PLY.reserve_factor(&cycles);
            assert!(PLY.is_below(&cycles, 1.000_001 * factor));
            assert!(!PLY.is_below(&cycles, 0.999_999 * factor));
        }
        assert!(!PLY.is_below(&[], 1e9));
    }

    /// By hand: about 200, the middle of both strengths, the amplitude is 800; about 600 and about
    /// -200 it is 400. A tenth of it has 10^10 cycles, a half 1024.
    #[test]
    fn cycles_have_the_life_of_the_diagram() {
        for (mean, amplitude) in [(200.0, 800.0), (600.0, 400.0), (-200.0, 400.0)] {
            assert_eq!(PLY.amplitude(mean), amplitude);
            for (part, life) in [(0.1, 1e10), (0.5, 1024.0)] {
                let damage = PLY.damage(&[cycle(7.0, 2.0 * part * amplitude, mean)]);
                assert!((damage * life / 7.0 - 1.0).abs() < 1e-12, "{mean} {damage}");
            }
        }
        // two blocks: 512/1024 and 3e9/1e10
        let blocks = [cycle(512.0, 800.0, 200.0), cycle(3e9, 80.0, -200.0)];
        assert!((PLY.damage(&blocks) - 0.8).abs() < 1e-12);
        assert_eq!(PLY.damage(&[cycle(0.5, 1.0, 1000.0)]), f64::INFINITY);
        assert_eq!(PLY.damage(&[]), 0.0);
    }

    /// Equal strengths: Goodman's line `s_a / (1 - |s_m|/X)` of the amplitude of equal life
    /// without mean.
    #[test]
    fn equal_strengths_are_the_line_of_goodman() {
        let equal = ConstantLife {
            compression: 1000.0,
            ..PLY
        };
        for mean in [-700.0_f64, -50.0, 0.0, 300.0, 900.0] {
            let amplitude = 20.0 / (1.0 - mean.abs() / 1000.0);
            let found = equal.damage(&[cycle(1.0, 40.0, mean)]);
            let alone = equal.damage(&[cycle(1.0, 2.0 * amplitude, 0.0)]);
            assert!((found / alone - 1.0).abs() < 1e-12, "{mean}");
        }
    }

    /// One block of n cycles without mean: r = (S/s_a) n^(-1/m). With the mean `s_m`, the factor
    /// solves r s_a n^(1/m) = T - r s_m. With damage far above and below one, and many cycles.
    #[test]
    fn reserve_factors_have_the_damage_one() {
        let equal = ConstantLife {
            compression: 1000.0,
            ..PLY
        };
        let found = equal.reserve_factor(&[cycle(1e6, 20.0, 0.0)]);
        assert!((found / (100.0 * 1e6_f64.powf(-0.1)) - 1.0).abs() < 1e-8);
        let found = PLY.reserve_factor(&[cycle(1e6, 20.0, 400.0)]);
        let exact = 1000.0 / (10.0 * 1e6_f64.powf(0.1) + 400.0);
        assert!((found / exact - 1.0).abs() < 1e-8, "{found} {exact}");
        for size in [1e-9, 1e-3, 0.1, 1.0, 1e4] {
            let cycles: Vec<Cycle> = (1..200)
                .map(|i| {
                    let i = f64::from(i);
                    cycle(2e3 * i, size * 3.0 * i, size * 400.0 * (i * i).sin())
                })
                .collect();
            let factor = PLY.reserve_factor(&cycles);
            let scaled: Vec<Cycle> = cycles
                .iter()
                .map(|one| cycle(one.count, factor * one.range, factor * one.mean))
                .collect();
            assert!((PLY.damage(&scaled) - 1.0).abs() < 1e-6, "{size} {factor}");
        }
        assert_eq!(PLY.reserve_factor(&[]), f64::INFINITY);
        // without range: only the mean
        assert_eq!(PLY.reserve_factor(&[cycle(1.0, 0.0, 10.0)]), 100.0);
        assert_eq!(PLY.reserve_factor(&[cycle(1.0, 0.0, 0.0)]), f64::INFINITY);
        // cycles that do not occur
        let beyond = cycle(0.0, 100.0, 2000.0);
        assert_eq!(PLY.damage(&[beyond]), 0.0);
        assert_eq!(PLY.reserve_factor(&[beyond]), f64::INFINITY);
    }
}
