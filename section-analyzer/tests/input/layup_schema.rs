//! The JSON schema of layup files against their reader, on random documents.

use std::path::{Path, PathBuf};

use jsonschema::Validator;
use section_analyzer::input::layup;
use section_analyzer::input::schema::LAYUP;
use toml::{Table, Value};

/// Files whose values are changed.
const FILES: [&str; 4] = [
    "wind_blade.layup.toml",
    "rotor_blade.layup.toml",
    "words_wind_blade.layup.toml",
    "words_propeller.layup.toml",
];
/// Messages about the meaning of values, which a schema does not know: names, orders and numbers of others,
/// units, materials, files, lines, and keys of which one excludes another.
const OF_MEANING: [&str; 27] = [
    "has no \"eta\"",
    "a name in one line",
    "expected more than 0",
    "is not in the file",
    "is the name of another",
    "expected one of",
    "expected as many values",
    "ascending",
    "as values",
    "has no ply thickness",
    "no file",
    "measures",
    "places go in a circle",
    "starts at arc",
    "is not a NACA airfoil",
    "at the position",
    "expected less than",
    "the matrix",
    "point",
    "is not on the contour",
    "by plies, and",
    "continue along",
    "unit",
    "column",
    "a length of the line",
    "has no effect",
    "it is nowhere",
];

/// Numbers from a seed (xorshift64*, Vigna 2016).
struct Random(u64);

impl Random {
    fn below(&mut self, count: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 33) as usize % count.max(1)
    }
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/layup/files")
}

/// All values below a value, the value itself included, by the steps that lead to them.
fn paths(value: &Value, path: &[String], found: &mut Vec<Vec<String>>) {
    found.push(path.to_vec());
    let mut step = |name: String, inner: &Value| paths(inner, &[path, &[name]].concat(), found);
    match value {
        Value::Table(table) => table
            .iter()
            .for_each(|(key, inner)| step(key.clone(), inner)),
        Value::Array(list) => {
            (0..)
                .zip(list)
                .for_each(|(i, inner): (usize, _)| step(i.to_string(), inner));
        }
        _ => {}
    }
}

/// The value at the end of a path.
fn at<'a>(value: &'a mut Value, path: &[String]) -> &'a mut Value {
    path.iter().fold(value, |value, step| match value {
        Value::Table(table) => table.get_mut(step).expect("a key"),
        Value::Array(list) => &mut list[step.parse::<usize>().expect("a number")],
        _ => panic!("{step}"),
    })
}

/// Another value.
fn odd(random: &mut Random) -> Value {
    let texts = [
        "",
        "x",
        "1 m",
        "3 deg",
        "nose",
        "1:20",
        "0.5",
        "trailing_edge",
    ];
    match random.below(12) {
        0 => Value::Array(Vec::new()),
        1 => Value::Array(vec![Value::Float(0.5)]),
        2 => Value::Array(vec![Value::Array(vec![Value::Integer(1)])]),
        3 => Value::Table(Table::new()),
        4 => Value::Boolean(true),
        5 => Value::Integer(0),
        6 => Value::Integer(-1),
        7 => Value::Float(0.25),
        8 => Value::Float(f64::NAN),
        _ => Value::String(texts[random.below(texts.len())].to_owned()),
    }
}

/// A document with a change: a value is another one or absent, a list is shorter, a key has another name.
fn change(document: &mut Value, random: &mut Random) {
    let mut all = Vec::new();
    paths(document, &[], &mut all);
    // the document itself remains a table
    let path = all[1 + random.below(all.len() - 1)].clone();
    let (last, before) = path.split_last().expect("a step");
    match (random.below(5), at(document, before)) {
        (0, Value::Table(table)) => drop(table.remove(last)),
        (1, Value::Table(table)) => {
            let value = table.remove(last).expect("a key");
            table.insert(format!("{last}s"), value);
        }
        (0 | 1, Value::Array(list)) => drop(list.pop()),
        _ => *at(document, &path) = odd(random),
    }
}

fn fits(validator: &Validator, document: &Value) -> bool {
    let value = serde_json::to_value(document).expect("TOML without dates");
    validator.is_valid(&value)
}

