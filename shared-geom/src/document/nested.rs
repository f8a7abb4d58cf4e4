//! Tables as values.

use super::tree::Kind;
use super::{Item, Table};

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
