//! Input that was read without a word and is not meant: errors with the line, the layer and the remedy.

use crate::windio::{read, tube};

/// The tube of windIO 2 with a change, which must be in it, and the problems of the result.
fn problems(from: &str, to: &str) -> String {
    let (_, text) = tube();
    assert!(text.contains(from), "{from}");
    match read(&text.replacen(from, to, 1)) {
        Ok(_) => panic!("no problem: {to}"),
        Err(problems) => problems,
    }
}

/// Each change of a windIO file, and parts of its message: line, name, value found, expectation, remedy.
#[test]
fn windio_files_say_what_they_mean() {
    let anchor = "        - name: foot\n";
    let again = "        - name: low\n          start_nd_arc: {grid: *ends, values: [0.5, 0.5]}\n";
    let rear = "end_nd_arc: {anchor: {name: rear, handle: end_nd_arc}}";
    let web = "end_nd_arc: {anchor: {name: web, handle: end_nd_arc}}";
    let axis = "values: [0, 40]}";
    let cases: [(&str, String, &[&str]); 4] = [
        (
            anchor,
            format!("{again}{anchor}"),
            &[
                "a.yaml:43: anchor \"low\"",
                "given twice, first in line 40",
                "one anchor of each name",
                "give it another name",
            ],
        ),
        (
            rear,
            rear.replace("handle: end", "handle: start"),
            &[
                "the place of layer \"rear\"",
                "start_nd_arc of anchor \"rear\" for both",
                "the start and the end of the layer",
                "refer to another handle",
            ],
        ),
        (
            web,
            web.replace("handle: end", "handle: start"),
            &[
                "the place of web \"main\"",
                "start_nd_arc of anchor \"web\" for both",
                "one on each side",
            ],
        ),
        (
            axis,
            "values: [40, 0]}".to_owned(),
            &[
                "a.yaml:7: reference_axis",
                "from 40 at the root to 0 at the tip",
                "z that grows from root to tip",
                "turn the signs of z",
            ],
        ),
    ];
    for (from, to, expected) in cases {
        let found = problems(from, &to);
        for part in expected {
            assert!(found.contains(part), "{part}:\n{found}");
        }
    }
}

const TEXT: &str = "\
units = \"SI\"
[line]
span = [0, 50]
twist = { eta = [0, 1], value = [\"10 deg\", \"0 deg\"] }
[shape]
chord = 2
naca = \"0018\"
[[layer]]
name = \"skin\"
material = \"glass\"
thickness = 0.004
[[layer]]
name = \"cap\"
material = \"glass\"
thickness = 0.01
from = 0.3
to = 0.4
[[web]]
name = \"main\"
at = { x = 0.3 }
plies = [{ name = \"wall\", material = \"glass\", thickness = 0.004 }]
[material.glass]
young = 40e9
poisson = 0.3
density = 1900
";

/// The same of layup files, in reading or at a section.
#[test]
fn layup_files_say_what_they_mean() {
    let cases: [(&str, &str, &[&str]); 6] = [
        (
            "span = [0, 50]",
            "span = [50, 0]",
            &["a.layup.toml:3: ", "span", "ascending"],
        ),
        (
            "span = [0, 50]",
            "span = [0, 40, 30, 50]",
            &["a.layup.toml:3: ", "span", "ascending"],
        ),
        (
            "from = 0.3\n",
            "from = 0.3\nwidth = \"9 m\"\n",
            &["a.layup.toml:17: ", "\"cap\"", "width"],
        ),
        (
            "to = 0.4",
            "to = 1.4",
            &[
                "a.layup.toml:17: ",
                "\"arc 1.4\" of layer \"cap\" is not on the contour",
            ],
        ),
        (
            "at = { x = 0.3 }",
            "at = { x = 1.3 }",
            &[
                "a.layup.toml:20: ",
                "\"x = 1.3\" of web \"main\" is not on the contour",
            ],
        ),
        (
            "name = \"cap\"\nmaterial = \"glass\"\n",
            "name = \"cap\"\n",
            &[
                "a.layup.toml:12: \"cap\" has no \"material\"",
                "expected the name of a table [material.NAME]",
            ],
        ),
    ];
    for (from, to, expected) in cases {
        assert!(TEXT.contains(from), "{from}");
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("a.layup.toml");
        std::fs::write(&file, TEXT.replacen(from, to, 1)).expect("a file");
        let layup = section_analyzer::input::layup::read(&file);
        let found = layup.and_then(|layup| layup.section(0.5));
        let found = found.map(|section| format!("{:?}", section.layers));
        let found = found.expect_err(to).to_string();
        for part in expected {
            assert!(found.contains(part), "{to}: {part}:\n{found}");
        }
    }
}
