//! The description of an input file: every key with its table, kind of value, meaning and
//! example.
//!
//! A description is a constant: tables of keys, and tables in them. The JSON schema for
//! editors ([`json_schema`]) and a reference page ([`reference`]) are made from it, and a
//! [`Table`](super::Table) that is read by it refuses every key that it does not have, and
//! every key of a family that its reader did not request.

use crate::error::quoted;
use crate::units::Dimension;

mod json;
mod reference;
mod share;
mod units;

pub use json::{Numbers, json_schema, shared_json_schema};
pub use reference::reference;
pub use units::UNITS;

/// An input file, for its JSON schema and its reference page.
#[derive(Debug, Clone, Copy)]
pub struct Description {
    /// Its top table.
    pub file: &'static TableSchema,
    /// Texts that may replace its numbers.
    pub numbers: Numbers,
    /// The opening of the reference page, in Markdown.
    pub opening: &'static str,
}

impl Description {
    /// The JSON schema, draft 2020-12.
    pub fn json_schema(&self) -> serde_json::Value {
        shared_json_schema(self.file, self.numbers)
    }

    /// The reference page, in Markdown.
    pub fn reference(&self) -> String {
        reference(self.file, self.opening)
    }
}

/// A table of an input file.
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

impl TableSchema {
    /// The keys of the table, and of its families: a key of several families repeatedly.
    pub fn all_keys(&self) -> impl Iterator<Item = &'static KeySchema> + use<> {
        let own = self.families.iter().flat_map(|family| family.keys);
        self.keys.iter().chain(own)
    }

    /// The words of a key that distinguishes the families, in their order.
    pub fn words(&self, key: &str) -> Vec<&'static str> {
        let mut words = Vec::new();
        let of_key = self.all_keys().filter(|own| own.name == key);
        for kind in of_key.flat_map(|own| own.kinds) {
            let ValueKind::Word(own) = kind else { continue };
            let new: Vec<_> = own.iter().filter(|word| !words.contains(*word)).collect();
            words.extend(new);
        }
        words
    }
}

/// Keys that belong together and exclude the keys of other families.
#[derive(Debug, Clone, Copy)]
pub struct Family {
    /// The name of the family: `isotropic`.
    pub name: &'static str,
    /// Its purpose.
    pub meaning: &'static str,
    /// Its keys.
    pub keys: &'static [KeySchema],
}

/// One key of a table.
#[derive(Debug, Clone, Copy)]
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
    /// Expected content in messages, as text; empty if it follows from kind and meaning.
    pub expected: &'static str,
}

impl KeySchema {
    /// Expected content, for messages: as declared, or `other`.
    pub fn expected_or(&self, other: impl FnOnce() -> String) -> String {
        match self.expected {
            "" => other(),
            own => own.to_owned(),
        }
    }

    /// Expected content, for messages: as declared, or from kind and meaning.
    pub fn expected(&self) -> String {
        self.expected_or(|| match self.kinds[0] {
            ValueKind::Word([others @ .., last]) if !others.is_empty() => {
                format!("{} or \"{last}\"", quoted(others))
            }
            ValueKind::Count(_) => "a whole number of at least 1".to_owned(),
            ValueKind::Vector(_, Dimension::NUMBER) => opening(self.meaning),
            ValueKind::Quantity(dimension)
            | ValueKind::Positive(dimension)
            | ValueKind::NotNegative(dimension)
            | ValueKind::Vector(_, dimension) => dimension.to_string(),
            ValueKind::Names => {
                format!("{}, or a list of such names", opening(self.meaning))
            }
            _ => opening(self.meaning),
        })
    }

    /// Whether a number has the sign of its first kind of value.
    pub fn has_sign(&self, number: f64) -> bool {
        match self.kinds[0] {
            ValueKind::Positive(_) => number > 0.0,
            ValueKind::NotNegative(_) => number >= 0.0,
            _ => true,
        }
    }

