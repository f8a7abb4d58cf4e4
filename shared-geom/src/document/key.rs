//! Keys that are declared once: [`Table::get`] reads a key by its declaration, and the
//! description of its table contains the same declaration.

use nalgebra::Vector3;

use super::schema::{KeySchema, Need, TableSchema, ValueKind};
use super::{Item, Table};

/// A key whose value is a `T`: its description, and its default.
#[derive(Debug)]
pub struct Key<T: 'static> {
    /// Its description.
    pub schema: KeySchema,
    /// The value if the key is absent; `None` if it is required, or optional without
    /// default.
    default: Option<fn() -> T>,
}

/// The type of a key that [`Table::get`] does not read: more than the file is needed to read
/// its value, or it has several forms.
#[derive(Debug)]
pub enum ByHand {}

/// The type of a key whose value is a table, which [`Table::nested`] reads.
#[derive(Debug)]
pub enum Nested {}

/// The type of a key whose value is a list of tables, which [`Table::each`] reads.
#[derive(Debug)]
pub enum NestedList {}

/// The type of a key whose value is tables with names, which [`Table::each_by_name`] reads.
#[derive(Debug)]
pub enum NestedByName {}

impl<T: Declared> Key<T> {
    /// A key by its description.
    ///
    /// # Panics
    /// In constants, so that the program does not compile: a type that does not fit a kind of
    /// value or the need.
    pub const fn new(schema: KeySchema, default: Option<fn() -> T>) -> Self {
        if !matches!(T::FORM, Form::Any | Form::ByHand) {
            let (mut index, mut is_of_type) = (0, false);
            while index < schema.kinds.len() {
                is_of_type |= form_of(&schema.kinds[index]).number() == T::FORM.number();
                index += 1;
            }
            assert!(is_of_type, "the type is not the type of the values");
        }
        if matches!(T::FORM, Form::Table | Form::Tables | Form::NamedTables) {
            assert!(default.is_none(), "a table has no default");
        } else if !matches!(T::FORM, Form::ByHand) {
            let is_right = match schema.need {
                Need::Required => default.is_none() && !T::IS_OPTIONAL,
                Need::Optional => default.is_none() && T::IS_OPTIONAL,
                Need::Default(_) => default.is_some() != T::IS_OPTIONAL,
            };
            assert!(
                is_right,
                "a default has a value, or the type of the key is an option"
            );
        }
        Self { schema, default }
    }

    /// The name of the key.
    pub const fn name(&self) -> &'static str {
        self.schema.name
    }
}

impl<T: 'static> AsRef<str> for Key<T> {
    /// The name of the key.
    fn as_ref(&self) -> &str {
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
    /// This number of numbers.
    Vector(usize),
    /// A list of three numbers each.
    Vectors,
    /// These numbers of rows and columns.
    Rows(usize, usize),
    /// Indices in a list of words.
    Words,
    /// A table.
    Table,
    /// A list of tables.
    Tables,
    /// Tables with names.
    NamedTables,
    /// Any form, of a type with a reader of its own.
    Any,
    /// Any form, of a key that is not read by its description.
    ByHand,
}

impl Form {
    /// A number that is different for each form.
    const fn number(self) -> usize {
        match self {
            Self::Text => 0,
            Self::Texts => 1,
            Self::Index => 2,
            Self::Boolean => 3,
            Self::Number => 4,
            Self::Numbers => 5,
            Self::Vectors => 6,
            Self::Any => 7,
            Self::ByHand => 8,
            Self::Words => 9,
            Self::Table => 10,
            Self::Tables => 11,
            Self::NamedTables => 12,
            Self::Vector(count) => 100 + count,
            Self::Rows(rows, columns) => 1000 + 100 * rows + columns,
        }
    }
}

/// The form of the values of a kind.
const fn form_of(kind: &ValueKind) -> Form {
    match kind {
        ValueKind::Text => Form::Text,
        ValueKind::Texts => Form::Texts,
        ValueKind::Word(_) | ValueKind::Count(_) => Form::Index,
        ValueKind::Boolean => Form::Boolean,
        ValueKind::Quantity(_) | ValueKind::Positive(_) | ValueKind::NotNegative(_) => Form::Number,
        ValueKind::Quantities(_) | ValueKind::Numbers(_) => Form::Numbers,
        ValueKind::Vector(count, _) => Form::Vector(*count),
        ValueKind::Vectors(3, _) => Form::Vectors,
        ValueKind::Rows(rows, columns) => Form::Rows(*rows, *columns),
        ValueKind::Words(_) => Form::Words,
        ValueKind::Table(_) => Form::Table,
        ValueKind::Tables(_) => Form::Tables,
        ValueKind::NamedTables(_) => Form::NamedTables,
        _ => Form::Any,
    }
}

/// The type of a key.
pub trait Declared: Sized + 'static {
    /// The form of its values; any for a type with a reader of its own.
    const FORM: Form = Form::Any;
    /// Whether the key may be absent without having a default.
    const IS_OPTIONAL: bool = false;
}

impl Declared for ByHand {
    const FORM: Form = Form::ByHand;
}

impl Declared for Nested {
    const FORM: Form = Form::Table;
}

