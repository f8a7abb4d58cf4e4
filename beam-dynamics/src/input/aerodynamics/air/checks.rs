//! Checks of the wind with the rest of the model: rotors in steady states, and the size of
//! turbulence boxes.

use nalgebra::Vector3;
use rotor_aero::wind::{OutsideGrid, WindField};
use shared_geom::document::Table;

use super::problem::AirProblem;
use super::{TURBULENCE, WIND, turbulence};
use crate::case::FrameRotation;
use crate::elements::strips::Air;
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

/// Notes turbulence boxes that are too small for a rotor of a `radius` \[m\], of which the center
/// is at `center` \[m\], in a run until `end` \[s\].
pub(in crate::input) fn check_boxes(
    root: &Table<'_>,
    air: &Air,
    (center, radius): (&Vector3<f64>, f64),
    end: f64,
) {
    let wind = air.wind();
    let [_, _, height] = wind.frame.point(&(*center).into());
    for one in &wind.boxes {
        if one.outside_grid() == OutsideGrid::Extend {
            continue;
        }
        let (Err(problems), Some(table)) = (one.covers(radius, height, end), root.table("air"))
        else {
            continue;
        };
        if let Some(table) = table.table(&TURBULENCE) {
            let _: Option<()> = table.keep_file(turbulence::FILE.name(), Err(problems));
        }
    }
}
