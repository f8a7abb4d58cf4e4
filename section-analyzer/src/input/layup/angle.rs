//! Angles of layups, all of which are within a turn.

use std::f64::consts::TAU;

use shared_geom::document::schema::KeySchema;
use shared_geom::document::{Declared, Table, Value};

use super::super::regions::bounded_angle;

/// Largest angle, with round-off \[rad\].
const LARGEST: f64 = TAU * (1.0 + 1e-9);
/// Words of the possible angles.
pub(super) const WITHIN_A_TURN: &str = "an angle within a turn, from -360 to 360 deg";

/// Whether an angle \[rad\] is within a turn.
pub(super) fn is_within_a_turn(angle: f64) -> bool {
    angle.abs() <= LARGEST
}

/// An angle within a turn \[rad\].
#[derive(Debug, Clone, Copy)]
pub(super) struct Angle(pub f64);

impl Declared for Angle {}

impl Value for Angle {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        bounded_angle(table, key, (LARGEST, WITHIN_A_TURN)).map(Self)
    }
}
