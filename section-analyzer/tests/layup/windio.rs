//! Turbine files of windIO: public blades, places in closed form, messages, damaged texts.

use std::f64::consts::{PI, TAU};
use std::path::{Path, PathBuf};

use section_analyzer::input::layup::{self, Layup, Materials};
use section_analyzer::mesh::generate::layup::{LayupSection, Outline};
use section_analyzer::output::layup_file;

use crate::random::Random;
use crate::sections::{cases, close};

/// The path of a public blade.
pub fn path(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/reference/layups");
    folder.join(format!("{name}.yaml"))
}

/// A public blade; the laws of IEA-10 and IEA-3.4 are repaired.
pub fn blade(name: &str) -> Layup {
    layup::read_with(&path(name), Materials::Repaired)
        .unwrap_or_else(|problems| panic!("{problems}"))
}

/// The tube and its text.
pub fn tube() -> (PathBuf, String) {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/layup/files/tube.windio.yaml");
    let text = std::fs::read_to_string(&file).expect("a file");
    (file, text)
}

/// The tube with changes, in a folder of its own.
fn changed(changes: &[(&str, &str)]) -> Result<Layup, String> {
    let (_, mut text) = tube();
    for (from, to) in changes {
        assert!(text.contains(from), "{from}");
        text = text.replacen(from, to, 1);
    }
    read(&text)
}

/// The blade of a text, or its problems.
pub fn read(text: &str) -> Result<Layup, String> {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("a.yaml");
    std::fs::write(&file, text).expect("a file");
    let found = layup::read(&file);
    found.map_err(|problems| {
        let name = format!("{}/", folder.path().display());
        problems.to_string().replace(&name, "")
    })
}

fn at(layup: &Layup, eta: f64) -> LayupSection {
    layup
        .section(eta)
        .unwrap_or_else(|problems| panic!("{problems}"))
}

/// Points of a contour lie on another one, within 0.3 % of its chord.
fn check_contour(found: &[[f64; 2]], expected: &[[f64; 2]], name: &str) {
    let outline = Outline::new(found).expect("a contour");
    let ends = |pick: fn(f64, f64) -> f64| expected.iter().map(|p| p[0]).reduce(pick);
    let chord = ends(f64::max).expect("points") - ends(f64::min).expect("points");
    let distance = |p: &[f64; 2]| {
        let s = (0..2000).map(|i| outline.perimeter() * f64::from(i) / 2000.0);
        let off = s.map(|s| {
            let q = outline.position(s);
            (q[0] - p[0]).hypot(q[1] - p[1])
        });
        off.fold(f64::INFINITY, f64::min)
    };
    let farthest = expected.iter().map(distance).fold(0.0, f64::max);
    println!("{}: contour {:.5}", name, farthest / chord);
    assert!(farthest < 3e-3 * chord, "{}: {}", name, farthest / chord);
}

/// Ten sections of the four public blades, resolved by an independent program from the files of
/// version 1: arcs within 1e-3, thicknesses within 0.1 %, contours within 0.3 % of the chord
/// (the numbers of the reference have 7 digits; its airfoils are splines over other points).
#[test]
fn public_blades_have_the_resolved_sections() {
    for case in cases() {
        let (name, eta) = case.name.split_once(" at ").expect("a name");
        let file = match name {
            "iea15" => "windio1_iea15",
            "iea22" => "windio2_iea22",
            "iea10" => "windio2_iea10",
            _ => "windio2_iea34",
        };
        let found = at(&blade(file), eta.parse().expect("a number"));
        let expected = &case.section;
        check_contour(&found.contour, &expected.contour, &case.name);
        for layer in &expected.layers {
            let mut all = found.layers.iter();
            let one = all.find(|one| one.name.eq_ignore_ascii_case(&layer.name));
            let one = one.unwrap_or_else(|| panic!("{}: {}", case.name, layer.name));
            let pairs = [(one.from, layer.from), (one.to, layer.to)];
            for (found, expected) in pairs {
                assert!(
                    (found - expected).abs() < 1e-3,
                    "{} {}: {found} {expected}",
                    case.name,
                    layer.name
                );
            }
            close(one.thickness, layer.thickness, 1e-3, &layer.name);
        }
        assert_eq!(
            found
                .webs
                .iter()
                .filter(|web| !web.plies.is_empty())
                .count(),
            expected.webs.len(),
            "{}",
            case.name
        );
        for web in &expected.webs {
            let one = found
                .webs
                .iter()
                .find(|one| one.name == web.name)
                .expect("the web");
            for (found, expected) in one.arcs.iter().zip(web.arcs) {
                assert!(
                    (found - expected).abs() < 1e-3,
                    "{} {}: {found} {expected}",
                    case.name,
                    web.name
                );
            }
        }
    }
}

