//! Checks of the air with the rest of the model: rotors in steady states, Mach numbers of strips, and
//! the size of turbulence boxes.

use nalgebra::Vector3;
use rotor_aero::wind::{Extent, OutsideGrid, Shear, TooSmall, WindField};
use shared_geom::document::Table;

use super::problem::AirProblem;
use super::{EVENT, OUTSIDE_MACH, TURBULENCE, WIND, event, turbulence};
use crate::case::FrameRotation;
use crate::elements::strips::Air;
use crate::input::aerodynamics::{MachLimit, StripProblem};
use crate::input::rotor_speed::RPM;
use crate::input::short_number;

/// Part of the wind across the axis below which it is axial: digits lost in the input.
const ALONG: f64 = 1e-9;

/// Notes a wind that varies in space or time, or across the axis, if equilibria or modes are
/// requested at rotor speeds of up to `highest` \[rad/s\] above zero. Drives have the value of the
/// start.
pub(in crate::input) fn check_steady(
    root: &Table<'_>,
    air: &Air,
    (rotation, highest): (&FrameRotation, f64),
) {
    if highest <= 0.0 {
        return;
    }
    let cause = match air.wind().variation() {
        Some(part) => part.to_owned(),
        None => {
            let velocity = air.wind().velocity(&Vector3::zeros(), 0.0);
            let across = across(&velocity, &rotation.axis);
            if across <= ALONG * velocity.norm() {
                return;
            }
            format!("{} m/s across the axis", short_number(across, 6))
        }
    };
    let rpm = highest / RPM;
    let problem = AirProblem::GoesRound { cause, rpm };
    match root.table("air") {
        Some(table) => table.note(&WIND, &problem),
        None => root.note("air", &problem),
    }
}

fn across(velocity: &Vector3<f64>, axis: &Vector3<f64>) -> f64 {
    (velocity - axis * axis.dot(velocity)).norm()
}

/// Notes each airfoil whose table ends below the Mach number of the blades, by their names, at a rotor
/// speed \[rad/s\] in a constant wind, without induction; other winds and motions are checked at each
/// state.
pub(in crate::input) fn check_mach<'a>(
    root: &Table<'_>,
    air: &Air,
    (rotation, speed): (&FrameRotation, f64),
    limits: impl Iterator<Item = (&'a str, &'a MachLimit)>,
) {
    if !air.refuses_mach() {
        return;
    }
    let wind = air.constant().unwrap_or_default();
    let (along, across) = (rotation.axis.dot(&wind), across(&wind, &rotation.axis));
    let mut known = Vec::new();
    for (blade, limit) in limits {
        let found = (speed * limit.radius + across).hypot(along) / air.atmosphere.sound_speed;
        if found <= limit.range[1] || known.contains(&&limit.airfoil) {
            continue;
        }
        known.push(&limit.airfoil);
        let problem = StripProblem::Mach {
            blade: blade.to_owned(),
            airfoil: limit.airfoil.clone(),
            radius: limit.radius,
            found,
            range: limit.range,
        };
        match root.has("air").then(|| root.table("air")).flatten() {
            Some(table) => table.note(&OUTSIDE_MACH, &problem),
            None => root.note("air", &problem),
        }
    }
}

/// Notes a wind with a law of the height if the center of a rotor, or without rotors the one of the
/// rotation, is at or below the ground, where it has no speed.
pub(in crate::input) fn check_ground(
    root: &Table<'_>,
    air: &Air,
    (rotors, rotation): (&[Vector3<f64>], &Vector3<f64>),
) {
    let wind = air.wind();
    let height = |center: &Vector3<f64>| wind.frame.point(&(*center).into())[2];
    let lowest = rotors.iter().map(height).reduce(f64::min);
    let height = lowest.unwrap_or_else(|| height(rotation));
    if height > 0.0 || wind.mean.at(0.0).shear == Shear::Uniform {
        return;
    }
    let Some(table) = root.table("air") else {
        return;
    };
    let problem = AirProblem::Value {
        key: "ground",
        found: format!(
            "{} m below the center of the rotor",
            short_number(height, 6)
        ),
        expected: "a point below it, since the wind has a law of the height".to_owned(),
        help: "give a point on the ground as \"ground\" of [air.wind]",
    };
    let key = if table.has(&EVENT) {
        EVENT.name()
    } else {
        WIND.name()
    };
    table.note(key, &problem);
}

/// Notes turbulence boxes that are too small for rotors and strips with their extents, in a run until
/// `end` \[s\].
pub(in crate::input) fn check_boxes(
    root: &Table<'_>,
    air: &Air,
    extents: impl Iterator<Item = Extent>,
    end: f64,
) {
    let mut known = Vec::new();
    for extent in extents {
        // Blades of one rotor have the same extent.
        let boxes = air.wind().boxes.iter();
        let boxes = boxes.filter(|one| one.outside_grid() == OutsideGrid::Refuse);
        for problem in boxes.flat_map(|one| one.uncovered(&extent, end)) {
            let text = problem.to_string();
            if !known.contains(&text) {
                note_small(root, &problem);
                known.push(text);
            }
        }
    }
}

/// Notes a box that is too small, with the key that names it or the condition that generates it.
fn note_small(root: &Table<'_>, problem: &TooSmall) {
    let Some(air) = root.table("air") else {
        return;
    };
    if let Some(table) = air
        .has(&TURBULENCE)
        .then(|| air.table(&TURBULENCE))
        .flatten()
    {
        let files = table.has(&turbulence::FILES);
        let key = if files {
            turbulence::FILES.name()
        } else {
            turbulence::FILE.name()
        };
        table.note(key, problem);
    } else if let Some(table) = air.table(&EVENT) {
        let remedy =
            "give a larger \"width\", or the height of the hub above \"ground\" as \"hub_height\"";
        table.note(
            &event::KIND,
            &TooSmall {
                remedy,
                ..problem.clone()
            },
        );
    }
}
