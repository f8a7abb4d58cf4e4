//! Propellers against measurements and other programs.

use std::f64::consts::{PI, TAU};
use std::path::PathBuf;

use rotor_aero::airfoil::files::performance::{PropellerPoint, read_performance};
use rotor_aero::airfoil::{Coefficients, Flow, Profile};
use rotor_aero::momentum::{HighInduction, Options};
use rotor_aero::real::Real;
use rotor_aero::rotor::OperatingPoint;

use crate::compare::Compared;
use crate::propellers::propeller;
use crate::support::{apc, json, law, numbers, text};

/// Sources of the measurements, and of the independent numbers.
const TUNNEL: &str = "UIUC Propeller Data Site, measured";
const SCRIPT: &str = "annular momentum by an independent script";

/// CT and CP by the middle rule on 24 rings between cosine edges.
fn middle_rule(blade: &apc::Blade, section: &apc::Compressible, rpm: f64, ratio: f64) -> [f64; 2] {
    let start = blade.rows[0][0];
    let edge =
        |i: usize| start + (blade.radius - start) * 0.5 * (1.0 - (PI * i as f64 / 24.0).cos());
    let rings: Vec<[f64; 3]> = (0..24)
        .map(|i| {
            let radius = 0.5 * (edge(i) + edge(i + 1));
            [radius, blade.at(radius, 1), blade.at(radius, 2)]
        })
        .collect();
    let options = law(HighInduction::Buhl);
    let rotor = propeller(section.clone(), &rings, (start, blade.radius), options);
    let (omega, diameter) = (rpm * PI / 30.0, 2.0 * blade.radius);
    let n = omega / TAU;
    let found = rotor.performance(&OperatingPoint {
        speed: ratio * n * diameter,
        omega,
        speed_of_sound: 340.0,
        ..OperatingPoint::default()
    });
    let mut sums = [0.0, 0.0];
    for (i, load) in found.sectors[0].stations.iter().enumerate() {
        let width = 2.0 * (edge(i + 1) - edge(i));
        sums[0] += load.normal * width;
        sums[1] += load.tangential * load.radius * width;
    }
    let force = 1.225 * n * n * diameter.powi(4);
    [sums[0] / force, TAU * sums[1] / (force * diameter)]
}

/// A propeller of APC, its measurements and the numbers of an independent script.
struct Tested {
    blade: apc::Blade,
    section: apc::Compressible,
    /// Rows of J (rpm, J, measured CT and CP, CT and CP of the script), and the same at rest without J.
    listed: [Vec<Vec<f64>>; 2],
    measured: Vec<PropellerPoint>,
}

impl Tested {
    fn new(geometry: &str, polar: (&str, &str), listed: &str, files: &str) -> Self {
        let data = json(&format!("aero/propellers/{listed}.json"));
        let table = |key: &str| -> Vec<Vec<f64>> {
            let rows = data[key].as_array().expect("rows");
            rows.iter().map(numbers).collect()
        };
        Self {
            blade: apc::blade(geometry),
            section: apc::Compressible(apc::family(polar.0, polar.1)),
            listed: [table("J"), table("static")],
            measured: measured(files),
        }
    }

    /// CT and CP; at rest with a J of 1e-3, which keeps the swirl, as in the script.
    fn at(&self, rpm: f64, ratio: f64) -> [f64; 2] {
        middle_rule(&self.blade, &self.section, rpm, ratio.max(1e-3))
    }

    /// Largest measured CT and CP, moving or at rest.
    fn scales(&self, at_rest: bool) -> [f64; 2] {
        let points = self.measured.iter();
        let points = points.filter(|point| (point.advance_ratio == 0.0) == at_rest);
        points.fold([0.0; 2], |most: [f64; 2], point| {
            [most[0].max(point.thrust), most[1].max(point.power)]
        })
    }

