//! The table `[rotor.drive]`.

use shared_geom::document::Table;

use super::keys::{ANGLE, SPEED, TORQUE};
use super::problem::RotorProblem;
use super::train::{Governor, Train};
use super::train_keys::{
    DAMPING, FREE_WHEEL, GEAR, GOVERNOR, INERTIA, INTEGRAL, LARGEST, PROPORTIONAL, REQUIRED,
    STIFFNESS, TRAIN,
};

/// Reads `[rotor.drive]` of the rotor called `name`; `Some(None)` without it.
pub(super) fn read(rotor: &Table<'_>, name: &str) -> Option<Option<Train>> {
    let speed = if rotor.has(&TRAIN) {
        rotor.get(&SPEED)?
    } else {
        None
    };
    rotor.nested(&TRAIN, |table| {
        let (inertia, gear) = (table.get(&INERTIA), table.get(&GEAR));
        let (stiffness, damping) = (table.get(&STIFFNESS), table.get(&DAMPING));
        let free_wheel = table.get(&FREE_WHEEL);
        let governor = table.nested(&GOVERNOR, |table| governor(table, speed, name));
        let (inertia, gear, damping) = (inertia?, gear?, damping?);
        let train = Train {
            inertia: inertia.map(|inertia| gear * gear * inertia),
            spring: stiffness?.map(|stiffness| [stiffness, damping]),
            has_free_wheel: free_wheel?,
            governor: governor?,
        };
        let idle = idle(table, &train, rotor);
        if let Some((key, needed)) = idle {
            let name = name.to_owned();
            table.note(key, &RotorProblem::Idle { name, key, needed });
            return None;
        }
        let other = [TORQUE.name(), ANGLE.name()]
            .into_iter()
            .find(|key| rotor.has(*key));
        if let (Some(_), Some(other)) = (&train.governor, other) {
            let (name, key) = (name.to_owned(), GOVERNOR.name());
            table.note(key, &RotorProblem::Both { name, key, other });
            return None;
        }
        Some(train)
    })
}

/// A key without the one that it needs, and this one.
fn idle(
    table: &Table<'_>,
    train: &Train,
    rotor: &Table<'_>,
) -> Option<(&'static str, &'static str)> {
    let is_moved = train.governor.is_some() || rotor.has(&TORQUE);
    let is_rigid = train.spring.is_none();
    let rows = [
        (INERTIA.name(), !is_moved, "torque\" or \"governor"),
        (GEAR.name(), train.inertia.is_none(), INERTIA.name()),
        (DAMPING.name(), is_rigid, STIFFNESS.name()),
        (FREE_WHEEL.name(), is_rigid, STIFFNESS.name()),
        (GOVERNOR.name(), train.inertia.is_none(), INERTIA.name()),
    ];
    let found = rows
        .into_iter()
        .find(|(key, lacks, _)| table.has(*key) && *lacks);
    let found = found.map(|(key, _, needed)| (key, needed));
    found.or(match (is_moved, train.inertia.is_none(), is_rigid) {
        (true, true, _) => Some((TRAIN.name(), INERTIA.name())),
        (false, _, true) => Some((TRAIN.name(), STIFFNESS.name())),
        _ => None,
    })
}

fn governor(table: &Table<'_>, speed: Option<f64>, name: &str) -> Option<Governor> {
    let (proportional, integral) = (table.get(&PROPORTIONAL), table.get(&INTEGRAL));
    let (required, largest) = (table.get(&REQUIRED), table.get(&LARGEST));
    let Some(speed) = required?.or(speed) else {
        let (name, key, needed) = (name.to_owned(), GOVERNOR.name(), REQUIRED.name());
        table.note("", &RotorProblem::Idle { name, key, needed });
        return None;
    };
    // its torque is not negative
    if speed <= 0.0 {
        let name = name.to_owned();
        table.note("", &RotorProblem::Governed { name, speed });
        return None;
    }
    Some(Governor {
        speed,
        proportional: proportional?,
        integral: integral?,
        largest: largest?,
    })
}
