//! Natural cubic splines.
//!
//! On the interval of length h between the points a and b, with second derivatives m,
//! and v the part of the interval behind x,
//!
//! ```text
//! f = (1-v) f_a + v f_b - h^2/6 ( ((1-v) - (1-v)^3) m_a + (v - v^3) m_b )
//! h_- m_- + 2 (h_- + h_+) m + h_+ m_+ = 6 (d_+ - d_-),    d = (f_b - f_a)/h,    m = 0 at both ends
//! ```
//!
//! # References
//! - C. de Boor, "A practical guide to splines", Springer, 1978, chapter IV.

/// A natural cubic spline through points of strictly growing abscissa.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Spline {
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
}

/// The tridiagonal system by elimination; it is diagonally dominant.
fn second_derivatives(x: &[f64], f: &[f64]) -> Vec<f64> {
    let n = x.len();
    let mut m = vec![0.0; n];
    // Of each inner row after elimination: the entry behind the diagonal, and m itself.
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