    /// Compares with the script, and its measurements with the files of the wind tunnel.
    fn beside_the_script(&self, case: &str) {
        let with = Compared {
            source: SCRIPT,
            case,
        };
        for (rows, at_rest) in self.listed.iter().zip([false, true]) {
            let scales = self.scales(at_rest);
            let first = if at_rest { 1 } else { 2 };
            // Rest is here the state without axial velocity, the script's an advance ratio of 1e-3.
            let within = if at_rest { 3e-3 } else { 2e-3 };
            for row in rows {
                let ratio = if at_rest { 0.0 } else { row[1] };
                let is_listed = |point: &PropellerPoint| {
                    let rpm = point.speed.expect("a speed") * 30.0 / PI;
                    (rpm - row[0]).abs() < 1e-6
                        && point.advance_ratio == ratio
                        && [point.thrust, point.power] == row[first..first + 2]
                };
                assert!(self.measured.iter().any(is_listed), "{case}: {row:?}");
                let found = self.at(row[0], ratio);
                for (i, name) in ["CT", "CP"].into_iter().enumerate() {
                    let quantity = format!("{name} over its largest value");
                    let numbers = [found[i], row[first + 2 + i]].map(|it| it / scales[i]);
                    with.absolute(&quantity, numbers, within);
                }
            }
        }
    }

    /// Smallest and largest differences of CT and CP from the measurements at some points, over the
    /// largest measured values.
    fn band(&self, at_rest: bool, within: impl Fn(f64) -> bool) -> [[f64; 2]; 2] {
        let scales = self.scales(at_rest);
        let mut band = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        let points = self.measured.iter();
        for point in points.filter(|point| (point.advance_ratio == 0.0) == at_rest) {
            if !within(point.advance_ratio) {
                continue;
            }
            let rpm = point.speed.expect("a speed") * 30.0 / PI;
            let found = self.at(rpm, point.advance_ratio);
            for (i, measured) in [point.thrust, point.power].into_iter().enumerate() {
                let difference = (found[i] - measured) / scales[i];
                band[i] = [band[i][0].min(difference), band[i][1].max(difference)];
            }
        }
        band
    }
}

/// The points of all files of measurements whose names begin so.
fn measured(files: &str) -> Vec<PropellerPoint> {
    let folder = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../tests/reference/aero/propellers"
    );
    let entries = std::fs::read_dir(folder).expect("a folder");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("a file").path()).collect();
    paths.retain(|path| {
        let name = path.file_name().expect("a name").to_string_lossy();
        name.starts_with(files) && !name.contains("geom")
    });
    paths.sort();
    let points = paths
        .iter()
        .flat_map(|path| read_performance(path).expect("points"));
    points.collect()
}

/// Records a band and checks its limits.
fn within(case: &str, quantity: &str, band: [f64; 2], [low, high]: [f64; 2]) {
    let with = Compared {
        source: TUNNEL,
        case,
    };
    println!("{case}, {quantity}: {band:?}");
    let limit = low.abs().max(high.abs());
    with.largest(&format!("{quantity}, over the largest value"), band, limit);
    assert!(
        band[0] > low && band[1] < high,
        "{case}, {quantity}: {band:?}"
    );
}

/// APC 10x7SF, with the geometry of its file and NACA 4412 everywhere: an independent script with
/// the same polars differs by less than 2e-3; the measurements of the University of Illinois, seven runs
/// of 3000 to 6000 rpm, are in the bands that it found: thrust 10 % at J from .1 to .9, power 13 % below
/// J = .6, and up to 35 % too low beyond, where the propeller is nearly without thrust.
#[test]
fn propeller_of_ten_inches() {
    let polar = ("NACA_4412", "N6.0");
    let tested = Tested::new("10x7SF-PERF.PE0", polar, "apc_10x7sf_compare", "apcsf_10x7");
    let case = "APC 10x7SF";
    tested.beside_the_script(case);
    let moving = tested.band(false, |ratio| (0.1..=0.92).contains(&ratio));
    within(case, "CT, J from .1 to .9", moving[0], [-0.10, 0.02]);
    within(case, "CP, J from .1 to .9", moving[1], [-0.35, 0.04]);
    let slow = tested.band(false, |ratio| ratio < 0.6);
    within(case, "CP, J below .6", slow[1], [-0.13, 0.04]);
    let still = tested.band(true, |_| true);
    within(case, "CT at rest", still[0], [-0.085, 0.0]);
    within(case, "CP at rest", still[1], [-0.155, 0.0]);
}

