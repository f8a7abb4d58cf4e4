//! Compressibility of tables without Mach numbers, and of linear lift.
//!
//! ```text
//! c_l(M) = c_l (1 + w (1/sqrt(1 - M^2) - 1)),   c_m likewise
//! ```
//!
//! where w is one up to 15 deg and fades to zero at 30 deg: separated and reverse flow are left as
//! they are. Curves are made at Mach numbers in steps of 0.05 or less up to a limit, from which on
//! coefficients are constant.
//!
//! # References
//! - H. Glauert, "The effect of compressibility on the lift of an aerofoil", Proceedings of the
//!   Royal Society A 118, 1928.

use super::data::{AirfoilData, Curve};
use super::formula::{LinearLift, MACH_LARGEST, faded};
use super::problem::AirfoilProblem;

/// Angles at which the fade of the factor begins and ends \[deg\].
const FADE_DEG: [f64; 2] = [15.0, 30.0];

/// Longest step of the Mach number.
const STEP: f64 = 0.05;

impl AirfoilData {
    /// The table with the Prandtl-Glauert factor up to a Mach number, usually 0.75 to 0.85; drag
    /// is kept.
    ///
    /// # Errors
    /// A table that has Mach numbers, which contains compressibility; a limit that is not
    /// between 0 and 0.95.
    pub fn with_compressibility(&self, mach_limit: f64) -> Result<Self, Vec<AirfoilProblem>> {
        let mut problems = Vec::new();
        let mut curves = self.lift.iter().chain(&self.drag).chain(&self.moment);
        if curves.any(|curve| curve.mach.is_some()) {
            let airfoil = self.name.clone();
            problems.push(AirfoilProblem::HasMach { airfoil });
        }
        problems.extend(wrong_limit(&self.name, mach_limit));
        if !problems.is_empty() {
            return Err(problems);
        }
        Ok(Self {
            lift: compressible(&self.lift, mach_limit),
            moment: compressible(&self.moment, mach_limit),
            ..self.clone()
        })
    }
}

impl LinearLift {
    /// The lift with the Prandtl-Glauert factor up to a Mach number, of the airfoil `name`.
    ///
    /// # Errors
    /// A limit that is not between 0 and 0.95.
    pub fn with_compressibility(self, name: &str, mach_limit: f64) -> Result<Self, AirfoilProblem> {
        match wrong_limit(name, mach_limit) {
            Some(problem) => Err(problem),
            None => Ok(Self {
                mach_limit: Some(mach_limit),
                ..self
            }),
        }
    }
}

/// The problem of a limit of the Mach number, if it has one.
fn wrong_limit(name: &str, limit: f64) -> Option<AirfoilProblem> {
    let is_wrong = !(limit > 0.0 && limit <= MACH_LARGEST);
    is_wrong.then(|| AirfoilProblem::Condition {
        curve: format!("compressibility of \"{name}\""),
        variable: "limit of the Mach number",
        value: limit,
        expected: "a number above 0, and 0.95 or less",
    })
}

/// The curves at all Mach numbers.
fn compressible(curves: &[Curve], limit: f64) -> Vec<Curve> {
    let steps = (limit / STEP).ceil().max(1.0);
    let mach = |k: u32| f64::from(k) / steps * limit;
    let all = |curve: &Curve| {
        let curve = curve.clone();
        (0..=steps as u32).map(move |k| at_mach(&curve, mach(k)))
    };
    curves.iter().flat_map(all).collect()
}

/// The curve at one Mach number.
fn at_mach(curve: &Curve, mach: f64) -> Curve {
    let rise = 1.0 / (1.0 - mach * mach).sqrt() - 1.0;
    let [from, to] = FADE_DEG.map(f64::to_radians);
    let points = curve.alpha.iter().zip(&curve.values);
    let value = |(alpha, value): (&f64, &f64)| value * (1.0 + rise * faded(*alpha, from, to));
    Curve {
        mach: Some(mach),
        values: points.map(value).collect(),
        ..curve.clone()
    }
}

#[cfg(test)]
mod tests {
    use crate::airfoil::{Airfoil, AirfoilData, Curve, Flow, Interpolation, naca0012};

    fn table() -> AirfoilData {
        let low = |curves: &[Curve]| {
            vec![Curve {
                mach: None,
                ..curves[0].clone()
            }]
        };
        let all = naca0012();
        AirfoilData {
            lift: low(&all.lift),
            drag: low(&all.drag),
            moment: low(&all.moment),
            ..all
        }
    }

    fn at(airfoil: &Airfoil, alpha_deg: f64, mach: f64) -> [f64; 2] {
        let (alpha, reynolds, flap) = (alpha_deg.to_radians(), 1e6, 0.0);
        let at = airfoil.at(&Flow {
            alpha,
            mach,
            reynolds,
            flap,
        });
        [at.lift, at.drag]
    }

    /// The cubics in the Mach number are within 2e-3 of the factor below the last step, in which
    /// their slope falls to zero.
    #[test]
    fn lift_has_the_factor_up_to_the_limit() {
        let plain = Airfoil::new(&table(), Interpolation::Monotone).unwrap();
        let data = table().with_compressibility(0.8).unwrap();
        let airfoil = Airfoil::new(&data, Interpolation::Monotone).unwrap();
        for alpha in [-12.0, 3.0, 8.0, 15.0] {
            for mach in [0.0, 0.13, 0.4, 0.52, 0.68, 0.74, 0.8, 0.9] {
                let limited = f64::min(mach, 0.8);
                let [lift, drag] = at(&plain, alpha, 0.0);
                let factor = at(&airfoil, alpha, mach)[0] / lift * (1.0 - limited * limited).sqrt();
                assert!((factor - 1.0).abs() < 2e-3, "{alpha} {mach} {factor}");
                assert_eq!(at(&airfoil, alpha, mach)[1], drag);
            }
        }
        for alpha in [-170.0, -31.0, 40.0, 120.0] {
            assert_eq!(at(&airfoil, alpha, 0.7), at(&plain, alpha, 0.7));
        }
    }

    #[test]
    fn tables_with_mach_numbers_and_limits_out_of_range_are_refused() {
        assert_eq!(naca0012().with_compressibility(0.8).unwrap_err().len(), 1);
        for limit in [0.0, -0.3, 1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(table().with_compressibility(limit).unwrap_err().len(), 1);
            assert_eq!(naca0012().with_compressibility(limit).unwrap_err().len(), 2);
        }
    }
}
