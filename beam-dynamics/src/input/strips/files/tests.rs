//! Blades in the air from files, against the files themselves.

use std::fs;
use std::path::Path;

use nalgebra::Vector3;
use rotor_aero::airfoil::Flow;
use shared_geom::document::Document;

use super::*;
use crate::input::{aerodynamics, drives, strips};

const AERO: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reference/aero");

/// A straight line along x.
fn straight(at: f64) -> Vector3<f64> {
    Vector3::new(at, 0.0, 0.0)
}

/// The stations of `[air]` in a text whose paths begin in `folder`; or the problems.
fn stations(
    text: &str,
    folder: &str,
    line: &BladeLine<'_>,
) -> Result<(Stations, Vec<String>), String> {
    let document = Document::parse(text, &format!("{folder}/a.toml")).unwrap();
    let root = document.root();
    let airfoils =
        aerodynamics::read(&root, &Vector3::zeros(), &drives::read_named(&root, &[])).airfoils;
    let table = root.table("blade_air").unwrap().described(&strips::CARD);
    let mut remarks = Vec::new();
    let found = read(&table, &airfoils, ("blade \"b\"", line), &mut remarks);
    let found = found.map(|stations| (stations, remarks));
    let problems = document
        .finish(found)
        .map_err(|problems| problems.to_string());
    problems.map_err(|text| text.replace(&format!("{folder}/"), ""))
}

fn read_straight(text: &str, folder: &str, length: f64) -> Result<(Stations, Vec<String>), String> {
    let position = &straight;
    stations(
        text,
        folder,
        &BladeLine {
            length,
            position,
            precone: None,
        },
    )
}

/// Rows of numbers of a file after its first `skip` lines.
fn rows(file: &str, skip: usize) -> Vec<Vec<f64>> {
    let text = fs::read_to_string(format!("{AERO}/{file}")).unwrap();
    let rows = text.lines().skip(skip);
    rows.map(|row| {
        row.split_whitespace()
            .map_while(|word| word.parse().ok())
            .collect()
    })
    .collect()
}

const IEA: &str = "[blade_air]\nfile = \"AeroDyn15_blade.dat\"\nairfoil_file = \"polars.csv\"\n";

/// Sign of the twist and position of the line, from the numbers of the file by the formula of the
/// head of `files.rs`; the line is straight, so that arc lengths are the numbers of the file.
#[test]
fn aerodyn_stations_of_a_straight_line_are_the_file() {
    let (found, _) = read_straight(IEA, &format!("{AERO}/iea15"), 117.0).unwrap();
    let positions: Vec<_> = found.positions().collect();
    let rows = rows("iea15/AeroDyn15_blade.dat", 6);
    assert_eq!((positions.len(), rows.len()), (50, 50));
    for (position, row) in positions.iter().zip(&rows) {
        assert_eq!(*position, row[0]);
        let at = found.at(*position).unwrap();
        let (downwind, back, feather) = (row[1], row[2], row[4].to_radians());
        let axis = 0.25 - (feather.cos() * back + feather.sin() * downwind) / row[5];
        // Round-off of the interpolation between stations, of numbers of the size of 10.
        for (found, expected) in [(at.chord, row[5]), (at.twist, -feather), (at.axis, axis)] {
            assert!((found - expected).abs() < 1e-13, "{found} {expected}");
        }
    }
    // Row of polars.csv: node 20, 5.75758 deg.
    let text = fs::read_to_string(format!("{AERO}/iea15/polars.csv")).unwrap();
    let row = text
        .lines()
        .find(|line| line.starts_with("20,5.75758,"))
        .unwrap();
    let expected: f64 = row.split(',').nth(2).unwrap().parse().unwrap();
    let section = found.at(positions[20]).unwrap().airfoil;
    let flow = Flow::<f64> {
        alpha: 5.75758_f64.to_radians(),
        mach: 0.0,
        reynolds: 1e7,
        flap: 0.0,
    };
    assert!((section.at(&flow).lift - expected).abs() < 1e-12);
}

