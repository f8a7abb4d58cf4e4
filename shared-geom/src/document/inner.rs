//! Tables in a table, and the keys that a table may have.

use super::schema::TableSchema;
use super::tree::{Kind, Value};
use super::{DocumentProblem, Table};

impl<'a> Table<'a> {
    /// Whether `key` holds a table.
    pub fn is_table(&self, key: impl AsRef<str>) -> bool {
        matches!(
            self.look_up(key.as_ref()),
            Some(Value {
                kind: Kind::Table(_),
                ..
            })
        )
    }

    /// The table under `key`.
    pub fn table(&self, key: impl AsRef<str>) -> Option<Table<'a>> {
        let key = key.as_ref();
        let entry = self.look_up_entry(key)?;
        match &entry.value.kind {
            Kind::Table(entries) => {
                let title = format!("[{}]", self.path_of(key));
                let table = Table::new(self.document, entries, title, entry.line);
                Some(self.describe(key, table))
            }
            Kind::Array(items) if items.iter().any(|item| matches!(item.kind, Kind::Table(_))) => {
                let expected = format!("one table [{}]", self.path_of(key));
                self.wrong_value(key, &entry.value, &expected)
            }
            _ => self.wrong_value(key, &entry.value, "a table"),
        }
    }

    /// As [`Table::table`], and required.
    pub fn require_table(&self, key: impl AsRef<str>, expected: &str) -> Option<Table<'a>> {
        let key = key.as_ref();
        self.require(key, expected)?;
        self.table(key)
    }

    /// The tables of an array of tables, `[[key]]`; empty when absent.
    pub fn tables(&self, key: impl AsRef<str>) -> Vec<Table<'a>> {
        let key = key.as_ref();
        let Some(value) = self.look_up(key) else {
            return Vec::new();
        };
        let path = self.path_of(key);
        let Kind::Array(items) = &value.kind else {
            let _: Option<()> = self.wrong_value(key, value, &format!("tables [[{path}]]"));
            return Vec::new();
        };
        let table = |(i, item): (usize, &'a Value)| match &item.kind {
            Kind::Table(entries) => {
                let title = format!("[[{path}]] number {}", i + 1);
                let table = Table::new(self.document, entries, title, item.line);
                Some(self.describe(key, table))
            }
            _ => self.wrong_value(key, item, &format!("a table [[{path}]]")),
        };
        items.iter().enumerate().filter_map(table).collect()
    }

    /// The tables `[[table.key]]`; empty if one of both is absent or of another kind, which is not
    /// noted.
    pub fn listed(&self, table: &str, key: &str) -> Vec<Table<'a>> {
        let found = self.is_table(table).then(|| self.table(table)).flatten();
        let listed = found.filter(|found| found.is_list(key));
        listed.map_or_else(Vec::new, |found| found.tables(key))
    }

    /// The tables `[key.name]` with their names; empty when absent.
    pub fn named_tables(&self, key: impl AsRef<str>) -> Vec<(String, Table<'a>)> {
        let key = key.as_ref();
        if self.is_list(key) {
            self.wrong(key, &format!("tables [{key}.NAME]"));
            return Vec::new();
        }
        let Some(outer) = self.table(key) else {
            return Vec::new();
        };
        let names = outer.entries.iter().map(|entry| entry.key.clone());
        names
            .filter_map(|name| {
                let mut table = outer.table(&name)?;
                table.title = format!("{key} \"{name}\"");
                table.schemas.clone_from(&outer.schemas);
                Some((name, table))
            })
            .collect()
    }

    /// The path of `key`: `blade.piece` of the pieces of a blade.
    fn path_of(&self, key: &str) -> String {
        if self.path.is_empty() {
            key.to_owned()
        } else {
            format!("{}.{key}", self.path)
        }
    }

    /// The table under `key` with its path and the descriptions of the key.
    fn describe(&self, key: &str, mut table: Table<'a>) -> Table<'a> {
        table.path = self.path_of(key);
        let keys = self.schemas.iter().flat_map(|schema| schema.all_keys());
        let keys = keys.filter(|own| own.name == key);
        for schema in keys
            .flat_map(|own| own.kinds)
            .filter_map(|kind| kind.table())
        {
            let is_there = |other: &&TableSchema| std::ptr::eq(*other, schema);
            if !table.schemas.iter().any(is_there) {
                table.schemas.push(schema);
            }
        }
        table
    }

    /// The keys of the table, in the order of its descriptions: all common keys, and the
    /// requested keys of families. Without description, the requested keys.
    fn known_keys(&self) -> Vec<String> {
        let requested = self.requested.borrow();
        if self.schemas.is_empty() {
            return requested.clone();
        }
        let mut known: Vec<String> = Vec::new();
        for schema in &self.schemas {
            let families = schema.families.iter().flat_map(|family| family.keys);
            let of_form = families.filter(|key| requested.iter().any(|own| own == key.name));
            for key in schema.keys.iter().chain(of_form) {
                if !known.iter().any(|own| own == key.name) {
                    known.push(key.name.to_owned());
                }
            }
        }
        known
    }

    /// Notes every key that the table does not have.
    pub fn finish(&self) {
        self.finish_beside(&[]);
    }

    /// Notes every key that the table does not have; `others` are keys of other tables, as
    /// they are written there.
    pub fn finish_beside(&self, others: &[(&str, &'static str)]) {
        let known = self.known_keys();
        for entry in self.entries {
            if !known.contains(&entry.key) {
                let right_table = others.iter().find(|(key, _)| *key == entry.key);
                let problem = DocumentProblem::UnknownKey {
                    key: entry.key.clone(),
                    table: self.title.clone(),
                    known: known.clone(),
                    right_table: right_table.map(|(_, location)| *location),
                };
                self.document.note(entry.line, &problem);
            }
        }
    }
}
