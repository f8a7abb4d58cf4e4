//! The static coefficients of a strip, with their split into attached and separated flow.
//!
//! Tables are evaluated with their derivatives by their own variables x alone, and these are
//! multiplied by the derivatives of the variables:
//!
//! ```text
//! c = c(re x) + c_x (x - re x)
//! ```

use num_dual::Dual64;

use crate::airfoil::{Coefficients, Flow, FlowNumber, Section, Separation};
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

    /// The section.
    pub fn section(&self) -> &Section {
        &self.section
    }

    /// The same with a part of its lift \[-\].
    pub fn with_lift(self, lift: f64) -> Self {
        Self { lift, ..self }
    }
}

impl Polar for StripPolar {
    fn coefficients<T: Real>(&self, flow: &Flow<T>) -> Coefficients<T> {
        if is_alone::<T>() {
            let all = self.section.at(flow);
            return Coefficients {
                lift: all.lift * self.lift,
                ..all
            };
        }
        let found = self.section.slopes(&values(flow));
        Coefficients {
            lift: along(found.lift, flow) * self.lift,
            drag: along(found.drag, flow),
            moment: along(found.moment, flow),
        }
    }

    fn drag<T: Real>(&self, flow: &Flow<T>) -> T {
        if is_alone::<T>() {
            T::from(self.section.drag(&values(flow)))
        } else {
            along(self.section.drag_slopes(&values(flow)), flow)
        }
    }

    fn attached<T: Real>(&self, alpha: T) -> T {
        if is_alone::<T>() {
            self.separation.attached(alpha)
        } else {
            of_angle(|alpha| self.separation.attached(alpha), alpha)
        }
    }

    fn separated_lift<T: Real>(&self, alpha: T) -> T {
        let all = if is_alone::<T>() {
            self.separation.separated_lift(alpha)
        } else {
            of_angle(|alpha| self.separation.separated_lift(alpha), alpha)
        };
        all * self.lift
    }

    fn slope(&self) -> f64 {
        self.separation.slope * self.lift
    }

    fn zero_lift(&self) -> f64 {
        self.separation.zero_lift
    }
}

/// The values of a flow.
fn values<T: Real>(flow: &Flow<T>) -> Flow<f64> {
    Flow {
        alpha: flow.alpha.re(),
        mach: flow.mach.re(),
        reynolds: flow.reynolds.re(),
        flap: flow.flap.re(),
    }
}

/// A value of a table with the derivatives of a flow.
fn along<T: Real>(found: FlowNumber, flow: &Flow<T>) -> T {
    let mut sum = T::from(found.re);
    let slopes = found.eps.0.iter().flat_map(|slopes| slopes.iter());
    let numbers = [flow.alpha, flow.mach, flow.reynolds, flow.flap];
    for (number, slope) in numbers.iter().zip(slopes) {
        // Most tables do not depend on most of the numbers.
        if *slope != 0.0 {
            sum += (*number - number.re()) * *slope;
        }
    }
    sum
}

/// Whether a number has no derivatives.
fn is_alone<T: Real>() -> bool {
    size_of::<T>() == size_of::<f64>()
}

/// A function of the angle of attack alone, with the derivatives of the angle.
fn of_angle<T: Real>(of: impl Fn(Dual64) -> Dual64, alpha: T) -> T {
    let found = of(Dual64::from_re(alpha.re()).derivative());
    T::from(found.re) + (alpha - alpha.re()) * found.eps
}
