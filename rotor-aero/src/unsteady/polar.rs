//! The static coefficients that a section model needs.

use crate::airfoil::{Coefficients, Flow};
use crate::real::Real;

/// Static coefficients of an airfoil, and their split into attached and separated flow.
///
/// The split is `cl = f slope (alpha - zero_lift) + (1 - f) separated_lift(alpha)`, where
/// `f = attached(alpha)` is the part of the chord with attached flow.
pub trait Polar {
    /// The static coefficients.
    fn coefficients<T: Real>(&self, flow: &Flow<T>) -> Coefficients<T>;

    /// The static drag coefficient alone.
    fn drag<T: Real>(&self, flow: &Flow<T>) -> T;

    /// The part of the chord with attached flow, from 0 to 1, at an angle of attack in rad.
    fn attached<T: Real>(&self, alpha: T) -> T;

    /// The lift coefficient of separated flow at an angle of attack in rad.
    fn separated_lift<T: Real>(&self, alpha: T) -> T;

    /// The slope of the lift coefficient in attached flow \[1/rad\].
    fn slope(&self) -> f64;

    /// The angle of attack without lift \[rad\].
    fn zero_lift(&self) -> f64;
}

impl<P: Polar> Polar for &P {
    fn coefficients<T: Real>(&self, flow: &Flow<T>) -> Coefficients<T> {
        (**self).coefficients(flow)
    }

    fn drag<T: Real>(&self, flow: &Flow<T>) -> T {
        (**self).drag(flow)
    }

    fn attached<T: Real>(&self, alpha: T) -> T {
        (**self).attached(alpha)
    }

    fn separated_lift<T: Real>(&self, alpha: T) -> T {
        (**self).separated_lift(alpha)
    }

    fn slope(&self) -> f64 {
        (**self).slope()
    }

    fn zero_lift(&self) -> f64 {
        (**self).zero_lift()
    }
}
