//! Files with wrong, misspelled, absent and repeated fields.

use nalgebra::{Matrix4, Vector2};
use serde_json::{Value, json};

use crate::section::tests::{with_imposed, with_prestress};
use crate::section::{Change, InitialCurvature, SectionProperties, parse, write};

/// A section with all fields of a file except a curvature, which excludes prestress.
fn full() -> SectionProperties {
    let mut section = with_prestress();
    section.imposed = with_imposed().imposed;
    section.imposed[0].stiffness_change = Some(Matrix4::identity());
    if let Some(prestress) = &mut section.prestress {
        prestress.per_kelvin = Some(Matrix4::identity());
    }
    let section = section.changed(Change::Rotate(0.7), "a", "1");
    section.changed(Change::Shift(Vector2::new(0.1, 0.2)), "a", "1")
}

/// The same without prestress, and curved; its damping by a time.
fn curved() -> SectionProperties {
    let mut section = with_imposed();
    section.initial_curvature = Some(InitialCurvature::STRAIGHT);
    section.damping = Some(crate::section::Damping::StiffnessProportional(1e-3));
    section
}

/// The paths of all fields of a file, as JSON pointers.
fn fields(value: &Value, path: &str, found: &mut Vec<String>) {
    if let Some(table) = value.as_object() {
        for (name, inner) in table {
            let path = format!("{path}/{name}");
            found.push(path.clone());
            fields(inner, &path, found);
        }
    }
    for (i, inner) in value.as_array().into_iter().flatten().enumerate() {
        fields(inner, &format!("{path}/{i}"), found);
    }
}

/// The message about a file whose table at `path` was changed, if it is refused.
fn reported(file: &Value, path: &str, change: impl FnOnce(&mut Value, &str)) -> Option<String> {
    let mut file = file.clone();
    let (holder, name) = path.rsplit_once('/').unwrap();
    change(file.pointer_mut(holder).unwrap(), name);
    let text = serde_json::to_string_pretty(&file).unwrap();
    parse(&text, "a.json")
        .err()
        .map(|reported| reported.to_string())
}

/// Every field of a file is known here, and its problems are reported in Helicoid's
/// messages, with its line: misspelled, absent, of another kind.
#[test]
fn every_field_is_reported_by_its_name() {
    for section in [full(), curved()] {
        let file: Value = serde_json::from_str(&write(&section)).unwrap();
        let mut paths = Vec::new();
        fields(&file, "", &mut paths);
        assert!(paths.len() > 30);
        for path in paths.iter().filter(|path| *path != "/format") {
            let name = path.rsplit('/').next().unwrap();
            let ours = |reported: &str| {
                assert!(
                    !reported.contains('`') && !reported.contains("invalid"),
                    "{path}: {reported}"
                );
            };
            let misspelled = reported(&file, path, |table, name| {
                let table = table.as_object_mut().unwrap();
                let value = table.remove(name).unwrap();
                table.insert(format!("{name}x"), value);
            });
            let misspelled = misspelled.unwrap();
            ours(&misspelled);
            let unknown = format!("{name}x\"");
            let near = format!("\n  help: did you mean \"{name}\"?");
            assert!(misspelled.contains(&unknown), "{path}: {misspelled}");
            assert!(misspelled.contains(&near), "{path}: {misspelled}");
            assert!(
                misspelled.starts_with("error: a.json:"),
                "{path}: {misspelled}"
            );
            assert_eq!(
                misspelled.matches("error: ").count(),
                1,
                "{path}: {misspelled}"
            );

            let absent = reported(&file, path, |table, name| {
                table.as_object_mut().unwrap().remove(name);
            });
            absent.iter().for_each(|absent| ours(absent));

            let other = reported(&file, path, |table, name| table[name] = json!(true));
            let other = other.unwrap();
            ours(&other);
            assert!(other.contains(&format!("{name}\"")), "{path}: {other}");
            assert!(other.contains(" is true, expected "), "{path}: {other}");
        }
    }
}

