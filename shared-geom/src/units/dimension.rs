//! The dimension of a physical quantity: exponents of the base quantities.

use std::fmt;

/// Exponents of the base quantities of a physical quantity.
///
/// Angle is distinguished from the pure numbers so that degrees cannot be given where a
/// ratio is expected; it is the radian inside. Temperatures are rises, that is
/// differences: they have no zero of a scale, and a rise of 1 degC is one of 1 K.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Dimension {
    /// Exponent of length (m).
    pub length: i8,
    /// Exponent of mass (kg).
    pub mass: i8,
    /// Exponent of time (s).
    pub time: i8,
    /// Exponent of angle (rad).
    pub angle: i8,
    /// Exponent of temperature rise (K).
    pub temperature: i8,
    /// Exponent of electric current (A).
    pub current: i8,
}

impl Dimension {
    /// A pure number.
    pub const NUMBER: Self = Self::of(0, 0, 0, 0);
    /// Length, in meters inside.
    pub const LENGTH: Self = Self::of(1, 0, 0, 0);
    /// Mass, in kilograms inside.
    pub const MASS: Self = Self::of(0, 1, 0, 0);
    /// Time, in seconds inside.
    pub const TIME: Self = Self::of(0, 0, 1, 0);
    /// Angle, in radians inside.
    pub const ANGLE: Self = Self::of(0, 0, 0, 1);
    /// Force, in newtons inside.
    pub const FORCE: Self = Self::of(1, 1, -2, 0);
    /// Stress and moduli, in pascals inside.
    pub const STRESS: Self = Self::of(-1, 1, -2, 0);
    /// Mass per volume, in kg/m^3 inside.
    pub const DENSITY: Self = Self::of(-3, 1, 0, 0);
    /// Speed of rotation, in rad/s inside.
    pub const ROTATION_SPEED: Self = Self::of(0, 0, -1, 1);
    /// Cycles per time, in Hz inside.
    pub const FREQUENCY: Self = Self::of(0, 0, -1, 0);
    /// Bending and torsional stiffness, in N m^2 inside.
    pub const BENDING_STIFFNESS: Self = Self::of(3, 1, -2, 0);
    /// Moment of force, in N m inside.
    pub const MOMENT: Self = Self::of(2, 1, -2, 0);
    /// Mass per length, in kg/m inside.
    pub const MASS_PER_LENGTH: Self = Self::of(-1, 1, 0, 0);
    /// Moment of inertia per length, in kg m inside.
    pub const INERTIA_PER_LENGTH: Self = Self::of(1, 1, 0, 0);
    /// Moment of inertia, in kg m^2 inside.
    pub const INERTIA: Self = Self::of(2, 1, 0, 0);
    /// Force per displacement, in N/m inside.
    pub const SPRING_STIFFNESS: Self = Self::of(0, 1, -2, 0);
    /// Force per velocity, in N s/m inside.
    pub const DAMPER: Self = Self::of(0, 1, -1, 0);
    /// Moment per angular velocity in radians per time, in N m s inside.
    pub const TURNING_DAMPER: Self = Self::of(2, 1, -1, 0);
    /// Axial and shear viscosity of a section, in N s inside.
    pub const FORCE_TIME: Self = Self::of(1, 1, -1, 0);
    /// Bending and torsional viscosity of a section, in N m^2 s inside.
    pub const BENDING_TIME: Self = Self::of(3, 1, -1, 0);
    /// Velocity, in m/s inside.
    pub const VELOCITY: Self = Self::of(1, 0, -1, 0);
    /// Force per length, in N/m inside.
    pub const FORCE_PER_LENGTH: Self = Self::of(0, 1, -2, 0);
    /// Acceleration, in m/s^2 inside.
    pub const ACCELERATION: Self = Self::of(1, 0, -2, 0);
    /// Rise of temperature, in K inside.
    pub const TEMPERATURE: Self = Self::of(0, 0, 0, 0).of_temperature(1);
    /// Coefficient of expansion, strain per rise of temperature, in 1/K inside.
    pub const EXPANSION: Self = Self::of(0, 0, 0, 0).of_temperature(-1);
    /// Gradient of temperature, in K/m inside.
    pub const TEMPERATURE_GRADIENT: Self = Self::of(-1, 0, 0, 0).of_temperature(1);
    /// Force per rise of temperature, in N/K inside.
    pub const THERMAL_FORCE: Self = Self::of(1, 1, -2, 0).of_temperature(-1);
    /// Moment per rise of temperature, in N m/K inside.
    pub const THERMAL_MOMENT: Self = Self::of(2, 1, -2, 0).of_temperature(-1);
    /// Force per volume, in N/m^3 inside.
    pub const FORCE_PER_VOLUME: Self = Self::of(-2, 1, -2, 0);
    /// Voltage, in V inside.
    pub const VOLTAGE: Self = Self::of(2, 1, -3, 0).of_current(-1);
    /// Electric current, in A inside.
    pub const CURRENT: Self = Self::of(0, 0, 0, 0).of_current(1);
    /// Electric charge, in C inside.
    pub const CHARGE: Self = Self::of(0, 0, 1, 0).of_current(1);
    /// Charge per length of a beam, in C/m inside.
    pub const CHARGE_PER_LENGTH: Self = Self::of(-1, 0, 1, 0).of_current(1);
    /// Charge per area, which is stress per electric field, in C/m^2 inside.
    pub const CHARGE_PER_AREA: Self = Self::of(-2, 0, 1, 0).of_current(1);
    /// Capacitance, in F inside.
    pub const CAPACITANCE: Self = Self::of(-2, -1, 4, 0).of_current(2);
    /// Resistance, in ohms inside.
    pub const RESISTANCE: Self = Self::of(2, 1, -3, 0).of_current(-2);
    /// Inductance, in H inside.
    pub const INDUCTANCE: Self = Self::of(2, 1, -2, 0).of_current(-2);
    /// Permittivity, in F/m inside.
    pub const PERMITTIVITY: Self = Self::of(-3, -1, 4, 0).of_current(2);
    /// Strain per electric field, in m/V inside.
    pub const STRAIN_PER_FIELD: Self = Self::of(-1, -1, 3, 0).of_current(1);
    /// Twist rate and curvature of a line, in rad/m inside.
    pub const CURVATURE: Self = Self::of(-1, 0, 0, 1);

