//! Performance of turbines against published tables and other programs.

mod support;

use rotor_aero::momentum::HighInduction;
use support::{iea15, json, law, nrel5mw, number, numbers, operating, row_numbers};

#[test]
fn explore() {
    let data = json("aero/nrel5mw/ccblade_jl.json");
    let mut rotor = nrel5mw();
    rotor.options = law(HighInduction::BuhlOutside);
    let sweep = &data["sweep"];
    let (tsr, cp, ct) = (
        numbers(&sweep["tsr"]),
        numbers(&sweep["CP"]),
        numbers(&sweep["CT"]),
    );
    let mut point = operating(10.0, 0.0, 0.0);
    point.shear_exponent = 0.2;
    let mut worst = (0.0f64, 0.0f64);
    for i in 0..tsr.len() {
        point.omega = tsr[i] * 10.0 / rotor.disk_radius();
        let found = rotor.performance(&point).turbine();
        worst.0 = worst.0.max((found.power - cp[i]).abs());
        worst.1 = worst.1.max((found.thrust - ct[i]).abs());
    }
    println!("sweep {worst:?}");
    point.omega = 7.55 * 10.0 / rotor.disk_radius();
    let one = rotor.performance(&point);
    let single = &data["single_azimuth"];
    let (np, tp) = (
        numbers(&single["Np_kN_per_m"]),
        numbers(&single["Tp_kN_per_m"]),
    );
    for (i, load) in one.sectors[0].stations.iter().enumerate() {
        println!(
            "{} {}",
            load.normal / 1e3 - np[i],
            load.tangential / 1e3 - tp[i]
        );
    }
    let rotor = nrel5mw();
    for row in row_numbers("aero/nrel5mw/steady.csv") {
        let found = rotor.performance(&operating(row[0], row[1], row[2]));
        println!(
            "{} P {} T {} {}",
            row[0],
            found.power / row[6] / 1e3 - 1.0,
            found.thrust / row[7] / 1e3 - 1.0,
            found.unsolved
        );
    }
    let rotor = iea15();
    println!("R {}", rotor.disk_radius());
    for row in row_numbers("aero/iea15/steady_wisdem.csv") {
        let mut at = operating(row[0], row[2], row[1]);
        at.shear_exponent = 0.12;
        let found = rotor.performance(&at);
        println!(
            "{} ours P {:.5} T {:.5} table P {:.5} T {:.5}",
            row[0],
            found.power / row[9] / 1e6 - 1.0,
            found.thrust / row[10] / 1e6 - 1.0,
            found.power / row[3] / 1e6 - 1.0,
            found.thrust / row[5] / 1e6 - 1.0
        );
    }
    let _ = number(&data["single_azimuth"]["tsr"]);
}
