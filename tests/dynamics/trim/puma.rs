//! The rotor of the Puma, flight 123: controls for thrust and flapping in forward flight.

use std::fmt::Write as _;

use super::{numbers, reference, trimmed};
use crate::record;

const TIP_SPEED: f64 = 209.735;
const RADIUS: f64 = 7.49;
const CHORD: f64 = 0.537;
/// Radius of the flap hinge \[m\].
const HINGE: f64 = 0.289;
/// Largest coefficients of lift, drag and moment in the tables.
const LARGEST: [f64; 3] = [9.9, 4.9, 4.9];

/// The table of `theory-rotor/naca0012_eq.c81` as columns, with its coefficients times a factor and,
/// deep in stall, within the limits of the reader.
fn airfoil(factor: f64) -> String {
    let path = "/tests/reference/theory-rotor/naca0012_eq.c81";
    let text = std::fs::read_to_string(format!("{}{path}", env!("CARGO_MANIFEST_DIR"))).unwrap();
    let fields = |line: &str| -> Vec<f64> {
        let fields = line
            .as_bytes()
            .chunks(7)
            .map(|part| std::str::from_utf8(part).unwrap().trim());
        fields
            .filter(|part| !part.is_empty())
            .map(|part| part.parse().unwrap())
            .collect()
    };
    let lines: Vec<Vec<f64>> = text.lines().skip(1).map(fields).collect();
    let blocks: Vec<&[Vec<f64>]> = lines.chunks(92).take(3).collect();
    let mut out = "alpha [deg],cl,cd,cm,mach\n".to_owned();
    for (column, mach) in blocks[0][0].iter().enumerate() {
        for row in 1..92 {
            let value = |block: usize| {
                (factor * blocks[block][row][column + 1]).clamp(-LARGEST[block], LARGEST[block])
            };
            let angle = blocks[0][row][0];
            let _ = writeln!(out, "{angle},{},{},{},{mach}", value(0), value(1), value(2));
        }
    }
    out
}

/// A variant of the rotor.
#[derive(Clone, Copy)]
struct Variant<'a> {
    /// Lines of its inflow.
    inflow: &'a str,
    /// Chords are divided by this, and coefficients multiplied.
    factor: f64,
    /// Speed of sound \[m/s\].
    sound: f64,
    /// Angle of the shaft, nose down \[deg\].
    shaft: f64,
    /// Whether the airfoil is linear.
    is_linear: bool,
    /// First guess of collective, cosine and sine \[deg\].
    guess: [f64; 3],
}

impl Default for Variant<'_> {
    fn default() -> Self {
        Self {
            inflow: "kind = \"Drees\"",
            factor: NARROW,
            sound: 331.0,
            shaft: 6.0,
            is_linear: false,
            guess: [11.5, 1.7, -5.7],
        }
    }
}

/// Stations of chords that are divided by a factor, with the twist of the tables, at the radii of its
/// larger kinks.
fn stations(factor: f64) -> String {
    let station = |(radius, twist): (f64, f64)| {
        format!(
            "{{ at = {:?}, chord = {:?}, twist = {:?}, airfoil = \"eq\" }}",
            radius - HINGE,
            CHORD / factor,
            twist.to_radians()
        )
    };
    let stations = [
        (2.08, -0.16),
        (2.507, -0.617),
        (3.507, -1.867),
        (6.257, -4.8),
        (7.49, -6.117),
    ];
    let stations = stations.map(station);
    stations.join(", ")
}

