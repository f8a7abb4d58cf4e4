//! Characteristic numbers of a table, one set for each curve of lift.
//!
//! | number | definition |
//! |---|---|
//! | zero lift | the rising zero of lift nearest to 0 deg, up to 20 deg |
//! | slope | the least-squares line of lift within 5 deg of zero lift |
//! | largest, least lift | from 0 to 30 deg, from -30 to 0 deg |
//! | least drag | from -30 to 30 deg |
//! | best lift over drag | at the points of the lift from 0 to 30 deg |
//! | moment | at zero lift, on straight lines |

use super::data::{AirfoilData, Curve};
use super::stall_delay::fitted;
use super::viterna::{matching, on_lines};

/// Limit of the angles for extremes \[deg\].
const LIMIT_DEG: f64 = 30.0;
/// Limit of the angle without lift \[deg\].
const ZERO_DEG: f64 = 20.0;
/// Half of the range of the slope \[deg\].
const SLOPE_DEG: f64 = 5.0;
/// Lift below which a curve has none: cylinders in tables of four digits \[-\].
const NO_LIFT: f64 = 1e-3;
/// Digits of angles in files \[rad\].
const DIGITS: f64 = 1e-6;

/// An extreme of a coefficient.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extreme {
    /// Its value \[-\].
    pub value: f64,
    /// Angle of attack \[rad\].
    pub angle: f64,
}

/// Characteristic numbers of the curves of one condition; absent if the curves have none.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Characteristics {
    /// Mach number \[-\].
    pub mach: Option<f64>,
    /// Reynolds number \[-\].
    pub reynolds: Option<f64>,
    /// Deflection of the flap \[rad\].
    pub flap: Option<f64>,
    /// Angle of attack without lift \[rad\].
    pub zero_lift: Option<f64>,
    /// Slope of lift there \[1/rad\].
    pub slope: Option<f64>,
    /// Largest lift.
    pub lift_max: Option<Extreme>,
    /// Least lift.
    pub lift_min: Option<Extreme>,
    /// Least drag.
    pub drag_min: Option<Extreme>,
    /// Largest ratio of lift to drag.
    pub ratio_max: Option<Extreme>,
    /// Moment without lift \[-\].
    pub moment_zero: Option<f64>,
}

impl AirfoilData {
    /// Characteristic numbers of each curve of lift, with the curves of drag and moment of the
    /// same conditions.
    pub fn characteristics(&self) -> Vec<Characteristics> {
        let of = |lift: &Curve| {
            let drag = matching(&self.drag, lift);
            let moment = matching(&self.moment, lift);
            characteristics(lift, drag, moment)
        };
        self.lift.iter().map(of).collect()
    }
}

fn characteristics(lift: &Curve, drag: Option<&Curve>, moment: Option<&Curve>) -> Characteristics {
    let limit = LIMIT_DEG.to_radians();
    let lifts = points(lift).any(|(angle, value)| angle.abs() <= limit && value.abs() > NO_LIFT);
    let mut found = Characteristics {
        mach: lift.mach,
        reynolds: lift.reynolds,
        flap: lift.flap,
        drag_min: drag.map(|drag| {
            let least = largest(points(drag).map(negated), [-limit, limit]);
            // A cylinder may have points at the ends alone.
            least.unwrap_or(Extreme {
                value: -on_lines(drag, 0.0),
                angle: 0.0,
            })
        }),
        ..Characteristics::default()
    };
    found.drag_min = found.drag_min.map(|at| Extreme {
        value: -at.value,
        ..at
    });
    if !lifts {
        return found;
    }
    found.lift_max = largest(points(lift), [0.0, limit]);
    let least = largest(points(lift).map(negated), [-limit, 0.0]);
    found.lift_min = least.map(|at| Extreme {
        value: -at.value,
        ..at
    });
    found.zero_lift = zero(lift);
    found.slope = found.zero_lift.and_then(|zero| {
        let half = SLOPE_DEG.to_radians();
        fitted(lift, [zero - half, zero + half]).map(|line| line.0)
    });
    found.ratio_max = drag.and_then(|drag| {
        let ratios = points(lift).map(|(angle, value)| (angle, value / on_lines(drag, angle)));
        largest(ratios, [0.0, limit])
    });
    found.moment_zero = match (moment, found.zero_lift) {
        (Some(moment), Some(zero)) => Some(on_lines(moment, zero)),
        _ => None,
    };
    found
}

