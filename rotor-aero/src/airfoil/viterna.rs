//! Extension of a table to the full circle.
//!
//! With the last angle h of the table, and c_lh, c_dh there,
//!
//! ```text
//! A = (c_lh - c_dm sin h cos h) sin h / cos^2 h,   B = (c_dh - c_dm sin^2 h)/cos h
//! c_l = (c_dm/2) sin 2a + A cos^2 a / sin a,       c_d = c_dm sin^2 a + B cos a      on h to 90 deg
//! ```
//!
//! From 90 deg to 180 deg - h the values at 180 deg - a are used, with -0.7 times the lift; lift is
//! linear from there to zero at 180 deg. On the negative side the values at -a are used, with -0.7
//! times the lift down to -90 deg, and 0.7 times the lift at a + 180 deg beyond; coefficients are
//! linear from -h to the first angle of the table. The drag has a lower limit.
//!
//! The moment, which the method does not have, is the one of a flat plate with the normal force of
//! the extension ([`super::FlatPlate`]); its difference at each end of the table fades linearly
//! over 30 deg.
//!
//! # References
//! - L. A. Viterna and D. C. Janetzke, "Theoretical and experimental power from large
//!   horizontal-axis wind turbines", NASA TM 82944, 1982.

use std::f64::consts::{FRAC_PI_2, PI};

use super::check::label;
use super::cubic;
use super::data::{AirfoilData, Curve};
use super::formula::plate_arm;
use super::problem::AirfoilProblem;

/// Step of the angles of the extension.
const STEP_DEG: f64 = 5.0;

/// Angles nearer to the table than this are left out \[rad\].
const NEAR: f64 = 1e-6;

/// Factor of the lift of the cambered side.
const CAMBER: f64 = 0.7;

/// Range over which the difference of the moment at the end of a table fades \[rad\].
const MOMENT_FADE: f64 = PI / 6.0;

/// Constants of the extension.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Viterna {
    /// Drag coefficient at 90 deg, c_dm \[-\].
    pub drag_90: f64,
    /// Least drag coefficient of the extension \[-\].
    pub least_drag: f64,
}

impl Viterna {
    /// The constants of a blade: 1.11 + 0.018 times its aspect ratio, at most 2.01 (ratio 50), and a
    /// least drag of 0.001.
    pub fn of_aspect_ratio(ratio: f64) -> Self {
        Self {
            drag_90: 1.11 + 0.018 * ratio.min(50.0),
            least_drag: 0.001,
        }
    }
}

impl AirfoilData {
    /// The table extended to the full circle; curves that are complete are kept.
    ///
    /// # Errors
    /// A lift curve without a drag curve of the same conditions, or ends of the table for which
    /// the method has no solution.
    pub fn extended(&self, viterna: &Viterna) -> Result<Self, Vec<AirfoilProblem>> {
        let mut problems = Vec::new();
        let mut extended = Self {
            lift: Vec::new(),
            drag: Vec::new(),
            moment: Vec::new(),
            ..self.clone()
        };
        for lift in &self.lift {
            match self.extended_curves(lift, viterna) {
                Ok([lift, drag, moment]) => {
                    extended.lift.extend(lift);
                    extended.drag.extend(drag);
                    extended.moment.extend(moment);
                }
                Err(reason) => problems.push(AirfoilProblem::Transformation {
                    curve: label(&self.name, "lift", lift),
                    reason,
                }),
            }
        }
        unpaired(self, &mut problems);
        if problems.is_empty() {
            Ok(extended)
        } else {
            Err(problems)
        }
    }

