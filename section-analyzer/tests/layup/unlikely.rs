//! Shapes, widths and materials that are likely wrong: remarks, and errors that name the likely cause.

use std::path::Path;

use section_analyzer::input::layup::{self, Layup};

use crate::windio::{blade, read, tube};

/// Changes of the tube of windIO 2, and the remark on each, which the tube itself does not have.
const REMARKS: [(&str, &str, &str); 6] = [
    (
        "z: {grid: &ends [0, 1], values: [0, 40]}",
        "z: {grid: &ends [0, 1], values: [0, 40000]}",
        "line 11: the blade is 40000 m long, 20000 times its largest chord, 2 m: check the units of both",
    ),
    (
        "chord: {grid: *ends,",
        "chord: {grid: [0, 0.98],",
        "line 11: chord ends at 0.98: its last value is taken up to the tip",
    ),
    (
        "twist: {grid: *ends,",
        "twist: {grid: [0.1, 1],",
        "line 12: twist begins at 0.1: its first value is taken from the root on",
    ),
    (
        "      rthick: {grid: *ends, values: [1, 1]}\n      airfoils:\n        - {name: circle, spanwise_position: 0}\n        - {name: circle, spanwise_position: 1}",
        "      airfoils:\n        - {name: circle, spanwise_position: 0}\n        - {name: circle, spanwise_position: 0.9}",
        "airfoils ends at 0.9: its last value is taken up to the tip",
    ),
    (
        "thickness: {grid: *ends, values: [0.01, 0.01]}",
        "thickness: {grid: *ends, values: [0.01, 0.01]}\n          n_plies: {grid: *ends, values: [3, 3]}",
        "n_plies has no effect beside thickness where the material has no ply_t: \"low\"",
    ),
    (
        "    E: 4.0e+9\n",
        "    E: 4.0e+6\n    G: 1.48e+9\n",
        // 4e6/2.7
        "material \"glue\": G is 1.48e9 Pa, and E/(2 (1 + nu)) is 1.481e6 Pa: E and nu are used",
    ),
];

#[test]
fn windio_values_that_are_likely_wrong_are_remarks() {
    let (_, tube) = tube();
    let plain = read(&tube).expect("a blade").remarks;
    for (from, to, expected) in REMARKS {
        assert!(tube.contains(from), "{from}");
        let has = |remarks: &[String]| remarks.iter().any(|one| one.contains(expected));
        assert!(!has(&plain), "{plain:?}");
        let found = read(&tube.replacen(from, to, 1)).expect(to).remarks;
        assert!(has(&found), "{to}: {found:?}");
    }
    // the modulus of E and nu to the digits of a file
    let glue = "    E: 4.0e+9\n";
    let right = tube.replacen(glue, &format!("{glue}    G: 1.48e+9\n"), 1);
    assert_eq!(read(&right).expect("a blade").remarks, plain);
}

#[test]
fn errors_of_windio_name_the_likely_cause() {
    let (_, tube) = tube();
    let message = |from: &str, to: &str| {
        assert!(tube.contains(from), "{from}");
        let read = read(&tube.replacen(from, to, 1));
        let section = read.and_then(|layup| layup.section(0.5).map_err(|all| all.to_string()));
        section.map(|_| ()).expect_err(to)
    };
    let cases = [
        (
            "y: {grid: [0, 1], values: [0, 2]}\n      z: {grid: &ends [0, 1], values: [0, 40]}",
            "y: {grid: &ends [0, 1], values: [0, 2]}\n      z: {grid: [0, 0.5, 1], values: [0, 42, 40]}",
            "a.yaml:7: reference_axis: found z = 40 at 1 after 42 at 0.5, expected z that grows from root to tip",
        ),
        ("      webs:\n", "      walls:\n", "help: the file has none"),
        (
            // 400 m at half of the span, of which a half is on each side of the middle; the tube has 2 pi m
            "grid: *ends, values: [0.5, 0.3]}",
            "grid: *ends, values: [500, 300]}",
            "of layer \"cap\" is not on the contour at eta 0.5: it is shifted by -200 m, and the contour is 6.28",
        ),
    ];
    for (from, to, expected) in cases {
        let found = message(from, to);
        assert!(found.contains(expected), "{expected}\n{found}");
    }
}

/// Layup file with a shape and layers.
fn text(shape: &str, layers: &str) -> String {
    format!(
        "units = \"SI\"\n[shape]\nchord = 1\n{shape}\n[[layer]]\nname = \"skin\"\nmaterial = \"glass\"\n\
         thickness = 0.002\n{layers}[material.glass]\nyoung = 40e9\npoisson = 0.3\ndensity = 1900\n\
         ply_thickness = 0.001\n"
    )
}

fn parsed(text: &str) -> Result<Layup, String> {
    let read = layup::parse(text, Path::new("a.layup.toml"));
    read.map_err(|problems| problems.to_string())
}

/// An ellipse, a fifth as thick as long: `count` points of each side from the trailing edge on.
fn sides(count: usize) -> [Vec<[f64; 2]>; 2] {
    [1.0, -1.0].map(|sign| {
        let point = |i: usize| {
            let angle = std::f64::consts::PI * i as f64 / (count - 1) as f64;
            // both sides have the same ends
            let height = (0.1e12 * angle.sin()).round() / 1e12;
            [0.5 + 0.5 * angle.cos(), sign * height]
        };
        (0..count).map(point).collect()
    })
}

/// The points from the trailing edge over the upper side to the nose and back.
fn around() -> Vec<[f64; 2]> {
    let [upper, lower] = sides(41);
    upper
        .into_iter()
        .chain(lower.into_iter().rev().skip(1))
        .collect()
}