fn points(curve: &Curve) -> impl Iterator<Item = (f64, f64)> + '_ {
    let angles = curve.alpha.iter().copied();
    angles.zip(curve.values.iter().copied())
}

fn negated((angle, value): (f64, f64)) -> (f64, f64) {
    (angle, -value)
}

/// The point of the largest finite value in a range of angles.
fn largest(points: impl Iterator<Item = (f64, f64)>, [from, to]: [f64; 2]) -> Option<Extreme> {
    points
        .filter(|(angle, value)| {
            *angle >= from - DIGITS && *angle <= to + DIGITS && value.is_finite()
        })
        .map(|(angle, value)| Extreme { value, angle })
        .reduce(|best, at| if at.value > best.value { at } else { best })
}

/// The rising zero of a curve that is nearest to 0 deg \[rad\].
fn zero(curve: &Curve) -> Option<f64> {
    let pairs = curve.alpha.windows(2).zip(curve.values.windows(2));
    let crossing = |(angles, values): (&[f64], &[f64])| {
        let (low, high) = (values[0], values[1]);
        let rises = low <= 0.0 && high > 0.0;
        rises.then(|| angles[0] - low * (angles[1] - angles[0]) / (high - low))
    };
    let near = |angle: &f64| angle.abs() <= ZERO_DEG.to_radians();
    pairs
        .filter_map(crossing)
        .filter(near)
        .min_by(|a, b| a.abs().total_cmp(&b.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(points: &[(f64, f64)]) -> Curve {
        Curve {
            alpha: points.iter().map(|point| point.0.to_radians()).collect(),
            values: points.iter().map(|point| point.1).collect(),
            ..Curve::default()
        }
    }

    /// Lift 0.1 per degree from -4 deg, linear up to 1.4 at 10 deg; numbers by hand, to round-off.
    #[test]
    fn numbers_of_a_polygon_follow_by_hand() {
        let data = AirfoilData {
            lift: vec![curve(&[
                (-180.0, 0.0),
                (-12.0, -0.8),
                (-8.0, -0.4),
                (-6.0, -0.2),
                (-2.0, 0.2),
                (0.0, 0.4),
                (10.0, 1.4),
                (30.0, 0.9),
                (45.0, 1.5),
                (180.0, 0.0),
            ])],
            drag: vec![curve(&[
                (-180.0, 0.1),
                (-3.0, 0.008),
                (7.0, 0.018),
                (180.0, 0.1),
            ])],
            moment: vec![curve(&[
                (-180.0, 0.0),
                (-5.0, -0.1),
                (-3.0, -0.2),
                (180.0, 0.0),
            ])],
            ..AirfoilData::default()
        };
        let found = data.characteristics()[0];
        let near = |found: Option<f64>, expected: f64| {
            let found = found.unwrap();
            assert!((found - expected).abs() < 1e-12, "{found} {expected}");
        };
        near(found.zero_lift.map(f64::to_degrees), -4.0);
        near(found.slope.map(f64::to_radians), 0.1);
        let max = found.lift_max.unwrap();
        assert_eq!((max.value, max.angle), (1.4, 10.0_f64.to_radians()));
        assert_eq!(found.lift_min.unwrap().value, -0.8);
        let drag = found.drag_min.unwrap();
        assert_eq!((drag.value, drag.angle), (0.008, -3.0_f64.to_radians()));
        near(found.moment_zero, -0.15);
        // At 0 deg, 0.4 over 0.011; at 10 deg, 1.4 over 0.01942.
        near(
            found.ratio_max.map(|at| at.value),
            1.4 / (0.018 + 3.0 / 173.0 * 0.082),
        );
    }

    #[test]
    fn a_cylinder_has_drag_alone() {
        let data = AirfoilData {
            lift: vec![curve(&[(-180.0, 0.0001), (180.0, 0.0001)])],
            drag: vec![curve(&[(-180.0, 0.5), (180.0, 0.5)])],
            ..AirfoilData::default()
        };
        let found = data.characteristics()[0];
        assert_eq!(
            (found.zero_lift, found.lift_max, found.ratio_max),
            (None, None, None)
        );
        assert_eq!(found.drag_min.unwrap().value, 0.5);
    }
}
