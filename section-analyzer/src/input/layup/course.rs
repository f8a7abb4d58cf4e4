//! Quantities along the span.
//!
//! Monotone cubics on the interval of length h with v = x - x_i and d = (f_{i+1} - f_i)/h,
//!
//! ```text
//! f = f_i + s_i v + (3 d - 2 s_i - s_{i+1}) v^2/h + (s_i + s_{i+1} - 2 d) v^3/h^2
//! s = (w_- + w_+) / (w_-/d_- + w_+/d_+),  w_- = 2 h_+ + h_-,  w_+ = h_+ + 2 h_-,  if d_- d_+ > 0
//! ```
//!
//! and s = 0 otherwise; at the ends the slope of the first and the last interval.
//!
//! # References
//! - F. N. Fritsch and J. Butland, "A method for constructing local monotone piecewise cubic
//!   interpolants", SIAM Journal on Scientific and Statistical Computing 5, 1984.

use shared_geom::document::schema::KeySchema;
use shared_geom::document::schema::ValueKind::{FreeMatrix, Quantities, Word};
use shared_geom::document::{ByHand, Declared, Table, Value};
use shared_geom::keys;
use shared_geom::units::Dimension;

keys! {
    /// A quantity along the span; outside of its range a layer or web is absent, and all else has
    /// the value of the nearest end.
    pub(super) COURSE = "{ eta = [...], value = [...] }";
    /// Positions along the span, ascending, 0 at the root to 1 at the tip.
    ETA: ByHand = "eta", [Quantities(Dimension::NUMBER)], required, "[0, 0.2, 1]";
    /// The values there.
    VALUE: ByHand = "value", [FreeMatrix], required, "[3.5, 4.6, 1]";
    /// Between the positions: monotone cubics, straight lines, or the value of the position before.
    COURSE_KIND: usize = "course", [Word(&["monotone", "linear", "constant"])],
        or "\"monotone\"" = 0, "\"linear\"";
}

/// How values between positions follow.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Monotone,
    Linear,
    Constant,
}

/// A quantity along the span, in SI units.
#[derive(Debug, Clone, PartialEq)]
pub struct Course {
    eta: Vec<f64>,
    value: Vec<f64>,
    kind: Kind,
}

impl Course {
    /// One value.
    pub fn constant(value: f64) -> Self {
        Self {
            eta: vec![0.0],
            value: vec![value],
            kind: Kind::Constant,
        }
    }

    /// Monotone cubics through values at ascending positions.
    pub fn monotone(eta: Vec<f64>, value: Vec<f64>) -> Self {
        Self {
            eta,
            value,
            kind: Kind::Monotone,
        }
    }

    /// Whether a position is within the table; one value is everywhere.
    pub fn covers(&self, eta: f64) -> bool {
        let last = self.eta.len() - 1;
        last == 0 || (eta >= self.eta[0] - 1e-12 && eta <= self.eta[last] + 1e-12)
    }

    /// The value at a position; beyond the table the value at its end.
    pub fn at(&self, eta: f64) -> f64 {
        let (x, f) = (&self.eta, &self.value);
        let last = x.len() - 1;
        if eta <= x[0] || last == 0 {
            return f[0];
        }
        if eta >= x[last] {
            return f[last];
        }
        let i = x.partition_point(|x| *x <= eta) - 1;
        let (h, v) = (x[i + 1] - x[i], eta - x[i]);
        let d = (f[i + 1] - f[i]) / h;
        match self.kind {
            Kind::Constant => f[i],
            Kind::Linear => f[i] + d * v,
            Kind::Monotone => {
                let (a, b) = (self.slope(i), self.slope(i + 1));
                let square = (3.0 * d - 2.0 * a - b) / h;
                let cube = (a + b - 2.0 * d) / (h * h);
                f[i] + v * (a + v * (square + v * cube))
            }
        }
    }

    /// Slope of the monotone cubics at a position of the table.
    fn slope(&self, i: usize) -> f64 {
        let step = |i: usize| self.eta[i + 1] - self.eta[i];
        let secant = |i: usize| (self.value[i + 1] - self.value[i]) / step(i);
        let last = self.eta.len() - 1;
        if i == 0 || i == last {
            return secant(i.min(last - 1));
        }
        let (before, after) = (secant(i - 1), secant(i));
        if before * after <= 0.0 {
            return 0.0;
        }
        let (low, high) = (step(i - 1), step(i));
        let weights = [2.0 * high + low, high + 2.0 * low];
        (weights[0] + weights[1]) / (weights[0] / before + weights[1] / after)
    }

    /// Positions of the table; none for one value.
    pub fn positions(&self) -> &[f64] {
        match self.eta.len() {
            1 => &[],
            _ => &self.eta,
        }
    }
}

impl Declared for Course {}

impl Value for Course {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        let dimension = key.dimension();
        if !table.is_table(key) {
            return table.quantity(key.name, dimension).map(Self::constant);
        }
        let inner = table.table(key)?.described(&COURSE);
        let eta = inner
            .require_item(&ETA, "positions along the span")
            .and_then(|_| inner.quantities(ETA.name(), Dimension::NUMBER));
        let value = inner
            .require_item(&VALUE, "the values at these positions")
            .and_then(|_| inner.quantities(VALUE.name(), dimension));
        let kind = inner.get(&COURSE_KIND);
        inner.finish();
        let (eta, value, kind) = (eta?, value?, kind?);
        if eta.len() != value.len() || eta.is_empty() {
            let expected = format!("as many values as positions: {} of \"eta\"", eta.len());
            inner.wrong(&VALUE, &expected);
            return None;
        }
        let is_ascending = eta.windows(2).all(|pair| pair[1] > pair[0]);
        if !is_ascending || eta[0] < 0.0 || eta[eta.len() - 1] > 1.0 {
            inner.wrong(&ETA, "ascending positions from 0 to 1");
            return None;
        }
        let kind = [Kind::Monotone, Kind::Linear, Kind::Constant][kind];
        Some(Self { eta, value, kind })
    }
}
