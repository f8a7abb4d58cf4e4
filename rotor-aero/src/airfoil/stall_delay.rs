//! Delay of stall by rotation.
//!
//! With c/r of the station, the slope m and zero a_0 of the lift, and the factor h,
//!
//! ```text
//! c_l3 = c_l + h [m (a - a_0) - c_l],   c_d3 = c_d + (c_l3 - c_l) (sin a - 0.12 cos a)/(cos a + 0.12 sin a)
//! Du, Selig:  h = (1/m) [1.6 (c/r)/0.1267 (1 - x)/(1 + x) - 1],  x = (c/r)^(R/(L r)),  L = Omega R/sqrt(V^2 + (Omega R)^2)
//! Snel:       h = 3 (c/r)^2, without drag
//! ```
//!
//! The drag at negative angles is the one of the section upside down.
//! The factor of Du and Selig is the one of the c/r at which it is largest also beyond it.
//! It is at most 1, which is the line: chords at a root may be longer than their radius.
//! Above 30 deg it fades with `((90 deg - a)/(60 deg))^2` to zero at 90 deg, on both sides.
//! A lift that contains the delay must not be corrected again: most public tables of wind
//! turbines do.
//!
//! # References
//! - Z. Du and M. S. Selig, "A 3-D stall-delay model for horizontal axis wind turbine performance
//!   prediction", AIAA 98-0021, 1998.
//! - A. J. Eggers, K. Chaney, R. Digumarthi, "An assessment of approximate modeling of
//!   aerodynamic loads on the UAE rotor", ASME Wind Energy Symposium, 2003.
//! - H. Snel, R. Houwink, J. Bosschers, "Sectional prediction of lift coefficients on rotating
//!   wind turbine blades in stall", ECN-C--93-052, 1994.

use std::f64::consts::{FRAC_PI_2, PI};

use super::check::label;
use super::data::{AirfoilData, Curve};
use super::problem::AirfoilProblem;
use super::viterna::{matching, on_lines};

/// Angle from which the correction fades \[rad\].
const FADE_FROM: f64 = PI / 6.0;

/// Law of the factor of the lift.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StallDelayLaw {
    /// Lift of Du and Selig, drag of Eggers.
    DuSelig {
        /// Speed of the tip by rotation over the speed at the tip, L \[-\].
        speed_ratio: f64,
        /// Radius of the station over radius of the rotor \[-\].
        radius_ratio: f64,
    },
    /// Lift of Snel.
    Snel,
}

/// Correction of a table for one station of a rotor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StallDelay {
    /// Law.
    pub law: StallDelayLaw,
    /// Chord over radius of the station \[-\].
    pub chord_ratio: f64,
    /// Angles between which the slope and the zero of lift are fitted \[rad\].
    pub fit: [f64; 2],
}

impl StallDelay {
    /// Usual angles of the fit: -5 and 5 deg \[rad\].
    pub const USUAL_FIT: [f64; 2] = [-PI / 36.0, PI / 36.0];

    /// Du and Selig's lift with Eggers' drag; lift is fitted from -5 to 5 deg.
    pub fn du_selig(chord_ratio: f64, radius_ratio: f64, speed_ratio: f64) -> Self {
        let law = StallDelayLaw::DuSelig {
            speed_ratio,
            radius_ratio,
        };
        Self::of(law, chord_ratio)
    }

    /// Snel's lift; lift is fitted from -5 to 5 deg.
    pub fn snel(chord_ratio: f64) -> Self {
        Self::of(StallDelayLaw::Snel, chord_ratio)
    }

    fn of(law: StallDelayLaw, chord_ratio: f64) -> Self {
        Self {
            law,
            chord_ratio,
            fit: Self::USUAL_FIT,
        }
    }

    /// The same with the lift fitted between these angles \[rad\].
    #[must_use]
    pub fn with_fit(self, fit: [f64; 2]) -> Self {
        Self { fit, ..self }
    }

    /// The factor h up to 30 deg, for a slope of lift.
    fn factor(&self, slope: f64) -> f64 {
        let ratio = self.chord_ratio;
        let factor = match self.law {
            StallDelayLaw::DuSelig {
                speed_ratio,
                radius_ratio,
            } => {
                let exponent = 1.0 / (speed_ratio * radius_ratio);
                let ratio = ratio.min(largest_ratio(exponent));
                let x = ratio.powf(exponent);
                (1.6 * ratio / 0.1267 * (1.0 - x) / (1.0 + x) - 1.0) / slope
            }
            StallDelayLaw::Snel => 3.0 * ratio * ratio,
        };
        factor.min(1.0)
    }

    fn is_possible(&self) -> bool {
        let fits = self.chord_ratio > 0.0 && self.chord_ratio.is_finite();
        fits && match self.law {
            StallDelayLaw::DuSelig {
                speed_ratio,
                radius_ratio,
            } => speed_ratio > 0.0 && speed_ratio <= 1.0 && radius_ratio > 0.0,
            StallDelayLaw::Snel => true,
        }
    }
}

