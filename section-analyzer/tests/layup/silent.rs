//! Input that was read without a word and is not meant: errors with the line, the layer and the remedy.

use std::path::Path;

use section_analyzer::input::layup;

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
        let layup = layup::read(&file);
        let found = layup.and_then(|layup| layup.section(0.5));
        let found = found.map(|section| format!("{:?}", section.layers));
        let found = found.expect_err(to).to_string();
        for part in expected {
            assert!(found.contains(part), "{to}: {part}:\n{found}");
        }
    }
}

/// Values that are possible and unusual: the layup is read, with a remark that has the line and the value.
#[test]
fn unusual_values_are_remarks() {
    let thickness = "thickness = 0.01\n";
    let cases = [
        (
            thickness,
            "thickness = 0.01\ntaper = \"5 m\"\n",
            // the arcs 0.3 to 0.4 of the contour of a NACA 0018 with a chord of 2 m, 4.15 m long
            "line 12: the taper of layer \"cap\" is 5 m long at eta 0, more than the layer is wide, 0.415953 m: it is shortened",
        ),
        (
            thickness,
            "thickness = 0.01\ntaper = \"1:100\"\n",
            "line 12: the taper of layer \"cap\" is 1 m long",
        ),
        (
            "chord = 2\n",
            "chord = 2\norigin = -0.25\n",
            "line 5: the origin of the section is at -0.25 of the chord at eta 0, ahead of the leading edge",
        ),
        (
            "chord = 2\n",
            "chord = 2\norigin = 1.5\n",
            "is at 1.5 of the chord at eta 0, behind the trailing edge",
        ),
    ];
    let remarks = |text: &str| {
        let layup = layup::parse(text, Path::new("a.layup.toml"));
        layup.expect(text).remarks
    };
    let usual = TEXT.replacen(thickness, "thickness = 0.01\ntaper = \"1:20\"\n", 1);
    assert!(remarks(&usual).is_empty(), "{:?}", remarks(&usual));
    for (from, to, expected) in cases {
        let found = remarks(&TEXT.replacen(from, to, 1));
        assert!(
            found.iter().any(|one| one.contains(expected)),
            "{to}: {found:?}"
        );
    }
}

/// The same of windIO files.
#[test]
fn unusual_values_of_windio_are_remarks() {
    let (_, tube) = tube();
    for (from, to, expected) in [
        (
            "orth: 1",
            "orth: 0",
            "material \"glass\": orth is 0, and E is a list: an orthotropic material is taken",
        ),
        (
            "orth: 0\n    rho: 100\n",
            "orth: 1\n    rho: 100\n",
            "material \"foam\": orth is 1, and E is a number: an isotropic material is taken",
        ),
        (
            "section_offset_y: {grid: *ends, values: [1, 1]}",
            "section_offset_y: {grid: *ends, values: [1, -1]}",
            "line 13: section_offset_y is -1 at 1: the axis is ahead of the leading edge",
        ),
        (
            "twist: {grid: *ends, values: [10, 10]}",
            "twist: {grid: *ends, values: [100, 10]}",
            "line 12: twist is 100 deg at 0, more than a right angle",
        ),
    ] {
        assert!(tube.contains(from), "{from}");
        let layup = read(&tube.replacen(from, to, 1)).expect(to);
        let found = layup.remarks;
        assert!(
            found.iter().any(|one| one.contains(expected)),
            "{to}: {found:?}"
        );
    }
}
