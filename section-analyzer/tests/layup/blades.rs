//! Sections of public blades: areas of the layers and properties, compared with an independent
//! prototype and, for IEA-22, with the published blade.

use section_analyzer::mesh::generate::layup::{LayupProblem, MeshedLayup};
use serde_json::Value;

use crate::areas;
use crate::sections::{Case, cases, number, reference, solved_with_center};

/// Measures of the reference, in the order of [`solved`].
const MEASURES: [&str; 5] = ["mass", "EA", "flap", "edge", "GJ"];

/// The results of a case, if the reference has them.
fn row<'a>(results: &'a Value, case: &Case) -> Option<&'a Value> {
    let name = |row: &Value| {
        let blade = row["blade"].as_str().unwrap_or_default().to_owned();
        format!("{blade} at {}", number(&row["eta"]))
    };
    let rows = results["sections"].as_array().expect("sections");
    rows.iter().find(|row| name(row) == case.name)
}

/// Layers of more than 1 % of the section: within 0.5 % of thickness times length, with the
/// curvature and without the part that contacts cut.
fn check_areas(case: &Case, meshed: &MeshedLayup, row: &Value) {
    for area in areas::large(&meshed.areas) {
        let expected = &row["areas"][&area.name];
        if expected.is_array() {
            let error = area.meshed / number(&expected[3]) - 1.0;
            assert!(error.abs() < 5e-3, "{}: {} {error}", case.name, area.name);
        }
    }
}

/// The prototype has ramps and cells of its own: 0.2 %, torsion 0.5 %. The published blade of
/// IEA-22 at 0.414 is another program's, on its own mesh: the same.
#[test]
fn sections_of_public_blades() {
    let results = reference("results.json");
    for case in cases() {
        let made = case.section.generate();
        let meshed = made.unwrap_or_else(|problem| panic!("{}: {problem}", case.name));
        let (found, center) = solved_with_center(&case, &meshed);
        let Some(row) = row(&results, &case) else {
            continue;
        };
        check_areas(&case, &meshed, row);
        let sources: &[&str] = match case.name.as_str() {
            "iea22 at 0" | "iea22 at 0.414" => &["our", "pub"],
            _ => &["our"],
        };
        check_center(&case, row, (center, sources));
        for (key, value) in MEASURES.iter().zip(found) {
            let tolerance = if *key == "GJ" { 5e-3 } else { 2e-3 };
            for source in sources {
                let error = value / number(&row[*source][*key]) - 1.0;
                println!("{} {key} {source}: {:.3} %", case.name, 100.0 * error);
                assert!(
                    error.abs() < tolerance,
                    "{} {key} {source}: {error}",
                    case.name
                );
            }
        }
    }
}

/// Tension centers within 2 mm of the prototype's, and of the published ones at the same sections.
fn check_center(case: &Case, row: &Value, (center, sources): ([f64; 2], &[&str])) {
    for source in sources {
        let errors = ["yt", "zt"].map(|key| number(&row[*source][key]));
        let errors = [0, 1].map(|i| 1e3 * (center[i] - errors[i]));
        println!("{} tension center {source}: {errors:.3?} mm", case.name);
        assert!(
            errors.iter().all(|error| error.abs() < 2.0),
            "{}: {errors:?}",
            case.name
        );
    }
}

/// A first layer of which both sides need more than the height of the section at half of the chord.
#[test]
fn a_first_layer_thicker_than_the_section_is_named() {
    let all = cases();
    assert!(!all.is_empty());
    for mut case in all {
        let first = &mut case.section.layers[0];
        (first.from, first.to, first.thickness) = (0.0, 1.0, 1e3);
        let name = first.name.clone();
        match case.section.generate() {
            Err(LayupProblem::Tight {
                layer,
                thickness,
                radius,
                ..
            }) => assert!(
                // a round root counts the layers inside too
                (layer == name || thickness > 1e3) && thickness >= 1e3 && radius < 10.0,
                "{}: {layer} {thickness} {radius}",
                case.name
            ),
            other => panic!("{}: {other:?}", case.name),
        }
    }
}
