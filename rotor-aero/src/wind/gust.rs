//! Gusts resolved in space: a front travels through the air at a given speed.
//!
//! ```text
//! v(x, t) = a g(s),   s = s0 + U t - x . d          (distance behind the front)
//! 1 - cos:    g = (1 - cos(2 pi s/L))/2 for 0 < s < L, else 0
//! sharp edge: g = 1 for s > 0, with a ramp of length r before: g = s/r for 0 < s < r
//! harmonic:   g = sin(2 pi s/L) for s > 0
//! ```
//!
//! The first is the discrete gust of CS 25.341, with the gradient distance H = L/2.

use std::f64::consts::TAU;

use super::problem::WindProblem;
use crate::real::Real;

/// Shape of a gust over the distance behind its front.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GustShape {
    /// One minus cosine.
    OneMinusCosine {
        /// Length \[m\].
        length: f64,
    },
    /// Step, or ramp to a constant.
    SharpEdge {
        /// Length of the ramp; 0 for a step \[m\].
        ramp: f64,
    },
    /// Sine behind the front.
    Harmonic {
        /// Wavelength \[m\].
        length: f64,
    },
}

/// A gust that travels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TravelingGust {
    /// Shape.
    pub shape: GustShape,
    /// Velocity where the shape is 1, in the axes of the wind \[m/s\].
    pub velocity: [f64; 3],
    /// Unit vector of travel, in the axes of the wind \[-\].
    pub direction: [f64; 3],
    /// Convection speed \[m/s\].
    pub convection: f64,
    /// Position of the front along the direction at the time 0 \[m\].
    pub front: f64,
}

impl TravelingGust {
    /// Checks the lengths and the direction.
    ///
    /// # Errors
    /// The first value that is not usable.
    pub fn check(&self) -> Result<(), WindProblem> {
        let (what, length, least) = match self.shape {
            GustShape::OneMinusCosine { length } => ("length of the gust", length, 1e-9),
            GustShape::SharpEdge { ramp } => ("ramp of the gust", ramp, 0.0),
            GustShape::Harmonic { length } => ("wavelength of the gust", length, 1e-9),
        };
        if !(length >= least && length.is_finite()) {
            let help = "give the length in meters";
            return Err(WindProblem::value(what, length, "a positive length", help));
        }
        let norm = self.direction.iter().map(|d| d * d).sum::<f64>().sqrt();
        if norm.is_nan() || (norm - 1.0).abs() > 1e-6 {
            let help = "divide the direction of travel by its length";
            let what = "length of the direction of travel";
            return Err(WindProblem::value(what, norm, "1", help));
        }
        Ok(())
    }

    /// Times at which its front, its middle and its end pass a point, in the axes of the wind
    /// \[s\]; none if it does not travel.
    pub fn corners(&self, at: &[f64; 3]) -> impl Iterator<Item = f64> + use<> {
        let d = self.direction;
        let along = at[0] * d[0] + at[1] * d[1] + at[2] * d[2];
        let [behind, speed] = [along - self.front, self.convection];
        let distances = match self.shape {
            GustShape::OneMinusCosine { length } => [0.0, 0.5 * length, length],
            GustShape::SharpEdge { ramp } => [0.0, ramp, ramp],
            // The front, the first peak and the first zero: from there on the wave is smooth.
            GustShape::Harmonic { length } => [0.0, 0.25 * length, 0.5 * length],
        };
        let times = distances.map(|distance| (distance + behind) / speed);
        times.into_iter().filter(|time| time.is_finite())
    }

    /// Velocity at a point, in the axes of the wind \[m/s\].
    pub fn velocity<T: Real>(&self, at: &[T; 3], time: f64) -> [T; 3] {
        let d = self.direction;
        let along = at[0] * d[0] + at[1] * d[1] + at[2] * d[2];
        let s = -along + (self.front + self.convection * time);
        let g = self.shape.value(s);
        self.velocity.map(|a| g * a)
    }
}

impl GustShape {
    fn value<T: Real>(&self, s: T) -> T {
        if s.re() <= 0.0 {
            return T::from(0.0);
        }
        match *self {
            Self::OneMinusCosine { length } if s.re() < length => {
                -((s * (TAU / length)).cos() - 1.0) * 0.5
            }
            Self::OneMinusCosine { .. } => T::from(0.0),
            Self::SharpEdge { ramp } if s.re() < ramp => s / ramp,
            Self::SharpEdge { .. } => T::from(1.0),
            Self::Harmonic { length } => (s * (TAU / length)).sin(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gust(shape: GustShape) -> TravelingGust {
        TravelingGust {
            shape,
            velocity: [0.0, 0.0, 10.0],
            direction: [1.0, 0.0, 0.0],
            convection: 20.0,
            front: -100.0,
        }
    }

    #[test]
    fn the_front_arrives_in_time() {
        let edge = gust(GustShape::SharpEdge { ramp: 0.0 });
        assert_eq!(edge.velocity(&[0.0; 3], 4.99), [0.0; 3]);
        assert_eq!(edge.velocity(&[0.0; 3], 5.01), [0.0, 0.0, 10.0]);
        // 20 m downwind a second later
        assert_eq!(edge.velocity(&[20.0, 0.0, 0.0], 5.99)[2], 0.0);
        assert_eq!(edge.velocity(&[20.0, 0.0, 0.0], 6.01)[2], 10.0);
    }

    #[test]
    fn corners_are_where_the_shape_begins_and_ends() {
        let cosine = gust(GustShape::OneMinusCosine { length: 50.0 });
        let at = [20.0, 3.0, 4.0];
        let corners: Vec<f64> = cosine.corners(&at).collect();
        assert_eq!(corners, [6.0, 7.25, 8.5]);
        for (corner, value) in corners.into_iter().zip([0.0, 10.0, 0.0]) {
            assert!((cosine.velocity(&at, corner)[2] - value).abs() < 1e-14);
        }
        let mut still = cosine;
        still.convection = 0.0;
        assert_eq!(still.corners(&at).count(), 0);
    }

    #[test]
    fn shapes_over_the_distance() {
        let cosine = GustShape::OneMinusCosine { length: 50.0 };
        for (s, value) in [
            (-1.0, 0.0),
            (12.5, 0.5),
            (25.0, 1.0),
            (50.0, 0.0),
            (80.0, 0.0),
        ] {
            assert!(f64::abs(cosine.value(s) - value) < 1e-15);
        }
        let sine = GustShape::Harmonic { length: 40.0 };
        for (s, value) in [(-10.0, 0.0), (10.0, 1.0), (30.0, -1.0), (50.0, 1.0)] {
            assert!(f64::abs(sine.value(s) - value) < 1e-14);
        }
        let ramp = GustShape::SharpEdge { ramp: 4.0 };
        assert_eq!([1.0, 4.0, 9.0].map(|s| ramp.value(s)), [0.25, 1.0, 1.0]);
    }

    #[test]
    fn useless_gusts_are_refused() {
        assert!(
            gust(GustShape::OneMinusCosine { length: 0.0 })
                .check()
                .is_err()
        );
        assert!(
            gust(GustShape::Harmonic { length: f64::NAN })
                .check()
                .is_err()
        );
        let mut long = gust(GustShape::SharpEdge { ramp: 0.0 });
        assert!(long.check().is_ok());
        long.direction = [2.0, 0.0, 0.0];
        assert!(long.check().is_err());
    }
}
