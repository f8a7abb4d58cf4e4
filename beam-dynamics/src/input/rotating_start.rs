//! Supports that prevent a steady rotation at the start of a run.

use nalgebra::Vector3;
use shared_geom::document::{Document, Table};
use shared_geom::error::Explain;

use super::analyses::Analyses;
use super::builder::ModelBuilder;
use super::number::short_number;
use super::rotor_speed::RPM;

/// Digits of the speed and of the axis in messages.
const DIGITS: usize = 6;

/// A support that holds a model which rotates at the start.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{held}, and the start rotates at {} rpm: it cannot turn", short_number(*.rpm, DIGITS))]
struct HeldStart {
    /// The part that is held, as text.
    held: String,
    /// Speed of the start \[rpm\].
    rpm: f64,
    /// Axis of the hub.
    axis: Vector3<f64>,
    /// Whether the hub is a node.
    has_hub: bool,
}

impl Explain for HeldStart {
    fn help(&self) -> Option<String> {
        let [x, y, z] = [0, 1, 2].map(|i| short_number(self.axis[i], DIGITS));
        let rpm = short_number(self.rpm, DIGITS);
        let support = if self.has_hub {
            "give \"support\" of [hub] torsion = 0"
        } else {
            "give [hub] support = { torsion = 0 }, so that it is the node \"hub\", which carries \
             the blades"
        };
        Some(format!(
            "{support}, and add the joint that turns it: [[joint]] with name = \"shaft\", kind = \
             \"spin\", nodes = [\"hub\"], axis = [{x}, {y}, {z}], speed = \"{rpm} rpm\""
        ))
    }
}

/// Notes clamps, and a support of the hub that holds its rotation, if a run starts in rotation.
pub(super) fn check(
    (document, root): (&Document, &Table<'_>),
    builder: &ModelBuilder,
    analyses: &Analyses,
) {
    let Some(hub) = builder.hub() else { return };
    let Some(speed) = analyses.rotating_speed() else {
        return;
    };
    let problem = |held: String| HeldStart {
        held,
        rpm: speed / RPM,
        axis: hub.frame_rotation().axis,
        has_hub: hub.moving().is_some(),
    };
    let is_held = |moving: &super::hub::MovingHub| moving.stiffness[3].is_none();
    if hub.moving().is_some_and(is_held) {
        let held = "the support of the hub holds its rotation about the axis";
        root.note("hub", &problem(held.to_owned()));
    }
    // Blades of a card are clamped on one line.
    let mut lines = Vec::new();
    for (node, line) in builder.clamp_lines() {
        if !lines.contains(&line) {
            lines.push(line);
            let held = format!("node \"{node}\" is clamped to the ground");
            document.note(line, &problem(held));
        }
    }
}