    /// The three curves of the conditions of one lift curve.
    fn extended_curves(
        &self,
        lift: &Curve,
        viterna: &Viterna,
    ) -> Result<[Option<Curve>; 3], &'static str> {
        let drag =
            matching(&self.drag, lift).ok_or("there is no drag curve of the same conditions")?;
        let moment = matching(&self.moment, lift);
        let all = [Some(lift), Some(drag), moment];
        let present = || all.iter().flatten();
        if present().all(|curve| is_complete(curve)) {
            return Ok(all.map(Option::<&Curve>::cloned));
        }
        if !present().all(|curve| is_usable(curve)) {
            return Err(
                "a curve to extend has fewer than two points, or angles or values that are no numbers",
            );
        }
        let ends = Extension::new([lift, drag], viterna)?;
        let kept = |curve: &Curve| ends.complete(curve, |_| 0.0);
        Ok([
            Some(ends.complete(lift, |angle| ends.at(angle)[0])),
            Some(ends.complete(drag, |angle| ends.at(angle)[1])),
            moment.map(|curve| {
                if is_complete(curve) {
                    kept(curve)
                } else {
                    ends.complete(curve, |angle| ends.moment(curve, angle))
                }
            }),
        ])
    }
}

/// Drag and moment curves that belong to no lift curve.
fn unpaired(data: &AirfoilData, problems: &mut Vec<AirfoilProblem>) {
    for (name, curves) in [("drag", &data.drag), ("moment", &data.moment)] {
        for curve in curves
            .iter()
            .filter(|curve| matching(&data.lift, curve).is_none())
        {
            problems.push(AirfoilProblem::Transformation {
                curve: label(&data.name, name, curve),
                reason: "there is no lift curve of the same conditions",
            });
        }
    }
}

/// The curve of the same conditions.
pub(super) fn matching<'a>(curves: &'a [Curve], like: &Curve) -> Option<&'a Curve> {
    let conditions = |curve: &Curve| [curve.mach, curve.reynolds, curve.flap];
    curves
        .iter()
        .find(|curve| conditions(curve) == conditions(like))
}

/// Whether a curve has two points or more, and numbers alone.
fn is_usable(curve: &Curve) -> bool {
    let mut numbers = curve.alpha.iter().chain(&curve.values);
    let is_pair = curve.alpha.len() == curve.values.len();
    is_pair && curve.alpha.len() > 1 && numbers.all(|number| number.is_finite())
}

/// Whether a curve covers the full circle, as far as the digits of a file.
fn is_complete(curve: &Curve) -> bool {
    let ends = (curve.alpha.first(), curve.alpha.last());
    matches!(ends, (Some(from), Some(to)) if from - 0.005 < -PI && to + 0.005 > PI)
}

/// The value on the straight lines of a curve, constant outside.
pub(super) fn on_lines(curve: &Curve, angle: f64) -> f64 {
    let i = cubic::interval(&curve.alpha, angle);
    let (Some(from), Some(to)) = (curve.alpha.get(i), curve.alpha.get(i + 1)) else {
        return curve.values.first().copied().unwrap_or(0.0);
    };
    let share = ((angle - from) / (to - from)).clamp(0.0, 1.0);
    curve.values[i] + share * (curve.values[i + 1] - curve.values[i])
}

/// The solution beyond the ends of a table.
#[derive(Debug)]
struct Extension {
    /// First and last angle of the table.
    range: [f64; 2],
    /// Lift and drag there.
    first: [f64; 2],
    last: [f64; 2],
    a: f64,
    b: f64,
    viterna: Viterna,
}

