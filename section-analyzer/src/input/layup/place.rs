//! Places on the contour.

use shared_geom::document::schema::ValueKind::{Positive, Quantity, Table as OneTable, Text, Word};
use shared_geom::document::schema::{Family, KeySchema, TableSchema};
use shared_geom::document::{Declared, Table, Value};
use shared_geom::keys;
use shared_geom::units::{Dimension, parse_quantity};

use super::course::{COURSE, Course};
use super::problem::LayupFileProblem;

/// Edges from which distances along the contour are measured.
const EDGES: [&str; 2] = [AT_EDGE, "leading_edge"];
/// Sides of a contour.
pub const SIDES: [&str; 2] = ["suction", "pressure"];

keys! {
    /// A place on the contour. As a number it is the part of the contour from the trailing edge
    /// over the suction side (0), the nose (about 0.5) and the pressure side (1); as a text,
    /// `nose`, `leading_edge`, `base.suction`, `base.pressure`, `LAYER.start`, `LAYER.end`,
    /// `WEB.suction`, `WEB.pressure`, for the faces of a web `WEB.suction.fore` and so on (`aft`),
    /// or the NAME of `[place.NAME]`; with a shift, `cap.end + 40 mm`, or `nose - 0.02` for a part
    /// of the contour.
    pub(super) PLACE = "place";
    /// Part of the contour.
    ARC: Option<Course> = "arc", [Quantity(Dimension::NUMBER), OneTable(&COURSE)], optional,
        "0.31";
    /// Part of the chord, on a `side`.
    X: Option<Course> = "x", [Quantity(Dimension::NUMBER), OneTable(&COURSE)], optional,
        "0.25";
    /// Length along the surface from the trailing edge, or the edge `from`, on a `side`.
    DISTANCE: Option<Course> = "distance", [Quantity(Dimension::LENGTH), OneTable(&COURSE)],
        optional, "\"120 mm\"";
    /// The edge from which `distance` is measured.
    FROM_EDGE: usize = "from", [Word(&EDGES)], or "\"trailing_edge\"" = 0, "\"leading_edge\"";
    /// Where the plane at this distance behind the origin meets a `side`.
    PLANE: Option<Course> = "plane", [Quantity(Dimension::LENGTH), OneTable(&COURSE)],
        optional, "\"-0.35 m\"";
    /// Angle of the plane from the normal of the chord line, its suction side aft.
    ANGLE: Course = "angle", [Quantity(Dimension::ANGLE), OneTable(&COURSE)],
        or "0" = Course::constant(0.0), "\"3 deg\"";
    /// A place by its name, as in the text.
    AT: Option<String> = "at", [Text], optional, "\"cap_suction.end\"";
    /// The side of `x`, `distance` and `plane`; of the places of webs the one of the key.
    SIDE: Option<usize> = "side", [Word(&SIDES)], optional, "\"suction\"";
    /// Length along the contour that is added, in its direction.
    SHIFT: Course = "shift", [Quantity(Dimension::LENGTH), OneTable(&COURSE)],
        or "0" = Course::constant(0.0), "\"40 mm\"";
}

/// The plane of a web.
pub(super) const BOTH: TableSchema = TableSchema {
    title: "plane of a web",
    meaning: "The plane of a web, which meets both sides.",
    keys: &[],
    families: &[
        Family {
            name: "x",
            meaning: "Normal to the chord line.",
            keys: &[X_OF_WEB.schema],
        },
        Family {
            name: "plane",
            meaning: "At a distance behind the origin, also inclined.",
            keys: &[PLANE_OF_WEB.schema, ANGLE.schema],
        },
        Family {
            name: "distance",
            meaning: "At equal lengths along both surfaces from the trailing edge.",
            keys: &[DISTANCE_OF_WEB.schema, FROM_TRAILING.schema],
        },
    ],
};

keys! {
    /// Part of the chord.
    X_OF_WEB: Course = "x", [Quantity(Dimension::NUMBER), OneTable(&COURSE)], required, "0.3";
    /// Length along the surfaces.
    DISTANCE_OF_WEB: Course = "distance", [Positive(Dimension::LENGTH), OneTable(&COURSE)], required,
        "\"0.1 m\"";
    /// The edge from which it is measured.
    FROM_TRAILING: usize = "from", [Word(&[AT_EDGE])], or "\"trailing_edge\"" = 0,
        "\"trailing_edge\"";
    /// Distance of the plane behind the origin.
    PLANE_OF_WEB: Course = "plane", [Quantity(Dimension::LENGTH), OneTable(&COURSE)], required,
        "\"-0.35 m\"";
}

