//! Webs at the trailing edge, on which the layers of both sides end.

use std::fmt::Write;
use std::path::Path;

use nalgebra::Matrix6;
use section_analyzer::analysis::{analyze, discretization_error};
use section_analyzer::input::layup;
use serde_json::Value;

use crate::files::section;

const FOLDER: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../tests/reference/sections/blade_naca"
);

fn parsed(text: &str) -> layup::Layup {
    let layup = layup::parse(text, Path::new("a.layup.toml"));
    layup.unwrap_or_else(|problems| panic!("{problems}"))
}

/// The points of the outer contour of `blade_naca.geo`, numbers 1 to 73, with three more on each of
/// the straight lines between them aft of 2 % of the chord, so that splines follow the lines.
fn contour() -> Vec<[f64; 2]> {
    let geo = std::fs::read_to_string(format!("{FOLDER}.geo")).expect("a file");
    let point = |number: usize| {
        let head = format!("Point({number})={{");
        let line = geo.lines().find_map(|line| line.strip_prefix(&head));
        let mut numbers = line.expect("a point").split(',');
        [0; 2].map(|_| {
            numbers
                .next()
                .map_or(0.0, |one| one.parse().expect("a number"))
        })
    };
    let corners: Vec<[f64; 2]> = (1..=73).map(point).collect();
    let mut points = vec![corners[0]];
    for pair in corners.windows(2) {
        let is_aft = pair.iter().all(|point| point[0] > 0.02);
        let count = if is_aft { 4 } else { 1 };
        let at = |part: f64| [0, 1].map(|i| pair[0][i] + part * (pair[1][i] - pair[0][i]));
        points.extend((1..=count).map(|i| at(f64::from(i) / f64::from(count))));
    }
    points
}

/// The section `blade_naca`: two plies around a NACA 0012 that is cut off at 90 % of the chord, a
/// web, and a wall behind the ends of the plies. Its files measure plane angles in axes that are
/// turned by half a turn about z, in which angles from x to the contour have the same sign.
fn blade_naca(size: f64) -> String {
    let mut text = format!("units = \"SI\"\n[mesh]\nsize = {size}\n");
    let _ = writeln!(
        text,
        "[shape]\nchord = 1\norigin = 0\npoints = {:?}",
        contour()
    );
    text + r#"
[[layer]]
name = "skin_ply0"
material = "a"
thickness = 0.003
fiber_angle = 45
toward = "contour"
[[layer]]
name = "skin_ply1"
material = "b"
thickness = 0.005
fiber_angle = 15
toward = "contour"
[[web]]
name = "web"
at = { x = 0.35 }
plies = [{ name = "web_ply", material = "a", thickness = 0.02, fiber_angle = 45 }]
[[web]]
name = "te"
at = "trailing_edge"
plies = [{ name = "te_wall", material = "a", thickness = 0.008, fiber_angle = 30 }]
[material.a]
e1 = 24.8e9
e2 = 10.3e9
e3 = 10.3e9
g12 = 8.0e9
g13 = 4.1e9
g23 = 3.8e9
nu12 = 0.3
nu13 = 0.3
nu23 = 0.33
density = 1830
[material.b]
e1 = 37e9
e2 = 9e9
e3 = 9e9
g12 = 4e9
g13 = 4e9
g23 = 3.4e9
nu12 = 0.28
nu13 = 0.28
nu23 = 0.32
density = 1860
"#
}

/// A matrix of the file: its x, y, z are y, z, x of a section whose y points aft, and ours is turned
/// by half a turn about z.
fn matrix(value: &Value) -> Matrix6<f64> {
    const ORDER: [usize; 6] = [2, 0, 1, 5, 3, 4];
    const SIGN: [f64; 6] = [-1.0, -1.0, 1.0, -1.0, -1.0, 1.0];
    Matrix6::from_fn(|i, j| {
        let entry = value[ORDER[i]][ORDER[j]].as_f64().expect("a number");
        SIGN[i] * SIGN[j] * entry
    })
}

/// Source: `tests/reference/sections/README.md`, extrapolated from three meshes of ANBA4. The
/// tolerance of the stiffness is the sum of the estimated error of this mesh and the uncertainty of
/// the extrapolation. Mass has no such error; the ends of the skins are left, triangles of half the
/// square of the thickness times the slope, which the reference cuts off along the base: some 3e-4 of
/// the mass at more than twice the radius of inertia, 1e-3 of the moments of inertia.
#[test]
fn blade_naca_is_the_same_by_columns() {
    let json = std::fs::read_to_string(format!("{FOLDER}.json")).expect("a file");
    let json: Value = serde_json::from_str(&json).expect("JSON");
    let made = section(&parsed(&blade_naca(0.012)), 0.0);
    let solution = analyze(&made.section).expect("a solution");
    let estimate = discretization_error(&made.section, &solution.stiffness).expect("an estimate");
    let converged = matrix(&json["converged"]["K"]);
    let uncertain = matrix(&json["converged"]["uncertainty_abs"]).abs();
    let mass = matrix(&json["on_this_mesh"]["M"]);
    let largest = |m: Matrix6<f64>, of: &Matrix6<f64>| {
        Matrix6::from_fn(|i, j| m[(i, j)] / (of[(i, i)] * of[(j, j)]).sqrt()).amax()
    };
    let difference = largest(solution.stiffness - converged, &converged);
    let error = largest(estimate.stiffness.abs(), &converged);
    let uncertainty = largest(uncertain, &converged);
    let of_mass = largest(solution.mass - mass, &mass);
    println!(
        "{} nodes: difference {difference:e}, error {error:e}, reference {uncertainty:e}, mass {of_mass:e}",
        made.section.mesh.nodes.len()
    );
    assert!(difference < error + uncertainty, "{difference:e}");
    assert!(of_mass < 1e-3, "{of_mass:e}");
}