impl Extension {
    fn new([lift, drag]: [&Curve; 2], viterna: &Viterna) -> Result<Self, &'static str> {
        let from = lift.alpha[0].max(drag.alpha[0]);
        let end = |curve: &Curve| curve.alpha[curve.alpha.len() - 1];
        let high = end(lift).min(end(drag));
        if !(high > 0.0 && high < FRAC_PI_2 && from > -FRAC_PI_2 && from < high) {
            return Err("the table must begin after -90 deg, and end between 0 and 90 deg");
        }
        let at = |angle| [on_lines(lift, angle), on_lines(drag, angle)];
        let (last, maximum) = (at(high), viterna.drag_90);
        let (sin, cos) = high.sin_cos();
        Ok(Self {
            range: [from, high],
            first: at(from),
            last,
            a: (last[0] - maximum * sin * cos) * sin / (cos * cos),
            b: (last[1] - maximum * sin * sin) / cos,
            viterna: *viterna,
        })
    }

    /// Lift and drag outside the table.
    fn at(&self, angle: f64) -> [f64; 2] {
        let high = self.range[1];
        let [lift, drag] = if angle > PI - high {
            [
                (angle - PI) / high * self.last[0] * CAMBER,
                self.stalled(PI - angle)[1],
            ]
        } else if angle > FRAC_PI_2 {
            let [lift, drag] = self.stalled(PI - angle);
            [-CAMBER * lift, drag]
        } else if angle >= high {
            self.stalled(angle)
        } else if angle > -high {
            self.bridge(angle)
        } else if angle > -FRAC_PI_2 {
            let [lift, drag] = self.stalled(-angle);
            [-CAMBER * lift, drag]
        } else if angle > high - PI {
            let [lift, drag] = self.stalled(PI + angle);
            [CAMBER * lift, drag]
        } else {
            [
                (angle + PI) / high * self.last[0] * CAMBER,
                self.stalled(PI + angle)[1],
            ]
        };
        [lift, drag.max(self.viterna.least_drag)]
    }

    /// Lift and drag from 0 to 90 deg.
    fn stalled(&self, angle: f64) -> [f64; 2] {
        let (sin, cos) = angle.sin_cos();
        let maximum = self.viterna.drag_90;
        let lift = maximum * sin * cos + self.a * cos * cos / sin;
        [lift, maximum * sin * sin + self.b * cos]
    }

    /// Straight lines from -h to the first angle of the table.
    fn bridge(&self, angle: f64) -> [f64; 2] {
        let [from, high] = self.range;
        let share = (angle + high) / (from + high);
        let start = [-CAMBER * self.last[0], self.last[1]];
        [0, 1].map(|i| start[i] + share * (self.first[i] - start[i]))
    }

    /// The moment of a plate with the normal force of the extension, and the fading difference
    /// at the nearer end of the table.
    fn moment(&self, curve: &Curve, angle: f64) -> f64 {
        let plate = |angle: f64| {
            let ([lift, drag], (sin, cos)) = (self.at(angle), angle.sin_cos());
            (lift * cos + drag * sin) * plate_arm(sin, cos)
        };
        let last = curve.alpha.len() - 1;
        let i = if angle > curve.alpha[last] { last } else { 0 };
        let share = 1.0 - (angle - curve.alpha[i]).abs() / MOMENT_FADE;
        let difference = curve.values[i] - plate(curve.alpha[i]);
        plate(angle) + share.max(0.0) * difference
    }

    /// A curve with values at multiples of the step outside its range.
    fn complete(&self, curve: &Curve, value: impl Fn(f64) -> f64) -> Curve {
        if is_complete(curve) {
            return curve.clone();
        }
        let mut points: Vec<(f64, f64)> = Vec::new();
        let own = || {
            curve
                .alpha
                .iter()
                .copied()
                .zip(curve.values.iter().copied())
        };
        let [from, to] = [curve.alpha[0], curve.alpha[curve.alpha.len() - 1]];
        let steps = (180.0 / STEP_DEG) as i32;
        let grid = (-steps..=steps).map(|k| (f64::from(k) * STEP_DEG).to_radians());
        let outside = |angle: f64| (angle, value(angle));
        points.extend(
            grid.clone()
                .filter(|angle| *angle < from - NEAR)
                .map(outside),
        );
        points.extend(own());
        points.extend(grid.filter(|angle| *angle > to + NEAR).map(outside));
        let (alpha, values) = points.into_iter().unzip();
        Curve {
            alpha,
            values,
            ..curve.clone()
        }
    }
}

#[cfg(test)]
mod tests {
    use serde_json::Value;

