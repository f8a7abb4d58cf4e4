//! Names of other files: blanks, signs, quotes and letters of any language.

use std::path::Path;

use section_analyzer::input::layup;
use section_analyzer::output::layup_file;

use crate::files::section;
use crate::windio::{read, tube};

/// Names of the tube, and names in their places: with the words and signs that names of places have,
/// quotes, a backslash, and a letter with its dots as a sign of its own.
const NAMES: [[&str; 2]; 7] = [
    ["skin", "Außenhaut + Gelcoat"],
    ["cap", "Spar cap - SS"],
    ["low", "Gurt_U\u{308}(unten)@2"],
    ["main", "web \"1\""],
    // made of the name of its web
    ["main_bond_1", "web \"1\"_bond_1"],
    ["web_skin", "skin of web 'main'.suction"],
    ["glass", "Glas \\ UD 1.0"],
];

/// A file with such names is written as a layup file and read again: its sections and the section file
/// of its mesh are the same, and differ from the ones of the tube by names alone.
#[test]
fn names_of_any_letters_are_read_again() {
    let (_, text) = tube();
    let plain = read(&text).unwrap_or_else(|problems| panic!("{problems}"));
    let mut named = text;
    for [from, to] in NAMES {
        let to = to.replace('\\', "\\\\").replace('"', "\\\"");
        for key in ["name", "web", "material"] {
            for end in ["\n", ","] {
                named = named.replace(
                    &format!("{key}: {from}{end}"),
                    &format!("{key}: \"{to}\"{end}"),
                );
            }
        }
    }
    let first = read(&named).unwrap_or_else(|problems| panic!("{problems}"));
    let written = layup_file(&first, "a.yaml");
    let again = layup::parse(&written, Path::new("a.layup.toml"));
    let again = again.unwrap_or_else(|problems| panic!("{problems}\n{written}"));
    let eta = 0.5;
    let of = |layup: &layup::Layup| {
        let section = layup.section(eta);
        section.unwrap_or_else(|problems| panic!("{problems}"))
    };
    assert_eq!(of(&again), of(&first));
    let new = |name: &str| {
        let known = NAMES.iter().find(|one| one[0] == name);
        known.map_or(name, |one| one[1]).to_owned()
    };
    let layers = |layup: &layup::Layup| -> Vec<String> {
        let layers = of(layup).layers.into_iter();
        layers.map(|layer| layer.name).collect()
    };
    let expected: Vec<String> = layers(&plain).iter().map(|name| new(name)).collect();
    assert_eq!(layers(&again), expected);
    let regions = |layup: &layup::Layup| section(layup, eta).section.mesh.cells.len();
    assert_eq!(regions(&again), regions(&plain));
}

/// A sign in a name is none of a shift, and a shift behind such a name is one.
#[test]
fn signs_in_names_are_no_shifts() {
    let text = |to: &str| {
        format!(
            "units = \"SI\"\n[shape]\nchord = 1\norigin = 0.25\nnaca = \"0018\"\n\
             [[layer]]\nname = \"cap - 2\"\nmaterial = \"a\"\nthickness = 0.001\nfrom = 0\nto = 0.3\n\
             [[layer]]\nname = \"b\"\nmaterial = \"a\"\nthickness = 0.001\nfrom = 0\nto = \"{to}\"\n\
             [material.a]\nyoung = 40e9\npoisson = 0.3\ndensity = 1900\n"
        )
    };
    for (to, arc) in [
        ("cap - 2.end", 0.3),
        ("cap - 2.end - 0.01", 0.29),
        ("cap - 2.end + 0.02", 0.32),
    ] {
        let layup = layup::parse(&text(to), Path::new("a.layup.toml"));
        let layup = layup.unwrap_or_else(|problems| panic!("{problems}"));
        let section = layup
            .section(0.5)
            .unwrap_or_else(|problems| panic!("{problems}"));
        assert!((section.layers[1].to - arc).abs() < 1e-12, "{to}");
    }
}
