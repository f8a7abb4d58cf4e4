//! The position and the axes of a station, and helpers of both ways to write stations.

use nalgebra::{Matrix6, Vector2, Vector3};

use super::engineering::{MASS, Parts, STIFFNESS};
use super::frame::Frame;
use super::problem::InputProblem;
use crate::document::Table;
use crate::line::about_x;
use crate::wrench;

/// Settings of the file for all stations.
#[derive(Debug, Clone, Copy)]
pub(super) struct Settings<'a> {
    pub frame: Option<&'a Frame>,
    pub reference_point: Option<Vector2<f64>>,
    /// Length of the line.
    pub length: Option<f64>,
}

/// Position and axes of a station.
#[derive(Debug, Clone, Copy)]
pub(super) struct StationAxes {
    pub arc_length: f64,
    /// Its own reference point.
    pub point: Vector2<f64>,
    /// From the section axes of the line to its own.
    pub angle: f64,
}

/// The 6x6 about the reference point of the blade, in the section axes of the line.
pub(super) fn moved(
    matrix: &Matrix6<f64>,
    axes: &StationAxes,
    settings: &Settings<'_>,
) -> Option<Matrix6<f64>> {
    let turned = match axes.angle {
        0.0 => *matrix,
        angle => wrench::rotate(matrix, &about_x(-angle)),
    };
    let by = settings.reference_point? - axes.point;
    Some(if by == Vector2::zeros() {
        turned
    } else {
        wrench::shift(&turned, &Vector3::new(0.0, by.x, by.y))
    })
}

/// Notes two keys for one quantity, or none; `Some(true)` for the first.
pub(super) fn either(
    table: &Table<'_>,
    has: impl Fn(&str) -> bool,
    one: &str,
    other: &str,
) -> Option<bool> {
    match (has(one), has(other)) {
        (true, false) => Some(true),
        (false, true) => Some(false),
        (true, true) => {
            let problem = InputProblem::Both {
                table: table.title().to_owned(),
                one: one.to_owned(),
                other: other.to_owned(),
            };
            table.note(other, &problem);
            None
        }
        (false, false) => {
            let problem = InputProblem::Neither {
                table: table.title().to_owned(),
                known: vec!["\"arc_length\"", "\"eta\" (part of the length)"],
            };
            table.note("eta", &problem);
            None
        }
    }
}

/// Notes engineering properties in a frame other than Helicoid's.
pub(super) fn note_foreign(table: &Table<'_>, parts: Parts, settings: &Settings<'_>) -> bool {
    let foreign = settings.frame.is_some_and(|frame| !frame.is_ours());
    let key = match (parts.stiffness, parts.mass) {
        (true, _) => STIFFNESS[0].0,
        (false, true) => MASS[0].0,
        (false, false) => return true,
    };
    if foreign {
        let problem = InputProblem::EngineeringFrame {
            table: table.title().to_owned(),
            key,
        };
        table.note(key, &problem);
    }
    !foreign
}
