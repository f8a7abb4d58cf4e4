//! Compares the descriptions of the input files with their readers, with the files of the
//! repository, and with their pages in the book.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use jsonschema::Validator;
use section_analyzer::input;
use section_analyzer::input::schema::{
    BLADE, Description, Family, KeySchema, LAYUP, MATRICES, SECTION, SECTION_FILE, TableSchema,
    ValueKind,
};
use section_analyzer::input::{blade, external, layup};
use shared_geom::error::Diagnostics;
use shared_geom::units::DECLARABLE;
use toml::{Table, Value};

/// A key that is unlike all others.
const STRANGE: &str = "qqqqqqqqqqqq";

/// The top folder of the repository.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// An input file and its reader.
struct Subject {
    description: Description,
    /// The ending of its names.
    ending: &'static str,
    /// Text in every file of the repository with this ending that is of this kind.
    mark: &'static str,
    /// Its page in the book.
    page: &'static str,
    read: fn(&Path) -> Result<(), Diagnostics>,
    /// Parts of messages that are due to the examples: files that do not exist, and examples
    /// that exclude each other.
    of_examples: &'static [&'static str],
    /// Optional keys to which examples of other keys refer.
    referred: &'static [&'static str],
}

const SUBJECTS: [Subject; 4] = [
    Subject {
        description: SECTION,
        ending: ".section.toml",
        mark: "",
        page: "section-input-reference.md",
        read: |path| input::read(path).map(drop),
        of_examples: &["spar.msh"],
        referred: &["region", "temperature", "initial_strain", "electrode"],
    },
    Subject {
        description: BLADE,
        ending: ".blade.toml",
        mark: "[airfoil]",
        page: "blade-mesh-reference.md",
        read: |path| blade::read(path).map(drop),
        of_examples: &[
            "no file \"airfoil.dat\"",
            "has another material",
            "] needs a",
            "x/c = ",
            "cannot be closed",
        ],
        referred: &[],
    },
    Subject {
        description: LAYUP,
        ending: ".layup.toml",
        mark: "",
        page: "layup-reference.md",
        read: |path| layup::read(path).map(drop),
        of_examples: &[
            "no file \"airfoil.dat\"",
            "is not in the file",
            "[shape] has 2",
            "[shape] has 3",
            "[[shape.airfoils]] number 1 has no \"thickness\"",
            "has no effect: [shape] has ",
            "is the name of another",
            "expected one of \"from\" and \"to\" beside it",
            "expected one of \"arc\"",
            "no file \"blade.csv\"",
            "\"twist\" lists 4",
            "a splined line leads outward",
        ],
        referred: &[],
    },
    Subject {
        description: MATRICES,
        ending: ".matrices.toml",
        mark: "",
        page: "matrices-reference.md",
        read: |path| external::read(path).map(drop),
        of_examples: &["nodes.csv", ".mtx", "is given above too"],
        referred: &[],
    },
];

impl Subject {
    fn validator(&self) -> Validator {
        jsonschema::draft202012::new(&self.description.json_schema()).expect("a valid schema")
    }

    /// Calls `look` with every table of the file.
    fn visit(&self, look: Look<'_>) {
        visit(&[], self.description.file, &|file| file, look);
    }

    /// The messages of the reader, each with its help, except for those that are due to the
    /// examples.
    fn problems(&self, text: &str) -> Vec<String> {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join(format!("a{}", self.ending));
        std::fs::write(&file, text).expect("a file");
        let reported = (self.read)(&file)
            .err()
            .map(|problems| problems.to_string());
        let mut problems: Vec<String> = Vec::new();
        for line in reported.unwrap_or_default().lines() {
            match problems.last_mut() {
                Some(last) if line.starts_with("  help: ") => last.push_str(line),
                // A long list of keys has several lines.
                Some(last) if line.starts_with("    ") => last.push_str(&line[3..]),
                _ => problems.push(line.to_owned()),
            }
        }
        problems.retain(|problem| !self.of_examples.iter().any(|part| problem.contains(part)));
        problems
    }

