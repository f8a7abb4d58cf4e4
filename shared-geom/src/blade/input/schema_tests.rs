//! The description of the blade file, the files of the repository, its reader, and its page in
//! the book.

use std::path::{Path, PathBuf};

use jsonschema::Validator;
use toml::Table;

use super::BLADE;

/// The top folder of the repository.
const ROOT: &str = env!("CARGO_MANIFEST_DIR");

fn validator() -> Validator {
    jsonschema::draft202012::new(&BLADE.json_schema()).expect("a valid schema")
}

/// Whether the text of a file fits the schema, with the reasons if not.
fn fits(validator: &Validator, text: &str) -> Result<(), String> {
    let table: Table = toml::from_str(text).expect("a file in TOML");
    let value = serde_json::to_value(table).expect("TOML without dates");
    let errors = validator.iter_errors(&value).map(|e| e.to_string());
    let errors: Vec<_> = errors.collect();
    if errors.is_empty() {
        Ok(())
    } else {
        Err(errors.join("\n"))
    }
}

/// All blade files of people below `folder`.
fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let is_made = ["target", "out", "results"].contains(&&*name) || name.starts_with('.');
        if path.is_dir() && !is_made {
            files(&path, found);
        } else if name.ends_with(super::ENDING) {
            found.push(path);
        }
    }
}

#[test]
fn every_blade_file_of_the_repository_fits() {
    let mut found = Vec::new();
    files(Path::new(ROOT), &mut found);
    let texts = found
        .iter()
        .map(|file| std::fs::read_to_string(file).expect("a text"));
    // sections to be meshed have the same ending
    let texts: Vec<_> = texts.filter(|text| !text.contains("[airfoil]")).collect();
    assert!(texts.len() > 5, "{}", texts.len());
    let validator = validator();
    for text in texts {
        assert_eq!(fits(&validator, &text), Ok(()), "{text}");
    }
}

const SOUND: &str = "\
units = \"SI\"
frame = \"helicoid\"
reference_point = \"line\"
[line]
course = \"spline\"
span = [0, 5, 10]
sweep = [0, 0, 1]
[damping]
proportional = 1e-3
[[station]]
eta = 0
ea = 1e6
gay = 1e5
gaz = 1e5
gj = 1e3
eiy = 1e3
eiz = 1e4
m = 1
iy = 1e-3
iz = 1e-2
mass_center = [0.01, 0]
[[station]]
eta = 1
stiffness = [[1e6, 0, 0, 0, 0, 0], [0, 1e5, 0, 0, 0, 0], [0, 0, 1e5, 0, 0, 0], [0, 0, 0, 1e3, 0, 0], [0, 0, 0, 0, 1e3, 0], [0, 0, 0, 0, 0, 1e4]]
m = 1
iy = 1e-3
iz = 1e-2
";

/// Both the reader and the schema refuse them.
#[test]
fn wrong_files_are_refused_by_both() {
    let validator = validator();
    assert_eq!(fits(&validator, SOUND), Ok(()));
    let read = |text: &str| super::parse(text, "a.blade.toml", false);
    assert!(read(SOUND).is_ok());
    for (from, to) in [
        ("units = \"SI\"\n", ""),
        ("units = \"SI\"\n", "units = \"SI\"\nspeed = 2\n"),
        ("\"helicoid\"", "\"helical\""),
        ("\"line\"", "\"lime\""),
        ("\"line\"", "[0.1]"),
        ("course", "curse"),
        ("\"spline\"", "\"splines\""),
        ("span = [0, 5, 10]\n", "length = 10\n"),
        ("sweep = [0, 0, 1]", "arc = [{ length = 1 }]"),
        ("proportional = 1e-3", "proportion = 1e-3"),
        ("proportional = 1e-3", "proportional = 1e-3\ntimes = [1]"),
        ("eta = 0\n", "eta = \"x\"\n"),
        ("eta = 0\n", "eta = 0\nfile = \"a.properties.json\"\n"),
        ("ea = 1e6", "ea = true"),
        ("gaz = 1e5\n", "gaz = 1e5\ngax = 1e5\n"),
        ("mass_center = [0.01, 0]", "mass_center = [0.01]"),
        ("[[station]]\neta = 1\n", "[station]\neta = 1\n"),
    ] {
        let text = SOUND.replacen(from, to, 1);
        assert_ne!(text, SOUND, "{from}");
        assert!(read(&text).is_err(), "{from} -> {to}");
        if toml::from_str::<Table>(&text).is_ok() {
            assert!(fits(&validator, &text).is_err(), "{from} -> {to}");
        }
    }
}

#[test]
fn the_reference_page_is_that_of_the_description() {
    let page = Path::new(ROOT).join("docs/src/blade-file-reference.md");
    let found = std::fs::read_to_string(page).unwrap_or_default();
    assert!(
        found == BLADE.reference(),
        "write it anew: beam-dynamics schema --of blade --format markdown --out \
         docs/src/blade-file-reference.md"
    );
}