/// The rotor with rigid blades on flap hinges. The uniform blade and its mass have the moments of mass
/// of the real one about the hinge.
fn rotor(folder: &std::path::Path, variant: &Variant<'_>) -> String {
    let Variant {
        inflow,
        factor,
        sound,
        ..
    } = *variant;
    let file = folder.join("eq.csv");
    std::fs::write(&file, airfoil(factor)).unwrap();
    let section = if variant.is_linear {
        format!("slope = {:?}\ndrag = {:?}", 5.73 * factor, 0.01 * factor)
    } else {
        format!("file = {:?}", file.display().to_string())
    };
    let [t0, t1c, t1s] = variant.guess.map(f64::to_radians);
    let mu = 0.321;
    let speed = TIP_SPEED / RADIUS;
    let length = RADIUS - HINGE;
    // First and second moment of mass about the hinge.
    let (first, second, at) = (247.755, 1179.78, 0.5 * length);
    let per_length = (second - at * first) / (length.powi(3) / 3.0 - at * length.powi(2) / 2.0);
    let mass = (first - per_length * length.powi(2) / 2.0) / at;
    let stations = stations(factor);
    let thrust = 0.0695 * 0.091286 * 1.05 * std::f64::consts::PI * (RADIUS * TIP_SPEED).powi(2);
    format!(
        "[properties.p]\nea = 1e10\ngay = 1e9\ngaz = 1e9\ngj = 1e8\neiy = 1e8\neiz = 1e8\n\
         m = {per_length:?}\niy = 1e-3\niz = 1e-3\n[gravity]\nacceleration = [0, 0, -9.80665]\n\
         [air]\ndensity = 1.05\nspeed_of_sound = {sound}\noutside_mach = \"hold\"\nwind = [{:?}, 0, {:?}]\n\
         [airfoils.eq]\n{section}\n\
         [[rotor]]\nname = \"r\"\nhub = \"articulated\"\nblades = 4\nspeed = {speed:?}\nmass = 80\n\
         [rotor.inflow]\n{inflow}\n[rotor.blade]\nhub_radius = {HINGE}\nproperties = \"p\"\n\
         piece = [{{ length = {length:?}, elements = 1 }}]\n\
         mass = [{{ at = {at:?}, mass = {mass:?} }}]\n[rotor.blade.aerodynamics]\n\
         section = \"quasi_steady\"\nstrips = 3\nstations = [{stations}]\n\
         [[rotor.hinge]]\nkind = \"flap\"\noffset = {HINGE}\n[rotor.swashplate]\n\
         collective = \"t0\"\ncosine = \"t1c\"\nsine = \"t1s\"\n\
         [sensors.thrust]\nquantity = \"thrust\"\n[sensors.flap]\nquantity = \"joint_angle\"\n\
         of = \"r 1/flap\"\nunit = \"rad\"\n[periodic]\nspeed = {speed:?}\nsteps = 24\n\
         stages = \"two\"\nsettle = 1\ntolerance = 1e-4\n[trim]\n\
         [[trim.control]]\nname = \"t0\"\nguess = {t0:?}\n[[trim.control]]\nname = \"t1c\"\nguess = {t1c:?}\n\
         [[trim.control]]\nname = \"t1s\"\nguess = {t1s:?}\n\
         [[trim.target]]\nname = \"thrust\"\nsignal = \"thrust\"\nvalue = {thrust:?}\nscale = 1e4\n\
         [[trim.target]]\nname = \"forward\"\nsignal = \"flap\"\nharmonic = 1\nvalue = {:?}\n\
         [[trim.target]]\nname = \"sideward\"\nsignal = \"flap\"\nharmonic = 1\npart = \"sine\"\n\
         value = {:?}\n",
        mu * TIP_SPEED,
        -mu * TIP_SPEED * variant.shaft.to_radians().tan(),
        0.42f64.to_radians(),
        -0.14f64.to_radians(),
    )
}

/// Collective, cosine and sine in degrees.
fn controls(variant: &Variant<'_>) -> Vec<f64> {
    let folder = tempfile::tempdir().unwrap();
    let point = &trimmed(&rotor(folder.path(), variant))[0];
    assert!(point.iterations <= 5, "{point:?}");
    point
        .controls
        .iter()
        .map(|angle| angle.to_degrees())
        .collect()
}

/// Compares the controls of a variant with listed ones \[deg\].
fn compare(listed: &str, variant: &Variant<'_>, expected: [f64; 3], within: f64) {
    // The listed controls are near: an iteration or two are enough.
    let found = controls(&Variant {
        guess: expected,
        ..*variant
    });
    let names = ["collective", "cosine", "sine"].into_iter();
    for (name, (found, expected)) in names.zip(found.iter().zip(expected)) {
        let error = (found - expected).abs();
        let case = format!("Puma, flight 123, {listed}");
        let source = "Rigid flapping blades by an independent program";
        let name = format!("{name} [deg]");
        record::value(source, &case, &name, [*found, expected], error, within);
        assert!(error < within, "{case}: {name} {found} {expected}");
    }
}

// The prototype takes the angle of attack at the quarter chord. Ours is at three quarters, so that the
// turning of the section about its span counts, .2 deg here: with chords a sixth of the real ones, and
// coefficients of six times, this is .04 deg. The listed controls are met within .1 deg, the tolerance of
// the list.
const NARROW: f64 = 6.0;

/// The listed controls of a variant.
fn row(listed: &str) -> [f64; 3] {
    let it = reference("theory-rotor/puma_flight_123.json");
    let rows = it["rows"].as_array().unwrap();
    let row = rows.iter().find(|row| row[0] == *listed).unwrap();
    [1, 3, 4].map(|column: usize| row[column].as_f64().unwrap())
}

