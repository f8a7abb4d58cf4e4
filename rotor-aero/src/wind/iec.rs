//! Wind conditions of IEC 61400-1 ed. 3 (sections 6.2 and 6.3) for a turbine.
//!
//! ```text
//! L = 0.7 zh, at most 42 m
//! NTM: s1 = Iref (0.75 V + 5.6)
//! ETM: s1 = 2 Iref (0.072 (Vave/2 + 3) (V/2 - 4) + 10),   Vave = 0.2 Vref
//! EWM: Ve50 = 1.4 Vref (z/zh)^0.11,  Ve1 = 0.8 Ve50
//! EOG: Vg = min[1.35 (Ve1 - V), 3.3 s1 / (1 + 0.1 D/L)]
//! EDC: th = 4 atan[s1 / (V (1 + 0.1 D/L))]
//! ECD: Vcg = 15 m/s, th = 180 deg below 4 m/s, else 720 deg / V
//! EWS: A = 2.5 + 1.28 s1 (D/L)^0.25   (0.2 beta = 1.28)
//! ```

use super::event::EventShape;
use super::kaimal::Kaimal;
use super::profile::{MeanWind, Shear};

/// Class of a turbine: its reference speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum WindClass {
    /// 50 m/s.
    One,
    /// 42.5 m/s.
    Two,
    /// 37.5 m/s.
    Three,
    /// A class of its own (S).
    Special {
        /// Reference speed, averaged over 10 minutes \[m/s\].
        reference_speed: f64,
    },
}

/// Category of turbulence: the expected intensity at 15 m/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TurbulenceCategory {
    /// 0.16.
    A,
    /// 0.14.
    B,
    /// 0.12.
    C,
    /// A category of its own (S).
    Special {
        /// Intensity at 15 m/s \[-\].
        intensity: f64,
    },
}

/// A turbine, as the standard describes it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IecTurbine {
    /// Class.
    pub class: WindClass,
    /// Category of turbulence.
    pub category: TurbulenceCategory,
    /// Height of the hub \[m\].
    pub hub_height: f64,
    /// Diameter of the rotor \[m\].
    pub diameter: f64,
}

impl IecTurbine {
    /// Reference speed `Vref` \[m/s\].
    pub fn reference_speed(&self) -> f64 {
        match self.class {
            WindClass::One => 50.0,
            WindClass::Two => 42.5,
            WindClass::Three => 37.5,
            WindClass::Special { reference_speed } => reference_speed,
        }
    }

    /// Intensity at 15 m/s `Iref` \[-\].
    pub fn reference_intensity(&self) -> f64 {
        match self.category {
            TurbulenceCategory::A => 0.16,
            TurbulenceCategory::B => 0.14,
            TurbulenceCategory::C => 0.12,
            TurbulenceCategory::Special { intensity } => intensity,
        }
    }

    /// Longitudinal scale of turbulence `L` \[m\].
    pub fn turbulence_scale(&self) -> f64 {
        (0.7 * self.hub_height).min(42.0)
    }

    /// Standard deviation of u in normal turbulence (NTM) at the hub speed \[m/s\].
    pub fn normal_sigma(&self, speed: f64) -> f64 {
        self.reference_intensity() * (0.75 * speed + 5.6)
    }

    /// Standard deviation of u in extreme turbulence (ETM) at the hub speed \[m/s\].
    pub fn extreme_sigma(&self, speed: f64) -> f64 {
        let average = 0.2 * self.reference_speed();
        let bracket = 0.072 * (0.5 * average + 3.0) * (0.5 * speed - 4.0) + 10.0;
        2.0 * self.reference_intensity() * bracket
    }

    /// Spectra of turbulence of the standard deviation `sigma` of u \[m/s\] at the hub speed \[m/s\].
    pub fn spectrum(&self, speed: f64, sigma: f64) -> Kaimal {
        Kaimal {
            speed,
            sigma,
            scale: self.turbulence_scale(),
        }
    }

    /// Normal wind profile (NWP): the power law 0.2.
    pub fn normal_profile(&self, speed: f64) -> MeanWind {
        self.profile(speed, 0.2)
    }

    /// Steady extreme wind (EWM) with a recurrence period of 50 years, `Ve50`.
    pub fn extreme_profile_50(&self) -> MeanWind {
        self.profile(1.4 * self.reference_speed(), 0.11)
    }

    /// Steady extreme wind (EWM) with a recurrence period of 1 year, `Ve1`.
    pub fn extreme_profile_1(&self) -> MeanWind {
        self.profile(0.8 * 1.4 * self.reference_speed(), 0.11)
    }

    /// Extreme operating gust (EOG) at the hub speed \[m/s\].
    pub fn operating_gust(&self, speed: f64) -> EventShape {
        let yearly = 1.35 * (self.extreme_profile_1().speed - speed);
        let turbulent = 3.3 * self.normal_sigma(speed) / self.averaging();
        EventShape::OperatingGust {
            amplitude: yearly.min(turbulent),
        }
    }

    /// Extreme direction change (EDC) at the hub speed \[m/s\]; `sign` is 1 or -1.
    pub fn direction_change(&self, speed: f64, sign: f64) -> EventShape {
        let ratio = self.normal_sigma(speed) / (speed * self.averaging());
        EventShape::DirectionChange {
            angle: sign * 4.0 * ratio.atan(),
        }
    }

