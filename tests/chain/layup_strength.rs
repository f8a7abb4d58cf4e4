//! The blade of a layup under a dead load, and the reserve factors of its plies under the internal
//! forces of this equilibrium.
//!
//! Closed form: a load p per length that keeps its direction has the resultant p (L - s) outboard of
//! the arc length s, however large the deflection is: it is the size of the force that `strength`
//! uses at each station. Tolerance: forces are linear between the evaluation points of 20 elements,
//! and the direction of the section turns by some degrees from one to the next: the square of the
//! turn over 8, 1e-4.

use std::path::Path;

const LAYUP: &str = "cases/section/layup_blade/layup_blade.layup.toml";
const STRENGTHS: &str = "
[material.triax.strength]
xt = 1.1e9
xc = 0.7e9
yt = 0.1e9
yc = 0.2e9
s12 = 0.1e9
";
const MODEL: &str = "
units = \"SI\"
[[blade]]
name = \"blade\"
file = \"b/a.blade.json\"
elements = 20
[[distributed_load]]
blade = \"blade\"
force = [0, 0, 400]
[static]
steps = 2
";

/// Runs a program in a folder.
fn run(folder: &Path, words: &str) {
    let place = |word: &str| match word.strip_prefix('@') {
        Some(file) => folder.join(file).display().to_string(),
        None => word.to_owned(),
    };
    let words = words.split_whitespace().map(|word| place(word).into());
    let words: Vec<std::ffi::OsString> = words.collect();
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let code = if words[0] == "section-analyzer" {
        section_analyzer::cli::run(words, &mut out, &mut err)
    } else {
        beam_dynamics::cli::run(words, &mut out, &mut err)
    };
    assert_eq!(code, 0, "{}", String::from_utf8_lossy(&err));
}

/// Columns of the rows of a table, as text.
fn columns<const N: usize>(file: &Path, names: [&str; N]) -> Vec<[String; N]> {
    let mut table = csv::Reader::from_path(file).unwrap();
    let heads = table.headers().unwrap().clone();
    let index = |name| heads.iter().position(|head| head == name).unwrap();
    let indices = names.map(index);
    let rows = table.records().map(|row| {
        let row = row.unwrap();
        indices.map(|index| row[index].to_owned())
    });
    rows.collect()
}

#[test]
fn forces_of_statics_are_the_loads_of_strength() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let layup = Path::new(env!("CARGO_MANIFEST_DIR")).join(LAYUP);
    let text = std::fs::read_to_string(layup).unwrap() + STRENGTHS;
    std::fs::write(folder.join("a.layup.toml"), text).unwrap();
    std::fs::write(folder.join("m.dynamics.toml"), MODEL).unwrap();
    let blade = "section-analyzer blade @a.layup.toml --out @b --no-figures --stations";
    run(folder, &format!("{blade} 0,0.1,0.3,0.6,0.8,1"));
    run(
        folder,
        "beam-dynamics static @m.dynamics.toml --out @r --no-figures",
    );
    run(
        folder,
        "section-analyzer strength @b/a.blade.json --loads @r/m.forces.csv",
    );
    let span = columns(&folder.join("b/a.span.csv"), ["section", "arc_length [m]"]);
    let names = [
        "section",
        "instant",
        "axial [N]",
        "shear_y [N]",
        "shear_z [N]",
    ];
    let rows = columns(&folder.join("b/a.strength.csv"), names);
    let number = |text: &String| text.parse::<f64>().unwrap();
    let length = number(&span.last().unwrap()[1]);
    for [section, arc] in &span {
        let own = rows.iter().filter(|row| row[0] == *section);
        let mut count = 0;
        for row in own.filter(|row| row[1] == "step 2") {
            let force = row[2..]
                .iter()
                .map(|text| number(text).powi(2))
                .sum::<f64>()
                .sqrt();
            let error = force / 400.0 - (length - number(arc));
            assert!(error.abs() < 1e-4 * length, "{row:?}: {error}");
            count += 1;
        }
        assert!(count > 0, "{section}: {rows:?}");
    }
}