#[test]
fn a_wrong_point_of_an_airfoil_is_a_remark() {
    let mut points = around();
    let of = |points: &[[f64; 2]]| {
        let text = text(&format!("points = {points:?}"), "");
        parsed(&text).expect("a layup").remarks
    };
    assert!(of(&points).is_empty(), "{:?}", of(&points));
    // at the largest thickness, where the contour is level, 3 % of the chord and the height of an arc of
    // 4.5 deg of the ellipse, 0.1 (1 - cos 4.5 deg) = 0.0003
    points[20][1] += 0.03;
    let found = of(&points);
    assert_eq!(found.len(), 1, "{found:?}");
    let expected = "of the airfoil is 0.0303083 of the chord off the line between its neighbors";
    assert!(
        found[0].starts_with("line 2: the point (0.5, 0.13)"),
        "{found:?}"
    );
    assert!(found[0].contains(expected), "{found:?}");
}

/// No airfoil of a public blade has a wrong point, and none of its proportions is odd.
#[test]
fn public_blades_have_likely_shapes() {
    for name in [
        "windio2_iea15",
        "windio1_iea15",
        "windio2_iea22",
        "windio2_bar_usc",
    ] {
        let remarks = blade(name).remarks;
        for part in [
            "check its numbers",
            "check the units",
            " ends at ",
            " begins at ",
            "ply_t",
        ] {
            let odd = remarks.iter().find(|remark| remark.contains(part));
            assert_eq!(odd, None, "{name}");
        }
        // G of a foam of BAR-USC is a thousand times too large
        let moduli = remarks
            .iter()
            .filter(|remark| remark.contains("E/(2 (1 + nu))"));
        let is_wrong = name == "windio2_bar_usc";
        assert_eq!(moduli.count(), usize::from(is_wrong), "{name}");
    }
}

/// Both sides from the nose on, in the file and in a table of coordinates, with and without the numbers of
/// points; and a title of one letter.
#[test]
fn sides_from_the_nose_on_are_named() {
    let from_nose = sides(41).map(|side| side.into_iter().rev().collect::<Vec<_>>());
    let both = from_nose.concat();
    let expected = "the points begin at the nose, and begin there again in row 42";
    let found = parsed(&text(&format!("points = {both:?}"), "")).expect_err("an error");
    assert!(found.contains(expected), "{found}");
    assert!(
        found.contains("help: reverse the rows of the upper side"),
        "{found}"
    );

    let rows = |points: &[[f64; 2]]| -> String {
        points.iter().map(|[x, z]| format!("{x} {z}\n")).collect()
    };
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("a.layup.toml");
    std::fs::write(&file, text("file = \"a.dat\"", "")).expect("a file");
    let with = |content: String| {
        std::fs::write(folder.path().join("a.dat"), content).expect("a file");
        layup::read(&file).map_err(|problems| problems.to_string())
    };
    let found = with(format!("X\n{}", rows(&both))).expect_err("an error");
    assert!(found.contains(expected), "{found}");
    let read = with(format!("X\n41. 41.\n{}", rows(&both))).expect("a layup");
    let right = parsed(&text(&format!("points = {:?}", around()), "")).expect("a layup");
    let close = |(a, b): (&[f64; 2], &[f64; 2])| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-12;
    let [found, right] = [read, right].map(|layup| layup.shape.contour(0.0));
    assert!(found.len() == right.len() && found.iter().zip(&right).all(close));
}

/// A rectangle by its corners, and by points of its sides with corners twice, as the message states.
#[test]
fn a_rectangle_of_few_points_needs_more() {
    let corners = [
        [1.0, 0.0],
        [1.0, 0.2],
        [0.0, 0.2],
        [0.0, -0.2],
        [1.0, -0.2],
        [1.0, 0.0],
    ];
    let section = |points: &[[f64; 2]]| {
        let layup = parsed(&text(&format!("points = {points:?}"), "")).expect("a layup");
        layup.mesh(0.5).map_err(|problems| problems.to_string())
    };
    let found = section(&corners).map(|_| ()).expect_err("an error");
    let expected = "has 6 points, expected 9 or more: straight sides have points too, and a point given twice \
                    is a corner";
    assert!(found.contains(expected), "{found}");
    let mut points: Vec<[f64; 2]> = Vec::new();
    for pair in corners.windows(2) {
        let part =
            |i: usize| [0, 1].map(|k| pair[0][k] + (pair[1][k] - pair[0][k]) * i as f64 / 4.0);
        points.extend((0..=4).map(part));
    }
    let area = section(&points).expect("a mesh").areas[0].meshed;
    // walls of 2 mm around 1 m x 0.4 m
    let exact = 1.0 * 0.4 - 0.996 * 0.396;
    assert!((area / exact - 1.0).abs() < 1e-9, "{area} {exact}");
}

/// Of plies that do not fit, the layer with the largest sum of its plies is named, not the thickest ply.
#[test]
fn the_layer_with_the_thickest_plies_is_named() {
    let plies = vec!["0"; 60].join(", ");
    let layers = format!(
        "[[layer]]\nname = \"spar\"\nmaterial = \"glass\"\nplies = [{plies}]\naround = \"nose\"\n\
         web = \"rear\"\n[[web]]\nname = \"rear\"\nat = {{ x = 0.35 }}\nplies = []\n"
    );
    let layup = parsed(&text("naca = \"0012\"", &layers)).expect("a layup");
    let found = layup.mesh(0.5).map(|_| ());
    let found = found.expect_err("an error").to_string();
    // 60 plies of 1 mm, beside a skin of 2 mm
    let expected = "the thickest one there is \"spar\" with 0.06";
    assert!(found.contains(expected), "{found}");
}
