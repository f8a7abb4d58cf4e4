//! The static coefficients of a strip, with their split into attached and separated flow.
//!
//! Tables are evaluated with their derivatives by their own variables x alone, and these are
//! multiplied by the derivatives of the variables:
//!
//! ```text
//! c = c(re x) + c_x (x - re x)
//! ```

use num_dual::Dual64;

use crate::airfoil::{Coefficients, Flow, FlowNumber, Kirchhoff, Section, Separation};
use crate::real::Real;
use crate::unsteady::{OF_FORMULA, OF_SPLIT, Polar, SectionModel};

/// Reynolds number at which the lift is split: steady lift does not depend on the split \[-\].
const REYNOLDS: f64 = 3e6;

/// Least slope of a file that is used \[1/rad\]: sections without lift state none.
const LEAST_SLOPE: f64 = 0.5;

/// Section and split of its lift.
#[derive(Debug, Clone)]
pub(super) struct StripPolar {
    section: Section,
    separation: Separation,
    /// Part of the lift \[-\].
    lift: f64,
}

impl StripPolar {
    /// The split at Mach zero and a large Reynolds number, with the slope and the angle of zero lift of
    /// the files of the airfoils if they state them; if the model allows it, also by the angle of
    /// separation and its scales.
    pub fn new(section: Section, model: &SectionModel) -> Self {
        let measured = Separation::of(&section, 0.0, REYNOLDS);
        let [zero_lift, slope] = OF_SPLIT;
        let zero_lift = section.constant(zero_lift, measured.zero_lift.to_degrees());
        let slope = section.constant(slope, measured.slope);
        let slope = slope.filter(|slope| *slope >= LEAST_SLOPE && measured.slope > 0.0);
        let own = zero_lift.is_some() || slope.is_some();
        let line = [
            slope.unwrap_or(measured.slope),
            zero_lift.map_or(measured.zero_lift, f64::to_radians),
        ];
        let formula = model.has_formula().then(|| formula(&section, line[1]));
        let separation = match formula.flatten() {
            Some(law) => Separation::kirchhoff(law, line[0], line[1]),
            None if own => Separation::of_line(&section, [0.0, REYNOLDS], line),
            None => measured,
        };
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

/// The attached part by the constants of a section with an angle of zero lift \[rad\], if it states all.
fn formula(section: &Section, zero_lift: f64) -> Option<Kirchhoff> {
    let [angle, before, beyond] = OF_FORMULA.map(|name| {
        let found = section.constant(name, 0.0)?;
        Some(found.to_radians())
    });
    let law = Kirchhoff {
        break_angle: angle? - zero_lift,
        scale_before: before?,
        scale_beyond: beyond?,
    };
    let sizes = [law.break_angle, law.scale_before, law.scale_beyond];
    sizes.iter().all(|size| *size > 0.0).then_some(law)
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
