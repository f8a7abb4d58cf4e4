//! All stations of the public blades, meshed from their windIO files, and some of them solved.

use section_analyzer::analysis::analyze;
use section_analyzer::input::layup::{Layup, parse};
use section_analyzer::mesh::generate::layup::{LayerArea, Outline};
use section_analyzer::properties::Perimeter;
use serde_json::Value;

use crate::areas;
use crate::effort;
use crate::files::section;
use crate::sections::{measures, number, reference};
use crate::windio::blade;

/// Blades of the reference, and their files.
const BLADES: [[&str; 2]; 4] = [
    ["iea22", "windio2_iea22"],
    ["iea15", "windio1_iea15"],
    ["iea34", "windio2_iea34"],
    ["iea10", "windio2_iea10"],
];
/// Measures of the reference, in the order of [`measures`].
const MEASURES: [&str; 5] = ["mass", "EA", "flap", "edge", "GJ"];

/// The stations of a blade of the reference.
fn stations(name: &str) -> Vec<Value> {
    let file = reference("blades.json");
    let stations = file["blades"][name]["stations"].as_array();
    stations.expect("stations").clone()
}

/// Meshed areas of the layers of more than 1 % of a station, relative to thickness times width on
/// the curved surface, of the independent mesher without the part that its contacts cut, or of ours
/// without mitres, which close more bases by a wall; the worst one.
fn worst_area(layup: &Layup, station: &Value) -> (String, f64) {
    let eta = number(&station["eta"]);
    let meshed = layup.mesh(eta);
    let meshed = meshed.unwrap_or_else(|problems| panic!("{eta}: {problems}"));
    let expected = station["areas"].as_object();
    let of = |name: &str| {
        let mut all = expected?.iter();
        let found = all.find(|(known, _)| known.eq_ignore_ascii_case(name))?;
        Some(number(&found.1[1]))
    };
    let large = areas::large(&meshed.areas);
    let error = |area: &LayerArea| {
        let errors = [of(&area.name)?, area.nominal].map(|other| area.meshed / other - 1.0);
        let least = errors
            .into_iter()
            .min_by(|a, b| a.abs().total_cmp(&b.abs()));
        Some((area.name.clone(), least?))
    };
    let worst = large.filter_map(error);
    let worst = worst.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
    worst.unwrap_or((String::new(), 0.0))
}

/// Differences of the measures of a station from the ones of a source of the reference.
fn differences(layup: &Layup, station: &Value, sources: [&str; 2]) -> [[f64; 5]; 2] {
    let eta = number(&station["eta"]);
    let solution = analyze(&section(layup, eta).section).expect("a solution");
    let found = measures(&solution);
    sources.map(|source| {
        let of = |i: usize| found[i] / number(&station[source][MEASURES[i]]) - 1.0;
        [0, 1, 2, 3, 4].map(of)
    })
}

/// Areas of the layers are within 0.5 % at 75 of the 76 stations. At the tip of IEA-10, with walls of 14 mm in a
/// nose of 2 mm, up to a twentieth of a layer is cut.
#[test]
fn all_stations_of_public_blades_are_meshed() {
    let mut count = 0;
    for [name, file] in BLADES {
        let layup = blade(file);
        for station in stations(name) {
            let eta = number(&station["eta"]);
            let (layer, error) = worst_area(&layup, &station);
            println!("{name} {eta}: {layer} {:.3} %", 100.0 * error);
            let is_crowded = (name, eta) == ("iea10", 1.0);
            let most = if is_crowded { 0.05 } else { 5e-3 };
            assert!(error.abs() < most, "{name} {eta}: {layer} {error}");
            count += 1;
        }
    }
    assert_eq!(count, 76);
}

