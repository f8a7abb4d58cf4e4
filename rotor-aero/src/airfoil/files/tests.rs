//! Readers of airfoils against the reference files.

use std::f64::consts::PI;
use std::path::Path;

use super::samples::{path, rows, text};
use super::*;

fn file(name: &str) -> Reading {
    read(&path(name)).unwrap_or_else(|problems| panic!("{problems}"))
}

/// The problems of a text.
fn problems(text: &str, name: &str) -> String {
    let result = parse(text, Path::new(name), &Options::default());
    result
        .map(|_| String::new())
        .unwrap_or_else(|problems| problems.to_string())
}

fn has(shown: &str, parts: &[&str]) {
    for part in parts {
        assert!(shown.contains(part), "expected \"{part}\" in:\n{shown}");
    }
}

/// Rows alpha [deg], lift, drag, moment of a data set with one grid.
fn table(airfoil: &ReadAirfoil) -> Vec<[f64; 4]> {
    let data = &airfoil.data;
    let (lift, drag, moment) = (&data.lift[0], &data.drag[0], &data.moment[0]);
    assert!(lift.alpha == drag.alpha && lift.alpha == moment.alpha);
    let row = |i: usize| {
        [
            lift.alpha[i].to_degrees(),
            lift.values[i],
            drag.values[i],
            moment.values[i],
        ]
    };
    (0..lift.alpha.len()).map(row).collect()
}

/// The columns of all nodes have angles of 4 decimals and coefficients of 5 significant digits:
/// half of the last one, which is less than 1e-5 below 1.
fn agree(found: &[[f64; 4]], expected: &[&[f64]]) {
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        assert!((found[0] - expected[0]).abs() <= 5.01e-5);
        for (a, b) in found.iter().zip(expected.iter()).skip(1) {
            let digits = if b.abs() < 1.0 { 1e-5 } else { 5.01e-5 };
            assert!((a - b).abs() <= digits, "{found:?} {expected:?}");
        }
    }
}

#[test]
fn aerodyn_polars_equal_their_nodes_in_the_table_of_all_nodes() {
    let all = rows("aero/iea15/polars.csv");
    for node in [0, 20, 49] {
        let reading = file(&format!("aero/iea15/AeroDyn15_Polar_{node:02}.dat"));
        assert_eq!(reading.format, Format::AeroDyn15);
        let of_node: Vec<_> = all
            .iter()
            .filter(|row| row[0] == f64::from(node))
            .map(|row| &row[1..])
            .collect();
        agree(&table(&reading.airfoils[0]), &of_node);
    }
    let csv = file("aero/iea15/polars.csv");
    assert_eq!(csv.airfoils.len(), 50);
    let node = csv
        .airfoils
        .iter()
        .find(|airfoil| airfoil.data.name == "20")
        .unwrap();
    let polar = file("aero/iea15/AeroDyn15_Polar_20.dat");
    let polar: Vec<_> = table(&polar.airfoils[0]);
    let polar: Vec<&[f64]> = polar.iter().map(|row| &row[..]).collect();
    agree(&table(node), &polar);
}

#[test]
fn an_aerodyn_polar_keeps_its_constants_and_coordinates() {
    let reading = file("aero/iea15/AeroDyn15_Polar_20.dat");
    let airfoil = &reading.airfoils[0];
    assert_eq!(
        airfoil.coordinates.as_deref(),
        Some("IEA-15-240-RWT_AF20_Coords.txt")
    );
    assert_eq!(airfoil.data.lift[0].reynolds, Some(3e6));
    assert_eq!(airfoil.data.lift[0].alpha[0], -PI);
    assert_eq!(airfoil.data.lift[0].alpha[199], PI);
    let constants = &airfoil.unsteady[0];
    assert_eq!(constants.get("alpha0"), Some(-2.766799));
    assert_eq!(constants.get("t_f0"), None);
    assert_eq!(constants.get("Cm0"), Some(-0.085427));
    assert_eq!(constants.get("C_nalpha"), Some(7.778098));
    assert_eq!(constants.get("alpha2"), Some(-12.025354));
    assert_eq!(constants.values.len(), 32);
}

