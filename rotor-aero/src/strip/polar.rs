//! The static coefficients of a strip, with their split into attached and separated flow.

use crate::airfoil::{Coefficients, Flow, Section, Separation};
use crate::real::Real;
use crate::unsteady::Polar;

/// Reynolds number at which the lift is split: steady lift does not depend on the split \[-\].
const REYNOLDS: f64 = 3e6;

/// Section and split of its lift.
#[derive(Debug, Clone)]
pub(super) struct StripPolar {
    section: Section,
    separation: Separation,
    /// Part of the lift \[-\].
    lift: f64,
}

impl StripPolar {
    /// The split at Mach zero and a large Reynolds number.
    pub fn new(section: Section) -> Self {
        let separation = Separation::of(&section, 0.0, REYNOLDS);
        Self {
            section,
            separation,
            lift: 1.0,
        }
    }

    /// The same with a part of its lift \[-\].
    pub fn with_lift(self, lift: f64) -> Self {
        Self { lift, ..self }
    }
}

impl Polar for StripPolar {
    fn coefficients<T: Real>(&self, flow: &Flow<T>) -> Coefficients<T> {
        let all = self.section.at(flow);
        Coefficients {
            lift: all.lift * self.lift,
            ..all
        }
    }

    fn attached<T: Real>(&self, alpha: T) -> T {
        self.separation.attached(alpha)
    }

    fn separated_lift<T: Real>(&self, alpha: T) -> T {
        self.separation.separated_lift(alpha) * self.lift
    }

    fn slope(&self) -> f64 {
        self.separation.slope * self.lift
    }

    fn zero_lift(&self) -> f64 {
        self.separation.zero_lift
    }
}