/// A NACA 0012 of chord 1 m, cut off at this part of the chord, with one layer and a web of two plies
/// at its trailing edge.
fn cut_off(at: f64, layer: f64, rest: &str) -> String {
    let half = |x: f64| {
        0.6 * (0.2969 * x.sqrt() - 0.126 * x - 0.3516 * x * x + 0.2843 * x.powi(3)
            - 0.1036 * x.powi(4))
    };
    let point = |i: i32| {
        let x = at * (f64::from(i) / 40.0).powi(2);
        [x, -half(x) * f64::from(i.signum())]
    };
    let points: Vec<[f64; 2]> = (-40..=40).map(point).collect();
    format!(
        "units = \"SI\"\n[shape]\nchord = 1\norigin = 0\npoints = {points:?}\n\
         [[layer]]\nname = \"skin\"\nmaterial = \"m\"\nthickness = {layer}\n\
         [[web]]\nname = \"te\"\nat = \"trailing_edge\"\nplies = [\
         {{ name = \"inner\", material = \"m\", thickness = 0.004 }},\
         {{ name = \"outer\", material = \"m\", thickness = 0.002 }}]\n{rest}\n\
         [material.m]\nyoung = 70e9\npoisson = 0.3\ndensity = 1\n"
    )
}

/// Each ply has the length of the base times its thickness, and the core behind its bound fills the
/// rest up to the web.
#[test]
fn plies_lie_behind_the_whole_base() {
    let fill = "[[fill]]\nname = \"core\"\nmaterial = \"m\"\nahead_of = \"te\"";
    for rest in ["", fill] {
        let layup = parsed(&cut_off(0.8, 0.005, rest));
        let meshed = layup
            .mesh(0.0)
            .unwrap_or_else(|problems| panic!("{problems}"));
        let contour = &meshed.section.contour;
        let base = contour[0][1] - contour[contour.len() - 1][1];
        let area = |name: &str| meshed.areas.iter().find(|area| area.name == name);
        for (name, thickness) in [("inner", 0.004), ("outer", 0.002)] {
            let area = area(name).expect("a ply").meshed;
            assert!(
                (area / (base * thickness) - 1.0).abs() < 1e-9,
                "{name} {area}"
            );
        }
        let skin = area("skin").expect("a layer");
        assert!((skin.meshed / skin.nominal - 1.0).abs() < 5e-3, "{skin:?}");
        assert_eq!(area("core").is_some(), !rest.is_empty());
    }
}

/// The layup is written and read again with the same section.
#[test]
fn a_web_at_the_trailing_edge_is_written() {
    let layup = parsed(&cut_off(0.8, 0.005, ""));
    let again = parsed(&section_analyzer::output::layup_file(&layup, "a"));
    let sections = [&layup, &again].map(|one| one.section(0.0).expect("a section"));
    assert_eq!(sections[0].webs, sections[1].webs);
}

fn refusal(text: &str) -> String {
    match layup::parse(text, Path::new("a.layup.toml")) {
        Err(problems) => problems.to_string(),
        Ok(layup) => layup.mesh(0.0).expect_err("a problem").to_string(),
    }
}

#[test]
fn webs_at_the_trailing_edge_that_do_not_fit_are_refused() {
    let second = "[[web]]\nname = \"other\"\nat = \"trailing_edge\"\nplies = [\
                  { name = \"third\", material = \"m\", thickness = 0.004 }]";
    let behind = "[[fill]]\nname = \"core\"\nmaterial = \"m\"\naft_of = \"te\"";
    let cases = [
        // 12 mm of both sides on a base of 11 mm
        (cut_off(0.96, 0.006, ""), "stands on a flat base of 0.0"),
        (cut_off(1.0, 0.0004, ""), "stands on a flat base"),
        (cut_off(0.8, 0.005, second), "are both at the trailing edge"),
        (cut_off(0.8, 0.005, behind), "no space for fill \"core\""),
        (
            cut_off(0.8, 0.005, "").replace("\"trailing_edge\"", "\"rear\""),
            "\"trailing_edge\", or a table with x or plane",
        ),
    ];
    let tab = |text: &str| cut_off(0.8, 0.005, "").replace("[shape]", text);
    let taught = [
        (
            tab("[shape]\ntrailing_edge = \"tab\""),
            "a [[web]] with at = \"trailing_edge\"",
        ),
        (
            tab("[trailing_edge]\nclose = \"bond\"\n[shape]"),
            "a table \"bond\" with material and to beside it",
        ),
    ];
    for (text, expected) in cases.into_iter().chain(taught) {
        let found = refusal(&text);
        assert!(found.contains(expected), "{found}");
    }
}
