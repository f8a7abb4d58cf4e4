//! Panels of a blade: its shape at points that are dense at both ends.
//!
//! ```text
//! r_k = r_hub + (r_tip - r_hub) (1 - cos((k + 1/2) pi / n)) / 2 ,   k = 0 .. n - 1
//! ```
//!
//! Loads of blades with losses fall like the root of the distance from the ends, which points at equal
//! distances resolve slowly: a blade of nine stations loses an eighth of its power.

use std::f64::consts::PI;

use crate::airfoil::{BlendProblem, Section};
use crate::rotor::blade::{RigidRotor, Station};

impl RigidRotor<Section> {
    /// The rotor with `count` stations at these points; shape and coefficients are linear between the
    /// stations of `self`, and constant beyond the first and the last one. Without stations it is the
    /// same rotor.
    ///
    /// # Errors
    /// [`BlendProblem`] of weights that are not numbers.
    pub fn with_panels(&self, count: usize) -> Result<Self, BlendProblem> {
        let length = self.tip_radius - self.hub_radius;
        let radius = |k: usize| {
            let angle = (k as f64 + 0.5) * PI / count as f64;
            self.hub_radius + 0.5 * length * (1.0 - angle.cos())
        };
        let stations = (0..count).filter_map(|k| self.station_at(radius(k)));
        Ok(Self {
            stations: stations.collect::<Result<_, _>>()?,
            ..self.clone()
        })
    }

    /// The blade at a radius; `None` without stations.
    fn station_at(&self, radius: f64) -> Option<Result<Station<Section>, BlendProblem>> {
        let after = self.stations.partition_point(|own| own.radius <= radius);
        let low = self.stations.get(after.saturating_sub(1))?;
        let high = self.stations.get(after).unwrap_or(low);
        let distance = high.radius - low.radius;
        let share = if distance > 0.0 {
            ((radius - low.radius) / distance).clamp(0.0, 1.0)
        } else {
            0.0
        };
        let between = |a: f64, b: f64| a + share * (b - a);
        let section = Section::between(&low.section, &high.section, share);
        Some(section.map(|section| Station {
            radius,
            chord: between(low.chord, high.chord),
            twist: between(low.twist, high.twist),
            prebend: between(low.prebend, high.prebend),
            section,
        }))
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::airfoil::{Airfoil, LinearLift};
    use crate::rotor::{AnnulusRadius, Machine, OperatingPoint};

    fn rotor(count: usize) -> RigidRotor<Section> {
        let airfoil = Arc::new(Airfoil::linear(LinearLift::default()));
        let station = |k: usize| {
            let radius = 1.0 + 9.0 * k as f64 / (count - 1) as f64;
            Station {
                radius,
                chord: 1.2 - 0.08 * radius,
                twist: 0.3 - 0.02 * radius,
                prebend: 0.0,
                section: Section::single(airfoil.clone()),
            }
        };
        RigidRotor {
            machine: Machine::Propeller,
            blades: 3,
            hub_radius: 1.0,
            tip_radius: 10.0,
            precone: 0.0,
            tilt: 0.0,
            yaw: 0.0,
            hub_height: 0.0,
            stations: (0..count).map(station).collect(),
            options: crate::momentum::Options::default(),
            annulus_radius: AnnulusRadius::ToShaft,
            skewed_wake: false,
            sectors: 1,
        }
    }

    /// Two stations describe this blade as well as a thousand; 60 panels are within .1 % of 2000.
    #[test]
    fn loads_do_not_depend_on_the_number_of_stations() {
        let operating = OperatingPoint {
            speed: 8.0,
            omega: 12.0,
            ..OperatingPoint::default()
        };
        let thrust = |stations: usize, panels: usize| {
            let rotor = rotor(stations).with_panels(panels).unwrap();
            rotor.performance(&operating).thrust
        };
        let fine = thrust(2, 2000);
        assert!(fine.abs() > 1000.0);
        for stations in [3, 17, 1000] {
            assert!(
                (thrust(stations, 2000) / fine - 1.0).abs() < 1e-9,
                "{stations}"
            );
        }
        for (panels, within) in [(60, 1e-3), (120, 3e-4)] {
            let error = thrust(2, panels) / fine - 1.0;
            assert!(error.abs() < within, "{panels}: {error}");
        }
    }

    #[test]
    fn beyond_the_stations_the_shape_is_constant() {
        let mut rotor = rotor(5);
        (rotor.hub_radius, rotor.tip_radius) = (0.5, 11.0);
        let panels = rotor.with_panels(40).unwrap();
        let ends = [&panels.stations[0], &panels.stations[39]];
        let given = [&rotor.stations[0], &rotor.stations[4]];
        for (end, given) in ends.into_iter().zip(given) {
            assert_eq!((end.chord, end.twist), (given.chord, given.twist));
        }
        rotor.stations.clear();
        assert!(rotor.with_panels(40).unwrap().stations.is_empty());
    }
}
