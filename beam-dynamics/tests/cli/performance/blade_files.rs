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
    let expected = "all stations of \"hawc2_ae.dat\" have no airfoil, expected an airfoil for each \
                    station\n  help: name the profile coefficients as airfoil_file";
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
    let expected = "all stations of \"apcsf_10x7_geom.txt\" have no airfoil";
    assert!(run.code == 2 && run.err.contains(expected), "{}", run.err);
}
