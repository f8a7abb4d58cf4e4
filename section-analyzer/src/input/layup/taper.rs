//! Drops of the thickness of layers.

use shared_geom::document::schema::KeySchema;
use shared_geom::document::{Declared, Table, Value};
use shared_geom::units::{Dimension, parse_quantity};

/// The drop of the thickness of a layer at its ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Taper {
    /// Its length \[m\].
    Length(f64),
    /// Its length over the thickness of the layer [-].
    Slope(f64),
}

impl Taper {
    /// The length of the drop of a layer of this thickness \[m\].
    pub fn length(self, thickness: f64) -> f64 {
        match self {
            Self::Length(length) => length,
            Self::Slope(ratio) => ratio * thickness,
        }
    }
}

impl Declared for Taper {}

/// A length, or 1:N.
impl Value for Taper {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        let read = if table.is_text(key) {
            let text = table.text(key.name)?;
            let slope = text.split_once(':').and_then(|(rise, run)| {
                let [rise, run] = [rise, run].map(|part| part.trim().parse::<f64>().ok());
                rise.filter(|rise| *rise > 0.0)
                    .and_then(|rise| Some(Self::Slope(run? / rise)))
            });
            let length = || {
                parse_quantity(&text, Dimension::LENGTH)
                    .ok()
                    .map(Self::Length)
            };
            slope.or_else(length).unwrap_or(Self::Length(0.0))
        } else {
            table
                .quantity(key.name, Dimension::LENGTH)
                .map(Self::Length)?
        };
        let value = read.length(1.0);
        if !(value > 0.0 && value.is_finite()) {
            table.wrong(key, "a positive length, or \"1:20\"");
            return None;
        }
        Some(read)
    }
}
