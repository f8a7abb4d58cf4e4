//! Angles of fibers along the span.

use shared_geom::document::schema::KeySchema;
use shared_geom::document::{Declared, Table, Value};

use super::super::regions::Angle;
use super::course::Course;

/// The angle of the fibers of a layer, one or a table along the span \[rad\].
#[derive(Debug, Clone)]
pub(super) struct FiberAngle(pub Course);

impl Declared for FiberAngle {}

impl Value for FiberAngle {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        if table.is_table(key) {
            return Course::read(table, key).map(Self);
        }
        let angle = Angle::read(table, key)?;
        Some(Self(Course::constant(angle.0)))
    }
}
