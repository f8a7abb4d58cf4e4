//! Prediction of a step from the two previous states.

/// The previous states of a step, as changes from the latest accepted state.
#[derive(Debug)]
pub(super) struct Past {
    /// Rates of the latest state.
    pub latest_rates: Vec<f64>,
    /// The previous state.
    pub before: Vec<f64>,
    /// Its rates.
    pub rates_before: Vec<f64>,
}

impl Past {
    /// Buffers for `size` unknowns.
    pub fn new(size: usize) -> Self {
        Self {
            latest_rates: vec![0.0; size],
            before: vec![0.0; size],
            rates_before: vec![0.0; size],
        }
    }

    /// Rates of the cubic through both states, at s steps of length h from the latest;
    /// with r = h / h_{n-1} and tau = s r,
    ///
    /// ```text
    /// y' = 6 tau (1 + tau) ( y_{n-2} - y_{n-1} ) / h_{n-1}
    ///    + (1 + tau)(1 + 3 tau) y'_{n-1} + tau (2 + 3 tau) y'_{n-2}                 (D-104)
    /// ```
    pub fn rates(&self, tau: f64, length_before: f64, out: &mut [f64]) {
        let by_value = 6.0 * tau * (1.0 + tau) / length_before;
        let by_latest = (1.0 + tau) * (1.0 + 3.0 * tau);
        let by_before = tau * (2.0 + 3.0 * tau);
        for (i, out) in out.iter_mut().enumerate() {
            *out = by_value * self.before[i]
                + by_latest * self.latest_rates[i]
                + by_before * self.rates_before[i];
        }
    }

    /// The polynomial of degree `order` (1 to 3) through the latest state and its rates, then the
    /// state before it, then that state's rates, at the end of a step of length h and ratio r:
    ///
    /// ```text
    /// 1:  y_{n-1} + h y'_{n-1}
    /// 2:  (1 - r^2) y_{n-1} + r^2 y_{n-2} + h (1 + r) y'_{n-1}
    /// 3:  the cubic of (D-104)                                                      (D-114)
    /// ```
    pub fn value(&self, order: usize, length: f64, ratio: f64, i: usize) -> f64 {
        let r = ratio;
        let slope = length * self.latest_rates[i];
        match order {
            1 => slope,
            2 => r * r * self.before[i] + (1.0 + r) * slope,
            _ => {
                r * r * (3.0 + 2.0 * r) * self.before[i]
                    + (1.0 + r).powi(2) * slope
                    + r * (1.0 + r) * length * self.rates_before[i]
            }
        }
    }
}

/// Error `y(t_n) - y = C h^(p+1) d^(p+1)y/dt^(p+1)` of the polynomial of degree p (1 to 3)
/// that [`Past::value`] extends: the product of the distances from its points,
///
/// ```text
/// C = 1/2 ,  (1 + 1/r) / 6 ,  (1 + 1/r)^2 / 24                                      (D-115)
/// ```
pub(super) fn error_of_value(order: usize, ratio: f64) -> f64 {
    let away = 1.0 + 1.0 / ratio;
    match order {
        1 => 0.5,
        2 => away / 6.0,
        _ => away * away / 24.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 1 + t + t^2 + t^3 around t = 0, its change from there, and its rate.
    fn cubic(t: f64) -> [f64; 2] {
        [t + t * t + t.powi(3), 1.0 + 2.0 * t + 3.0 * t * t]
    }

    fn past(length_before: f64) -> Past {
        let [before, rate] = cubic(-length_before);
        Past {
            latest_rates: vec![1.0],
            before: vec![before],
            rates_before: vec![rate],
        }
    }

    /// A cubic is predicted exactly, inside and at the end of the step, for any ratio.
    #[test]
    fn cubics_are_predicted_exactly() {
        for ratio in [0.5, 1.0, 1.2, 2.0] {
            let (length, before) = (0.3, 0.3 / ratio);
            for part in [0.25, 1.0] {
                let mut rates = [0.0];
                past(before).rates(part * ratio, before, &mut rates);
                let expected = cubic(part * length)[1];
                assert!((rates[0] - expected).abs() < 1e-13);
            }
            let found = past(before).value(3, length, ratio, 0);
            assert!((found - cubic(length)[0]).abs() < 1e-14);
        }
    }

    /// The line misses t^2 by 2 h^2 / 2 and the parabola misses t^3 by 6 h^3 C; degree 2 follows
    /// the other terms of the cubic exactly, and degree 1 follows t.
    #[test]
    fn lower_degrees_miss_by_their_constants() {
        let (length, ratio): (f64, f64) = (0.3, 1.5);
        let past = past(length / ratio);
        let missed = |order| cubic(length)[0] - past.value(order, length, ratio, 0);
        let second = 6.0 * error_of_value(2, ratio) * length.powi(3);
        assert!((missed(2) - second).abs() < 1e-15);
        let line = 2.0 * error_of_value(1, ratio) * length.powi(2) + length.powi(3);
        assert!((missed(1) - line).abs() < 1e-15);
    }
}
