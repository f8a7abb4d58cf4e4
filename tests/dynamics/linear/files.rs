//! The command and its files.

use std::ffi::OsString;

use super::problems::BODY;
use super::text;

/// Exit code and both outputs of the command with a file of the cards in a folder.
fn run(folder: &std::path::Path, cards: &str, options: &[&str]) -> (u8, String, String) {
    let file = folder.join("body.dynamics.toml");
    std::fs::write(&file, text(cards)).unwrap();
    let words = ["beam-dynamics", "linearize"]
        .into_iter()
        .map(OsString::from);
    let words = words.chain([file.into_os_string()]);
    let words = words.chain(options.iter().map(OsString::from));
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let code = beam_dynamics::cli::run(words, &mut out, &mut err);
    let texts = [out, err].map(|bytes| String::from_utf8(bytes).unwrap());
    let [out, err] = texts;
    (code, out, err)
}

// x'' = -10 x + u along x, alone in its rows and columns: by the numbers of the files.
#[test]
fn matrices_are_written_with_names_and_units() {
    let folder = tempfile::tempdir().unwrap();
    let options = ["--input", "push", "--output", "place"];
    let (code, out, err) = run(folder.path(), BODY, &options);
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(out.contains("12 states, 1 inputs, 1 outputs"), "{out}");
    let file = |ending: &str| {
        let path = folder.path().join("results/body.linear.").into_os_string();
        let mut path = path.into_string().unwrap();
        path.push_str(ending);
        std::fs::read_to_string(path).unwrap()
    };
    let json: serde_json::Value = serde_json::from_str(&file("json")).unwrap();
    let states = json["states"].as_array().unwrap();
    let place = |name: &str| states.iter().position(|own| own["name"] == name).unwrap();
    let [x, p] = [
        "position along x of node \"a\"",
        "momentum along x of node \"a\"",
    ]
    .map(place);
    let number = |matrix: &str, i: usize, j: usize| json[matrix][i][j].as_f64().unwrap();
    for (found, expected) in [
        (number("A", x, p), 1.0),
        (number("A", p, x), -10.0),
        (number("A", p, p), 0.0),
        (number("B", p, 0), 1.0),
        (number("C", 0, x), 1.0),
        (number("D", 0, 0), 0.0),
    ] {
        assert!((found - expected).abs() < 1e-13, "{found} {expected}");
    }
    assert_eq!(states[p]["unit"], "kg m/s");
    assert_eq!(json["outputs"][0]["unit"], "m");
    assert_eq!(json["eigenvalues"].as_array().unwrap().len(), 12);

    let table = file("csv");
    let mut reader = csv::Reader::from_reader(table.as_bytes());
    let headings = reader.headers().unwrap().clone();
    assert_eq!(&headings[13], "push [-]");
    let rows: Vec<_> = reader.records().map(|row| row.unwrap()).collect();
    assert_eq!(rows.len(), 13);
    assert_eq!(
        &rows[p][0],
        "rate of momentum along x of node \"a\" [kg m/s/s]"
    );
    assert!((rows[p][x + 1].parse::<f64>().unwrap() + 10.0).abs() < 1e-13);
    assert_eq!(&rows[12][0], "place [m]");
    assert_eq!(file("txt"), out[..out.find("\nWritten").unwrap()]);
}

// Wrong names exit with 2, no equilibrium with 1: a force on a body that only a hinge without stiffness
// holds.
#[test]
fn exit_codes() {
    let folder = tempfile::tempdir().unwrap();
    let (code, _, err) = run(folder.path(), BODY, &["--input", "pull"]);
    assert_eq!(code, 2, "{err}");
    let free = BODY.replace("value = 0", "value = 1").replace(
        "[[spring]]\nname = \"s\"\nnode = \"a\"\nstiffness = [10, 20, 30]\n\
         rotational_stiffness = [1, 2, 3]\n",
        "[[joint]]\nname = \"guide\"\nkind = \"prismatic\"\nnodes = [\"a\"]\naxis = [1, 0, 0]\n",
    );
    let (code, _, err) = run(folder.path(), &free, &["--input", "push"]);
    assert_eq!(code, 1, "{err}");
    assert!(err.contains("no steady equilibrium"), "{err}");
}