/// APC 4.2x4 at Reynolds numbers of 30 000: the trend alone, and the independent script.
#[test]
fn propeller_of_four_inches() {
    let polar = ("CLARK_Y", "N7.0");
    let tested = Tested::new("42x4-PERF.PE0", polar, "apc_4.2x4_compare", "apcff_4.2x4");
    let case = "APC 4.2x4";
    tested.beside_the_script(case);
    let moving = tested.band(false, |_| true);
    within(case, "CT, all J", moving[0], [-0.36, 0.0]);
    let still = tested.band(true, |_| true);
    within(case, "CT at rest", still[0], [-0.36, 0.0]);
}

/// The section of the folder propeller: linear lift, a parabola of drag, its Reynolds number.
#[derive(Clone)]
struct Folder;

impl Profile for Folder {
    fn at<T: Real>(&self, flow: &Flow<T>) -> Coefficients<T> {
        let factor = (-flow.mach * flow.mach + 1.0).sqrt().recip();
        let lift = (flow.alpha * 5.8 + 0.5) * factor;
        let above = lift - 0.5;
        let curve = if above.re() > 0.0 { 0.050 } else { 0.020 };
        let size = (flow.reynolds / 70_000.0).powf(-0.7);
        Coefficients {
            lift: if lift.re() > 1.2 { T::from(1.2) } else { lift },
            drag: (above * above * curve + 0.028) * size,
            moment: T::from(0.0),
        }
    }
}

/// QPROP 1.22 with its listed chord and angle at 25 stations, at 5 m/s and in hover: another model of the
/// swirl, of the tip and of stalled sections, 6 % at most (found: 1.2 and 2 %), with the radius of the tip
/// station or the radius of the disk.
#[test]
fn folder_propeller() {
    for (file, speed, thrust, torque) in [
        ("cam6x3_qprop_V5.txt", 5.0, 2.644, 0.0288),
        ("cam6x3_qprop_hover.txt", 0.01, 3.273, 0.03001),
    ] {
        let output = text(&format!("aero/propellers/{file}"));
        let words = |line: &str| -> Vec<f64> {
            let words = line.trim_start_matches('#').split_whitespace();
            words.map_while(|it| it.parse().ok()).collect()
        };
        let rows: Vec<Vec<f64>> = output.lines().map(words).collect();
        let total = rows.iter().find(|row| row.len() == 19 && row[0] == speed);
        let total = total.expect("the totals");
        assert_eq!((total[3], total[4]), (thrust, torque));
        let stations = rows.iter().filter(|row| row.len() == 12);
        let stations: Vec<[f64; 3]> = stations
            .map(|row| [row[0], row[1], row[2].to_radians()])
            .collect();
        assert_eq!(stations.len(), 25);
        let case = format!("Graupner CAM 6x3, {speed} m/s");
        for tip in [3.0 * 0.0254, 3.05 * 0.0254f64] {
            let with = Compared {
                source: "QPROP 1.22",
                case: &case,
            };
            let found = folder(&stations, tip.max(0.0763), speed);
            with.relative("thrust [N]", [found[0], thrust], 0.06);
            with.relative("torque [N m]", [found[1], torque], 0.06);
        }
    }
}

/// Thrust and torque by rectangles around the stations.
fn folder(stations: &[[f64; 3]], tip: f64, speed: f64) -> [f64; 2] {
    let options = Options {
        hub_loss: false,
        ..Options::default()
    };
    let rotor = propeller(Folder, stations, (0.75 * 0.0254, tip), options);
    let found = rotor.performance(&OperatingPoint {
        speed,
        omega: 14020.0 * PI / 30.0,
        speed_of_sound: 340.0,
        ..OperatingPoint::default()
    });
    let width = 2.0 * 2.25 * 0.0254 / 25.0;
    let loads = found.sectors[0].stations.iter();
    loads.fold([0.0; 2], |sum, load| {
        let moment = load.tangential * load.radius;
        [sum[0] + load.normal * width, sum[1] + moment * width]
    })
}
