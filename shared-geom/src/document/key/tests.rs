use nalgebra::Vector3;

use crate::document::schema::ValueKind::{
    Boolean, Count, NamedTables, NotNegative, Numbers, Positive, Quantity, Rows, Table as OneTable,
    Tables, Text, Texts, Vector, Vectors, Word, Words,
};
use crate::document::schema::{Family, Need, TableSchema};
use crate::document::{ByHand, Document, Nested, NestedByName, NestedList};
use crate::units::Dimension;
use crate::{choice, keys};

keys! {
    /// A part.
    PART = "[[part]]";
    /// The name of the part; used elsewhere.
    NAME: String = "name", [Text], required, "\"a\"";
    /// Its
    /// mass.
    MASS: f64 = "mass", [Positive(Dimension::MASS)], required, "2";
    /// Position of its center.
    CENTER: Vector3<f64> = "center", [Vector(3, Dimension::LENGTH)], or "[0, 0, 0]" = Vector3::zeros(), "[1, 0, 0]";
    /// Side of the part.
    SIDE: usize = "side", [Word(&["left", "middle", "right"])], required, "\"left\"";
    /// Friction.
    FRICTION: Option<f64> = "friction", [NotNegative(Dimension::NUMBER)], optional, "0.1";
    /// Axes.
    AXES: usize = "axes", [Word(&["model", "node"])], or "\"model\"" = 0, "\"node\"";
    /// Whether it stays.
    FIXED: bool = "fixed", [Boolean], or "false" = false, "true";
    /// Number of copies.
    COPIES: usize = "copies", [Count(9)], or "1" = 1, "3";
    /// Others.
    OTHERS: Option<Vec<String>> = "others", [Texts], optional, "[\"b\"]";
    /// Anything.
    SHAPE: ByHand = "shape", [Text, OneTable(&SHAPE_TABLE)], or "the usual one", "\"round\"";
}

const SHAPE_TABLE: TableSchema = TableSchema {
    title: "shape = { ... }",
    meaning: "A shape.",
    keys: &[FRICTION.schema],
    families: &[],
};

keys! {
    /// The file.
    FILE = "a.toml";
    /// Parts.
    PARTS: ByHand = "part", [NamedTables(&PART)], optional, "";
    /// Speed.
    SPEED: f64 = "speed", [Quantity(Dimension::VELOCITY)], or "0" = 0.0, "2";
}

