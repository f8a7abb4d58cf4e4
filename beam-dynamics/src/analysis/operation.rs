//! Remarks on rotors at operating points that are plausible for none: a speed in another unit, wind from the
//! other side, a pitch of the wrong sign.
//!
//! With the speed V of the air along and across the shaft, and along it positive with the thrust:
//!
//! ```text
//! lambda = |Omega| R / |V|     C_T = T / (rho V^2 A / 2)     C_P = P / (rho |V|^3 A / 2)
//! ```

use std::f64::consts::PI;

use super::stall::StallCount;
use crate::case::Words;
use crate::elements::{AirState, RotorAir};
use crate::input::short_number;

/// Ratio of the speeds of tips and air below which no rotor works, and the one of a fast turbine \[-\].
pub(super) const RATIOS: [f64; 2] = [0.5, 20.0];
/// The same ratio below which a rotor that brakes is no helicopter that descends \[-\].
const BRAKE: f64 = 10.0;
/// Coefficients of thrust and power that are no small rest \[-\].
const COUNTS: f64 = 0.05;
/// Advance ratio above which the periodic coefficients of blades count beside their means \[-\].
const PERIODIC: f64 = 0.1;
/// Part of the strips beyond stall, above which the state is none of operation \[-\].
const STALLED: f64 = 0.75;
/// Digits of numbers.
const DIGITS: usize = 4;

/// A reason for doubt.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Doubt {
    Slow,
    Fast,
    Supersonic,
    Advance,
    Averaged,
    Behind,
    Against,
    Brakes,
    Stalled,
}

/// A doubt about a rotor, with its first point.
#[derive(Debug, Clone)]
struct Found {
    rotor: String,
    doubt: Doubt,
    at: String,
    points: usize,
    text: String,
}

/// The operating points of an analysis.
#[derive(Debug, Clone, Default)]
pub(super) struct Operation {
    /// The number of points with air.
    points: usize,
    /// Whether others report stall.
    omits_stall: bool,
    /// Whether the equations have mean coefficients.
    is_averaged: bool,
    found: Vec<Found>,
}

impl Operation {
    /// Of an analysis that reports stall itself.
    pub fn without_stall() -> Self {
        Self {
            omits_stall: true,
            ..Self::default()
        }
    }

    /// Of an analysis, which averages the coefficients of the equations or not.
    pub fn of_averaged(is_averaged: bool) -> Self {
        Self {
            is_averaged,
            ..Self::default()
        }
    }

    /// Adds the strips in the air at a point, `at` which as text, of a model with words for its blades.
    pub fn add(&mut self, at: &str, air: &[AirState], words: Words) {
        let rotors = RotorAir::all(air);
        self.points += usize::from(!rotors.is_empty());
        for (name, rotor) in rotors {
            let own = air
                .iter()
                .filter(|strip| strip.location.rotor.as_deref() == Some(name.as_str()));
            let mut found = doubts(&rotor, words);
            found.extend(averaged(&rotor).filter(|_| self.is_averaged));
            found.extend(supersonic(own.clone()));
            found.extend(stalled(&rotor, own).filter(|_| !self.omits_stall));
            for (doubt, text) in found {
                self.note((&name, doubt), at, text);
            }
        }
    }

    fn note(&mut self, (rotor, doubt): (&str, Doubt), at: &str, text: String) {
        let mut known = self.found.iter_mut();
        match known.find(|own| own.rotor == rotor && own.doubt == doubt) {
            Some(own) => own.points += 1,
            None => self.found.push(Found {
                rotor: rotor.to_owned(),
                doubt,
                at: at.to_owned(),
                points: 1,
                text,
            }),
        }
    }

    /// The remarks on doubts that all points have, as of a run in time, which passes through others.
    pub fn lasting(mut self) -> Vec<String> {
        let points = self.points;
        self.found.retain(|own| own.points == points);
        self.remarks()
    }

    /// The remarks on all points; numbers are of the first one of each.
    pub fn remarks(&self) -> Vec<String> {
        let remark = |own: &Found| {
            let place = match (self.points, own.at.as_str()) {
                (_, "") => String::new(),
                (1, at) => format!(" at {at}"),
                (all, at) => format!(" at {} of {all} points, first at {at}", own.points),
            };
            format!("rotor \"{}\"{place}: {}", own.rotor, own.text)
        };
        self.found.iter().map(remark).collect()
    }
}

