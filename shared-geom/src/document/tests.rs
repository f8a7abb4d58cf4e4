//! Tests of the reader: values in SI units, and every problem at its line.

use super::*;

const TEXT: &str = r#"
[units]
length = "in"
force = "lbf"

[material.alu]
young = 10.6e6
poisson = 0.3
density = "2700 kg/m^3"

[[region]]
group = "skin"
offset = [1, 2.5, "25.4 mm"]
"#;

#[test]
fn values_come_in_si() {
    let document = Document::parse(TEXT, "a.toml").unwrap();
    let root = document.root();
    document.declare_units(&root);
    let materials = root.named_tables("material");
    let (name, alu) = &materials[0];
    assert_eq!(name, "alu");
    let young = alu.require_positive("young", Dimension::STRESS).unwrap();
    assert!((young / (10.6e6 * 6_894.757_293_168) - 1.0).abs() < 1e-12);
    assert_eq!(alu.quantity("density", Dimension::DENSITY), Some(2700.0));
    assert_eq!(alu.quantity("poisson", Dimension::NUMBER), Some(0.3));
    let region = &root.tables("region")[0];
    let offset = region.vector("offset", Dimension::LENGTH).unwrap();
    assert_eq!(offset, nalgebra::Vector3::new(0.0254, 2.5 * 0.0254, 0.0254));
    assert_eq!(region.require_text("group", "a name").unwrap(), "skin");
    for table in [&root, alu, region] {
        table.finish();
    }
    assert!(document.finish(Some(())).is_ok());
}

