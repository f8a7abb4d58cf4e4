//! Airfoil tables against measurements, and their files.

use std::path::Path;

use rotor_aero::airfoil::files::{self, Format, Options};
use rotor_aero::airfoil::{Curve, Flow, built_in, naca0012};

use crate::compare::Compared;
use crate::support::{json, row_numbers};

/// Lift of NACA 0012 at a Reynolds number of 6e6 in the book of Abbott and von Doenhoff, read from its
/// figure: at 10.2 degrees both signs of the angle differ by .05 there (found: .054, at 15.9 degrees). The largest lift, at 16.4 degrees,
/// is 1.596; the built-in table, by Ladson's measurements, has 1.618 at 17 degrees.
#[test]
fn naca_0012_has_the_lift_of_abbott_and_von_doenhoff() {
    let airfoil = built_in("naca0012").expect("built in");
    let lift = |degrees: f64| {
        let flow = Flow {
            alpha: degrees.to_radians(),
            mach: 0.15,
            reynolds: 6e6,
            flap: 0.0,
        };
        airfoil.at(&flow).lift
    };
    let rows = row_numbers("theory-rotor/naca0012_abbott.csv");
    let with = Compared {
        source: "Abbott and von Doenhoff, Theory of Wing Sections",
        case: "NACA 0012, Re 6e6, built-in table",
    };
    let below = rows.iter().filter(|row| row[0].abs() < 16.0);
    let errors = below.map(|row| lift(row[0]) - row[1]);
    with.largest("lift coefficient below 16 deg", errors, 0.06);
    let measured = rows.iter().map(|row| row[1]).fold(0.0, f64::max);
    let found = (0..250).map(|tenth| lift(0.1 * f64::from(tenth)));
    let found = found.fold(0.0, f64::max);
    with.relative("largest lift coefficient", [found, measured], 0.03);
}

/// Values of six characters: the table of 91 angles and 8 Mach numbers comes back with the errors listed
/// in `c81_format.json`, half of the last character; tables of more angles than two digits count are
/// refused.
#[test]
fn a_c81_file_returns_its_table_in_six_characters() {
    let data = json("theory-rotor/c81_format.json");
    let listed = data["verified"].as_str().expect("a text");
    let words = listed.split_whitespace();
    let listed: Vec<f64> = words
        .filter(|word| word.contains("e-"))
        .filter_map(|word| word.parse().ok())
        .collect();
    let table = naca0012();
    let own = files::ReadAirfoil {
        data: table.clone(),
        ..files::ReadAirfoil::default()
    };
    let written = files::write(&[own], Format::C81, "naca0012.c81").expect("a file");
    let back = files::parse(
        &written.text,
        Path::new("naca0012.c81"),
        &Options::default(),
    );
    let back = back.expect("the same table").airfoils.remove(0).data;
    let differences = |own: &[Curve], back: &[Curve]| -> Vec<f64> {
        assert_eq!(own.len(), 8);
        let curves = own.iter().zip(back);
        let curves = curves.flat_map(|(own, back)| {
            assert_eq!((own.mach, own.alpha.len()), (back.mach, 91));
            own.values.iter().zip(&back.values).map(|(a, b)| a - b)
        });
        curves.collect()
    };
    let with = Compared {
        source: "C81 tables of six characters",
        case: "NACA 0012 at all angles, written and read",
    };
    for (quantity, own, back, listed) in [
        ("lift coefficient", &table.lift, &back.lift, listed[0]),
        ("drag coefficient", &table.drag, &back.drag, listed[1]),
        ("moment coefficient", &table.moment, &back.moment, listed[2]),
    ] {
        // the listed errors have one or two digits
        with.largest(quantity, differences(own, back), 1.1 * listed);
    }
}
