//! Blades of files: equal to blades of pieces, and with hinges and masses equal to closed forms.

use std::f64::consts::PI;
use std::fs;

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::result::FrequencyTable;
use nalgebra::{Matrix6, Vector2, Vector3, Vector6};
use shared_geom::blade::{self, Blade, Interpolation, Station};
use shared_geom::line::{Course, LinePoint, ReferenceLine};
use shared_geom::section::Provenance;

use crate::record;

/// Stiffness and mass of a strip: EA, GAy, GAz, GJ, EIy, EIz; m and the inertias.
const STIFFNESS: [f64; 6] = [7e6, 2e6, 1e6, 3e3, 4e3, 9e4];
const MASS: [f64; 6] = [2.0, 2.0, 2.0, 0.05, 0.01, 0.04];

/// The same strip as properties on the card.
const STRIP: &str = "units = \"SI\"\n[properties.strip]\nea = 7e6\ngay = 2e6\ngaz = 1e6\n\
    gj = 3e3\neiy = 4e3\neiz = 9e4\nm = 2\niy = 0.01\niz = 0.04\n";

/// A straight blade of constant sections, twisted evenly; stiffness times `factor`.
fn strip(length: f64, twist: f64, factor: f64) -> Blade {
    let point = |part: f64| LinePoint {
        position: Vector3::new(part * length, 0.0, 0.0),
        twist: part * twist,
    };
    let station = |arc_length| Station {
        arc_length,
        stiffness: factor * Matrix6::from_diagonal(&Vector6::from(STIFFNESS)),
        mass: Matrix6::from_diagonal(&Vector6::from(MASS)),
    };
    Blade {
        name: "strip".to_owned(),
        line: ReferenceLine::through(vec![point(0.0), point(1.0)], Course::Polyline),
        reference_point: Vector2::zeros(),
        stations: vec![station(0.0), station(length)],
        interpolation: Interpolation::Linear,
        damping: None,
        provenance: Provenance::default(),
    }
}

