//! Spars meshed by columns against the first generator of `mesh blade`, which placed the nodes beside
//! mitres by another rule: `tests/reference/sections/spars`, a box-spar with caps that end at the
//! webs, and a D-spar with plies that begin, end, are replaced, or are in the web only.

use std::path::{Path, PathBuf};

use nalgebra::Matrix6;
use section_analyzer::analysis::{analyze, discretization_error};
use section_analyzer::input::{self, blade};
use serde_json::Value;
use shared_geom::gmsh;

fn reference(file: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/reference/sections/spars");
    folder.join(file)
}

/// The largest entry of a matrix, of sqrt(Kii Kjj).
fn largest(matrix: &Matrix6<f64>, k: &Matrix6<f64>) -> f64 {
    Matrix6::from_fn(|i, j| matrix[(i, j)] / (k[(i, i)] * k[(j, j)]).sqrt()).amax()
}

/// Both meshes have the same cells, and only nodes beside mitres are at other places on the faces of
/// their plies: 5.6e-5, a hundredth of the estimate of the error of the cells.
#[test]
fn spars_have_the_stiffness_of_the_first_generator() {
    let text = std::fs::read_to_string(reference("stiffness.json")).expect("the reference");
    let value: Value = serde_json::from_str(&text).expect("JSON");
    for name in ["box", "d_spar"] {
        let made = blade::read(&reference(&format!("{name}.blade.toml")));
        let made = made.unwrap_or_else(|problems| panic!("{problems}"));
        let folder = tempfile::tempdir().expect("a folder");
        let file = format!("{name}.section.toml");
        std::fs::write(
            folder.path().join(format!("{name}.msh")),
            gmsh::write(&made.mesh),
        )
        .expect("a mesh");
        std::fs::copy(reference(&file), folder.path().join(&file)).expect("a section file");
        let read = input::read(&folder.path().join(&file));
        let section = read.unwrap_or_else(|problems| panic!("{problems}")).section;
        let stiffness = analyze(&section).expect("a solution").stiffness;
        let error = discretization_error(&section, &stiffness).expect("an estimate");
        let known = |i: usize, j: usize| value[name][i][j].as_f64().expect("a number");
        let known = Matrix6::from_fn(known);
        let difference = largest(&(stiffness - known), &known);
        let estimate = largest(&error.stiffness, &known);
        println!("{name}: difference {difference:e}, error {estimate:e}");
        assert!(
            difference < estimate.min(1e-4),
            "{name}: {difference:e} {estimate:e}"
        );
    }
}
