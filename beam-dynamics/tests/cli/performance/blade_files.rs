//! Rotors from the files of other programs.

use super::{Rows, support};
use crate::Folder;

/// The blade of IEA 15 MW from its files of HAWC2, which have neither twist nor prebend: the twist
/// is from the file of AeroDyn.
#[test]
fn a_blade_of_hawc2_needs_its_twist_and_profiles() {
    let folder = Folder::new();
    for file in ["hawc2_ae.dat", "hawc2_pc.dat"] {
        folder.write(file, &support::text(&format!("aero/iea15/{file}")));
    }
    let (radii, twists) = twist_of_aerodyn();
    let text = format!(
        "units = \"SI\"\n[rotor]\nblades = 3\nhub_radius = 3.97\nprecone = 4\ntilt = 6\n\
         file = \"hawc2_ae.dat\"\nairfoil_file = \"hawc2_pc.dat\"\ntwist_radii = [{}]\n\
         twist = [{}]\n[[schedule]]\nspeed = 8\nrotor_speed = 5.5\n",
        radii.join(", "),
        twists.join(", ")
    );
    folder.write("a.rotor.toml", &text);
    let run = folder.run(&["performance", "a.rotor.toml", "--no-figures"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""), "{}", run.out);
    assert!(!run.out.contains("twist is not"), "{}", run.out);
    let rows = Rows::of(&folder, "results/a.performance.csv", "schedule 1");
    let power = rows.column("CP [-]")[0];
    println!("CP {power:.4}");
    // The optimum of this rotor is .489 (E. Gaertner and others, NREL/TP-5000-75698, 2020); the
    // straight blade has a slightly larger disk and no prebend.
    assert!((0.44..0.51).contains(&power), "{power}");
    let without = text.replace("airfoil_file = \"hawc2_pc.dat\"\n", "");
    folder.write("a.rotor.toml", &without);
    let run = folder.run(&["performance", "a.rotor.toml"]);
    let expected = "no airfoils for \"hawc2_ae.dat\", expected \"airfoils\" or \"airfoil_file\"\n  \
                    help: add airfoils = [\"polars/*.dat\"]";
    assert!(run.code == 2 && run.err.contains(expected), "{}", run.err);
}

/// Distances from the shaft \[m\] and twist \[deg\] of the blade of IEA 15 MW.
fn twist_of_aerodyn() -> (Vec<String>, Vec<String>) {
    let blade = support::text("aero/iea15/AeroDyn15_blade.dat");
    let rows = blade.lines().skip(6).filter(|line| !line.trim().is_empty());
    let row = |line: &str| {
        let words: Vec<_> = line.split_whitespace().collect();
        let span: f64 = words[0].parse().unwrap();
        ((span + 3.97).to_string(), words[4].to_owned())
    };
    rows.map(row).unzip()
}

/// A blade whose spans begin at its root, and the same with its own twist by the distance from the shaft:
/// the same rotor, to round-off.
#[test]
fn twist_by_radii_is_the_twist_of_the_file() {
    let folder = Folder::new();
    folder.write(
        "blade.dat",
        &support::text("aero/iea15/AeroDyn15_blade.dat"),
    );
    let (radii, twists) = twist_of_aerodyn();
    let keys = format!(
        "twist_radii = [{}]\ntwist = [{}]\n",
        radii.join(", "),
        twists.join(", ")
    );
    let power = ["", keys.as_str()].map(|keys| {
        let text = format!(
            "units = \"SI\"\n[rotor]\nblades = 3\nhub_radius = 3.97\nfile = \"blade.dat\"\n\
             airfoil = \"naca0012\"\n{keys}[[schedule]]\nspeed = 8\nrotor_speed = 5.5\n"
        );
        folder.write("a.rotor.toml", &text);
        let run = folder.run(&["performance", "a.rotor.toml", "--no-figures"]);
        assert_eq!(run.code, 0, "{}", run.err);
        Rows::of(&folder, "results/a.performance.csv", "schedule 1").column("CP [-]")[0]
    });
    assert!((power[1] / power[0] - 1.0).abs() < 1e-9, "{power:?}");
}

