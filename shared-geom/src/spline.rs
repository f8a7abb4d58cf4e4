//! Natural cubic splines, and piecewise straight lines.
//!
//! On the interval of length h between the points a and b, with second derivatives m, and
//! v the part of the interval before x,
//!
//! ```text
//! f = (1-v) f_a + v f_b - h^2/6 ( ((1-v) - (1-v)^3) m_a + (v - v^3) m_b )
//! h_- m_- + 2 (h_- + h_+) m + h_+ m_+ = 6 (d_+ - d_-),    d = (f_b - f_a)/h,    m = 0 at both ends
//! ```
//!
//! A piecewise straight line has m = 0 everywhere.
//!
//! # References
//! - C. de Boor, "A practical guide to splines", Springer, 1978, chapter IV.

/// A natural cubic spline, or a piecewise straight line, through points of strictly
/// increasing abscissa.
#[derive(Debug, Clone, PartialEq)]
pub struct Spline {
    x: Vec<f64>,
    f: Vec<f64>,
    /// Second derivatives at the points.
    m: Vec<f64>,
}

impl Spline {
    /// The spline of the values `f` at `x`.
    pub fn new(x: &[f64], f: &[f64]) -> Self {
        Self {
            x: x.to_vec(),
            f: f.to_vec(),
            m: second_derivatives(x, f),
        }
    }

    /// The piecewise straight line of the values `f` at `x`.
    pub fn straight(x: &[f64], f: &[f64]) -> Self {
        Self {
            x: x.to_vec(),
            f: f.to_vec(),
            m: vec![0.0; x.len()],
        }
    }

    /// Abscissas of the points, ascending.
    pub fn positions(&self) -> &[f64] {
        &self.x
    }

    /// Values at the points.
    pub fn values(&self) -> &[f64] {
        &self.f
    }

    /// The interval in which `x` is; beyond the ends the first or the last.
    pub fn interval(&self, x: f64) -> usize {
        let after = self.x.partition_point(|position| *position <= x);
        after.clamp(1, self.x.len().max(2) - 1) - 1
    }

    /// Value at `x` in the interval `i`.
    pub fn value(&self, i: usize, x: f64) -> f64 {
        let h = self.x[i + 1] - self.x[i];
        let v = (x - self.x[i]) / h;
        let u = 1.0 - v;
        let bent = (u - u * u * u) * self.m[i] + (v - v * v * v) * self.m[i + 1];
        u * self.f[i] + v * self.f[i + 1] - h * h / 6.0 * bent
    }

    /// Slope at `x` in the interval `i`.
    pub fn slope(&self, i: usize, x: f64) -> f64 {
        let h = self.x[i + 1] - self.x[i];
        let v = (x - self.x[i]) / h;
        let u = 1.0 - v;
        let bent = (3.0 * u * u - 1.0) * self.m[i] + (1.0 - 3.0 * v * v) * self.m[i + 1];
        (self.f[i + 1] - self.f[i]) / h - h / 6.0 * bent
    }

    /// Second derivative at `x` in the interval `i`.
    pub fn bend(&self, i: usize, x: f64) -> f64 {
        let v = (x - self.x[i]) / (self.x[i + 1] - self.x[i]);
        (1.0 - v) * self.m[i] + v * self.m[i + 1]
    }

    /// Integral from the beginning of the interval `i` to `x` in it.
    pub fn integral(&self, i: usize, x: f64) -> f64 {
        let h = self.x[i + 1] - self.x[i];
        let v = (x - self.x[i]) / h;
        let [u_square, v_square] = [(1.0 - v) * (1.0 - v), v * v];
        let of_first = 0.25 - 0.5 * u_square + 0.25 * u_square * u_square;
        let of_last = 0.5 * v_square - 0.25 * v_square * v_square;
        let bent = of_first * self.m[i] + of_last * self.m[i + 1];
        let straight = (v - 0.5 * v_square) * self.f[i] + 0.5 * v_square * self.f[i + 1];
        h * (straight - h * h / 6.0 * bent)
    }
}

/// The tridiagonal system by elimination; it is diagonally dominant.
fn second_derivatives(x: &[f64], f: &[f64]) -> Vec<f64> {
    let n = x.len();
    let mut m = vec![0.0; n];
    // For each inner row after elimination: the entry after the diagonal, and m itself.
    let mut behind = vec![0.0; n];
    for i in 1..n.saturating_sub(1) {
        let (before, after) = (x[i] - x[i - 1], x[i + 1] - x[i]);
        let kink = (f[i + 1] - f[i]) / after - (f[i] - f[i - 1]) / before;
        let pivot = 2.0 * (before + after) - before * behind[i - 1];
        behind[i] = after / pivot;
        m[i] = (6.0 * kink - before * m[i - 1]) / pivot;
    }
    for i in (1..n.saturating_sub(1)).rev() {
        m[i] -= behind[i] * m[i + 1];
    }
    m
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A straight line and a natural spline through three points, whose middle second
    /// derivative is -3 d for the values 0, d, 0 at -1, 0, 1: `f = d (1 - 3/2 x^2 + 1/2 |x|^3)`,
    /// with the integral `d (1 - 1/2 + 1/8)` over each half.
    #[test]
    fn integrals_are_those_of_the_closed_form() {
        let (x, f) = ([-1.0, 0.0, 1.0], [0.0, 2.0, 0.0]);
        let spline = Spline::new(&x, &f);
        let straight = Spline::straight(&x, &f);
        for (i, end) in [(0, 0.0), (1, 1.0)] {
            assert!((spline.integral(i, end) - 1.25).abs() < 1e-15);
            assert!((straight.integral(i, end) - 1.0).abs() < 1e-15);
        }
        assert!((spline.value(1, 0.5) - 2.0 * (1.0 - 0.375 + 0.0625)).abs() < 1e-15);
        assert!((straight.value(1, 0.5) - 1.0).abs() < 1e-15);
        for (position, interval) in [(-3.0, 0), (-1.0, 0), (0.0, 1), (0.7, 1), (5.0, 1)] {
            assert_eq!(spline.interval(position), interval);
        }
    }
}