    /// The keys that the reader knows in the table with the strange key, which is the only
    /// problem.
    fn known_to_the_reader(&self, text: &str) -> BTreeSet<String> {
        let problems = self.problems(text);
        let list = match &problems[..] {
            [problem] if problem.contains(STRANGE) => problem.split_once("  help: known keys: "),
            _ => None,
        };
        let (_, list) = list.unwrap_or_else(|| panic!("{problems:#?}\n{text}"));
        list.split(", ").map(str::to_owned).collect()
    }
}

/// Whether the text of a file fits the schema, with the reason if not.
fn fits(validator: &Validator, text: &str) -> Result<(), String> {
    let table: Table = toml::from_str(text).expect("a file in TOML");
    let value = serde_json::to_value(table).expect("TOML without dates");
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

/// Every form of a table: none, or one of its families.
fn forms(table: &TableSchema) -> Vec<Option<&'static Family>> {
    match table.families {
        [] => vec![None],
        families => families.iter().map(Some).collect(),
    }
}

fn keys(table: &'static TableSchema, form: Option<&'static Family>) -> Vec<&'static KeySchema> {
    let own = form.map_or(&[][..], |family| family.keys);
    table.keys.iter().chain(own).collect()
}

/// A table with all its keys, by their examples; the tables in it in their first form.
fn complete(table: &'static TableSchema, form: Option<&'static Family>) -> Table {
    let value = |key: &KeySchema| {
        if key.example.is_empty() {
            let kind = &key.kinds[0];
            let inner = kind.table().expect("a value without example is a table");
            return embedded(key.name, kind, complete(inner, forms(inner)[0]));
        }
        let written: Table = toml::from_str(&format!("key = {}", key.example))
            .unwrap_or_else(|error| panic!("example of {}: {error}", key.name));
        written["key"].clone()
    };
    keys(table, form)
        .into_iter()
        .map(|key| (key.name.to_owned(), value(key)))
        .collect()
}

/// A table as the value of a key of this kind; named tables use the names of the
/// examples.
fn embedded(key: &str, kind: &ValueKind, table: Table) -> Value {
    let name = match key {
        "temperature" => "hot",
        "initial_strain" => "cure",
        _ => "glass",
    };
    match kind {
        ValueKind::NamedTables(_) => {
            Value::Table(Table::from_iter([(name.to_owned(), Value::Table(table))]))
        }
        ValueKind::Tables(_) => Value::Array(vec![Value::Table(table)]),
        _ => Value::Table(table),
    }
}

type Embed<'a> = &'a dyn Fn(Table) -> Table;
type Look<'a> = &'a mut dyn FnMut(&Sample, Embed<'_>);

/// A table in one of its forms.
struct Sample {
    /// The keys that lead to it.
    path: Vec<&'static str>,
    table: &'static TableSchema,
    form: Option<&'static Family>,
    /// With all its keys.
    whole: Table,
}

impl Sample {
    fn keys(&self) -> Vec<&'static KeySchema> {
        keys(self.table, self.form)
    }

    fn names(&self) -> BTreeSet<String> {
        self.keys().iter().map(|key| key.name.to_owned()).collect()
    }

    fn location(&self) -> String {
        let form = self.form.map_or("", |family| family.name);
        format!("{} {form}", self.table.title)
    }
}

