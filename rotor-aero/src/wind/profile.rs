//! Mean wind over height and width at one time.
//!
//! ```text
//! V = V0 [ s(z) + (h (y cos d + x sin d) + v (z - zr)) / L ] + G
//! s(z) = (z/zr)^p   or   ln(z/z0)/ln(zr/z0),   0 at the ground and below
//! (Vx, Vy, Vz) = ( cos d (V cos e - W sin e), -sin d (V cos e - W sin e), V sin e + W cos e )
//! ```
//!
//! d is the direction at the height z, with veer: `d = d0 + veer (z - zr)`; the coordinate of the
//! horizontal shear has `d0`. Symbols h, v: linear shears over the length L; G: gust; W: vertical
//! wind; e: upflow angle. The sum is the one of the uniform wind of InflowWind (its theory in
//! the OpenFAST documentation), which has no veer.

use crate::real::Real;

/// Dependence of the mean wind on the height.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Shear {
    /// The same wind everywhere, also below the ground: free flight.
    #[default]
    Uniform,
    /// Power law.
    Power {
        /// Exponent \[-\].
        exponent: f64,
    },
    /// Logarithmic law.
    Log {
        /// Roughness length of the ground \[m\].
        roughness: f64,
    },
}

impl Shear {
    /// Speed over the speed at the reference height `zr` \[-\].
    fn factor<T: Real>(&self, z: T, zr: f64) -> T {
        match *self {
            Self::Uniform => T::from(1.0),
            Self::Power { exponent } if exponent == 0.0 && z.re() > 0.0 => T::from(1.0),
            Self::Power { exponent } if z.re() > 0.0 => (z / zr).powf(exponent),
            Self::Log { roughness } if z.re() > roughness => {
                (z / roughness).ln() / (zr / roughness).ln()
            }
            _ if z.re().is_nan() => z,
            _ => T::from(0.0),
        }
    }
}

/// Mean wind at one time, in axes x downwind, y lateral, z up from the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeanWind {
    /// Speed at the reference height \[m/s\].
    pub speed: f64,
    /// Reference height, positive \[m\].
    pub reference_height: f64,
    /// Dependence on the height.
    pub shear: Shear,
    /// Direction: turn of the velocity from x towards -y, clockwise seen from above \[rad\].
    pub direction: f64,
    /// Change of the direction with the height \[rad/m\].
    pub veer: f64,
    /// Upflow angle: the velocity turned upwards \[rad\].
    pub upflow: f64,
    /// Horizontal linear shear: change of speed over `reference_length` along y, as a fraction of `speed` \[-\].
    pub horizontal_shear: f64,
    /// Vertical linear shear: the same along z, zero at the reference height \[-\].
    pub vertical_shear: f64,
    /// Length over which the linear shears are given: often the diameter of the rotor \[m\].
    pub reference_length: f64,
    /// Vertical wind \[m/s\].
    pub vertical: f64,
    /// Speed that is added everywhere, along the wind \[m/s\].
    pub gust: f64,
}

impl Default for MeanWind {
    /// Still air; reference height and length are 1 m.
    fn default() -> Self {
        Self {
            speed: 0.0,
            reference_height: 1.0,
            shear: Shear::Uniform,
            direction: 0.0,
            veer: 0.0,
            upflow: 0.0,
            horizontal_shear: 0.0,
            vertical_shear: 0.0,
            reference_length: 1.0,
            vertical: 0.0,
            gust: 0.0,
        }
    }
}

impl MeanWind {
    /// Whether it is the same everywhere.
    pub fn is_uniform(&self) -> bool {
        let is_free = match self.shear {
            Shear::Uniform => true,
            // The power law of exponent zero has a ground.
            Shear::Power { .. } | Shear::Log { .. } => self.speed == 0.0,
        };
        let slopes = [self.veer, self.horizontal_shear, self.vertical_shear];
        is_free && slopes.iter().all(|slope| *slope == 0.0)
    }

    /// Velocity at a point, with `extra` speed along the wind; in the axes of the wind \[m/s\].
    pub fn velocity<T: Real>(&self, at: &[T; 3], extra: T) -> [T; 3] {
        let [x, y, z] = *at;
        let above = z - self.reference_height;
        let (sin, cos) = self.direction.sin_cos();
        let lateral = (y * cos + x * sin) * self.horizontal_shear;
        let linear = (lateral + above * self.vertical_shear) / self.reference_length;
        let profile = self.shear.factor(z, self.reference_height);
        let along = (profile + linear) * self.speed + self.gust + extra;
        let (sin, cos) = self.upflow.sin_cos();
        let level = along * cos - self.vertical * sin;
        let turned = above * self.veer + self.direction;
        [
            level * turned.cos(),
            -level * turned.sin(),
            along * sin + self.vertical * cos,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(wind: &MeanWind, at: [f64; 3]) -> [f64; 3] {
        wind.velocity(&at, 0.0)
    }

    #[test]
    fn laws_of_height() {
        let mut wind = MeanWind {
            speed: 10.0,
            reference_height: 100.0,
            shear: Shear::Power { exponent: 0.5 },
            ..Default::default()
        };
        assert_eq!(at(&wind, [3.0, 4.0, 25.0]), [5.0, 0.0, 0.0]);
        assert_eq!(at(&wind, [0.0, 0.0, 0.0]), [0.0; 3]);
        assert_eq!(at(&wind, [0.0, 0.0, -1.0]), [0.0; 3]);
        wind.shear = Shear::Log { roughness: 0.01 };
        let tenth = at(&wind, [0.0, 0.0, 1.0])[0];
        assert!((tenth - 5.0).abs() < 1e-14, "{tenth}");
        assert_eq!(at(&wind, [0.0, 0.0, 0.01])[0], 0.0);
        wind.shear = Shear::Uniform;
        assert_eq!(at(&wind, [0.0, 0.0, -50.0])[0], 10.0);
    }

    #[test]
    fn direction_is_clockwise_and_upflow_is_upwards() {
        let quarter = std::f64::consts::FRAC_PI_2;
        let mut wind = MeanWind {
            speed: 10.0,
            direction: quarter,
            ..Default::default()
        };
        let [x, y, z] = at(&wind, [0.0; 3]);
        assert!(x.abs() < 1e-14 && (y + 10.0).abs() < 1e-14 && z == 0.0);
        wind.direction = 0.0;
        wind.upflow = 0.1;
        wind.vertical = 1.0;
        let [x, _, z] = at(&wind, [0.0; 3]);
        assert!((x - (10.0 * 0.1_f64.cos() - 0.1_f64.sin())).abs() < 1e-14);
        assert!((z - (10.0 * 0.1_f64.sin() + 0.1_f64.cos())).abs() < 1e-14);
    }

    #[test]
    fn linear_shears_and_veer() {
        let wind = MeanWind {
            speed: 10.0,
            reference_height: 90.0,
            horizontal_shear: 0.3,
            vertical_shear: -0.2,
            reference_length: 100.0,
            veer: 0.001,
            gust: 0.5,
            ..Default::default()
        };
        let [x, y, _] = at(&wind, [7.0, 20.0, 140.0]);
        let speed = 10.0 * (1.0 + 0.3 * 0.2 - 0.2 * 0.5) + 0.5;
        assert!((x - speed * 0.05_f64.cos()).abs() < 1e-14);
        assert!((y + speed * 0.05_f64.sin()).abs() < 1e-14);
    }
}