/// Problems of `text` when `read` asks for its values.
fn problems(text: &str, read: impl Fn(&Table<'_>)) -> String {
    let document = Document::parse(text, "a.toml").unwrap();
    let root = document.root();
    read(&root);
    root.finish();
    document.finish(Some(())).unwrap_err().to_string()
}

#[test]
fn all_problems_come_at_once_with_lines() {
    let text = "units = \"SI\"\nlenght = 3\nwidth = \"4 kg\"\ncells = 0\nkind = \"quad5\"\n";
    let shown = problems(text, |root| {
        root.document().declare_units(root);
        assert_eq!(root.require_quantity("length", Dimension::LENGTH), None);
        assert_eq!(root.quantity("width", Dimension::LENGTH), None);
        assert_eq!(root.count("cells"), None);
        assert_eq!(root.word("kind", &["quad4", "quad8"]), None);
    });
    let expected = "\
error: a.toml:1: the file has no \"length\", expected a length
error: a.toml:2: unknown key \"lenght\" in the file
  help: did you mean \"length\"?
error: a.toml:3: \"width\": \"kg\" measures a mass, expected a length
  help: units of it: m, mm, cm, km, um, in, ft
error: a.toml:4: \"cells\" is 0, expected a whole number of at least 1
error: a.toml:5: \"kind\" is \"quad5\", expected one of \"quad4\", \"quad8\"
  help: did you mean \"quad4\"?";
    assert_eq!(shown, expected);
}

#[test]
fn a_text_is_a_list_of_one_text() {
    let text = "one = \"a\"\ntwo = [\"a\", \"b\"]\nnone = []\n";
    let document = Document::parse(text, "a.toml").unwrap();
    let root = document.root();
    assert_eq!(root.texts("one").unwrap(), ["a"]);
    assert_eq!(root.texts("two").unwrap(), ["a", "b"]);
    assert!(root.texts("none").unwrap().is_empty());
    assert_eq!(root.texts("absent"), None);
    root.finish();
    assert!(document.finish(Some(())).is_ok());

    let wrong = problems("number = 3\nmixed = [\"a\", 1,\n true]\n", |root| {
        assert_eq!(root.texts("number"), None);
        assert_eq!(root.texts("mixed"), None);
    });
    let expected = "\
error: a.toml:1: \"number\" is 3, expected a text in quotes, or a list of texts
error: a.toml:2: \"mixed\" is 1, expected a text in quotes
error: a.toml:3: \"mixed\" is true, expected a text in quotes";
    assert_eq!(wrong, expected);
}

#[test]
fn numbers_and_units_that_cannot_be_read_are_shown_short() {
    let text = "units = \"imperial\"\nhuge = 1e308\njoined = \"70GPa\"\n";
    let shown = problems(text, |root| {
        root.document().declare_units(root);
        assert_eq!(root.word("huge", &["a"]), None);
        assert_eq!(root.quantity("joined", Dimension::STRESS), None);
    });
    let expected = "\
error: a.toml:1: \"units\" is the text \"imperial\", expected \"SI\", or a table of units
error: a.toml:2: \"huge\" is 1e308, expected a text in quotes
error: a.toml:3: \"joined\": \"70GPa\" cannot be read, expected a number, a space and a unit, as in \"73.1 GPa\"";
    assert_eq!(shown, expected);
}

#[test]
fn a_folder_is_no_file() {
    let shown = Document::read(Path::new(".")).unwrap_err();
    assert_eq!(
        shown.to_string(),
        "error: .: cannot be read: it is a folder"
    );
}

#[test]
fn undeclared_and_unknown_units_are_errors() {
    let none = problems("a = 1\n", |root| {
        root.document().declare_units(root);
        let _ = root.quantity("a", Dimension::LENGTH);
    });
    assert!(none.contains("has no \"units\""), "{none}");
    let wrong = problems("[units]\nlength = \"inch\"\n", |root| {
        root.document().declare_units(root);
    });
    assert!(
        wrong.contains("a.toml:2: \"length\": unknown unit \"inch\""),
        "{wrong}"
    );
    assert!(wrong.contains("did you mean \"in\"?"), "{wrong}");
}

#[test]
fn syntax_errors_carry_their_lines() {
    let shown = Document::parse("a = 1\nb = \nc = [1,\n", "a.toml").unwrap_err();
    assert!(
        shown.to_string().contains("a.toml:2: not valid TOML"),
        "{shown}"
    );
}

#[test]
fn numbers_must_be_finite() {
    for text in [
        "a = nan",
        "a = inf",
        "a = 1e999",
        "a = 99999999999999999999999",
    ] {
        let document = Document::parse(text, "a.toml");
        if let Ok(document) = document {
            let value = document.root().quantity("a", Dimension::NUMBER);
            assert!(value.is_none_or(f64::is_finite), "{text}");
        }
    }
}

#[test]
fn a_missing_file_is_named() {
    let shown = Document::read(Path::new("no/such.toml")).unwrap_err();
    assert_eq!(
        shown.to_string(),
        "error: no/such.toml: cannot be read: no such file"
    );
}

/// A long text of another kind must not bury its first error.
#[test]
fn errors_of_syntax_are_counted_after_the_first() {
    let shown = Document::parse(&"a b\n".repeat(1000), "a.toml")
        .unwrap_err()
        .to_string();
    assert!(
        shown.starts_with("error: a.toml:1: not valid TOML"),
        "{shown}"
    );
    assert!(
        shown.contains("a.toml:9: further errors of syntax from here on: "),
        "{shown}"
    );
    assert_eq!(shown.lines().count(), SYNTAX_SHOWN + 1);
}

#[test]
fn a_file_of_another_kind_is_told_as_such() {
    let texts = [
        ("$MeshFormat\n4.1 0 8\n", "a gmsh mesh"),
        (
            "{\n \"format\": 1\n}\n",
            "a JSON file, as property files are",
        ),
        ("<?xml version=\"1.0\"?>\n", "an XML file"),
    ];
    for (text, what) in texts {
        let shown = Document::parse(text, "a.toml").unwrap_err().to_string();
        let expected = format!("error: a.toml: the file is {what}, expected an input file in TOML");
        assert!(shown.starts_with(&expected), "{shown}");
        assert_eq!(shown.matches("error:").count(), 1, "{shown}");
    }
}