    use super::Viterna;
    use crate::airfoil::{Airfoil, AirfoilData, Curve, Flow, Interpolation};

    fn reference() -> Value {
        let path = concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/tests/reference/aero/theory/viterna.json"
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

    fn table(file: &Value) -> AirfoilData {
        let input = &file["input"];
        let alpha: Vec<f64> = numbers(&input["alpha_deg"])
            .iter()
            .map(|x| x.to_radians())
            .collect();
        let curve = |key: &str| Curve {
            alpha: alpha.clone(),
            values: numbers(&input[key]),
            ..Curve::default()
        };
        AirfoilData {
            name: "table".to_owned(),
            lift: vec![curve("cl")],
            drag: vec![curve("cd")],
            ..AirfoilData::default()
        }
    }

    fn viterna(file: &Value) -> Viterna {
        Viterna {
            drag_90: file["cdmax"].as_f64().unwrap(),
            least_drag: file["cd_min"].as_f64().unwrap(),
        }
    }

    /// All 54 angles of a public test of WISDEM/CCBlade, with four digits after the point.
    #[test]
    fn a_public_table_is_reproduced() {
        let file = reference();
        let extended = table(&file).extended(&viterna(&file)).unwrap();
        let angles = numbers(&file["output"]["alpha_deg"]);
        for (curve, key) in [(&extended.lift[0], "cl"), (&extended.drag[0], "cd")] {
            for (angle, expected) in angles.iter().zip(numbers(&file["output"][key])) {
                let near = |a: &&f64| (a.to_degrees() - angle).abs() < 1e-9;
                let i = curve.alpha.iter().position(|a| near(&a)).unwrap();
                let error = (curve.values[i] - expected).abs();
                assert!(error < 5.0e-5 + 1e-12, "{key} {angle} {error}");
            }
        }
    }

    #[test]
    fn an_extended_table_is_accepted_and_kept_when_extended_again() {
        let file = reference();
        let mut data = table(&file);
        data.moment = vec![Curve {
            values: vec![-0.05; data.lift[0].alpha.len()],
            ..data.lift[0].clone()
        }];
        assert!(Airfoil::new(&data, Interpolation::Monotone).is_err());
        let extended = data.extended(&viterna(&file)).unwrap();
        let airfoil = Airfoil::new(&extended, Interpolation::Monotone).unwrap();
        assert!(airfoil.remarks().is_empty(), "{:?}", airfoil.remarks());
        assert_eq!(extended.extended(&viterna(&file)).unwrap(), extended);
        // The pressure of a plate at 90 deg acts at half chord.
        let (alpha, mach, reynolds, flap) = (std::f64::consts::FRAC_PI_2, 0.0, 1e6, 0.0);
        let at = airfoil.at(&Flow {
            alpha,
            mach,
            reynolds,
            flap,
        });
        assert!((at.moment + 1.29 / 4.0).abs() < 1e-9 && (at.drag - 1.29).abs() < 1e-12);
    }

    #[test]
    fn tables_without_a_solution_are_problems() {
        let file = reference();
        let problems = |change: &dyn Fn(&mut AirfoilData)| {
            let mut data = table(&file);
            change(&mut data);
            data.extended(&viterna(&file))
                .map_err(|problems| problems.len())
        };
        assert_eq!(problems(&|data| data.drag.clear()), Err(1));
        assert_eq!(problems(&|data| data.drag[0].mach = Some(0.3)), Err(2));
        assert_eq!(problems(&|data| data.lift[0].values.truncate(3)), Err(1));
        assert_eq!(problems(&|data| data.lift[0] = Curve::default()), Err(1));
        assert_eq!(
            problems(&|data| data.lift[0].alpha.iter_mut().for_each(|a| *a = f64::NAN)),
            Err(1)
        );
        let shifted = |data: &mut AirfoilData| {
            data.lift[0].alpha.iter_mut().for_each(|a| *a -= 1.0);
        };
        assert_eq!(problems(&shifted), Err(1));
    }
}