    /// Extreme coherent gust with direction change (ECD) at the hub speed \[m/s\]; `sign` is 1
    /// or -1.
    pub fn coherent_gust(&self, speed: f64, sign: f64) -> EventShape {
        let degrees: f64 = if speed < 4.0 { 180.0 } else { 720.0 / speed };
        EventShape::CoherentGust {
            rise: 15.0,
            angle: sign * degrees.to_radians(),
        }
    }

    /// Extreme vertical shear (EWS) at the hub speed \[m/s\]; `sign` is 1 or -1.
    pub fn vertical_shear(&self, speed: f64, sign: f64) -> EventShape {
        EventShape::VerticalShear {
            amplitude: sign * self.shear_amplitude(speed),
            diameter: self.diameter,
            hub_height: self.hub_height,
        }
    }

    /// Extreme horizontal shear (EWS) at the hub speed \[m/s\]; `sign` is 1 or -1.
    pub fn horizontal_shear(&self, speed: f64, sign: f64) -> EventShape {
        EventShape::HorizontalShear {
            amplitude: sign * self.shear_amplitude(speed),
            diameter: self.diameter,
        }
    }

    fn shear_amplitude(&self, speed: f64) -> f64 {
        let ratio = self.diameter / self.turbulence_scale();
        2.5 + 1.28 * self.normal_sigma(speed) * ratio.powf(0.25)
    }

    /// `1 + 0.1 D/L`: the rotor averages gusts that are smaller than itself.
    fn averaging(&self) -> f64 {
        1.0 + 0.1 * self.diameter / self.turbulence_scale()
    }

    fn profile(&self, speed: f64, exponent: f64) -> MeanWind {
        MeanWind {
            speed,
            reference_height: self.hub_height,
            shear: Shear::Power { exponent },
            reference_length: self.diameter,
            ..MeanWind::default()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wind::Event;

    /// Independent evaluation, formulas confirmed by the documentation of pyIECWind; digits of
    /// the file, 1e-4.
    fn reference() -> (serde_json::Value, IecTurbine) {
        let path = concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/tests/reference/aero/theory/iec_gusts.json"
        );
        let json: serde_json::Value =
            serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
        let turbine = IecTurbine {
            class: WindClass::One,
            category: TurbulenceCategory::A,
            hub_height: json["z_hub"].as_f64().unwrap(),
            diameter: json["D"].as_f64().unwrap(),
        };
        (json, turbine)
    }

    #[test]
    fn amplitudes_equal_the_reference() {
        let (json, turbine) = reference();
        let speed = json["V"].as_f64().unwrap();
        let amplitude = |shape| match shape {
            EventShape::OperatingGust { amplitude } => amplitude,
            EventShape::DirectionChange { angle } | EventShape::CoherentGust { angle, .. } => {
                angle.to_degrees()
            }
            EventShape::VerticalShear { amplitude, .. }
            | EventShape::HorizontalShear { amplitude, .. } => amplitude,
        };
        let pairs = [
            ("sigma1", turbine.normal_sigma(speed)),
            ("ETM_sigma", turbine.extreme_sigma(speed)),
            ("V_gust", amplitude(turbine.operating_gust(speed))),
            (
                "theta_e_deg",
                amplitude(turbine.direction_change(speed, 1.0)),
            ),
            (
                "ECD_theta_deg",
                amplitude(turbine.coherent_gust(speed, 1.0)),
            ),
            (
                "EWS_amplitude_mps",
                amplitude(turbine.vertical_shear(speed, 1.0)),
            ),
            (
                "EWS_amplitude_mps",
                -amplitude(turbine.horizontal_shear(speed, -1.0)),
            ),
        ];
        for (name, value) in pairs {
            let expected = json[name].as_f64().unwrap();
            assert!(
                (value - expected).abs() < 1e-4,
                "{name}: {value} {expected}"
            );
        }
    }

    #[test]
    fn operating_gust_over_time() {
        let (json, turbine) = reference();
        let speed = json["V"].as_f64().unwrap();
        let event = Event {
            start: 0.0,
            shape: turbine.operating_gust(speed),
        };
        let at = |time: f64| speed + event.speed(&[0.0; 3], time);
        let times = (0..=105_000).map(|i| 1e-4 * f64::from(i));
        let extreme = |sign: f64| {
            let pairs = times.clone().map(|t| (sign * at(t), t));
            let (value, t) = pairs.max_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
            (sign * value, t)
        };
        let gust = &json["EOG"];
        for (sign, name) in [(-1.0, "min"), (1.0, "max")] {
            let (value, time) = extreme(sign);
            assert!((value - gust[name].as_f64().unwrap()).abs() < 1e-4);
            // three digits in the file; the second minimum, at T - t, is as deep
            let expected = gust[format!("t_{name}")].as_f64().unwrap();
            let mirrored = (10.5 - time - expected).abs();
            assert!(
                (time - expected).abs().min(mirrored) < 2e-3,
                "{name} at {time}"
            );
        }
    }

    #[test]
    fn profiles() {
        let (_, turbine) = reference();
        let at = |wind: MeanWind, z: f64| wind.velocity(&[0.0, 0.0, z], 0.0)[0];
        assert!((at(turbine.extreme_profile_50(), 90.0) - 70.0).abs() < 1e-12);
        let ratio = at(turbine.extreme_profile_1(), 180.0) / at(turbine.extreme_profile_1(), 90.0);
        assert!((ratio - 2.0_f64.powf(0.11)).abs() < 1e-14);
        assert!((at(turbine.normal_profile(10.0), 45.0) - 10.0 * 0.5_f64.powf(0.2)).abs() < 1e-14);
    }
}
