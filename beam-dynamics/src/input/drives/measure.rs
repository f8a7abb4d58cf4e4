//! Units of the numbers of a drive.

use shared_geom::document::schema::KeySchema;
use shared_geom::document::{Declared, Document, DocumentProblem, Item, Table, Value};
use shared_geom::units::{self, Dimension, Unit};

/// Unit of the numbers of a drive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::input) enum Measure {
    /// A quantity in its declared unit.
    Declared(Dimension),
    /// Plain numbers.
    Plain,
    /// A quantity in a unit that the drive names.
    Unit(Unit),
}

impl Declared for Measure {}

/// A unit.
impl Value for Measure {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        match units::parse(&table.text(key.name)?) {
            Ok(unit) => Some(Self::Unit(unit)),
            Err(problem) => {
                let name = key.name.to_owned();
                table.note(key, &DocumentProblem::Unit { key: name, problem });
                None
            }
        }
    }
}

impl Measure {
    /// SI units, or plain numbers, per plain number \[unit of the drive\].
    pub fn factor(self, document: &Document) -> f64 {
        match self {
            Self::Declared(dimension) => document.factor(dimension),
            Self::Plain => 1.0,
            Self::Unit(unit) => unit.factor,
        }
    }

    /// The factor that converts from `other` to this measure; `None` if they have different
    /// dimensions.
    pub fn factor_from(self, other: Self, document: &Document) -> Option<f64> {
        match (self, other) {
            (_, Self::Plain) => Some(self.factor(document)),
            (Self::Plain, _) => None,
            _ => (self.dimension() == other.dimension()).then_some(1.0),
        }
    }

    fn dimension(self) -> Dimension {
        match self {
            Self::Declared(dimension) => dimension,
            Self::Plain => Dimension::NUMBER,
            Self::Unit(unit) => unit.dimension,
        }
    }

    /// Description of the dimension.
    pub fn words(self) -> String {
        self.dimension().to_string()
    }

    /// A number in this measure, converted to SI units.
    pub fn number(self, item: &Item<'_>) -> Option<f64> {
        let is_plain = item
            .text()
            .is_none_or(|text| text.trim_start().starts_with('='));
        match self {
            Self::Unit(unit) if is_plain => Some(unit.factor * item.quantity(Dimension::NUMBER)?),
            _ => item.quantity(self.dimension()),
        }
    }
}
