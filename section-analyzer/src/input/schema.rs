//! The section file, described once: every key with its table, kind of value,
//! meaning and example.
//!
//! From [`SECTION_FILE`] follow the JSON schema for editors ([`json_schema`]) and the
//! reference of the book ([`reference`]). A test holds the description and the
//! reader to each other, key by key: what one knows, the other must know.
//!
//! A new key is one line in a list: `schema/keys.rs`, `schema/materials.rs`,
//! `schema/limits.rs` for the limits of materials, `schema/electric.rs` for electric laws and electrodes, or
//! `schema/laminae.rs` for laminates along curves.

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
    /// What it is for.
    pub meaning: &'static str,
    /// Its keys, but for those of its families.
    pub keys: &'static [KeySchema],
    /// Sets of keys that exclude each other, of which the table has exactly one;
    /// empty where it has no such choice.
    pub families: &'static [Family],
}

/// Keys that belong together and exclude those of other families.
#[derive(Debug)]
pub struct Family {
    /// The name of the family: `isotropic`.
    pub name: &'static str,
    /// What it is for.
    pub meaning: &'static str,
    /// Its keys.
    pub keys: &'static [KeySchema],
}

/// One key of a table.
#[derive(Debug)]
pub struct KeySchema {
    /// The key.
    pub name: &'static str,
    /// What its value may be: one kind, or one of several.
    pub kinds: &'static [ValueKind],
    /// Whether it must be there, and what holds when it is not.
    pub need: Need,
    /// What it means.
    pub meaning: &'static str,
    /// A value in TOML; empty where the value is a table.
    pub example: &'static str,
}

/// A key; a value that is a table has no example of its own.
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

/// Whether a key must be there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Need {
    /// It must.
    Required,
    /// It need not, and nothing takes its place.
    Optional,
    /// It need not; this value or rule, in words, takes its place.
    Default(&'static str),
}

/// What a value may be.
#[derive(Debug)]
pub enum ValueKind {
    /// A text.
    Text,
    /// A text, or a whole number that stands for one: a physical group.
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
    /// As many quantities.
    Vector(usize, Dimension),
    /// A whole number from 1 to this one.
    Count(usize),
    /// A list of one to as many plain numbers.
    Numbers(usize),
    /// A table of quantities by names of the user's choice.
    Named(Dimension),
    /// Rows and columns of plain numbers.
    Rows(usize, usize),
    /// A table, `[key]`.
    Table(&'static TableSchema),
    /// Tables with names of the user's choice, `[key.NAME]`.
    NamedTables(&'static TableSchema),
    /// A list of tables, `[[key]]`.
    Tables(&'static TableSchema),
}

impl ValueKind {
    /// The table behind the key, where there is one.
    pub fn table(&self) -> Option<&'static TableSchema> {
        match self {
            Self::Table(table) | Self::NamedTables(table) | Self::Tables(table) => Some(table),
            _ => None,
        }
    }
}
