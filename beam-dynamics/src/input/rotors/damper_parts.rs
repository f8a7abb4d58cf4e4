//! The tables of dampers.

use nalgebra::Vector3;
use shared_geom::document::{Key, Table};
use std::f64::consts::TAU;

use super::damper::Ends;
use super::damper_keys::{
    BETWEEN, BLADE_END, DAMPER, DAMPING, FORCES, FREQUENCY, HUB_END, LAG_DAMPER, LINE_REST,
    LINE_STIFFNESS, LOSS_FACTOR, MOMENTS, NEXT_END, ON, RATES, STIFFNESS, TURNING_REST,
    TURNING_STIFFNESS, VELOCITIES,
};
use super::damper_law::DamperLaw;
use super::problem::RotorProblem;
use crate::input::too_stiff;

/// Distance of two points as a part of that from the center of the hub below which they are the same.
const SAME_POINT: f64 = 1e-9;

/// Reads the damper of a hinge; `Some(None)` without it.
pub(super) fn of_hinge(table: &Table<'_>) -> Option<Option<DamperLaw>> {
    table.nested(&DAMPER, |table| {
        if is_elastomer(table) {
            elastomer(table, &TURNING_STIFFNESS, &TURNING_REST)
        } else {
            curve(table, [&RATES, &MOMENTS])
        }
    })
}

/// A damper between hub and blade.
#[derive(Debug)]
pub(super) struct LagDamper {
    /// Its ends.
    pub ends: Ends,
    /// Whether the first end is on the next blade, not on the hub.
    pub is_between_blades: bool,
    /// Whether the root carries its end; `None` if the file does not say.
    pub on_root: Option<bool>,
    /// Its law.
    pub law: DamperLaw,
}

/// Reads `[rotor.lag_damper]`; `Some(None)` without it.
pub(super) fn between(table: &Table<'_>, name: &str) -> Option<Option<LagDamper>> {
    table.nested(&LAG_DAMPER, |table| {
        let is_between_blades = table.get(&BETWEEN) == Some(1);
        let first = first_end(table, name, is_between_blades);
        let (blade, on) = (table.get(&BLADE_END), table.get(&ON));
        let law = if is_elastomer(table) {
            elastomer(table, &LINE_STIFFNESS, &LINE_REST)
        } else if table.has(&VELOCITIES) || table.has(&FORCES) {
            curve(table, [&VELOCITIES, &FORCES])
        } else {
            linear(table, name)
        };
        let (hub, blade) = (first?, blade?);
        if !is_between_blades && (hub - blade).norm() <= SAME_POINT * hub.norm().max(blade.norm()) {
            let point = hub.into();
            table.note(&BLADE_END, &RotorProblem::DamperEnds { point });
            return None;
        }
        Some(LagDamper {
            ends: Ends { hub, blade },
            is_between_blades,
            on_root: on?.map(|index| index == 1),
            law: law?,
        })
    })
}

/// The end that is not on the blade of the damper; notes the one that is missing, or one too many.
fn first_end(table: &Table<'_>, name: &str, is_between_blades: bool) -> Option<Vector3<f64>> {
    let (wanted, other) = if is_between_blades {
        (&NEXT_END, &HUB_END)
    } else {
        (&HUB_END, &NEXT_END)
    };
    let name = name.to_owned();
    let (found, has_other) = (table.get(wanted)?, table.has(other));
    if has_other {
        let (key, other) = (other.name(), "between");
        table.note(key, &RotorProblem::Both { name, key, other });
        return None;
    }
    if found.is_none() {
        let (key, needed) = (LAG_DAMPER.name(), wanted.name());
        table.note("", &RotorProblem::Idle { name, key, needed });
    }
    found
}

fn linear(table: &Table<'_>, name: &str) -> Option<DamperLaw> {
    let (stiffness, damping) = (table.get(&STIFFNESS), table.get(&DAMPING));
    let law = [stiffness?, damping?];
    let keys = [STIFFNESS.name(), DAMPING.name()].into_iter().zip(law);
    let mut keys = keys.map(|(key, value)| too_stiff::is_resolved(table, key, [value]));
    if !keys.all(|is_resolved| is_resolved) {
        return None;
    }
    if law == [0.0, 0.0] {
        let (name, key, needed) = (name.to_owned(), LAG_DAMPER.name(), DAMPING.name());
        table.note("", &RotorProblem::Idle { name, key, needed });
        return None;
    }
    Some(DamperLaw::Linear(law))
}

fn is_elastomer(table: &Table<'_>) -> bool {
    let keys = [LOSS_FACTOR.name(), FREQUENCY.name(), LINE_REST.name()];
    keys.into_iter().any(|key| table.has(key))
}

fn elastomer(
    table: &Table<'_>,
    stiffness_key: &Key<f64>,
    rest: &Key<Option<f64>>,
) -> Option<DamperLaw> {
    let (stiffness, loss_factor) = (table.get(stiffness_key), table.get(&LOSS_FACTOR));
    let (frequency, at_rest) = (table.get(&FREQUENCY), table.get(rest));
    let (stiffness, at_rest) = (stiffness?, at_rest?);
    if at_rest.is_some_and(|at_rest| at_rest >= stiffness) {
        table.wrong(rest, "less than \"stiffness\"");
        return None;
    }
    let frequency = frequency? * TAU;
    let law = DamperLaw::elastomer([stiffness, loss_factor?], frequency, at_rest);
    let values = [stiffness, law.stiffest()];
    too_stiff::is_resolved(table, stiffness_key.name(), values).then_some(law)
}

/// A curve of a damper.
fn curve(table: &Table<'_>, [rates_key, forces_key]: [&Key<Vec<f64>>; 2]) -> Option<DamperLaw> {
    let (rates, forces) = (table.get(rates_key), table.get(forces_key));
    let (rates, forces) = (rates?, forces?);
    let ascends = rates.windows(2).all(|pair| pair[0] < pair[1]);
    if rates.len() != forces.len() || rates.len() < 2 || !ascends {
        let problem = RotorProblem::Curve {
            rates: rates.len(),
            moments: forces.len(),
            key: forces_key.name(),
        };
        table.note(rates_key, &problem);
        return None;
    }
    let points = rates.into_iter().zip(forces);
    let points: Vec<_> = points.map(|(rate, force)| [rate, force]).collect();
    let is_driving = |[rate, force]: &[f64; 2]| rate * force < 0.0;
    if let Some(point) = points.iter().position(is_driving) {
        let problem = RotorProblem::DrivingDamper {
            point: point + 1,
            key: forces_key.name(),
        };
        table.note(forces_key, &problem);
        return None;
    }
    Some(DamperLaw::Curve(points))
}
