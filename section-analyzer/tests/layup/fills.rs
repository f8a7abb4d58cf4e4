//! Spaces between shell and webs filled with triangles.

use std::f64::consts::PI;
use std::path::Path;

use section_analyzer::analysis::analyze;
use section_analyzer::input::layup::{self, Layup};
use section_analyzer::output::layup_file;

use crate::files::section;

/// Three spaces of an airfoil.
pub const TEXT: &str = "\
units = \"SI\"
[shape]
naca = \"0018\"
chord = 1
[[layer]]
name = \"skin\"
material = \"metal\"
thickness = 0.001
[[web]]
name = \"rear\"
at = { x = 0.6 }
plies = [{ name = \"b\", material = \"metal\", thickness = 0.003 }]
[[fill]]
name = \"mass\"
material = \"metal\"
ahead_of = { x = 0.05 }
[[fill]]
name = \"core\"
material = \"metal\"
aft_of = { x = 0.05 }
ahead_of = \"rear\"
[[fill]]
name = \"rest\"
material = \"metal\"
[material.metal]
young = 70e9
poisson = 0.3
density = 1
";

fn parse(text: &str) -> Result<Layup, String> {
    layup::parse(text, Path::new("a.layup.toml")).map_err(|problems| problems.to_string())
}

fn half(x: f64) -> f64 {
    let rest = -0.126 * x - 0.3516 * x * x + 0.2843 * x.powi(3) - 0.1015 * x.powi(4);
    5.0 * 0.18 * (0.2969 * x.sqrt() + rest)
}

/// Area of NACA 0018 of unit chord between two positions, by its polynomial.
fn area(from: f64, to: f64) -> f64 {
    const STEPS: usize = 200_000;
    let at = |i: usize| from + (to - from) * (i as f64 + 0.5) / STEPS as f64;
    let sum: f64 = (0..STEPS).map(|i| 2.0 * half(at(i))).sum();
    sum * (to - from) / STEPS as f64
}

/// All spaces of one material make a solid section: the area of the contour as mass, within the
/// error of the spline through its points, and E times it in extension. The parts lie
/// between their planes: the nose mass ahead of x = 0.05, within the area of the skin there, of
/// which 1 mm times the length of its outline is 1 % of it.
#[test]
fn filled_spaces_make_a_solid_section() {
    let layup = parse(TEXT).expect("a layup");
    let found = analyze(&section(&layup, 0.0).section).expect("a solution");
    let mass = found.mass[(0, 0)];
    println!("{}", mass / area(0.0, 1.0) - 1.0);
    assert!((mass / area(0.0, 1.0) - 1.0).abs() < 1e-6, "{mass}");
    assert!((found.stiffness[(0, 0)] / (70e9 * mass) - 1.0).abs() < 1e-9);
    let meshed = layup.mesh(0.0).expect("a mesh");
    let of = |name: &str| {
        let found = meshed.areas.iter().find(|area| area.name == name);
        found.expect("an area").meshed
    };
    let sum: f64 = meshed.areas.iter().map(|area| area.meshed).sum();
    assert!((sum / mass - 1.0).abs() < 1e-9, "{sum} {mass}");
    // length of the outline ahead of 0.05, by chords
    let length: f64 = (0..20_000)
        .map(|i| {
            let [a, b] = [0, 1].map(|k| 0.05 * (f64::from(i + k) / 20_000.0).powi(2));
            2.0 * (b - a).hypot(half(b) - half(a))
        })
        .sum();
    let nose = area(0.0, 0.05);
    let inside = nose - 0.001 * length + PI * 0.5e-6;
    println!("{} {}", of("mass") / inside - 1.0, of("core") + of("rest"));
    assert!((of("mass") / inside - 1.0).abs() < 5e-5, "{}", of("mass"));
}

/// A solid ellipse in a thin skin of its material: G pi a^3 b^3 / (a^2 + b^2), from 20 cells around
/// on, where the curved sides of a space, parabolas, are the largest error.
#[test]
fn a_filled_ellipse_has_the_torsion_of_saint_venant() {
    let (a, b) = (1.0_f64, 0.5_f64);
    let points: Vec<String> = (0..=360)
        .map(|i| {
            let (sine, cosine) = (f64::from(i) * PI / 180.0).sin_cos();
            format!("[{:?}, {:?}]", 0.5 + 0.5 * cosine, 0.25 * sine)
        })
        .collect();
    let text = format!(
        "units = \"SI\"\n[shape]\npoints = [{}]\nchord = 2\norigin = 0.5\n[mesh]\nsize = SIZE\n\
         [[layer]]\nname = \"skin\"\nmaterial = \"metal\"\nthickness = 0.01\n\
         [[fill]]\nname = \"core\"\nmaterial = \"metal\"\n\
         [material.metal]\nyoung = 2.6\npoisson = 0.3\ndensity = 1\n",
        points.join(", ")
    );
    let exact = PI * (a * b).powi(3) / (a * a + b * b);
    let errors = [0.4, 0.2, 0.1].map(|size| {
        let layup = parse(&text.replace("SIZE", &size.to_string())).expect("a layup");
        let found = analyze(&section(&layup, 0.0).section).expect("a solution");
        println!("area {:e}", found.mass[(0, 0)] / (PI * a * b) - 1.0);
        found.stiffness[(3, 3)] / exact - 1.0
    });
    println!("torsion {errors:?}");
    assert!(
        errors[2].abs() < 1e-6 && errors[0].abs() < 5e-5,
        "{errors:?}"
    );
}

/// A material with its fiber across the section: E in extension becomes E2, and a
/// plane angle of 90 degrees exchanges the second and the third axis in bending.
#[test]
fn fills_have_angles() {
    let skin = "name = \"skin\"\nmaterial = \"soft\"\nthickness = 0.001";
    let metal = "name = \"core\"\nmaterial = \"metal\"";
    let laws = "[material.soft]\nyoung = 1\npoisson = 0.3\ndensity = 1\n[material.metal]\n\
                e1 = 100e9\ne2 = 10e9\ne3 = 1e9\ng12 = 5e9\ng13 = 4e9\ng23 = 3e9\n\
                nu12 = 0\nnu13 = 0\nnu23 = 0\ndensity = 1\n";
    let text = format!(
        "units = \"SI\"\n[shape]\nnaca = \"0018\"\nchord = 1\n[[layer]]\n{skin}\n[[fill]]\n{metal}\n\
         ANGLES\n{laws}"
    );
    let axial = |angles: &str| {
        let layup = parse(&text.replace("ANGLES", angles)).unwrap_or_else(|text| panic!("{text}"));
        let found = analyze(&section(&layup, 0.0).section).expect("a solution");
        let area = layup.mesh(0.0).expect("a mesh").areas[1].meshed;
        found.stiffness[(0, 0)] / area
    };
    for (angles, expected) in [
        ("", 100e9),
        ("fiber_angle = \"90 deg\"", 10e9),
        ("fiber_angle = \"90 deg\"\nplane_angle = \"90 deg\"", 10e9),
    ] {
        let found = axial(angles);
        assert!((found / expected - 1.0).abs() < 1e-6, "{angles}: {found}");
    }
    let layup = parse(&text.replace("ANGLES", "plane_angle = \"0.5 rad\"")).expect("a layup");
    let again = parse(&layup_file(&layup, "a")).unwrap_or_else(|text| panic!("{text}"));
    assert_eq!(layup.fills[0].plane_angle, again.fills[0].plane_angle);
}

/// Fills are written and read again; each is a jump of the span where it ends.
#[test]
fn fills_are_written_and_read_again() {
    let text = TEXT
        .replace("_of = { x = 0.05 }", "_of = { plane = -0.2, angle = 0.1 }")
        .replace("name = \"rest\"", "name = \"rest\"\neta = [0.2, 0.7]");
    let layup = parse(&text).expect("a layup");
    let again = parse(&layup_file(&layup, "a")).unwrap_or_else(|text| panic!("{text}"));
    for eta in [0.1, 0.5] {
        let sections = [&layup, &again].map(|layup| layup.section(eta).expect("a section"));
        assert_eq!(sections[0].fills, sections[1].fills);
        assert_eq!(sections[0].fills.len(), if eta < 0.2 { 2 } else { 3 });
        layup
            .mesh(eta)
            .unwrap_or_else(|problems| panic!("{problems}"));
    }
    assert_eq!(layup.jumps(), [0.2, 0.7]);
}

/// Words, others in their place, and the problem.
const WRONG: &[(&str, &str, &str)] = &[
    (
        "ahead_of = \"rear\"",
        "ahead_of = \"raer\"",
        "error: a.layup.toml:21: web \"raer\" is not in the file\n  help: did you mean \
             \"rear\"?",
    ),
    (
        "ahead_of = { x = 0.05 }",
        "ahead_of = { x = 0.05, side = \"suction\" }",
        "a.layup.toml:16: unknown key \"side\"",
    ),
    (
        "ahead_of = { x = 0.05 }",
        "ahead_of = 3",
        "error: a.layup.toml:16: \"ahead_of\" is 3, expected",
    ),
    (
        "ahead_of = { x = 0.05 }",
        "",
        "error: a.layup.toml:17: eta 0: there is no space for fill \"core\" between shell and webs\n  help: fills before it may have taken it, its bounds may be in the wrong order, or the layers of both sides meet there",
    ),
    (
        "aft_of = { x = 0.05 }",
        "aft_of = { x = 0.7 }",
        "error: a.layup.toml:17: eta 0: there is no space for fill \"core\" between shell and webs\n  help: fills before it may have taken it, its bounds may be in the wrong order, or the layers of both sides meet there",
    ),
    (
        "ahead_of = { x = 0.05 }",
        "ahead_of = { x = 0.6 }",
        "error: a.layup.toml:9: eta 0: the feet of web \"rear\" and the bound of fill \"mass\" \
             overlap on the suction side by 0.00",
    ),
    (
        "ahead_of = { x = 0.05 }",
        "ahead_of = { x = 1.2 }",
        "error: a.layup.toml:16: \"x = 1.2\" of fill \"mass\" is not on the contour at eta 0",
    ),
    (
        "plies = [{ name = \"b\", material = \"metal\", thickness = 0.003 }]",
        "plies = []",
        "error: a.layup.toml:17: eta 0: fill \"core\" is bounded by web \"rear\", which has no \
             plies here",
    ),
    (
        "name = \"rest\"",
        "name = \"skin\"",
        "error: a.layup.toml:22: \"skin\" is the name of another layer, web or fill on line 5, \
             expected a name of its own",
    ),
    (
        "name = \"rest\"",
        "name = \"rest\"\neta = [0.5, 0.2]",
        "error: a.layup.toml:24: \"eta\" of \"rest\" is [0.5, 0.2], expected two ascending positions \
         from 0 to 1\n  help: eta = [0.1, 0.9]; without it",
    ),
    (
        "name = \"rest\"\nmaterial = \"metal\"",
        "name = \"rest\"\nmaterial = \"metall\"",
        "error: a.layup.toml:24: material \"metall\" is not in the file\n  help: did you mean \
             \"metal\"?",
    ),
];

#[test]
fn wrong_fills_are_named() {
    for (from, to, expected) in WRONG {
        let made = parse(&TEXT.replacen(from, to, 1));
        let problem = made.and_then(|layup| {
            let meshed = layup.mesh(0.0).map_err(|problems| problems.to_string());
            meshed.map(|_| layup)
        });
        let problem = problem.expect_err(to);
        assert!(problem.contains(expected), "{to}: {problem}\n{expected}");
    }
}

/// Flanges and bond lines are layers from the faces of a web, adhesive at the trailing edge is a
/// fill. The flange is 20 mm wide on both sides of a web of 4 mm, under which it continues: 44 mm
/// times 2 mm, less 5e-3 for the curvature of the surface. The adhesive is the space behind x = 0.9 inside of
/// the skin and of the wall across the base.
#[test]
fn flanges_bonds_and_adhesive_are_layers_and_fills() {
    let joints = "[[layer]]
name = \"bond\"
material = \"metal\"
thickness = 0.001
from = \"web.suction.aft - 20 mm\"
to = \"web.suction.fore + 20 mm\"
[[layer]]
name = \"flange\"
material = \"metal\"
thickness = 0.002
from = \"web.suction.aft - 20 mm\"
to = \"web.suction.fore + 20 mm\"
[[web]]
name = \"web\"
at = { x = 0.3 }
plies = [{ name = \"ply\", material = \"metal\", thickness = 0.004 }]
[[fill]]
name = \"adhesive\"
material = \"metal\"
aft_of = { x = 0.9 }
[material.metal]";
    let head = TEXT.split("[[web]]").next().expect("a head");
    let tail = TEXT.split("[material.metal]").nth(1).expect("a tail");
    let layup = parse(&format!("{head}{joints}{tail}")).unwrap_or_else(|text| panic!("{text}"));
    let meshed = layup
        .mesh(0.0)
        .unwrap_or_else(|problems| panic!("{problems}"));
    let of = |name: &str| {
        let found = meshed.areas.iter().find(|area| area.name == name);
        found.expect("an area").meshed
    };
    let inside = |x: f64| {
        let slope = (half(x + 1e-6) - half(x - 1e-6)) / 2e-6;
        2.0 * half(x) - 0.002 * 1.0_f64.hypot(slope)
    };
    let adhesive: f64 = (0..1000)
        .map(|i| inside(0.9 + 0.099 * (f64::from(i) + 0.5) / 1000.0))
        .sum::<f64>()
        * 0.099
        / 1000.0;
    let errors = [
        of("bond") / (0.044 * 0.001) - 1.0,
        of("flange") / (0.044 * 0.002) - 1.0,
        of("adhesive") / adhesive - 1.0,
    ];
    println!("{errors:?}");
    assert!(
        errors[0].abs() < 5e-3 && errors[1].abs() < 1e-2,
        "{errors:?}"
    );
    assert!(errors[2].abs() < 1e-3, "{errors:?}");
}