/// The blade of both versions is one, but for layers at the edges, which the converter between
/// the versions measured on another contour.
#[test]
fn both_versions_are_one_blade() {
    let [one, two] = ["windio1_iea15", "windio2_iea15"].map(blade);
    for eta in [0.0, 0.12, 0.3, 0.55, 0.8, 1.0] {
        let [one, two] = [at(&one, eta), at(&two, eta)];
        for (a, b) in one.contour.iter().zip(&two.contour) {
            assert!((a[0] - b[0]).hypot(a[1] - b[1]) < 1e-5);
        }
        assert_eq!(one.webs.len(), two.webs.len());
        for layer in one
            .layers
            .iter()
            .filter(|layer| !layer.name.starts_with("TE_"))
        {
            let same = two
                .layers
                .iter()
                .find(|other| other.name == layer.name)
                .expect("a layer");
            close(layer.thickness, same.thickness, 1e-6, &layer.name);
            assert!(
                (layer.from - same.from).abs() < 1e-6 && (layer.to - same.to).abs() < 1e-6,
                "{eta}: {layer:?} {same:?}"
            );
        }
    }
}

/// Written as a layup file and read again, a blade has the same sections to the last digit.
#[test]
fn written_blades_are_read_again() {
    let (tube, _) = tube();
    let tube = layup::read(&tube).unwrap_or_else(|problems| panic!("{problems}"));
    let mut all = vec![tube];
    let public = [
        "windio2_iea22",
        "windio1_iea15",
        "windio2_iea10",
        "windio2_iea34",
    ];
    all.extend(public.map(blade));
    for layup in all {
        let text = layup_file(&layup, "a.yaml");
        let again = layup::parse(&text, Path::new("a.layup.toml"));
        let again = again.unwrap_or_else(|problems| panic!("{problems}"));
        let rows = |text: &str| -> Vec<String> {
            let rows = text.lines().filter(|row| !row.is_empty());
            rows.map(str::to_owned).collect()
        };
        assert_eq!(rows(&layup.constants), rows(&again.constants));
        assert!(layup.line.is_some());
        assert_eq!(layup.line, again.line);
        for i in 0..=20 {
            let eta = f64::from(i) / 20.0;
            assert_eq!(layup.section(eta).ok(), again.section(eta).ok(), "{eta}");
        }
        assert_eq!(
            layup_file(&again, "a.yaml").lines().count() + layup.remarks.len(),
            text.lines().count()
        );
    }
}

/// Lines of arcs, units, forms of places and stations are written too.
#[test]
fn written_layup_files_are_read_again() {
    let line = "stations = [0, 0.5]\n[line]\ntwist = 0.1\narc = [{ length = 9, curvature = [0.01, 0, 0.02] }]\n";
    for name in ["wind_blade", "rotor_blade"] {
        let file = format!("tests/layup/files/{name}.layup.toml");
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
        let text = std::fs::read_to_string(&file).expect("a file");
        let (stations, arcs) = line.split_once('\n').expect("two parts");
        let text = format!("{stations}\n{text}\n{arcs}");
        let layup = layup::parse(&text, &file).unwrap_or_else(|problems| panic!("{problems}"));
        let written = layup_file(&layup, name);
        let again = layup::parse(&written, Path::new("a.layup.toml"));
        let again = again.unwrap_or_else(|problems| panic!("{problems}\n{written}"));
        assert_eq!(layup.stations, again.stations);
        assert_eq!(layup.line.as_ref().map(|line| line.points.len()), Some(2));
        let [one, two] = [&layup, &again].map(|layup| layup.line.clone().expect("a line").length());
        close(one, two, 1e-14, "length");
        for eta in [0.1, 0.4, 0.8] {
            let [one, two] = [at(&layup, eta), at(&again, eta)];
            assert_eq!(one.layers.len(), two.layers.len());
            for (a, b) in one.layers.iter().zip(&two.layers) {
                // lengths are divided by the unit and multiplied again
                close(a.thickness, b.thickness, 1e-14, &a.name);
                assert!(
                    (a.from - b.from).abs() + (a.to - b.to).abs() < 1e-9,
                    "{a:?} {b:?}"
                );
            }
        }
    }
}