/// Polars of the NREL 5 MW turbine by name, by a pattern and by a folder: the same power. Stations that
/// are typed use the names of the files; files of AeroDyn their order, in which 10 is after 9.
#[test]
fn airfoils_are_named_by_patterns_and_folders() {
    let folder = Folder::new();
    let names = ["Cylinder1", "DU40_A17", "NACA64_A17"];
    for name in names {
        let text = support::text(&format!("aero/nrel5mw/polar_{name}.csv"));
        folder.write(&format!("af/{name}.csv"), &text);
    }
    let power = |rotor: &str, more: &str| {
        let text = format!(
            "units = \"SI\"\n[rotor]\nblades = 3\nhub_radius = 1.5\n{rotor}\n{more}\n\
             [[schedule]]\nspeed = 8\nrotor_speed = 9\n"
        );
        folder.write("a.rotor.toml", &text);
        let run = folder.run(&["performance", "a.rotor.toml", "--no-figures"]);
        assert_eq!(run.code, 0, "{}", run.err);
        Rows::of(&folder, "results/a.performance.csv", "schedule 1").column("power [W]")[0]
    };
    let stations = "stations = [{ r = 3, chord = 3.5, twist = 13, airfoil = \"Cylinder1\" }, \
         { r = 12, chord = 4.5, twist = 13, airfoil = \"DU40_A17\" }, \
         { r = 60, chord = 1.5, airfoil = \"NACA64_A17\" }]";
    let cards = names.map(|name| format!("[airfoils.{name}]\nfile = \"af/{name}.csv\"\n"));
    let expected = power(stations, &cards.concat());
    for airfoils in [
        "\"af/*.csv\"",
        "\"af\"",
        "[\"af/*_A17.csv\", \"af/Cylinder1.csv\"]",
    ] {
        let found = power(&format!("airfoils = {airfoils}\n{stations}"), "");
        assert_eq!(found, expected, "{airfoils}");
    }
    // In the order of the numbers: the cylinder, then both others.
    for (number, name) in [(1, "Cylinder1"), (9, "DU40_A17"), (10, "NACA64_A17")] {
        let text = support::text(&format!("aero/nrel5mw/polar_{name}.csv"));
        folder.write(&format!("polars/p{number}.csv"), &text);
    }
    folder.write(
        "blade.dat",
        "AERODYN BLADE\nthree stations\n=====\n3 NumBlNds\nBlSpn BlCrvAC BlSwpAC BlCrvAng BlTwist \
         BlChord BlAFID\n(m) (m) (m) (deg) (deg) (m) (-)\n1.5 0 0 0 13 3.5 1\n10.5 0 0 0 13 4.5 2\n\
         58.5 0 0 0 0 1.5 3\n",
    );
    let found = power("file = \"blade.dat\"\nairfoils = \"polars/*.csv\"", "");
    assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}");
}

/// A polar of windIO 2.
const WINDIO_POLAR: &str = "polars:\n      - configuration: clean\n        re_sets: [{re: 1e6, \
         cl: {grid: [-180, -15, 0, 15, 180], values: [0, -1.5, 0, 1.5, 0]}, \
         cd: {grid: [-180, 180], values: [0.01, 0.01]}, cm: {grid: [-180, 180], values: [0, 0]}}]";

/// The parts of a turbine of windIO 2 but its airfoils, `inner` and `outer`.
fn windio_shape() -> String {
    let grid = |values: &str| format!("{{grid: [0, 1], values: [{values}]}}");
    format!(
        "components:\n  hub: {{diameter: 2}}\n  blade:\n    reference_axis:\n      x: {}\n      y: {}\n      \
         z: {}\n    outer_shape:\n      airfoils:\n        - {{name: inner, spanwise_position: 0}}\n        \
         - {{name: outer, spanwise_position: 1}}\n      chord: {}\n      twist: {}\n      rthick: {}\n",
        grid("0, 0"),
        grid("0, 0"),
        grid("0, 20"),
        "{grid: [0, 0.3, 0.6, 1], values: [2, 2, 1.5, 1]}",
        grid("8, 0"),
        grid("0.3, 0.2"),
    )
}