#[test]
fn columns_of_a_polar_follow_the_main_file() {
    let text = text("aero/iea15/AeroDyn15_Polar_20.dat");
    let columns = Columns {
        alpha: 1,
        lift: 3,
        drag: 2,
        moment: None,
    };
    let options = Options {
        columns: Some(columns),
    };
    let reading = parse(&text, Path::new("a.dat"), &options).unwrap();
    assert_eq!(
        reading.airfoils[0].data.lift[0].values[0],
        2.67292776565803e-2
    );
    assert!(reading.airfoils[0].data.moment.is_empty());
    let beyond = Columns {
        alpha: 1,
        lift: 2,
        drag: 7,
        moment: None,
    };
    let shown = parse(
        &text,
        Path::new("a.dat"),
        &Options {
            columns: Some(beyond),
        },
    )
    .unwrap_err();
    has(&shown.to_string(), &["a.dat:56: ", "a number in column 7"]);
}

/// Both files have the numbers of the published table.
#[test]
fn the_polar_of_aerodyn_12_equals_its_columns() {
    let old = file("aero/nrel5mw/DU21_A17_aerodyn_v12.dat");
    assert_eq!(old.format, Format::AeroDyn12);
    let columns = file("aero/nrel5mw/polar_DU21_A17.csv");
    assert_eq!(table(&old.airfoils[0]), table(&columns.airfoils[0]));
    let constants = &old.airfoils[0].unsteady[0];
    assert_eq!(constants.reynolds, Some(1e6));
    for (name, value) in [
        ("alpha0", -5.0609),
        ("alpha1", 8.0),
        ("C_nalpha", 6.2047),
        ("Cn1", 1.4144),
        ("Cn2", -0.5324),
        ("Cd0", 0.0057),
    ] {
        assert_eq!(constants.get(name), Some(value), "{name}");
    }
}

#[test]
fn columns_of_the_turbine_are_exact() {
    for name in [
        "Cylinder1",
        "Cylinder2",
        "DU21_A17",
        "DU25_A17",
        "DU30_A17",
        "DU35_A17",
        "DU40_A17",
        "NACA64_A17",
    ] {
        let name = format!("aero/nrel5mw/polar_{name}.csv");
        let reading = file(&name);
        let mut expected = rows(&name);
        expected.dedup();
        let alpha: Vec<_> = expected.iter().map(|row| row[0].to_radians()).collect();
        let data = &reading.airfoils[0].data;
        assert_eq!(data.lift[0].alpha, alpha);
        for (curve, column) in [(&data.lift, 1), (&data.drag, 2), (&data.moment, 3)] {
            let values: Vec<_> = expected.iter().map(|row| row[column]).collect();
            assert_eq!(curve[0].values, values);
        }
        // The published table of this airfoil repeats -13 deg.
        let is_repeated = reading
            .remarks
            .iter()
            .any(|remark| remark.contains("-13 is repeated"));
        assert_eq!(is_repeated, name.contains("DU25"), "{:?}", reading.remarks);
    }
}

#[test]
fn profiles_of_hawc2_have_their_own_grids() {
    let reading = file("aero/iea15/hawc2_pc.dat");
    assert_eq!(reading.format, Format::Hawc2Pc);
    let thickness: Vec<_> = reading
        .airfoils
        .iter()
        .map(|airfoil| airfoil.data.thickness.unwrap())
        .collect();
    assert_eq!(
        thickness,
        [21.1, 24.1, 27.0, 30.1, 33.0, 36.0, 50.0, 100.0].map(|t| t / 100.0)
    );
    let sizes: Vec<_> = reading
        .airfoils
        .iter()
        .map(|airfoil| airfoil.data.lift[0].alpha.len())
        .collect();
    assert_eq!(sizes, [120, 120, 120, 120, 120, 120, 199, 2]);
    let second = table(&reading.airfoils[0])[1];
    let expected = [
        -1.777142857404007e+02,
        5.402504999999973e-02,
        2.533_819_157_601_85e-2,
        9.142857142857111e-02,
    ];
    assert_eq!(second[1..], expected[1..]);
    // One rounding each way between deg and rad.
    assert!((second[0] - expected[0]).abs() < 1e-13);
}

