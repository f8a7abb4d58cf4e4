//! All stations of the public blades, meshed from their windIO files, and some of them solved.

use section_analyzer::analysis::analyze;
use section_analyzer::input::layup::Layup;
use section_analyzer::mesh::generate::layup::LayerArea;
use serde_json::Value;

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
fn worst_area(layup: &Layup, station: &Value) -> Result<(String, f64), String> {
    let eta = number(&station["eta"]);
    let meshed = layup.mesh(eta).map_err(|problems| problems.to_string())?;
    let total: f64 = meshed.areas.iter().map(|area| area.meshed).sum();
    let expected = station["areas"].as_object();
    let of = |name: &str| {
        let mut all = expected?.iter();
        let found = all.find(|(known, _)| known.eq_ignore_ascii_case(name))?;
        Some(number(&found.1[1]))
    };
    let large = meshed
        .areas
        .iter()
        .filter(|area| area.meshed > 0.01 * total);
    let error = |area: &LayerArea| {
        let errors = [of(&area.name)?, area.nominal].map(|other| area.meshed / other - 1.0);
        let least = errors
            .into_iter()
            .min_by(|a, b| a.abs().total_cmp(&b.abs()));
        Some((area.name.clone(), least?))
    };
    let worst = large.filter_map(error);
    let worst = worst.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
    Ok(worst.unwrap_or((String::new(), 0.0)))
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

/// Areas of the layers are within 0.5 % at 69 of the 76 stations. At five more one or two layers
/// are up to 2.2 % off: inner skins and layers of the trailing edge that contacts cut between two
/// stations. The tip of IEA-10 is refused by the name of a layer: walls of 14 mm in a nose of 8 mm.
#[test]
fn all_stations_of_public_blades_are_meshed() {
    let mut counts = [0, 0, 0];
    for [name, file] in BLADES {
        let layup = blade(file);
        for station in stations(name) {
            let eta = number(&station["eta"]);
            match worst_area(&layup, &station) {
                Err(problem) => {
                    println!("{name} {eta}: {problem}");
                    assert!(problem.contains("layer \""), "{problem}");
                    assert!((name, eta) == ("iea10", 1.0), "{name} {eta}: {problem}");
                    counts[2] += 1;
                }
                Ok((layer, error)) => {
                    println!("{name} {eta}: {layer} {:.3} %", 100.0 * error);
                    assert!(error.abs() < 0.025, "{name} {eta}: {layer} {error}");
                    counts[usize::from(error.abs() > 5e-3)] += 1;
                }
            }
        }
    }
    assert!(counts[0] >= 69 && counts[2] == 1, "{counts:?}");
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
    ("iea34", [5e-3, 5e-3, 5e-3, 2.5e-2, 2e-2]),
    ("iea10", [5e-3, 5e-3, 5e-3, 1e-2, 1e-2]),
];
/// Largest differences from the published IEA-22, made with another program on its own mesh.
const PUBLISHED: [f64; 5] = [6e-3, 4e-3, 1e-2, 1.6e-2, 2e-2];

/// The published matrices of the other blades are not of their layups; at 0.517, beside the end of
/// a web, the published one is the mean of both sides.
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
            assert!(is_within(ours, most), "{name} {eta}: {ours:?}");
            let is_published =
                name == "iea22" && eta > 0.1 && eta < 0.9 && (eta - 0.517).abs() > 0.01;
            assert!(
                !is_published || is_within(published, &PUBLISHED),
                "{name} {eta}: {published:?}"
            );
        }
    }
}
