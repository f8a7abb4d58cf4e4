//! The description as a JSON schema, for editors.

use serde_json::{Map, Value, json};
use shared_geom::units::Dimension;

use super::{Family, KeySchema, Need, SECTION_FILE, TableSchema, ValueKind};

/// A number and a unit, with or without space between them.
const QUANTITY: &str =
    r"^\s*[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?(\s*[/%°A-Za-zµμΩ]| +1).*$";

/// The JSON schema of a section file, draft 2020-12.
///
/// It contains no references, which editors resolve in different ways. It does not check
/// the names of groups, the dimensions of units and the admissibility of laws;
/// `section-analyzer check` does.
pub fn json_schema() -> Value {
    let mut schema = Map::new();
    let draft = "https://json-schema.org/draft/2020-12/schema";
    schema.insert("$schema".into(), draft.into());
    schema.insert("title".into(), SECTION_FILE.title.into());
    if let Value::Object(table) = of_table(&SECTION_FILE) {
        schema.extend(table);
    }
    schema.into()
}

fn of_table(table: &TableSchema) -> Value {
    if table.families.is_empty() {
        return of_keys(table.meaning, table.keys, &[]);
    }
    let family = |family: &Family| {
        let mut schema = of_keys(family.meaning, table.keys, family.keys);
        schema["title"] = family.name.into();
        schema
    };
    let families: Vec<_> = table.families.iter().map(family).collect();
    json!({ "description": table.meaning, "type": "object", "oneOf": families })
}

fn of_keys(meaning: &str, common: &[KeySchema], own: &[KeySchema]) -> Value {
    let keys = || own.iter().chain(common);
    let properties: Map<_, _> = keys()
        .map(|key| (key.name.to_owned(), of_key(key)))
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

fn of_key(key: &KeySchema) -> Value {
    let mut forms: Vec<_> = key.kinds.iter().flat_map(forms).collect();
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

/// Dimension of a kind of value, for the description.
fn measured(kind: &ValueKind) -> Option<String> {
    match kind {
        ValueKind::Quantity(Dimension::NUMBER) => Some("A pure number".to_owned()),
        ValueKind::Quantity(dimension)
        | ValueKind::Vector(_, dimension)
        | ValueKind::Named(dimension) => Some(format!(
            "A number in the declared unit, or a text with its own unit: {dimension}"
        )),
        _ => None,
    }
}

/// The example as JSON; TOML and JSON have the same notation for the values of examples.
fn example(key: &KeySchema) -> Option<Value> {
    serde_json::from_str(key.example).ok()
}

/// The schemas of a kind; a value must fit one of them.
fn forms(kind: &ValueKind) -> Vec<Value> {
    match kind {
        ValueKind::Text | ValueKind::Unit(_) => vec![json!({ "type": "string", "minLength": 1 })],
        ValueKind::Name => vec![
            json!({ "type": "string", "minLength": 1 }),
            json!({ "type": "integer", "minimum": 1 }),
        ],
        ValueKind::Names => {
            let name = json!({ "anyOf": forms(&ValueKind::Name) });
            let list = json!({ "type": "array", "items": name, "minItems": 1 });
            forms(&ValueKind::Name).into_iter().chain([list]).collect()
        }
        ValueKind::Word(words) => vec![json!({ "type": "string", "enum": words })],
        ValueKind::Boolean => vec![json!({ "type": "boolean" })],
        ValueKind::Quantity(_) => quantity(),
        ValueKind::Vector(count, _) => vec![array(*count, json!({ "anyOf": quantity() }))],
        ValueKind::Named(_) => {
            let values = json!({ "anyOf": quantity() });
            vec![json!({ "type": "object", "additionalProperties": values })]
        }
        ValueKind::Count(most) => vec![json!({ "type": "integer", "minimum": 1, "maximum": most })],
        ValueKind::Numbers(most) => {
            let items = json!({ "anyOf": quantity() });
            vec![json!({ "type": "array", "items": items, "minItems": 1, "maxItems": most })]
        }
        ValueKind::Rows(rows, columns) => {
            vec![array(
                *rows,
                array(*columns, json!({ "anyOf": quantity() })),
            )]
        }
        ValueKind::Table(table) => vec![of_table(table)],
        ValueKind::NamedTables(table) => vec![json!({
            "type": "object",
            "additionalProperties": of_table(table),
            "minProperties": 1,
        })],
        ValueKind::Tables(table) => vec![json!({
            "type": "array",
            "items": of_table(table),
            "minItems": 1,
        })],
    }
}

fn quantity() -> Vec<Value> {
    vec![
        json!({ "type": "number" }),
        json!({ "type": "string", "pattern": QUANTITY }),
    ]
}

fn array(count: usize, items: Value) -> Value {
    json!({ "type": "array", "items": items, "minItems": count, "maxItems": count })
}
