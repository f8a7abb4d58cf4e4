//! `prestress` of properties: cases in which it is refused.

use shared_geom::section::{self, CubicTable, Prestress, SectionProperties, StrainMeasure};

use super::{BLADE, Folder, strip};

/// The blade, with a key after the file of its properties.
fn with(key: &str) -> String {
    let file = "file = \"strip.properties.json\"\n";
    assert!(BLADE.contains(file));
    BLADE.replacen(file, &format!("{file}{key}\n"), 1)
}

/// A folder whose property file has a table.
fn prestressed() -> Folder {
    let folder = Folder::new();
    let section = SectionProperties {
        prestress: Some(Prestress {
            strain_measure: StrainMeasure::Biot,
            third: CubicTable::ZERO,
            per_kelvin: None,
        }),
        ..strip()
    };
    folder.write("strip.properties.json", &section::write(&section));
    folder
}

#[test]
fn a_file_without_a_table_is_reported_with_the_remedy() {
    let folder = Folder::new();
    let path = folder.path("strip.properties.json");
    let message = "properties \"strip\" request the effect of prestress, but ";
    folder.write("a.dynamics.toml", &with("prestress = true"));
    let run = folder.run(&["check", "a.dynamics.toml"]);
    assert_eq!(run.code, 2);
    for expected in [
        message,
        &path.file_name().unwrap().to_string_lossy(),
        "has no table of it",
        "\n  help: put prestress = \"biot\" into the section file and analyze it again, or remove \
         \"prestress\" to ignore prestress\n",
    ] {
        assert!(
            run.err.contains(expected),
            "{expected} is not in\n{}",
            run.err
        );
    }
}

#[test]
fn a_law_and_prestress_exclude_each_other() {
    let folder = prestressed();
    let keys = "prestress = true\nlaw = [{ kind = \"section\" }]";
    folder.write("a.dynamics.toml", &with(keys));
    let run = folder.run(&["check", "a.dynamics.toml"]);
    assert_eq!(run.code, 2);
    let words = "properties \"strip\": a \"law\" replaces the stiffness, and \
                 \"prestress\" with it\n  help: remove one of the two";
    assert!(run.err.contains(words), "{}", run.err);
}

#[test]
fn inline_numbers_have_no_table() {
    let folder = Folder::new();
    let text = "units = \"SI\"\n[properties.p]\nprestress = true\nea = 1\n";
    folder.write("a.dynamics.toml", text);
    let run = folder.run(&["check", "a.dynamics.toml"]);
    assert_eq!(run.code, 2);
    let words = "a.dynamics.toml:3: properties \"p\" request the effect of prestress, but have no \
                 \"file\"\n  help: only property files have tables of prestress";
    assert!(run.err.contains(words), "{}", run.err);
}

/// A table of zeros changes nothing, whether it is requested or not: the same table of
/// frequencies, to the last digit that is written.
#[test]
fn a_table_of_zeros_changes_nothing() {
    let folder = prestressed();
    let frequencies = |keys: &str| {
        folder.write("a.dynamics.toml", &with(keys));
        let run = folder.run(&["modes", "a.dynamics.toml"]);
        assert_eq!(run.code, 0, "{}", run.err);
        run.out
    };
    let without = frequencies("prestress = false");
    let with = frequencies("prestress = true");
    let table = |text: &str| {
        let lines = text.lines().filter(|line| line.contains("flap"));
        lines.map(str::to_owned).collect::<Vec<_>>()
    };
    assert!(!table(&with).is_empty());
    assert_eq!(table(&with), table(&without));
}
