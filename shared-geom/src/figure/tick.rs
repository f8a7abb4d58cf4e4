//! Round numbers along an axis, and their labels.

/// Round positions along an axis, and the way to write them.
#[derive(Debug, Clone, PartialEq)]
pub struct Ticks {
    first: i64,
    last: i64,
    mantissa: i64,
    power: i32,
}

impl Ticks {
    /// About `count` round positions (steps of 1, 2 or 5 times a power of ten)
    /// from `low` to `high`; none if the range is empty or not finite.
    pub fn between(low: f64, high: f64, count: usize) -> Self {
        let none = Self {
            first: 0,
            last: -1,
            mantissa: 1,
            power: 0,
        };
        let wanted = (high - low) / count.max(1) as f64;
        if !wanted.is_normal() || wanted < 0.0 || !low.is_finite() || !high.is_finite() {
            return none;
        }
        let mut power = wanted.log10().floor() as i32;
        let rest = wanted / 10_f64.powi(power);
        let mantissa = match rest {
            rest if rest < 1.5 => 1,
            rest if rest < 3.5 => 2,
            rest if rest < 7.5 => 5,
            _ => {
                power += 1;
                1
            }
        };
        let step = mantissa as f64 * 10_f64.powi(power);
        // Ends that are ticks up to round-off belong to the axis.
        let first = (low / step - 1e-9).ceil();
        let last = (high / step + 1e-9).floor();
        if first.abs().max(last.abs()) > 1e15 {
            return none;
        }
        Self {
            first: first as i64,
            last: last as i64,
            mantissa,
            power,
        }
    }

    /// The positions, in rising order \[unit of the axis\].
    pub fn positions(&self) -> impl Iterator<Item = f64> + '_ {
        (self.first..=self.last).map(|k| self.position(k))
    }

    /// Positions with their labels, all with the same number of decimals; large and small
    /// ones all with the same power of ten, the engineers' 10^3, 10^6, ...
    pub fn labeled(&self) -> impl Iterator<Item = (f64, String)> + '_ {
        let largest = (self.first.abs().max(self.last.abs()) * self.mantissa).max(1);
        let digits_before = self.power + (largest as f64).log10().floor() as i32;
        let power = if (-3..6).contains(&digits_before) {
            0
        } else {
            3 * digits_before.div_euclid(3)
        };
        let decimals = (power - self.power).max(0) as usize;
        (self.first..=self.last).map(move |k| {
            let shown = Self {
                power: self.power - power,
                ..*self
            };
            let label = match (k, power) {
                (0, _) => "0".to_owned(),
                (_, 0) => format!("{:.decimals$}", shown.position(k)),
                _ => format!("{:.decimals$}e{power}", shown.position(k)),
            };
            (self.position(k), label)
        })
    }

    /// Whole multiples of a power of ten, so that zero is zero and 0.3 is 0.3.
    fn position(&self, k: i64) -> f64 {
        let whole = (k * self.mantissa) as f64;
        if self.power < 0 {
            whole / 10_f64.powi(-self.power)
        } else {
            whole * 10_f64.powi(self.power)
        }
    }
}

/// Label of a tick at `value` on an axis whose range has the length `span`: at
/// most six digits, no trailing zeros, and never "-0.0".
pub fn tick_label(value: f64, span: f64) -> String {
    if value.abs() <= 1e-6 * span.abs() || value == 0.0 {
        return "0".to_owned();
    }
    let power = value.abs().log10().floor();
    if (-4.0..6.0).contains(&power) {
        let decimals = (5.0 - power).max(0.0) as usize;
        return trimmed(&format!("{value:.decimals$}")).to_owned();
    }
    let text = format!("{value:.5e}");
    match text.split_once('e') {
        Some((mantissa, power)) => format!("{}e{power}", trimmed(mantissa)),
        None => text,
    }
}

fn trimmed(text: &str) -> &str {
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(low: f64, high: f64, count: usize) -> String {
        let labels: Vec<_> = Ticks::between(low, high, count)
            .labeled()
            .map(|t| t.1)
            .collect();
        labels.join(" ")
    }

    #[test]
    fn ticks_are_round_and_zero_has_no_sign() {
        assert_eq!(labels(-0.25, 0.31, 5), "-0.2 -0.1 0 0.1 0.2 0.3");
        assert_eq!(labels(0.0, 1.0, 2), "0 0.5 1.0");
        assert_eq!(labels(-40.0, 95.0, 6), "-40 -20 0 20 40 60 80");
        assert_eq!(labels(0.0, 3e7, 3), "0 10e6 20e6 30e6");
        assert_eq!(labels(0.0, 2e-7, 2), "0 100e-9 200e-9");
        assert_eq!(labels(-4e-4, 2e-4, 3), "-400e-6 -200e-6 0 200e-6");
        assert_eq!(labels(0.0, 2.4e6, 4), "0 0.5e6 1.0e6 1.5e6 2.0e6");
        assert_eq!(labels(0.0, 0.005, 2), "0 0.002 0.004");
    }

    #[test]
    fn empty_and_endless_ranges_have_no_ticks() {
        for (low, high) in [
            (1.0, 1.0),
            (2.0, 1.0),
            (0.0, f64::INFINITY),
            (f64::NAN, 1.0),
        ] {
            assert_eq!(Ticks::between(low, high, 5).positions().count(), 0);
        }
        assert_eq!(Ticks::between(1.0, 1.0 + 1e-15, 5).positions().count(), 0);
    }

    #[test]
    fn labels_have_no_noise_and_no_negative_zero() {
        let cases = [
            (-1e-17, 1.0, "0"),
            (-0.0, 0.0, "0"),
            (0.1 + 0.2, 1.0, "0.3"),
            (-12.5, 30.0, "-12.5"),
            (100_000.0, 1e5, "100000"),
            (2.5e7, 1e8, "2.5e7"),
            (-3e-9, 1e-8, "-3e-9"),
        ];
        for (value, span, expected) in cases {
            assert_eq!(tick_label(value, span), expected);
        }
    }
}
