//! Sums of the strips of a rotor, and its coefficients.
//!
//! With the axis n of the shaft (the vector of the rotation), the forces F and the moments M about
//! the center of the shaft, and the speed of rotation omega:
//!
//! ```text
//! T = n . sum F                  Q = n . sum M                  P = Q omega
//! ```
//!
//! Of a rotor that turns clockwise about its axis, which is a mirror image, `T = -n . sum F`.
//!
//! T, Q and P are of the air on the blades: P is positive for turbines. The coefficients are the
//! ones of [`rotor_aero::rotor`]; for rotors and propellers torque and power are the ones that
//! the shaft must provide, -Q and -P.

use rotor_aero::rotor::{Machine, OperatingPoint, Performance};

use super::air_state::{AirState, RotorSum};

/// The definitions of coefficients of a field.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Definition {
    /// Helicopters: speed of the tip, without the factor 1/2.
    Rotor,
    /// Wind turbines: dynamic pressure of the wind.
    Wind,
    /// Propellers: revolutions per second and diameter.
    Propeller,
}

/// A quantity of a rotor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RotorQuantity {
    /// T [N].
    Thrust,
    /// Q [N m].
    Torque,
    /// P \[W\].
    Power,
    /// \[-\].
    ThrustCoefficient,
    /// \[-\].
    TorqueCoefficient,
    /// \[-\].
    PowerCoefficient,
    /// Of propellers, thrust times speed over power \[-\].
    Efficiency,
    /// Of propellers V / (n D); of rotors the speed in the plane of the disk over the speed of the
    /// tip \[-\].
    AdvanceRatio,
    /// Of wind turbines \[-\].
    TipSpeedRatio,
    /// Of rotors in hover \[-\].
    FigureOfMerit,
}

impl RotorQuantity {
    /// The definitions by which it has a value, the usual one first.
    pub fn definitions(self) -> &'static [Definition] {
        match self {
            Self::Efficiency => &[Definition::Propeller],
            Self::AdvanceRatio => &[Definition::Rotor, Definition::Propeller],
            Self::TipSpeedRatio => &[Definition::Wind],
            Self::FigureOfMerit => &[Definition::Rotor],
            _ => &[Definition::Rotor, Definition::Wind, Definition::Propeller],
        }
    }

    /// Whether its value depends on the definition.
    pub fn is_defined(self) -> bool {
        !matches!(self, Self::Thrust | Self::Torque | Self::Power)
    }
}

/// Sums of the strips of a rotor, and its motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RotorAir {
    /// T [N].
    pub thrust: f64,
    /// Q [N m].
    pub torque: f64,
    /// omega \[rad/s\].
    pub turning: f64,
    /// Speed of the center along the shaft against the air, positive in climb [m/s].
    pub climb: f64,
    /// The same across the shaft [m/s].
    pub edgewise: f64,
    /// Mean radius of the tips \[m\].
    pub radius: f64,
    /// Density of the air \[kg/m^3\].
    pub density: f64,
}

impl RotorAir {
    /// The sums over the strips of a rotor; `None` if there are none.
    pub fn of<'a>(strips: impl IntoIterator<Item = &'a AirState>) -> Option<Self> {
        let (mut count, mut sums, mut last) = (0.0, [0.0; 4], None);
        for strip in strips {
            let Some(rotor) = &strip.rotor else { continue };
            count += 1.0;
            sums[0] += RotorSum::Thrust.share(strip);
            sums[1] += RotorSum::Torque.share(strip);
            sums[2] += rotor.turning;
            sums[3] += rotor.tip_radius;
            last = Some((rotor, strip.location.side));
        }
        let (rotor, side) = last?;
        let climb = rotor.velocity.dot(&rotor.axis);
        Some(Self {
            thrust: sums[0],
            torque: sums[1],
            turning: sums[2] / count,
            radius: sums[3] / count,
            climb: side * climb,
            edgewise: (rotor.velocity - rotor.axis * climb).norm(),
            density: rotor.density,
        })
    }

    /// The sums of each rotor of these strips, by its name, in their order.
    pub fn all(strips: &[AirState]) -> Vec<(String, Self)> {
        let mut names: Vec<&str> = Vec::new();
        for name in strips
            .iter()
            .filter_map(|strip| strip.location.rotor.as_deref())
        {
            if !names.contains(&name) {
                names.push(name);
            }
        }
        let of = |name: &str| {
            let own = strips.iter();
            let own = own.filter(|strip| strip.location.rotor.as_deref() == Some(name));
            Some((name.to_owned(), Self::of(own)?))
        };
        names.into_iter().filter_map(of).collect()
    }

    /// P \[W\].
    pub fn power(&self) -> f64 {
        self.torque * self.turning
    }

    /// A quantity by a definition; not finite where the definition has no value, as without wind.
    pub fn value(&self, quantity: RotorQuantity, definition: Definition) -> f64 {
        let performance = self.performance(definition);
        match quantity {
            RotorQuantity::Thrust => self.thrust,
            RotorQuantity::Torque => self.torque,
            RotorQuantity::Power => self.power(),
            RotorQuantity::AdvanceRatio if definition == Definition::Rotor => {
                self.edgewise / (self.turning.abs() * self.radius)
            }
            RotorQuantity::AdvanceRatio => performance.propeller().advance_ratio,
            RotorQuantity::Efficiency => performance.propeller().efficiency,
            RotorQuantity::TipSpeedRatio => performance.turbine().tip_speed_ratio,
            RotorQuantity::FigureOfMerit => performance.helicopter().figure_of_merit,
            RotorQuantity::ThrustCoefficient => self.coefficients(definition)[0],
            RotorQuantity::TorqueCoefficient => self.coefficients(definition)[1],
            RotorQuantity::PowerCoefficient => self.coefficients(definition)[2],
        }
    }

    /// Coefficients of thrust, torque and power \[-\].
    pub fn coefficients(&self, definition: Definition) -> [f64; 3] {
        let performance = self.performance(definition);
        match definition {
            Definition::Rotor => {
                let found = performance.helicopter();
                [found.thrust, found.power, found.power]
            }
            Definition::Wind => {
                let found = performance.turbine();
                [found.thrust, found.torque, found.power]
            }
            Definition::Propeller => {
                let found = performance.propeller();
                [found.thrust, found.torque, found.power]
            }
        }
    }

    /// The performance with the signs of a definition.
    fn performance(&self, definition: Definition) -> Performance {
        let (machine, sign) = match definition {
            Definition::Wind => (Machine::Turbine, 1.0),
            Definition::Propeller | Definition::Rotor => (Machine::Propeller, -1.0),
        };
        Performance {
            machine,
            operating: OperatingPoint {
                speed: -sign * self.climb,
                omega: self.turning.abs(),
                density: self.density,
                ..OperatingPoint::default()
            },
            disk_radius: self.radius,
            thrust: self.thrust,
            torque: sign * self.torque * self.turning.signum(),
            power: sign * self.power(),
            unsolved: 0,
            sectors: Vec::new(),
        }
    }
}
