//! Static coefficients in closed form.

use crate::airfoil::{Coefficients, Flow};
use crate::real::Real;
use crate::unsteady::Polar;

/// Attached flow at all angles, `cl = slope sin alpha`.
pub struct Linear {
    pub slope: f64,
}

impl Polar for Linear {
    fn coefficients<T: Real>(&self, flow: &Flow<T>) -> Coefficients<T> {
        Coefficients {
            lift: flow.alpha.sin() * self.slope,
            drag: T::zero(),
            moment: T::zero(),
        }
    }

    fn drag<T: Real>(&self, flow: &Flow<T>) -> T {
        self.coefficients(flow).drag
    }

    fn attached<T: Real>(&self, _alpha: T) -> T {
        T::one()
    }

    fn separated_lift<T: Real>(&self, alpha: T) -> T {
        alpha.sin() * (0.5 * self.slope)
    }

    fn slope(&self) -> f64 {
        self.slope
    }

    fn zero_lift(&self) -> f64 {
        0.0
    }
}

/// NACA 0012 at Mach .3 after Kirchhoff, with the published constants.
pub struct Naca0012 {
    /// Whether the attached part is found from the lift, as for a table.
    pub from_lift: bool,
    /// Drag without lift [-].
    pub least_drag: f64,
}

const NORMAL_SLOPE: f64 = 0.113 * 180.0 / std::f64::consts::PI;
const LIFT_SLOPE: f64 = 6.468;

impl Naca0012 {
    fn kirchhoff_part<T: Real>(alpha: T) -> T {
        let size = alpha.abs().to_degrees_of();
        if size.re() <= 15.25 {
            return -((size - 15.25) / 3.0).exp() * 0.3 + 1.0;
        }
        ((-size + 15.25) / 2.3).exp() * 0.66 + 0.04
    }

    fn lift<T: Real>(alpha: T) -> T {
        let [normal, chordwise] = Self::axes(alpha);
        normal * alpha.cos() + chordwise * alpha.sin()
    }

    fn axes<T: Real>(alpha: T) -> [T; 2] {
        let root = Self::kirchhoff_part(alpha).sqrt();
        let half = (root + 1.0) * 0.5;
        let normal = alpha * half * half * NORMAL_SLOPE;
        [normal, alpha * alpha * root * (0.965 * NORMAL_SLOPE)]
    }
}

/// Degrees of a number.
trait Degrees {
    fn to_degrees_of(self) -> Self;
}

impl<T: Real> Degrees for T {
    fn to_degrees_of(self) -> Self {
        self * (180.0 / std::f64::consts::PI)
    }
}

impl Polar for Naca0012 {
    fn coefficients<T: Real>(&self, flow: &Flow<T>) -> Coefficients<T> {
        let [normal, chordwise] = Self::axes(flow.alpha);
        let (sin, cos) = flow.alpha.sin_cos();
        Coefficients {
            lift: normal * cos + chordwise * sin,
            drag: normal * sin - chordwise * cos + self.least_drag,
            moment: T::zero(),
        }
    }

    fn drag<T: Real>(&self, flow: &Flow<T>) -> T {
        self.coefficients(flow).drag
    }

    fn attached<T: Real>(&self, alpha: T) -> T {
        if !self.from_lift {
            return Self::kirchhoff_part(alpha);
        }
        if alpha.re().abs() < 1e-6 {
            return T::one();
        }
        let ratio = Self::lift(alpha) / (alpha * LIFT_SLOPE);
        if ratio.re() >= 1.0 {
            return T::one();
        }
        if ratio.re() <= 0.25 {
            return T::zero();
        }
        let root = ratio.sqrt() * 2.0 - 1.0;
        root * root
    }

    fn separated_lift<T: Real>(&self, alpha: T) -> T {
        let part = self.attached(alpha);
        let lift = Self::lift(alpha);
        if part.re() > 0.999_999 {
            return lift * 0.5;
        }
        (lift - alpha * part * LIFT_SLOPE) / (-part + 1.0)
    }

    fn slope(&self) -> f64 {
        if self.from_lift {
            LIFT_SLOPE
        } else {
            NORMAL_SLOPE
        }
    }

    fn zero_lift(&self) -> f64 {
        0.0
    }
}

/// A cambered section that stalls near 15 deg, periodic and infinitely smooth.
pub struct Smooth;

impl Polar for Smooth {
    fn coefficients<T: Real>(&self, flow: &Flow<T>) -> Coefficients<T> {
        let part = self.attached(flow.alpha);
        let (sin, cos) = (flow.alpha + 0.05).sin_cos();
        let mach = flow.mach * flow.mach;
        let lift = part * sin * self.slope() + (-part + 1.0) * self.separated_lift(flow.alpha);
        Coefficients {
            lift: lift * (mach * 0.5 + 1.0) + flow.flap * cos,
            drag: (-cos * cos + 1.0) * 1.8 + 0.01 + mach * 0.02,
            moment: sin * cos * (-0.2) - flow.flap * 0.3 - flow.reynolds * 1e-9,
        }
    }

    fn drag<T: Real>(&self, flow: &Flow<T>) -> T {
        self.coefficients(flow).drag
    }

    fn attached<T: Real>(&self, alpha: T) -> T {
        let sin = alpha.sin();
        let half = (-sin * sin + 0.07) / 0.015 * 0.5;
        (half.tanh() + 1.0) * 0.5
    }

    fn separated_lift<T: Real>(&self, alpha: T) -> T {
        (alpha * 2.0).sin() * 0.9
    }

    fn slope(&self) -> f64 {
        6.1
    }

    fn zero_lift(&self) -> f64 {
        -0.05
    }
}