#[test]
fn a_family_of_polars_is_sorted_by_reynolds_number() {
    let numbers = [
        "0.500", "0.030", "0.100", "0.040", "0.060", "0.080", "0.130", "0.160", "0.200", "0.300",
    ];
    for (name, title, critical) in [
        ("CLARK_Y_AIRFOIL", "CLARK Y AIRFOIL", "7.0"),
        ("NACA_4412", "NACA 4412", "6.0"),
    ] {
        let files = numbers.map(|re| {
            file(&format!(
                "aero/propellers/{name}_T1_Re{re}_M0.00_N{critical}.txt"
            ))
        });
        assert!(files.iter().all(|reading| reading.format == Format::Xfoil));
        let merged = merge(files.to_vec()).unwrap();
        assert_eq!(merged.airfoils.len(), 1);
        let data = &merged.airfoils[0].data;
        assert_eq!(data.name, title);
        let sorted: Vec<_> = data
            .lift
            .iter()
            .map(|curve| (curve.mach, curve.reynolds.unwrap()))
            .collect();
        assert_eq!(
            sorted,
            [3e4, 4e4, 6e4, 8e4, 1e5, 1.3e5, 1.6e5, 2e5, 3e5, 5e5].map(|re| (None, re))
        );
    }
    let shown = merge(vec![
        file(&format!(
            "aero/propellers/NACA_4412_T1_Re{}_M0.00_N6.0.txt",
            "0.100"
        ));
        2
    ]);
    has(
        &shown.unwrap_err().to_string(),
        &["lift of airfoil \"NACA 4412\"", "Reynolds number 100000"],
    );
}

/// The solver of XFOIL did not converge at -7 and -6 deg.
#[test]
fn missing_angles_of_xfoil_stay_missing() {
    let reading = file("aero/propellers/CLARK_Y_AIRFOIL_T1_Re0.030_M0.00_N7.0.txt");
    let rows = table(&reading.airfoils[0]);
    let at = rows
        .iter()
        .position(|row| (row[0] + 7.5).abs() < 1e-9)
        .unwrap();
    assert_eq!(rows[at][1..], [-0.2997, 0.09898, -0.0117]);
    assert!((rows[at + 1][0] + 6.5).abs() < 1e-9 && (rows[at + 2][0] + 5.5).abs() < 1e-9);
}

#[test]
fn a_c81_table_is_read_by_columns_and_written_as_it_was() {
    let name = "theory-rotor/naca0012_eq.c81";
    let reading = file(name);
    let data = &reading.airfoils[0].data;
    assert_eq!(
        (reading.format, data.name.as_str()),
        (Format::C81, "NACA0012-EQ")
    );
    for curves in [&data.lift, &data.drag, &data.moment] {
        assert_eq!(
            curves
                .iter()
                .map(|curve| curve.mach.unwrap())
                .collect::<Vec<_>>(),
            [0.15, 0.3, 0.4, 0.5, 0.6, 0.7, 0.75, 0.8]
        );
        assert!(curves.iter().all(|curve| curve.alpha.len() == 91));
    }
    assert_eq!(
        data.lift[1].values[data.lift[1]
            .alpha
            .iter()
            .position(|a| (a.to_degrees() + 25.0).abs() < 1e-9)
            .unwrap()],
        -0.9543
    );
    let written = write(&reading.airfoils, Format::C81, "a.c81").unwrap();
    assert!(written.lost.is_empty());
    assert_eq!(written.text, text(name));
    // By its content, too.
    assert_eq!(
        recognize(&written.text, Path::new("a.dat")),
        Some(Format::C81)
    );
}

#[test]
fn fields_of_c81_touch_and_blocks_have_their_own_grids() {
    let head = "TOUCHING                       1 2 2 3 1 2\n";
    let lift = "          0.00\n-180.00-1.0355\n 180.00-1.0355\n";
    let drag =
        "          0.10   0.50\n-180.00 100000200000.\n   0.00   .010   .012\n 180.00   1      2\n";
    let moment = "          0.00\n -10.00   .001\n  10.00  -.001\n";
    let reading = parse(
        &format!("{head}{lift}{drag}{moment}"),
        Path::new("a.c81"),
        &Options::default(),
    );
    let reading = reading.unwrap_or_else(|problems| panic!("{problems}"));
    let data = &reading.airfoils[0].data;
    assert_eq!(data.lift[0].values, [-1.0355, -1.0355]);
    assert_eq!(data.lift[0].mach, None);
    assert_eq!(data.drag[1].values, [200000.0, 0.012, 2.0]);
    assert_eq!(data.moment[0].alpha.len(), 2);
}

pub(super) const VERSION_1: &str = "windIO_version: '1.0'\nairfoils:\n  - name: thin\n    relative_thickness: 0.21\n    aerodynamic_center: 0.25\n    polars:\n      - configuration: Default\n        re: 3.0e6\n        c_l: {grid: [-3.14, 0, 3.14], values: [0.1, 0.5, 0.3]}\n        c_d: {grid: [-3.141592653589793, 3.141592653589793], values: [0.01, 0.01]}\n        c_m: {grid: [-3.1416, 0, 3.1416], values: [0, -0.1, 0]}\n";

