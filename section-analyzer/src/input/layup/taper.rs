//! Drops of the thickness of layers at their ends, and profiles over their width.

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

/// Parts of the width of a layer and of its thickness there [-].
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Profile(pub Vec<[f64; 2]>);

impl Declared for Profile {}

impl Value for Profile {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        let count = table.row_count(key).unwrap_or(1);
        let rows = table.rows(key.name, count, 2)?;
        let rows: Vec<[f64; 2]> = rows.into_iter().map(|row| [row[0], row[1]]).collect();
        let is_in_order = rows.windows(2).all(|pair| pair[1][0] > pair[0][0] + 1e-6);
        let ends = (
            rows.first().map(|row| row[0]),
            rows.last().map(|row| row[0]),
        );
        let are_parts = rows.iter().all(|row| (0.0..=1.0).contains(&row[1]));
        let has_some = rows.iter().any(|row| row[1] > 0.0);
        if is_in_order && ends == (Some(0.0), Some(1.0)) && are_parts && has_some {
            return Some(Self(rows));
        }
        table.wrong(
            key,
            "rows of a part of the width, ascending from 0 to 1, and a part of the thickness, 0 to 1, \
             not all 0",
        );
        None
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
