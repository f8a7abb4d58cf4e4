//! Coefficients of performance, by the definitions of each field.

use std::f64::consts::{PI, TAU};

use crate::rotor::performance::Performance;

/// By the wind and the disk, of wind turbines.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TurbineCoefficients {
    /// P / (rho A V^3 / 2) \[-\].
    pub power: f64,
    /// T / (rho A V^2 / 2) \[-\].
    pub thrust: f64,
    /// Q / (rho A R V^2 / 2) \[-\].
    pub torque: f64,
    /// Speed of the tip over the wind, omega R / V \[-\].
    pub tip_speed_ratio: f64,
}

/// By revolutions per second n and the diameter D, of propellers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PropellerCoefficients {
    /// T / (rho n^2 D^4) \[-\].
    pub thrust: f64,
    /// P / (rho n^3 D^5) \[-\].
    pub power: f64,
    /// Q / (rho n^2 D^5) \[-\].
    pub torque: f64,
    /// T V / P \[-\].
    pub efficiency: f64,
    /// Advance ratio, V / (n D) \[-\].
    pub advance_ratio: f64,
}

/// By the speed of the tip and the disk, of helicopters (without the factor 1/2).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HelicopterCoefficients {
    /// T / (rho A (omega R)^2) \[-\].
    pub thrust: f64,
    /// P / (rho A (omega R)^3), equal to the coefficient of torque \[-\].
    pub power: f64,
    /// Figure of merit in hover, thrust^1.5 / (sqrt(2) power) \[-\].
    pub figure_of_merit: f64,
    /// Speed of flight along the shaft over the speed of the tip \[-\].
    pub climb_ratio: f64,
}

impl Performance {
    /// Coefficients of wind turbines; not finite without wind.
    pub fn turbine(&self) -> TurbineCoefficients {
        let (speed, area) = (self.operating.speed, PI * self.disk_radius.powi(2));
        let force = 0.5 * self.operating.density * area * speed * speed;
        TurbineCoefficients {
            power: self.power / (force * speed),
            thrust: self.thrust / force,
            torque: self.torque / (force * self.disk_radius),
            tip_speed_ratio: self.operating.omega * self.disk_radius / speed,
        }
    }

    /// Coefficients of propellers; not finite without rotation.
    pub fn propeller(&self) -> PropellerCoefficients {
        let (n, diameter) = (self.operating.omega / TAU, 2.0 * self.disk_radius);
        let force = self.operating.density * n * n * diameter.powi(4);
        PropellerCoefficients {
            thrust: self.thrust / force,
            power: self.power / (force * n * diameter),
            torque: self.torque / (force * diameter),
            efficiency: self.thrust * self.operating.speed / self.power,
            advance_ratio: self.operating.speed / (n * diameter),
        }
    }

    /// Coefficients of helicopters; not finite without rotation.
    pub fn helicopter(&self) -> HelicopterCoefficients {
        let tip_speed = self.operating.omega * self.disk_radius;
        let area = PI * self.disk_radius.powi(2);
        let force = self.operating.density * area * tip_speed * tip_speed;
        let (thrust, power) = (self.thrust / force, self.power / (force * tip_speed));
        HelicopterCoefficients {
            thrust,
            power,
            figure_of_merit: thrust.max(0.0).powf(1.5) / (2f64.sqrt() * power),
            climb_ratio: self.operating.speed / tip_speed,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rotor::blade::Machine;
    use crate::rotor::operating::OperatingPoint;

    /// The coefficients of thrust of propellers and helicopters differ by 4 / pi^3.
    #[test]
    fn definitions_agree() {
        let performance = Performance {
            machine: Machine::Propeller,
            operating: OperatingPoint {
                speed: 5.0,
                omega: 300.0,
                ..OperatingPoint::default()
            },
            disk_radius: 0.4,
            thrust: 12.0,
            torque: 0.3,
            power: 90.0,
            unsolved: 0,
            sectors: Vec::new(),
        };
        let (own, other) = (performance.propeller(), performance.helicopter());
        assert!((own.thrust * 4.0 / PI.powi(3) - other.thrust).abs() < 1e-15);
        assert!((own.power - TAU * own.torque).abs() < 1e-15);
        let efficiency = own.advance_ratio * own.thrust / own.power;
        assert!((own.efficiency - efficiency).abs() < 1e-15);
        let turbine = performance.turbine();
        assert!((turbine.power - turbine.torque * turbine.tip_speed_ratio).abs() < 1e-12);
    }
}