/// The problems of a file with one part, of which `read` reads the keys.
fn problems(text: &str, read: impl Fn(&crate::document::Table<'_>)) -> String {
    let document = Document::parse(&format!("[part.p]\n{text}"), "a.toml").unwrap();
    let root = document.root_of(&FILE);
    for (_, table) in root.named_tables("part") {
        read(&table);
        table.finish();
    }
    root.finish();
    document
        .finish(Some(()))
        .map_or_else(|problems| problems.to_string(), |()| String::new())
}

#[test]
fn values_come_by_their_declaration() {
    let text = "name = \"a\"\nmass = \"2 g\"\naxes = \"node\"\nfixed = true\ncopies = 3\n\
                others = \"b\"\ncenter = [1, \"2 mm\", 0]\nfriction = 0\n";
    let shown = problems(text, |table| {
        assert_eq!(table.get(&NAME).as_deref(), Some("a"));
        assert_eq!(table.get(&MASS), Some(0.002));
        assert_eq!(table.get(&CENTER), Some(Vector3::new(1.0, 0.002, 0.0)));
        assert_eq!(table.get(&FRICTION), Some(Some(0.0)));
        assert_eq!(table.get(&AXES), Some(1));
        assert_eq!(table.get(&FIXED), Some(true));
        assert_eq!(table.get(&COPIES), Some(3));
        assert_eq!(table.get(&OTHERS), Some(Some(vec!["b".to_owned()])));
    });
    assert_eq!(shown, "");
}

#[test]
fn absent_keys_have_their_defaults_or_are_reported() {
    let shown = problems("shape = \"round\"\n", |table| {
        assert_eq!(table.get(&NAME), None);
        assert_eq!(table.get(&MASS), None);
        assert_eq!(table.get(&SIDE), None);
        assert_eq!(table.get(&CENTER), Some(Vector3::zeros()));
        assert_eq!(table.get(&FRICTION), Some(None));
        assert_eq!(table.get(&AXES), Some(0));
        assert_eq!(table.get(&COPIES), Some(1));
        assert!(table.has(&SHAPE));
    });
    // The message names the opening of the meaning, or the quantity.
    for expected in [
        "part \"p\" has no \"name\", expected the name of the part",
        "part \"p\" has no \"mass\", expected a mass",
        "part \"p\" has no \"side\", expected \"left\", \"middle\" or \"right\"",
    ] {
        assert!(shown.contains(expected), "{expected} is not in\n{shown}");
    }
    assert_eq!(MASS.schema.meaning, "Its mass.");
    assert_eq!(CENTER.schema.need, Need::Default("[0, 0, 0]"));
    assert_eq!(SHAPE.schema.need, Need::Default("the usual one"));
}

#[test]
fn counts_have_a_limit() {
    let shown = problems("name = \"a\"\ncopies = 10\n", |table| {
        assert_eq!(table.get(&COPIES), None);
    });
    assert!(
        shown.contains("a.toml:3: \"copies\" is 10, expected at most 9"),
        "{shown}"
    );
}

#[test]
fn wrong_expressions_are_reported_with_their_value() {
    let text = "mass = \"= 2 - 3.5\"\nname = \"a\"\nfriction = \"= -0.1 - 0.2\"\n";
    let shown = problems(text, |table| {
        assert_eq!(table.get(&MASS), None);
        assert_eq!(table.get(&FRICTION), None);
        assert!(table.has(&NAME));
    });
    for expected in [
        "\"mass\" is -1.5, the value of \"= 2 - 3.5\", expected a mass greater than zero",
        "\"friction\" is -0.3, the value of \"= -0.1 - 0.2\", expected a pure number, zero or more",
    ] {
        assert!(shown.contains(expected), "{expected} is not in\n{shown}");
    }
}

#[test]
fn wrong_values_are_none_and_reported() {
    let text = "name = 3\nmass = 0\nfriction = -1\naxes = \"nod\"\ncopies = 0\nfixed = 1\n";
    let shown = problems(text, |table| {
        assert_eq!(table.get(&NAME), None);
        assert_eq!(table.get(&MASS), None);
        assert_eq!(table.get(&FRICTION), None);
        assert_eq!(table.get(&AXES), None);
        assert_eq!(table.get(&COPIES), None);
        assert_eq!(table.get(&FIXED), None);
    });
    for expected in [
        "a.toml:2: \"name\" is 3, expected a text in quotes",
        "a.toml:3: \"mass\" is 0, expected a mass greater than zero",
        "a.toml:4: \"friction\" is -1, expected a pure number, zero or more",
        "a.toml:5: \"axes\" is \"nod\", expected one of \"model\", \"node\"",
        "a.toml:6: \"copies\" is 0, expected a whole number of at least 1",
        "a.toml:7: \"fixed\" is 1, expected true or false",
    ] {
        assert!(shown.contains(expected), "{expected} is not in\n{shown}");
    }
}

// A reader cannot use a key that is not declared: it is refused, although it was requested.
// A declared key is accepted, also if the reader stopped before it.
#[test]
fn only_declared_keys_are_keys() {
    let shown = problems(
        "name = \"a\"\nzqj = 1\nfrictoin = 2\nshape = \"round\"\n",
        |table| {
            table.get(&FRICTION);
            table.get(&NAME);
            assert!(table.has("zqj"));
        },
    );
    assert!(
        shown.contains("unknown key \"zqj\" in part \"p\"\n  help: known keys: name, mass, center, side, friction, axes"),
        "{shown}"
    );
    assert!(shown.contains("did you mean \"friction\"?"), "{shown}");
    assert_eq!(shown.matches("unknown key").count(), 2, "{shown}");
    // Also in a table of a table.
    let shown = problems("shape = { friction = 1, zqj = 2 }\n", |table| {
        let shape = table.table(SHAPE.name()).unwrap();
        assert_eq!(shape.get(&FRICTION), Some(Some(1.0)));
        assert!(shape.has("zqj"));
        shape.finish();
    });
    assert!(
        shown.contains("unknown key \"zqj\" in [part.p.shape]\n  help: known keys: friction"),
        "{shown}"
    );
}

keys! {
    /// Its point, y and z.
    POINT: [f64; 2] = "point", [Vector(2, Dimension::LENGTH)] as "an array of 2, y and z",
        required, "[1, 2]";
    /// Weights.
    WEIGHTS: Vec<f64> = "weights", [Numbers(3)], or "[1]" = vec![1.0], "[1, 2]";
    /// Points on it.
    POINTS: Option<Vec<Vector3<f64>>> = "points", [Vectors(3, Dimension::LENGTH)],
        or "the corners", "[[0, 0, 0]]";
    /// Its matrix.
    MATRIX: [[f64; 2]; 2] = "matrix", [Rows(2, 2)], required, "[[1, 0], [0, 1]]";
    /// Direction of the part, of any length.
    DIRECTION: Vector3<f64> = "direction", [Vector(3, Dimension::NUMBER)], required, "[1, 0, 0]";
}

// A text of the declaration replaces the one that follows from kind and meaning; a default
// that is a rule is none.
#[test]
fn lists_have_the_sizes_of_their_declaration() {
    let text = "point = [1, \"2 mm\"]\npoints = [1, 2, 3]\nmatrix = [[1, 2], [3, 4]]\n";
    let found = Document::parse(text, "a.toml").unwrap();
    let table = found.root();
    assert_eq!(table.get(&POINT), Some([1.0, 0.002]));
    assert_eq!(table.get(&WEIGHTS), Some(vec![1.0]));
    assert_eq!(
        table.get(&POINTS),
        Some(Some(vec![Vector3::new(1.0, 2.0, 3.0)]))
    );
    assert_eq!(table.get(&MATRIX), Some([[1.0, 2.0], [3.0, 4.0]]));
    assert_eq!(
        Document::parse("", "a.toml").unwrap().root().get(&POINTS),
        Some(None)
    );

    let text = "point = [1]\nweights = [1, 2, 3, 4]\nmatrix = [[1, 2]]\n";
    let document = Document::parse(text, "a.toml").unwrap();
    let table = document.root();
    assert_eq!(table.get(&POINT), None);
    assert_eq!(table.get(&WEIGHTS), None);
    assert_eq!(table.get(&MATRIX), None);
    assert_eq!(table.get(&DIRECTION), None);
    assert_eq!(table.given(&DIRECTION), None);
    let shown = document.finish(Some(())).unwrap_err().to_string();
    let expected = "\
error: a.toml:1: \"point\" is an array of 1, expected an array of 2, y and z
error: a.toml:1: the file has no \"direction\", expected direction of the part
error: a.toml:2: \"weights\" is an array of 4, expected an array of 1 to 3 numbers
error: a.toml:3: \"matrix\" is an array of 1, expected 2 rows of 2 numbers";
    assert_eq!(shown, expected);
}

#[test]
fn conditions_of_values_are_reported() {
    let shown = problems("mass = 2\nfriction = 3\n", |table| {
        assert_eq!(table.get_if(&MASS, |mass| *mass > 1.0, "more"), Some(2.0));
        let small = |friction: &Option<f64>| friction.is_none_or(|friction| friction < 1.0);
        assert_eq!(table.get_if(&FRICTION, small, "less than 1"), None);
        assert_eq!(table.get_if(&COPIES, |copies| *copies == 2, "two"), None);
    });
    assert_eq!(
        shown,
        "error: a.toml:3: \"friction\" is 3, expected less than 1"
    );
}

#[test]
fn families_are_distinguished_by_a_word() {
    const KIND: [&str; 2] = ["kind", "Its kind."];
    const FORMS: TableSchema = TableSchema {
        title: "[form]",
        meaning: "A form.",
        keys: &[],
        families: &[
            Family {
                name: "round",
                meaning: "Round.",
                keys: &[choice!(KIND, "circle", "ring")],
            },
            Family {
                name: "other",
                meaning: "Other.",
                keys: &[choice!(KIND, "square", "ring")],
            },
        ],
    };
    assert_eq!(FORMS.words("kind"), ["circle", "ring", "square"]);
    for (text, word, reported) in [
        ("kind = \"ring\"", Some("ring"), ""),
        (
            "",
            None,
            "has no \"kind\", expected one of circle, ring, square",
        ),
        ("kind = \"rink\"", None, "did you mean \"ring\"?"),
    ] {
        let document = Document::parse(text, "a.toml").unwrap();
        let root = document.root();
        assert_eq!(root.has_choice(&FORMS, "kind"), word.is_some());
        assert_eq!(root.choice(&FORMS, "kind"), word);
        let shown = document
            .finish(Some(()))
            .map_or_else(|p| p.to_string(), |()| String::new());
        assert!(shown.contains(reported), "{shown}");
    }
}

keys! {
    /// A file of tables.
    TABLES = "b.toml";
    /// The main hole.
    MAIN: Nested = "main", [OneTable(&HOLE)], required, "";
    /// A spare hole.
    SPARE: Nested = "spare", [OneTable(&HOLE)], optional, "";
    /// Holes.
    HOLES: NestedList = "hole", [Tables(&HOLE)], optional, "";
    /// Holes by name.
    NAMED: NestedByName = "named", [NamedTables(&HOLE)], optional, "";
    /// Where.
    SIDES: Option<Vec<usize>> = "sides", [Words(&["left", "right"])], optional, "\"left\"";
}

keys! {
    /// A hole.
    HOLE = "hole";
    /// Its diameter.
    BORE: f64 = "bore", [Positive(Dimension::LENGTH)], required, "2";
}

/// The tables under the declared keys of a text.
#[derive(Debug, PartialEq)]
struct Holes {
    main: Option<f64>,
    list: Option<Vec<f64>>,
    named: Option<Vec<(String, f64)>>,
}

/// The tables of a text, and its problems.
fn holes(text: &str) -> (Holes, String) {
    let document = Document::parse(text, "b.toml").unwrap();
    let root = document.root_of(&TABLES);
    let found = Holes {
        main: root.nested(&MAIN, |table| table.get(&BORE)).flatten(),
        list: root.each(&HOLES, |table| table.get(&BORE)),
        named: root.each_by_name(&NAMED, |_, table| table.get(&BORE)),
    };
    assert_eq!(root.nested(&SPARE, |_| Some(())), Some(None));
    root.finish();
    let reported = document.finish(Some(())).err();
    let reported = reported.map(|problems| problems.to_string());
    (found, reported.unwrap_or_default())
}

#[test]
fn tables_are_read_by_their_declarations() {
    let text = "[main]\nbore = 1\n[[hole]]\nbore = 2\n[[hole]]\nbore = 3\n[named.a]\nbore = 4\n";
    let expected = Holes {
        main: Some(1.0),
        list: Some(vec![2.0, 3.0]),
        named: Some(vec![("a".to_owned(), 4.0)]),
    };
    assert_eq!(holes(text), (expected, String::new()));
    assert_eq!(holes("[main]\nbore = 1\n").0.list, Some(Vec::new()));
    let text = "[[hole]]\nbore = 0\nbroe = 2\n[[hole]]\n[named.a]\nb = 1\n";
    let (found, reported) = holes(text);
    let expected = Holes {
        main: None,
        list: None,
        named: None,
    };
    assert_eq!(found, expected);
    for part in [
        "b.toml:1: the file has no \"main\", expected the main hole",
        "b.toml:2: \"bore\" is 0",
        "b.toml:3: unknown key \"broe\"",
        "b.toml:4: [[hole]] number 2 has no \"bore\"",
        "b.toml:6: unknown key \"b\"",
    ] {
        assert!(reported.contains(part), "{part}\n{reported}");
    }
}

#[test]
fn words_are_indices_and_all_wrong_ones_are_noted() {
    let read = |text: &str| {
        let document = Document::parse(text, "b.toml").unwrap();
        let found = document.root().get(&SIDES);
        let reported = document
            .finish(Some(()))
            .err()
            .map(|problems| problems.to_string());
        (found, reported.unwrap_or_default())
    };
    assert_eq!(
        read("sides = [\"right\", \"left\"]"),
        (Some(Some(vec![1, 0])), String::new())
    );
    assert_eq!(
        read("sides = \"right\""),
        (Some(Some(vec![1])), String::new())
    );
    assert_eq!(read(""), (Some(None), String::new()));
    let (found, reported) = read("sides = [\"rigth\", \"up\"]");
    assert_eq!(
        (found, reported.matches("error:").count()),
        (None, 2),
        "{reported}"
    );
    assert!(reported.contains("did you mean \"right\"?"), "{reported}");
}
