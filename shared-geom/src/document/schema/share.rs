//! Parts of a JSON schema that occur repeatedly, written once.

use std::collections::BTreeMap;

use serde_json::{Map, Value, json};

/// Letters of a part below which it is repeated.
const SHORT: usize = 200;

/// The schema with parts that occur repeatedly under `$defs`, and references to them.
pub(super) fn share(mut schema: Value) -> Value {
    let mut counts = BTreeMap::new();
    count(&mut schema, &mut counts);
    counts.retain(|_, count| *count > 1);
    let mut shared = Shared {
        numbers: counts.into_keys().map(|part| (part, None)).collect(),
        parts: Map::new(),
    };
    shared.replace_parts(&mut schema);
    if let Value::Object(schema) = &mut schema {
        schema.insert("$defs".into(), shared.parts.into());
    }
    schema
}

/// Repeated parts of a schema.
struct Shared {
    /// The number of each part; `None` before its first use.
    numbers: BTreeMap<String, Option<usize>>,
    /// The parts by their names.
    parts: Map<String, Value>,
}

impl Shared {
    /// Replaces the repeated parts of a schema by references.
    fn replace_parts(&mut self, schema: &mut Value) {
        for part in parts(schema) {
            let Some(number) = self.numbers.get(&part.to_string()).copied() else {
                self.replace_parts(part);
                continue;
            };
            let number = number.unwrap_or_else(|| self.add(part.clone()));
            *part = json!({ "$ref": format!("#/$defs/part{number}") });
        }
    }

    /// Adds a part; returns its number.
    fn add(&mut self, mut part: Value) -> usize {
        let number = self.parts.len() + 1;
        self.numbers.insert(part.to_string(), Some(number));
        // Its place is taken before the parts in it are added.
        let name = format!("part{number}");
        self.parts.insert(name.clone(), Value::Null);
        self.replace_parts(&mut part);
        self.parts.insert(name, part);
        number
    }
}

/// Counts the long parts of a schema by their texts.
fn count(schema: &mut Value, counts: &mut BTreeMap<String, usize>) {
    for part in parts(schema) {
        let text = part.to_string();
        if text.len() > SHORT {
            *counts.entry(text).or_default() += 1;
            count(part, counts);
        }
    }
}

/// The schemas in a schema.
fn parts(schema: &mut Value) -> Vec<&mut Value> {
    let Value::Object(schema) = schema else {
        return Vec::new();
    };
    let mut found = Vec::new();
    for (name, value) in schema {
        match (name.as_str(), value) {
            ("properties", Value::Object(properties)) => found.extend(properties.values_mut()),
            ("anyOf", Value::Array(forms)) => found.extend(forms),
            ("items" | "additionalProperties", value @ Value::Object(_)) => found.push(value),
            _ => {}
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The schema with its references replaced by the parts that they name.
    fn whole(schema: &Value, parts: &Value) -> Value {
        if let Some(name) = schema.get("$ref").and_then(Value::as_str) {
            let name = name.trim_start_matches("#/$defs/");
            return whole(&parts[name], parts);
        }
        match schema {
            Value::Object(map) => map
                .iter()
                .filter(|(name, _)| *name != "$defs")
                .map(|(name, value)| (name.clone(), whole(value, parts)))
                .collect::<Map<_, _>>()
                .into(),
            Value::Array(items) => items.iter().map(|item| whole(item, parts)).collect(),
            other => other.clone(),
        }
    }

    // A part in a part: both occur twice, and so does a key that is called like a keyword.
    #[test]
    fn shared_parts_make_the_same_schema() {
        let inner = json!({ "type": "string", "description": "x".repeat(SHORT) });
        let table = json!({
            "type": "object",
            "properties": { "a": inner, "items": { "type": "number" } },
            "additionalProperties": false,
        });
        let schema = json!({ "type": "object", "properties": {
            "one": table,
            "two": { "anyOf": [{ "type": "array", "items": table }, inner] },
        }});
        let shared = share(schema.clone());
        assert_eq!(whole(&shared, &shared["$defs"]), schema);
        let copies = |schema: &Value| schema.to_string().matches(&"x".repeat(SHORT)).count();
        assert_eq!([copies(&schema), copies(&shared)], [3, 1]);
        assert_eq!(shared["properties"]["one"]["$ref"], "#/$defs/part1");
    }
}
