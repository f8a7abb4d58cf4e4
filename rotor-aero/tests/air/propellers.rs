//! Annular momentum of a turbine and of propellers against CCBlade.jl.

use std::f64::consts::{PI, TAU};

use rotor_aero::airfoil::{Coefficients, Interpolation};
use rotor_aero::momentum::{Annulus, HighInduction, Options, Outcome, Solution, solve};
use rotor_aero::rotor::{Machine, OperatingPoint, RigidRotor, Station};
use serde_json::Value;

use crate::compare::Compared;
use crate::support::akima::akima;
use crate::support::{Shared, airfoil, json, law, nrel5mw, number, numbers, row_numbers};

const CCBLADE: &str = "CCBlade.jl";

/// A ring without losses, high induction with the factor of loss outside.
fn lossless(radius: f64, chord: f64, blades: usize) -> Annulus {
    Annulus {
        radius,
        hub_radius: 1e-6,
        tip_radius: 100.0,
        blades,
        chord,
        options: Options {
            tip_loss: false,
            hub_loss: false,
            ..law(HighInduction::BuhlOutside)
        },
    }
}

/// A turbine of Ingram's lecture notes, four digits; the first station is not comparable.
#[test]
fn ingram_turbine() {
    let data = &json("aero/propellers/ccblade_jl.json")["ingram_turbine"];
    let list = |key: &str| numbers(&data[key].as_array().expect(key)[1..].to_vec().into());
    let (radius, chord, gamma) = (list("r"), list("chord"), list("gamma_deg"));
    let (a, swirl) = (list("a"), list("ap"));
    let lift = |alpha: f64| Coefficients {
        lift: 0.084 * alpha.to_degrees(),
        drag: 0.0,
        moment: 0.0,
    };
    let with = Compared {
        source: "Ingram's notes, by CCBlade.jl",
        case: "turbine without losses",
    };
    for i in 0..radius.len() {
        let twist = (90.0 - gamma[i]).to_radians();
        // lift without camber: the airfoil upside down is the same
        let ring = lossless(radius[i], chord[i], 3);
        let found = solve(&ring, twist, 7.0, 11.2 * radius[i], lift);
        with.absolute("axial induction", [-found.axial / 7.0, a[i]], 1e-4);
        let own = -found.swirl / (11.2 * radius[i]);
        with.absolute("tangential induction", [own, swirl[i]], 1e-4);
    }
}

/// The section of the propeller without losses.
fn parabolic(alpha: f64, zero_lift: f64) -> Coefficients<f64> {
    let lift = 6.2 * (alpha - zero_lift);
    Coefficients {
        lift,
        drag: 0.008 - 0.003 * lift + 0.01 * lift * lift,
        moment: 0.0,
    }
}

fn station(speed: f64, radius: f64, zero_lift: f64) -> Solution {
    let omega = 2100.0 * PI / 30.0;
    let twist = (1.0 / (TAU * radius)).atan();
    let ring = lossless(radius, 0.1, 2);
    solve(&ring, twist, speed, omega * radius, |alpha| {
        parabolic(alpha, zero_lift)
    })
}

/// Thrust and torque by rectangles of .072 m at each of 11 stations.
fn rectangle_sums(speed: f64, zero_lift: f64) -> (f64, f64) {
    let mut sums = (0.0, 0.0);
    for i in 0..11 {
        let radius = 0.08 + 0.072 * f64::from(i);
        let found = station(speed, radius, zero_lift);
        assert_eq!(found.outcome, Outcome::Solved);
        let (cn, ct) = found.flow.load_coefficients(found.coefficients);
        let load = 2.0 * 0.5 * 1.225 * found.flow.speed.powi(2) * 0.1 * 0.072;
        sums.0 += cn * load;
        sums.1 += ct * load * radius;
    }
    sums
}

/// Tables of the tests of CCBlade.jl, whose tolerance is 1e-2 N and 2e-3 N m.
#[test]
fn propeller_without_losses() {
    let data = &json("aero/propellers/ccblade_jl.json")["no_loss_propeller"];
    let with = Compared {
        source: CCBLADE,
        case: "propeller without losses, 1 to 60 m/s",
    };
    let (thrust, torque) = (numbers(&data["T_N"]), numbers(&data["Q_Nm"]));
    for (i, (thrust, torque)) in thrust.iter().zip(torque).enumerate() {
        let found = rectangle_sums(1.0 + i as f64, 0.0);
        with.absolute("thrust [N]", [found.0, *thrust], 1e-2);
        with.absolute("torque [N m]", [found.1, torque], 2e-3);
    }
    let cambered = &data["cambered"];
    let zero_lift = (-3f64).to_radians();
    let with = Compared {
        source: CCBLADE,
        case: "propeller of a cambered section",
    };
    let found = rectangle_sums(5.0, zero_lift);
    with.relative("thrust [N]", [found.0, number(&cambered["T"])], 1e-8);
    with.relative("torque [N m]", [found.1, number(&cambered["Q"])], 1e-8);
    let fourth = station(5.0, 0.08 + 0.072 * 3.0, zero_lift);
    for (own, key) in [
        (fourth.axial, "u"),
        (fourth.swirl, "v"),
        (fourth.flow.phi, "phi"),
        (fourth.alpha, "alpha"),
        (fourth.flow.speed, "W"),
        (fourth.coefficients.lift, "cl"),
        (fourth.coefficients.drag, "cd"),
    ] {
        let listed = number(&cambered["station4"][key]);
        with.relative(&format!("{key} of the fourth station"), [own, listed], 1e-8);
    }
}

