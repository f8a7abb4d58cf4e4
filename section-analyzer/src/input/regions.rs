//! Regions as written: a physical group, its material, and the two angles.

use shared_geom::document::schema::ValueKind::{
    Boolean, Name, Quantity, Table as OneTable, Tables, Text,
};
use shared_geom::document::schema::{Family, KeySchema, TableSchema, ValueKind};
use shared_geom::document::{Declared, NestedList, Table, Value};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::problem::InputProblem;

keys! {
    /// Material and angles of each physical surface of the mesh; every surface needs a region.
    pub(super) REGIONS: NestedList = "region", [Tables(&REGION)], optional, "";
}

keys! {
    /// A physical surface of the mesh and its material.
    REGION = "[[region]]";
    /// The name of a physical surface, or its tag.
    GROUP: Written = "group", [Name], required, "\"skin\"";
    /// The name of a material.
    pub(super) MATERIAL: Written = "material", [Name], required, "\"glass\"";
    /// Angle of the fiber from x toward the wall direction, in the wall.
    FIBER_ANGLE: WrittenAngle = "fiber_angle", [Quantity(Dimension::ANGLE), OneTable(&FIBER_ANGLES)],
        or "0" = WrittenAngle::Constant(0.0), "45";
    /// Angle of the wall direction from +y.
    PLANE_ANGLE: WrittenAngle = "plane_angle", [Quantity(Dimension::ANGLE), OneTable(&PLANE_ANGLES)],
        or "0" = WrittenAngle::Constant(0.0), "\"90 deg\"";
}

keys! {
    /// The fiber angle cell by cell.
    FIBER_ANGLES = "fiber_angle = { ... }";
    /// CSV file with the header cell,angle and a row for each cell of the region, by its tag in
    /// the mesh; angles in the declared unit.
    TABLE: Written = "table", [Text], required, "\"angles.csv\"";
}

keys! {
    /// The name of a physical curve, or its tag.
    FOLLOW: Written = "follow", [Name], required, "\"outer\"";
    /// Whether to take the opposite direction.
    REVERSE: bool = "reverse", [Boolean], or "false" = false, "true";
}

const PLANE_ANGLES: TableSchema = TableSchema {
    title: "plane_angle = { ... }",
    meaning: "The plane angle cell by cell, or along a curve.",
    keys: &[],
    families: &[
        Family {
            name: "table",
            meaning: "Cell by cell.",
            keys: &[TABLE.schema],
        },
        Family {
            name: "follow",
            meaning: "The direction of a curve of the mesh, at its point nearest to the \
                      centroid of each cell.",
            keys: &[FOLLOW.schema, REVERSE.schema],
        },
    ],
};

/// Largest angle \[rad\]: 1000 revolutions. For a much larger angle the remainder after
/// whole revolutions has no accurate digit.
const LARGEST_ANGLE: f64 = 1000.0 * std::f64::consts::TAU;

/// `[[region]]` as far as it could be read.
#[derive(Debug, Clone)]
pub(super) struct WrittenRegion {
    pub line: usize,
    pub group: Option<Written>,
    pub material: Option<Written>,
    pub fiber_angle: Option<WrittenAngle>,
    pub plane_angle: Option<WrittenAngle>,
}

/// A name and its line.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Written {
    pub text: String,
    pub line: usize,
}

/// An angle as given in the input.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum WrittenAngle {
    /// The same for all cells \[rad\].
    Constant(f64),
    /// From a table by cell.
    Table(Written),
    /// The direction of a curve, or the opposite direction.
    Follow { curve: Written, reverse: bool },
}

/// Reads every `[[region]]`.
pub(super) fn read(root: &Table<'_>) -> Vec<WrittenRegion> {
    let regions = root.each(&REGIONS, |table| {
        Some(WrittenRegion {
            line: table.line(),
            group: table.get(&GROUP),
            material: table.get(&MATERIAL),
            fiber_angle: table.get(&FIBER_ANGLE),
            plane_angle: table.get(&PLANE_ANGLE),
        })
    });
    regions.unwrap_or_default()
}

impl Declared for Written {}

/// A text, or for a name also a number that represents it.
impl Value for Written {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        let text = match key.kinds[0] {
            ValueKind::Name if table.is_list(key) || table.is_table(key) => {
                table.wrong(key, &key.expected());
                return None;
            }
            ValueKind::Name if !table.is_text(key) => table.count(key.name)?.to_string(),
            _ => table.text(key.name)?,
        };
        let line = table.line_of(key);
        Some(Self { text, line })
    }
}

impl Written {
    /// Whether it is one line without control characters.
    pub fn is_line(&self) -> bool {
        !self.text.trim().is_empty() && !self.text.contains(char::is_control)
    }
}

/// An angle of at most 1000 revolutions \[rad\].
#[derive(Debug, Clone, Copy)]
pub(super) struct Angle(pub f64);

impl Declared for Angle {}

impl Value for Angle {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        let expected = "an angle of at most 1000 revolutions";
        bounded_angle(table, key, (LARGEST_ANGLE, expected)).map(Self)
    }
}

/// An angle up to the `largest` one \[rad\]; `expected` describes the possible ones.
pub(super) fn bounded_angle(
    table: &Table<'_>,
    key: &KeySchema,
    (largest, expected): (f64, &str),
) -> Option<f64> {
    let angle = table.quantity(key.name, Dimension::ANGLE)?;
    if angle.abs() > largest {
        table.wrong(key, expected);
        return None;
    }
    Some(angle)
}

impl Declared for WrittenAngle {}

/// A constant, `{ table = ... }`, or for the plane angle `{ follow = ... }`.
impl Value for WrittenAngle {
    fn read(region: &Table<'_>, key: &KeySchema) -> Option<Self> {
        if !region.is_table(key) {
            return Angle::read(region, key).map(|angle| Self::Constant(angle.0));
        }
        let table = region.table(key)?;
        let (key, may_follow) = (key.name, key.name == PLANE_ANGLE.name());
        let found = match (table.has(&TABLE), may_follow && table.has(&FOLLOW)) {
            (true, true) => {
                table.note(&FOLLOW, &InputProblem::TableAndFollow { key });
                None
            }
            (true, false) => table.get(&TABLE).map(Self::Table),
            (false, true) => {
                let (curve, reverse) = (table.get(&FOLLOW), table.get(&REVERSE));
                curve
                    .zip(reverse)
                    .map(|(curve, reverse)| Self::Follow { curve, reverse })
            }
            (false, false) => {
                let expected = if may_follow {
                    "\"table\" or \"follow\""
                } else {
                    "\"table\""
                };
                table.note("", &InputProblem::NoAngle { key, expected });
                None
            }
        };
        table.finish();
        found
    }
}
