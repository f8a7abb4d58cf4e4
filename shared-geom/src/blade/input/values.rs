//! Values of keys of the blade file: words, and curvatures of arcs.

use nalgebra::Vector3;

use crate::document::schema::KeySchema;
use crate::document::{Declared, Item, Table, Value};
use crate::expression::written;
use crate::units::{Dimension, parse_any};

/// Names of frames.
pub(super) const FRAMES: [&str; 6] = ["helicoid", "beamdyn", "hawc2", "vabs", "sonata", "anba4"];
/// Directions that describe axes.
pub(super) const DIRECTIONS: [&str; 6] = [
    "tip",
    "root",
    "leading edge",
    "trailing edge",
    "upper",
    "lower",
];
/// The six components along and about the axes of a frame.
pub(super) const COMPONENTS: [&str; 6] = ["Fx", "Fy", "Fz", "Mx", "My", "Mz"];

/// Inverse of a length: curvature, angle per length without the angle.
const INVERSE_LENGTH: Dimension = Dimension {
    length: -1,
    ..Dimension::NUMBER
};

/// The curvature of an arc \[1/m\]: numbers are the inverse of a radius, texts an inverse radius
/// or an angle per length, as in section files.
#[derive(Debug, Clone, Copy)]
pub(super) struct ArcCurvature(pub Vector3<f64>);

impl Declared for ArcCurvature {}

impl Value for ArcCurvature {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        curvature(&table.item(key)?).map(Self)
    }
}

fn curvature(item: &Item<'_>) -> Option<Vector3<f64>> {
    let expected = "an array of 3: one over a radius, or angles per length, as in \"5 deg/m\"";
    let Some(items) = item.list().filter(|items| items.len() == 3) else {
        return item.wrong(expected);
    };
    let quantity = |item: &Item<'_>| {
        let text = item.text().filter(|text| written(text).is_none());
        let of_angle = text.is_some_and(|text| {
            let found = parse_any(text).map(|(_, dimension)| dimension);
            found != Ok(INVERSE_LENGTH)
        });
        item.quantity(if of_angle {
            Dimension::CURVATURE
        } else {
            INVERSE_LENGTH
        })
    };
    // Every number is read, so that each wrong one is noted.
    let numbers: Vec<_> = items.iter().map(quantity).collect();
    let numbers: Option<Vec<f64>> = numbers.into_iter().collect();
    Some(Vector3::from_vec(numbers?))
}
