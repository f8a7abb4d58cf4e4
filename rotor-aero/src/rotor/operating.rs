//! The operating point, and the air that it brings to a section.
//!
//! With the azimuth psi from the blade up, the lean kappa of the span, tilt t and yaw y,
//!
//! ```text
//! h = z cos psi cos t - x sin t,  V = speed (1 + h / H)^p
//! Vx = V [(cos y sin t cos psi + sin y sin psi) sin kappa + cos y cos t cos kappa]
//! Vy = V (cos y sin t sin psi - sin y cos psi) + omega z
//! ```
//!
//! Ning, Wind Energy 17 (2014) 1327, with its rotation: clockwise as seen from upwind.

use crate::momentum::Ambient;
use crate::rotor::blade::{Point, RigidRotor};

/// A steady operating point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OperatingPoint {
    /// Speed of the wind at the hub, or speed of flight along the shaft \[m/s\].
    pub speed: f64,
    /// Speed of rotation, positive \[rad/s\].
    pub omega: f64,
    /// Pitch, added to the twist \[rad\].
    pub pitch: f64,
    /// Density of the air \[kg/m^3\].
    pub density: f64,
    /// Dynamic viscosity, for Reynolds numbers \[Pa s\].
    pub viscosity: f64,
    /// Speed of sound, for Mach numbers \[m/s\].
    pub speed_of_sound: f64,
    /// Exponent of the vertical shear of the wind \[-\].
    pub shear_exponent: f64,
}

impl Default for OperatingPoint {
    /// Still air at sea level in the standard atmosphere, without shear.
    fn default() -> Self {
        Self {
            speed: 0.0,
            omega: 0.0,
            pitch: 0.0,
            density: 1.225,
            viscosity: 1.81e-5,
            speed_of_sound: 340.3,
            shear_exponent: 0.0,
        }
    }
}

impl<S> RigidRotor<S> {
    /// The air at a point of the blade at an azimuth, without induction; its velocity in the
    /// plane of the disk is not part of it.
    pub(crate) fn ambient(
        &self,
        operating: &OperatingPoint,
        point: &Point,
        azimuth: f64,
    ) -> Ambient<f64> {
        let (sin, cos) = azimuth.sin_cos();
        let (sin_tilt, cos_tilt) = self.tilt.sin_cos();
        let (sin_yaw, cos_yaw) = self.yaw.sin_cos();
        let (sin_lean, cos_lean) = point.lean.sin_cos();
        let height = point.z * cos * cos_tilt - point.x * sin_tilt;
        let wind = operating.speed * shear(height, self.hub_height, operating.shear_exponent);
        let radial = cos_yaw * sin_tilt * cos + sin_yaw * sin;
        let around = cos_yaw * sin_tilt * sin - sin_yaw * cos;
        Ambient {
            axial: wind * (radial * sin_lean + cos_yaw * cos_tilt * cos_lean),
            rotation: wind * around + operating.omega * point.z,
            skew: 0.0,
        }
    }

    /// Angle of the wind to the shaft, and the azimuth towards which it blows in the disk \[rad\].
    pub(crate) fn wind_angles(&self) -> (f64, f64) {
        let axial = self.yaw.cos() * self.tilt.cos();
        // the components of the wind at the azimuths 0 and 90 degrees, along the radius
        let (up, side) = (self.yaw.cos() * self.tilt.sin(), self.yaw.sin());
        (up.hypot(side).atan2(axial), side.atan2(up))
    }
}

/// Speed at a height above the hub over the speed at the hub; zero below the ground.
fn shear(height: f64, hub_height: f64, exponent: f64) -> f64 {
    if exponent == 0.0 || hub_height <= 0.0 {
        return 1.0;
    }
    (1.0 + height / hub_height).max(0.0).powf(exponent)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shear_is_a_power_law_above_the_ground() {
        assert_eq!(shear(-100.0, 90.0, 0.2), 0.0);
        assert_eq!(shear(0.0, 90.0, 0.2), 1.0);
        assert!((shear(90.0, 90.0, 0.2) - 2f64.powf(0.2)).abs() < 1e-15);
        assert_eq!(shear(40.0, 0.0, 0.2), 1.0);
    }
}
