//! Loads along the blades and their sums.
//!
//! ```text
//! Np = cn rho W^2 c / 2,  Tp = ct rho W^2 c / 2
//! T = B int Np cos kappa ds,  Q = B int Tp r ds,  P = Q omega
//! ```
//!
//! by the trapezoidal rule, with zeros at hub and tip. `r` is the distance to the shaft, kappa the
//! lean of the span. Reynolds and Mach numbers of the sections are formed without induction, as
//! the programs for comparison do.

use std::f64::consts::TAU;

use crate::airfoil::{Coefficients, Flow, Profile};
use crate::momentum::{
    Ambient, Annulus, Outcome, SectionFlow, Solution, induced_flow, skew_factor, solve, wake_skew,
};
use crate::rotor::blade::{Machine, Point, RigidRotor, Station};
use crate::rotor::operating::OperatingPoint;

/// Loads and flow at a station, with the signs of the machine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpanLoad {
    /// Distance from the shaft \[m\].
    pub radius: f64,
    /// Length along the blade from the hub \[m\].
    pub arc: f64,
    /// Force per length along the thrust, normal to the span (Np) \[N/m\].
    pub normal: f64,
    /// Force per length in the plane of rotation, along the torque (Tp) \[N/m\].
    pub tangential: f64,
    /// Axial induction factor: of turbines the share by which the air slows down, of propellers by
    /// which it speeds up (a) \[-\].
    pub axial_induction: f64,
    /// Tangential induction factor (a') \[-\].
    pub tangential_induction: f64,
    /// Induced velocity along the wind \[m/s\].
    pub induced_axial: f64,
    /// Induced velocity along the motion of the blade \[m/s\].
    pub induced_swirl: f64,
    /// Angle of attack \[rad\].
    pub alpha: f64,
    /// Lift coefficient \[-\].
    pub lift: f64,
    /// Drag coefficient \[-\].
    pub drag: f64,
    /// Moment coefficient about the quarter chord \[-\].
    pub moment: f64,
    /// Angle of the flow to the plane of rotation \[rad\].
    pub phi: f64,
    /// Speed of the flow (W) \[m/s\].
    pub speed: f64,
    /// Factor of loss at hub and tip \[-\].
    pub loss: f64,
    /// Reynolds number without induction \[-\].
    pub reynolds: f64,
    /// Mach number without induction \[-\].
    pub mach: f64,
    /// Outcome of the steady state.
    pub outcome: Outcome,
}

/// Loads of a blade at one azimuth.
#[derive(Debug, Clone, PartialEq)]
pub struct Sector {
    /// Azimuth from the blade up \[rad\].
    pub azimuth: f64,
    /// Loads at the stations, from hub to tip.
    pub stations: Vec<SpanLoad>,
}

/// Performance of a rotor at an operating point, with the signs of its machine.
#[derive(Debug, Clone, PartialEq)]
pub struct Performance {
    /// Signs.
    pub machine: Machine,
    /// Operating point.
    pub operating: OperatingPoint,
    /// Distance of the tips from the shaft \[m\].
    pub disk_radius: f64,
    /// Thrust along the shaft, all blades, mean over the azimuth \[N\].
    pub thrust: f64,
    /// Torque about the shaft \[N m\].
    pub torque: f64,
    /// Power \[W\].
    pub power: f64,
    /// Number of stations and azimuths without a state in balance.
    pub unsolved: usize,
    /// Loads by azimuth.
    pub sectors: Vec<Sector>,
}

impl<S: Profile> RigidRotor<S> {
    /// Performance at an operating point. Every input has a result; stations without a state in
    /// balance have no induction, and are counted.
    pub fn performance(&self, operating: &OperatingPoint) -> Performance {
        let points = self.points();
        let disk_radius = points.last().map_or(self.tip_radius, |tip| tip.z);
        let count = self.sectors.max(1);
        let sectors: Vec<Sector> = (0..count)
            .map(|sector| {
                let azimuth = TAU * sector as f64 / count as f64;
                self.sector(operating, &points, azimuth)
            })
            .collect();
        let (mut thrust, mut torque) = (0.0, 0.0);
        for sector in &sectors {
            let sums = integrated(&points, &sector.stations);
            let blades = self.blades as f64 / count as f64;
            thrust += blades * sums.0;
            torque += blades * sums.1;
        }
        let all = sectors.iter().flat_map(|sector| &sector.stations);
        Performance {
            machine: self.machine,
            operating: *operating,
            disk_radius,
            thrust,
            torque,
            power: torque * operating.omega,
            unsolved: all.filter(|it| it.outcome == Outcome::Unsolved).count(),
            sectors,
        }
    }

    fn sector(&self, operating: &OperatingPoint, points: &[Point], azimuth: f64) -> Sector {
        let ends = (points.first(), points.last());
        let radius = |end: Option<&Point>| end.map_or(0.0, |it| it.annulus);
        let ends = (radius(ends.0), radius(ends.1));
        let load = |point: &Point| {
            let station = self.stations.get(point.station?)?;
            Some(self.load(operating, station, point, ends, azimuth))
        };
        Sector {
            azimuth,
            stations: points.iter().filter_map(load).collect(),
        }
    }

