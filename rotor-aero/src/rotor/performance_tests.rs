//! Signs, sums and odd inputs.

use std::f64::consts::PI;

use super::*;
use crate::momentum::Options;
use crate::real::Real;
use crate::rotor::blade::AnnulusRadius;

/// Lift with camber; upside down it has the opposite angle without lift.
#[derive(Debug, Clone, PartialEq)]
struct Cambered {
    zero_lift: f64,
}

impl Profile for Cambered {
    fn at<T: Real>(&self, flow: &Flow<T>) -> Coefficients<T> {
        let alpha = flow.alpha - self.zero_lift;
        Coefficients {
            lift: alpha * 5.5,
            drag: alpha * alpha * 0.5 + 0.01,
            moment: T::from(-0.05),
        }
    }
}

fn rotor(machine: Machine, zero_lift: f64) -> RigidRotor<Cambered> {
    let station = |radius: f64| Station {
        radius,
        chord: 0.1,
        twist: (0.3 / radius).atan(),
        prebend: 0.0,
        section: Cambered { zero_lift },
    };
    RigidRotor {
        machine,
        blades: 2,
        hub_radius: 0.1,
        tip_radius: 1.0,
        precone: 0.0,
        tilt: 0.0,
        yaw: 0.0,
        hub_height: 0.0,
        stations: [0.2, 0.4, 0.6, 0.8, 0.95].map(station).to_vec(),
        options: Options::default(),
        annulus_radius: AnnulusRadius::ToShaft,
        skewed_wake: false,
        sectors: 1,
    }
}

fn point(speed: f64, omega: f64) -> OperatingPoint {
    OperatingPoint {
        speed,
        omega,
        ..OperatingPoint::default()
    }
}

/// A turbine is a propeller whose airfoil is upside down: thrust, torque, lift and angle of attack
/// change sign, the flow does not.
#[test]
fn a_turbine_is_a_propeller_upside_down() {
    for (speed, omega) in [(5.0, 40.0), (25.0, 40.0), (0.0, 50.0), (-3.0, 50.0)] {
        let at = point(speed, omega);
        let turbine = rotor(Machine::Turbine, -0.05).performance(&at);
        let propeller = rotor(Machine::Propeller, 0.05).performance(&at);
        assert!((turbine.thrust + propeller.thrust).abs() < 1e-12);
        assert!((turbine.power + propeller.power).abs() < 1e-10);
        let (one, other) = (
            turbine.sectors[0].stations[2],
            propeller.sectors[0].stations[2],
        );
        assert_eq!(one.alpha, -other.alpha);
        assert!((one.lift + other.lift).abs() < 1e-14);
        assert_eq!((one.phi, one.speed), (other.phi, other.speed));
    }
}

/// Energy: the power of a propeller is the thrust times the speed of flight and more; the power of
/// a turbine is less than 16/27 of the power of the wind.
#[test]
fn signs_of_power() {
    let mut own = rotor(Machine::Propeller, -0.05);
    let driven = own.performance(&point(5.0, 50.0));
    assert!(driven.thrust > 0.0 && driven.power > 5.0 * driven.thrust);
    let efficiency = driven.propeller().efficiency;
    assert!(efficiency > 0.3 && efficiency < 1.0, "{efficiency}");
    own = rotor(Machine::Turbine, -0.05);
    own.stations.iter_mut().for_each(|it| it.twist *= 0.3);
    let driving = own.performance(&point(10.0, 50.0));
    let power = driving.turbine().power;
    assert!(
        driving.thrust > 0.0 && power > 0.1 && power < 16.0 / 27.0,
        "{power}"
    );
    let hover = rotor(Machine::Propeller, -0.05).performance(&point(0.0, 50.0));
    let merit = hover.helicopter().figure_of_merit;
    assert!(merit > 0.2 && merit < 1.0, "{merit}");
}

/// A constant load is a trapezoid with ramps at both ends.
#[test]
fn loads_are_zero_at_hub_and_tip() {
    let rotor = rotor(Machine::Propeller, 0.0);
    let points = rotor.points();
    let mut loads = rotor.performance(&point(3.0, 30.0)).sectors[0]
        .stations
        .clone();
    for load in &mut loads {
        load.normal = 2.0;
        load.tangential = 1.0 / load.radius;
    }
    let (thrust, torque) = integrated(&points, &loads);
    let length = 0.75 + 0.5 * (0.1 + 0.05);
    assert!((thrust - 2.0 * length).abs() < 1e-14);
    assert!((torque - length).abs() < 1e-14);
}

#[test]
fn stations_at_the_ends_have_no_load() {
    let mut own = rotor(Machine::Propeller, 0.0);
    let before = own.performance(&point(3.0, 30.0));
    let mut tip = own.stations[4].clone();
    tip.radius = 1.0;
    own.stations.push(tip);
    let after = own.performance(&point(3.0, 30.0));
    assert_eq!(after.sectors[0].stations[5].normal, 0.0);
    assert_eq!(after.sectors[0].stations[5].outcome, Outcome::End);
    assert!((after.thrust - before.thrust).abs() < 1e-13);
}

#[test]
fn odd_inputs_are_no_panic() {
    for machine in [Machine::Turbine, Machine::Propeller] {
        let mut own = rotor(machine, 0.0);
        for value in [0.0, -0.0, 1e-300, 1e300, f64::NAN, f64::INFINITY, -20.0] {
            for other in [0.0, 30.0, -30.0, f64::NAN, f64::INFINITY] {
                own.performance(&point(value, other));
                own.performance(&point(other, value));
            }
            own.stations[1].radius = value;
            own.performance(&point(4.0, 30.0));
            own.stations[1].radius = 0.4;
            own.tip_radius = value;
            own.performance(&point(4.0, 30.0));
            own.tip_radius = 1.0;
        }
        own.stations.truncate(1);
        assert!(own.performance(&point(4.0, 30.0)).thrust.is_finite());
        own.stations.clear();
        own.sectors = 0;
        assert_eq!(own.performance(&point(4.0, 30.0)).thrust, 0.0);
    }
}

/// The power of rotation against the plane of the yawed wind: the mean over the azimuth is even in
/// yaw without tilt.
#[test]
fn yaw_is_even() {
    let mut own = rotor(Machine::Propeller, 0.0);
    own.sectors = 8;
    own.yaw = 0.3;
    let one = own.performance(&point(6.0, 40.0));
    own.yaw = -0.3;
    let other = own.performance(&point(6.0, 40.0));
    assert!((one.thrust / other.thrust - 1.0).abs() < 1e-12);
    assert!((one.sectors[1].azimuth - PI / 4.0).abs() < 1e-15);
}
