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

/// Problems of `text` when `read` requests its values.
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
    let text = "units = \"imperial\"\nhuge = 1e308\njoined = \"70,5GPa\"\n";
    let shown = problems(text, |root| {
        root.document().declare_units(root);
        assert_eq!(root.word("huge", &["a"]), None);
        assert_eq!(root.quantity("joined", Dimension::STRESS), None);
    });
    let expected = "\
error: a.toml:1: \"units\" is the text \"imperial\", expected \"SI\", or a table as in { length = \"mm\", force = \"N\" }
error: a.toml:2: \"huge\" is 1e308, expected a text in quotes
error: a.toml:3: \"joined\": \"70,5GPa\" cannot be read, expected a number and a unit, as in \"73.1 GPa\"
  help: write \"70.5GPa\", with a decimal point";
    assert_eq!(shown, expected);
}

#[test]
fn a_folder_is_no_file() {
    let folder = tempfile::tempdir().unwrap();
    let shown = || Document::read(folder.path()).unwrap_err().to_string();
    let expected = "cannot be read: it is a folder";
    assert!(shown().ends_with(expected), "{}", shown());
    for name in ["a.png", "b.toml"] {
        std::fs::write(folder.path().join(name), "").unwrap();
    }
    let expected = format!("{expected}\n  help: name a file in it: b.toml");
    assert!(shown().ends_with(&expected), "{}", shown());
}

#[test]
fn undeclared_and_unknown_units_are_errors() {
    let none = problems("a = 1\n", |root| {
        root.document().declare_units(root);
        let _ = root.quantity("a", Dimension::LENGTH);
    });
    assert!(none.contains("has no \"units\""), "{none}");
    let wrong = problems("[units]\nlength = \"mmm\"\n", |root| {
        root.document().declare_units(root);
    });
    assert!(
        wrong.contains("a.toml:2: \"length\": unknown unit \"mmm\""),
        "{wrong}"
    );
    assert!(wrong.contains("did you mean \"mm\"?"), "{wrong}");
}

#[test]
fn syntax_errors_carry_their_lines() {
    let shown = Document::parse("a = 1\nb = \nc = [1,\n", "a.toml").unwrap_err();
    assert!(
        shown.to_string().contains("a.toml:2: not valid TOML"),
        "{shown}"
    );
}

// Three numbers of one list cause three errors of the parser.
#[test]
fn slips_of_syntax_are_reported_once_and_with_what_is_meant() {
    let reported = |text: &str| Document::parse(text, "a.toml").unwrap_err().to_string();
    let shown = reported("[a]\ninertia = [.3,.4,.5]\n");
    assert_eq!(shown.matches("error").count(), 1, "{shown}");
    assert!(
        shown.starts_with("error: a.toml:2: not valid TOML: invalid mantissa")
            && shown.ends_with("a digit on both sides of the point: 0.3"),
        "{shown}"
    );
    for (text, meant) in [
        ("a = -.5e3", "-0.5e3"),
        ("a = 5.", "5.0"),
        ("a = 2.e-3 # x", "2.0e-3"),
        ("a = -70,05 # x", "-70.05"),
    ] {
        let shown = reported(text);
        assert!(shown.ends_with(&format!(": {meant}")), "{text}: {shown}");
    }
    assert!(!reported("a = 0x\nb = = 1\n").contains("help"));
}

#[test]
fn keys_that_are_there_twice_are_named_with_the_line_of_the_first() {
    for (text, expected) in [
        (
            "x = 1\n[a]\nx = 2\ny = { x = 3 }\nx = 4\n",
            "a.toml:5: not valid TOML: duplicate key \"x\", first on line 3",
        ),
        (
            "[a]\nb = 1\n[c]\n[a]\nb = 2\n",
            "a.toml:4: not valid TOML: duplicate key \"a\", first on line 1",
        ),
        (
            "a = { \"x\" = 1, x = 2 }\n",
            "a.toml:1: not valid TOML: duplicate key \"x\", first on line 1",
        ),
    ] {
        let shown = Document::parse(text, "a.toml").unwrap_err().to_string();
        assert!(shown.contains(expected), "{shown}");
    }
    let text = "[material.al]\n[material.al]\n";
    let shown = Document::parse(text, "a.toml").unwrap_err().to_string();
    let expected =
        "keep one of them, or give one another name; tables of a list are [[material.al]]";
    assert!(shown.ends_with(expected), "{shown}");
    let text = "[a]\nx = 1\ny = 2\n[a] # once more\nx = 1\ny = 2\n[b]\nx = 1\nx = 2\n";
    let shown = Document::parse(text, "a.toml").unwrap_err().to_string();
    let expected = "error: a.toml:4: not valid TOML: duplicate key \"a\", first on line 1\n  \
                    help: keep one of them; tables of a list are [[a]]\n\
                    error: a.toml:9: not valid TOML: duplicate key \"x\", first on line 8";
    assert_eq!(shown, expected);
}