/// Calls `look` with every table in every form, and with a function that makes a whole
/// file of it.
fn visit(path: &[&'static str], table: &'static TableSchema, embed: Embed<'_>, look: Look<'_>) {
    for form in forms(table) {
        let sample = Sample {
            path: path.to_vec(),
            table,
            form,
            whole: complete(table, form),
        };
        look(&sample, embed);
        for key in sample.keys() {
            for kind in key.kinds {
                let Some(inner) = kind.table() else { continue };
                let embed_inner = |inner: Table| {
                    let mut outer = sample.whole.clone();
                    outer.insert(key.name.to_owned(), embedded(key.name, kind, inner));
                    embed(outer)
                };
                visit(&[path, &[key.name]].concat(), inner, &embed_inner, look);
            }
        }
    }
}

/// All keys of the reader are in the description of each table, and vice versa: an
/// unknown key makes the reader list the keys that it reads.
#[test]
fn reader_and_description_know_the_same_keys() {
    // the file, units, three laws, region, both angles, one of them in two forms; the file,
    // units, both airfoils, skin, spar, their plies, filler, cores, nose mass and mesh; both
    // files, with units, slice, matrices and curvature
    for (subject, least) in SUBJECTS.iter().zip([9, 14, 7]) {
        let seen = know_the_same_keys(subject);
        assert!(seen >= least, "{}: {seen}", subject.ending);
    }
}

/// Compares all tables; returns their number.
fn know_the_same_keys(subject: &Subject) -> usize {
    // The reader reads the keys of all forms, to distinguish them.
    let mut all_forms: BTreeMap<Vec<&str>, BTreeSet<String>> = BTreeMap::new();
    subject.visit(&mut |sample, _| {
        let names = all_forms.entry(sample.path.clone()).or_default();
        names.extend(sample.names());
    });
    let validator = subject.validator();
    let mut seen = 0;
    subject.visit(&mut |sample, embed| {
        let location = sample.location();
        let text = toml::to_string(&embed(sample.whole.clone())).expect("a table");
        assert_eq!(fits(&validator, &text), Ok(()), "{location}:\n{text}");

        let mut strange = sample.whole.clone();
        strange.insert(STRANGE.to_owned(), Value::Integer(1));
        let text = toml::to_string(&embed(strange)).expect("a table");
        assert!(fits(&validator, &text).is_err(), "{location}:\n{text}");
        let known = subject.known_to_the_reader(&text);
        let described = sample.names();
        let unknown: Vec<_> = described.difference(&known).collect();
        assert!(
            unknown.is_empty(),
            "{location}: the reader does not know {unknown:?}"
        );
        let missing: Vec<_> = known.difference(&all_forms[&sample.path]).collect();
        assert!(
            missing.is_empty(),
            "{location}: the description lacks {missing:?}"
        );
        seen += 1;
    });
    seen
}

/// Whether a table of one form without a key is a table of another form.
fn is_other_form(sample: &Sample, without: &Table) -> bool {
    sample.table.families.iter().any(|family| {
        let own = keys(sample.table, Some(family));
        let mut required = own
            .iter()
            .copied()
            .filter(|key| key.need == input::schema::Need::Required);
        // with the type of the example: stiffnesses are rows or a word
        let has = |key: &'static KeySchema| {
            let example = complete(sample.table, Some(family))[key.name].clone();
            let found = without.get(key.name);
            found.is_some_and(|found| found.same_type(&example))
        };
        required.all(has)
            && without
                .keys()
                .all(|name| own.iter().any(|key| key.name == name))
    })
}

/// The absence of a key described as required is refused by both. (A file without regions
/// is refused by the reader only after it has read the mesh.)
#[test]
fn required_keys_are_required_by_both() {
    for subject in &SUBJECTS {
        let validator = subject.validator();
        subject.visit(&mut |sample, embed| {
            for key in sample.keys() {
                let mut without = sample.whole.clone();
                without.remove(key.name);
                let is_required =
                    key.need == input::schema::Need::Required && !is_other_form(sample, &without);
                let text = toml::to_string(&embed(without)).expect("a table");
                let location = format!("{} without {}", sample.location(), key.name);
                assert_eq!(fits(&validator, &text).is_err(), is_required, "{location}");
                let problems = subject.problems(&text);
                // Without them, references in the examples have no target.
                if !(sample.path.is_empty() && subject.referred.contains(&key.name)) {
                    assert_eq!(
                        !problems.is_empty(),
                        is_required,
                        "{location}: {problems:?}"
                    );
                }
            }
        });
    }
}

