//! Cycles of a history by rainflow counting, and the amplitude of equal damage.
//!
//! A range Y between two reversals is a cycle as soon as the next range X is not smaller; it is
//! half a cycle if it contains the first point that is left, and so are the ranges that remain at
//! the end. With n_i cycles of range R_i and the Woehler exponent m
//!
//! ```text
//! R_eq = (sum n_i R_i^m / n_eq)^(1/m)
//! ```
//!
//! # References
//! - ASTM E1049-85, "Standard practices for cycle counting in fatigue analysis", 5.4.4.

/// Equal cycles, or half of one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cycle {
    /// Largest minus smallest value [unit of the history].
    pub range: f64,
    /// Mean of both [unit of the history].
    pub mean: f64,
    /// One, or a half [-].
    pub count: f64,
}

/// The cycles of a history; values that are not finite are left out.
pub fn cycles(history: impl IntoIterator<Item = f64>) -> Vec<Cycle> {
    let mut counted = Vec::new();
    let mut open: Vec<f64> = Vec::new();
    for value in reversals(history) {
        open.push(value);
        while let [.., a, b, c] = open[..] {
            if (c - b).abs() < (b - a).abs() {
                break;
            }
            let last = open.len();
            if last == 3 {
                counted.push(cycle(a, b, 0.5));
                open.remove(0);
            } else {
                counted.push(cycle(a, b, 1.0));
                open.drain(last - 3..last - 1);
            }
        }
    }
    counted.extend(open.windows(2).map(|pair| cycle(pair[0], pair[1], 0.5)));
    counted
}

fn cycle(a: f64, b: f64, count: f64) -> Cycle {
    Cycle {
        range: (b - a).abs(),
        mean: 0.5 * (a + b),
        count,
    }
}

/// First and last value, and the turns between them.
fn reversals(history: impl IntoIterator<Item = f64>) -> Vec<f64> {
    let mut found: Vec<f64> = Vec::new();
    for value in history.into_iter().filter(|value| value.is_finite()) {
        if found.last() == Some(&value) {
            continue;
        }
        match found[..] {
            [.., before, last] if (value - last) * (last - before) > 0.0 => {
                found.pop();
            }
            _ => {}
        }
        found.push(value);
    }
    found
}

/// The range of `equal` equal cycles with the damage of `cycles`; zero without cycles.
pub fn equivalent_range(cycles: &[Cycle], exponent: f64, equal: f64) -> f64 {
    let largest = cycles
        .iter()
        .fold(0.0, |most: f64, cycle| most.max(cycle.range));
    if largest == 0.0 || equal <= 0.0 {
        return 0.0;
    }
    // ranges relative to the largest: no overflow
    let damage = cycles
        .iter()
        .map(|cycle| cycle.count * (cycle.range / largest).powf(exponent));
    largest * (damage.sum::<f64>() / equal).powf(1.0 / exponent)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counts(history: &[f64]) -> Vec<(f64, f64)> {
        let mut sums: Vec<(f64, f64)> = Vec::new();
        for cycle in cycles(history.iter().copied()) {
            match sums.iter_mut().find(|known| known.0 == cycle.range) {
                Some(known) => known.1 += cycle.count,
                None => sums.push((cycle.range, cycle.count)),
            }
        }
        sums.sort_by(|a, b| a.0.total_cmp(&b.0));
        sums
    }

    /// The example of the standard, figure 6, with its table of counts; points between the
    /// reversals change nothing.
    #[test]
    fn example_of_the_standard() {
        let reversals = [-2.0, 1.0, -3.0, 5.0, -1.0, 3.0, -4.0, 4.0, -2.0];
        let expected = [(3.0, 0.5), (4.0, 1.5), (6.0, 0.5), (8.0, 1.0), (9.0, 0.5)];
        assert_eq!(counts(&reversals), expected);
        let mut fine = vec![reversals[0]];
        for pair in reversals.windows(2) {
            fine.extend([0.3, 0.3, 0.7].map(|part| pair[0] + part * (pair[1] - pair[0])));
            fine.push(pair[1]);
        }
        assert_eq!(counts(&fine), expected);
        assert!(cycles([]).is_empty() && cycles([1.0, 1.0, f64::NAN]).is_empty());
    }

    /// A hundred periods of one amplitude: the equivalent range of as many cycles is the range,
    /// of n times as many smaller by n^(1/m).
    #[test]
    fn equal_cycles_are_their_own_equivalent() {
        let wave = (0..=400).map(|i| 3.0 + [0.0, 2.0, 0.0, -2.0][i % 4]);
        let cycles = cycles(wave);
        // a quarter at the start and three quarters at the end are halves of other ranges
        for exponent in [3.0, 10.0] {
            let range = equivalent_range(&cycles, exponent, 100.0);
            assert!((range / 4.0 - 1.0).abs() < 0.01 / exponent, "{range}");
            let many = equivalent_range(&cycles, exponent, 1e4);
            assert!((many / range * 100.0_f64.powf(1.0 / exponent) - 1.0).abs() < 1e-12);
        }
        assert_eq!(equivalent_range(&[], 4.0, 1.0), 0.0);
    }

    /// 300 random histories: two halves for each range between reversals, none larger than the
    /// largest difference, which is counted; scaled and shifted histories have scaled cycles.
    #[test]
    fn random_histories_keep_their_ranges() {
        let mut state = 3_u64;
        let mut random = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 40) as f64 - 8e6
        };
        for length in 2..302 {
            let history: Vec<f64> = (0..length).map(|_| random()).collect();
            let found = cycles(history.iter().copied());
            let halves: f64 = found.iter().map(|cycle| 2.0 * cycle.count).sum();
            assert_eq!(
                halves as usize,
                reversals(history.iter().copied()).len() - 1
            );
            let (low, high) = history
                .iter()
                .fold((f64::MAX, f64::MIN), |(low, high), value| {
                    (low.min(*value), high.max(*value))
                });
            let most = found
                .iter()
                .fold(0.0, |most: f64, cycle| most.max(cycle.range));
            assert_eq!(most, high - low);
            let moved = cycles(history.iter().map(|value| 2.0 * value - 16.0));
            let is_scaled = |(a, b): (&Cycle, &Cycle)| {
                b.range == 2.0 * a.range && b.mean == 2.0 * a.mean - 16.0 && a.count == b.count
            };
            assert!(found.len() == moved.len() && found.iter().zip(&moved).all(is_scaled));
        }
    }
}
