//! Tables as values, and the tables under declared keys.

use super::key::{Nested, NestedByName, NestedList};
use super::schema::Need;
use super::tree::Kind;
use super::{Item, Key, Table};

impl<'a> Item<'a> {
    /// The table, if it is one; messages call it `title`.
    pub fn table(&self, title: &str) -> Option<Table<'a>> {
        match &self.value().kind {
            Kind::Table(entries) => Some(Table::new(
                self.document(),
                entries,
                title.to_owned(),
                self.line(),
            )),
            _ => None,
        }
    }
}

impl<'a> Table<'a> {
    /// The table under `key` as converted by `read`, after which its unknown keys are noted.
    /// `Some(None)` if it is absent and optional; `None` if it is wrong, or absent and required,
    /// which has been noted.
    pub fn nested<T>(
        &self,
        key: &Key<Nested>,
        read: impl FnOnce(&Table<'a>) -> Option<T>,
    ) -> Option<Option<T>> {
        if !self.has(key) && key.schema.need != Need::Required {
            return Some(None);
        }
        let table = self.require_table(key, &key.schema.expected())?;
        finished(&table, read).map(Some)
    }

    /// As [`Table::nested`], for every table of a list, which is empty if it is absent and
    /// optional.
    pub fn each<T>(
        &self,
        key: &Key<NestedList>,
        mut read: impl FnMut(&Table<'a>) -> Option<T>,
    ) -> Option<Vec<T>> {
        if key.schema.need == Need::Required {
            self.require(key.name(), &key.schema.expected())?;
        }
        // Every table is read, so that each wrong one is noted.
        let tables = self.tables(key).into_iter();
        let all: Vec<_> = tables.map(|table| finished(&table, &mut read)).collect();
        all.into_iter().collect()
    }

    /// As [`Table::each`], for tables with names.
    pub fn each_by_name<T>(
        &self,
        key: &Key<NestedByName>,
        mut read: impl FnMut(&str, &Table<'a>) -> Option<T>,
    ) -> Option<Vec<(String, T)>> {
        if key.schema.need == Need::Required {
            self.require(key.name(), &key.schema.expected())?;
        }
        let tables = self.named_tables(key).into_iter();
        let all: Vec<_> = tables
            .map(|(name, table)| {
                let found = finished(&table, |table| read(&name, table));
                found.map(|found| (name, found))
            })
            .collect();
        all.into_iter().collect()
    }
}

/// A table as converted by `read`, after which its unknown keys are noted.
fn finished<'a, T>(table: &Table<'a>, read: impl FnOnce(&Table<'a>) -> Option<T>) -> Option<T> {
    let found = read(table);
    table.finish();
    found
}
