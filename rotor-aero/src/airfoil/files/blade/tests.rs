//! Readers of aerodynamic blades against the reference files.

use std::path::Path;

use super::super::samples::{Random, mutated, path, text};
use super::*;

fn file(name: &str) -> BladeAero {
    read_blade(&path(name), &BladeOptions::default())
        .unwrap_or_else(|problems| panic!("{problems}"))
}

fn problems(text: &str, name: &str) -> String {
    let result = parse_blade(text, Path::new(name), &BladeOptions::default());
    result
        .map(|_| String::new())
        .unwrap_or_else(|problems| problems.to_string())
}

fn near(found: f64, expected: f64) {
    // Numbers of the file after one or two roundings.
    assert!(
        (found - expected).abs() <= 1e-14 * expected.abs().max(1.0),
        "{found} {expected}"
    );
}

/// Numbers of the first and second row of the file; its twist and sweep change their signs.
#[test]
fn an_aerodyn_blade_has_nose_up_twist() {
    let blade = file("aero/iea15/AeroDyn15_blade.dat");
    assert_eq!(
        (blade.format, blade.stations.len(), blade.origin),
        (BladeFormat::AeroDyn15, 50, SpanOrigin::Root)
    );
    let (first, second) = (&blade.stations[0], &blade.stations[1]);
    near(first.twist.to_degrees(), -1.559455301971172e1);
    near(second.sweep, -5.005748522338992e-2);
    near(second.prebend, 3.236481948738088e-2);
    near(second.span, 2.387753704536792);
    near(second.chord, 5.208839941579524);
    assert_eq!(first.airfoil, StationAirfoil::Index(0));
    assert_eq!(blade.stations[49].airfoil, StationAirfoil::Index(49));
    // The blade is prebent upwind: BlCrvAC is positive downwind.
    assert!(blade.stations[49].prebend < -1.0);
}

#[test]
fn a_hawc2_layout_has_thickness_in_per_cent() {
    let blade = file("aero/iea15/hawc2_ae.dat");
    assert_eq!(
        (blade.format, blade.stations.len()),
        (BladeFormat::Hawc2Ae, 30)
    );
    near(blade.stations[1].thickness.unwrap(), 0.9834162404424322);
    near(blade.stations[29].span, 117.1835883386072);
    near(blade.stations[29].chord, 0.5);
    assert_eq!(blade.stations[29].airfoil, StationAirfoil::ByThickness(1));
    assert_eq!(blade.stations[0].reference_point, 0.5);
}

#[test]
fn apc_propellers_are_in_inches() {
    let blade = file("aero/propellers/10x7SF-PERF.PE0");
    assert_eq!(
        (blade.name.as_str(), blade.stations.len(), blade.blades),
        ("10x7SF", 43, Some(2))
    );
    near(blade.tip_radius.unwrap(), 5.0 * 0.0254);
    near(blade.hub_radius.unwrap(), 0.83 * 0.0254);
    let first = &blade.stations[0];
    near(first.span, 0.8398 * 0.0254);
    near(first.chord, 0.65 * 0.0254);
    near(first.twist.to_degrees(), 36.7926);
    near(first.thickness.unwrap(), 0.0663);
    near(first.sweep, 0.4574 * 0.0254);
    assert_eq!(
        first.airfoil,
        StationAirfoil::Blend(vec![("E63".to_owned(), 1.0)])
    );
    assert_eq!(
        blade.stations[42].airfoil,
        StationAirfoil::Blend(vec![("APC12".to_owned(), 1.0)])
    );
    let StationAirfoil::Blend(parts) = &blade.stations[40].airfoil else {
        panic!("a blend")
    };
    // Station 4.9267 in, transition from 4.90 to 5.00 in.
    assert!((parts[1].1 - 0.267).abs() < 1e-9, "{parts:?}");
    let small = file("aero/propellers/42x4-PERF.PE0");
    near(small.tip_radius.unwrap(), 2.09 * 0.0254);
    assert_eq!(small.blades, Some(2));
}