impl Declared for NestedList {
    const FORM: Form = Form::Tables;
}

impl Declared for NestedByName {
    const FORM: Form = Form::NamedTables;
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
    const FORM: Form = Form::Vector(3);
}

impl<const N: usize> Declared for [f64; N] {
    const FORM: Form = Form::Vector(N);
}

impl<const M: usize, const N: usize> Declared for [[f64; N]; M] {
    const FORM: Form = Form::Rows(M, N);
}

impl Declared for Vec<usize> {
    const FORM: Form = Form::Words;
}

impl Declared for Vec<Vector3<f64>> {
    const FORM: Form = Form::Vectors;
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
                    table.wrong(key.name, &key.expected_or(|| format!("at most {limit}")));
                    return None;
                }
                Some(found)
            }
            _ => table.count(key.name),
        }
    }
}

/// The indices of words; one word is a list of one.
impl Value for Vec<usize> {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        let known = match key.kinds[0] {
            ValueKind::Words(known) => known,
            _ => &[],
        };
        let found = table.texts(key.name)?.into_iter();
        // Every word is read, so that each wrong one is noted.
        let indices: Vec<_> = found
            .map(|word| table.index_of(key.name, word, known, &[]))
            .collect();
        indices.into_iter().collect()
    }
}

/// A quantity in SI units.
impl Value for f64 {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        let found = table.quantity(key.name, key.dimension())?;
        if !key.has_sign(found) {
            table.wrong(key.name, &key.expected_number());
            return None;
        }
        Some(found)
    }
}

/// Quantities in SI units.
impl Value for Vec<f64> {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        let found = match (&key.kinds[0], table.is_list(key)) {
            (ValueKind::Numbers(_), false) => Self::new(),
            _ => table.quantities(key.name, key.dimension())?,
        };
        match key.kinds[0] {
            ValueKind::Numbers(most) if !(1..=most).contains(&found.len()) => {
                let expected = || format!("an array of 1 to {most} numbers");
                table.wrong(key, &key.expected_or(expected));
                None
            }
            _ => Some(found),
        }
    }
}

/// Three quantities in SI units.
impl Value for Vector3<f64> {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        <[f64; 3]>::read(table, key).map(Self::from)
    }
}

/// Quantities in SI units.
impl<const N: usize> Value for [f64; N] {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        let dimension = key.dimension();
        let example = key.example;
        let other = || format!("an array of {N}, each {dimension}, as in {example}");
        let expected = key.expected_or(other);
        table.array(key.name, dimension, &expected)
    }
}

/// Rows of plain numbers; no unit is applied.
impl<const M: usize, const N: usize> Value for [[f64; N]; M] {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        let rows = table.rows(key.name, M, N)?;
        Some(std::array::from_fn(|i| std::array::from_fn(|j| rows[i][j])))
    }
}

/// Vectors in SI units; one vector is a list of one.
impl Value for Vec<Vector3<f64>> {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        table.vectors(key.name, key.dimension())
    }
}

impl Table<'_> {
    /// The value of a key: its default if it is absent and has one. `None` if it is wrong,
    /// or absent and required; the problem has been noted.
    pub fn get<T: Value>(&self, key: &Key<T>) -> Option<T> {
        if self.has(key) {
            return T::read(self, &key.schema);
        }
        match key.default {
            Some(default) => Some(default()),
            None if T::IS_OPTIONAL => T::absent(),
            None => {
                // Notes that it is absent.
                self.require(key.name(), &key.schema.expected())?;
                None
            }
        }
    }

    /// The value of a key that the table has; `None` if it is absent or wrong.
    pub fn given<T: Value>(&self, key: &Key<T>) -> Option<T> {
        self.has(key).then(|| self.get(key)).flatten()
    }

    /// The word under a required key that distinguishes the families of `schema`.
    pub fn choice(&self, schema: &TableSchema, key: &str) -> Option<&'static str> {
        self.choice_or_meant(schema, key, &[])
    }

    /// As [`Table::choice`]; for a word that is the first of a pair, its second is proposed.
    pub fn choice_or_meant(
        &self,
        schema: &TableSchema,
        key: &str,
        meant: &[(&str, &'static str)],
    ) -> Option<&'static str> {
        let words = schema.words(key);
        self.require(key, &format!("one of {}", words.join(", ")))?;
        let index = self.word_or_meant(key, &words, meant)?;
        Some(words[index])
    }

    /// Whether a table has a known word under such a key; nothing is noted.
    pub fn has_choice(&self, schema: &TableSchema, key: &str) -> bool {
        let item = self.item(key);
        let word = item.as_ref().and_then(Item::text);
        word.is_some_and(|word| schema.words(key).contains(&word))
    }

    /// As [`Table::get`], if the value is right; otherwise it is noted that `expected` is.
    pub fn get_if<T: Value>(
        &self,
        key: &Key<T>,
        is_right: impl FnOnce(&T) -> bool,
        expected: &str,
    ) -> Option<T> {
        let found = self.get(key)?;
        if is_right(&found) {
            return Some(found);
        }
        self.wrong(key, expected);
        None
    }
}

#[cfg(test)]
mod tests;
