//! The description of the dynamics file, its reader, the files of the repository, and the
//! page of the book.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use beam_dynamics::input;
use beam_dynamics::input::schema::{DYNAMICS_FILE, json_schema, reference};
use jsonschema::Validator;
use shared_geom::document::schema::{Family, KeySchema, Need, TableSchema, ValueKind};
use toml::{Table, Value};

use super::Folder;

/// A key that is unlike all others.
const STRANGE: &str = "qqqqqqqqqqqq";

/// Objects with the names that examples use.
const BASE: &str = "\
units = \"SI\"
[drives.swing]
kind = \"constant\"
value = 1
[properties.strip]
ea = 3e6
gay = 9.5e5
gaz = 9.5e5
gj = 2.8
eiy = 0.64
eiz = 160
m = 0.11
iy = 2.4e-8
iz = 5.9e-6
thermal_force = [-80, 0, 0, 0, 0.4, 0]
[sensors.tilt]
quantity = \"rotation\"
of = \"mast\"
component = \"y\"
[[node]]
name = \"root\"
position = [0, 0, 0]
[[node]]
name = \"mid\"
position = [1, 0, 0]
[[node]]
name = \"tip\"
position = [2, 0, 0]
[[node]]
name = \"mast\"
position = [0, 0, 3]
[[node]]
name = \"foot\"
position = [0, 3, 3]
[[node]]
name = \"hook\"
position = [1, 3, 3]
[[node]]
name = \"gearbox\"
position = [2, 3, 3]
[[node]]
name = \"engine\"
position = [3, 3, 3]
[[node]]
name = \"end\"
position = [4, 3, 3]
[[beam]]
name = \"arm\"
nodes = [\"root\", \"mid\", \"tip\"]
properties = \"strip\"
[[joint]]
name = \"pin\"
kind = \"revolute\"
nodes = [\"mast\", \"foot\"]
axis = [0, 0, 1]
[[rod]]
name = \"stay\"
nodes = [\"foot\", \"hook\"]
law = { kind = \"linear\", stiffness = 1 }
[[blade]]
name = \"blade\"
properties = \"strip\"
[[blade.piece]]
length = 2
elements = 3
";

/// Keys that are read only together with others: the title of their table, the key, and the
/// others with their values.
const TOGETHER: &[(&str, &str, &str)] = &[
    ("[hub]", "support_damping", "support = { in_plane = 1 }"),
    ("[hub]", "inertia", "support = { in_plane = 1 }"),
    ("[hub]", "mass", "support = { in_plane = 1 }"),
    ("[[rotor]]", "blade", "hub = \"rigid\"\nspeed = 300"),
    (
        "[[rotor]]",
        "inflow",
        "hub = \"rigid\"\nspeed = 300\nblade.piece = [{ length = 1, elements = 1 }]\n\
         blade.aerodynamics.stations = [{ at = 0, chord = 1, airfoil = \"naca0012\" }]",
    ),
    (
        "[[rotor]]",
        "flexbeam",
        "hub = \"bearingless\"\nspeed = 300\n[blade]\nhub_radius = 100\n\
         piece = [{ length = 1, elements = 1 }]",
    ),
    (
        "[[rotor]]",
        "torque_tube",
        "hub = \"bearingless\"\nspeed = 300\n[blade]\nhub_radius = 100\n\
         piece = [{ length = 1, elements = 1 }]\n[flexbeam]\noffset = 0.1\n\
         piece = [{ length = 1, elements = 1 }]",
    ),
    ("[rotor.flexbeam]", "temperature", "properties = \"strip\""),
    ("[rotor.flexbeam]", "imposed", "properties = \"strip\""),
    (
        "[rotor.torque_tube]",
        "temperature",
        "properties = \"strip\"",
    ),
    ("[rotor.torque_tube]", "imposed", "properties = \"strip\""),
    ("[rotor.blade]", "temperature", "properties = \"strip\""),
    ("[rotor.blade]", "imposed", "properties = \"strip\""),
    ("[[frame]]", "axis", "turn = 30"),
    ("[[frame]]", "center", "turn = 30"),
    ("[drives.NAME]", "columns", "file = \"gust.csv\""),
    ("[[rod]]", "at", "nodes = [\"hook\"]"),
    (
        "[[spring]]",
        "at",
        "law = { kind = \"linear\", stiffness = 1 }",
    ),
    ("[[beam]]", "temperature", "properties = \"strip\""),
    ("[[beam]]", "imposed", "properties = \"strip\""),
    ("[[blade.piece]]", "temperature", "properties = \"strip\""),
    ("[[blade.piece]]", "imposed", "properties = \"strip\""),
    ("[[blade]]", "temperature", "properties = \"strip\""),
    ("[[blade]]", "imposed", "properties = \"strip\""),
];

/// The top folder of the repository.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn validator() -> Validator {
    jsonschema::draft202012::new(&json_schema()).unwrap()
}

/// Whether a dynamics file fits the schema, with the reasons if not.
fn fits(validator: &Validator, table: &Table) -> Result<(), String> {
    let value = serde_json::to_value(table).unwrap();
    let errors: Vec<_> = validator
        .iter_errors(&value)
        .map(|e| e.to_string())
        .collect();
    if errors.is_empty() {
        Ok(())
    } else {
        Err(errors.join("\n"))
    }
}

/// A table in one of its forms.
#[derive(Clone)]
struct Sample {
    table: &'static TableSchema,
    form: Option<&'static Family>,
    /// Values of the keys `kind` or `quantity`, if the form has several.
    word: Option<(&'static str, &'static str)>,
}

impl Sample {
    /// All forms of a table.
    fn all(table: &'static TableSchema) -> Vec<Self> {
        let of_form = |form: Option<&'static Family>| {
            let key = form.and_then(|form| form.keys.iter().find(|key| is_choice(key)));
            let words: Vec<_> = match key.map(|key| (key.name, &key.kinds[0])) {
                Some((name, ValueKind::Word(words))) => {
                    words.iter().map(|word| Some((name, *word))).collect()
                }
                _ => vec![None],
            };
            words
                .into_iter()
                .map(move |word| Self { table, form, word })
        };
        match table.families {
            [] => of_form(None).collect(),
            families => families.iter().map(Some).flat_map(of_form).collect(),
        }
    }

    fn keys(&self) -> Vec<&'static KeySchema> {
        let own = self.form.map_or(&[][..], |family| family.keys);
        self.table.keys.iter().chain(own).collect()
    }

    /// The value of a key by its example.
    fn value(&self, key: &KeySchema) -> Value {
        if let Some((_, word)) = self.word.filter(|word| word.0 == key.name) {
            return word.into();
        }
        if !key.example.is_empty() {
            let written: Table = toml::from_str(&format!("key = {}", key.example))
                .unwrap_or_else(|error| panic!("example of {}: {error}", key.name));
            return written["key"].clone();
        }
        let kind = &key.kinds[0];
        match (kind, kind.table()) {
            (_, Some(inner)) => embedded(key, kind, Self::all(inner)[0].minimal()),
            (ValueKind::OtherTables, None) => Value::Array(vec![Value::Table(Table::new())]),
            (_, None) => panic!("{} has no example", key.name),
        }
    }

    fn of_keys(&self, keys: impl Iterator<Item = &'static KeySchema>) -> Table {
        keys.map(|key| (key.name.to_owned(), self.value(key)))
            .collect()
    }

    /// The table with all its keys.
    fn complete(&self) -> Table {
        self.of_keys(self.keys().into_iter())
    }

    /// The table with its required keys.
    fn minimal(&self) -> Table {
        let keys = self.keys().into_iter();
        self.of_keys(keys.filter(|key| key.need == Need::Required))
    }

    fn location(&self) -> String {
        let form = self.form.map_or("", |family| family.name);
        format!("{} {form} {:?}", self.table.title, self.word)
    }
}

/// Whether a key distinguishes the forms of a table.
fn is_choice(key: &KeySchema) -> bool {
    matches!(key.kinds, [ValueKind::Word(_)]) && ["kind", "quantity"].contains(&key.name)
}

/// A table as the value of a key of this kind.
fn embedded(key: &KeySchema, kind: &ValueKind, table: Table) -> Value {
    match kind {
        ValueKind::NamedTables(_) => {
            let name = format!("{} a", key.name).replace(' ', "_");
            Value::Table(Table::from_iter([(name, Value::Table(table))]))
        }
        ValueKind::Tables(_) => Value::Array(vec![Value::Table(table)]),
        _ => Value::Table(table),
    }
}

type Embed<'a> = &'a dyn Fn(Table) -> Table;
type Look<'a> = &'a mut dyn FnMut(&[&'static str], &Sample, Embed<'_>);

/// Calls `look` with the path of every table, the table in every form, and a function that
/// makes a file of it, in which the tables around it have the keys that they need.
fn visit(path: &[&'static str], table: &'static TableSchema, embed: Embed<'_>, look: Look<'_>) {
    for sample in Sample::all(table) {
        look(path, &sample, embed);
        for key in sample.keys() {
            // The cards in a repeat are the cards of the file.
            if table.title == "[[repeat]]" {
                continue;
            }
            for kind in key.kinds {
                let Some(inner) = kind.table() else { continue };
                let embed_inner = |inner: Table| {
                    let mut outer = sample.minimal();
                    add_together(&mut outer, table.title, key.name);
                    outer.insert(key.name.to_owned(), embedded(key, kind, inner));
                    embed(outer)
                };
                visit(&[path, &[key.name]].concat(), inner, &embed_inner, look);
            }
        }
    }
}

/// Adds the keys without which a key is not read.
fn add_together(table: &mut Table, title: &str, key: &str) {
    for (_, _, more) in TOGETHER.iter().filter(|one| (one.0, one.1) == (title, key)) {
        let more: Table = toml::from_str(more).unwrap();
        table.extend(more);
    }
}

fn visit_all(look: Look<'_>) {
    visit(&[], &DYNAMICS_FILE, &|file| file, look);
}

/// The sample with the objects that it may name.
fn with_base(mut file: Table) -> Table {
    let base: Table = toml::from_str(BASE).unwrap();
    for (key, value) in base {
        match (file.get_mut(&key), value) {
            (Some(Value::Array(items)), Value::Array(more)) => items.extend(more),
            (Some(Value::Table(items)), Value::Table(more)) => {
                for (name, table) in more {
                    items.entry(name).or_insert(table);
                }
            }
            (Some(_), _) => {}
            (None, value) => drop(file.insert(key, value)),
        }
    }
    file
}

/// The messages of the reader, each with its help.
fn problems(folder: &Folder, file: &Table) -> Vec<String> {
    let text = toml::to_string(file).unwrap();
    folder.write("a.dynamics.toml", &text);
    let shown = match input::read(&folder.path("a.dynamics.toml")) {
        Ok(_) => String::new(),
        Err(problems) => problems.to_string(),
    };
    let mut problems: Vec<String> = Vec::new();
    for line in shown.lines() {
        match problems.last_mut() {
            Some(last) if line.starts_with("  help: ") => last.push_str(line),
            // A long list of keys has several lines.
            Some(last) if line.starts_with("    ") => last.push_str(&line[3..]),
            _ => problems.push(line.to_owned()),
        }
    }
    problems
}

/// The keys that the reader knows in the table with the strange key.
fn known_to_the_reader(problems: &[String]) -> BTreeSet<String> {
    let lists = problems.iter().filter(|problem| problem.contains(STRANGE));
    let lists = lists.filter_map(|problem| problem.split_once("  help: known keys: "));
    lists
        .flat_map(|(_, list)| list.split(", ").map(str::to_owned))
        .collect()
}

/// The reader accepts exactly the declared keys of every form of every table: an unknown key
/// makes it list them. The examples fit the JSON schema of their own keys.
#[test]
fn reader_and_description_have_the_same_keys() {
    let folder = Folder::new();
    let mut all_forms: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    visit_all(&mut |path, sample, _| {
        let names = all_forms.entry(path.join(".")).or_default();
        names.extend(sample.keys().iter().map(|key| key.name.to_owned()));
    });
    let validator = validator();
    let (mut seen, mut faults) = (0, Vec::new());
    visit_all(&mut |path, sample, embed| {
        let location = format!("{} in {}", sample.location(), path.join("."));
        let units = |mut file: Table| {
            file.entry("units").or_insert("SI".into());
            file
        };
        if let Err(errors) = fits(&validator, &units(embed(sample.complete()))) {
            faults.push(format!("{location}: {errors}"));
        }
        let mut strange = sample.complete();
        strange.insert(STRANGE.to_owned(), Value::Integer(1));
        let file = units(embed(strange));
        if fits(&validator, &file).is_ok() {
            faults.push(format!("{location}: the schema accepts a strange key"));
        }
        let problems = problems(&folder, &file);
        let known = known_to_the_reader(&problems);
        let described: BTreeSet<_> = sample
            .keys()
            .iter()
            .map(|key| key.name.to_owned())
            .collect();
        let unknown: Vec<_> = described.difference(&known).collect();
        let missing: Vec<_> = known.difference(&all_forms[&path.join(".")]).collect();
        if !unknown.is_empty() || !missing.is_empty() {
            faults.push(format!(
                "{location}: the reader does not know {unknown:?}, the description lacks \
                 {missing:?}\n{problems:#?}"
            ));
        }
        seen += 1;
    });
    assert!(faults.is_empty(), "{}", faults.join("\n\n"));
    assert!(seen > 150, "{seen}");
}

/// Every declared key is read: a date, which no key accepts, is reported by the name of the
/// key.
#[test]
fn every_declared_key_is_read() {
    let folder = Folder::new();
    let date: Value = Value::Datetime("1979-05-27".parse().unwrap());
    let (mut seen, mut faults) = (0, Vec::new());
    visit_all(&mut |path, sample, embed| {
        for key in sample.keys() {
            // The cards in a repeat are the cards of the file.
            let is_card = sample.table.title == "[[repeat]]" && key.example.is_empty();
            if is_card {
                continue;
            }
            let mut table = sample.minimal();
            add_together(&mut table, sample.table.title, key.name);
            table.insert(key.name.to_owned(), date.clone());
            let problems = problems(&folder, &with_base(embed(table)));
            let quoted = format!("\"{}\"", key.name);
            // As a date, or as a key that cannot be used here.
            let is_read = |problem: &String| {
                let is_absent = problem.contains("unknown key") || problem.contains("has no");
                problem.contains(&quoted) && !is_absent
            };
            if !problems.iter().any(is_read) {
                let location = format!("{} in {}", sample.location(), path.join("."));
                faults.push(format!("{location}: \"{}\"\n{problems:#?}", key.name));
            }
            seen += 1;
        }
    });
    assert!(
        faults.is_empty(),
        "{} faults\n{}",
        faults.len(),
        faults.join("\n\n")
    );
    assert!(seen > 800, "{seen}");
}

/// A file without a required key is refused by both.
#[test]
fn required_keys_are_required_by_both() {
    let folder = Folder::new();
    let validator = validator();
    let mut faults = Vec::new();
    visit_all(&mut |path, sample, embed| {
        for key in sample.keys() {
            if key.need != Need::Required || path.is_empty() {
                continue;
            }
            let mut table = sample.minimal();
            table.remove(key.name);
            let file = with_base(embed(table));
            let location = format!(
                "{} in {}: \"{}\"",
                sample.location(),
                path.join("."),
                key.name
            );
            // Without the key that distinguishes it, the table may be of another form.
            let is_other = sample.form.is_some() && fits(&validator, &file).is_ok();
            if !is_other && fits(&validator, &file).is_ok() {
                faults.push(format!(
                    "{location}: the schema accepts the table without it"
                ));
            }
            if !is_other && problems(&folder, &file).is_empty() {
                faults.push(format!(
                    "{location}: the reader accepts the table without it"
                ));
            }
        }
    });
    assert!(faults.is_empty(), "{}", faults.join("\n\n"));
}

/// All files below `folder` whose name ends so.
fn files_below(folder: &Path, ending: &str, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if path.is_dir() && !["target", "out", "results"].contains(&&*name) {
            if !name.starts_with('.') {
                files_below(&path, ending, found);
            }
        } else if name.ends_with(ending) {
            found.push(path);
        }
    }
}

#[test]
fn every_dynamics_file_of_the_repository_fits() {
    let mut files = Vec::new();
    files_below(&root(), ".dynamics.toml", &mut files);
    assert!(files.len() > 5, "{}", files.len());
    let validator = validator();
    for file in files {
        let text = std::fs::read_to_string(&file).unwrap();
        let table = toml::from_str(&text).unwrap();
        assert_eq!(fits(&validator, &table), Ok(()), "{}", file.display());
    }
}

const SOUND: &str = "\
units = \"SI\"
[drives.push]
kind = \"ramp\"
to = 2
duration = 1
[[node]]
name = \"a\"
position = [\"= 2*pi\", 0, \"3 mm\"]
[[joint]]
kind = \"revolute\"
nodes = [\"a\"]
axis = [0, 0, 1]
angle = { kind = \"constant\", value = 3 }
[[load]]
node = \"a\"
force = [0, 0, 1]
drive = \"push\"
follower = true
[modes]
speeds = [0, 300]
count = 4
";

#[test]
fn wrong_files_do_not_fit() {
    let validator = validator();
    let table = |text: &str| toml::from_str::<Table>(text).unwrap();
    assert_eq!(fits(&validator, &table(SOUND)), Ok(()));
    for (from, to) in [
        ("units = \"SI\"", ""),
        ("\"SI\"", "\"si\""),
        ("kind = \"ramp\"", "kind = \"rampe\""),
        ("to = 2", "too = 2"),
        ("to = 2", "value = 2"),
        ("position = ", "place = "),
        ("\"= 2*pi\"", "\"2*pi\""),
        ("\"3 mm\"", "\"three mm\""),
        (", \"3 mm\"]", "]"),
        ("kind = \"revolute\"", "kind = \"clamp\""),
        ("axis = [0, 0, 1]", ""),
        ("axis = [0, 0, 1]", "axis = 1"),
        ("angle = {", "length = {"),
        ("follower = true", "follower = \"yes\""),
        ("count = 4", "count = 0"),
        ("count = 4", "count = 100000"),
        ("[modes]", "[[modes]]"),
    ] {
        let text = SOUND.replacen(from, to, 1);
        assert_ne!(text, SOUND, "{from}");
        assert!(fits(&validator, &table(&text)).is_err(), "{from} -> {to}");
    }
}

/// The page of the book, and the files that the program writes.
#[test]
fn the_page_and_the_program_show_the_description() {
    let page = root().join("docs/src/dynamics-input-reference.md");
    let found = std::fs::read_to_string(page).unwrap_or_default();
    assert!(
        found == reference(),
        "docs/src/dynamics-input-reference.md does not match the description: run\n  cargo run -p \
         beam-dynamics -- schema --format markdown --out docs/src/dynamics-input-reference.md"
    );
    let folder = Folder::new();
    let run = folder.run(&["schema"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let shown: serde_json::Value = serde_json::from_str(&run.out).unwrap();
    assert_eq!(shown, json_schema());
    let run = folder.run(&["schema", "--format", "markdown", "--out", "page.md"]);
    assert_eq!((run.code, run.out.as_str()), (0, "page.md\n"));
    assert_eq!(folder.read("page.md"), reference());
    let run = folder.run(&["schema", "--out", "no/such/folder.json"]);
    assert_eq!(run.code, 2);
    assert!(run.err.contains("no/such/folder.json"), "{}", run.err);
}
