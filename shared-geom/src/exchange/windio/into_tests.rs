//! Blades written into windIO files.

use std::path::Path;

use super::fields;
use crate::blade::Blade;
use crate::exchange::problem::Problems;
use crate::exchange::samples::{blade, difference};
use crate::exchange::yaml;
use crate::exchange::{Options, length_remark, parse, write_into};

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

// The interpolation of the axis is a comment of Helicoid's files, which this file does not have:
// it is read as a spline, like the sample.
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

// The IEA-15 blade is 117 m long along z, and its prebend of 4 m adds 0.1 % of this.
#[test]
fn a_blade_of_another_length_is_remarked() {
    for (text, kept) in [
        (TWO, "the shape and"),
        (ONE, "the reference axis, the shape and"),
    ] {
        let own = read(text);
        assert_eq!(length_remark(&own, text), None);
        let mut longer = own.clone();
        for point in &mut longer.line.points {
            point.position *= 1.04;
        }
        assert_eq!(length_remark(&longer, text), None);
        for point in &mut longer.line.points {
            point.position *= 1.02;
        }
        let shown = length_remark(&longer, text).unwrap();
        let new = own.length() * 1.04 * 1.02;
        let begins = format!(
            "the blade is {new:.4} m long, and the blade of the file {:.4} m",
            own.length()
        );
        assert!(
            shown.starts_with(&begins) && shown.contains(kept),
            "{shown}"
        );
    }
    assert_eq!(length_remark(&blade(), "components:\n  blade:\n"), None);
}

// Rules of the schema of windIO 2.1.1 for the parts that are written: required keys, no other
// keys, positions from 0 to 1, one number for each position, six damping times.
#[test]
fn written_tables_keep_the_rules_of_the_schema() {
    let at = TWO.find("            elastic_properties:").unwrap();
    let bare = TWO[..at].to_owned() + "            webs: []\n";
    let mut undamped = blade();
    undamped.damping = None;
    let written = |blade: &Blade, text: &str| {
        let writing = write_into(blade, text, Path::new("a.yaml")).unwrap();
        writing.files[0].1.clone()
    };
    let plain = super::write_version_2(&blade(), "a").files[0].1.clone();
    for text in [into(TWO), written(&undamped, &bare), plain] {
        let root = yaml::parse(&text).unwrap();
        let blade = root.path(&["components", "blade"]).unwrap();
        for axis in ["x", "y", "z"] {
            let columns = blade.path(&["reference_axis", axis]).unwrap();
            assert_eq!(columns.keys(), ["grid", "values"]);
            of_schema(columns);
        }
        of_schema(blade.path(&["outer_shape", "twist"]).unwrap());
        let elastic = blade.path(&["structure", "elastic_properties"]).unwrap();
        let mut keys = elastic.keys();
        keys.sort_unstable();
        let required = ["inertia_matrix", "stiffness_matrix", "structural_damping"];
        assert_eq!(keys, required);
        of_schema(elastic.entry("stiffness_matrix").unwrap());
        of_schema(elastic.entry("inertia_matrix").unwrap());
        let stiffness = elastic.entry("stiffness_matrix").unwrap().keys();
        assert_eq!(stiffness.len(), 22, "grid and K11 to K66");
        let inertia = elastic.entry("inertia_matrix").unwrap().keys();
        let seven = ["mass", "cm_x", "cm_y", "i_edge", "i_flap", "i_plr", "i_cp"];
        assert_eq!(inertia[1..], seven);
        let times = elastic.path(&["structural_damping", "mu"]).unwrap();
        assert_eq!(list(times).len(), 6);
    }
}

fn list(node: &yaml::Node) -> Vec<f64> {
    let mut problems = Problems::new("a.yaml");
    fields::numbers(node, "list", &mut problems).unwrap()
}

/// A table whose lists have the length of its grid, from 0 to 1.
fn of_schema(table: &yaml::Node) {
    let grid = list(table.entry("grid").unwrap());
    assert!(grid.len() >= 2 && grid.iter().all(|part| (0.0..=1.0).contains(part)));
    for key in table.keys() {
        assert_eq!(list(table.entry(key).unwrap()).len(), grid.len(), "{key}");
    }
}