/// A line through the aerodynamic centers is at their quarter chord, wherever the blade bends.
#[test]
fn a_line_through_the_aerodynamic_centers_is_at_the_quarter_chord() {
    let rows = rows("iea15/AeroDyn15_blade.dat", 6);
    let points: Vec<_> = rows
        .iter()
        .map(|row| Vector3::new(row[0], -row[2], row[1]))
        .collect();
    let mut lengths = vec![0.0];
    for pair in points.windows(2) {
        lengths.push(lengths[lengths.len() - 1] + (pair[1] - pair[0]).norm());
    }
    let position = |at: f64| {
        let i = lengths.partition_point(|length| *length <= at).clamp(1, 49);
        let share = (at - lengths[i - 1]) / (lengths[i] - lengths[i - 1]);
        points[i - 1] + (points[i] - points[i - 1]) * share
    };
    let line = BladeLine {
        length: lengths[49],
        position: &position,
        precone: None,
    };
    let (found, remarks) = stations(IEA, &format!("{AERO}/iea15"), &line).unwrap();
    for (found_at, expected) in found.positions().zip(&lengths) {
        // Round-off of the bisection: the spacing of numbers of the size of 117.
        assert!((found_at - expected).abs() < 1e-12, "{found_at} {expected}");
        let axis = found.at(found_at).unwrap().axis;
        assert!((axis - 0.25).abs() < 1e-12, "{axis}");
    }
    assert!(!remarks.iter().any(|remark| remark.contains("off the line")));
}

/// Thickness of the ae file by the profiles of the pc file, twist of the blade file; the profile of
/// 0.36 is alone where the thickness, linear between two stations, is 0.36.
#[test]
fn hawc2_layouts_have_profiles_by_thickness() {
    let text = "[blade_air]\nfile = \"hawc2_ae.dat\"\nairfoil_file = \"hawc2_pc.dat\"\n\
                twist_file = \"../../exchange/hawc2_dtu10.htc\"\n";
    let (found, _) = read_straight(text, &format!("{AERO}/iea15"), 117.2).unwrap();
    let rows = rows("iea15/hawc2_ae.dat", 2);
    assert_eq!(found.positions().count(), 30);
    let htc = format!("{AERO}/../exchange/hawc2_dtu10.htc");
    let curve = exchange::read(Path::new(&htc)).unwrap().blade.line.curve();
    for (position, row) in found.positions().zip(&rows) {
        let at = found.at(position).unwrap();
        assert_eq!((position, at.axis), (row[0], 0.5));
        assert!((at.chord - row[1]).abs() < 1e-13);
        assert!((at.twist - curve.at(position).twist).abs() < 1e-13);
    }
    let i = rows.iter().position(|row| row[2] < 36.0).unwrap() - 1;
    let share = (rows[i][2] - 36.0) / (rows[i][2] - rows[i + 1][2]);
    assert!(share > 0.01 && share < 0.99, "{share}");
    let middle = rows[i][0] + share * (rows[i + 1][0] - rows[i][0]);
    let flow = Flow::<f64> {
        alpha: 0.2,
        mach: 0.0,
        reynolds: 1e7,
        flap: 0.0,
    };
    let lift = |at: f64| found.at(at).unwrap().airfoil.at(&flow).lift;
    let pc = rotor_aero::airfoil::files::read(Path::new(&format!("{AERO}/iea15/hawc2_pc.dat")));
    let pc = pc.unwrap().airfoils;
    let profile = pc.iter().find(|one| one.data.thickness == Some(0.36));
    let interpolation = rotor_aero::airfoil::Interpolation::Monotone;
    let profile = rotor_aero::airfoil::Airfoil::new(&profile.unwrap().data, interpolation).unwrap();
    assert!((lift(middle) - profile.at(&flow).lift).abs() < 1e-9);
}

