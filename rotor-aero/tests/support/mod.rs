//! Rotors of the reference data.
#![allow(dead_code)] // each suite uses a part of it

pub mod akima;
pub mod apc;

use std::path::PathBuf;
use std::sync::Arc;

use rotor_aero::airfoil::{
    Airfoil, AirfoilData, Coefficients, Curve, Flow, Interpolation, Profile,
};
use rotor_aero::momentum::{HighInduction, Options};
use rotor_aero::real::Real;
use rotor_aero::rotor::{AnnulusRadius, Machine, OperatingPoint, RigidRotor, Station};
use serde_json::Value;

/// An airfoil that stations share.
#[derive(Debug, Clone)]
pub struct Shared(pub Arc<Airfoil>);

impl Profile for Shared {
    fn at<T: Real>(&self, flow: &Flow<T>) -> Coefficients<T> {
        self.0.at(flow)
    }
}

pub fn text(path: &str) -> String {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../tests/reference");
    std::fs::read_to_string(root.join(path)).expect(path)
}

pub fn json(path: &str) -> Value {
    serde_json::from_str(&text(path)).expect("JSON")
}

pub fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

pub fn numbers(value: &Value) -> Vec<f64> {
    value
        .as_array()
        .expect("a list")
        .iter()
        .map(number)
        .collect()
}

/// Rows of a file of comma-separated values, without comments and titles, as words.
pub fn rows(path: &str) -> Vec<Vec<String>> {
    let text = text(path);
    let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    lines
        .map(|line| line.split(',').map(|word| word.trim().to_owned()).collect())
        .collect()
}

pub fn row_numbers(path: &str) -> Vec<Vec<f64>> {
    let number = |word: &String| word.parse().unwrap_or(f64::NAN);
    let rows = rows(path);
    rows.iter()
        .map(|row| row.iter().map(number).collect())
        .collect()
}

/// An airfoil of rows of angle in degrees, lift, drag, moment.
pub fn airfoil(name: &str, rows: &[Vec<f64>], interpolation: Interpolation) -> Shared {
    // a repeated angle keeps its first values
    let mut kept: Vec<&Vec<f64>> = Vec::new();
    for row in rows {
        if kept.last().is_none_or(|last| row[0] > last[0]) {
            kept.push(row);
        }
    }
    let curve = |column: usize| Curve {
        alpha: kept.iter().map(|row| row[0].to_radians()).collect(),
        values: kept.iter().map(|row| row[column]).collect(),
        ..Curve::default()
    };
    let data = AirfoilData {
        name: name.to_owned(),
        thickness: None,
        lift: vec![curve(1)],
        drag: vec![curve(2)],
        moment: vec![curve(3)],
    };
    Shared(Arc::new(Airfoil::new(&data, interpolation).expect(name)))
}

/// The NREL 5MW rotor: 17 stations, monotone cubics, tilt 5 and cone 2.5 degrees.
pub fn nrel5mw() -> RigidRotor<Shared> {
    nrel5mw_with(|rows| rows)
}

/// The same rotor with a change of the rows of its polars.
pub fn nrel5mw_with(change: impl Fn(Vec<Vec<f64>>) -> Vec<Vec<f64>>) -> RigidRotor<Shared> {
    let mut known: Vec<(String, Shared)> = Vec::new();
    let mut stations = Vec::new();
    for row in rows("aero/nrel5mw/blade.csv") {
        let name = &row[3];
        if !known.iter().any(|(other, _)| other == name) {
            let polar = change(row_numbers(&format!("aero/nrel5mw/polar_{name}.csv")));
            known.push((name.clone(), airfoil(name, &polar, Interpolation::Monotone)));
        }
        let section = known.iter().find(|(other, _)| other == name);
        let value = |column: usize| row[column].parse::<f64>().expect("a number");
        stations.push(Station {
            radius: value(0),
            chord: value(1),
            twist: value(2).to_radians(),
            prebend: 0.0,
            section: section.expect("known").1.clone(),
        });
    }
    RigidRotor {
        machine: Machine::Turbine,
        blades: 3,
        hub_radius: 1.5,
        tip_radius: 63.0,
        precone: 2.5f64.to_radians(),
        tilt: 5f64.to_radians(),
        yaw: 0.0,
        hub_height: 90.0,
        stations,
        options: law(HighInduction::Buhl),
        annulus_radius: AnnulusRadius::AlongBlade,
        skewed_wake: false,
        sectors: 4,
    }
}

/// The IEA 15 MW rotor: 48 loaded stations with an airfoil each, tilt 6 and cone 4 degrees.
pub fn iea15() -> RigidRotor<Shared> {
    let polars = row_numbers("aero/iea15/polars.csv");
    let blade = text("aero/iea15/AeroDyn15_blade.dat");
    let stations = blade.lines().skip(6).enumerate().map(|(node, line)| {
        let words = line.split_whitespace();
        let row: Vec<f64> = words.map(|it| it.parse().expect("a number")).collect();
        let own = polars.iter().filter(|polar| polar[0] == node as f64);
        let polar: Vec<Vec<f64>> = own.map(|polar| polar[1..].to_vec()).collect();
        Station {
            radius: 3.97 + row[0],
            chord: row[5],
            twist: row[4].to_radians(),
            prebend: row[1],
            section: airfoil(&format!("node {node}"), &polar, Interpolation::Monotone),
        }
    });
    let stations: Vec<Station<Shared>> = stations.collect();
    // 70 micrometers below the listed 120.97 m: a station there would have a load
    let tip = stations.last().map_or(120.97, |station| station.radius);
    RigidRotor {
        precone: 4f64.to_radians(),
        tilt: 6f64.to_radians(),
        hub_radius: 3.97,
        tip_radius: tip,
        hub_height: 150.0,
        sectors: 8,
        annulus_radius: AnnulusRadius::ToShaft,
        stations,
        ..nrel5mw()
    }
}

/// A point of operation by degrees and revolutions per minute.
pub fn operating(speed: f64, rpm: f64, pitch_deg: f64) -> OperatingPoint {
    OperatingPoint {
        speed,
        omega: rpm * std::f64::consts::PI / 30.0,
        pitch: pitch_deg.to_radians(),
        ..OperatingPoint::default()
    }
}

pub fn law(high_induction: HighInduction) -> Options {
    Options {
        high_induction,
        ..Options::default()
    }
}

/// Torque of the generator of the NREL 5MW turbine on its own shaft (NREL/TP-500-38060) by its speed
/// \[rad/s\]: nothing, a line, a parabola, a line of slip, constant power \[N m\].
pub fn generator_torque(data: &Value, speed: f64) -> f64 {
    let value = |key: &str| number(&data[key]);
    let (k, rated) = (value("K_region2"), value("w_rated_torque"));
    let synchronous = rated / (1.0 + 0.01 * value("slip_percent"));
    let power = value("P_rated_mech");
    let slope = power / rated / (rated - synchronous);
    let (cut_in, start) = (value("w_cut_in"), value("w_region2"));
    // the slip line meets the parabola
    let crossing = (slope - (slope * (slope - 4.0 * k * synchronous)).sqrt()) / (2.0 * k);
    if speed >= rated {
        power / speed
    } else if speed <= cut_in {
        0.0
    } else if speed < start {
        k * start * start * (speed - cut_in) / (start - cut_in)
    } else if speed < crossing {
        k * speed * speed
    } else {
        slope * (speed - synchronous)
    }
}