/// The ratio c/r at which the factor of Du and Selig is largest, from the zero of its derivative, beyond which
/// lie the chords of roots:
///
/// ```text
/// d/dc [c (1 - c^p)/(1 + c^p)] = 0 ,     c^p = sqrt(p^2 + 1) - p
/// ```
fn largest_ratio(p: f64) -> f64 {
    // The difference without its cancellation.
    (p.hypot(1.0) + p).recip().powf(p.recip())
}

impl AirfoilData {
    /// The table with delayed stall.
    ///
    /// # Errors
    /// Ratios out of range, no drag curve of the conditions of a lift curve, or a lift without
    /// two points of positive slope in the range of the fit.
    pub fn with_stall_delay(&self, delay: &StallDelay) -> Result<Self, Vec<AirfoilProblem>> {
        let mut problems = Vec::new();
        let mut delayed = self.clone();
        for (i, lift) in self.lift.iter().enumerate() {
            match increments(lift, delay) {
                Ok(increment) => {
                    for (value, step) in delayed.lift[i].values.iter_mut().zip(&increment) {
                        *value += step;
                    }
                    let increment = Curve {
                        values: increment,
                        ..lift.clone()
                    };
                    if let Some(drag) = delayed_drag(&self.drag, &increment, delay.law) {
                        replace(&mut delayed.drag, drag);
                    }
                }
                Err(reason) => problems.push(AirfoilProblem::Transformation {
                    curve: label(&self.name, "lift", lift),
                    reason,
                }),
            }
        }
        if problems.is_empty() {
            Ok(delayed)
        } else {
            Err(problems)
        }
    }
}

/// The increments of lift at the angles of its curve.
fn increments(lift: &Curve, delay: &StallDelay) -> Result<Vec<f64>, &'static str> {
    if !delay.is_possible() {
        return Err("chord and radius ratios must be positive, the speed ratio from 0 to 1");
    }
    if lift.alpha.len() != lift.values.len() {
        return Err("angles and values differ in number");
    }
    let (slope, zero) = fitted(lift, delay.fit)
        .ok_or("the lift has no positive slope of two points in the range of the fit")?;
    let factor = delay.factor(slope);
    let points = lift.alpha.iter().zip(&lift.values);
    let increment = |(angle, value): (&f64, &f64)| {
        let attached = slope * (angle - zero);
        factor * fade(*angle) * (attached - value)
    };
    Ok(points.map(increment).collect())
}

/// Slope and zero of the least-squares line in a range of angles.
pub(super) fn fitted(lift: &Curve, [from, to]: [f64; 2]) -> Option<(f64, f64)> {
    // The digits of a file.
    let is_in = |angle: f64| angle >= from - 1e-3 && angle <= to + 1e-3;
    let points = || {
        lift.alpha
            .iter()
            .zip(&lift.values)
            .filter(|point| is_in(*point.0))
    };
    let n = points().count() as f64;
    let mean = |value: &dyn Fn((&f64, &f64)) -> f64| points().map(value).sum::<f64>() / n;
    let (x, y) = (mean(&|point| *point.0), mean(&|point| *point.1));
    let product = mean(&|point| (point.0 - x) * (point.1 - y));
    let square = mean(&|point| (point.0 - x) * (point.0 - x));
    let slope = product / square;
    (slope.is_finite() && slope > 0.0).then(|| (slope, x - y / slope))
}

/// The share of the correction at an angle.
fn fade(angle: f64) -> f64 {
    let share = (FRAC_PI_2 - angle.abs()) / (FRAC_PI_2 - FADE_FROM);
    let share = share.clamp(0.0, 1.0);
    share * share
}

/// The drag curve that belongs to an increment of lift, with its increment.
fn delayed_drag(drag: &[Curve], lift: &Curve, law: StallDelayLaw) -> Option<Curve> {
    if law == StallDelayLaw::Snel {
        return None;
    }
    let mut drag = matching(drag, lift)?.clone();
    for (angle, value) in drag.alpha.iter().zip(drag.values.iter_mut()) {
        // The formula is for positive angles, and has a pole at -83 deg.
        let (sin, cos) = angle.abs().sin_cos();
        let ratio = angle.signum() * (sin - 0.12 * cos) / (cos + 0.12 * sin);
        let increment = on_lines(lift, *angle);
        *value += if increment == 0.0 {
            0.0
        } else {
            increment * ratio
        };
    }
    Some(drag)
}

/// Replaces the curve of the same conditions.
fn replace(curves: &mut [Curve], by: Curve) {
    let conditions = |curve: &Curve| [curve.mach, curve.reynolds, curve.flap];
    if let Some(curve) = curves
        .iter_mut()
        .find(|curve| conditions(curve) == conditions(&by))
    {
        *curve = by;
    }
}

#[cfg(test)]
mod tests {
    use serde_json::Value;

    use super::StallDelay;
    use crate::airfoil::{AirfoilData, Curve, naca0012};

