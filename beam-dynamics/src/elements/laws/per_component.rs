//! Laws of a single component: polynomial and two slopes.

/// `f = k_1 e + k_2 |e| e + k_3 e^3`: odd, equal in tension and compression.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Cubic {
    /// k_1 [unit of force / unit of strain].
    pub first: f64,
    /// k_2 [unit of force / unit of strain^2].
    pub second: f64,
    /// k_3 [unit of force / unit of strain^3].
    pub third: f64,
}

impl Cubic {
    /// Force and slope at a strain.
    pub fn at(&self, e: f64) -> (f64, f64) {
        let size = e.abs();
        (
            e * (self.first + size * (self.second + size * self.third)),
            self.first + size * (2.0 * self.second + 3.0 * size * self.third),
        )
    }

    /// Energy `1/2 k_1 e^2 + 1/3 k_2 |e|^3 + 1/4 k_3 e^4`.
    pub fn energy(&self, e: f64) -> f64 {
        let size = e.abs();
        e * e * (self.first / 2.0 + size * (self.second / 3.0 + size * self.third / 4.0))
    }
}

/// Two slopes, elastic: there is no hysteresis, unloading follows the same line.
///
/// ```text
/// f = k_1 e                                     |e| <= e_1
/// f = sign(e) [ k_1 e_1 + k_2 (|e| - e_1) ]     |e| >  e_1
/// ```
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Bilinear {
    /// k_1 [unit of force / unit of strain].
    pub first: f64,
    /// k_2 [unit of force / unit of strain].
    pub second: f64,
    /// e_1, zero or more [unit of strain].
    pub limit: f64,
}

impl Bilinear {
    /// Force and slope at a strain; at the limit the first slope.
    pub fn at(&self, e: f64) -> (f64, f64) {
        let beyond = e.abs() - self.limit;
        if beyond <= 0.0 {
            return (self.first * e, self.first);
        }
        let size = self.first * self.limit + self.second * beyond;
        (size * e.signum(), self.second)
    }

    /// Energy: the area below the line.
    pub fn energy(&self, e: f64) -> f64 {
        let beyond = e.abs() - self.limit;
        if beyond <= 0.0 {
            return 0.5 * self.first * e * e;
        }
        let corner = self.first * self.limit;
        0.5 * corner * self.limit + beyond * (corner + 0.5 * self.second * beyond)
    }
}