/// Modes of the cards, with the file of `blade` next to them.
fn table(blade: &Blade, cards: &str) -> FrequencyTable {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.blade.json"), blade::write(blade)).unwrap();
    let file = folder.path().join("a.dynamics.toml");
    fs::write(&file, cards).unwrap();
    let input = beam_dynamics::input::read(&file).unwrap_or_else(|e| panic!("{e}"));
    let outcome = modes(&input.model, &input.modes.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    outcome.table
}

fn frequencies(table: &FrequencyTable, speed: usize) -> Vec<f64> {
    let modes = table.at_speed(speed);
    modes.iter().map(|mode| mode.1.frequency).collect()
}

/// Frequencies to 1e-10: the same elements except for round-off, which the axial stiffness EA/(m
/// omega^2 L^2) of 1e4 increases by four digits.
fn assert_same(a: &FrequencyTable, b: &FrequencyTable, case: &str) {
    for speed in 0..a.speeds.len() {
        let [a, b] = [a, b].map(|table| frequencies(table, speed));
        assert_eq!(a.len(), b.len(), "{case}");
        for (a, b) in a.iter().zip(&b) {
            let error = (a / b - 1.0).abs();
            record::largest(
                "the same blade in two descriptions",
                case,
                "frequencies",
                error,
                1e-10,
            );
            assert!(error < 1e-10, "{case}: {a} {b}");
        }
    }
}

const MODES: &str = "[modes]\nspeeds = [0, 60]\ncount = 8\n";

#[test]
fn stations_of_constant_sections_are_pieces() {
    let mounted = "name = \"b\"\nroot = [1, 0, 0]\nprecone = 3\npitch = 5\n";
    let file = format!(
        "units = \"SI\"\n[[blade]]\n{mounted}file = \"a.blade.json\"\nelements = 6\n{MODES}"
    );
    let pieces = format!(
        "{STRIP}[[blade]]\n{mounted}properties = \"strip\"\n\
         [[blade.piece]]\nlength = 6\nelements = 6\ntwist = [0, 20]\n{MODES}"
    );
    let blade = strip(6.0, 20_f64.to_radians(), 1.0);
    assert_same(
        &table(&blade, &file),
        &table(&blade, &pieces),
        "twisted strip",
    );
}

/// A mass on the line is a body on the node there, for both descriptions of the blade.
#[test]
fn masses_on_the_line_are_bodies_on_nodes() {
    let keys = "mass = 3\noffset = [0, 0.1, 0]\ninertia = [0.2, 0.1, 0.1]\n";
    let blade = strip(6.0, 0.0, 1.0);
    let file = format!(
        "units = \"SI\"\n[[blade]]\nname = \"b\"\nfile = \"a.blade.json\"\nelements = 6\n\
         [[blade.mass]]\nat = \"tip\"\n{keys}[[blade.mass]]\nat = 2\n{keys}{MODES}"
    );
    let strip = format!(
        "{STRIP}[[blade]]\nname = \"b\"\nproperties = \"strip\"\n\
         [[blade.piece]]\nlength = 6\nelements = 6\n"
    );
    let bodies =
        format!("{strip}[[body]]\nnode = \"b/tip\"\n{keys}[[body]]\nnode = \"b/4\"\n{keys}{MODES}");
    // In a blade of pieces the nearest node carries it: 2.3 m is 0.2 m from the middle of an
    // element at 2.5 m.
    let near = keys.replace("[0, ", "[-0.2, ");
    let [off, shifted] = [
        format!("{strip}[[blade.mass]]\nat = 2.3\n{keys}{MODES}"),
        format!("{strip}[[body]]\nnode = \"b/5\"\n{near}{MODES}"),
    ];
    let [file, bodies, off, shifted] =
        [&file, &bodies, &off, &shifted].map(|cards| table(&blade, cards));
    assert_same(&file, &bodies, "two masses");
    assert_same(&off, &shifted, "a mass off the nodes");
}

/// A rigid uniform blade of length L from a hinge at e, at speed Omega: by Euler's
/// equations about the hinge, with `S = m L^2/2` and the moments of inertia
/// `I_xx = J L, I_yy = m L^3/3 + I_y L, I_zz = m L^3/3 + I_z L`,
///
/// ```text
/// flap: (omega/Omega)^2 = (I_zz - I_xx + e S)/I_yy        lag: e S/I_zz
/// ```
///
/// With 1e2 times the stiffness of the strip the elastic share is (Omega/omega_1)^2, with 191 rad/s
/// of the first flap bending about a hinge: 4e-5 of a correction that is small itself.
#[test]
fn rigid_blades_on_hinges_have_the_frequencies_of_closed_forms() {
    let (length, offset) = (6.0, 0.5);
    let blade = strip(length, 0.0, 1e2);
    let slender = MASS[0] * length.powi(3) / 3.0;
    let moment = MASS[0] * length * length / 2.0;
    let [ixx, iyy, izz] = [0.0, slender, slender];
    let [ixx, iyy, izz] = [
        ixx + MASS[3] * length,
        iyy + MASS[4] * length,
        izz + MASS[5] * length,
    ];
    let speed = 12.0 / 60.0;
    let flap = speed * ((izz - ixx + offset * moment) / iyy).sqrt();
    let lag = speed * (offset * moment / izz).sqrt();
    for (hinges, expected) in [
        ("{ kind = \"flap\", offset = 0.5 }", vec![flap]),
        ("{ kind = \"lag\", offset = 0.5 }", vec![lag]),
        (
            "{ kind = \"flap\", offset = 0.5 }, { kind = \"lag\" }",
            vec![lag, flap],
        ),
        (
            "{ kind = \"lag\", offset = 0.5 }, { kind = \"flap\" }",
            vec![lag, flap],
        ),
    ] {
        let cards = format!(
            "units = \"SI\"\n[[blade]]\nname = \"b\"\nfile = \"a.blade.json\"\nhub_radius = 0.5\n\
             elements = 4\nhinges = [{hinges}]\n[modes]\nspeeds = [12]\ncount = 3\n"
        );
        let found = frequencies(&table(&blade, &cards), 0);
        for (k, expected) in expected.into_iter().enumerate() {
            let error = (found[k] / expected - 1.0).abs();
            println!("{hinges}: {} {expected} {error:.1e}", found[k]);
            let quantity = format!("frequency {}", k + 1);
            let source = "rigid uniform blade on hinges, closed form";
            record::value(source, hinges, &quantity, [found[k], expected], error, 1e-4);
            assert!(error < 1e-4, "{hinges}: {} {expected}", found[k]);
        }
    }
}

/// A stiff blade with a spring in its pitch hinge: `omega^2 = k/(J L)` at rest, with J the polar
/// inertia per length; the offset between hinge and root has no effect. With GJ 1e2 times the
/// strip's, k L/GJ = 2e-4 and the elastic share is half of this over 3.
#[test]
fn a_pitch_spring_turns_the_blade_about_its_span() {
    let (length, stiffness) = (6.0, 10.0);
    let blade = strip(length, 0.0, 1e2);
    let cards = format!(
        "units = \"SI\"\n[[blade]]\nname = \"b\"\nfile = \"a.blade.json\"\nhub_radius = 1\n\
         hinges = [{{ kind = \"pitch\", offset = 0.2, stiffness = {stiffness} }}]\n\
         [modes]\nspeeds = [0]\ncount = 8\n"
    );
    let table = table(&blade, &cards);
    let found = table.at_speed(0);
    let torsion = found
        .iter()
        .find(|mode| mode.0.name == "torsion 1")
        .unwrap();
    let expected = (stiffness / (MASS[3] * length)).sqrt() / (2.0 * PI);
    let error = (torsion.1.frequency / expected - 1.0).abs();
    assert!(error < 1e-4, "{} {expected}", torsion.1.frequency);
}
