//! Families of files and changes of tables in `[airfoils.NAME]`.

use std::fs;

use rotor_aero::airfoil::Flow;
use shared_geom::document::Document;

use super::*;

/// The airfoils of a text beside two polars to 12 deg, of lift 1.3 and 1.5 there.
fn airfoils(text: &str) -> Result<Airfoils, String> {
    let folder = tempfile::tempdir().unwrap();
    for (name, reynolds, lift) in [("1.csv", "1e6", 1.3), ("2.csv", "2e6", 1.5)] {
        let rows = format!(
            "airfoil,reynolds,alpha [deg],cl,cd,cm\np{name},{reynolds},-10,-0.8,0.02,0\n\
             p{name},{reynolds},0,0.2,0.01,0\np{name},{reynolds},12,{lift},0.03,0\n"
        );
        fs::write(folder.path().join(name), rows).unwrap();
    }
    let file = folder.path().join("a.toml").display().to_string();
    let document = Document::parse(text, &file).unwrap();
    let found = read(&document.root());
    let found = document.finish(Some(found));
    found.map_err(|problems| problems.to_string())
}

/// The only airfoil in a flow of -12, 12 or 90 deg.
fn at(airfoils: &Airfoils, alpha_deg: f64, reynolds: f64) -> [f64; 2] {
    let airfoil = airfoils.named[0].1.as_ref().unwrap();
    let found = airfoil.at(&Flow {
        alpha: alpha_deg.to_radians(),
        mach: 0.0,
        reynolds,
        flap: 0.0,
    });
    [found.lift, found.drag]
}

#[test]
fn files_are_one_table_over_the_reynolds_number_and_are_extended() {
    let text = "[airfoils.a]\nfile = [\"1.csv\", \"2.csv\"]\nviterna = { aspect_ratio = 17 }\n";
    let found = airfoils(text).unwrap();
    // Points of the tables; 1.11 + 0.018 * 17 at 90 deg, a multiple of the step of the extension.
    for (reynolds, lift) in [(1e6, 1.3), (2e6, 1.5)] {
        assert!((at(&found, 12.0, reynolds)[0] - lift).abs() < 1e-12);
        assert!((at(&found, 90.0, reynolds)[1] - 1.416).abs() < 1e-12);
    }
    let between = at(&found, 12.0, 1.5e6)[0];
    assert!(between > 1.3 && between < 1.5, "{between}");
    let mirrored = airfoils(&format!("{text}mirror = true\n")).unwrap();
    assert!((at(&mirrored, -12.0, 1e6)[0] + 1.3).abs() < 1e-12);
    let text = "[airfoils.a]\nbuilt_in = \"naca0012\"\n\
                stall_delay = { law = \"Snel\", chord_ratio = 0.3 }\n";
    let (delayed, plain) = (
        airfoils(text).unwrap(),
        "[airfoils.a]\nbuilt_in = \"naca0012\"\n",
    );
    // Snel adds lift beyond stall.
    assert!(at(&delayed, 20.0, 1e6)[0] > at(&airfoils(plain).unwrap(), 20.0, 1e6)[0] + 0.1);
}

#[test]
fn faults_of_changes_have_remedies() {
    for (keys, expected) in [
        ("file = \"1.csv\"", "add \"viterna = true\" to [airfoils.a]"),
        (
            "file = [\"1.csv\", \"1.csv\"]\nviterna = true",
            "two tables at Mach number any, Reynolds",
        ),
        ("file = []", "a file is missing"),
        (
            "slope = 6\nmirror = true",
            "has \"mirror\" without \"file\"",
        ),
        (
            "file = \"1.csv\"\nairfoil = \"q\"\nviterna = true",
            "unknown airfoil of the file \"q\"",
        ),
        ("file = \"1.csv\"\nviterna = 3", "\"viterna\""),
        (
            "file = \"1.csv\"\nviterna = { drag_90 = -1 }",
            "\"drag_90\"",
        ),
    ] {
        let shown = airfoils(&format!("[airfoils.a]\n{keys}\n")).unwrap_err();
        assert!(shown.contains(expected), "{expected:?} in:\n{shown}");
    }
}

/// Constants of a polar of AeroDyn 15, replaced by keys; other Mach numbers of NACA 0012 by Leishman
/// and Beddoes (1989): T_p = 2, C_N1 = 1.05 at Mach 0.5.
#[test]
fn constants_of_unsteady_models() {
    let polar = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/reference/aero/iea15/AeroDyn15_Polar_20.dat"
    );
    let of = |text: &str| {
        let found = airfoils(text).unwrap();
        let airfoil = found.named[0].1.clone().unwrap();
        airfoil.unsteady().clone()
    };
    let file = format!("[airfoils.a]\nfile = \"{}\"\n", polar.replace('\\', "/"));
    let found = of(&file);
    assert_eq!(found.get("alpha0"), Some(-2.766799));
    assert_eq!((found.get("Cn1"), found.get("T_p")), (Some(1.944572), None));
    let found = of(&format!(
        "{file}unsteady = {{ critical_normal = 1.5, zero_lift = -3, pressure_time = 2 }}\n"
    ));
    assert_eq!((found.get("Cn1"), found.get("T_p")), (Some(1.5), Some(2.0)));
    assert!((found.get("alpha0").unwrap() + 3.0).abs() < 1e-12);
    assert_eq!(of(&format!("{file}mirror = true\n")).get("Cn1"), None);
    let built_in = "[airfoils.a]\nbuilt_in = \"naca0012\"\n";
    let found = of(&format!(
        "{built_in}unsteady = {{ mach = 0.5, suction = 0.9 }}\n"
    ));
    assert_eq!(
        (found.get("T_p"), found.get("Cn1")),
        (Some(2.0), Some(1.05))
    );
    assert_eq!(found.get("eta_e"), Some(0.9));
    let shown = airfoils(&format!("{built_in}unsteady = {{ mach = 0.9 }}\n")).unwrap_err();
    let expected = "\"mach\" is 0.9, expected a Mach number from 0.3 to 0.8";
    assert!(shown.contains(expected), "{shown}");
    let shown = airfoils(&format!(
        "{built_in}unsteady = {{ vortex_time = 0, mah = 1 }}\n"
    ));
    let shown = shown.unwrap_err();
    for words in ["\"vortex_time\"", "unknown key \"mah\"", "\"mach\""] {
        assert!(shown.contains(words), "{words}\n{shown}");
    }
}
