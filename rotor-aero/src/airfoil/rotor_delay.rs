//! Delay of stall along the blades of a rotor.
//!
//! Each place of a blade has the corrections of [`super::stall_delay`] with its own ratios c/r and r/R,
//! up to a part of the radius; the tables of an airfoil are corrected anew for each place. Airfoils
//! without a table do not stall, and tables without lift, such as the ones of a cylinder, have none to delay:
//! both remain.

use std::sync::Arc;

use super::blend::Section;
use super::evaluated::Airfoil;
use super::stall_delay::StallDelay;

/// Law of the factor of the lift.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RotorDelayLaw {
    /// Lift of Du and Selig, drag of Eggers.
    DuSelig,
    /// Lift of Snel.
    Snel,
}

/// Delay of stall along a blade.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RotorStallDelay {
    /// Law.
    pub law: RotorDelayLaw,
    /// Speed of the tip by rotation over its speed in the air; not for Snel \[-\].
    pub speed_ratio: f64,
    /// Part of the radius of the tip beyond which stall is not delayed \[-\].
    pub to: f64,
    /// Angles between which the slope and the zero of lift are fitted \[rad\].
    pub fit: [f64; 2],
}

/// A place of a blade.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RotorPlace {
    /// Chord \[m\].
    pub chord: f64,
    /// Distance from the shaft \[m\].
    pub radius: f64,
    /// Distance of the tip from the shaft \[m\].
    pub tip_radius: f64,
}

impl RotorStallDelay {
    /// The correction of a place; `None` beyond the part of the radius, and at the shaft.
    pub fn at(&self, place: RotorPlace) -> Option<StallDelay> {
        let RotorPlace {
            chord,
            radius,
            tip_radius,
        } = place;
        // A place at the limit has rounding errors.
        let is_in = radius > 0.0 && radius <= self.to * tip_radius * (1.0 + 1e-9);
        let delay = || match self.law {
            RotorDelayLaw::DuSelig => {
                StallDelay::du_selig(chord / radius, radius / tip_radius, self.speed_ratio)
            }
            RotorDelayLaw::Snel => StallDelay::snel(chord / radius),
        };
        is_in.then(|| delay().with_fit(self.fit))
    }

    /// The section of a place with delayed stall.
    pub fn section(&self, section: &Section, place: RotorPlace) -> Section {
        match self.at(place) {
            Some(delay) => section.with_each(|airfoil| delayed(airfoil, &delay)),
            None => section.clone(),
        }
    }
}

/// The airfoil with delayed stall, or the same if it has none to delay.
fn delayed(airfoil: &Arc<Airfoil>, delay: &StallDelay) -> Arc<Airfoil> {
    airfoil
        .with_stall_delay(delay)
        .map_or_else(|| Arc::clone(airfoil), Arc::new)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;
    use crate::airfoil::{Flow, Interpolation, LinearLift, built_in, naca0012};

    fn naca() -> Arc<Airfoil> {
        Arc::new(built_in("naca0012").unwrap())
    }

    fn snel(to: f64) -> RotorStallDelay {
        RotorStallDelay {
            law: RotorDelayLaw::Snel,
            speed_ratio: 1.0,
            to,
            fit: StallDelay::USUAL_FIT,
        }
    }

    fn flow(alpha: f64) -> Flow<f64> {
        Flow {
            alpha,
            mach: 0.3,
            reynolds: 3e6,
            flap: 0.0,
        }
    }

    /// Numbers without a pattern.
    fn scattered(seed: usize) -> impl FnMut(f64, f64) -> f64 {
        let mut count = seed as f64;
        move |low, high| {
            count += 1.0;
            low + (high - low) * (count * 0.754_877_666_246_693).fract()
        }
    }

    /// 300 random places of either law: the lift at the angles of the table is the one of the airfoil whose
    /// table has the correction of this place.
    #[test]
    fn places_have_the_correction_of_their_own_ratios() {
        let mut between = scattered(0);
        for case in 0..300 {
            let place = RotorPlace {
                chord: between(0.05, 0.6),
                radius: between(0.3, 5.0),
                tip_radius: 5.0,
            };
            let law = [RotorDelayLaw::DuSelig, RotorDelayLaw::Snel][case % 2];
            let delay = RotorStallDelay {
                law,
                speed_ratio: between(0.6, 1.0),
                to: 1.0,
                fit: [between(-0.2, -0.05), between(0.05, 0.1)],
            };
            let ratio = place.chord / place.radius;
            let by_hand = match law {
                RotorDelayLaw::DuSelig => {
                    StallDelay::du_selig(ratio, place.radius / 5.0, delay.speed_ratio)
                }
                RotorDelayLaw::Snel => StallDelay::snel(ratio),
            };
            let by_hand = by_hand.with_fit(delay.fit);
            let data = naca0012().with_stall_delay(&by_hand).unwrap();
            let expected = Airfoil::new(&data, Interpolation::Monotone).unwrap();
            let found = delay.section(&Section::single(naca()), place);
            for angle in [-0.4, 0.1, 0.24, 0.3, 0.6, 1.2, 3.0] {
                let (found, expected) = (found.at(&flow(angle)), expected.at(&flow(angle)));
                assert_eq!(found, expected, "{place:?} {angle}");
            }
        }
    }

    /// Snel by its formula between two airfoils: 3 (c/r)^2 of the way to the line, of each at its share.
    #[test]
    fn mixtures_are_corrected_part_by_part() {
        let linear = Arc::new(Airfoil::linear(LinearLift {
            slope: TAU,
            ..LinearLift::default()
        }));
        let parts = [(0.25, naca()), (0.75, linear)];
        let section = Section::weighted(&parts).unwrap();
        let place = RotorPlace {
            chord: 0.4,
            radius: 2.0,
            tip_radius: 5.0,
        };
        let found = snel(1.0).section(&section, place);
        let rise = |section: &Section| section.at(&flow(0.35)).lift;
        let alone = Section::single(naca());
        let of_one = rise(&snel(1.0).section(&alone, place)) - rise(&alone);
        assert!(of_one > 0.05);
        assert!((rise(&found) - rise(&section) - 0.25 * of_one).abs() < 1e-12);
    }

    #[test]
    fn stall_is_delayed_up_to_a_part_of_the_radius() {
        let section = Section::single(naca());
        let place = |radius: f64| RotorPlace {
            chord: 0.5,
            radius,
            tip_radius: 5.0,
        };
        for (radius, is_delayed) in [(0.0, false), (1.0, true), (4.0, true), (4.01, false)] {
            let found = snel(0.8).section(&section, place(radius));
            assert_eq!(found != section, is_delayed, "{radius}");
        }
    }

    /// A cylinder has no lift, a formula no stall, and an airfoil with a correction of its own has it once.
    #[test]
    fn airfoils_without_stall_remain() {
        let mut cylinder = naca0012().with_scaled_lift(0.0);
        "cylinder".clone_into(&mut cylinder.name);
        let cylinder = Airfoil::new(&cylinder, Interpolation::Monotone).unwrap();
        let linear = Airfoil::linear(LinearLift::default());
        let own = Airfoil::clone(&naca()).without_stall_delay();
        for airfoil in [cylinder, linear, own] {
            let section = Section::single(Arc::new(airfoil));
            let place = RotorPlace {
                chord: 0.5,
                radius: 1.0,
                tip_radius: 5.0,
            };
            assert_eq!(snel(1.0).section(&section, place), section);
        }
    }
}