    fn reference() -> Value {
        let path = concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/tests/reference/aero/theory/du_selig.json"
        );
        serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
    }

    fn numbers(value: &Value) -> Vec<f64> {
        value
            .as_array()
            .unwrap()
            .iter()
            .map(|x| x.as_f64().unwrap())
            .collect()
    }

    fn table(angles_deg: &[f64], lift: Vec<f64>) -> AirfoilData {
        let alpha: Vec<f64> = angles_deg.iter().map(|x| x.to_radians()).collect();
        let curve = |values| Curve {
            alpha: alpha.clone(),
            values,
            ..Curve::default()
        };
        AirfoilData {
            name: "table".to_owned(),
            drag: vec![curve(vec![0.0; lift.len()])],
            lift: vec![curve(lift)],
            ..AirfoilData::default()
        }
    }

    /// Both stations of a public test of CCBlade.jl, whose values are from the spreadsheet
    /// AirfoilPrep, with four digits after the point.
    #[test]
    fn lift_of_du_and_selig_agrees_with_a_public_table() {
        let file = reference();
        let number = |key: &str| file[key].as_f64().unwrap();
        let tip = number("rpm") * std::f64::consts::PI / 30.0 * number("D") / 2.0;
        let speed_ratio = tip / tip.hypot(number("V"));
        let data = table(&numbers(&file["alpha_deg"]), numbers(&file["cl_2d"]));
        for case in file["cases"].as_array().unwrap() {
            let ratio = |key: &str| case[key].as_f64().unwrap();
            let mut delay = StallDelay::du_selig(ratio("c_over_r"), ratio("r_over_R"), speed_ratio);
            // The line through the first three points.
            delay.fit = [0.0, 5.1_f64.to_radians()];
            let delayed = data.with_stall_delay(&delay).unwrap();
            for (value, expected) in delayed.lift[0].values.iter().zip(numbers(&case["cl_3d"])) {
                assert!((value - expected).abs() < 5e-5, "{value} {expected}");
            }
        }
    }

    /// The formula of the drag by hand, at 20 deg, where the lift rises by 0.3.
    #[test]
    fn drag_follows_the_increment_of_lift() {
        let data = table(
            &[-5.0, 0.0, 5.0, 20.0, 90.0, 180.0],
            vec![-0.5, 0.0, 0.5, 1.0, 0.0, 0.0],
        );
        let delayed = data
            .with_stall_delay(&StallDelay::du_selig(0.2, 0.5, 0.9))
            .unwrap();
        let (sin, cos) = 20.0_f64.to_radians().sin_cos();
        let increment = delayed.lift[0].values[3] - 1.0;
        let expected = increment * (sin - 0.12 * cos) / (cos + 0.12 * sin);
        assert!(increment > 0.05 && (delayed.drag[0].values[3] - expected).abs() < 1e-12);
        assert_eq!(delayed.lift[0].values[4..], [0.0, 0.0]);
    }

    /// At 10 deg the lift is 0.8 and the line 1: 0.03 of the difference for c/r = 0.1.
    #[test]
    fn lift_of_snel_is_the_formula() {
        let data = table(&[-5.0, 5.0, 10.0], vec![-0.5, 0.5, 0.8]);
        let delayed = data.with_stall_delay(&StallDelay::snel(0.1)).unwrap();
        assert!((delayed.lift[0].values[2] - (0.8 + 0.03 * 0.2)).abs() < 1e-12);
        assert_eq!(delayed.drag, data.drag);
    }

    /// The lift at 25 deg grows with the chord, and stays below the line, for any chord.
    #[test]
    fn wide_chords_do_not_turn_the_factor_over() {
        let data = table(
            &[-5.0, 0.0, 5.0, 25.0, 90.0, 180.0],
            vec![-0.5, 0.0, 0.5, 1.0, 0.0, 0.0],
        );
        for radius_ratio in [0.05, 0.1, 0.3, 0.6, 1.0] {
            let lift = |ratio: f64| {
                let delay = StallDelay::du_selig(ratio, radius_ratio, 0.97);
                data.with_stall_delay(&delay).unwrap().lift[0].values[3]
            };
            let mut last = lift(0.01);
            for k in 2..400 {
                let found = lift(0.01 * f64::from(k));
                assert!(
                    found >= last - 1e-12 && found <= 2.5 + 1e-12,
                    "{radius_ratio} {k} {found}"
                );
                last = found;
            }
        }
    }

    #[test]
    fn odd_input_is_a_problem() {
        let data = naca0012();
        for ratio in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(data.with_stall_delay(&StallDelay::snel(ratio)).is_err());
            assert!(
                data.with_stall_delay(&StallDelay::du_selig(0.1, ratio, 0.9))
                    .is_err()
                    || ratio > 1.0
            );
            assert!(
                data.with_stall_delay(&StallDelay::du_selig(0.1, 0.5, ratio))
                    .is_err()
            );
        }
        let flat = table(&[-5.0, 5.0], vec![0.0, 0.0]);
        assert_eq!(
            flat.with_stall_delay(&StallDelay::snel(0.1))
                .unwrap_err()
                .len(),
            1
        );
        assert!(data.with_stall_delay(&StallDelay::snel(0.1)).is_ok());
    }
}
