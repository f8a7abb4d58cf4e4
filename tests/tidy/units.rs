//! Units of public numbers: in a public structure, the doc comment of every public field
//! of `f64`, or of arrays, vectors and matrices of them, states one in brackets.

use crate::source::words;
use crate::tree::{File, Tree};

/// Words of a unit, without numbers and signs.
const UNITS: [&str; 33] = [
    "m", "mm", "kg", "s", "ms", "N", "kN", "J", "W", "Pa", "kPa", "MPa", "GPa", "K", "rad", "deg",
    "Hz", "rpm", "V", "A", "C", "F", "g", "t", "in", "ft", "lb", "lbf", "slug", "psi", "per",
    "rev", "mixed",
];

/// Public fields of the three crates whose doc comment states no unit.
pub fn fields(tree: &Tree) -> Vec<String> {
    let mut breaches = Vec::new();
    for folder in [
        "shared-geom/src",
        "section-analyzer/src",
        "beam-dynamics/src",
    ] {
        for file in tree.rust_below(folder) {
            breaches.extend(fields_of(file));
        }
    }
    breaches
}

fn fields_of(file: &File) -> Vec<String> {
    let lines: Vec<&str> = file.text.lines().collect();
    let mut breaches = Vec::new();
    let mut is_public_structure = true;
    for (line, code) in file.program_lines() {
        if words(code, "struct").next().is_some() {
            is_public_structure = code.trim_start().starts_with("pub struct");
        }
        let Some((name, kind)) = public_field(code).filter(|_| is_public_structure) else {
            continue;
        };
        if words(kind, "f64").next().is_some() && !states_unit(&doc_above(&lines, line)) {
            let message = format!(
                "field \"{name}\": no unit in the doc comment, expected one in brackets such as [N m^2] or [-]"
            );
            breaches.push(file.breach(line, &message));
        }
    }
    breaches
}

/// Name and type of the public field on this line of blanked code.
fn public_field(code: &str) -> Option<(&str, &str)> {
    let (name, kind) = code.trim().strip_prefix("pub ")?.split_once(": ")?;
    let is_name = !name.contains([' ', '(', '<', ':']);
    (is_name && kind.ends_with(',')).then_some((name, kind))
}

/// The doc comment above a line, attributes skipped.
fn doc_above(lines: &[&str], line: usize) -> String {
    let above = lines[..line].iter().rev().map(|text| text.trim());
    let mut doc: Vec<&str> = above
        .take_while(|text| text.starts_with("///") || text.starts_with("#["))
        .filter_map(|text| text.strip_prefix("///"))
        .collect();
    doc.reverse();
    doc.join(" ")
}

/// Whether a pair of brackets in the text holds a unit.
fn states_unit(doc: &str) -> bool {
    let opened = doc.split('[').skip(1);
    opened
        .filter_map(|rest| rest.split_once(']'))
        .any(|(content, _)| is_unit(content))
}

/// `-`, words of [`UNITS`] with numbers and signs between them, or words that include
/// "unit", if another value decides.
fn is_unit(content: &str) -> bool {
    let content = content.trim_matches(['\\', '`', ' ']);
    if content == "-"
        || ["unit", "units"]
            .iter()
            .any(|word| words(content, word).next().is_some())
    {
        return true;
    }
    let mut letters = content
        .split(|c: char| !c.is_ascii_alphabetic())
        .filter(|word| !word.is_empty())
        .peekable();
    letters.peek().is_some() && letters.all(|word| UNITS.contains(&word))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn breaches(text: &str) -> usize {
        fields(&Tree::of(&[("shared-geom/src/a.rs", text)])).len()
    }

    #[test]
    fn fields_without_a_unit_are_reported() {
        assert_eq!(
            breaches("pub struct A {\n    /// Mass [kg/m].\n    pub mass: f64,\n}\n"),
            0
        );
        assert_eq!(
            breaches("pub struct A {\n    /// Mass.\n    pub mass: f64,\n}\n"),
            1
        );
        assert_eq!(
            breaches("pub struct A {\n    /// See [`B`].\n    pub k: Vec<Matrix6<f64>>,\n}\n"),
            1
        );
        assert_eq!(
            breaches("pub struct A {\n    /// Mass.\n    mass: f64,\n    pub n: usize,\n}\n"),
            0
        );
    }

    #[test]
    fn structures_of_a_module_are_free() {
        assert_eq!(
            breaches("pub(super) struct A {\n    /// Mass.\n    pub mass: f64,\n}\n"),
            0
        );
    }

    #[test]
    fn attributes_may_be_between_doc_and_field() {
        let text = "/// Length\n/// from the root, in \\[m\\].\n#[allow(x)]\npub length: f64,\n";
        assert_eq!(breaches(text), 0);
    }

    #[test]
    fn units_are_distinguished_from_links() {
        for unit in [
            "-",
            "m",
            "N m^2",
            "kg m²/s",
            "1/m",
            "N, N m",
            "unit of the column",
            "`m`",
        ] {
            assert!(is_unit(unit), "{unit}");
        }
        for other in ["Frame", "crate::wrench", "", "0, 1", "the tip"] {
            assert!(!is_unit(other), "{other}");
        }
    }
}
