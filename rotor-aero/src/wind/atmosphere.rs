//! The International Standard Atmosphere to 20 km (ISO 2533, geopotential altitude).
//!
//! ```text
//! troposphere, to 11 km:  T = T0 - L h,   p = p0 (T / T0)^(g / (L R))
//! above, to 20 km:        T = T11,        p = p11 exp(-g (h - 11 km) / (R T11))
//! rho = p / (R (T + dT)),  a = sqrt(1.4 R (T + dT)),
//! mu = 1.458e-6 (T + dT)^1.5 / (T + dT + 110.4)     (Sutherland)
//! ```
//!
//! A temperature offset dT leaves the pressure unchanged.

use super::problem::WindProblem;

const SEA_TEMPERATURE: f64 = 288.15;
const SEA_PRESSURE: f64 = 101_325.0;
const LAPSE: f64 = 0.0065;
const GRAVITY: f64 = 9.80665;
const GAS: f64 = 287.05287;
const HEAT_RATIO: f64 = 1.4;
const TROPOPAUSE: f64 = 11_000.0;
const CEILING: f64 = 20_000.0;
const FLOOR: f64 = -2_000.0;

/// The still air, as elements use it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Atmosphere {
    /// Density \[kg m^-3\].
    pub density: f64,
    /// Temperature \[K\].
    pub temperature: f64,
    /// Static pressure; of the standard atmosphere, also if the density is given \[Pa\].
    pub pressure: f64,
    /// Speed of sound \[m/s\].
    pub sound_speed: f64,
    /// Dynamic viscosity \[Pa s\].
    pub viscosity: f64,
}

impl Default for Atmosphere {
    fn default() -> Self {
        standard(0.0, 0.0)
    }
}

/// The air as a user describes it: given values replace the ones of the standard atmosphere.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct AtmosphereInput {
    /// Altitude above sea level, -2 km to 20 km \[m\].
    pub altitude: f64,
    /// Difference to the standard temperature at this altitude \[K\].
    pub temperature_offset: f64,
    /// Density, if given \[kg m^-3\].
    pub density: Option<f64>,
    /// Temperature, if given; without the offset \[K\].
    pub temperature: Option<f64>,
    /// Speed of sound, if given \[m/s\].
    pub sound_speed: Option<f64>,
    /// Dynamic viscosity, if given \[Pa s\].
    pub viscosity: Option<f64>,
}

impl AtmosphereInput {
    /// The air of this description. A given temperature changes density, speed of sound and
    /// viscosity, unless they are given too.
    ///
    /// # Errors
    /// All values that are not usable: an altitude outside -2 km to 20 km, or a value that is
    /// not positive.
    pub fn atmosphere(&self) -> Result<Atmosphere, Vec<WindProblem>> {
        let problems = self.problems();
        if !problems.is_empty() {
            return Err(problems);
        }
        let mut offset = self.temperature_offset;
        if let Some(temperature) = self.temperature {
            offset = temperature - standard(self.altitude, 0.0).temperature;
        }
        let air = standard(self.altitude, offset);
        Ok(Atmosphere {
            density: self.density.unwrap_or(air.density),
            sound_speed: self.sound_speed.unwrap_or(air.sound_speed),
            viscosity: self.viscosity.unwrap_or(air.viscosity),
            ..air
        })
    }

    fn problems(&self) -> Vec<WindProblem> {
        let mut problems = Vec::new();
        if !(FLOOR..=CEILING).contains(&self.altitude) {
            let help = "give the altitude of the site above sea level, in meters";
            let expected = "-2000 m to 20000 m";
            problems.push(WindProblem::value(
                "altitude",
                self.altitude,
                expected,
                help,
            ));
        }
        let temperature = self.temperature.unwrap_or_else(|| {
            let altitude = self.altitude.clamp(FLOOR, CEILING);
            standard(altitude, 0.0).temperature + self.temperature_offset
        });
        let values = [
            ("density", self.density),
            ("temperature with its offset, in kelvin", Some(temperature)),
            ("speed of sound", self.sound_speed),
            ("viscosity", self.viscosity),
        ];
        for (what, value) in values {
            let Some(value) = value.filter(|value| !(*value > 0.0 && value.is_finite())) else {
                continue;
            };
            let help = "give a value in SI units, or leave it out";
            problems.push(WindProblem::value(what, value, "a positive number", help));
        }
        problems
    }
}

