//! Axes of the wind.

use nalgebra::{Matrix3, Vector3};

use super::problem::WindProblem;
use crate::real::Real;

/// Axes in which a wind is described: x downwind, y lateral (y = z cross x), z up.
#[derive(Debug, Clone, PartialEq)]
pub struct WindFrame {
    /// A point on the ground, in the inertial frame: the foot of the tower \[m\].
    origin: Vector3<f64>,
    /// Unit vectors downwind, lateral and up, in this order, as rows.
    axes: Matrix3<f64>,
}

impl Default for WindFrame {
    /// The inertial frame itself: x downwind, z up.
    fn default() -> Self {
        Self {
            origin: Vector3::zeros(),
            axes: Matrix3::identity(),
        }
    }
}

impl WindFrame {
    /// The frame with its `origin` on the ground, from the directions `downwind` and `up` of any
    /// length; of `downwind` the part normal to `up` is used.
    ///
    /// # Errors
    /// A zero, infinite or missing direction, or two parallel ones.
    pub fn new(
        origin: Vector3<f64>,
        downwind: Vector3<f64>,
        up: Vector3<f64>,
    ) -> Result<Self, WindProblem> {
        let wrong = |what: &str, found: &Vector3<f64>| WindProblem::Value {
            what: what.to_owned(),
            found: format!("({}, {}, {})", found.x, found.y, found.z),
            expected: "a finite vector, not zero, downwind not parallel to up".to_owned(),
            help: "give the direction into which the wind blows, and the vertical".to_owned(),
        };
        if !origin.iter().all(|value| value.is_finite()) {
            return Err(wrong("the origin of the wind", &origin));
        }
        let z = up
            .try_normalize(f64::MIN_POSITIVE)
            .filter(|z| z.iter().all(|value| value.is_finite()))
            .ok_or_else(|| wrong("the upward direction", &up))?;
        let across = downwind - z * z.dot(&downwind);
        let x = across
            .try_normalize(1e-9 * downwind.norm().max(f64::MIN_POSITIVE))
            .filter(|x| x.iter().all(|value| value.is_finite()))
            .ok_or_else(|| wrong("the downwind direction", &downwind))?;
        let y = z.cross(&x);
        let axes = Matrix3::from_rows(&[x.transpose(), y.transpose(), z.transpose()]);
        Ok(Self { origin, axes })
    }

    /// The frame of a `velocity` \[m/s\] of any direction: x along its level part, or along any
    /// level direction if it has none.
    ///
    /// # Errors
    /// As [`WindFrame::new`], without demands on the velocity but to be finite.
    pub fn along(
        origin: Vector3<f64>,
        velocity: &Vector3<f64>,
        up: Vector3<f64>,
    ) -> Result<Self, WindProblem> {
        let is_finite = velocity.iter().all(|value| value.is_finite());
        let directions = [*velocity, Vector3::x(), Vector3::y()];
        let frames = directions.map(|downwind| Self::new(origin, downwind, up));
        let [own, x, y] = frames;
        if is_finite { own.or(x).or(y) } else { own }
    }

    /// Components in these axes of a vector of the inertial frame.
    pub fn components(&self, of: &Vector3<f64>) -> [f64; 3] {
        (self.axes * of).into()
    }

    /// The upward unit vector, in the inertial frame \[-\].
    pub fn up(&self) -> Vector3<f64> {
        self.axes.row(2).transpose()
    }

    /// Components in these axes of a point of the inertial frame \[m\].
    pub fn point<T: Real>(&self, at: &[T; 3]) -> [T; 3] {
        let from_origin = [0, 1, 2].map(|i| at[i] - self.origin[i]);
        [0, 1, 2].map(|i| self.row(i, &from_origin))
    }

    /// Components in the inertial frame of a vector of these axes.
    pub fn vector<T: Real>(&self, of: &[T; 3]) -> [T; 3] {
        [0, 1, 2].map(|i| {
            of[0] * self.axes[(0, i)] + of[1] * self.axes[(1, i)] + of[2] * self.axes[(2, i)]
        })
    }

    fn row<T: Real>(&self, i: usize, of: &[T; 3]) -> T {
        of[0] * self.axes[(i, 0)] + of[1] * self.axes[(i, 1)] + of[2] * self.axes[(i, 2)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_are_right_handed_and_maps_are_inverse() {
        // wind towards -y of a frame whose vertical is x
        let up = Vector3::new(2.0, 0.0, 0.0);
        let frame = WindFrame::new(
            Vector3::new(1.0, 2.0, 3.0),
            Vector3::new(5.0, -4.0, 0.0),
            up,
        )
        .unwrap();
        assert_eq!(frame.vector(&[1.0, 0.0, 0.0]), [0.0, -1.0, 0.0]);
        assert_eq!(frame.vector(&[0.0, 0.0, 1.0]), [1.0, 0.0, 0.0]);
        // lateral: up cross downwind = x cross -y = -z
        assert_eq!(frame.vector(&[0.0, 1.0, 0.0]), [0.0, 0.0, -1.0]);
        assert_eq!(frame.point(&[1.5, 0.0, 7.0]), [2.0, -4.0, 0.5]);
    }

    #[test]
    fn frames_along_any_velocity() {
        let up = Vector3::new(0.0, 0.0, 3.0);
        let origin = Vector3::new(1.0, 0.0, 0.0);
        let level = |velocity: [f64; 3]| {
            let frame = WindFrame::along(origin, &velocity.into(), up).unwrap();
            frame.components(&velocity.into())
        };
        assert_eq!(level([0.0, -3.0, 4.0]), [3.0, 0.0, 4.0]);
        assert_eq!(level([0.0, 0.0, -2.0]), [0.0, 0.0, -2.0]);
        assert_eq!(level([0.0; 3]), [0.0; 3]);
        let along_x = WindFrame::along(origin, &Vector3::x(), Vector3::x()).unwrap();
        assert_eq!(along_x.components(&Vector3::x()), [0.0, 0.0, 1.0]);
        assert!(WindFrame::along(origin, &Vector3::repeat(f64::NAN), up).is_err());
    }

    #[test]
    fn useless_directions_are_refused() {
        let [o, x] = [Vector3::zeros(), Vector3::x()];
        assert!(WindFrame::new(o, x, x).is_err());
        assert!(WindFrame::new(o, x, o).is_err());
        assert!(WindFrame::new(o, o, x).is_err());
        assert!(WindFrame::new(o, x * f64::NAN, Vector3::z()).is_err());
        assert!(WindFrame::new(x * f64::INFINITY, x, Vector3::z()).is_err());
        assert!(WindFrame::new(o, x, Vector3::z() * f64::INFINITY).is_err());
    }
}