pub(super) const VERSION_2: &str = "windIO_version: '2.0'\nairfoils:\n  - name: thin\n    rthick: 0.21\n    polars:\n      - configuration: Default\n        re_sets:\n          - re: 3.0e6\n            cl: {grid: [-180, 0, 180], values: [0.1, 0.5, 0.1]}\n            cd: {grid: [-180, 180], values: [0.01, 0.01]}\n            cm: {grid: [-180, 180], values: [0, 0]}\n          - re: 6.0e6\n            cl: {grid: [-180, 180], values: [0, 0]}\n            cd: {grid: [-180, 180], values: [0.02, 0.02]}\n      - configuration: Rough\n        re_sets:\n          - re: 3.0e6\n            cl: {grid: [-180, 180], values: [0, 0]}\n            cd: {grid: [-180, 180], values: [0.03, 0.03]}\n            cm: {grid: [-180, 180], values: [0, 0]}\n";

#[test]
fn windio_1_is_in_rad_and_closed_at_pi() {
    let reading = parse(VERSION_1, Path::new("a.yaml"), &Options::default()).unwrap();
    let airfoil = &reading.airfoils[0];
    assert_eq!(
        (airfoil.data.thickness, airfoil.aerodynamic_center),
        (Some(0.21), Some(0.25))
    );
    let lift = &airfoil.data.lift[0];
    // The file ends at 3.14, the nearest number to 314/100.
    let end = 314.0 / 100.0;
    assert_eq!(lift.alpha, [-PI, -end, 0.0, end, PI]);
    // The value in the middle of the gap between 0.3 and 0.1.
    assert!((lift.values[0] - 0.2).abs() < 1e-12 && (lift.values[4] - 0.2).abs() < 1e-12);
    assert_eq!(lift.reynolds, Some(3e6));
    assert_eq!(airfoil.data.moment[0].alpha, [-PI, 0.0, PI]);
    has(
        &reading.remarks.join("\n"),
        &["is closed at pi", "is set to half a turn"],
    );
}

#[test]
fn windio_2_is_in_deg_and_has_configurations() {
    let reading = parse(VERSION_2, Path::new("a.yaml"), &Options::default()).unwrap();
    let names: Vec<_> = reading
        .airfoils
        .iter()
        .map(|airfoil| airfoil.data.name.as_str())
        .collect();
    assert_eq!(names, ["thin/Default", "thin/Rough"]);
    let data = &reading.airfoils[0].data;
    assert_eq!((data.lift.len(), data.moment.len()), (2, 1));
    assert_eq!(data.lift[0].alpha, [-PI, 0.0, PI]);
    assert_eq!(reading.airfoils[1].data.drag[0].values, [0.03, 0.03]);
}

#[test]
fn columns_have_their_units() {
    let header = "thickness [%],Re [1e6],alpha [deg],cl [-],cd\n";
    let rows: String = [-180, 0, 180]
        .map(|alpha| format!("21,3,{alpha},0,0.01\n"))
        .concat();
    let path = Path::new("a.csv");
    let reading = parse(&format!("{header}{rows}"), path, &Options::default()).unwrap();
    let data = &reading.airfoils[0].data;
    assert!((data.thickness.unwrap() - 0.21).abs() < 1e-15);
    assert_eq!(data.lift[0].reynolds, Some(3e6));
    let shown = problems(&format!("{}{rows}", header.replace("[-]", "[N]")), "a.csv");
    has(
        &shown,
        &["a.csv:1: unit of column \"cl\"", "\"n\"", "a factor"],
    );
}

#[test]
fn all_problems_of_a_file_are_reported_at_once() {
    let csv = "alpha [deg],cl,cd\n-200,0,0.1\n0,x,0.1\n5,1,0.1\n4,1,0.1\n5,2,0.1\n6,nan\n";
    let shown = problems(csv, "a.csv");
    has(
        &shown,
        &[
            "a.csv:2: ",
            "-200 deg, expected -180 to 180 deg",
            "a.csv:3: cl: expected a finite number, found \"x\"",
            "a.csv:5: ",
            "4 after a larger angle",
            "a.csv:6: ",
            "5 again, with other values",
            "a.csv:7: ",
            "2 cells",
        ],
    );
    has(
        &problems("alpha,cl,cd\n0,0,0\n", "a.csv"),
        &["unit of column \"alpha\"", "help: write \"alpha [deg]\""],
    );
    has(
        &problems("alpha [deg],cl\n0,0\n", "a.csv"),
        &["column \"cd\" is missing"],
    );
    has(
        &problems("alpha [deg],cl,cd\n", "a.csv"),
        &["a row of numbers after the header is missing"],
    );
    has(&problems(" \r\n\t\n", "a.dat"), &["the file is blank"]);
    has(
        &problems("\u{0}\u{1}PNG", "a.dat"),
        &["one of these formats: windIO file, AeroDyn 15 polar"],
    );
}

