//! Edges that are thinner than their first layers, contours of one side, and webs of nothing.

use std::path::Path;

use section_analyzer::input::layup;
use section_analyzer::output::layer_rows;

/// A section whose first layer is a twentieth of its height, with layers near the trailing edge.
const TEXT: &str = "\
units = \"SI\"
[shape]
chord = 1
origin = 0.25
naca = \"0015\"
[[layer]]
name = \"skin\"
material = \"glass\"
thickness = 0.02
[[layer]]
name = \"edge\"
material = \"glass\"
thickness = 0.003
from = 0
to = 0.05
[[layer]]
name = \"strip\"
material = \"glass\"
thickness = 0.003
from = 0.3
to = 0.35
[material.glass]
young = 40e9
poisson = 0.3
density = 1900
";

/// The nominal areas contain the layers behind the cut: `t L` of a layer along the flat rear, whose contour is
/// 2.05 chords long (1 % by its bulge), and which has no cells. A layer elsewhere is complete.
#[test]
fn layers_behind_a_cut_count_as_given() {
    let layup = layup::parse(TEXT, Path::new("a.layup.toml"))
        .unwrap_or_else(|problems| panic!("{problems}"));
    let meshed = layup
        .mesh(0.0)
        .unwrap_or_else(|problems| panic!("{problems}"));
    let rows = layer_rows(&layup, &meshed);
    let [skin, edge, strip] = ["skin", "edge", "strip"].map(|name| {
        let row = rows.iter().find(|row| row.layer == name);
        row.unwrap_or_else(|| panic!("{name}"))
    });
    let expected = 0.003 * 0.05 * 2.05;
    assert!((edge.nominal / expected - 1.0).abs() < 0.02, "{edge:?}");
    assert!(edge.meshed < 0.01 * edge.nominal, "{edge:?}");
    assert!((edge.cut / edge.nominal - 1.0).abs() < 0.01, "{edge:?}");
    assert!(skin.cut > 0.05 * skin.nominal, "{skin:?}");
    let kept = skin.nominal - skin.cut;
    assert!((skin.meshed / kept - 1.0).abs() < 0.005, "{skin:?}");
    assert!(
        (strip.meshed / strip.nominal - 1.0).abs() < 0.005,
        "{strip:?}"
    );
}

/// One side alone is no section.
#[test]
fn a_contour_of_one_side_is_refused() {
    let points: Vec<String> = (0..=20)
        .map(|k| {
            let x = 1.0 - f64::from(k) / 20.0;
            format!("[{x:?}, {:?}]", 0.4 * x * (1.0 - x))
        })
        .collect();
    let points = format!("points = [{}]", points.join(", "));
    let text = TEXT.replace("naca = \"0015\"", &points);
    let layup = layup::parse(&text, Path::new("a.layup.toml"))
        .unwrap_or_else(|problems| panic!("{problems}"));
    let problems = layup.mesh(0.0).expect_err("a half contour").to_string();
    assert!(
        problems.contains("of its length from its start, expected both sides of the section"),
        "{problems}"
    );
}
