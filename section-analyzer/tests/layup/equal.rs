//! A section of `mesh blade` as a layup: equal within the errors of both meshes.

use std::path::{Path, PathBuf};

use nalgebra::Matrix6;
use section_analyzer::analysis::{analyze, discretization_error};
use section_analyzer::input::{self, layup};
use section_analyzer::section::Section;

use crate::files::section;

/// Stiffness of a section, and the estimate of its error.
fn solved(section: &Section) -> [Matrix6<f64>; 2] {
    let stiffness = analyze(section).expect("a solution").stiffness;
    let error = discretization_error(section, &stiffness).expect("an estimate");
    [stiffness, error.stiffness]
}

/// The largest difference of two stiffnesses, and the largest sum of both errors, of sqrt(Kii Kjj).
fn compare([a, error_a]: [Matrix6<f64>; 2], [b, error_b]: [Matrix6<f64>; 2]) -> [f64; 2] {
    let largest = |m: Matrix6<f64>| {
        let scaled = Matrix6::from_fn(|i, j| m[(i, j)] / (b[(i, i)] * b[(j, j)]).sqrt());
        scaled.amax()
    };
    [largest(a - b), largest(error_a.abs() + error_b.abs())]
}

/// A folder of the case of the active-twist blade.
fn active_twist(file: &str) -> PathBuf {
    let folder =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../cases/section/active_twist_section");
    folder.join(file)
}

/// The section of the active-twist blade as a layup with cells of this length [in]: a skin, and a
/// spar to 40 % of the chord, from the outside in six active plies from 5 % of the chord to the web,
/// which a filler replaces elsewhere, each on a ply of glass, then carbon and glass.
fn active_twist_layup(size: f64) -> String {
    let file = std::fs::read_to_string(active_twist("active_twist_section.section.toml"));
    let file = file.expect("a section file");
    let [from, to] = ["[units]", "[[region]]"].map(|word| file.find(word).expect("a table"));
    let mut text = file[from..to].to_owned();
    text += "[shape]\nnaca = \"0012\"\nchord = 16.3968\norigin = 0.25\n";
    text += &format!("[mesh]\nsize = {size}\n");
    let mut layer = |name: &str, material: &str, thickness: f64, rest: &str| {
        text += &format!(
            "[[layer]]\nname = {name:?}\nmaterial = {material:?}\nthickness = {thickness}\n{rest}\n"
        );
    };
    const GLASS: f64 = 0.0051;
    let web = "web = \"rear\"";
    let end = |key: &str, side: &str| format!("{key} = {{ x = 0.05, side = {side:?} }}");
    layer("skin", "glass_45", GLASS, "");
    for i in 0..6 {
        let angle = format!("fiber_angle = {}\ntoward = \"contour\"", [-45, 45][i % 2]);
        let above = format!("{angle}\nfrom = \"rear.suction\"\n{}", end("to", "suction"));
        let below = format!(
            "{angle}\n{}\nto = \"rear.pressure\"",
            end("from", "pressure")
        );
        let filler = format!(
            "{web}\n{}\n{}",
            end("from", "suction"),
            end("to", "pressure")
        );
        layer(&format!("filler{i}"), "glass_45", 0.0055, &filler);
        layer(&format!("upper{i}"), "afc", 0.0055, &above);
        layer(&format!("lower{i}"), "afc", 0.0055, &below);
        layer(&format!("glass{i}"), "glass_45", GLASS, web);
    }
    layer("carbon", "t300", 9.0 * 0.00492, web);
    layer("inner", "glass_45", GLASS, web);
    text + "[[web]]\nname = \"rear\"\nat = { x = 0.4 }\nplies = []\n"
}

/// The spar of the active-twist blade, mitred at its web: 7.3e-4 of sqrt(Kii Kjj) with these cells.
/// Plies of the web that stand on the surfaces, without mitres, make a difference of 9.2e-3 with
/// cells of any size.
#[test]
fn the_active_twist_section_is_the_same_as_a_layup() {
    let before = input::read(&active_twist("medium.section.toml"));
    let before = before.unwrap_or_else(|problems| panic!("{problems}"));
    let layup = layup::parse(&active_twist_layup(0.28), Path::new("a.layup.toml"));
    let layup = layup.unwrap_or_else(|problems| panic!("{problems}"));
    let now = section(&layup, 0.0);
    println!(
        "{} {} nodes",
        before.section.mesh.nodes.len(),
        now.section.mesh.nodes.len()
    );
    let [difference, error] = compare(solved(&now.section), solved(&before.section));
    println!("active twist: difference {difference:e}, errors {error:e}");
    assert!(difference < error, "{difference:e} {error:e}");
}