/// Doubts about the sums of a rotor that turns.
fn doubts(air: &RotorAir, words: Words) -> Vec<(Doubt, String)> {
    let tips = air.turning.abs() * air.radius;
    let speed = air.climb.hypot(air.edgewise);
    if tips == 0.0 || speed == 0.0 {
        return Vec::new();
    }
    let number = |value: f64| short_number(value, DIGITS);
    let ratio = tips / speed;
    let is_wind = words == Words::Wind;
    let speeds = format!(
        "the tips move at {} m/s in air of {} m/s",
        number(tips),
        number(speed)
    );
    if ratio < RATIOS[0] {
        let text = format!(
            "{speeds}, a ratio of {}, expected more than {}: check the unit of the speed of rotation, \
             which is rpm without a unit, the radius of {} m and the wind",
            number(ratio),
            RATIOS[0],
            number(air.radius)
        );
        return vec![(Doubt::Slow, text)];
    }
    let mut found = Vec::new();
    if is_wind && ratio > RATIOS[1] {
        let text = format!(
            "{speeds}, a ratio of {}, expected less than {} of a turbine: check the units of the speed of \
             rotation and of the radius of {} m, and the wind",
            number(ratio),
            RATIOS[1],
            number(air.radius)
        );
        found.push((Doubt::Fast, text));
    }
    if !is_wind && air.edgewise > tips {
        let text = format!(
            "the advance ratio is {}, expected less than 1: the air moves faster across the shaft, with {} \
             m/s, than the tips",
            number(air.edgewise / tips),
            number(air.edgewise)
        );
        found.push((Doubt::Advance, text));
    }
    found.extend(of_wind(air, tips, is_wind));
    found
}

/// A doubt about mean coefficients of a rotor in forward flight: the error grows with the square of the advance
/// ratio.
fn averaged(air: &RotorAir) -> Option<(Doubt, String)> {
    let advance = air.edgewise / (air.turning.abs() * air.radius);
    (advance > PERIODIC && advance.is_finite()).then(|| {
        let text = format!(
            "the averaged coefficients leave out the ones that vary over a turn, at an advance ratio of {}: \
             compare the damping with by = \"Floquet\"",
            short_number(advance, DIGITS)
        );
        (Doubt::Averaged, text)
    })
}

/// A doubt about the wind of a rotor along its shaft, at a speed of its tips.
fn of_wind(air: &RotorAir, tips: f64, is_wind: bool) -> Option<(Doubt, String)> {
    let ratio = tips / air.climb.abs();
    let [thrust, power] = coefficients(air);
    let number = |value: f64| short_number(value, DIGITS);
    let wind = number(air.climb.abs());
    let is_near = ratio <= RATIOS[1];
    if is_near && air.climb > 0.0 && (is_wind || power > COUNTS) {
        let text = format!(
            "the wind of {wind} m/s along the shaft is against the axis of rotation, on the suction side of \
             the airfoils, as for a propeller: the wind of a turbine is along the axis of rotation; change the \
             sign of one of them, or give the blades mirror = true"
        );
        return Some((Doubt::Behind, text));
    }
    if is_near && is_wind && air.climb < 0.0 && thrust < -COUNTS {
        let text = format!(
            "the thrust of {} kN is against the wind of {wind} m/s along the shaft: check the pitch, which is \
             positive nose up, and the twist",
            number(1e-3 * air.thrust.abs())
        );
        return Some((Doubt::Against, text));
    }
    let most = if is_wind { RATIOS[1] } else { BRAKE };
    (ratio <= most && air.climb < 0.0 && power < -COUNTS).then(|| {
        let text = format!(
            "it takes {} kW from its shaft in a wind of {wind} m/s that should drive it: check the sign of the \
             pitch, which is positive nose up and negative toward feather, the twist, and the speed of rotation",
            number(1e-3 * air.power().abs())
        );
        (Doubt::Brakes, text)
    })
}

/// Coefficients of thrust and power by the speed of the air along the shaft, positive with the thrust and
/// for power from the air \[-\].
fn coefficients(air: &RotorAir) -> [f64; 2] {
    let speed = air.climb.abs();
    let force = 0.5 * air.density * speed * speed * PI * air.radius * air.radius;
    [air.thrust / force, air.power() / (force * speed)]
}

/// Sections beyond the speed of sound.
fn supersonic<'a>(strips: impl Iterator<Item = &'a AirState>) -> Option<(Doubt, String)> {
    let fastest = strips.map(|strip| strip.flow.mach).fold(0.0, f64::max);
    (fastest > 1.0).then(|| {
        let mach = short_number(fastest, 3);
        let text = format!(
            "sections move faster than sound, up to a Mach number of {mach}, for which no airfoil here is meant: \
             check the units of radii and speeds"
        );
        (Doubt::Supersonic, text)
    })
}