/// At 101 positions of IEA-15 and IEA-3.4, and at two more where walls across the base begin and end, areas of layers of
/// more than 1 % of the section are within 0.3 %: without the part that contacts cut, and with the space that the
/// innermost layers fill where the edge is closed (from 0.43 to 0.47 up to 2.1 % of the reinforcements, ahead of a
/// base that is too short for a wall). Nominal areas have the change of the thickness within mitres, where both
/// reinforcements end (up to 1.7 % at 0.1034), and at oblique ends (up to 3.7 %).
#[test]
fn areas_between_the_stations_are_those_of_the_layers() {
    for file in ["windio1_iea15", "windio2_iea34"] {
        let layup = blade(file);
        let mut worst = (0.0, String::new());
        let hundredths = (0..=100).map(|i| f64::from(i) / 100.0);
        for eta in hundredths.chain([0.1034, 0.4483]) {
            let meshed = layup.mesh(eta);
            let meshed = meshed.unwrap_or_else(|problems| panic!("{file} {eta}: {problems}"));
            for area in areas::large(&meshed.areas) {
                let error = areas::error(area).abs();
                if error > worst.0 {
                    worst = (error, format!("{eta} {}", area.name));
                }
            }
        }
        println!("{file}: {worst:?}");
        assert!(worst.0 < 3e-3, "{file}: {worst:?}");
    }
}

/// The trailing edge is closed over the thickness of the layers, and the space behind the last web is a
/// hole of its own: where the layers of both sides fit beside each other on the base of IEA-15, from
/// 0.44 to 0.45, both sides were joined in one node, and the boundary of the hole counted as the outer
/// one. The outer boundary is at most as long as the contour.
#[test]
fn both_sides_are_joined_at_the_trailing_edge() {
    let layup = blade("windio1_iea15");
    for eta in [0.3, 0.4, 0.43, 0.44, 0.445, 0.449, 0.455, 0.6, 0.8] {
        let input = section(&layup, eta).section;
        let all: Vec<usize> = (0..input.mesh.cells.len()).collect();
        let perimeter = Perimeter::of(&input.mesh, &all);
        let made = layup.section(eta).expect("a section");
        let outline = Outline::new(&made.contour).expect("a contour");
        println!("{eta} {perimeter:?} {}", outline.perimeter());
        let webs = made.webs.iter().filter(|web| !web.plies.is_empty()).count();
        assert_eq!(
            (perimeter.outer.len(), perimeter.holes.len()),
            (1, webs + 1),
            "{eta}"
        );
        let part = perimeter.outer_length() / outline.perimeter();
        assert!(part > 0.98 && part < 1.0 + 1e-4, "{eta}: {part}");
    }
}