#[test]
fn the_units_are_those_that_can_be_declared() {
    let units = SECTION_FILE.keys.iter().find(|key| key.name == "units");
    let units = units.and_then(|key| key.kinds.iter().find_map(ValueKind::table));
    let units = units.expect("the table of units");
    let described: Vec<_> = units
        .keys
        .iter()
        .map(|key| match key.kinds {
            [ValueKind::Unit(dimension)] => (key.name, *dimension),
            other => panic!("{other:?}"),
        })
        .collect();
    assert_eq!(described, DECLARABLE);
}

/// All files with this ending below `folder`.
fn files(folder: &Path, ending: &str, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if path.is_dir()
            && !["target", "out", "results"].contains(&&*name)
            && !name.starts_with('.')
        {
            files(&path, ending, found);
        } else if name.ends_with(ending) {
            found.push(path);
        }
    }
}

#[test]
fn every_file_of_the_repository_fits() {
    for subject in &SUBJECTS {
        let mut found = Vec::new();
        files(&root(), subject.ending, &mut found);
        let validator = subject.validator();
        let mut seen = 0;
        for file in found {
            let text = std::fs::read_to_string(&file).expect("a text file");
            if text.contains(subject.mark) {
                assert_eq!(fits(&validator, &text), Ok(()), "{}", file.display());
                seen += 1;
            }
        }
        assert!(seen > 1, "{}", subject.ending);
    }
}

const SOUND: &str = "\
mesh = \"two.msh\"
units = \"SI\"
[material.steel]
young = \"210 GPa\"
poisson = 0.3
density = 7850
[[region]]
group = 1
material = \"steel\"
plane_angle = { follow = \"outer\", reverse = true }
";

#[test]
fn wrong_files_do_not_fit() {
    let validator = SUBJECTS[0].validator();
    assert_eq!(fits(&validator, SOUND), Ok(()));
    for (from, to) in [
        ("mesh = \"two.msh\"", ""),
        ("mesh = \"two.msh\"", "mesh = 2"),
        ("mesh =", "mash ="),
        ("\"SI\"", "\"si\""),
        ("units = \"SI\"", ""),
        ("poisson = 0.3", ""),
        ("poisson = 0.3", "poisson = 0.3\ne1 = 2"),
        ("poisson = 0.3", "nu = 0.3"),
        ("\"210 GPa\"", "\"GPa\""),
        ("\"210 GPa\"", "\"210,5GPa\""),
        ("\"210 GPa\"", "true"),
        ("density = 7850", ""),
        ("density = 7850", "stiffness = [[1]]"),
        ("[[region]]", "[region]"),
        ("group = 1", "group = 0"),
        ("group = 1", "group = 1.5"),
        ("material = \"steel\"", ""),
        ("follow = \"outer\"", "table = \"a.csv\""),
        (
            "follow = \"outer\"",
            "follow = \"outer\", table = \"a.csv\"",
        ),
        ("reverse = true", "reverse = 1"),
    ] {
        let text = SOUND.replacen(from, to, 1);
        assert_ne!(text, SOUND, "{from}");
        assert!(fits(&validator, &text).is_err(), "{from} -> {to}");
    }
}

/// The pages of the book equal the output of the program.
#[test]
fn the_reference_pages_are_those_of_the_descriptions() {
    for subject in &SUBJECTS {
        let page = root().join("docs/src").join(subject.page);
        let found = std::fs::read_to_string(page).unwrap_or_default();
        let description = subject.description;
        assert!(
            found == description.reference(),
            "docs/src/{} does not match the description: write it anew by section-analyzer \
             schema --format markdown --out, with --of for other files than section files",
            subject.page
        );
    }
}