/// A turbine of windIO whose airfoils have no polars takes them from another file or from `[airfoils]`, and
/// each unknown one is reported once.
#[test]
fn polars_of_windio_may_be_in_another_file() {
    let folder = Folder::new();
    let shape = windio_shape();
    let polar = WINDIO_POLAR;
    let head = "windIO_version: '2.0'\nname: turbine\nairfoils:\n";
    let airfoil =
        |name: &str, polar: &str| format!("  - name: {name}\n    rthick: 0.3\n    {polar}\n");
    let both = |polar: &str| airfoil("inner", polar) + &airfoil("outer", polar);
    folder.write("whole.yaml", &format!("{head}{}{shape}", both(polar)));
    folder.write(
        "turbine.yaml",
        &format!("{head}{}{shape}", both("polars: []")),
    );
    folder.write("polars.yaml", &format!("{head}{}", both(polar)));
    let run = |file: &str, keys: &str, cards: &str| {
        let text = format!(
            "units = \"SI\"\n[rotor]\nblades = 3\nfile = \"{file}\"\n{keys}\n{cards}[[schedule]]\n\
             speed = 8\nrotor_speed = 30\n"
        );
        folder.write("a.rotor.toml", &text);
        folder.run(&["performance", "a.rotor.toml", "--no-figures"])
    };
    let power = |file: &str, keys: &str, cards: &str| {
        let run = run(file, keys, cards);
        assert_eq!(run.code, 0, "{}", run.err);
        Rows::of(&folder, "results/a.performance.csv", "schedule 1").column("power [W]")[0]
    };
    let expected = power("whole.yaml", "", "");
    let found = power("turbine.yaml", "airfoil_file = \"polars.yaml\"", "");
    assert_eq!(found, expected);
    let cards = ["inner", "outer"]
        .map(|name| format!("[airfoils.{name}]\nfile = \"polars.yaml\"\nairfoil = \"{name}\"\n"));
    assert_eq!(power("turbine.yaml", "", &cards.concat()), expected);
    // Airfoils of the rotor file take the place of the ones of the turbine.
    let drag = "[airfoils.outer]\nslope = 5.73\ndrag = 0.1\n";
    assert!(power("whole.yaml", "", drag) < 0.6 * expected);
    let refused = run("turbine.yaml", "", &cards[0].replace("inner]", "iner]"));
    assert_eq!(refused.code, 2);
    for words in [
        "unknown airfoils \"inner\", \"outer\" in \"turbine.yaml\"",
        "did you mean \"iner\"?",
    ] {
        assert_eq!(refused.err.matches(words).count(), 1, "{}", refused.err);
    }
    let refused = run("turbine.yaml", "", "");
    let words = "the file has no polars of them: add airfoils = [\"polars/*.dat\"]";
    assert_eq!(refused.err.matches(words).count(), 1, "{}", refused.err);
}

/// The cone of the hub of windIO counts as the same "precone" does, and a "precone" of the rotor file in its
/// place; blades of a model have their own, with a remark on another one of the file.
#[test]
fn the_cone_of_windio_counts_unless_it_is_given() {
    let folder = Folder::new();
    let airfoils = format!(
        "airfoils:\n  - name: inner\n    rthick: 0.3\n    {WINDIO_POLAR}\n  - name: outer\n    \
         rthick: 0.3\n    {WINDIO_POLAR}\n"
    );
    let head = "windIO_version: '2.0'\nname: turbine\nassembly: {number_of_blades: 3}\n";
    let straight = format!("{head}{airfoils}{}", windio_shape());
    folder.write("straight.yaml", &straight);
    let coned = straight.replace("hub: {diameter: 2}", "hub: {diameter: 2, cone_angle: 8}");
    folder.write("coned.yaml", &coned);
    folder.write("none.yaml", &straight.replace("blades: 3", "blades: 0"));
    let run = |file: &str, key: &str| {
        let text = format!(
            "units = \"SI\"\n[rotor]\nfile = \"{file}\"\n{key}\n[[schedule]]\nspeed = 8\nrotor_speed = 30\n"
        );
        folder.write("a.rotor.toml", &text);
        folder.run(&["performance", "a.rotor.toml", "--no-figures"])
    };
    let power = |file: &str, key: &str| {
        let run = run(file, key);
        assert_eq!(run.code, 0, "{}", run.err);
        Rows::of(&folder, "results/a.performance.csv", "schedule 1").column("power [W]")[0]
    };
    let [flat, coned] = [power("straight.yaml", ""), power("coned.yaml", "")];
    // The power of a cone falls with the square of its cosine and more.
    assert!(coned < 0.985 * flat, "{coned} {flat}");
    assert_eq!(power("straight.yaml", "precone = 8"), coned);
    assert_eq!(power("coned.yaml", "precone = 0"), flat);
    let refused = run("none.yaml", "");
    let words = "none.yaml: number_of_blades: found 0, expected a whole number from 1 to 100";
    assert!(
        refused.code == 2 && refused.err.contains(words),
        "{}",
        refused.err
    );
    for (precone, remarks) in [(0, 1), (8, 0), (-8, 0)] {
        let text = format!(
            "units = \"SI\"\n[properties.p]\nea = 7e9\ngay = 9e8\ngaz = 9e8\ngj = 8e8\neiy = 7e8\n\
             eiz = 7e8\nm = 11\niy = 0.001\niz = 0.001\n[[inflow]]\nname = \"i\"\n[[blade]]\nname = \"b\"\n\
             count = 3\nhub_radius = 1\nprecone = {precone}\nproperties = \"p\"\n\
             piece = [{{ length = 20, elements = 4 }}]\n[blade.aerodynamics]\ninflow = \"i\"\n\
             file = \"coned.yaml\"\n[static]\nspeed = \"30 rpm\"\n"
        );
        folder.write("a.dynamics.toml", &text);
        let run = folder.run(&["check", "a.dynamics.toml"]);
        let words = "blade \"b\": the rotor of \"coned.yaml\" has a cone of 8 deg, and the blade a \"precone\" \
                     of 0 deg, which counts";
        let found = (run.out.clone() + &run.err).matches(words).count();
        assert_eq!((run.code, found), (0, remarks), "{}{}", run.out, run.err);
    }
}

