//! The numbers of the page of `cases/dynamics/bearingless`.

use beam_dynamics::analysis::trim::{Trimmed, trim};
use beam_dynamics::input;

use super::case_files::{Case, frequency};

/// Soft lag modes that the snubber damps, and torsion on flexbeam and pitch link, as on the page. The
/// blades see each other by the inflow of collective modes only, so that the others are equal.
#[test]
fn modes_of_the_page() {
    let table = Case::new("bearingless").modes("modes.dynamics.toml");
    let at = table.speeds.len() - 2;
    let revolution = 395.0 / 60.0;
    let lag = frequency(&table, "lag 1 regressive", at);
    assert!((lag / revolution - 0.604).abs() < 1e-3, "{lag}");
    let torsion = frequency(&table, "torsion 1 collective", at);
    assert!((torsion - 32.70).abs() < 0.01, "{torsion}");
    let points = table.at_speed(at).into_iter();
    let lags = points.filter(|(branch, _)| branch.name.starts_with("lag 1"));
    let found: Vec<_> = lags.map(|(_, point)| point.damping_ratio).collect();
    assert_eq!(found.len(), 4);
    for damping in &found {
        assert!((0.0167..0.0195).contains(damping), "{found:?}");
    }
}

/// Collective for the largest thrust of the page, and the pitch that reaches the root.
#[test]
fn hover_of_the_page() {
    let case = Case::new("bearingless");
    let file = "hover.dynamics.toml";
    case.replace(file, "[15000, 20000, 25000]", "[25000]");
    let path = case.path(file);
    let text = std::fs::read_to_string(&path).unwrap();
    let read = |given: &[(String, f64)]| input::parse_with(&text, &path, given);
    let parsed = read(&[]).unwrap_or_else(|problems| panic!("{problems}"));
    let outcome = trim("hover", parsed.trim.as_ref().unwrap(), &read);
    let point = &outcome.result.points[0];
    assert_eq!(point.failure, None);
    assert!((point.controls[0] - 5.637).abs() < 1e-3, "{point:?}");
    assert!((point.targets[0][0] / 25000.0 - 1.0).abs() < 1e-9);
    let Some(Trimmed::Static(found)) = outcome.end.and_then(|end| end.found) else {
        panic!("no equilibrium");
    };
    let last = found.last().unwrap();
    let root = found
        .nodes
        .iter()
        .position(|node| node.label == "main 1/root")
        .unwrap();
    let turn = last.rotations[root] * found.nodes[root].rotation.transpose();
    let pitch = shared_geom::rotation::vector::from_rotation(&turn)
        .x
        .to_degrees();
    assert!((pitch - 5.546).abs() < 2e-3, "{pitch}");
    let sections = last
        .sections
        .iter()
        .filter(|own| own.beam.contains("flexbeam"));
    let tension = sections
        .map(|own| own.internal_force[0])
        .fold(0.0, f64::max);
    assert!((tension / 127_200.0 - 1.0).abs() < 1e-3, "{tension}");
}
