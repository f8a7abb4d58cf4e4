//! Places on the contour.

use shared_geom::document::schema::KeySchema;
use shared_geom::document::schema::ValueKind::{Quantity, Table as OneTable, Text, Word};
use shared_geom::document::{Declared, Table, Value};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::course::{COURSE, Course};

/// Sides of a contour.
pub const SIDES: [&str; 2] = ["suction", "pressure"];

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
    /// Where the plane at this distance behind the origin meets a `side`.
    PLANE: Option<Course> = "plane", [Quantity(Dimension::LENGTH), OneTable(&COURSE)],
        optional, "\"-0.35 m\"";
    /// Angle of the plane from the normal of the chord line, its suction side aft.
    ANGLE: Course = "angle", [Quantity(Dimension::ANGLE), OneTable(&COURSE)],
        or "0" = Course::constant(0.0), "\"3 deg\"";
    /// A place by its name.
    AT: Option<String> = "at", [Text], optional, "\"cap_suction.end\"";
    /// The side of `x`, `distance` and `plane`.
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
    /// The plane at a distance behind the origin \[m\] whose normal is turned by an angle
    /// \[rad\], on a side.
    Plane(Course, Course, usize),
    /// The name of a place.
    Named(String),
}

impl Place {
    /// A part of the contour.
    pub fn arc(part: f64) -> Self {
        Self::of(PlaceForm::Arc(Course::constant(part)))
    }

    /// A place without a shift.
    pub fn of(form: PlaceForm) -> Self {
        let shift = Course::constant(0.0);
        Self { form, shift }
    }

    /// The place shifted by `factor` times a length.
    pub fn shifted(mut self, by: &Course, factor: f64) -> Self {
        self.shift = self.shift.plus(by, factor);
        self
    }

    /// Whether a position is within its table.
    pub fn covers(&self, eta: f64) -> bool {
        match &self.form {
            PlaceForm::Arc(course)
            | PlaceForm::X(course, _)
            | PlaceForm::Distance(course, _)
            | PlaceForm::Plane(course, ..) => course.covers(eta),
            PlaceForm::Named(_) => true,
        }
    }

    /// Positions along the span at which its table has values.
    pub fn positions(&self) -> &[f64] {
        match &self.form {
            PlaceForm::Arc(course)
            | PlaceForm::X(course, _)
            | PlaceForm::Distance(course, _)
            | PlaceForm::Plane(course, ..) => course.positions(),
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
        let (plane, angle) = (inner.get(&PLANE), inner.get(&ANGLE));
        let shift = inner.get(&SHIFT);
        inner.finish();
        let side = side?;
        let angle = angle?;
        let forms = [
            arc?.map(PlaceForm::Arc),
            x?.zip(side).map(|(x, side)| PlaceForm::X(x, side)),
            distance?
                .zip(side)
                .map(|(distance, side)| PlaceForm::Distance(distance, side)),
            plane?
                .zip(side)
                .map(|(plane, side)| PlaceForm::Plane(plane, angle, side)),
            at?.map(PlaceForm::Named),
        ];
        let given = [&ARC, &X, &DISTANCE, &PLANE].iter();
        let given = given.filter(|key| inner.has(key)).count() + usize::from(inner.has(&AT));
        let form = forms.into_iter().flatten().next();
        let form = form.filter(|_| given == 1);
        if form.is_none() {
            table.wrong(
                key,
                "one of \"arc\", \"x\", \"distance\", \"plane\" and \"at\"; a \"side\" with \"x\", \
                 \"distance\" and \"plane\"",
            );
        }
        let shift = shift?;
        form.map(|form| Self { form, shift })
    }
}
