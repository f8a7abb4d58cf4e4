//! The split of a static lift curve into attached and separated flow.
//!
//! With the lift c_i of attached flow, the part f of the chord with attached flow, and the lift
//! c_s of separated flow,
//!
//! ```text
//! c_i = s (alpha - alpha_0),   c_l = f c_i + (1 - f) c_s
//! f = (2 sqrt(c_l/c_i) - 1)^2, at most 1;   f = 0 beyond the first angle at which c_l/c_i = 1/4
//! c_s = (c_l - f c_i)/(1 - f) = c_i (1 + 3 sqrt f)/(4 (1 + sqrt f)),   c_l/2 if f = 1
//! ```
//!
//! f fades to zero between 40 and 45 deg, on each side where it is less than 0.7 at 40 deg: the lift of airfoils
//! without stall rises further. alpha_0 is the rising zero of the lift
//! that is nearest to zero; s is the least-squares slope through it, over 5 deg on both sides.
//! Both curves are monotone cubics through samples, every half degree up to 50 deg: derivatives
//! are continuous.
//!
//! # References
//! - M. H. Hansen, M. Gaunaa, H. A. Madsen, "A Beddoes-Leishman type dynamic stall model in
//!   state-space and indicial formulations", Risoe-R-1354, 2004.

mod kirchhoff;

pub use kirchhoff::Kirchhoff;

use std::f64::consts::PI;

use super::cubic::{self, Cubic, Ends};
use super::data::Flow;
use super::evaluated::Profile;
use super::formula::faded;
use super::surface::wrapped;
use crate::real::Real;

/// Steps of the samples up to 50 deg, and beyond \[deg\].
const STEPS_DEG: [f64; 2] = [0.5, 2.5];

/// Number of fine steps, and of all steps, on one side.
const STEPS: [u32; 2] = [100, 152];

/// Angles at which the fade of attached flow begins and ends \[deg\].
const FADE_DEG: [f64; 2] = [40.0, 45.0];

/// Part of the chord with attached flow at the first of these angles, from which on a side has no stall \[-\].
const UNSTALLED: f64 = 0.7;

/// Range of the fit on both sides of zero lift \[deg\].
const FIT_DEG: f64 = 5.0;

/// Smallest slope of a section with attached flow \[1/rad\].
const LEAST_SLOPE: f64 = 0.5;

/// Attached and separated lift of a section at one Mach and Reynolds number.
#[derive(Debug, Clone, PartialEq)]
pub struct Separation {
    /// Slope of the lift of attached flow; zero for a section that has none, such as a
    /// cylinder \[1/rad\].
    pub slope: f64,
    /// Angle of attack without lift \[rad\].
    pub zero_lift: f64,
    law: Law,
}

#[derive(Debug, Clone, PartialEq)]
enum Law {
    Samples(Samples),
    Formula(Kirchhoff),
}

/// Cubics between samples over the full circle.
#[derive(Debug, Clone, PartialEq)]
struct Samples {
    alpha: Vec<f64>,
    attached: Vec<Cubic>,
    separated: Vec<Cubic>,
}

impl Separation {
    /// The split of the static lift of an airfoil or section, without deflection of a flap.
    pub fn of<P: Profile>(airfoil: &P, mach: f64, reynolds: f64) -> Self {
        let lift = lift_at(airfoil, mach, reynolds);
        let (slope, zero_lift) = attached_line(&lift);
        Self::sampled(&lift, slope, zero_lift)
    }

    /// The same for a given slope `[1/rad]` and zero-lift angle `[rad]`, which files may state.
    pub fn of_line<P: Profile>(
        airfoil: &P,
        [mach, reynolds]: [f64; 2],
        [slope, zero_lift]: [f64; 2],
    ) -> Self {
        Self::sampled(&lift_at(airfoil, mach, reynolds), slope, zero_lift)
    }

    /// The split by a formula of the attached part; the static lift follows from it.
    pub fn kirchhoff(law: Kirchhoff, slope: f64, zero_lift: f64) -> Self {
        Self {
            slope,
            zero_lift,
            law: Law::Formula(law),
        }
    }

    fn sampled(lift: &dyn Fn(f64) -> f64, slope: f64, zero_lift: f64) -> Self {
        let alpha = angles();
        let part = parts(&alpha, lift, slope, zero_lift);
        let has_stall = stalls(&alpha, &part);
        let pairs = alpha.iter().zip(&part);
        let split = pairs.map(|(angle, part)| {
            split(
                lift(*angle),
                slope * (angle - zero_lift),
                *part,
                if has_stall[usize::from(*angle > 0.0)] {
                    fade(*angle)
                } else {
                    1.0
                },
            )
        });
        let (attached, separated): (Vec<f64>, Vec<f64>) = split.unzip();
        let samples = Samples {
            attached: cubic::monotone(&alpha, &attached, Ends::Periodic),
            separated: cubic::monotone(&alpha, &separated, Ends::Periodic),
            alpha,
        };
        Self {
            slope,
            zero_lift,
            law: Law::Samples(samples),
        }
    }

    /// The part of the chord with attached flow, from 0 to 1, at an angle of attack in rad.
    pub fn attached<T: Real>(&self, alpha: T) -> T {
        let alpha = wrapped(alpha);
        match &self.law {
            Law::Samples(samples) => samples.at(&samples.attached, alpha),
            Law::Formula(law) => law.attached(alpha - self.zero_lift) * fade(alpha),
        }
    }

    /// The lift coefficient of separated flow at an angle of attack in rad.
    pub fn separated_lift<T: Real>(&self, alpha: T) -> T {
        let alpha = wrapped(alpha);
        match &self.law {
            Law::Samples(samples) => samples.at(&samples.separated, alpha),
            Law::Formula(law) => {
                let root = (law.attached(alpha - self.zero_lift) * fade(alpha) + TINY).sqrt();
                let share = (root * 3.0 + 1.0) / ((root + 1.0) * 4.0);
                (alpha - self.zero_lift) * self.slope * share
            }
        }
    }