/// Angles in radians in a file whose version has degrees.
#[test]
fn polars_in_radians_are_suspected() {
    let folder = Folder::new();
    let grid = "grid: [-3.1416, -0.3, 0, 0.3, 3.1416]";
    folder.write(
        "a.yaml",
        &format!(
            "windIO_version: '2.0'\nname: t\nairfoils:\n  - name: a\n    rthick: 0.2\n    polars:\n      \
             - configuration: clean\n        re_sets: [{{re: 1e6, cl: {{{grid}, values: [0, -1.4, 0, 1.4, 0]}}, \
             cd: {{{grid}, values: [0.1, 0.03, 0.01, 0.03, 0.1]}}, \
             cm: {{{grid}, values: [0, 0, 0, 0, 0]}}}}]\n"
        ),
    );
    let rotor = |more: &str| {
        let text = format!(
            "units = \"SI\"\n[airfoils.a]\nfile = \"a.yaml\"\n{more}[rotor]\nblades = 3\nstations = [{{ r = 1, \
             chord = 1, airfoil = \"a\" }}, {{ r = 9, chord = 1, airfoil = \"a\" }}]\n[[schedule]]\n\
             speed = 8\nrotor_speed = 30\n"
        );
        folder.write("a.rotor.toml", &text);
        folder.run(&["performance", "a.rotor.toml", "--no-figures"])
    };
    let run = rotor("");
    assert_eq!(run.code, 2);
    let help = "the angles seem to be in radians, but are read as degrees";
    assert!(run.err.contains(help), "{}", run.err);
    // The file itself has a remark too, for a table that is extended to the full circle.
    let run = folder.run(&["airfoil", "a.yaml"]);
    let words =
        "the angles of airfoil \"a\" end at 3.14 deg, and its lift coefficient reaches 1.40";
    assert!(
        (run.out.clone() + &run.err).contains(words),
        "{}{}",
        run.out,
        run.err
    );
}

/// A propeller of QPROP with the polar of its file, against the output of QPROP 1.22 at 5 m/s and
/// 14020 rpm: 2.644 N and 42.29 W, 3.273 N and 44.06 W in hover. QPROP has a vortex for each blade and its own limit of
/// compressibility, and so differs from annular momentum by a few per cent.
#[test]
fn a_propeller_of_qprop_has_the_polar_of_its_file() {
    let folder = Folder::new();
    folder.write("cam.def", &support::text("aero/propellers/cam6x3.def"));
    folder.write(
        "a.rotor.toml",
        "units = \"SI\"\n[rotor]\nmachine = \"propeller\"\nfile = \"cam.def\"\n[[schedule]]\n\
         speed = [5, 0]\nrotor_speed = [14020, 14020]\n",
    );
    let run = folder.run(&["performance", "a.rotor.toml", "--no-figures"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""), "{}", run.out);
    let rows = Rows::of(&folder, "results/a.performance.csv", "schedule 1");
    let (thrust, power) = (rows.column("thrust [N]"), rows.column("power [W]"));
    let turns = 14020.0 * std::f64::consts::PI / 30.0;
    for (row, [expected, torque]) in [[2.644, 0.0288], [3.273, 0.03001]].into_iter().enumerate() {
        let found = [thrust[row] / expected, power[row] / (torque * turns)];
        println!("{found:?}");
        assert!(
            found.iter().all(|ratio| (ratio - 1.0).abs() < 0.06),
            "{found:?}"
        );
    }
}

/// The geometry that UIUC measured, whose radius is in the name of the file.
#[test]
fn a_geometry_of_uiuc_takes_an_airfoil_by_name() {
    let folder = Folder::new();
    folder.write(
        "apcsf_10x7_geom.txt",
        &support::text("aero/propellers/apcsf_10x7_geom.txt"),
    );
    let text = "units = \"SI\"\n[rotor]\nmachine = \"propeller\"\nblades = 2\n\
                file = \"apcsf_10x7_geom.txt\"\nairfoil = \"naca0012\"\n[[schedule]]\nspeed = 5\n\
                rotor_speed = 4000\n";
    folder.write("a.rotor.toml", text);
    let run = folder.run(&["performance", "a.rotor.toml", "--no-figures"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""), "{}", run.out);
    assert!(run.out.contains("2 blades, radius 0.127 m"), "{}", run.out);
    folder.write(
        "a.rotor.toml",
        &text.replace("airfoil = \"naca0012\"\n", ""),
    );
    let run = folder.run(&["performance", "a.rotor.toml"]);
    for expected in [
        "no airfoils for \"apcsf_10x7_geom.txt\"",
        "airfoil = \"NAME\" of [rotor]",
    ] {
        assert!(run.code == 2 && run.err.contains(expected), "{}", run.err);
    }
}
