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
[output]
span_forces = true
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
[output]
span_forces = true
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
        "section-analyzer strength @b/a.blade.json --loads @r/m.static.blade.forces.csv",
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
    let strength =
        "section-analyzer strength @b/a.blade.json --loads @r/m.transient.blade.forces.csv";
    run(folder, strength);
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

/// Reserve factors by section and ply after `strength` with the tables `loads`.
fn reserves(folder: &Path, loads: &str) -> Vec<([String; 3], f64)> {
    run(
        folder,
        &format!("section-analyzer strength @b/a.blade.json {loads}"),
    );
    let names = ["section", "ply", "instant", "reserve_factor [-]"];
    let rows = columns(&folder.join("b/a.strength.csv"), names);
    let row = |[section, ply, instant, factor]: [String; 4]| {
        ([section, ply, instant], factor.parse::<f64>().unwrap())
    };
    rows.into_iter().map(row).collect()
}

// The envelope has the force at the instant of the largest load at each point, which governs: the load
// and its response are one cycle up from zero. Neighboring points have their largest force within a
// step of each other, over which a cosine at its top changes by (2 pi 0.5/20)^2/2 = 1.2 %; a table
// cannot have a smaller reserve factor than its history but by the line between two points. The instants of the
// extremes are instants of the history: no smaller factor, and larger only where an instant without an extreme
// governs. Of two tables the smaller one counts.
#[test]
fn envelopes_and_several_tables_are_loads() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let motion = MOTION.replace("to = 100", "to = 20");
    solved(folder, "0,0.4", &format!("{motion}[static]\nsteps = 2\n"));
    let begin = |command: &str| {
        let words = format!("beam-dynamics {command} @m.dynamics.toml --out @r --no-figures");
        run(folder, &words);
    };
    begin("transient");
    begin("static");
    let table = |name: &str| format!("--loads @r/m.{name}.csv");
    let [history, envelope, state] = [
        "transient.blade.forces",
        "transient.blade.envelope",
        "static.blade.forces",
    ]
    .map(table);
    let whole = reserves(folder, &history);
    let extremes = reserves(folder, &envelope);
    assert!(whole.len() > 4 && whole.len() == extremes.len());
    for (whole, extreme) in whole.iter().zip(&extremes) {
        assert_eq!(whole.0[..2], extreme.0[..2]);
        let ratio = extreme.1 / whole.1;
        assert!((ratio - 1.0).abs() < 5e-3, "{whole:?} {extreme:?}");
        assert!(extreme.0[2].starts_with("case ") && whole.0[2].starts_with("time "));
    }
    let instants = reserves(folder, &table("transient.blade.extremes"));
    assert_eq!(whole.len(), instants.len());
    for (whole, instant) in whole.iter().zip(&instants) {
        let ratio = instant.1 / whole.1;
        assert!((1.0..1.002).contains(&ratio), "{whole:?} {instant:?}");
    }
    let sizes = ["extremes", "forces"].map(|name| {
        let file = folder.join(format!("r/m.transient.blade.{name}.csv"));
        columns(&file, ["time [s]"]).len()
    });
    assert!(sizes[0] > 0 && 2 * sizes[0] < sizes[1], "{sizes:?}");
    let steady = reserves(folder, &state);
    let both = reserves(folder, &format!("{state} {history}"));
    for ((steady, whole), both) in steady.iter().zip(&whole).zip(&both) {
        assert_eq!(both.1, steady.1.min(whole.1), "{steady:?} {whole:?}");
        let table = match steady.1 < whole.1 {
            true => "case m.static.blade step",
            false => "case m.transient.blade time",
        };
        assert!(both.0[2].starts_with(table), "{both:?}");
    }
}

// A run that stopped halfway and continues has the same tables, to the tolerance of its steps.
#[test]
fn a_run_that_continues_has_the_tables_of_the_whole_run() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let motion = MOTION.replace("to = 100", "to = 20");
    solved(folder, "0,0.4", &motion);
    let whole = "beam-dynamics transient @m.dynamics.toml --out @r --no-figures";
    run(folder, whole);
    let half = MOTION.replace("to = 100", "to = 10");
    std::fs::write(folder.join("m.dynamics.toml"), half).unwrap();
    let halves = "beam-dynamics transient @m.dynamics.toml --out @h --no-figures";
    run(folder, halves);
    std::fs::write(folder.join("m.dynamics.toml"), motion).unwrap();
    run(folder, &format!("{halves} --restart @h/m.restart.json"));
    for table in ["forces", "extremes", "envelope"] {
        let numbers = |out: &str| {
            let file = format!("{out}/m.transient.blade.{table}.csv");
            columns(
                &folder.join(file),
                ["arc [m]", "shear_z [N]", "bending_y [N m]"],
            )
        };
        let (direct, halves) = (numbers("r"), numbers("h"));
        assert!(direct.len() == halves.len() && direct.len() >= 40);
        for (direct, halves) in direct.iter().zip(&halves) {
            let pairs = direct.iter().zip(halves);
            let mut errors =
                pairs.map(|(a, b)| a.parse::<f64>().unwrap() - b.parse::<f64>().unwrap());
            // of 4000 N and 20 kN m
            assert!(
                errors.all(|error| error.abs() < 1e-3),
                "{direct:?} {halves:?}"
            );
        }
    }
}