    /// Expected number, for messages: as declared, or from dimension and sign.
    pub fn expected_number(&self) -> String {
        let sign = match self.kinds[0] {
            ValueKind::Positive(_) => " greater than zero",
            ValueKind::NotNegative(_) => ", zero or more",
            _ => "",
        };
        self.expected_or(|| format!("{}{sign}", self.dimension()))
    }

    /// Dimension of the numbers of its first kind of value.
    pub fn dimension(&self) -> Dimension {
        match self.kinds[0] {
            ValueKind::Quantity(dimension)
            | ValueKind::Positive(dimension)
            | ValueKind::NotNegative(dimension)
            | ValueKind::Quantities(dimension)
            | ValueKind::Vector(_, dimension)
            | ValueKind::Vectors(_, dimension)
            | ValueKind::Drive(dimension)
            | ValueKind::Drives(dimension)
            | ValueKind::NamedDrives(dimension) => dimension,
            _ => Dimension::NUMBER,
        }
    }
}

impl AsRef<str> for KeySchema {
    /// Its name.
    fn as_ref(&self) -> &str {
        self.name
    }
}

/// The opening of a sentence, up to the first of `,`, `;`, `:` and `.`, without a capital.
fn opening(meaning: &str) -> String {
    let opening = meaning
        .split([',', ';', ':', '.'])
        .next()
        .unwrap_or(meaning);
    let mut letters = opening.chars();
    let first = letters.next().map(|first| first.to_ascii_lowercase());
    first.into_iter().chain(letters).collect()
}

/// A key; a value that is a table has no example.
pub const fn key(
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
        expected: "",
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
    /// A text, or a list of texts.
    Texts,
    /// One of these words.
    Word(&'static [&'static str]),
    /// One of these words, or a list of some of them.
    Words(&'static [&'static str]),
    /// True or false.
    Boolean,
    /// A text that is a unit of this dimension.
    Unit(Dimension),
    /// A number in the declared units, or a text with a unit of its own.
    Quantity(Dimension),
    /// A quantity greater than zero.
    Positive(Dimension),
    /// A quantity that is zero or more.
    NotNegative(Dimension),
    /// A quantity, or a list of quantities.
    Quantities(Dimension),
    /// An array of this number of quantities.
    Vector(usize, Dimension),
    /// A list of such arrays.
    Vectors(usize, Dimension),
    /// A quantity whose dimension depends on other keys.
    Free,
    /// A quantity, a list of quantities, or rows of numbers, whose dimension and size depend
    /// on other keys.
    FreeMatrix,
    /// A whole number from 1 to this number, or to any if it is [`usize::MAX`].
    Count(usize),
    /// A list of one to this number of plain numbers.
    Numbers(usize),
    /// A table of quantities with names chosen by the user.
    Named(Dimension),
    /// Rows and columns of plain numbers.
    Rows(usize, usize),
    /// Any number of rows of this number of quantities; any length of them if it is zero.
    Lines(usize),
    /// A number that may change with time: a quantity, an expression, a name, or a table
    /// that is described elsewhere.
    Drive(Dimension),
    /// A list of such numbers.
    Drives(Dimension),
    /// A table of such numbers with names chosen by the user.
    NamedDrives(Dimension),
    /// A table, `[key]`.
    Table(&'static TableSchema),
    /// Tables with names chosen by the user, `[key.NAME]`.
    NamedTables(&'static TableSchema),
    /// A list of tables, `[[key]]`.
    Tables(&'static TableSchema),
    /// A list of tables that are described elsewhere.
    OtherTables,
    /// A table of texts, or of tables, by keys that are described elsewhere.
    Columns(&'static TableSchema),
    /// A table of numbers, or of tables, with names chosen by the user.
    Parameters(&'static TableSchema),
}

impl ValueKind {
    /// The table of the key, if its value is a table.
    pub fn table(&self) -> Option<&'static TableSchema> {
        match self {
            Self::Table(table) | Self::NamedTables(table) | Self::Tables(table) => Some(table),
            _ => None,
        }
    }

    /// The tables that are part of the value.
    pub fn inner_table(&self) -> Option<&'static TableSchema> {
        match self {
            Self::Columns(table) | Self::Parameters(table) => Some(table),
            _ => self.table(),
        }
    }
}