/// A place on the contour.
#[derive(Debug, Clone, PartialEq)]
pub struct Place {
    /// The form in which it is given.
    pub form: PlaceForm,
    /// Length along the contour that is added \[m\].
    pub shift: Course,
    /// Part of the contour that is added [-].
    pub part: f64,
    /// The line of the file on which it is given; 0 if it is not given there.
    pub line: usize,
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

/// Ends of the names of places of layers and webs.
const PARTS: [&str; 6] = [".start", ".end", ".suction", ".pressure", ".fore", ".aft"];

/// Whether the text behind a sign is a shift, and not the rest of a name with a sign in it.
fn is_shift(text: &str) -> bool {
    let is_number = text.starts_with(|first: char| first.is_ascii_digit() || "+-.".contains(first));
    is_number && !PARTS.iter().any(|part| text.ends_with(part))
}

impl Place {
    /// A part of the contour.
    pub fn arc(part: f64) -> Self {
        Self::of(PlaceForm::Arc(Course::constant(part)))
    }

    /// The place of a name on a line of the file.
    pub(super) fn of_name(name: String, line: usize) -> Self {
        Self::of(PlaceForm::Named(name)).on_line(line)
    }

    /// A place without a shift.
    pub fn of(form: PlaceForm) -> Self {
        Self {
            form,
            shift: Course::constant(0.0),
            part: 0.0,
            line: 0,
        }
    }

    fn on_line(self, line: usize) -> Self {
        Self { line, ..self }
    }

    /// A place by its name, with or without a shift: `cap.end + 40 mm`, `nose - 0.02`.
    fn named(text: &str) -> Result<Self, String> {
        let text = text.replace('\t', " ");
        let signs = [(" + ", 1.0), (" - ", -1.0)];
        let found = signs.map(|(word, sign)| {
            let at = text.rfind(word)?;
            is_shift(text[at + 3..].trim()).then_some((at, sign))
        });
        let Some((at, sign)) = found.into_iter().flatten().max_by_key(|found| found.0) else {
            return Ok(Self::of(PlaceForm::Named(text.trim().to_owned())));
        };
        let mut place = Self::of(PlaceForm::Named(text[..at].trim().to_owned()));
        let by = text[at + 3..].trim();
        match by.parse::<f64>() {
            Ok(part) if part.is_finite() => place.part = sign * part,
            _ => {
                let length = parse_quantity(by, Dimension::LENGTH);
                let length = length.map_err(|problem| problem.to_string())?;
                place.shift = Course::constant(sign * length);
            }
        }
        Ok(place)
    }

    /// The quantities along the span.
    pub(super) fn courses_mut(&mut self) -> Vec<&mut Course> {
        let mut all = vec![&mut self.shift];
        match &mut self.form {
            PlaceForm::Arc(course) | PlaceForm::X(course, _) | PlaceForm::Distance(course, _) => {
                all.push(course);
            }
            PlaceForm::Plane(course, angle, _) => all.extend([course, angle]),
            PlaceForm::Named(_) => {}
        }
        all
    }

    /// The place shifted by `factor` times a length.
    pub fn shifted(mut self, by: &Course, factor: f64) -> Self {
        let is_zero = self.shift.positions().is_empty() && self.shift.at(0.0) == 0.0;
        self.shift = if is_zero && factor == 1.0 {
            by.clone()
        } else {
            self.shift.plus(by, factor)
        };
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
        let place = Self::read_form(table, key)?;
        Some(place.on_line(table.line_of(key)))
    }
}

impl Place {
    fn read_form(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        if table.is_text(key) {
            let made = Self::named(&table.text(key.name)?);
            let expected = |reason| format!("a place, as \"cap.end + 40 mm\" ({reason})");
            return made
                .map_err(|reason| table.wrong(key, &expected(reason)))
                .ok();
        }
        if !table.is_table(key) {
            return table.quantity(key.name, Dimension::NUMBER).map(Self::arc);
        }
        // a table of positions and values, or of a place
        let inner = table.table(key)?;
        if Course::has_positions(&inner) {
            return Course::read(table, key).map(PlaceForm::Arc).map(Self::of);
        }
        let inner = inner.described(&PLACE);
        let side = SIDES.iter().position(|side| *side == key.name);
        let place = Self::on_side(&inner, side);
        inner.finish();
        place
    }

    /// The place of a table with the keys of [`PLACE`]; notes problems.
    pub(super) fn of_table(inner: &Table<'_>) -> Option<Self> {
        Self::on_side(inner, None)
    }

