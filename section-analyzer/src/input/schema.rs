//! The single description of the section file: every key with its table, kind of value,
//! meaning and example.
//!
//! The JSON schema for editors ([`json_schema`]) and the reference of the book
//! ([`reference`]) are made from [`SECTION_FILE`]. A test compares the description with
//! the reader, key by key: both must have the same keys.
//!
//! A new key needs one line in a list: `schema/keys.rs`, `schema/materials.rs`,
//! `schema/limits.rs` for the limits of materials, `schema/electric.rs` for electric laws
//! and electrodes, or `schema/laminae.rs` for laminates along curves.

use shared_geom::units::Dimension;

mod distributed;
mod electric;
mod imposed;
mod json;
mod keys;
mod laminae;
mod limits;
mod loads;
mod materials;
mod reference;

pub use json::json_schema;
pub use keys::SECTION_FILE;
pub use reference::reference;

/// A table of the section file.
#[derive(Debug)]
pub struct TableSchema {
    /// The table as it is written: `[material.NAME]`.
    pub title: &'static str,
    /// Its purpose.
    pub meaning: &'static str,
    /// Its keys, except the keys of its families.
    pub keys: &'static [KeySchema],
    /// Sets of keys that exclude each other, of which the table has exactly one;
    /// empty if it has no alternatives.
    pub families: &'static [Family],
}

/// Keys that belong together and exclude the keys of other families.
#[derive(Debug)]
pub struct Family {
    /// The name of the family: `isotropic`.
    pub name: &'static str,
    /// Its purpose.
    pub meaning: &'static str,
    /// Its keys.
    pub keys: &'static [KeySchema],
}

/// One key of a table.
#[derive(Debug)]
pub struct KeySchema {
    /// The key.
    pub name: &'static str,
    /// Allowed values: one kind, or one of several.
    pub kinds: &'static [ValueKind],
    /// Whether it is required, and its default.
    pub need: Need,
    /// Its meaning.
    pub meaning: &'static str,
    /// A value in TOML; empty if the value is a table.
    pub example: &'static str,
}

/// A key; a value that is a table has no example.
const fn key(
    name: &'static str,
    kinds: &'static [ValueKind],
    need: Need,
    example: &'static str,
    meaning: &'static str,
) -> KeySchema {
    KeySchema {
        name,
        kinds,
        need,
        meaning,
        example,
    }
}

/// Whether a key is required.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Need {
    /// Required.
    Required,
    /// Optional, without default.
    Optional,
    /// Optional, with this value or rule as default.
    Default(&'static str),
}

/// Allowed values of a key.
#[derive(Debug)]
pub enum ValueKind {
    /// A text.
    Text,
    /// A text, or a whole number that represents it: a physical group.
    Name,
    /// A name, or a list of names.
    Names,
    /// One of these words.
    Word(&'static [&'static str]),
    /// True or false.
    Boolean,
    /// A text that is a unit of this dimension.
    Unit(Dimension),
    /// A number in the declared units, or a text with a unit of its own.
    Quantity(Dimension),
    /// An array of this number of quantities.
    Vector(usize, Dimension),
    /// A whole number from 1 to this number.
    Count(usize),
    /// A list of one to this number of plain numbers.
    Numbers(usize),
    /// A table of quantities with names chosen by the user.
    Named(Dimension),
    /// Rows and columns of plain numbers.
    Rows(usize, usize),
    /// A table, `[key]`.
    Table(&'static TableSchema),
    /// Tables with names chosen by the user, `[key.NAME]`.
    NamedTables(&'static TableSchema),
    /// A list of tables, `[[key]]`.
    Tables(&'static TableSchema),
}

impl ValueKind {
    /// The table of the key, if its value is a table.
    pub fn table(&self) -> Option<&'static TableSchema> {
        match self {
            Self::Table(table) | Self::NamedTables(table) | Self::Tables(table) => Some(table),
            _ => None,
        }
    }
}