/// One fault, one problem.
#[test]
fn airfoils_of_windio_without_polars_are_reported_once() {
    let head = "windIO_version: '2.0'\nairfoils:\n  - name: thin\n    rthick: 0.21\n";
    for (polars, expected) in [
        (
            "",
            "a.yaml:3: key \"polars\" of airfoil \"thin\" is missing",
        ),
        (
            "    polars: []\n",
            "a.yaml:3: a polar of airfoil \"thin\" is missing",
        ),
        ("    polars: 3\n", "a.yaml:5: polars"),
    ] {
        let shown = problems(&format!("{head}{polars}"), "a.yaml");
        has(&shown, &[expected]);
        assert_eq!(shown.matches("error:").count(), 1, "{shown}");
    }
}

#[test]
fn cut_files_are_reported() {
    let cut = |name: &str, lines: usize| {
        let text: Vec<_> = text(name).lines().take(lines).map(str::to_owned).collect();
        problems(&text.join("\n"), "cut.dat")
    };
    has(
        &cut("aero/iea15/AeroDyn15_Polar_20.dat", 100),
        &["cut.dat:100: the file ends within a table of coefficients, expected 200 rows, found 46"],
    );
    has(
        &cut("aero/iea15/hawc2_pc.dat", 300),
        &["cut.dat:300: the file ends within profile 3 of set 1"],
    );
    has(
        &cut("theory-rotor/naca0012_eq.c81", 150),
        &["cut.dat:150: the file ends within drag, angle 57 of 91"],
    );
    has(
        &cut("aero/propellers/NACA_4412_T1_Re0.100_M0.00_N6.0.txt", 8),
        &["line of dashes"],
    );
    has(
        &cut("aero/iea15/AeroDyn15_Polar_20.dat", 20),
        &["NumAlf and its rows is missing"],
    );
}

#[test]
fn tables_that_c81_cannot_count_are_refused() {
    let mut reading = file("aero/iea15/AeroDyn15_Polar_20.dat");
    let shown = write(&reading.airfoils, Format::C81, "a.c81")
        .unwrap_err()
        .to_string();
    has(
        &shown,
        &["1 Mach numbers and 200 angles, expected at most 99 of both"],
    );
    let curve = &mut reading.airfoils[0].data.lift[0];
    (curve.alpha, curve.values) = (vec![0.0, 1e-9], vec![1e9, 0.0]);
    let data = reading.airfoils[0].data.clone();
    reading.airfoils[0].data.drag = data.lift.clone();
    reading.airfoils[0].data.moment.clear();
    has(
        &write(&reading.airfoils, Format::C81, "a.c81")
            .unwrap_err()
            .to_string(),
        &["a number of at most six characters"],
    );
    let head = format!("{:<30}{}\n       \n", "TOO MANY", " 1107 1 1 1 1");
    has(
        &problems(&head, "a.c81"),
        &["at most 99 Mach numbers and 99 angles"],
    );
    assert!(
        write(&reading.airfoils, Format::Xfoil, "a")
            .unwrap_err()
            .to_string()
            .contains("cannot be written")
    );
}

/// Windows line ends, tabs, and comments in another encoding.
#[test]
fn foreign_bytes_and_line_ends_are_read() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("airfoil.dat");
    let text = text("aero/nrel5mw/DU21_A17_aerodyn_v12.dat");
    let mut bytes = b"Profil f\xfcr Fl\xfcgel\r\n".to_vec();
    bytes.extend(text.replace('\n', "\r\n").replace("   ", "\t").into_bytes());
    std::fs::write(&path, bytes).unwrap();
    let reading = read(&path).unwrap_or_else(|problems| panic!("{problems}"));
    let plain = file("aero/nrel5mw/DU21_A17_aerodyn_v12.dat");
    assert_eq!(reading.airfoils[0].data.lift, plain.airfoils[0].data.lift);
    assert_eq!(reading.airfoils[0].data.name, "airfoil");
    has(&reading.remarks.join("\n"), &["bytes that are no UTF-8"]);
    assert!(
        read(&folder.path().join("airfoil.dta"))
            .unwrap_err()
            .to_string()
            .contains("airfoil.d")
    );
}
