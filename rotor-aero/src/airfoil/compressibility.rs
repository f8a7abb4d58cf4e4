//! Compressibility of tables without Mach numbers or of one Mach number, and of linear lift.
//!
//! ```text
//! c_l(M) = c_l(M_0) g(M) / g(M_0),   g(M) = 1 + w (1/sqrt(1 - M^2) - 1),   c_m likewise
//! ```
//!
//! where M_0 is the Mach number of the table, zero if it states none, and w is one up to 15 deg and
//! fades to zero at 30 deg: separated and reverse flow are left as they are. Curves are made at Mach numbers in steps of 0.05 or less up to a limit, from which on
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
    /// A table over several Mach numbers, which contains compressibility; a limit that is not
    /// between 0 and 0.95.
    pub fn with_compressibility(&self, mach_limit: f64) -> Result<Self, Vec<AirfoilProblem>> {
        let mut problems = Vec::new();
        let curves = || self.lift.iter().chain(&self.drag).chain(&self.moment);
        let own = curves().next().and_then(|curve| curve.mach);
        let has_several = curves().any(|curve| curve.mach != own);
        if has_several || own.is_some_and(|own| own > MACH_LARGEST) {
            let airfoil = self.name.clone();
            problems.push(AirfoilProblem::HasMach { airfoil });
        }
        problems.extend(wrong_limit(&self.name, mach_limit));
        if !problems.is_empty() {
            return Err(problems);
        }
        let without = |curve: &Curve| Curve {
            mach: None,
            ..curve.clone()
        };
        let from = own.unwrap_or(0.0);
        Ok(Self {
            lift: compressible(&self.lift, (from, mach_limit)),
            drag: self.drag.iter().map(without).collect(),
            moment: compressible(&self.moment, (from, mach_limit)),
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

/// The curves of the Mach number `from` at all Mach numbers up to `limit`.
fn compressible(curves: &[Curve], (from, limit): (f64, f64)) -> Vec<Curve> {
    let steps = (limit / STEP).ceil().max(1.0);
    let mach = |k: u32| f64::from(k) / steps * limit;
    let all = |curve: &Curve| {
        let curve = curve.clone();
        (0..=steps as u32).map(move |k| at_mach(&curve, from, mach(k)))
    };
    curves.iter().flat_map(all).collect()
}

/// The curve of the Mach number `own` at another one.
fn at_mach(curve: &Curve, own: f64, mach: f64) -> Curve {
    let [from, to] = FADE_DEG.map(f64::to_radians);
    let factor = |alpha: f64, mach: f64| {
        let rise = 1.0 / (1.0 - mach * mach).sqrt() - 1.0;
        1.0 + rise * faded(alpha, from, to)
    };
    let points = curve.alpha.iter().zip(&curve.values);
    let value = |(alpha, value): (&f64, &f64)| value * factor(*alpha, mach) / factor(*alpha, own);
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

    /// A table of the Mach number .5 that the factor made from one of Mach number 0 gives this one back.
    #[test]
    fn a_table_of_one_mach_number_is_its_own_start() {
        let whole = table().with_compressibility(0.8).unwrap();
        let at_half = |curves: &[Curve]| {
            let own = |curve: &&Curve| (curve.mach.unwrap_or(0.5) - 0.5).abs() < 1e-9;
            let curves = curves.iter().filter(own).cloned();
            let stated = curves.map(|curve| Curve {
                mach: Some(0.5),
                ..curve
            });
            stated.collect::<Vec<_>>()
        };
        let half = AirfoilData {
            lift: at_half(&whole.lift),
            drag: at_half(&whole.drag),
            moment: at_half(&whole.moment),
            ..whole.clone()
        };
        assert_eq!(half.lift.len(), 1);
        let again = half.with_compressibility(0.8).unwrap();
        assert_eq!(again.drag, whole.drag);
        for (own, expected) in again.lift.iter().zip(&whole.lift) {
            let pairs = own.values.iter().zip(&expected.values);
            let off = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(own.mach == expected.mach && off < 1e-13, "{off}");
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
