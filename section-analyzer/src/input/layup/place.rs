//! Places on the contour.

use shared_geom::document::schema::KeySchema;
use shared_geom::document::schema::ValueKind::{Quantity, Table as OneTable, Text, Word};
use shared_geom::document::{Declared, Table, Value};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::course::{COURSE, Course};

/// Sides of a contour.
const SIDES: [&str; 2] = ["suction", "pressure"];

keys! {
    /// A place on the contour. As a number it is the part of the contour from the trailing edge
    /// over the suction side (0), the nose (about 0.5) and the pressure side (1); as a text,
    /// `nose`, `LAYER.start`, `LAYER.end`, `WEB.suction` or `WEB.pressure`.
    pub(super) PLACE = "place";
    /// Part of the contour.
    ARC: Option<Course> = "arc", [Quantity(Dimension::NUMBER), OneTable(&COURSE)], optional,
        "0.31";
    /// Part of the chord, on a `side`.
    X: Option<Course> = "x", [Quantity(Dimension::NUMBER), OneTable(&COURSE)], optional,
        "0.25";
    /// Length along the surface from the trailing edge, on a `side`.
    DISTANCE: Option<Course> = "distance", [Quantity(Dimension::LENGTH), OneTable(&COURSE)],
        optional, "\"120 mm\"";
    /// A place by its name.
    AT: Option<String> = "at", [Text], optional, "\"cap_suction.end\"";
    /// The side of `x` and `distance`.
    SIDE: Option<usize> = "side", [Word(&SIDES)], optional, "\"suction\"";
    /// Length along the contour that is added, in its direction.
    SHIFT: Course = "shift", [Quantity(Dimension::LENGTH), OneTable(&COURSE)],
        or "0" = Course::constant(0.0), "\"40 mm\"";
}

/// A place on the contour.
#[derive(Debug, Clone, PartialEq)]
pub struct Place {
    /// The form in which it is given.
    pub form: PlaceForm,
    /// Length along the contour that is added \[m\].
    pub shift: Course,
}

/// The forms of a place.
#[derive(Debug, Clone, PartialEq)]
pub enum PlaceForm {
    /// Part of the contour [-].
    Arc(Course),
    /// Part of the chord on a side, 0 suction, 1 pressure [-].
    X(Course, usize),
    /// Length from the trailing edge on a side \[m\].
    Distance(Course, usize),
    /// The name of a place.
    Named(String),
}

impl Place {
    /// A part of the contour.
    pub fn arc(part: f64) -> Self {
        Self::of(PlaceForm::Arc(Course::constant(part)))
    }

    fn of(form: PlaceForm) -> Self {
        let shift = Course::constant(0.0);
        Self { form, shift }
    }

    /// Positions along the span at which its table has values.
    pub fn positions(&self) -> &[f64] {
        match &self.form {
            PlaceForm::Arc(course) | PlaceForm::X(course, _) | PlaceForm::Distance(course, _) => {
                course.positions()
            }
            PlaceForm::Named(_) => &[],
        }
    }
}

impl Declared for Place {}

impl Value for Place {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        if table.is_text(key) {
            return table.text(key.name).map(PlaceForm::Named).map(Self::of);
        }
        if !table.is_table(key) {
            return table.quantity(key.name, Dimension::NUMBER).map(Self::arc);
        }
        // a table of positions and values, or of a place
        let inner = table.table(key)?;
        if inner.has("eta") || inner.has("value") {
            return Course::read(table, key).map(PlaceForm::Arc).map(Self::of);
        }
        let inner = inner.described(&PLACE);
        let side = inner.get(&SIDE);
        let (arc, x) = (inner.get(&ARC), inner.get(&X));
        let (distance, at) = (inner.get(&DISTANCE), inner.get(&AT));
        let shift = inner.get(&SHIFT);
        inner.finish();
        let (arc, x, distance, at) = (arc?, x?, distance?, at?);
        let side = side?;
        let form = match (arc, x, distance, at) {
            (Some(arc), None, None, None) => Some(PlaceForm::Arc(arc)),
            (None, Some(x), None, None) => side.map(|side| PlaceForm::X(x, side)),
            (None, None, Some(distance), None) => {
                side.map(|side| PlaceForm::Distance(distance, side))
            }
            (None, None, None, Some(at)) => Some(PlaceForm::Named(at)),
            _ => None,
        };
        if form.is_none() {
            table.wrong(
                key,
                "one of \"arc\", \"x\", \"distance\" and \"at\"; a \"side\" with \"x\" and \"distance\"",
            );
        }
        let shift = shift?;
        form.map(|form| Self { form, shift })
    }
}