#[test]
fn propellers_of_uiuc_have_the_radius_of_their_name() {
    let blade = file("aero/propellers/apcsf_10x7_geom.txt");
    assert_eq!(
        (blade.stations.len(), blade.origin),
        (18, SpanOrigin::RotationAxis)
    );
    near(blade.tip_radius.unwrap(), 0.127);
    near(blade.stations[17].span, 0.127);
    near(blade.stations[1].chord, 0.132 * 0.127);
    near(blade.stations[1].twist.to_degrees(), 37.6);
    assert!(blade.remarks[0].contains("10 in"));
    let text = text("aero/propellers/apcsf_10x7_geom.txt");
    assert!(problems(&text, "geometry.txt").contains("the radius of the propeller is missing"));
    let options = BladeOptions {
        radius: Some(1.0),
        ..BladeOptions::default()
    };
    let scaled = parse_blade(&text, Path::new("geometry.txt"), &options).unwrap();
    near(scaled.stations[1].chord, 0.132);
    near(
        file("aero/propellers/apcff_4.2x4_geom.txt")
            .tip_radius
            .unwrap(),
        2.1 * 0.0254,
    );
}

#[test]
fn a_qprop_propeller_has_its_polar() {
    let blade = file("aero/propellers/cam6x3.def");
    assert_eq!(
        (blade.format, blade.blades, blade.stations.len()),
        (BladeFormat::Qprop, Some(2), 7)
    );
    assert_eq!(blade.name, "Graupner CAM 6x3 folder");
    near(blade.stations[0].span, 0.75 * 0.0254);
    near(blade.stations[0].chord, 0.66 * 0.0254);
    near(blade.stations[0].twist.to_degrees(), 27.5);
    near(blade.tip_radius.unwrap(), 3.0 * 0.0254);
    assert!(
        blade.remarks[0].contains("is not used"),
        "{:?}",
        blade.remarks
    );
    let polar = blade.polar.unwrap();
    assert_eq!(
        (polar.lift_zero, polar.lift_slope, polar.lift_limits),
        (0.5, 5.8, [-0.3, 1.2])
    );
    assert_eq!(
        (polar.drag_zero, polar.drag_quadratic, polar.lift_drag_zero),
        (0.028, [0.05, 0.02], 0.5)
    );
    assert_eq!((polar.reynolds, polar.exponent), (70000.0, -0.7));
}

const VERSION_1: &str = "name: turbine\nassembly: {number_of_blades: 3, rotor_diameter: 100}\ncomponents:\n  hub:\n    outer_shape_bem: {diameter: 4.0, cone_angle: 0.05}\n  nacelle: {drivetrain: {uptilt: 0.1}}\n  blade:\n    outer_shape_bem:\n      airfoil_position: {grid: [0, 0.5, 1], labels: [a, b, b]}\n      chord: {grid: [0, 0.25, 1], values: [3, 4, 1]}\n      twist: {grid: [0, 1], values: [0.2, 0]}\n      pitch_axis: {grid: [0, 1], values: [0.5, 0.3]}\n      reference_axis:\n        x: {grid: [0, 1], values: [0, -4]}\n        y: {grid: [0, 1], values: [0, 1]}\n        z: {grid: [0, 1], values: [0, 48]}\n";