/// On a circle of radius R, a plane at the distance d behind the axis, turned by T - R, meets the
/// sides at the angles acos(d/R) -+ (T - R) from the trailing edge, and a width w is the arc
/// w / (2 pi R). The axis is swept linearly, so that a plane through two of its points is parallel
/// to it: the distance along y is d sqrt(1 + slope^2).
#[test]
fn places_on_a_circle_are_exact() {
    let (file, _) = tube();
    let layup = layup::read(&file).unwrap_or_else(|problems| panic!("{problems}"));
    let section = at(&layup, 0.5);
    let turn = (10.0_f64 - 4.0) * PI / 180.0;
    // the slope of the axis turned by 4 degrees
    let slope = 2.0 * (4.0 * PI / 180.0).cos() / 40.0;
    let foot = (-0.25 * slope.hypot(1.0)).acos();
    let [suction, pressure] = [(foot - turn) / TAU, 1.0 - (foot + turn) / TAU];
    let web = &section.webs[0];
    close(web.arcs[0], suction, 1e-6, "suction");
    close(web.arcs[1], pressure, 1e-6, "pressure");
    let middle = (0.1_f64.acos() - 10.0 * PI / 180.0) / TAU;
    let arcs = |name: &str| {
        let layer = section
            .layers
            .iter()
            .find(|layer| layer.name == name)
            .expect("a layer");
        [layer.from, layer.to, layer.thickness]
    };
    let [from, to, thickness] = arcs("cap");
    close(from, middle - 0.2 / TAU, 1e-6, "cap");
    close(to, middle + 0.2 / TAU, 1e-6, "cap");
    // 10 to 5 plies of 1 mm between 0.1 and 0.8
    close(thickness, 1e-3 * (10.0 - 5.0 * 0.4 / 0.7), 1e-9, "plies");
    let [from, to, _] = arcs("rear");
    assert_eq!(from, 0.0);
    close(to, 0.4 / TAU, 1e-6, "rear");
    let [from, to, _] = arcs("low");
    close(from, 0.61, 1e-9, "low");
    close(to, 0.76, 1e-9, "low");
    let [from, to, _] = arcs("main_bond_1");
    close(from, pressure - 0.1 / TAU, 1e-6, "bond");
    close(to, 0.9, 1e-9, "bond");
    close(
        layup.layers[0].fiber_angle.at(0.0),
        PI / 6.0,
        1e-12,
        "angle",
    );
    // outside of the tables of its plane the web is absent, beyond its thickness a layer
    assert!(at(&layup, 0.05).webs.is_empty() && at(&layup, 0.95).webs.is_empty());
    assert!(
        at(&layup, 0.85)
            .layers
            .iter()
            .all(|layer| layer.name != "cap")
    );
    assert!(
        layup.remarks.iter().any(|remark| remark.contains("rear")),
        "{:?}",
        layup.remarks
    );
}

/// Text of the tube, a wrong one, and a part of the message.
const MISTAKES: [(&str, &str, &str); 13] = [
    (
        "material: foam",
        "material: faom",
        "a.yaml:76: material of low: found \"faom\", expected a material of the file\n  help: did you mean \"foam\"?",
    ),
    (
        "anchor: {name: cap,",
        "anchor: {name: cp,",
        "expected the name of an anchor\n  help: did you mean \"cap\"?",
    ),
    (
        "name: circle, spanwise_position: 0}",
        "name: circel, spanwise_position: 0}",
        "a.yaml:16: airfoil of the blade: found \"circel\"",
    ),
    (
        "values: [10, 5]",
        "values: [10]",
        "a.yaml:69: n_plies of layer \"cap\": found 1 values, expected 2",
    ),
    (
        "grid: [0.1, 0.8]",
        "grid: [0.8, 0.1]",
        "found 0.1 after 0.8, expected increasing positions",
    ),
    (
        "web: main",
        "web: mian",
        "found \"mian\", expected the name of a web\n  help: did you mean \"main\"?",
    ),
    (
        "values: [0.6, 0.62]",
        "values: [0.6, 1.62]",
        "found 1.62 at 1, expected arcs from 0 to 1",
    ),
    (
        "nu: [0.28, 0.28, 0.4]",
        "nu: [0.9, 0.9, 0.9]",
        "--repair-materials",
    ),
    ("nu: 0.35", "nu: 0.5", "\"glue\""),
    ("ply_t: 0.001", "x: 0.001", "which has no ply_t"),
    (
        "name: web_skin",
        "name: rear",
        "\"rear\" is the name of another layer",
    ),
    (
        "{name: TE, handle: start_nd_arc}}\n          end_nd_arc: {grid: *ends, values: [1, 1]}",
        "{name: rear, handle: start_nd_arc}}\n          end_nd_arc: {grid: *ends, values: [1, 1]}",
        "rear.start_nd_arc -> rear.start_nd_arc",
    ),
    (
        "components:",
        "component:",
        "key \"components\" of the file is missing",
    ),
];