/// Also in tables of named tables, and in lists of lists of tables.
#[test]
fn tables_in_tables_are_named_with_their_path() {
    let text = "\
[[blade]]
[[blade.piece]]
[[blade.piece.mass]]
kg = 1
[blade.piece.law]
kn = 2
[material.steel.electric]
at = { d3 = 1 }
";
    let shown = problems(text, |root| {
        for blade in root.tables("blade") {
            for piece in blade.tables("piece") {
                let law = piece.table("law");
                for table in piece.tables("mass").into_iter().chain(law) {
                    table.finish();
                }
                piece.finish();
            }
            blade.finish();
        }
        for (_, steel) in root.named_tables("material") {
            let electric = steel.table("electric").unwrap();
            electric.table("at").unwrap().finish();
            electric.finish();
            steel.finish();
        }
    });
    for expected in [
        "a.toml:4: unknown key \"kg\" in [[blade.piece.mass]] number 1",
        "a.toml:6: unknown key \"kn\" in [blade.piece.law]",
        "a.toml:8: unknown key \"d3\" in [material.steel.electric.at]",
    ] {
        assert!(shown.contains(expected), "{shown}");
    }
    let shown = problems("[a]\nb = { c = 1 }\n", |root| {
        let inner = root.table("a").unwrap().table("b").unwrap();
        assert!(inner.tables("c").is_empty());
    });
    assert!(shown.contains("expected tables [[a.b.c]]"), "{shown}");
}

/// The number of a parameter, or the messages.
fn parameter(text: &str, name: &str) -> Result<f64, String> {
    let document = Document::parse(text, "a.toml").unwrap();
    document.declare_parameters(&document.root());
    let known = document.parameters().clone();
    let found = known.iter().find(|own| own.0 == name).map(|own| own.1);
    document
        .finish(found)
        .map_err(|problems| problems.to_string())
}

// Names in another order than their dependence.
#[test]
fn parameters_are_found_in_any_order() {
    let text =
        "[parameters]\nz = 2\na = \"= b + z*c\"\nc = \"= b^2 - pi + pi\"\nb = \"= 1 + z + z\"\n";
    assert_eq!(parameter(text, "a"), Ok(5.0 + 2.0 * 25.0));
    let wrong = parameter("[parameters]\na = \"= 1/b\"\nb = \"= c - 1\"\nc = 1\n", "a");
    assert!(wrong.unwrap_err().contains("a.toml:2: \"a\" is inf"));
    let slip = parameter(
        "[parameters]\na = \"= lenght + b\"\nlength = 1\nb = \"= a\"\n",
        "a",
    );
    let slip = slip.unwrap_err();
    assert!(slip.contains("did you mean \"length\"?"), "{slip}");
    // Dependents of a wrong parameter are not reported.
    assert_eq!(slip.matches("error").count(), 1, "{slip}");
}

// Two cycles, a parameter that depends on one, and an independent one: each cycle is
// reported once.
#[test]
fn cycles_of_parameters_are_named() {
    let text = "[parameters]\nq = \"= p\"\np = \"= r + q\"\nr = 1\ns = \"= s\"\nt = \"= q + r\"\n";
    let reported = parameter(text, "r").unwrap_err();
    assert!(
        reported.contains(
            "a.toml:3: the parameter \"p\" depends on itself: p -> q -> p\n  help: give one of them"
        ),
        "{reported}"
    );
    assert!(
        reported.contains(
            "a.toml:5: the parameter \"s\" depends on itself: s -> s\n  help: give \"s\" a number"
        ),
        "{reported}"
    );
    assert_eq!(reported.matches("error").count(), 2, "{reported}");
    let count = 2000;
    let ring = |i: usize| format!("p{i} = \"= p{}\"\n", (i + 1) % count);
    let text: String = (0..count).map(ring).collect();
    let reported = parameter(&format!("[parameters]\n{text}"), "p0").unwrap_err();
    assert!(
        reported.contains("p0 -> p1 -> p2 -> p3 -> p4 -> p5 -> p6 -> p7 -> (1992 more) -> p0\n"),
        "{reported}"
    );
}