/// All errors at once, in the order of their lines.
#[test]
fn all_slips_are_reported_together() {
    let mut text = write(&full());
    for (old, new) in [
        ("\"stiffness\"", "\"stifness\""),
        ("\"tension\"", "\"tensoin\""),
        ("\"free_strain\"", "\"free strain\""),
        ("\"nodes\"", "\"cells\""),
        ("\"mass\"", "\"weight\""),
    ] {
        assert!(text.contains(old), "{old}: {text}");
        text = text.replacen(old, new, 1);
    }
    let line = |key: &str| 1 + text.lines().position(|line| line.contains(key)).unwrap();
    let shown = parse(&text, "a.json").unwrap_err().to_string();
    let weight = line("\"weight\"");
    let location = |key: &str| format!("error: a.json:{}: ", line(key));
    let again = text
        .lines()
        .enumerate()
        .filter(|line| line.1.contains("\"cells\""));
    let again = again.last().unwrap().0 + 1;
    for expected in [
        "error: a.json: \"mass\" is missing, expected 6 rows of 6 numbers".to_owned(),
        format!(
            "{}unknown field \"stifness\"\n  help: did you mean \"stiffness\"?",
            location("stifness")
        ),
        format!(
            "{}unknown field \"centers.tensoin\"\n  help: did you mean \"tension\"?",
            location("tensoin")
        ),
        format!(
            "{}unknown field \"free strain\" of the imposed state \"hot\"\n  help: did you mean \
             \"free_strain\"?",
            location("free strain")
        ),
        format!(
            "error: a.json:{again}: \"provenance.cells\" is given a second time, expected it once"
        ),
        format!(
            "error: a.json:{weight}: unknown field \"weight\"\n  help: known fields: format, version, "
        ),
    ] {
        assert!(shown.contains(&expected), "{expected}\n{shown}");
    }
    assert_eq!(shown.matches("error: ").count(), 6, "{shown}");
}

/// Lists of tables, matrices by rows and dampings of two kinds.
#[test]
fn wrong_lists_are_reported() {
    let file: Value = serde_json::from_str(&write(&full())).unwrap();
    let cases = [
        (
            "/imposed",
            json!([7]),
            "the imposed state 1 is 7, expected a table",
        ),
        (
            "/piezo/coupling",
            json!([[1], 2]),
            "row 2 of \"piezo.coupling\" is 2, expected numbers",
        ),
        (
            "/piezo/electrodes",
            json!(["top", 1]),
            "\"piezo.electrodes\" is an array with the text \"top\", expected a list of texts",
        ),
        (
            "/damping",
            json!({}),
            "\"damping\" is a table, expected a table with either \"stiffness_proportional\" or \
             \"viscous\"",
        ),
        (
            "/damping",
            json!("viscous"),
            "\"damping\" is the text \"viscous\", expected a table with",
        ),
        (
            "/provenance/nodes",
            json!(-1),
            "\"provenance.nodes\" is -1, expected a whole number",
        ),
    ];
    for (path, value, expected) in cases {
        let shown = reported(&file, path, |table, name| table[name] = value).unwrap();
        assert!(shown.contains(expected), "{shown}");
    }
}

/// A problem of a state is reported with its name and line, even after other states.
#[test]
fn a_skew_change_is_reported_of_its_state() {
    let mut section = full();
    let mut cold = section.imposed[0].clone();
    cold.name = "cold".to_owned();
    if let Some(change) = &mut cold.stiffness_change {
        change[(0, 3)] = 100.0;
    }
    section.imposed.push(cold);
    let text = write(&section);
    let lines = text.lines().enumerate();
    let changes = lines.filter(|(_, line)| line.contains("stiffness_change"));
    let line = changes.last().unwrap().0 + 1;
    assert_eq!(
        parse(&text, "a.json").unwrap_err().to_string(),
        format!(
            "error: a.json:{line}: imposed state \"cold\": stiffness_change is not symmetric: entry \
             (1, 4) is 1e2 and (4, 1) is 1e-1\n  help: the order is axial, torsion, bending y, bending z"
        )
    );
}