const VERSION_2: &str = "windIO_version: '2.0'\nname: turbine\nassembly: {number_of_blades: 3, rotor_orientation: Downwind}\nairfoils:\n  - name: a\n    rthick: 0.4\n    aerodynamic_center: 0.25\n    polars:\n      - configuration: clean\n        re_sets: [{re: 1e6, cl: {grid: [-180, 180], values: [0, 0]}, cd: {grid: [-180, 180], values: [0.1, 0.1]}, cm: {grid: [-180, 180], values: [0, 0]}}]\n      - configuration: rough\n        re_sets: [{re: 1e6, cl: {grid: [-180, 180], values: [0, 0]}, cd: {grid: [-180, 180], values: [0.2, 0.2]}, cm: {grid: [-180, 180], values: [0, 0]}}]\ncomponents:\n  hub: {outer_shape: {diameter: 4.0, cone_angle: 2.5}}\n  blade:\n    reference_axis:\n      x: {grid: [0, 1], values: [0, -4]}\n      y: {grid: [0, 1], values: [0, 0]}\n      z: {grid: [0, 1], values: [0, 48]}\n    outer_shape:\n      airfoils:\n        - {name: a, spanwise_position: 0, configuration: [clean], weight: [1]}\n        - {name: a, spanwise_position: 1, configuration: [clean, rough], weight: [0.25, 0.75]}\n      chord: {grid: [0, 0.5, 1], values: [3, 4, 1]}\n      twist: {grid: [0, 1], values: [18, 0]}\n      section_offset_y: {grid: [0, 1], values: [1.5, 0.5]}\n      rthick: {grid: [0, 1], values: [1, 0.2]}\n";

#[test]
fn windio_1_has_labels_along_the_span() {
    let blade = parse_blade(VERSION_1, Path::new("a.yaml"), &BladeOptions::default())
        .unwrap_or_else(|problems| panic!("{problems}"));
    let spans: Vec<_> = blade.stations.iter().map(|station| station.span).collect();
    assert_eq!(spans, [0.0, 12.0, 24.0, 48.0]);
    assert_eq!(
        (blade.blades, blade.hub_radius, blade.tip_radius),
        (Some(3), Some(2.0), Some(50.0))
    );
    assert_eq!((blade.cone, blade.tilt), (Some(0.05), Some(0.1)));
    let degrees = VERSION_1.replace("cone_angle: 0.05", "cone_angle: 2.5");
    let refused = parse_blade(&degrees, Path::new("a.yaml"), &BladeOptions::default());
    let shown = refused.unwrap_err().to_string();
    assert!(
        shown.contains("cone_angle of the hub") && shown.contains("143.2394 deg"),
        "{shown}"
    );
    let second = &blade.stations[1];
    near(second.twist, -0.15);
    near(second.prebend, -1.0);
    near(second.sweep, -0.25);
    near(second.reference_point, 0.45);
    assert_eq!(
        second.airfoil,
        StationAirfoil::Blend(vec![("a".to_owned(), 0.5), ("b".to_owned(), 0.5)])
    );
}

#[test]
fn windio_2_has_weights_of_configurations() {
    let blade = parse_blade(VERSION_2, Path::new("a.yaml"), &BladeOptions::default())
        .unwrap_or_else(|problems| panic!("{problems}"));
    near(blade.cone.unwrap().to_degrees(), -2.5);
    let second = &blade.stations[1];
    near(second.twist.to_degrees(), -9.0);
    near(second.reference_point, 0.25);
    near(second.thickness.unwrap(), 0.6);
    near(second.aerodynamic_center.unwrap(), 0.25);
    assert_eq!(
        second.airfoil,
        StationAirfoil::Blend(vec![
            ("a/clean".to_owned(), 0.625),
            ("a/rough".to_owned(), 0.375)
        ])
    );
    assert_eq!((blade.airfoils.len(), blade.hub_radius), (2, Some(2.0)));
}