/// A ply of a web that fades out is absent where it is thinner than a thousandth of the cells, and
/// the remark names it: cells 1686 times as long as thick had no solution. A thin coat is no such ply.
#[test]
fn a_ply_that_fades_out_is_absent() {
    let text = "units = \"SI\"
[shape]
chord = 1
naca = \"0018\"
[[layer]]
name = \"coat\"
material = \"soft\"
thickness = 1e-5
[[layer]]
name = \"skin\"
material = \"stiff\"
thickness = 2e-3
[[web]]
name = \"web\"
at = { x = 0.4 }
[[web.plies]]
name = \"fore\"
material = \"stiff\"
thickness = 1e-3
[[web.plies]]
name = \"filler\"
material = \"soft\"
thickness = { eta = [0, 1], value = [0.01, 0], course = \"linear\" }
[[web.plies]]
name = \"aft\"
material = \"stiff\"
thickness = 1e-3
[material.stiff]
young = 20e9
poisson = 0.3
density = 1900
[material.soft]
young = 50e6
poisson = 0.3
density = 100
";
    let layup = parse(text, std::path::Path::new("a.layup.toml"));
    let layup = layup.unwrap_or_else(|problems| panic!("{problems}"));
    // cells of 17 mm
    let stations = [0.0, 0.9, 0.998, 0.999, 0.9995];
    let remarks = layup.faded_layers(&stations);
    let expected = "line 20: layer \"filler\" is thinner than a thousandth of the cells, and absent: \
                    eta 0.999, 0.9995";
    assert_eq!(remarks, [expected]);
    let stiffness = stations.map(|eta| {
        let solution = analyze(&section(&layup, eta).section);
        let solution = solution.unwrap_or_else(|failure| panic!("{eta}: {failure}"));
        measures(&solution)
    });
    // the filler of 20 um has a five hundredth of the stiffness of the web
    for (thin, none) in stiffness[2].iter().zip(stiffness[3]) {
        assert!((thin / none - 1.0).abs() < 1e-3, "{thin} {none}");
    }
}

/// Between the root and the first airfoil of IEA-15 the contour goes from a circle to a base with
/// a hook before its corner; the wall is as thick as the base is long. All of it is meshed, and
/// every layer of more than 1 % has its area on the curved surface with mitred corners within 0.5 %,
/// or 1 % beside the hook of IEA-10, whose curvature changes within the thickness of the wall.
#[test]
fn bases_that_begin_are_walls() {
    for (file, most, etas) in [
        (
            "windio1_iea15",
            5e-3,
            [0.02, 0.035, 0.045, 0.052, 0.0612, 0.069, 0.09],
        ),
        (
            "windio2_iea10",
            1e-2,
            [0.03, 0.06, 0.08, 0.095, 0.1034, 0.11, 0.12],
        ),
    ] {
        let layup = blade(file);
        for eta in etas {
            let meshed = layup.mesh(eta);
            let meshed = meshed.unwrap_or_else(|problems| panic!("{file} {eta}: {problems}"));
            let total: f64 = meshed.areas.iter().map(|area| area.meshed).sum();
            for area in &meshed.areas {
                let error = area.meshed / area.nominal - 1.0;
                println!("{file} {eta} {} {error:.5}", area.name);
                assert!(
                    error.abs() < most || area.meshed < 0.01 * total,
                    "{file} {eta}: {} {error}",
                    area.name
                );
            }
        }
    }
}

/// Largest differences from the independent mesher: mass, EA, flap, edge, GJ. Its edges, ramps and
/// cells are others, which counts at the thin tips and in the small contacts of rear edges; it cuts
/// 0.6 % of the wall of IEA-15 at 0.05, where ours runs around.
const MESHER: [(&str, [f64; 5]); 4] = [
    ("iea22", [2e-3, 2e-3, 2e-3, 6e-3, 5e-3]),
    ("iea15", [7e-3, 7e-3, 1e-2, 8e-3, 1e-2]),
    ("iea34", [5e-3, 6e-3, 5e-3, 2.5e-2, 2e-2]),
    ("iea10", [5e-3, 5e-3, 5e-3, 1e-2, 1e-2]),
];
/// Largest differences from the published IEA-22, made with another program on its own mesh.
const PUBLISHED: [f64; 5] = [6e-3, 4e-3, 1e-2, 1.6e-2, 2e-2];

/// Stations of IEA-22 at which the published section is another one: at 0.172 it has 0.5 % more mass and a
/// tension center that is 17 mm farther aft, thus more at its trailing edge than the layup; at 0.517,
/// beside the end of a web, it is the mean of both sides.
const OTHERS: [f64; 2] = [0.172, 0.517];

/// The published matrices of the other blades are not of their layups.
#[test]
fn sections_of_public_blades_from_their_files() {
    for [name, file] in BLADES {
        let layup = blade(file);
        let (_, most) = MESHER.iter().find(|one| one.0 == name).expect("a blade");
        for (i, station) in stations(name).iter().enumerate() {
            let eta = number(&station["eta"]);
            let is_meshed = layup.mesh(eta).is_ok() && station["our"].is_object();
            // the edge of the tip is closed by stretched layers: 2 % of its torsion
            let is_left = i % 3 != 1 && !effort::is_long();
            if is_left || !is_meshed || eta > 0.99 {
                continue;
            }
            let [ours, published] = differences(&layup, station, ["our", "pub"]);
            println!("{name} {eta} {ours:.4?} {published:.4?}");
            let is_within = |found: [f64; 5], most: &[f64; 5]| {
                found
                    .iter()
                    .zip(most)
                    .all(|(found, most)| found.abs() < *most)
            };
            let mut most = *most;
            // both sides are joined over the thickness of the layers, there in one node
            if (name, eta) == ("iea10", 0.928051) {
                most[4] = 5e-2;
            }
            // the independent mesher cuts layers of the trailing edge there: its areas are 1.1 % off
            if name == "iea22" && (eta - 0.586).abs() < 1e-3 {
                most[3] = 7e-3;
            }
            assert!(is_within(ours, &most), "{name} {eta}: {ours:?}");
            let is_other = OTHERS.iter().any(|other| (eta - other).abs() < 0.01);
            let is_published = name == "iea22" && eta > 0.1 && eta < 0.9 && !is_other;
            assert!(
                !is_published || is_within(published, &PUBLISHED),
                "{name} {eta}: {published:?}"
            );
        }
    }
}