    /// Power, in W inside.
    pub const POWER: Self = Self::of(2, 1, -3, 0);
    /// Dynamic viscosity, in Pa s inside.
    pub const VISCOSITY: Self = Self::of(-1, 1, -1, 0);

    const fn of(length: i8, mass: i8, time: i8, angle: i8) -> Self {
        Self {
            length,
            mass,
            time,
            angle,
            temperature: 0,
            current: 0,
        }
    }

    const fn of_current(self, current: i8) -> Self {
        Self { current, ..self }
    }

    const fn of_temperature(self, temperature: i8) -> Self {
        Self {
            temperature,
            ..self
        }
    }

    /// Product with `other` raised to `power`; exponents saturate.
    #[must_use]
    pub fn times(self, other: Self, power: i8) -> Self {
        let add = |a: i8, b: i8| a.saturating_add(b.saturating_mul(power));
        Self {
            length: add(self.length, other.length),
            mass: add(self.mass, other.mass),
            time: add(self.time, other.time),
            angle: add(self.angle, other.angle),
            temperature: add(self.temperature, other.temperature),
            current: add(self.current, other.current),
        }
    }
}

impl fmt::Display for Dimension {
    /// The name of the quantity if it has one, else the SI unit.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let word = match *self {
            Self::NUMBER => "a pure number",
            Self::LENGTH => "a length",
            Self::MASS => "a mass",
            Self::TIME => "a time",
            Self::ANGLE => "an angle",
            Self::FORCE => "a force",
            Self::STRESS => "a stress",
            Self::DENSITY => "a density",
            Self::VISCOSITY => "a dynamic viscosity",
            Self::VELOCITY => "a velocity",
            Self::ACCELERATION => "an acceleration",
            Self::FORCE_PER_VOLUME => "a force per volume",
            Self::ROTATION_SPEED => "a rotation speed",
            Self::FREQUENCY => "a frequency",
            Self::BENDING_STIFFNESS => "a bending or torsional stiffness",
            Self::MOMENT => "a moment",
            Self::POWER => "a power",
            Self::MASS_PER_LENGTH => "a mass per length",
            Self::INERTIA_PER_LENGTH => "a moment of inertia per length",
            Self::INERTIA => "a moment of inertia",
            Self::SPRING_STIFFNESS => "a force per length",
            Self::DAMPER => "a force per velocity",
            Self::TURNING_DAMPER => "a moment per angular velocity",
            Self::TEMPERATURE => "a rise of temperature",
            Self::EXPANSION => "an expansion coefficient",
            Self::TEMPERATURE_GRADIENT => "a gradient of temperature",
            Self::CURVATURE => "a curvature (angle per length)",
            Self::VOLTAGE => "a voltage",
            Self::CURRENT => "an electric current",
            Self::CHARGE => "a charge",
            Self::CHARGE_PER_LENGTH => "a charge per length",
            Self::CHARGE_PER_AREA => "a charge per area (stress per electric field)",
            Self::CAPACITANCE => "a capacitance",
            Self::RESISTANCE => "a resistance",
            Self::INDUCTANCE => "an inductance",
            Self::PERMITTIVITY => "a permittivity",
            Self::STRAIN_PER_FIELD => "a strain per electric field",
            _ => return self.write_units(f),
        };
        f.write_str(word)
    }
}

impl Dimension {
    fn write_units(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a quantity in")?;
        let parts = [
            ("kg", self.mass),
            ("m", self.length),
            ("s", self.time),
            ("rad", self.angle),
            ("K", self.temperature),
            ("A", self.current),
        ];
        for (unit, power) in parts.into_iter().filter(|part| part.1 != 0) {
            match power {
                1 => write!(f, " {unit}")?,
                _ => write!(f, " {unit}^{power}")?,
            }
        }
        Ok(())
    }
}