    /// The static lift coefficient that follows from the split, at an angle of attack in rad.
    pub fn static_lift<T: Real>(&self, alpha: T) -> T {
        let alpha = wrapped(alpha);
        let (part, separated) = (self.attached(alpha), self.separated_lift(alpha));
        separated + part * ((alpha - self.zero_lift) * self.slope - separated)
    }
}

/// Keeps the derivative of a square root finite.
const TINY: f64 = 1e-12;

impl Samples {
    fn at<T: Real>(&self, cubics: &[Cubic], alpha: T) -> T {
        let i = cubic::interval(&self.alpha, alpha.re());
        cubic::evaluate(&cubics[i], alpha - self.alpha[i])
    }
}

/// The factor of attached flow that is zero at large angles.
fn fade<T: Real>(alpha: T) -> T {
    let [from, to] = FADE_DEG.map(f64::to_radians);
    faded(alpha, from, to)
}

/// The lift coefficient over the angle of attack.
fn lift_at<P: Profile>(airfoil: &P, mach: f64, reynolds: f64) -> impl Fn(f64) -> f64 {
    let flow = move |alpha| Flow {
        alpha,
        mach,
        reynolds,
        flap: 0.0,
    };
    move |alpha| airfoil.at(&flow(alpha)).lift
}

/// Angles of the samples, from -pi to pi.
fn angles() -> Vec<f64> {
    let [fine, coarse] = STEPS_DEG;
    let [fine_steps, steps] = STEPS;
    let angle = |k: u32| {
        let (near, far) = (k.min(fine_steps), k.saturating_sub(fine_steps));
        (f64::from(near) * fine + f64::from(far) * coarse).to_radians()
    };
    let negative = (1..=steps).rev().map(|k| -angle(k));
    let mut all: Vec<f64> = negative.chain((0..=steps).map(angle)).collect();
    // The ends are exact.
    all[0] = -PI;
    if let Some(last) = all.last_mut() {
        *last = PI;
    }
    all
}

/// Slope and zero of the lift of attached flow; zeros for a section without.
fn attached_line(lift: &dyn Fn(f64) -> f64) -> (f64, f64) {
    let step = 0.25_f64.to_radians();
    let rising = |k: &i32| {
        let low = f64::from(*k) * step;
        lift(low) <= 0.0 && lift(low + step) > 0.0
    };
    let nearest = (-100..100).filter(rising).min_by_key(|k| k.abs());
    let Some(k) = nearest else {
        return (0.0, 0.0);
    };
    let zero = bisected(lift, f64::from(k) * step, f64::from(k + 1) * step);
    let fit = (-20..=20).map(|k| f64::from(k) / 20.0 * FIT_DEG.to_radians());
    let moments = fit.map(|x| (x * lift(zero + x), x * x));
    let (product, square) = moments.fold((0.0, 0.0), |sum, it| (sum.0 + it.0, sum.1 + it.1));
    let slope = product / square;
    if slope > LEAST_SLOPE {
        (slope, zero)
    } else {
        (0.0, 0.0)
    }
}

/// The zero between `low` and `high`, at which the lift is not above and above zero.
fn bisected(lift: &dyn Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    for _ in 0..60 {
        let middle = low + (high - low) / 2.0;
        if lift(middle) > 0.0 {
            high = middle;
        } else {
            low = middle;
        }
    }
    low
}

/// The attached part at the angles, before its fade.
fn parts(alpha: &[f64], lift: &dyn Fn(f64) -> f64, slope: f64, zero_lift: f64) -> Vec<f64> {
    let mut parts = vec![0.0; alpha.len()];
    if slope <= 0.0 {
        return parts;
    }
    let near = STEPS_DEG[0].to_radians();
    let secant = (lift(zero_lift + near) - lift(zero_lift - near)) / (2.0 * near);
    let ratio = |angle: f64| {
        let incidence = angle - zero_lift;
        let is_near = incidence.abs() < near;
        if is_near {
            secant / slope
        } else {
            lift(angle) / (slope * incidence)
        }
    };
    let start = alpha.partition_point(|angle| *angle < zero_lift);
    let outward: [Vec<usize>; 2] = [(start..alpha.len()).collect(), (0..start).rev().collect()];
    for side in outward {
        // Not a number ends the attached range too.
        let attached = side.into_iter().take_while(|i| ratio(alpha[*i]) > 0.25);
        for i in attached {
            parts[i] = (2.0 * ratio(alpha[i]).sqrt() - 1.0).powi(2).min(1.0);
        }
    }
    parts
}

/// Whether the flow is separated where its fade begins, at negative and at positive angles.
fn stalls(alpha: &[f64], parts: &[f64]) -> [bool; 2] {
    let begin = FADE_DEG[0].to_radians();
    [-begin, begin].map(|begin| {
        let sample = alpha.partition_point(|angle| *angle < begin);
        parts.get(sample).is_none_or(|part| *part < UNSTALLED)
    })
}

/// The faded attached part, and the separated lift that gives the static lift with it.
fn split(lift: f64, attached_lift: f64, part: f64, fade: f64) -> (f64, f64) {
    let faded = part * fade;
    let separated = if faded >= 1.0 {
        lift / 2.0
    } else if fade >= 1.0 && part > 0.0 {
        let root = part.sqrt();
        attached_lift * (1.0 + 3.0 * root) / (4.0 * (1.0 + root))
    } else {
        (lift - faded * attached_lift) / (1.0 - faded)
    };
    (faded, separated)
}

#[cfg(test)]
mod tests;