/// 400 documents with a changed value: a document that the schema refuses is refused by the reader, so that an
/// editor never marks a sound file; and one that the schema accepts is refused for the meaning of its values
/// only, not for their form.
#[test]
fn reader_and_schema_agree_on_random_documents() {
    let validator = jsonschema::draft202012::new(&LAYUP.json_schema()).expect("a schema");
    let documents = FILES.map(|file| {
        let text = std::fs::read_to_string(folder().join(file)).expect("a file");
        Value::Table(toml::from_str::<Table>(&text).expect("TOML"))
    });
    assert!(documents.iter().all(|document| fits(&validator, document)));
    let mut counts = [0; 3];
    let mut disagreements = Vec::new();
    for seed in 0..400 {
        let mut random = Random(0x9E37_79B9 * (seed + 1));
        let mut document = documents[random.below(documents.len())].clone();
        change(&mut document, &mut random);
        let text = toml::to_string(&document).expect("a text");
        let read = layup::parse(&text, &folder().join("a.layup.toml"));
        match (fits(&validator, &document), read) {
            (true, Ok(_)) => counts[0] += 1,
            (false, Err(_)) => counts[1] += 1,
            (false, Ok(_)) => {
                disagreements.push(format!("{seed}: read, and refused by the schema:\n{text}"))
            }
            (true, Err(problems)) => {
                counts[2] += 1;
                let problems = problems.to_string();
                let mut lines = problems.lines().filter(|line| line.starts_with("error"));
                let is_of_meaning = |line: &str| OF_MEANING.iter().any(|part| line.contains(part));
                if !lines.all(is_of_meaning) {
                    disagreements.push(format!("{seed}: accepted by the schema: {problems}"));
                }
            }
        }
    }
    println!("{counts:?}");
    assert!(disagreements.is_empty(), "{}", disagreements.join("\n"));
    assert!(counts.iter().all(|count| *count > 20), "{counts:?}");
}

/// Forms of which both must have the same opinion.
#[test]
fn forms_that_are_none_are_refused_by_both() {
    let validator = jsonschema::draft202012::new(&LAYUP.json_schema()).expect("a schema");
    let file = folder().join("a.layup.toml");
    let text = std::fs::read_to_string(folder().join(FILES[1])).expect("a file");
    for (from, to, is_sound) in [
        ("thickness = 0.5", "plies = []", false),
        ("thickness = 0.5", "thickness = []", false),
        ("thickness = 0.5", "thickness = -0.5", false),
        ("thickness = 0.5", "thickness = true", false),
        (
            "thickness = 0.5",
            "thickness = { eta = [], value = [] }",
            false,
        ),
        ("thickness = 0.5", "thickness = \"0.5 mm\"", true),
        (
            "thickness = 0.5",
            "thickness = { eta = [0, 1], value = [1, 2] }",
            true,
        ),
        ("chord = 400", "chord = 0", false),
        (
            "plies = [{ name = \"web_ply\", material = \"glass\", thickness = 2, fiber_angle = -45 }]",
            "plies = [1]",
            false,
        ),
        ("[units]", "fill = []\n[units]", true),
        ("[units]", "layers = []\n[units]", false),
        ("[mesh]", "[mesh]\nprofile = 1", false),
        (
            "thickness = 0.5",
            "thickness = 0.5\nprofile = [[0, 0], [1, 1]]",
            true,
        ),
        (
            "thickness = 0.5",
            "thickness = 0.5\nprofile = [[0], [1]]",
            false,
        ),
        ("from = { x = 0.4, side = \"suction\" }", "from = []", false),
        ("from = { x = 0.4, side = \"suction\" }", "from = 0.3", true),
        ("size = 6", "size = -6", false),
    ] {
        assert!(text.contains(from), "{from}");
        let text = text.replacen(from, to, 1);
        let document = Value::Table(toml::from_str::<Table>(&text).expect("TOML"));
        let read = layup::parse(&text, &file);
        assert_eq!(fits(&validator, &document), is_sound, "{to}: the schema");
        assert_eq!(read.is_ok(), is_sound, "{to}: the reader");
    }
}
