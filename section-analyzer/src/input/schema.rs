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

use serde_json::Value;
use shared_geom::document::schema;

mod distributed;
mod electric;
mod imposed;
mod keys;
mod laminae;
mod limits;
mod loads;
mod materials;

pub use keys::SECTION_FILE;
pub use shared_geom::document::schema::{
    Family, KeySchema, Need, TableSchema, UNITS, ValueKind, key,
};

/// The opening of the reference page.
const OPENING: &str = "\
# Section input reference

Every key of a section file, `NAME.section.toml`.
Made by `section-analyzer schema --format markdown`; do not edit.
The use of the keys is described in [Section input](section-input.md).

A *quantity* is a number in the declared units, or a text with its own unit, such as `\"73.1 GPa\"`.
A *name* is a text, or a whole number that represents one: the tag of a physical group.
";

/// The JSON schema of a section file, draft 2020-12.
///
/// It does not check the names of groups, the dimensions of units and the admissibility of
/// laws; `section-analyzer check` does.
pub fn json_schema() -> Value {
    schema::json_schema(&SECTION_FILE, schema::Numbers::Plain)
}

/// The reference page of the section file, in Markdown.
pub fn reference() -> String {
    schema::reference(&SECTION_FILE, OPENING)
}
