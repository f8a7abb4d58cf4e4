//! Keys that are declared once: [`Table::get`] reads a key by its declaration, and the
//! description of its table contains the same declaration.

use nalgebra::Vector3;

use super::Table;
use super::schema::{KeySchema, Need, ValueKind};
use crate::error::quoted;
use crate::units::Dimension;

/// A key whose value is a `T`: its description, and its default.
#[derive(Debug)]
pub struct Key<T: 'static> {
    /// Its description.
    pub schema: KeySchema,
    /// The value if the key is absent; `None` if it is required, or optional without
    /// default.
    default: Option<fn() -> T>,
}

/// The type of a key with a reader of its own, which [`Table::get`] does not read.
#[derive(Debug)]
pub enum ByHand {}

impl<T: Declared> Key<T> {
    /// A key by its description.
    ///
    /// # Panics
    /// In constants, so that the program does not compile: a type that does not fit the
    /// first kind of value or the need.
    pub const fn new(schema: KeySchema, default: Option<fn() -> T>) -> Self {
        if !matches!(T::FORM, Form::Any) {
            let is_of_type = form_of(&schema.kinds[0]) as u8 == T::FORM as u8;
            assert!(is_of_type, "the type is not the type of the values");
            let has_default = matches!(schema.need, Need::Default(_));
            assert!(
                has_default == default.is_some(),
                "a default is a text and a value"
            );
            let is_optional = matches!(schema.need, Need::Optional);
            assert!(
                is_optional == T::IS_OPTIONAL,
                "the type of an optional key is an option"
            );
        }
        Self { schema, default }
    }

    /// The name of the key.
    pub const fn name(&self) -> &'static str {
        self.schema.name
    }
}

/// Forms of values that are read by a description.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// A text.
    Text,
    /// A list of texts.
    Texts,
    /// An index in a list of words, or a count.
    Index,
    /// A truth value.
    Boolean,
    /// A number.
    Number,
    /// A list of numbers.
    Numbers,
    /// Three numbers.
    Vector,
    /// Any form, of a key with a reader of its own.
    Any,
}

/// The form of the values of a kind.
const fn form_of(kind: &ValueKind) -> Form {
    match kind {
        ValueKind::Text => Form::Text,
        ValueKind::Texts => Form::Texts,
        ValueKind::Word(_) | ValueKind::Count(_) => Form::Index,
        ValueKind::Boolean => Form::Boolean,
        ValueKind::Quantity(_) | ValueKind::Positive(_) | ValueKind::NotNegative(_) => Form::Number,
        ValueKind::Quantities(_) => Form::Numbers,
        ValueKind::Vector(3, _) => Form::Vector,
        _ => Form::Any,
    }
}

/// The type of a key.
pub trait Declared: Sized + 'static {
    /// The form of its values.
    const FORM: Form;
    /// Whether the key may be absent without having a default.
    const IS_OPTIONAL: bool = false;
}

impl Declared for ByHand {
    const FORM: Form = Form::Any;
}

impl Declared for String {
    const FORM: Form = Form::Text;
}

impl Declared for Vec<String> {
    const FORM: Form = Form::Texts;
}

impl Declared for bool {
    const FORM: Form = Form::Boolean;
}

impl Declared for usize {
    const FORM: Form = Form::Index;
}

impl Declared for f64 {
    const FORM: Form = Form::Number;
}

impl Declared for Vec<f64> {
    const FORM: Form = Form::Numbers;
}

impl Declared for Vector3<f64> {
    const FORM: Form = Form::Vector;
}

/// A value that is read by the description of its key.
pub trait Value: Declared {
    /// The value of a key that the table has; `None` if it is wrong, which is noted.
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self>;

    /// The value of an absent key without default; `None` if the key is required.
    fn absent() -> Option<Self> {
        None
    }
}

impl<T: Declared> Declared for Option<T> {
    const FORM: Form = T::FORM;
    const IS_OPTIONAL: bool = true;
}

/// Absent: `Some(None)`.
impl<T: Value> Value for Option<T> {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        T::read(table, key).map(Some)
    }

    fn absent() -> Option<Self> {
        Some(None)
    }
}

impl Value for String {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        table.text(key.name)
    }
}

impl Value for Vec<String> {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        table.texts(key.name)
    }
}

impl Value for bool {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        table.boolean(key.name)
    }
}

/// The index of a word, or a count up to its limit.
impl Value for usize {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        match key.kinds[0] {
            ValueKind::Word(words) => table.word(key.name, words),
            ValueKind::Count(limit) => {
                let found = table.count(key.name)?;
                if found > limit {
                    table.wrong(key.name, &format!("at most {limit}"));
                    return None;
                }
                Some(found)
            }
            _ => table.count(key.name),
        }
    }
}

/// A quantity in SI units.
impl Value for f64 {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        let (dimension, is_right, range): (_, fn(f64) -> bool, _) = match key.kinds[0] {
            ValueKind::Positive(dimension) => {
                (dimension, |found| found > 0.0, " greater than zero")
            }
            ValueKind::NotNegative(dimension) => {
                (dimension, |found| found >= 0.0, ", zero or more")
            }
            _ => (dimension_of(key), |_| true, ""),
        };
        let found = table.quantity(key.name, dimension)?;
        if is_right(found) {
            return Some(found);
        }
        table.wrong(key.name, &format!("{dimension}{range}"));
        None
    }
}

/// Quantities in SI units.
impl Value for Vec<f64> {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        table.quantities(key.name, dimension_of(key))
    }
}

/// Three quantities in SI units.
impl Value for Vector3<f64> {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        table.vector(key.name, dimension_of(key))
    }
}

/// The dimension of the numbers of a key.
fn dimension_of(key: &KeySchema) -> Dimension {
    match key.kinds[0] {
        ValueKind::Quantity(dimension)
        | ValueKind::Positive(dimension)
        | ValueKind::NotNegative(dimension)
        | ValueKind::Quantities(dimension)
        | ValueKind::Vector(_, dimension) => dimension,
        _ => Dimension::NUMBER,
    }
}

/// Expected content of a key, for the message about its absence.
fn expected(key: &KeySchema) -> String {
    match key.kinds[0] {
        ValueKind::Word([others @ .., last]) if !others.is_empty() => {
            format!("{} or \"{last}\"", quoted(others))
        }
        ValueKind::Count(_) => "a whole number of at least 1".to_owned(),
        ValueKind::Quantity(dimension)
        | ValueKind::Positive(dimension)
        | ValueKind::NotNegative(dimension)
        | ValueKind::Vector(_, dimension) => dimension.to_string(),
        _ => opening(key.meaning),
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

impl Table<'_> {
    /// The value of a key: its default if it is absent and has one. `None` if it is wrong,
    /// or absent and required; the problem has been noted.
    pub fn get<T: Value>(&self, key: &Key<T>) -> Option<T> {
        let schema = &key.schema;
        if self.has(schema.name) {
            return T::read(self, schema);
        }
        match key.default {
            Some(default) => Some(default()),
            None if T::IS_OPTIONAL => T::absent(),
            None => {
                // Notes that it is absent.
                self.require(schema.name, &expected(schema))?;
                None
            }
        }
    }

    /// Whether the table has a declared key.
    pub fn holds<T: Declared>(&self, key: &Key<T>) -> bool {
        self.has(key.name())
    }
}

#[cfg(test)]
mod tests;
