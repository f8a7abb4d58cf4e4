//! The attached part of the chord by a formula.
//!
//! With the incidence a from zero lift,
//!
//! ```text
//! f = 1 - 0.3 exp((|a| - a_1)/S_1)       for |a| <= a_1
//! f = 0.04 + 0.66 exp((a_1 - |a|)/S_2)   beyond
//! ```
//!
//! The slope of f jumps at a_1 and at zero. Here a cubic replaces f within S_2/10 of a_1, and a
//! parabola replaces |a| within a_1/50 of zero, so that the derivative is continuous.
//!
//! # References
//! - J. G. Leishman and T. S. Beddoes, "A semi-empirical model for dynamic stall", Journal of the
//!   American Helicopter Society 34, 1989.

use crate::airfoil::cubic;
use crate::real::Real;

/// Constants of the attached part over the incidence.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Kirchhoff {
    /// Incidence at which the attached part is 0.7, a_1 \[rad\].
    pub break_angle: f64,
    /// Scale of the incidence before it, S_1 \[rad\].
    pub scale_before: f64,
    /// Scale of the incidence beyond it, S_2 \[rad\].
    pub scale_beyond: f64,
}

/// Mach numbers of the published constants.
const MACH: [f64; 7] = [0.3, 0.4, 0.5, 0.6, 0.7, 0.75, 0.8];

/// a_1, S_1 and S_2 of NACA 0012 at these Mach numbers \[deg\].
const NACA0012_DEG: [[f64; 7]; 3] = [
    [15.25, 12.5, 10.5, 8.5, 5.6, 3.5, 0.7],
    [3.0, 3.25, 3.5, 4.0, 4.5, 3.5, 0.7],
    [2.3, 1.6, 1.2, 0.7, 0.5, 0.8, 0.18],
];

impl Kirchhoff {
    /// The published constants of NACA 0012, linear between Mach 0.3 and 0.8, constant outside.
    pub fn naca0012(mach: f64) -> Self {
        let mach = mach.clamp(MACH[0], MACH[6]);
        let i = cubic::interval(&MACH, mach);
        let share = (mach - MACH[i]) / (MACH[i + 1] - MACH[i]);
        let between = |row: [f64; 7]| (row[i] + share * (row[i + 1] - row[i])).to_radians();
        let [break_angle, scale_before, scale_beyond] = NACA0012_DEG.map(between);
        Self {
            break_angle,
            scale_before,
            scale_beyond,
        }
    }

    /// The attached part at an incidence from zero lift in rad.
    pub fn attached<T: Real>(&self, incidence: T) -> T {
        let size = rounded_size(incidence, self.break_angle / 50.0);
        let half = self.scale_beyond / 10.0;
        let from = size - (self.break_angle - half);
        if from.re() <= 0.0 {
            return self.before(size);
        }
        if from.re() >= 2.0 * half {
            return self.beyond(size);
        }
        let (low, high) = (self.break_angle - half, self.break_angle + half);
        let (f_low, f_high) = (self.before(low), self.beyond(high));
        let slope_low = (f_low - 1.0) / self.scale_before;
        let slope_high = (0.04 - f_high) / self.scale_beyond;
        let middle = cubic::hermite(2.0 * half, [f_low, f_high], [slope_low, slope_high]);
        cubic::evaluate(&middle, from)
    }

    fn before<T: Real>(&self, size: T) -> T {
        ((size - self.break_angle) / self.scale_before).exp() * -0.3 + 1.0
    }

    fn beyond<T: Real>(&self, size: T) -> T {
        ((-size + self.break_angle) / self.scale_beyond).exp() * 0.66 + 0.04
    }
}

/// The absolute value, with a parabola within `half` of zero.
fn rounded_size<T: Real>(x: T, half: f64) -> T {
    if x.re() > half {
        x
    } else if x.re() < -half {
        -x
    } else {
        (x * x + half * half) / (2.0 * half)
    }
}