/// The 17 stations of the NREL 5 MW turbine, by radius, with the twist towards feather.
#[test]
fn nrel_5mw_twist_towards_feather_is_nose_down() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().display().to_string();
    let blade = fs::read_to_string(format!("{AERO}/nrel5mw/blade.csv")).unwrap();
    fs::write(
        folder.path().join("blade.csv"),
        blade.replace("twist_deg", "feather_deg"),
    )
    .unwrap();
    let mut text = String::from("[blade_air]\nfile = \"blade.csv\"\nroot_radius = 1.5\n");
    let names = [
        "Cylinder1",
        "Cylinder2",
        "DU40_A17",
        "DU35_A17",
        "DU30_A17",
        "DU25_A17",
    ];
    for name in names.iter().chain(&["DU21_A17", "NACA64_A17"]) {
        let file = format!("{AERO}/nrel5mw/polar_{name}.csv");
        text += &format!("[airfoils.{name}]\nfile = \"{file}\"\n");
    }
    let (found, _) = read_straight(&text, &path, 61.5).unwrap();
    let rows = blade.lines().skip(3).map(|row| {
        let cells: Vec<f64> = row.split(',').map_while(|cell| cell.parse().ok()).collect();
        cells
    });
    let rows: Vec<_> = rows.collect();
    assert_eq!((found.positions().count(), rows.len()), (17, 17));
    for (position, row) in found.positions().zip(&rows) {
        let at = found.at(position).unwrap();
        assert_eq!(position, row[0] - 1.5);
        assert!((at.twist + row[2].to_radians()).abs() < 1e-14);
        assert!((at.chord - row[1]).abs() < 1e-13 && at.axis == 0.25);
    }
    // Radii without their origin, and an origin beyond the first station.
    let shown = read_straight(&text.replace("root_radius = 1.5\n", ""), &path, 61.5).unwrap_err();
    assert!(
        shown.contains("stations by their radius, expected \"root_radius\""),
        "{shown}"
    );
    let shown = read_straight(&text.replace("1.5", "3.5"), &path, 61.5).unwrap_err();
    let expected = "station 1 of \"blade.csv\" is at -0.6333 m from the root";
    assert!(
        shown.contains(expected) && shown.contains("\"root_radius\", or the length"),
        "{shown}"
    );
    // An airfoil that no table has is reported once, though eight stations have it.
    let shown = read_straight(
        &text.replace("[airfoils.NACA64_A17]", "[airfoils.NACA64]"),
        &path,
        61.5,
    );
    let shown = shown.unwrap_err();
    assert_eq!(
        shown.matches("unknown airfoil \"NACA64_A17\"").count(),
        1,
        "{shown}"
    );
}

const WINDIO: &str = "windIO_version: '2.0'\nname: turbine\nairfoils:\n  - name: a\n    rthick: 0.4\n    polars:\n      - configuration: clean\n        re_sets: [{re: 1e6, cl: {grid: [-180, 0, 180], values: [0, 0.5, 0]}, cd: {grid: [-180, 180], values: [0.1, 0.1]}, cm: {grid: [-180, 180], values: [0, 0]}}]\ncomponents:\n  blade:\n    reference_axis:\n      x: {grid: [0, 1], values: [0, 0]}\n      y: {grid: [0, 1], values: [0, 0]}\n      z: {grid: [0, 1], values: [0, 48]}\n    outer_shape:\n      airfoils:\n        - {name: a, spanwise_position: 0, configuration: [clean], weight: [1]}\n        - {name: a, spanwise_position: 1, configuration: [clean], weight: [1]}\n      chord: {grid: [0, 0.5, 1], values: [3, 4, 1]}\n      twist: {grid: [0, 1], values: [18, 0]}\n      section_offset_y: {grid: [0, 1], values: [1.5, 0.5]}\n      rthick: {grid: [0, 1], values: [0.4, 0.4]}\n";

#[test]
fn windio_files_have_their_airfoils() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("t.yaml"), WINDIO).unwrap();
    let path = folder.path().display().to_string();
    let text = "[blade_air]\nfile = \"t.yaml\"\n";
    let (found, _) = read_straight(text, &path, 48.0).unwrap();
    assert_eq!(found.positions().collect::<Vec<_>>(), [0.0, 24.0, 48.0]);
    let middle = found.at(24.0).unwrap();
    // 18 deg towards feather at the root, half of it here; 1 m behind the edge of a chord of 4 m.
    assert!((middle.twist.to_degrees() + 9.0).abs() < 1e-12);
    assert!((middle.axis - 0.25).abs() < 1e-12);
    let flow = Flow::<f64> {
        alpha: 0.0,
        mach: 0.0,
        reynolds: 1e6,
        flap: 0.0,
    };
    assert_eq!(middle.airfoil.at(&flow).lift, 0.5);
    // Ends that differ are one remark.
    let open = WINDIO.replace("values: [0, 0.5, 0]", "values: [0, 0.5, 0.01]");
    fs::write(folder.path().join("t.yaml"), open).unwrap();
    let (_, remarks) = read_straight(text, &path, 48.0).unwrap();
    let ends = remarks.iter().filter(|remark| remark.contains("180 deg"));
    assert_eq!(ends.count(), 1, "{remarks:?}");
    let shown = read_straight(text, &path, 47.0).unwrap_err();
    let expected = "station 3 of \"t.yaml\" is at 48 m from the root, expected a position on the \
                    line, from 0 to 47 m";
    assert!(shown.contains(expected), "{shown}");
}