/// Wrong files are refused with line, name, value and remedy.
#[test]
fn mistakes_are_reported_with_their_lines() {
    for (from, to, expected) in MISTAKES {
        let problem = changed(&[(from, to)]).err();
        let problem = problem.unwrap_or_else(|| panic!("{to} is read"));
        assert!(problem.contains(expected), "{to}: {problem}");
    }
    // all at once
    let both = changed(&[
        ("web: main", "web: mian"),
        ("material: foam", "material: faom"),
    ]);
    let both = both.expect_err("two mistakes");
    assert!(both.contains("mian") && both.contains("faom"), "{both}");
    let layup = changed(&[("structure:", "structure:\n      adhesive: 1")]).expect("a blade");
    assert!(
        layup
            .remarks
            .iter()
            .any(|remark| remark.contains("not meshed: adhesive"))
    );
}

/// Texts cut at any byte, and with changed bytes: read or refused with a message.
#[test]
fn damaged_files_are_read_or_refused() {
    let (_, text) = tube();
    let (mut good, mut bad) = (0, 0);
    let mut look = |text: &str| match read(text) {
        Ok(layup) => {
            let _ = layup.section(0.4);
            good += 1;
        }
        Err(problems) => {
            assert!(!problems.is_empty());
            bad += 1;
        }
    };
    let mut random = Random::new(12);
    for end in (0..text.len()).step_by(29) {
        look(&text[..end]);
    }
    for _ in 0..400 {
        let mut bytes = text.clone().into_bytes();
        let at = (random.unit() * bytes.len() as f64) as usize;
        bytes[at] = b"\"[]{}=,.#-0 9az\n:&*"[(random.unit() * 19.0) as usize];
        look(&String::from_utf8_lossy(&bytes));
    }
    println!("{good} read, {bad} refused");
    assert!(good > 10 && bad > 100);
}

/// Slopes of S-N lines belong to the strengths; without strengths, and intercepts, are remarks.
#[test]
fn slopes_of_fatigue_are_read() {
    let layup = changed(&[
        (
            "ply_t: 0.001",
            "ply_t: 0.001\n    m: [10, 8, 8]\n    A: 4.0e+8",
        ),
        ("    nu: 0.35", "    nu: 0.35\n    m: 5"),
        ("    nu: 0.3\n", "    nu: 0.3\n    m: 0\n    A: 0\n"),
    ]);
    let layup = layup.unwrap_or_else(|text| panic!("{text}"));
    assert!(
        layup.constants.contains("m = 10.0\nm_matrix = 8.0\n"),
        "{}",
        layup.constants
    );
    let told = |text: &str| {
        layup
            .remarks
            .iter()
            .filter(|one| one.contains(text))
            .count()
    };
    assert_eq!(told("material \"glass\": A is not used"), 1);
    assert_eq!(
        told("material \"glue\": m is not used without one of Xt"),
        1
    );
    assert_eq!(told("\"foam\""), 0);
}

/// Strengths that are absent or zero never govern, and are remarked; without any there is no table. The
/// zeros of the carbon are the ones of the public file of the IEA 15 MW turbine.
#[test]
fn strengths_of_some_directions_are_taken() {
    let layup = changed(&[
        ("Xt: [9.0e+8, 5.0e+7, 5.0e+7]", "Xt: [1.546e9, 0, 0]"),
        ("Xc: [6.0e+8, 1.2e+8, 1.2e+8]", "Xc: [1.047e9, 0, 0]"),
        ("S: [6.0e+7, 6.0e+7, 5.0e+7]", "S: [0, 0, 0]"),
        ("    nu: 0.35", "    nu: 0.35\n    Xt: 7.4e7\n    Xc: 8.7e7"),
        (
            "    nu: 0.3\n",
            "    nu: 0.3\n    Xt: 0\n    Xc: 0\n    S: 0\n",
        ),
    ]);
    let layup = layup.unwrap_or_else(|text| panic!("{text}"));
    for table in [
        "[material.\"glass\".strength]\nxt = 1546000000.0\nxc = 1047000000.0\nyt = 1e30\nyc = 1e30\n\
         s12 = 1e30\n",
        "[material.\"glue\".strength]\ntension = 74000000.0\ncompression = 87000000.0\nshear = 1e30\n",
    ] {
        assert!(layup.constants.contains(table), "{}", layup.constants);
    }
    assert!(!layup.constants.contains("[material.\"foam\".strength]"));
    let has = |text: &str| layup.remarks.iter().any(|one| one.contains(text));
    let end = "in Xt, Xc and S: such failure is not assessed";
    assert!(has(&format!(
        "material \"glass\": no strength \"yt\", \"yc\", \"s12\" {end}"
    )));
    assert!(has(&format!(
        "material \"glue\": no strength \"shear\" {end}"
    )));
    assert!(!has("\"foam\""), "{:?}", layup.remarks);
}