// Quadratic time would be minutes here, and quadratic memory gigabytes.
#[test]
fn parameters_may_be_many() {
    const COUNT: usize = 30_000;
    let chain = |i: usize| format!("p{i} = \"= p{} + 1\"\n", i + 1);
    let text: String = (0..COUNT).map(chain).collect();
    let text = format!("[parameters]\n{text}p{COUNT} = 1\n");
    assert_eq!(parameter(&text, "p0"), Ok(COUNT as f64 + 1.0));
    let alone: String = (0..COUNT)
        .map(|i| format!("p{i} = \"= 2*{i}\"\n"))
        .collect();
    assert_eq!(parameter(&format!("[parameters]\n{alone}"), "p7"), Ok(14.0));
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
        "error: no/such.toml: cannot be read: there is no folder \"no\""
    );
    let shown = Document::read(Path::new("such.toml")).unwrap_err();
    let expected = "error: such.toml: cannot be read: no such file";
    assert!(shown.to_string().starts_with(expected), "{shown}");
}

/// Files in one missing folder are one message, at the first of them.
#[test]
fn a_missing_folder_is_named_once() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("tables")).unwrap();
    let file = folder.path().join("a.toml").display().to_string();
    let text = "a = \"none\"\nb = \"table/b.csv\"\nc = \"table/deep/c.csv\"\nd = \"table/d.csv\"\n";
    let document = Document::parse(text, &file).unwrap();
    let root = document.root();
    for key in ["a", "b", "c", "d"] {
        let written = root.text(key).unwrap();
        assert_eq!(root.existing(key, &written), None);
    }
    let shown = document.finish(Some(())).unwrap_err().to_string();
    let missing = folder.path().join("table").display().to_string();
    let expected = format!(
        "error: {file}:2: \"b\" is \"table/b.csv\", but there is no folder \"{missing}\"; 2 more \
         files are named in it\n  help: did you mean the folder \"tables\"?"
    );
    assert!(shown.ends_with(&expected), "{shown}");
    assert!(
        shown.contains("a.toml:1: \"a\": no file \"none\""),
        "{shown}"
    );
}

/// The folder is made by the test, with one file.
#[test]
fn the_nearest_name_of_a_missing_file_is_proposed() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("blade.dynamics.toml"), "").unwrap();
    let written = folder.path().join("blad.dynamics.toml");
    let shown = Document::read(&written).unwrap_err().to_string();
    let expected = "cannot be read: no such file\n  help: did you mean \"blade.dynamics.toml\"?";
    assert!(shown.ends_with(expected), "{shown}");
}

#[test]
fn numbers_that_overflow_are_refused() {
    let read = |text: &str| {
        let document = Document::parse(text, "a.toml").unwrap();
        let number = document.root().quantity("a", Dimension::FORCE);
        document.finish(number)
    };
    assert_eq!(read("a = -1e100").unwrap(), -1e100);
    for text in [
        "a = 1e101",
        "a = -1e300",
        "a = \"1e99 MN\"",
        "a = \"= 10^200\"",
    ] {
        let shown = read(text).unwrap_err().to_string();
        let expected = "expected a force, at most 1e100 in magnitude in SI units";
        assert!(shown.contains(expected), "{text}: {shown}");
    }
    let shown = read("a = inf").unwrap_err().to_string();
    assert!(shown.contains("expected a force, finite"), "{shown}");
}

#[test]
fn a_number_with_a_unit_is_a_text() {
    for (text, value) in [
        ("young = 7e10 Pa\nb = 1\n", "7e10 Pa"),
        ("[a]\nsize = [1, 2 mm, 3]\n", "2 mm"),
        ("size = { first = 0.1 s } # 3 m\n", "0.1 s"),
    ] {
        let shown = Document::parse(text, "a.toml").unwrap_err().to_string();
        let expected = format!("help: a number with a unit is a text: \"{value}\"");
        assert!(shown.contains(&expected), "{text}: {shown}");
    }
    let shown = Document::parse("a = b c\n", "a.toml").unwrap_err();
    assert!(!shown.to_string().contains("help"), "{shown}");
}

#[test]
fn an_array_of_tables_without_names_is_reported() {
    let shown = problems("[[material]]\nyoung = 1\n", |root| {
        assert!(root.named_tables("material").is_empty());
    });
    assert_eq!(
        shown,
        "error: a.toml:1: \"material\" is an array of 1, expected tables [material.NAME]"
    );
    let shown = problems("[[gravity]]\ng = 1\n", |root| {
        assert!(root.table("gravity").is_none());
    });
    let expected = "error: a.toml:1: \"gravity\" is an array of 1, expected one table [gravity]";
    assert_eq!(shown, expected);
}

#[test]
fn other_words_of_the_field_are_known() {
    let shown = problems("kind = \"hinge\"\n", |root| {
        let index = root.word_or_meant("kind", &["revolute", "pin"], &[("hinge", "revolute")]);
        assert_eq!(index, None);
    });
    assert!(
        shown.ends_with("help: did you mean \"revolute\"?"),
        "{shown}"
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
    assert_eq!(shown.lines().count(), super::syntax::SHOWN + 1);
}

#[test]
fn a_file_of_another_kind_is_reported_as_such() {
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