    /// As [`Place::of_table`], on a side without the key `side`.
    fn on_side(inner: &Table<'_>, without: Option<usize>) -> Option<Self> {
        let side = inner.get(&SIDE).map(|side| side.or(without));
        let edge = inner.get(&FROM_EDGE);
        let (arc, x) = (inner.get(&ARC), inner.get(&X));
        let (distance, at) = (inner.get(&DISTANCE), inner.get(&AT));
        let (plane, angle) = (inner.get(&PLANE), inner.get(&ANGLE));
        let shift = inner.get(&SHIFT);
        let (side, edge, angle) = (side?, edge?, angle?);
        let named = match at?.map(|name| Self::named(&name)) {
            Some(Err(reason)) => {
                inner.wrong(&AT, &format!("a place ({reason})"));
                return None;
            }
            Some(Ok(place)) => Some(place),
            None => None,
        };
        let on = |course: Option<Course>| course.zip(side);
        let forms = [
            arc?.map(PlaceForm::Arc).map(Self::of),
            on(x?).map(|(x, side)| Self::of(PlaceForm::X(x, side))),
            on(distance?).map(|(distance, side)| Self::from_edge(edge, distance, side)),
            on(plane?).map(|(plane, side)| Self::of(PlaceForm::Plane(plane, angle, side))),
        ];
        let given = [&ARC, &X, &DISTANCE, &PLANE].iter();
        let given = given.filter(|key| inner.has(key)).count() + usize::from(inner.has(&AT));
        let form = forms.into_iter().flatten().next();
        let has_angle = inner.has(&ANGLE) && !inner.has(&PLANE)
            || inner.has(&FROM_EDGE) && !inner.has(&DISTANCE);
        let has_side =
            inner.has(&SIDE) && [&ARC.name(), &AT.name()].iter().any(|key| inner.has(key));
        let form = form
            .or(named)
            .filter(|_| given == 1 && !has_angle && !has_side);
        if form.is_none() {
            let problem = LayupFileProblem::Place;
            inner.note("", &problem);
        }
        Some(form?.shifted(&shift?, 1.0).on_line(inner.line()))
    }
}

impl Place {
    /// The place at a distance from an edge along a side.
    fn from_edge(edge: usize, distance: Course, side: usize) -> Self {
        if EDGES[edge] == AT_EDGE {
            return Self::of(PlaceForm::Distance(distance, side));
        }
        // arcs grow toward the leading edge on the suction side
        let sign = [-1.0, 1.0][side];
        let shift = distance.map(|_, length| sign * length);
        Self::of(PlaceForm::Named(EDGES[edge].to_owned())).shifted(&shift, 1.0)
    }
}

/// Notes a table or key of the trailing edge, which webs and fills describe.
pub(super) fn refuse_trailing_edge(table: &Table<'_>) {
    if table.has(AT_EDGE) {
        table.note(AT_EDGE, &LayupFileProblem::TrailingEdge);
    }
}

/// The word of the place of a web behind the base.
pub(super) const AT_EDGE: &str = "trailing_edge";

/// A place on each side, suction and pressure.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct BothSides(pub [Place; 2]);

impl Declared for BothSides {}

impl Value for BothSides {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        let line = table.line_of(key);
        if table.is_text(key) {
            let at_edge = table.text(key.name)? == AT_EDGE;
            if !at_edge {
                table.wrong(key, &format!("\"{AT_EDGE}\", or a table with x or plane"));
            }
            let places = [0.0, 1.0].map(|arc| Place::arc(arc).on_line(line));
            return at_edge.then_some(Self(places));
        }
        let inner = table.table(key)?.described(&BOTH);
        let given = [&X_OF_WEB, &PLANE_OF_WEB, &DISTANCE_OF_WEB].map(|key| inner.has(key));
        let forms = match given {
            [false, false, true] => {
                let _ = inner.get(&FROM_TRAILING);
                let distance = inner.get(&DISTANCE_OF_WEB);
                distance.map(|length| [0, 1].map(|side| PlaceForm::Distance(length.clone(), side)))
            }
            [true, false, false] => {
                let x = inner.get(&X_OF_WEB);
                x.map(|x| [0, 1].map(|side| PlaceForm::X(x.clone(), side)))
            }
            [false, true, false] => {
                let (plane, angle) = (inner.get(&PLANE_OF_WEB), inner.get(&ANGLE));
                let form = |(plane, angle): (Course, Course)| {
                    [0, 1].map(|side| PlaceForm::Plane(plane.clone(), angle.clone(), side))
                };
                plane.zip(angle).map(form)
            }
            _ => {
                table.wrong(key, "one of \"x\", \"plane\" and \"distance\"");
                None
            }
        };
        inner.finish();
        Some(Self(forms?.map(|form| Place::of(form).on_line(line))))
    }
}