#[test]
fn controls_of_an_independent_program() {
    let variant = Variant {
        inflow: "kind = \"Drees\"\neffective_radius = 0.97",
        ..Variant::default()
    };
    compare("Drees, B .97", &variant, row("Drees, B .97"), 0.1);
}

// By an auto-pilot, from guesses that are 5 deg and more away: the thrust begins at a third of the target.
#[test]
fn controls_by_an_auto_pilot() {
    let folder = tempfile::tempdir().unwrap();
    let variant = Variant {
        inflow: "kind = \"Drees\"\neffective_radius = 0.97",
        guess: [8.0, 0.0, 0.0],
        ..Variant::default()
    };
    let text = rotor(folder.path(), &variant);
    let text = text.replace("[trim]\n", "[trim]\nmethod = \"autopilot\"\n");
    let point = &trimmed(&text)[0];
    let found = point.controls.iter().map(|angle| angle.to_degrees());
    let names = ["collective", "cosine", "sine"].into_iter();
    for ((name, found), expected) in names.zip(found).zip(row("Drees, B .97")) {
        let error = (found - expected).abs();
        let source = "Rigid flapping blades by an independent program";
        let case = "Puma, flight 123, Drees, B .97, auto-pilot";
        let name = format!("{name} [deg]");
        println!("{name} {found} {expected}, {} periods", point.iterations);
        record::value(source, case, &name, [found, expected], error, 0.1);
        assert!(error < 0.1, "{name} {found} {expected}");
    }
}

#[test]
#[ignore = "5 s; rows of the same kind are tested"]
fn controls_with_drees_inflow() {
    let listed = "Drees, a 331 m/s";
    compare(listed, &Variant::default(), row(listed), 0.1);
}

#[test]
#[ignore = "5 s; rows of the same kind are tested"]
fn controls_with_uniform_inflow() {
    let variant = Variant {
        inflow: "kind = \"uniform\"",
        ..Variant::default()
    };
    compare("uniform", &variant, row("uniform"), 0.1);
}

#[test]
#[ignore = "5 s; rows of the same kind are tested"]
fn controls_with_another_speed_of_sound() {
    let variant = Variant {
        sound: 306.0,
        ..Variant::default()
    };
    compare("Drees, a 306", &variant, row("Drees, a 306"), 0.1);
}

// The prototype has no lift in reverse flow; a linear airfoil here has the lift of the flow from behind
// there, on the inner .32 of the radius at low speed.
#[test]
#[ignore = "5 s; rows of the same kind are tested"]
fn controls_with_linear_lift() {
    let listed = "Drees, slope 5.73, reverse flow off";
    let variant = Variant {
        is_linear: true,
        ..Variant::default()
    };
    compare(listed, &variant, row(listed), 0.1);
}

/// The controls of the listed angles of the shaft.
fn at_shaft(angle: &str) {
    let it = reference("theory-rotor/puma_flight_123.json");
    let expected = numbers(&it["shaft_angle_sensitivity"][angle]);
    let variant = Variant {
        shaft: -angle.parse::<f64>().unwrap(),
        ..Variant::default()
    };
    let expected = [expected[0], expected[1], expected[2]];
    compare(&format!("shaft {angle} deg"), &variant, expected, 0.1);
}

#[test]
#[ignore = "5 s; rows of the same kind are tested"]
fn controls_at_a_shaft_of_4_degrees() {
    at_shaft("-4");
}

#[test]
#[ignore = "5 s; rows of the same kind are tested"]
fn controls_at_a_shaft_of_5_degrees() {
    at_shaft("-5");
}

#[test]
#[ignore = "5 s; rows of the same kind are tested"]
fn controls_at_a_shaft_of_7_degrees() {
    at_shaft("-7");
}

#[test]
fn controls_at_a_shaft_of_8_degrees() {
    at_shaft("-8");
}

// Measured controls (NASA TM 110421): rigid blades without lag hinges and without a loss at the tip are
// within 1 deg of the collective, .5 deg of the cosine and 1.5 deg of the sine.
#[test]
fn controls_of_the_flight_test() {
    let it = reference("theory-rotor/puma_flight_123.json");
    let measured = numbers(&it["measured"]);
    let found = controls(&Variant {
        factor: 1.0,
        ..Variant::default()
    });
    for (i, (name, within)) in [("collective", 1.0), ("cosine", 0.5), ("sine", 1.5)]
        .into_iter()
        .enumerate()
    {
        let error = (found[i] - measured[i]).abs();
        let pair = [found[i], measured[i]];
        let name = format!("{name} [deg]");
        record::value(
            "NASA TM 110421",
            "Puma, flight 123",
            &name,
            pair,
            error,
            within,
        );
        assert!(error < within, "{name} {pair:?}");
    }
}
