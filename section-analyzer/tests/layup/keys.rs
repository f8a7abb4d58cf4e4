//! Keys of layup files that give the same layup in other words.

use std::path::Path;

use section_analyzer::input::layup::{self, Layup};
use section_analyzer::mesh::generate::layup::LayupSection;
use section_analyzer::output::layup_file;

const TEXT: &str = "\
units = \"SI\"
[line]
length = 50
[shape]
chord = { span = [0, 25, 50], value = [2, 2, 1], course = \"linear\" }
origin = 0.25
naca = \"0018\"
[place.cap_rear]
x = 0.45
side = \"suction\"
[[layer]]
name = \"skin\"
material = \"glass\"
plies = [\"45 deg\", \"-45 deg\"]
[[layer]]
name = \"cap\"
material = \"glass\"
count = { eta = [0, 0.5, 1], value = [10, 4, 4], course = \"linear\" }
from = \"cap_rear + 40 mm\"
to = \"cap.start + 0.3 m\"
taper = \"1:20\"
[[layer]]
name = \"patch\"
material = \"glass\"
thickness = { eta = [0.2, 0.4], value = [0.001, 0.001], hold = true }
from = \"web.suction.fore + 20 mm\"
to = \"nose - 0.02\"
[[layer]]
name = \"tape\"
material = \"glass\"
thickness = { file = \"t.csv\", column = \"tape\" }
from = \"base.suction\"
to = \"base.suction + 0.1 m\"
[[web]]
name = \"web\"
at = { x = 0.3 }
plies = [{ name = \"ply\", material = \"glass\", count = 20, round = false }]
[material.glass]
young = 40e9
poisson = 0.3
density = 1900
ply_thickness = \"1 mm\"
";

fn parse(text: &str) -> Result<Layup, String> {
    let folder = tempfile::tempdir().expect("a folder");
    let table = "span [m],tape [mm],strip [mm],bare\n0,1,1,1 mm\n10,2,2 mm,2\n40,3,3,3\n";
    std::fs::write(folder.path().join("t.csv"), table).expect("a table");
    layup::parse(text, &folder.path().join("a.layup.toml")).map_err(|problems| problems.to_string())
}

fn section(text: &str, eta: f64) -> LayupSection {
    let layup = parse(text).unwrap_or_else(|problems| panic!("{problems}"));
    let found = layup.section(eta);
    found.unwrap_or_else(|problems| panic!("{problems}"))
}

/// By hand at eta 0.26: plies of 1 mm, 7 of 6.88 in the cap, whose width and drop are given; the
/// table of the file at 13 m; the web's fore face is 10 mm ahead of x = 0.3 of a chord of 2 m.
#[test]
fn the_words_have_their_values() {
    let found = section(TEXT, 0.26);
    let names: Vec<&str> = found.layers.iter().map(|one| one.name.as_str()).collect();
    assert_eq!(names, ["skin/1", "skin/2", "cap", "patch", "tape"]);
    let thickness: Vec<f64> = found.layers.iter().map(|one| one.thickness).collect();
    for (found, expected) in thickness[..4].iter().zip([0.001, 0.001, 0.007, 0.001]) {
        assert!((found - expected).abs() < 1e-15, "{thickness:?}");
    }
    assert!(
        thickness[4] > 0.002 && thickness[4] < 0.003,
        "{thickness:?}"
    );
    assert!((found.webs[0].plies[0].thickness - 0.02).abs() < 1e-15);
    // the same places in other words
    let [fore, chord] = [0.3 - 0.01 / 2.0, 2.0];
    let other = TEXT
        .replace(
            "from = \"web.suction.fore + 20 mm\"",
            &format!("from = {{ x = {fore:?}, side = \"suction\", shift = \"20 mm\" }}"),
        )
        .replace(
            "from = \"cap_rear + 40 mm\"",
            "from = { x = 0.45, side = \"suction\", shift = 0.04 }",
        )
        .replace(
            "at = { x = 0.3 }",
            "suction = { x = 0.3, side = \"suction\" }\npressure = { x = 0.3, side = \"pressure\" }",
        );
    let other = section(&other, 0.26);
    for (a, b) in found.layers.iter().zip(&other.layers) {
        assert!(
            (a.from - b.from).abs() + (a.to - b.to).abs() < 1e-9,
            "{a:?} {b:?}"
        );
    }
    assert_eq!(found.webs, other.webs);
    let outline = section_analyzer::mesh::generate::layup::Outline::new(&found.contour);
    let perimeter = outline.expect("a contour").perimeter();
    let [cap, patch] = [2, 3].map(|i| &found.layers[i]);
    assert!(((cap.to - cap.from) * perimeter - 0.3).abs() < 1e-9);
    assert!((cap.taper.unwrap() - 0.14).abs() < 1e-12);
    let width = found.contour.iter().map(|point| point[0]);
    let width = width.clone().fold(f64::MIN, f64::max) - width.fold(f64::MAX, f64::min);
    assert!((width - chord).abs() < 1e-3 * chord, "{width}");
    assert!(patch.to < 0.5 && patch.to > 0.46, "{patch:?}");
}

/// 10 - 12 eta plies are 9.5 at 1/24, and 4.5 at 11/24: jumps of six plies. Beyond its table the
/// patch is held.
#[test]
fn rounded_plies_jump_along_the_span() {
    let layup = parse(TEXT).unwrap_or_else(|problems| panic!("{problems}"));
    let jumps = layup.jumps();
    for count in 0..6 {
        let expected = (0.5 + f64::from(count)) / 12.0;
        assert!(
            jumps.iter().any(|eta| (eta - expected).abs() < 1e-9),
            "{expected}: {jumps:?}"
        );
    }
    // and the end of the tape
    assert_eq!(jumps.len(), 7, "{jumps:?}");
    assert!(
        section(TEXT, 0.9)
            .layers
            .iter()
            .any(|one| one.name == "patch")
    );
    let free = TEXT.replace(", hold = true", "");
    assert!(
        !section(&free, 0.9)
            .layers
            .iter()
            .any(|one| one.name == "patch")
    );
}

/// Counts change everywhere between two close positions, and a shift in the name of a place keeps the
/// interpolation of the other one.
#[test]
fn interpolations_hold_between_close_positions() {
    let of_cap = |text: &str, eta: f64| {
        let layers = section(text, eta).layers;
        layers.into_iter().find(|one| one.name == "cap").unwrap()
    };
    let steep = TEXT.replace(
        "{ eta = [0, 0.5, 1], value = [10, 4, 4], course",
        "{ eta = [0, 0.1, 0.1004, 0.5, 0.5001, 0.5002, 1], value = [4, 4, 84, 4, 20, 4, 4], course",
    );
    for (eta, plies) in [(0.1002, 44.0), (0.5001, 20.0), (0.50009, 18.0), (0.6, 4.0)] {
        let found = of_cap(&steep, eta).thickness;
        assert!((found - 1e-3 * plies).abs() < 1e-12, "{eta}: {found}");
    }
    let shifted = |course: &str, eta: f64| {
        let place = format!(
            "from = {{ at = \"cap_rear + 40 mm\", shift = {{ eta = [0, 0.5, 1], \
             value = [0, 0.02, 0.08], course = \"{course}\" }} }}"
        );
        let text = TEXT.replace("from = \"cap_rear + 40 mm\"", &place);
        of_cap(&text, eta).from - of_cap(TEXT, eta).from
    };
    assert!(shifted("constant", 0.3).abs() < 1e-12);
    // 0.05 m of a contour of the chord 1.5 m, 0.02 m of 2 m
    let [outer, inner] = [0.75, 0.5].map(|eta| shifted("linear", eta));
    assert!(
        (outer / inner - 2.5 * 2.0 / 1.5).abs() < 1e-6,
        "{outer} {inner}"
    );
}

/// The file of a layup has the same sections, which can be meshed.
#[test]
fn the_file_of_a_layup_has_its_sections() {
    let layup = parse(TEXT).unwrap_or_else(|problems| panic!("{problems}"));
    let text = layup_file(&layup, "a.layup.toml");
    let again = layup::parse(&text, Path::new("b.layup.toml"));
    let again = again.unwrap_or_else(|problems| panic!("{problems}\n{text}"));
    for eta in [0.1, 0.26, 0.7] {
        let [a, b] = [&layup, &again].map(|layup| layup.section(eta).expect("a section"));
        for (a, b) in a.layers.iter().zip(&b.layers) {
            let difference = (a.thickness - b.thickness).abs() + (a.from - b.from).abs();
            assert!(a.name == b.name && difference + (a.to - b.to).abs() < 1e-12);
        }
        assert_eq!(a.layers.len(), b.layers.len());
    }
    again
        .mesh(0.26)
        .unwrap_or_else(|problems| panic!("{problems}"));
}

/// Words, others in their place, and the problem.
const WRONG: &[(&str, &str, &str)] = &[
    (
        "plies = [\"45 deg\", \"-45 deg\"]",
        "plies = [45]\ncount = 1",
        "layer \"skin\" has 2 of",
    ),
    (
        "plies = [\"45 deg\", \"-45 deg\"]",
        "",
        "layer \"skin\" has 0 of",
    ),
    (
        "plies = [\"45 deg\", \"-45 deg\"]",
        "plies = []",
        "expected one angle or more",
    ),
    (
        "plies = [\"45 deg\", \"-45 deg\"]",
        "plies = [45]\nfiber_angle = 1",
        "has the angles of its plies and \"fiber_angle\"",
    ),
    (
        "ply_thickness = \"1 mm\"\n",
        "",
        "material \"glass\" has no ply thickness",
    ),
    ("+ 40 mm", "+ 40 kg", "a place, as \"cap.end + 40 mm\""),
    (
        "taper = \"1:20\"",
        "profile = [[0, 0], [0.5, 1.5], [1, 0]]",
        "expected rows of a part of the width, ascending from 0 to 1, and a part of the thickness, 0 to 1, \
         not all 0",
    ),
    (
        "taper = \"1:20\"",
        "taper = \"1:20\"\nprofile = [[0, 0], [0.5, 1], [1, 0]]",
        "layer \"cap\" has a \"taper\" beside a \"profile\" that is zero at both ends",
    ),
    (
        "origin = 0.25",
        "origin = 50",
        "expected a part of the chord from -1 to 2",
    ),
    (
        "taper = \"1:20\"",
        "profile = [[0, 1], [0.5, 1]]",
        "expected rows of a part of the width",
    ),
    ("\"1:20\"", "\"1:0\"", "a positive length, or \"1:20\""),
    ("\"1:20\"", "\"steep\"", "a positive length, or \"1:20\""),
    (
        "at = { x = 0.3 }",
        "at = { x = 0.3 }\nsuction = 0.3",
        "web \"web\": expected",
    ),
    (
        "at = { x = 0.3 }",
        "at = { angle = 0.3 }",
        "one of \"x\", \"plane\" and \"distance\"",
    ),
    (
        "[line]\nlength = 50\n",
        "",
        "expected \"eta\" in a layup without [line]",
    ),
    (
        "[0, 25, 50]",
        "[0, 25, 51]",
        "a.layup.toml:5: a \"span\" goes to 51 m, expected at most 50 m",
    ),
    (
        "[0, 25, 50]",
        "[0, 25, 20]",
        "expected ascending lengths from 0, not 20 after 25",
    ),
    (
        "at = { x = 0.3 }",
        "at = { x = 0.3 }\neta = 0.5",
        "\"eta\" of \"web\" is 0.5, expected two ascending positions",
    ),
    (
        "ply_thickness = \"1 mm\"",
        "ply_thickness = 0",
        "\"ply_thickness\" is 0, expected a length greater than zero",
    ),
    (
        "density = 1900",
        "density = -1900",
        "expected 0 or more\n  help: a material without mass has the density 0",
    ),
    (
        "span = [0, 25, 50]",
        "eta = [0, 1], span = [0, 1]",
        "expected \"eta\" and \"value\"",
    ),
    (
        "column = \"tape\"",
        "column = \"tap\"",
        "did you mean \"tape\"?",
    ),
    ("\"t.csv\"", "\"u.csv\"", "u.csv"),
    // beside numbers of its column, and in a column without a unit in its heading
    (
        "column = \"tape\"",
        "column = \"strip\"",
        "2 mm\", expected a number (named by \"file\" of [layer.thickness], ",
    ),
    (
        "column = \"tape\"",
        "column = \"strip\"",
        "\n  help: write the unit in the heading, as \"strip [mm]\", and 2 here",
    ),
    (
        "column = \"tape\"",
        "column = \"bare\"",
        "t.csv:2: column \"bare\": found \"1 mm\", expected a number",
    ),
    (
        "column = \"tape\"",
        "column = \"bare\"",
        "\n  help: write the unit in the heading, as \"bare [mm]\", and 1 here",
    ),
    ("side = \"suction\"\n", "", "expected one of \"arc\""),
    (
        "from = \"base.suction\"",
        "from = { arc = 0.1, side = \"suction\" }",
        "a.layup.toml:32: expected one of \"arc\", \"x\", \"distance\", \"plane\" and \"at\"; a \"side\" with \
         \"x\", \"distance\" and \"plane\" alone, an \"angle\" with \"plane\" alone",
    ),
    (
        "from = \"base.suction\"",
        "from = { at = \"nose\", side = \"suction\" }",
        "a.layup.toml:32: expected one of",
    ),
    (
        "from = \"base.suction\"",
        "from = { x = 0.1, side = \"suction\", angle = 0.1 }",
        "a.layup.toml:32: expected one of",
    ),
    (
        "cap_rear + 40",
        "cap_reer + 40",
        "a.layup.toml:19: place \"cap_reer\" is not in the file\n  help: did you mean \
         \"cap_rear\"?",
    ),
    (
        "x = 0.45\nside = \"suction\"",
        "at = \"web.suction.aft\"\n[place.b]\nat = \"cap_reer\"",
        "a.layup.toml:10: place \"cap_reer\" is not in the file",
    ),
    (
        "at = { x = 0.3 }",
        "suction = \"patch.start\"\npressure = 0.7",
        "a.layup.toml:26: places go in a circle: web.suction.fore -> patch.start -> \
         web.suction.fore",
    ),
    (
        "\"1:20\"",
        "\"-1:-20\"",
        "expected a positive length, or \"1:20\"",
    ),
    (
        "count = 20, round",
        "count = -3, round",
        "\"count\" is -3, expected a pure number, zero or more",
    ),
    (
        "value = [0.001, 0.001], hold",
        "value = [0.001, -0.001], hold",
        "thickness is -0.001 at the position 0.4 along the span, expected a length, zero or more",
    ),
];

#[test]
fn wrong_words_are_refused() {
    for (from, to, expected) in WRONG {
        assert!(TEXT.contains(from), "{from}");
        let problems = parse(&TEXT.replacen(from, to, 1)).expect_err(to);
        assert!(problems.contains(expected), "{to}: {problems}");
    }
    let tabs = TEXT.replace("cap_rear + 40 mm", "cap_rear\\t+\\t40\\tmm");
    assert_eq!(section(&tabs, 0.3), section(TEXT, 0.3));
    // one problem, not two
    let zero = parse(&TEXT.replace("\"1 mm\"", "0")).expect_err("a thickness");
    assert!(!zero.contains("no ply thickness"), "{zero}");
}

/// Places without a use, and layers that no section has.
#[test]
fn what_has_no_effect_is_a_remark() {
    let remarks = |text: &str| parse(text).expect("a layup").remarks;
    assert_eq!(remarks(TEXT), [""; 0]);
    let places =
        "[place.nose]\narc = 0.4\n[place.\"cap.end\"]\narc = 0.4\n[place.idle]\narc = 0.4\n";
    let text = TEXT.replacen("[place.cap_rear]", &format!("{places}[place.cap_rear]"), 1);
    let expected = [
        "line 8: place \"nose\" has the name of a point of the contour, which is used",
        "line 10: place \"cap.end\" has the name of a place of a layer or web, which is used",
        "line 12: place \"idle\" is not used",
    ];
    assert_eq!(remarks(&text), expected);
    let absent = |text: &str| {
        let layup = parse(text).expect("a layup");
        let absent = layup.absent_layers();
        let absent = absent.iter().map(|(name, line)| format!("{line} {name}"));
        absent.collect::<Vec<String>>()
    };
    assert_eq!(absent(TEXT), [""; 0]);
    let text = TEXT
        .replace("value = [0.001, 0.001], hold", "value = [0, 0], hold")
        .replace("count = 20, round", "count = 0, round");
    assert_eq!(absent(&text), ["22 patch", "37 ply"]);
}

/// The area of a layer with a profile is the integral of the profile: a half of the full one for a
/// triangle, three quarters with a drop over a half of the width; to 1e-3 on the curved surface.
#[test]
fn profiles_have_their_areas() {
    let area = |profile: &str| {
        let text = TEXT.replace("taper = \"1:20\"", profile);
        let layup = parse(&text).unwrap_or_else(|problems| panic!("{problems}"));
        let meshed = layup
            .mesh(0.26)
            .unwrap_or_else(|problems| panic!("{problems}"));
        let cap = meshed.areas.iter().find(|area| area.name == "cap");
        let cap = cap.expect("a cap");
        assert!((cap.meshed / cap.nominal - 1.0).abs() < 1e-3, "{cap:?}");
        cap.meshed
    };
    let whole = area("");
    for (profile, part) in [
        ("profile = [[0, 0], [0.5, 1], [1, 0]]", 0.5),
        ("profile = [[0, 1], [0.5, 1], [1, 0]]", 0.75),
        ("profile = [[0, 0.5], [1, 1]]", 0.75),
    ] {
        let found = area(profile) / whole;
        assert!((found / part - 1.0).abs() < 5e-3, "{profile}: {found}");
    }
}

/// A layer by a table of one position is there only, and along the whole span if it is held; a
/// written file has it so.
#[test]
fn one_position_is_no_range() {
    let names = |layup: &Layup, eta: f64| -> Vec<String> {
        let found = layup.section(eta);
        let found = found.unwrap_or_else(|problems| panic!("{problems}"));
        found.layers.into_iter().map(|one| one.name).collect()
    };
    let table = "{ eta = [0.2, 0.4], value = [0.001, 0.001], hold = true }";
    for (one, there) in [
        ("{ eta = [0.3], value = [0.001] }", [false, true, false]),
        ("{ eta = [0.3], value = [0.001], hold = true }", [true; 3]),
    ] {
        let layup = parse(&TEXT.replace(table, one));
        let layup = layup.unwrap_or_else(|problems| panic!("{problems}"));
        let again = parse(&layup_file(&layup, "a.layup.toml"))
            .unwrap_or_else(|problems| panic!("{problems}"));
        for layup in [&layup, &again] {
            let patch = "patch".to_owned();
            let found = [0.26, 0.3, 0.34].map(|eta| names(layup, eta).contains(&patch));
            assert_eq!(found, there, "{one}");
        }
    }
}

#[test]
fn a_distance_beyond_the_side_is_named() {
    let far = "to = { distance = \"99 m\", side = \"suction\" }";
    let layup = parse(&TEXT.replace("to = \"nose - 0.02\"", far));
    let layup = layup.unwrap_or_else(|problems| panic!("{problems}"));
    let problem = layup.section(0.26).expect_err("a place beyond the contour");
    let expected = "\"distance = 99 m\" of layer \"patch\" is not on the contour at eta 0.26";
    assert!(problem.to_string().contains(expected), "{problem}");
}
