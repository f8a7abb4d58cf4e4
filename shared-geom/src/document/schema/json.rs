//! The description as a JSON schema, for editors.

use serde_json::{Map, Value, json};

use super::share::share;
use super::{Family, KeySchema, Need, TableSchema, ValueKind};
use crate::units::Dimension;

/// A number and a unit, with or without space between them.
const QUANTITY: &str =
    r"^\s*[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?(\s*[/%°A-Za-zµμΩ]| +1).*$";
/// An expression of parameters.
const EXPRESSION: &str = r"^\s*=\s*\S";

/// Texts that may replace a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Numbers {
    /// A number with its unit.
    Plain,
    /// The same, or an expression that begins with `=`.
    Expressions,
}

/// The JSON schema of a file, draft 2020-12.
///
/// It does not check the names of other tables and the dimensions of units.
pub fn json_schema(file: &'static TableSchema, numbers: Numbers) -> Value {
    let mut schema = Map::new();
    let draft = "https://json-schema.org/draft/2020-12/schema";
    schema.insert("$schema".into(), draft.into());
    schema.insert("title".into(), file.title.into());
    if let Value::Object(table) = numbers.of_table(file) {
        schema.extend(table);
    }
    schema.into()
}

/// As [`json_schema`], for a file of many equal tables: parts that occur repeatedly are
/// under `$defs`, with references to them.
pub fn shared_json_schema(file: &'static TableSchema, numbers: Numbers) -> Value {
    share(json_schema(file, numbers))
}

impl Numbers {
    fn of_table(self, table: &TableSchema) -> Value {
        if table.families.is_empty() {
            return self.of_keys(table.meaning, table.keys, &[]);
        }
        let family = |family: &Family| {
            let mut schema = self.of_keys(family.meaning, table.keys, family.keys);
            schema["title"] = family.name.into();
            schema
        };
        let families: Vec<_> = table.families.iter().map(family).collect();
        json!({ "description": table.meaning, "type": "object", "anyOf": families })
    }

    fn of_keys(self, meaning: &str, common: &[KeySchema], own: &[KeySchema]) -> Value {
        let keys = || own.iter().chain(common);
        let properties: Map<_, _> = keys()
            .map(|key| (key.name.to_owned(), self.of_key(key)))
            .collect();
        let required: Vec<_> = keys()
            .filter(|key| key.need == Need::Required)
            .map(|key| key.name)
            .collect();
        json!({
            "description": meaning,
            "type": "object",
            "properties": properties,
            "required": required,
            "additionalProperties": false,
        })
    }

    fn of_key(self, key: &KeySchema) -> Value {
        let mut forms: Vec<_> = key.kinds.iter().flat_map(|kind| self.forms(kind)).collect();
        let mut schema = Map::new();
        let default = match key.need {
            Need::Default(default) => format!(" Default: {default}."),
            _ => String::new(),
        };
        let unit = key.kinds.iter().find_map(measured);
        let unit = unit.map_or_else(String::new, |unit| format!(" {unit}."));
        schema.insert(
            "description".into(),
            format!("{}{unit}{default}", key.meaning).into(),
        );
        if forms.len() == 1
            && let Some(Value::Object(form)) = forms.pop()
        {
            for (name, value) in form {
                schema.entry(name).or_insert(value);
            }
        } else {
            schema.insert("anyOf".into(), forms.into());
        }
        if let Some(example) = example(key) {
            schema.insert("examples".into(), json!([example]));
        }
        schema.into()
    }