/// Most of the strips of a rotor that turns beyond stall.
fn stalled<'a>(
    air: &RotorAir,
    strips: impl Iterator<Item = &'a AirState> + Clone,
) -> Option<(Doubt, String)> {
    let mut count = StallCount::default();
    count.add(strips);
    let stall = count.found()?;
    let turns = air.turning.abs() * air.radius > RATIOS[0] * air.climb.hypot(air.edgewise);
    (turns && stall.part > STALLED).then(|| {
        let text = format!(
            "{} % of the strips are beyond stall, with an angle of attack up to {} deg: check the sign of the \
             pitch, which is positive nose up, the twist, the speed of rotation, which is in rpm without a unit, \
             and the wind",
            short_number(100.0 * stall.part, 2),
            short_number(stall.largest_angle.to_degrees(), 3)
        );
        (Doubt::Stalled, text)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A turbine of 60 m at 12 rpm in 10 m/s, lambda = 7.54, with the thrust and the power of usual
    /// coefficients, 0.75 and 0.45.
    fn turbine() -> RotorAir {
        let force = 0.5 * 1.225 * 100.0 * PI * 3600.0;
        let turning = 12.0 * PI / 30.0;
        RotorAir {
            thrust: 0.75 * force,
            torque: 0.45 * force * 10.0 / turning,
            turning,
            climb: -10.0,
            edgewise: 0.0,
            radius: 60.0,
            density: 1.225,
        }
    }

    fn kinds(air: &RotorAir, words: Words) -> Vec<Doubt> {
        doubts(air, words).iter().map(|own| own.0).collect()
    }

    #[test]
    fn coefficients_are_the_ones_of_turbines() {
        let [thrust, power] = coefficients(&turbine());
        assert!((thrust - 0.75).abs() < 1e-12 && (power - 0.45).abs() < 1e-12);
    }

    // A helicopter at an advance ratio of 0.3, and in a climb.
    #[test]
    fn averaged_coefficients_are_for_slow_flight() {
        let at = |edgewise: f64| {
            averaged(&RotorAir {
                edgewise,
                turning: 20.0,
                radius: 5.0,
                ..turbine()
            })
        };
        assert!(at(30.0).is_some_and(|own| own.1.contains("ratio of 0.3:")));
        assert_eq!(at(9.0), None);
    }

    // rpm for rad/s makes the ratio pi / 30 of the one that was meant, and the other way round.
    #[test]
    fn wrong_operation_of_turbines_has_a_doubt() {
        let sound = turbine();
        let changed = |change: fn(&mut RotorAir)| {
            let mut air = sound;
            change(&mut air);
            [Words::Wind, Words::Rotor].map(|words| kinds(&air, words))
        };
        let none = || [vec![], vec![]];
        assert_eq!(changed(|_| {}), none());
        let both = |doubt| [vec![doubt], vec![doubt]];
        let wind = |doubt| [vec![doubt], vec![]];
        assert_eq!(
            changed(|air| {
                air.turning *= PI / 30.0;
                air.climb *= 2.0;
            }),
            both(Doubt::Slow)
        );
        assert_eq!(changed(|air| air.turning *= 30.0 / PI), wind(Doubt::Fast));
        assert_eq!(changed(|air| air.climb = 10.0), both(Doubt::Behind));
        assert_eq!(
            changed(|air| (air.climb, air.torque) = (10.0, -air.torque)),
            wind(Doubt::Behind)
        );
        assert_eq!(changed(|air| air.torque *= -1.0), both(Doubt::Brakes));
        assert_eq!(changed(|air| air.thrust *= -1.0), wind(Doubt::Against));
        // At rest, and without wind.
        assert_eq!(changed(|air| air.turning = 0.0), none());
        assert_eq!(changed(|air| air.climb = 0.0), none());
    }

    // A helicopter with tips at 200 m/s hovers, climbs, descends with its own power, and flies at an advance
    // ratio of 0.35; beyond 1 it does not.
    #[test]
    fn helicopters_have_no_doubt_up_to_an_advance_ratio_of_one() {
        let at = |climb: f64, edgewise: f64| RotorAir {
            thrust: 4e4,
            torque: -1e4,
            turning: 33.0,
            climb,
            edgewise,
            radius: 200.0 / 33.0,
            density: 1.225,
        };
        let flights = [
            (0.0, 0.0),
            (8.0, 0.0),
            (-10.0, 0.0),
            (4.0, 70.0),
            (-4.0, 70.0),
            (-1e-50, 70.0),
        ];
        for (climb, edgewise) in flights {
            assert_eq!(kinds(&at(climb, edgewise), Words::Rotor), vec![]);
        }
        assert_eq!(kinds(&at(4.0, 210.0), Words::Rotor), [Doubt::Advance]);
    }

    #[test]
    fn points_are_counted() {
        let mut operation = Operation {
            points: 3,
            ..Operation::default()
        };
        for at in ["wind = 4", "wind = 8"] {
            operation.note(("turbine", Doubt::Fast), at, "too fast".to_owned());
        }
        assert_eq!(operation.clone().lasting(), Vec::<String>::new());
        let expected = "rotor \"turbine\" at 2 of 3 points, first at wind = 4: too fast";
        assert_eq!(operation.remarks(), [expected]);
        operation.points = 2;
        assert_eq!(operation.lasting().len(), 1);
    }
}