    /// Loads at a station between the radii of hub and tip.
    fn load(
        &self,
        operating: &OperatingPoint,
        station: &Station<S>,
        point: &Point,
        (hub_radius, tip_radius): (f64, f64),
        azimuth: f64,
    ) -> SpanLoad {
        let ambient = self.ambient(operating, point, azimuth);
        let annulus = Annulus {
            radius: point.annulus,
            hub_radius,
            tip_radius,
            blades: self.blades,
            chord: station.chord,
            options: self.options,
        };
        let pitch = station.twist + operating.pitch;
        let speed = ambient.axial.hypot(ambient.rotation);
        let (mach, reynolds) = (
            speed / operating.speed_of_sound,
            operating.density * speed * station.chord / operating.viscosity,
        );
        let section = |alpha: f64| {
            let flow = Flow {
                alpha,
                mach,
                reynolds,
                flap: 0.0,
            };
            self.machine.coefficients(&station.section, flow)
        };
        let state = solve(&annulus, pitch, ambient.axial, ambient.rotation, section);
        let state = self.skewed(state, &annulus, &ambient, pitch, azimuth, section);
        let pressure = 0.5 * operating.density * state.flow.speed.powi(2) * station.chord;
        let conditions = (reynolds, mach);
        self.machine
            .span_load(&state, point, &ambient, pressure, conditions)
    }

    /// The state with the variation of the induced velocity over the azimuth.
    fn skewed(
        &self,
        state: Solution,
        annulus: &Annulus,
        ambient: &Ambient<f64>,
        pitch: f64,
        azimuth: f64,
        section: impl Fn(f64) -> Coefficients<f64>,
    ) -> Solution {
        let (angle, downwind) = self.wind_angles();
        if !self.skewed_wake || state.outcome != Outcome::Solved || angle == 0.0 {
            return state;
        }
        let induction = -state.axial / ambient.axial;
        let skew = wake_skew(angle, induction.clamp(-1.0, 1.0));
        let ratio = annulus.radius / annulus.tip_radius;
        let factor = skew_factor(skew, ratio, azimuth - downwind, Some(state.loss));
        let axial = state.axial * factor;
        let flow: SectionFlow<f64> = induced_flow(ambient, axial, state.swirl);
        let alpha = pitch - flow.phi;
        Solution {
            axial,
            flow,
            alpha,
            coefficients: section(alpha),
            ..state
        }
    }
}

impl Machine {
    /// Coefficients with the signs of propellers: the airfoil of a turbine is upside down.
    fn coefficients(self, section: &impl Profile, flow: Flow<f64>) -> Coefficients<f64> {
        match self {
            Self::Propeller => section.at(&flow),
            Self::Turbine => {
                let Coefficients { lift, drag, moment } = section.at(&Flow {
                    alpha: -flow.alpha,
                    ..flow
                });
                Coefficients {
                    lift: -lift,
                    drag,
                    moment: -moment,
                }
            }
        }
    }

    /// A state with the signs of the machine.
    fn span_load(
        self,
        state: &Solution,
        point: &Point,
        ambient: &Ambient<f64>,
        pressure: f64,
        (reynolds, mach): (f64, f64),
    ) -> SpanLoad {
        let sign = match self {
            Self::Turbine => -1.0,
            Self::Propeller => 1.0,
        };
        let (normal, tangential) = state.flow.load_coefficients(state.coefficients);
        SpanLoad {
            radius: point.z,
            arc: point.arc,
            normal: sign * normal * pressure,
            tangential: sign * tangential * pressure,
            axial_induction: sign * state.axial / ambient.axial,
            tangential_induction: sign * state.swirl / ambient.rotation,
            induced_axial: state.axial,
            induced_swirl: state.swirl,
            alpha: sign * state.alpha,
            lift: sign * state.coefficients.lift,
            drag: state.coefficients.drag,
            moment: sign * state.coefficients.moment,
            phi: state.flow.phi,
            speed: state.flow.speed,
            loss: state.loss,
            reynolds,
            mach,
            outcome: state.outcome,
        }
    }
}

/// Thrust and torque of one blade.
fn integrated(points: &[Point], loads: &[SpanLoad]) -> (f64, f64) {
    let (mut thrust, mut torque) = (0.0, 0.0);
    let mut last = (0.0, 0.0, 0.0);
    let mut loads = loads.iter();
    for point in points {
        let (axial, moment) = match point.station.and_then(|_| loads.next()) {
            Some(load) => (
                load.normal * point.lean.cos(),
                load.tangential * load.radius,
            ),
            None => (0.0, 0.0),
        };
        let half = 0.5 * (point.arc - last.0);
        thrust += half * (axial + last.1);
        torque += half * (moment + last.2);
        last = (point.arc, axial, moment);
    }
    (thrust, torque)
}

#[cfg(test)]
#[path = "performance_tests.rs"]
mod tests;