    /// The schemas of a kind; a value must fit one of them.
    fn forms(self, kind: &ValueKind) -> Vec<Value> {
        match kind {
            ValueKind::Text | ValueKind::Unit(_) => vec![text()],
            ValueKind::Name => vec![text(), json!({ "type": "integer", "minimum": 1 })],
            ValueKind::Names => {
                let mut forms = self.forms(&ValueKind::Name);
                forms.push(list(any(self.forms(&ValueKind::Name))));
                forms
            }
            ValueKind::Texts => vec![text(), list(text())],
            ValueKind::Word(words) => vec![word(words)],
            ValueKind::Words(words) => vec![word(words), list(word(words))],
            ValueKind::Boolean => vec![json!({ "type": "boolean" })],
            ValueKind::Quantity(_) => self.quantity(json!({ "type": "number" })),
            ValueKind::Positive(_) => {
                self.quantity(json!({ "type": "number", "exclusiveMinimum": 0 }))
            }
            ValueKind::NotNegative(_) => self.quantity(json!({ "type": "number", "minimum": 0 })),
            ValueKind::Quantities(_) => {
                let mut forms = self.forms(&ValueKind::Quantity(Dimension::NUMBER));
                forms.push(list(self.number()));
                forms
            }
            ValueKind::Vector(count, _) => vec![array(*count, self.number())],
            ValueKind::Vectors(count, _) => vec![list(array(*count, self.number()))],
            ValueKind::Named(_) => vec![open(self.number())],
            ValueKind::Free => self.quantity(json!({ "type": "number" })),
            ValueKind::FreeMatrix => {
                let mut forms = self.forms(&ValueKind::Quantities(Dimension::NUMBER));
                forms.extend(self.forms(&ValueKind::Lines(0)));
                forms
            }
            ValueKind::Count(most) => self.count(*most),
            ValueKind::Numbers(most) => {
                let items = self.number();
                vec![json!({ "type": "array", "items": items, "minItems": 1, "maxItems": most })]
            }
            ValueKind::Rows(rows, columns) => vec![array(*rows, array(*columns, self.number()))],
            ValueKind::Lines(0) => vec![list(list(self.number()))],
            ValueKind::Lines(columns) => vec![list(array(*columns, self.number()))],
            ValueKind::Drive(_) => vec![drive()],
            ValueKind::Drives(_) => vec![list(drive())],
            ValueKind::NamedDrives(_) => vec![open(drive())],
            ValueKind::Table(table) => vec![self.of_table(table)],
            ValueKind::NamedTables(table) => vec![json!({
                "type": "object",
                "additionalProperties": self.of_table(table),
                "minProperties": 1,
            })],
            ValueKind::Tables(table) => vec![list(self.of_table(table))],
            ValueKind::Columns(table) => vec![open(any(vec![text(), self.of_table(table)]))],
            ValueKind::Parameters(table) => {
                vec![open(any(vec![self.number(), self.of_table(table)]))]
            }
            ValueKind::OtherTables => vec![list(json!({ "type": "object" }))],
        }
    }

    /// A whole number up to `most`, or an expression.
    fn count(self, most: usize) -> Vec<Value> {
        let mut count = json!({ "type": "integer", "minimum": 1 });
        if most < usize::MAX {
            count["maximum"] = most.into();
        }
        [count].into_iter().chain(self.expression()).collect()
    }

    /// A number, or a text in its place.
    fn quantity(self, number: Value) -> Vec<Value> {
        let mut forms = vec![number, json!({ "type": "string", "pattern": QUANTITY })];
        forms.extend(self.expression());
        forms
    }

    fn number(self) -> Value {
        any(self.quantity(json!({ "type": "number" })))
    }

    fn expression(self) -> Option<Value> {
        match self {
            Self::Plain => None,
            Self::Expressions => Some(json!({ "type": "string", "pattern": EXPRESSION })),
        }
    }
}

/// Dimension of a kind of value, for the description.
fn measured(kind: &ValueKind) -> Option<String> {
    match kind {
        ValueKind::Quantity(Dimension::NUMBER)
        | ValueKind::Positive(Dimension::NUMBER)
        | ValueKind::NotNegative(Dimension::NUMBER) => Some("A pure number".to_owned()),
        ValueKind::Quantity(dimension)
        | ValueKind::Positive(dimension)
        | ValueKind::NotNegative(dimension)
        | ValueKind::Quantities(dimension)
        | ValueKind::Vector(_, dimension)
        | ValueKind::Vectors(_, dimension)
        | ValueKind::Named(dimension) => Some(format!(
            "A number in the declared unit, or a text with its own unit: {dimension}"
        )),
        ValueKind::Drive(dimension) => Some(format!(
            "A number in the declared unit, a text with its own unit, an expression, or a name: \
             {dimension}"
        )),
        _ => None,
    }
}

/// The example as JSON; TOML and JSON have the same notation for the values of examples.
fn example(key: &KeySchema) -> Option<Value> {
    serde_json::from_str(key.example).ok()
}

fn text() -> Value {
    json!({ "type": "string", "minLength": 1 })
}

fn word(words: &[&str]) -> Value {
    json!({ "type": "string", "enum": words })
}

/// A number, a text, or a table.
fn drive() -> Value {
    json!({ "type": ["number", "string", "object"], "minLength": 1 })
}

fn any(forms: Vec<Value>) -> Value {
    json!({ "anyOf": forms })
}

/// A list of at least one item.
fn list(items: Value) -> Value {
    json!({ "type": "array", "items": items, "minItems": 1 })
}

fn array(count: usize, items: Value) -> Value {
    json!({ "type": "array", "items": items, "minItems": count, "maxItems": count })
}

/// A table with keys chosen by the user.
fn open(values: Value) -> Value {
    json!({ "type": "object", "additionalProperties": values })
}
