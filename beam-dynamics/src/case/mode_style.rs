//! Words, units and multiples of the tables and figures of modes.

use std::f64::consts::TAU;

/// Words for the motion of blades.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Words {
    /// Lag, progressive, regressive: helicopters.
    #[default]
    Rotor,
    /// Edge, forward, backward: wind turbines.
    Wind,
}

impl Words {
    /// The words in files, in the order of [`Self::ALL`].
    pub const NAMES: [&str; 2] = ["rotor", "wind"];
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Rotor, Self::Wind];

    /// The word in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rotor => "rotor",
            Self::Wind => "wind",
        }
    }
}

/// Unit of frequencies in tables and figures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FrequencyUnit {
    /// Cycles per second.
    #[default]
    Hertz,
    /// Cycles per minute.
    Rpm,
    /// Radians per second.
    RadiansPerSecond,
    /// Cycles per revolution of the rotor.
    PerRevolution,
}

impl FrequencyUnit {
    /// The words in files, in the order of [`Self::ALL`].
    pub const NAMES: [&str; 4] = ["Hz", "rpm", "rad/s", "1/rev"];
    /// All of them.
    pub const ALL: [Self; 4] = [
        Self::Hertz,
        Self::Rpm,
        Self::RadiansPerSecond,
        Self::PerRevolution,
    ];

    /// The unit as text.
    pub fn word(self) -> &'static str {
        match self {
            Self::Hertz => "Hz",
            Self::Rpm => "rpm",
            Self::RadiansPerSecond => "rad/s",
            Self::PerRevolution => "1/rev",
        }
    }

    /// A frequency \[Hz\] at a rotor speed \[rad/s\] in this unit; `None` per revolution at rest.
    pub fn value(self, frequency: f64, speed: f64) -> Option<f64> {
        match self {
            Self::Hertz => Some(frequency),
            Self::Rpm => Some(60.0 * frequency),
            Self::RadiansPerSecond => Some(TAU * frequency),
            Self::PerRevolution => (speed > 0.0).then(|| TAU * frequency / speed),
        }
    }

    /// The unit of a column beside the one of frequencies per revolution: hertz, if these are chosen.
    pub fn of_column(self) -> Self {
        match self {
            Self::PerRevolution => Self::Hertz,
            unit => unit,
        }
    }

    /// The unit of rotor speeds that belongs to this unit, as text: `rad/s` or `rpm`.
    pub fn speed_word(self) -> &'static str {
        match self {
            Self::RadiansPerSecond => "rad/s",
            _ => "rpm",
        }
    }

    /// A rotor speed \[rad/s\] in the unit of [`Self::speed_word`].
    pub fn speed(self, speed: f64) -> f64 {
        match self {
            Self::RadiansPerSecond => speed,
            _ => 60.0 / TAU * speed,
        }
    }
}

/// How modes are named and drawn.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ModeStyle {
    /// Words of names and tables.
    pub words: Words,
    /// Unit of frequencies in tables and figures.
    pub unit: FrequencyUnit,
    /// Multiples of the rotor speed in figures and among the critical speeds, ascending; empty:
    /// chosen by the number of blades.
    pub harmonics: Vec<u32>,
    /// Speed, among the requested ones, at which modes are named; `None`: the first
    /// [rad/s].
    pub name_at: Option<f64>,
}

#[cfg(test)]
mod tests {
    use super::*;

    // 2 Hz at 60 rpm, which is 1 Hz.
    #[test]
    fn frequencies_have_their_units() {
        let values = FrequencyUnit::ALL.map(|unit| unit.value(2.0, TAU));
        assert_eq!(values, [2.0, 120.0, 2.0 * TAU, 2.0].map(Some));
        assert_eq!(FrequencyUnit::PerRevolution.value(2.0, 0.0), None);
        let speeds = FrequencyUnit::ALL.map(|unit| (unit.speed(TAU), unit.speed_word()));
        let rpm = (60.0, "rpm");
        assert_eq!(speeds, [rpm, rpm, (TAU, "rad/s"), rpm]);
        assert_eq!(
            FrequencyUnit::ALL.map(FrequencyUnit::word),
            FrequencyUnit::NAMES
        );
    }
}
