//! Blades written into windIO files.

use std::path::Path;

use crate::blade::Blade;
use crate::exchange::samples::{blade, difference};
use crate::exchange::{Options, parse, write_into};

const TWO: &str = include_str!("../../../../tests/reference/exchange/windio2_iea15.yaml");
const ONE: &str = include_str!("../../../../tests/reference/exchange/windio1_iea15.yaml");

fn read(text: &str) -> Blade {
    let read = parse(text, Path::new("a.yaml"), &Options::default());
    read.unwrap_or_else(|problems| panic!("{problems}")).1.blade
}

fn into(text: &str) -> String {
    let writing = write_into(&blade(), text, Path::new("a.yaml"));
    writing
        .unwrap_or_else(|problems| panic!("{problems}"))
        .files[0]
        .1
        .clone()
}

fn refused(text: &str) -> String {
    let writing = write_into(&blade(), text, Path::new("a.yaml"));
    writing.unwrap_err().to_string()
}

/// Lines of a text that have none of `keys`.
fn others<'a>(text: &'a str, keys: &[&str]) -> Vec<&'a str> {
    let is_other = |line: &&str| !keys.iter().any(|key| line.trim_start().starts_with(key));
    text.lines().filter(is_other).collect()
}

// The course of the axis is a comment of Helicoid's files, which this file does not have:
// it is read as a spline, as the course of the sample is.
#[test]
fn the_blade_comes_back_and_other_lines_stay() {
    let extra = "        outer_shape:\n            # kept\n            chord: {grid: [0, 1], values: [5, 1]}\n";
    let text = TWO.replace("        outer_shape:\n", extra) + "airfoils:\n- name: kept\n";
    let written = into(&text);
    // Round-off of eta times length and of degrees, as in a file of its own.
    let error = difference(&blade(), &read(&written));
    assert!(error < 1e-14, "{error:e}");
    let numbers = ["grid", "values", "K", "mass", "cm_", "i_", "mu"];
    assert_eq!(others(&written, &numbers), others(&text, &numbers));
}

// Axis and twist of the file have grids of their own; afterwards both have the same.
#[test]
fn a_blade_returns_into_its_own_file() {
    let old = read(TWO);
    let written = write_into(&old, TWO, Path::new("a.yaml")).unwrap();
    let error = difference(&old, &read(&written.files[0].1));
    // Parts of the length are divided by it and multiplied again.
    assert!(error < 1e-12, "{error:e}");
}

#[test]
fn version_1_has_all_in_one_table() {
    let text = ONE.replace("components:", "components:\n    hub: {diameter: 7}");
    let written = into(&text);
    let error = difference(&blade(), &read(&written));
    assert!(error < 1e-14, "{error:e}");
    assert!(written.contains("    hub: {diameter: 7}\n"));
}

#[test]
fn missing_properties_are_added_to_the_structure() {
    let at = TWO.find("            elastic_properties:").unwrap();
    let text = TWO[..at].to_owned() + "            webs: []\n";
    let written = into(&text);
    assert!(difference(&blade(), &read(&written)) < 1e-14);
    assert!(written.contains("            webs: []\n            elastic_properties:\n"));
}

#[test]
fn files_that_cannot_be_edited_are_refused_with_their_line() {
    let anchored = TWO
        .replace("            x:\n", "            x: &x\n")
        .replace(
            "        outer_shape:\n",
            "        other: *x\n        outer_shape:\n",
        );
    assert!(refused(&anchored).contains("the anchor &x, to which other tables refer"));
    let flat = TWO.replace("        reference_axis:\n", "        reference_axis: {}\n");
    let message = refused(&flat);
    assert!(
        message.contains("a.yaml:7: components.blade.reference_axis: found \"{}\""),
        "{message}"
    );
    let without = TWO.replace("        structure:\n", "        structures:\n");
    let message = refused(&without);
    assert!(message.contains("add structure"), "{message}");
    assert!(refused("a: 1\n").contains("expected a windIO file with components.blade"));
}