/// The standard atmosphere at `altitude` \[m\] with a temperature `offset` \[K\].
fn standard(altitude: f64, offset: f64) -> Atmosphere {
    let below = altitude.min(TROPOPAUSE);
    let cold = SEA_TEMPERATURE - LAPSE * below;
    let mut pressure = SEA_PRESSURE * (cold / SEA_TEMPERATURE).powf(GRAVITY / (LAPSE * GAS));
    if altitude > TROPOPAUSE {
        pressure *= (-GRAVITY * (altitude - TROPOPAUSE) / (GAS * cold)).exp();
    }
    let temperature = cold + offset;
    Atmosphere {
        density: pressure / (GAS * temperature),
        temperature,
        pressure,
        sound_speed: (HEAT_RATIO * GAS * temperature).sqrt(),
        viscosity: 1.458e-6 * temperature.powf(1.5) / (temperature + 110.4),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(altitude: f64) -> Atmosphere {
        let input = AtmosphereInput {
            altitude,
            ..Default::default()
        };
        input.atmosphere().unwrap()
    }

    /// Tables of ISO 2533 (geopotential altitude), to their number of digits.
    #[test]
    fn tables_of_the_standard_atmosphere() {
        let rows = [
            (0.0, 288.15, 101_325.0, 1.225, 340.294, 1.7894e-5),
            (5000.0, 255.65, 54_019.9, 0.736_116, 320.529, 1.6281e-5),
            (11_000.0, 216.65, 22_632.0, 0.363_918, 295.069, 1.4216e-5),
            (20_000.0, 216.65, 5_474.88, 0.088_034_9, 295.069, 1.4216e-5),
        ];
        for (h, temperature, pressure, density, sound, viscosity) in rows {
            let air = at(h);
            approx::assert_relative_eq!(air.temperature, temperature, max_relative = 1e-9);
            // five to six digits of the tables
            approx::assert_relative_eq!(air.pressure, pressure, max_relative = 1e-5);
            approx::assert_relative_eq!(air.density, density, max_relative = 1e-5);
            approx::assert_relative_eq!(air.sound_speed, sound, max_relative = 3e-6);
            approx::assert_relative_eq!(air.viscosity, viscosity, max_relative = 5e-5);
        }
        assert_eq!(Atmosphere::default(), at(0.0));
    }

    #[test]
    fn a_hot_day_keeps_the_pressure() {
        let hot = AtmosphereInput {
            altitude: 1000.0,
            temperature_offset: 20.0,
            ..Default::default()
        };
        let (hot, cold) = (hot.atmosphere().unwrap(), at(1000.0));
        assert_eq!(hot.pressure, cold.pressure);
        let ratio = hot.density * hot.temperature / (cold.density * cold.temperature);
        assert!((ratio - 1.0).abs() < 1e-14);
    }

    #[test]
    fn given_values_replace_the_standard_ones() {
        let input = AtmosphereInput {
            density: Some(1.1),
            temperature: Some(300.0),
            temperature_offset: 99.0,
            viscosity: Some(2e-5),
            ..Default::default()
        };
        let air = input.atmosphere().unwrap();
        assert_eq!((air.density, air.viscosity), (1.1, 2e-5));
        assert!((air.temperature - 300.0).abs() < 1e-12);
        assert!((air.sound_speed - (1.4 * GAS * 300.0_f64).sqrt()).abs() < 1e-9);
    }

    #[test]
    fn all_wrong_values_are_reported() {
        let input = AtmosphereInput {
            altitude: f64::NAN,
            temperature_offset: -300.0,
            density: Some(0.0),
            sound_speed: Some(f64::INFINITY),
            ..Default::default()
        };
        assert_eq!(input.atmosphere().unwrap_err().len(), 4);
    }
}