#[test]
fn point_masses_of_the_existing_file_are_reported() {
    let masses = "                point_mass: {grid: [0, 1], mass: [1, 1]}\n";
    let at = "            elastic_properties:\n";
    let text = TWO.replace(at, &format!("{at}{masses}"));
    let writing = write_into(&blade(), &text, Path::new("a.yaml")).unwrap();
    let reported = "point_mass of the existing file: it stays as it is";
    assert!(
        writing.lost.iter().any(|lost| lost == reported),
        "{:?}",
        writing.lost
    );
    assert!(writing.files[0].1.contains(masses));
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

/// A turbine with all of its blade in the flow style.
const FLOW: &str = "# turbine\ncomponents:\n    hub: {diameter: 7, cone: [1, 2]}  # kept\n    blade: {\n        \
                outer_shape: {chord: {grid: [0, 1], values: [5, 1]}, twist: {grid: [0,\n 1], values: [0, 0]}},\n        \
                structure: {webs: [], elastic_properties: null}, reference_axis: null\n    } # blade\n\
                airfoils: [] # kept\n";

// A reference turbine may have all of its blade in the flow style: the tables around the replaced
// ones become blocks with their entries as they are, and other tables keep their style.
#[test]
fn tables_in_the_flow_style_are_replaced() {
    let written = into(FLOW);
    assert!(difference(&blade(), &read(&written)) < 1e-14, "{written}");
    for kept in [
        "# turbine\ncomponents:\n    hub: {diameter: 7, cone: [1, 2]}  # kept\n    blade: # blade\n",
        "            chord: {grid: [0, 1], values: [5, 1]}\n            twist:\n                grid: [",
        "            webs: []\n            elastic_properties:\n",
        "\nairfoils: [] # kept\n",
    ] {
        assert!(written.contains(kept), "{kept}\n{written}");
    }
}

// The first alias after a replaced table has the old value, and others refer to it.
#[test]
fn anchors_in_replaced_tables_move_to_their_first_alias() {
    let key = "        outer_shape:\n";
    let other = "        first: {grid: *g, list: *x} # kept\n        second: *g\n        third: *x\n        \
                 fourth: *b\n";
    let at = TWO.find("            x:\n").unwrap();
    let x = "            x: &b\n                grid: &g [0,\n                    1]\n                \
             values: &x [1, 2]\n            other:\n";
    let text = TWO[..at].to_owned() + x + &TWO[at..];
    let text = text.replace(key, &format!("{other}{key}"));
    let written = into(&text);
    let expected = "        first: {grid: &g [0, 1], list: &x [1, 2]} # kept\n        second: *g\n        \
                    third: *x\n        fourth: &b\n            grid: &g [0,\n                1]\n            \
                    values: &x [1, 2]\n        outer_shape:\n";
    assert!(written.contains(expected), "{written}");
    assert!(difference(&blade(), &read(&written)) < 1e-14);
}

// Refused or readable, and never a panic.
#[test]
fn no_changed_byte_makes_the_writer_panic() {
    let text = FLOW
        .replace("webs: []", "webs: &w [1, *v], a: *w")
        .replace("# turbine", "v: &v 2");
    into(&text);
    let mut written = 0;
    for at in 0..text.len() {
        let mut bytes = text.clone().into_bytes();
        bytes[at] = b"{}[],:&*#'\"\n x"[at * 5 % 14];
        let changed = String::from_utf8(bytes).unwrap();
        if let Ok(writing) = write_into(&blade(), &changed, Path::new("a.yaml")) {
            written += 1;
            read(&writing.files[0].1);
        }
    }
    assert!(written > 20, "{written}");
}

#[test]
fn missing_properties_are_added_to_version_1() {
    let text =
        "components:\n    blade:\n        outer_shape_bem:\n            chord: {}\n    hub: {}\n";
    let written = into(text);
    assert!(difference(&blade(), &read(&written)) < 1e-14);
    assert!(written.starts_with(&text[..text.find("    hub").unwrap()]));
    assert!(written.ends_with("    hub: {}\n"));
}

#[test]
fn files_that_cannot_be_edited_are_refused_with_their_line() {
    let flat = TWO.replace(
        "        reference_axis:\n",
        "        reference_axis: {a: 1, # one\n          b: 2}\n        other:\n",
    );
    let message = refused(&flat);
    assert!(
        message.contains("a.yaml:7: components.blade.reference_axis: found \"{a: 1, # one\""),
        "{message}"
    );
    // a block cannot move into a list
    let anchored = TWO
        .replace("            x:\n", "            x: &x\n")
        .replace(
            "        outer_shape:\n",
            "        other: [*x]\n        outer_shape:\n",
        );
    assert!(refused(&anchored).contains("the anchor &x, to which other tables refer"));
    let without = TWO.replace("        structure:\n", "        structures:\n");
    let message = refused(&without);
    assert!(message.contains("add structure"), "{message}");
    assert!(refused("a: 1\n").contains("expected a windIO file with components.blade"));
}