/// Faults of a table, and a part of each message.
#[test]
fn faults_are_reported_with_their_remedies() {
    let iea = format!("{AERO}/iea15");
    for (keys, expected) in [
        (
            "file = \"AeroDyn15_blade.dat\"\n",
            "expected \"airfoils\" or \"airfoil_file\"",
        ),
        (
            "file = \"AeroDyn15_blade.dat\"\nairfoils = [\"naca0012\", \"AeroDyn15_Polar_*.dat\"]\n",
            "station 50 of \"AeroDyn15_blade.dat\" has the airfoil number 50, expected 1 to 4",
        ),
        (
            "file = \"AeroDyn15_blade.dat\"\nairfoils = \"Polar_*.dat\"\n",
            "no file is named \"Polar_*.dat\"",
        ),
        (
            "file = \"hawc2_ae.dat\"\nairfoil_file = \"hawc2_pc.dat\"\n",
            "\"hawc2_ae.dat\" has no twist, expected \"twist_file\"",
        ),
        // A wrong file of airfoils alone: the ones that it may have are not missing.
        (
            "file = \"AeroDyn15_blade.dat\"\nairfoil_file = \"hawc2_ae.dat\"\n",
            "hawc2_ae.dat",
        ),
        (
            "file = \"hawc2_ae.dat\"\nset = 2\nairfoil_file = \"hawc2_pc.dat\"\n",
            "set 2 is missing",
        ),
        ("file = \"blade.dat\"\n", "\"blade.dat\""),
        ("file = \"polars.csv\"\n", "format of the file"),
    ] {
        let shown = read_straight(&format!("[blade_air]\n{keys}"), &iea, 117.2).unwrap_err();
        assert!(shown.contains(expected), "{expected:?} in:\n{shown}");
        assert!(shown.contains("help"), "{shown}");
        let is_missing = keys.matches('\n').count() == 1 && keys.contains("AeroDyn15");
        assert_eq!(shown.contains("no airfoils for"), is_missing, "{shown}");
    }
}

// The thicknesses of the file, 23 % at the tip, as fractions: less than any of the airfoils, in percent.
#[test]
fn thicknesses_as_fractions_name_the_unit_of_the_file() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["hawc2_ae.dat", "hawc2_pc.dat", "AeroDyn15_blade.dat"] {
        let text = fs::read_to_string(format!("{AERO}/iea15/{name}")).unwrap();
        let fraction = |line: &str| {
            let words: Vec<_> = line.split_whitespace().collect();
            match words[..] {
                [at, chord, thickness, set] => thickness.parse::<f64>().map_or_else(
                    |_| line.to_owned(),
                    |thickness| format!("{at} {chord} {} {set}", thickness / 100.0),
                ),
                _ => line.to_owned(),
            }
        };
        let text = match name {
            "hawc2_ae.dat" => text.lines().map(fraction).collect::<Vec<_>>().join("\n"),
            _ => text,
        };
        fs::write(folder.path().join(name), text).unwrap();
    }
    let keys = "[blade_air]\nfile = \"hawc2_ae.dat\"\nairfoil_file = \"hawc2_pc.dat\"\n";
    let shown = read_straight(keys, folder.path().to_str().unwrap(), 117.2).unwrap_err();
    let expected = "% of the chord, less than any airfoil\n  help: the ae file of HAWC2 has thicknesses in percent \
                    of the chord: ";
    assert!(shown.contains(expected), "{shown}");
}
