//! `analyze --mesh-error`: the file, the table, refused requests.

use crate::workplace::Workplace;

const FILE: &str = "results/a.mesh_error.json";
const REQUEST: [&str; 3] = ["analyze", "a.section.toml", "--mesh-error"];

fn json(workplace: &Workplace, file: &str) -> serde_json::Value {
    serde_json::from_str(&workplace.read(file)).unwrap()
}

fn entry(matrix: &serde_json::Value, i: usize, j: usize) -> f64 {
    matrix[i][j].as_f64().unwrap()
}

/// Two square cells of 4 nodes: bending is too stiff by the curvature in the plane that they
/// cannot have, by some per cent, and their axial stiffness is exact.
#[test]
fn errors_are_in_the_file_and_in_the_report() {
    let workplace = Workplace::with(&[], &[]);
    let run = workplace.run(&REQUEST);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert!(run.out.contains(&format!("\n  {FILE}\n")), "{}", run.out);

    let file = json(&workplace, FILE);
    assert_eq!(file["format"], "helicoid section mesh error");
    // 6 nodes; alone between two faces, the cells become eight ones of 9 nodes, with 45
    assert_eq!(file["unknowns"], serde_json::json!([18, 135]));
    let properties = json(&workplace, "results/a.properties.json");
    assert_eq!(file["stiffness"], properties["stiffness"]);
    assert_eq!(file["input"], properties["provenance"]["input_hash"]);
    let [stiffness, error, relative] =
        ["stiffness", "error", "relative_error"].map(|key| &file[key]);
    assert!(entry(relative, 0, 0) < 1e-10);
    // all diagonal entries are too large; about the centroid E J = E 0.001^3 0.002 / 12
    for i in 1..6 {
        let size = entry(error, i, i) / entry(stiffness, i, i);
        assert!(size > 1e-3 && size < 1.0, "{i}: {size}");
        assert!((size / entry(relative, i, i) - 1.0).abs() < 1e-12);
    }
    // axial-shear y is zero by symmetry
    assert!(entry(relative, 0, 1) < 1e-10);

    let report = workplace.read("results/a.report.txt");
    assert!(run.out.starts_with(&report));
    let part = report
        .split("\nDiscretization error of the stiffness")
        .nth(1);
    let lines: Vec<_> = part.unwrap().lines().take(10).collect();
    assert_eq!(lines[1], "  (135 unknowns, 7.5 times as many)");
    let axial: Vec<_> = lines[3].split_whitespace().collect();
    assert_eq!(axial[..3], ["axial", "0", "(0)"], "{report}");
    let torsion: Vec<_> = lines[6].split_whitespace().collect();
    let shown: f64 = torsion[4].parse().unwrap();
    assert!((shown / entry(relative, 3, 3) - 1.0).abs() < 0.06);
}

/// The file belongs to the run that requested it.
#[test]
fn a_run_without_the_option_removes_the_file() {
    let workplace = Workplace::with(&[], &[]);
    workplace.run(&REQUEST);
    let again = workplace.run(&REQUEST);
    assert!(again.out.contains("Unchanged since"), "{}", again.out);
    let run = workplace.run(&["analyze", "a.section.toml"]);
    assert!(!run.out.contains("Discretization error"), "{}", run.out);
    let removed = format!("\nRemoved: results of an earlier run\n  {FILE}\n");
    assert!(run.out.ends_with(&removed), "{}", run.out);
    assert!(!workplace.path(FILE).exists());
}

/// A failed analysis leaves no estimate of an earlier one.
#[test]
fn a_failed_run_removes_the_file() {
    let workplace = Workplace::with(&[], &[]);
    workplace.run(&REQUEST);
    let text = workplace.read("a.section.toml");
    let web = "group = \"web\"\nmaterial = \"steel\"";
    let air = "group = \"web\"\nmaterial = \"air\"";
    let soft = "\n[material.air]\nyoung = 1e-20\npoisson = 0\ndensity = 1\n";
    workplace.write("a.section.toml", &(text.replace(web, air) + soft));
    let run = workplace.run(&REQUEST);
    assert_eq!(run.code, 1, "{}", run.err);
    assert!(!workplace.path(FILE).exists());
}
