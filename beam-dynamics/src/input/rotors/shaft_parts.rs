//! The keys of the shaft of a rotor and of its drive.

use shared_geom::document::Table;

use super::base::Units;
use super::context::Context;
use super::controls::{self, Sum};
use super::keys;
use super::problem::RotorProblem;
use super::shaft::{Drive, Shaft};
use super::train_parts;
use crate::elements::Smoothness;

/// A speed that the file gives, and the one of an angle over time at the time zero \[rad/s\].
type Speeds = [Option<f64>; 2];

/// Reads the keys of the shaft of a rotor.
pub(super) fn read(table: &Table<'_>, name: &str, context: &Context) -> Option<Shaft> {
    let (drive, train) = (drive(table, name, context), train_parts::read(table, name));
    let ((drive, [given, turning]), train) = (drive?, train?);
    Some(Shaft {
        drive,
        train,
        given,
        turning,
    })
}

/// The drive of the shaft, and its speeds.
fn drive(table: &Table<'_>, name: &str, context: &Context) -> Option<(Drive, Speeds)> {
    let speed = table.get(&keys::SPEED)?;
    let read = |key, needed| controls::read(table, key, (context, needed));
    let sum = |control: &Option<controls::Control>| {
        let mut sum = Sum::default();
        sum.add(control.as_ref(), None);
        sum
    };
    let angle = read(&keys::ANGLE.schema, Smoothness::Acceleration)?;
    let units = Units::of(table.document());
    let turning = angle.as_ref().and_then(|angle| {
        let rate = angle.rate_at_start(&context.constants(table.document()))?;
        Some(rate * units.angle / units.time)
    });
    let angle = sum(&angle);
    let torque = sum(&read(&keys::TORQUE.schema, Smoothness::Value)?);
    let name = name.to_owned();
    let given = [speed, turning];
    match (angle.is_empty(), torque.is_empty()) {
        (false, false) => {
            table.note(&keys::TORQUE, &RotorProblem::TwoDrives { name });
            None
        }
        (false, true) => Some((Drive::Angle(angle.content(), angle.text()), given)),
        (true, false) => Some((Drive::Torque(torque.content()), given)),
        (true, true) => {
            let Some(speed) = speed else {
                table.note("", &RotorProblem::NoDrive { name });
                return None;
            };
            Some((Drive::Speed(speed), given))
        }
    }
}
