//! The blade of a layup under a dead load, and the reserve factors of its plies under the internal
//! forces of the equilibrium and of a slow motion.
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

/// Five equal cycles of the load, of 20 s each: a hundred periods of the first mode, 5 Hz.
const MOTION: &str = "
units = \"SI\"
[[blade]]
name = \"blade\"
file = \"b/a.blade.json\"
elements = 20
[[distributed_load]]
blade = \"blade\"
force = [0, 0, 200]
drive = \"gust\"
[drives.gust]
expression = \"1 - cos(2*pi*t/20)\"
[transient]
to = 100
step = 0.5
[[output.column]]
name = \"root\"
quantity = \"internal_force\"
of = \"blade/beam 1\"
[[output.column]]
name = \"tip\"
quantity = \"internal_force\"
of = \"blade/beam 20\"
point = 2
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

/// Solves the blade at some stations; writes a model with it.
fn solved(folder: &Path, stations: &str, model: &str) {
    let layup = Path::new(env!("CARGO_MANIFEST_DIR")).join(LAYUP);
    let text = std::fs::read_to_string(layup).unwrap() + STRENGTHS;
    std::fs::write(folder.join("a.layup.toml"), text).unwrap();
    std::fs::write(folder.join("m.dynamics.toml"), model).unwrap();
    let blade = "section-analyzer blade @a.layup.toml --out @b --no-figures --stations";
    run(folder, &format!("{blade} {stations}"));
}

#[test]
fn forces_of_statics_are_the_loads_of_strength() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    solved(folder, "0,0.1,0.3,0.6,0.8,1", MODEL);
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

// The range of the shear at the root is 400 N/m times the length, up to the acceleration of the blade: the
// square of the ratio of the frequencies, 1e-4, times 12.4/8 for the mass at the tip; accepted 5e-4. Five
// equal cycles in a hundred, one for each second, have the equivalent range R (5/100)^(1/m); the start from
// rest leaves an oscillation of 1e-4.
#[test]
fn forces_of_a_motion_have_their_damage_equivalent_ranges() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    solved(folder, "0,1", MOTION);
    run(
        folder,
        "beam-dynamics transient @m.dynamics.toml --out @r --no-figures",
    );
    // the evaluation points of elements of a twentieth of the length
    let point = |from: f64, sign: f64| from + 0.025 * (1.0 + sign / 3.0_f64.sqrt());
    let [root, tip] = [point(0.0, -1.0), point(0.95, 1.0)];
    let strength = "section-analyzer strength @b/a.blade.json --loads @r/m.transient.csv";
    run(
        folder,
        &format!("{strength} --at root={root} --at tip={tip}"),
    );
    let number = |text: &String| text.parse::<f64>().unwrap();
    let span = columns(&folder.join("b/a.span.csv"), ["arc_length [m]"]);
    let length = number(&span.last().unwrap()[0]);
    let names = [
        "eta [-]",
        "component",
        "cycles [-]",
        "largest_range",
        "exponent [-]",
        "equivalent_range",
    ];
    let rows = columns(&folder.join("b/a.fatigue.csv"), names);
    let mut square = 0.0;
    for row in rows.iter().filter(|row| number(&row[0]) == 0.0) {
        let [range, exponent, equivalent] = [3, 4, 5].map(|index| number(&row[index]));
        if !row[1].starts_with("shear") {
            continue;
        }
        assert_eq!(number(&row[2]), 5.0, "{row:?}");
        let expected = range * 0.05_f64.powf(exponent.recip());
        assert!((equivalent / expected - 1.0).abs() < 5e-4, "{row:?}");
        square += if exponent == 4.0 { range * range } else { 0.0 };
    }
    let error = square.sqrt() / (400.0 * length) - 1.0;
    assert!(error.abs() < 5e-4, "{error:e}");
}