/// A propeller of one airfoil, with its stations as (radius, chord, twist).
pub fn propeller<S: Clone>(
    section: S,
    stations: &[[f64; 3]],
    (hub, tip): (f64, f64),
    options: Options,
) -> RigidRotor<S> {
    let plain = nrel5mw();
    let own = |row: &[f64; 3]| Station {
        radius: row[0],
        chord: row[1],
        twist: row[2],
        prebend: 0.0,
        section: section.clone(),
    };
    RigidRotor {
        machine: Machine::Propeller,
        blades: 2,
        hub_radius: hub,
        tip_radius: tip,
        precone: 0.0,
        tilt: 0.0,
        yaw: 0.0,
        hub_height: 0.0,
        stations: stations.iter().map(own).collect(),
        options,
        annulus_radius: plain.annulus_radius,
        skewed_wake: false,
        sectors: 1,
    }
}

/// A propeller of 6 inches, CT and CP over J, loads and induced velocities at 10 m/s: CCBlade.jl with
/// Akima's cubics, from which monotone cubics differ by 4e-5 in the coefficients, and more near the tip.
/// Its stations are listed with twists of 1e-4 degrees, 3e-5 of the loads.
#[test]
fn propeller_of_six_inches() {
    let polar = row_numbers("aero/nrel5mw/polar_NACA64_A17.csv");
    six_inches("monotone cubics", &polar, [1e-4, 0.02, 1e-3]);
    six_inches("Akima's cubics", &akima(polar.clone()), [1e-6, 5e-4, 1e-5]);
}

/// The propeller with a polar of its airfoil.
fn of_six_inches(data: &Value, polar: &[Vec<f64>]) -> RigidRotor<Shared> {
    let section = airfoil("NACA64", polar, Interpolation::Monotone);
    let (radius, chord) = (numbers(&data["r_m"]), numbers(&data["chord_m"]));
    let twist = numbers(&data["twist_deg"]);
    let stations: Vec<[f64; 3]> = (0..radius.len())
        .map(|i| [radius[i], chord[i], twist[i].to_radians()])
        .collect();
    let ends = (0.0127, 0.0762);
    propeller(section, &stations, ends, law(HighInduction::BuhlOutside))
}

/// Compares with tolerances of coefficients, loads \[N/m\] and induced velocities over the speed.
fn six_inches(polars: &str, polar: &[Vec<f64>], tolerances: [f64; 3]) {
    let data = &json("aero/propellers/ccblade_jl.json")["six_inch"];
    let rotor = of_six_inches(data, polar);
    let omega = 8000.0 * PI / 30.0;
    let at = |speed: f64| {
        rotor.performance(&OperatingPoint {
            speed,
            omega,
            ..OperatingPoint::default()
        })
    };
    let case = format!("propeller of 6 inches, {polars}");
    let with = Compared {
        source: CCBLADE,
        case: &case,
    };
    let (thrust, power) = (numbers(&data["CT"]), numbers(&data["CP"]));
    for i in 0..20 {
        let ratio = 0.1 + 0.8 * i as f64 / 19.0;
        let found = at(ratio * omega / TAU * 0.1524).propeller();
        assert!((found.advance_ratio - ratio).abs() < 1e-14);
        with.absolute(
            "CT, J from .1 to .9",
            [found.thrust, thrust[i]],
            tolerances[0],
        );
        with.absolute(
            "CP, J from .1 to .9",
            [found.power, power[i]],
            tolerances[0],
        );
    }
    let listed = |key: &str| numbers(&data["at_10mps"][key]);
    let loads = &at(10.0).sectors[0].stations;
    for (i, load) in loads.iter().enumerate() {
        with.absolute(
            "load along the shaft [N/m]",
            [load.normal, listed("Np")[i]],
            tolerances[1],
        );
        let around = [load.tangential, listed("Tp")[i]];
        with.absolute("load around the shaft [N/m]", around, tolerances[1]);
        // That program lists the uniform velocity that has the momentum of the annulus,
        // F a (1 + a) = b (1 + b), and the swirl in the same ratio.
        let a = load.axial_induction;
        let mean = 0.5 * ((1.0 + 4.0 * load.loss * a * (1.0 + a)).sqrt() - 1.0);
        let swirl = load.induced_swirl / 10.0 * mean / a;
        with.absolute(
            "induced velocity over the speed",
            [mean, listed("u_over_V")[i]],
            tolerances[2],
        );
        with.absolute(
            "swirl over the speed",
            [swirl, listed("v_over_V")[i]],
            tolerances[2],
        );
    }
}