#[test]
fn faults_of_blades_are_reported_at_once() {
    let blade = text("aero/iea15/AeroDyn15_blade.dat");
    let cut: Vec<_> = blade.lines().take(20).collect();
    assert!(
        problems(&cut.join("\n"), "a.dat")
            .contains("a.dat:4: NumBlNds: found 14 rows, expected 50")
    );
    let shown = problems(&blade.replace("BlChord", "Chord"), "a.dat");
    assert!(
        shown.contains("a.dat:5: column BlChord is missing"),
        "{shown}"
    );
    let layout = text("aero/iea15/hawc2_ae.dat")
        .replace("1 30 r", "1 31 r")
        .replace("4.128435627827585e+00", "x");
    let shown = problems(&layout, "a.dat");
    assert!(
        shown.contains("length: expected a finite number, found \"x\"")
            && shown.contains("31 rows, found 30"),
        "{shown}"
    );
    let shown = problems(
        &VERSION_1
            .replace("values: [3, 4, 1]", "values: [3, -4]")
            .replace("twist:", "twst:"),
        "a.yaml",
    );
    assert!(
        shown.contains("3 positions and 2 values")
            && shown.contains("\"twist\" of the outer shape is missing"),
        "{shown}"
    );
    assert!(problems("", "a.dat").contains("the file is blank"));
    assert!(problems("hello\n", "a.dat").contains("AeroDyn 15 blade, "));
}

#[test]
fn blades_with_faults_are_read_or_reported() {
    let names = [
        "iea15/AeroDyn15_blade.dat",
        "iea15/hawc2_ae.dat",
        "propellers/10x7SF-PERF.PE0",
        "propellers/apcsf_10x7_geom.txt",
        "propellers/cam6x3.def",
    ];
    let mut texts: Vec<_> = names
        .iter()
        .map(|name| text(&format!("aero/{name}")))
        .collect();
    texts.extend([VERSION_1, VERSION_2].map(str::to_owned));
    let mut random = Random(6);
    for text in &texts {
        let mut refused = 0;
        for _ in 0..400 {
            let text = mutated(text, &mut random);
            match parse_blade(
                &text,
                Path::new("a_10x7_geom.dat"),
                &BladeOptions::default(),
            ) {
                Ok(blade) => assert!(blade.stations.len() > 1),
                Err(problems) => {
                    assert!(
                        !problems.is_empty() && !problems.to_string().contains("no reason"),
                        "{problems}"
                    );
                    refused += 1;
                }
            }
        }
        assert!(refused > 60, "{refused}");
    }
}

/// The file has the twist of turbines, towards feather, under the name `twist`: with the name
/// `feather`, it is nose up after reading, with the opposite sign.
#[test]
fn columns_state_the_sign_of_the_twist() {
    let file = text("aero/nrel5mw/blade.csv");
    let read = |text: &str| {
        let options = BladeOptions::default();
        parse_blade(text, Path::new("blade.csv"), &options)
            .unwrap_or_else(|problems| panic!("{problems}"))
    };
    let blade = read(&file.replace("twist_deg", "feather_deg"));
    assert_eq!(
        (blade.format, blade.origin, blade.stations.len()),
        (BladeFormat::Csv, SpanOrigin::RotationAxis, 17)
    );
    let first = &blade.stations[0];
    assert_eq!((first.span, first.chord), (2.8667, 3.542));
    near(first.twist.to_degrees(), -13.308);
    assert_eq!(
        blade.stations[16].airfoil,
        StationAirfoil::Blend(vec![("NACA64_A17".to_owned(), 1.0)])
    );
    near(read(&file).stations[0].twist.to_degrees(), 13.308);
    let from_root = read("span [mm];chord [m];twist [rad];axis [-]\n0;1;0.1;0.3\n2000;1;0;0.3\n");
    assert_eq!(from_root.origin, SpanOrigin::Root);
    assert_eq!(
        (
            from_root.stations[1].span,
            from_root.stations[0].reference_point
        ),
        (2.0, 0.3)
    );
}

#[test]
fn faults_of_columns_are_reported_at_once() {
    let shown = problems("span,chord [kg],colour\n0,1,2\n1,x,2\n2,1\n", "a.csv");
    for expected in [
        "a.csv:1: the header: found none, expected one of the columns \"twist\" and \"feather\"",
        "a.csv:1: unit of column \"chord\": found \"kg\", expected m",
        "a.csv:3: ",
        "a.csv:4: row of the blade: found 2 cells, expected 3, as in the header",
    ] {
        assert!(shown.contains(expected), "{expected:?} in\n{shown}");
    }
}
